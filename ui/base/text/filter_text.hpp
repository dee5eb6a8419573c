// The texts of filter descriptors in the user's language.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string_view>

namespace footfall {
struct FilterDescriptor;
}

namespace footfall::ui {

/// A text of a descriptor, translated where there is a translation. The core has no translations; its texts reach the
/// translators through the generated file translations/descriptor_texts.cpp.
QString filterText(std::string_view text);

/// The label of the filter with this name; the name itself where there is no such filter.
QString filterName(std::string_view name);

/// A pipeline line with the label of its filter and its numbers: "HeightAwareStrategy 50 2 false" becomes "Height-aware
/// strategy 50 · 2". Other lines stay as they are.
QString strategyText(std::string_view line);

/// The whole descriptor as rich text for the help panel; the parameter at `emphasised` is highlighted (-1: none).
QString filterHelp(const FilterDescriptor& filter, int emphasised = -1);

}  // namespace footfall::ui
