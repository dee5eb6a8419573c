// Texts of the core in the user's language.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <exception>
#include <string_view>

#include "footfall/text.hpp"

namespace footfall::ui {

/// A translated text with its arguments inserted; English where there is no translation. translations/update.sh
/// extracts the patterns for translators.
QString coreText(const Text& text);

/// A name that is the same in all languages.
inline QString untranslated(std::string_view name) {
  return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

/// The message of an exception: translated for Footfall's own errors, unchanged for others.
QString coreText(const std::exception& error);

}  // namespace footfall::ui
