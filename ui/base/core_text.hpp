// What the core says to people, in their language.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <exception>

#include "footfall/text.hpp"

namespace footfall::ui {

/// Translated where there is a translation, with the arguments in their places; patterns come to the translators
/// through translations/update.sh.
QString coreText(const Text& text);

/// What an exception says: translated for Footfall's own errors, as it is for others.
QString coreText(const std::exception& error);

}  // namespace footfall::ui
