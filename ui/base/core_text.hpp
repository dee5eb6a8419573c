// What the core says to people, in their language.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <exception>
#include <string_view>

#include "footfall/text.hpp"

namespace footfall::ui {

/// Translated where there is a translation, with the arguments in their places; patterns come to the translators
/// through translations/update.sh.
QString coreText(const Text& text);

/// A name that stays what it is in all languages.
inline QString untranslated(std::string_view name) {
  return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

/// What an exception says: translated for Footfall's own errors, as it is for others.
QString coreText(const std::exception& error);

}  // namespace footfall::ui
