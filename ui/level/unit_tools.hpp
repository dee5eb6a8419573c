// The commands that choose the unit of lengths, and its session section.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace footfall::ui {

struct FeatureHost;

/// Adds the menu "Lengths in" to the window.
void installUnitTools(const FeatureHost& host);

}  // namespace footfall::ui
