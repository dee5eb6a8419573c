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

/// The label of the filter that has this name; the name where no filter has it.
QString filterName(std::string_view name);

/// A line of a pipeline that makes cells, e.g. "HeightAwareStrategy 50 2 false", with the label of its filter:
/// "Height-aware 50 2 false".
QString strategyText(std::string_view line);

/// The whole descriptor as rich text for the help panel; the parameter at `emphasised` stands out (-1: none).
QString filterHelp(const FilterDescriptor& filter, int emphasised = -1);

}  // namespace footfall::ui
