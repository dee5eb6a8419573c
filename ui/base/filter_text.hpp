// What the filters' descriptors say, in the user's language.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string_view>

#include "footfall/filter.hpp"

namespace footfall::ui {

/// A text of a descriptor, translated where there is a translation. The core knows nothing of languages; its texts come
/// to the translators through translations/descriptor_texts.cpp, which is generated.
QString filterText(std::string_view text);

/// The whole descriptor as rich text for the help panel; the parameter at `emphasised` stands out (-1: none).
QString filterHelp(const FilterDescriptor& filter, int emphasised = -1);

}  // namespace footfall::ui
