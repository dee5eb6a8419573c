// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/scene_rule.hpp"

namespace footfall::ui {
namespace {

constexpr double kFromAbove = 0.34;  // 20 degrees: a steeper camera looks into a level and not at it

}  // namespace

SceneRule::SceneRule(const SceneParts& parts, const SceneFacts& facts) {
  const bool told = parts.mode == ViewMode::Result || parts.mode == ViewMode::RejectedBy;
  field = isHeatMap(parts.mode);
  wires = parts.mode == ViewMode::Wireframe || parts.mode == ViewMode::HiddenLine;
  reasons = told && parts.removed && facts.reasons;
  walkable = parts.walkable && !field;
  if (parts.environment && parts.mode != ViewMode::WalkableOnly) {
    environment = Environment::All;
  } else {
    environment = reasons ? Environment::Floors : Environment::None;
  }
  const Unseen under = environment == Environment::All ? Unseen::Plain : reasons ? Unseen::Gap : Unseen::LeftOut;
  unseenLayer = walkable ? under : Unseen::LeftOut;
  if (!walkable && reasons) unseen = under;
  through = parts.mode == ViewMode::Wireframe;
  const bool all = !parts.inside || through;
  backs = all || facts.bothSides;
  covers = all || facts.down < kFromAbove;
}

}  // namespace footfall::ui
