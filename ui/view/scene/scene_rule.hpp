// The rule that decides which parts of a scene are drawn. SceneRenderer draws and LevelView picks by this rule, so that
// the visible parts are the ones that can be clicked.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "ui/view/scene/appearance.hpp"
#include "ui/view/view_mode.hpp"

namespace footfall::ui {

/// The parts of the scene to draw; the legend and the View menu switch them. Each switch affects only the part that it
/// names.
struct SceneParts {
  bool environment = true;  ///< walls, ceilings and floors without a state
  bool walkable = true;
  bool removed = true;              ///< floors in the paint of the filter that removed them
  std::uint32_t plainRemovals = 0;  ///< bits of reasons whose floors are drawn as if nothing was said about them
  bool obstacleEdges = true;
  bool connections = true;
  bool steps = true;
  bool gaps = true;
  bool drops = true;
  bool outlines = true;              ///< creases of the environment and outlines of the walkable area
  bool cells = false;                ///< of a parallel block, over everything that faces up
  bool inside = true;                ///< one looks into closed levels; LevelView::setInside() knows better, as with:
  ViewMode mode = ViewMode::Result;  ///< LevelView::setMode() knows better than who switches parts
  [[nodiscard]] bool shows(const RemovalStyle& style) const { return (plainRemovals & bitOf(style)) == 0; }
  void show(const RemovalStyle& style, bool on) {
    plainRemovals = on ? plainRemovals & ~bitOf(style) : plainRemovals | bitOf(style);
  }
  bool operator==(const SceneParts&) const = default;

 private:
  static std::uint32_t bitOf(const RemovalStyle& style) { return std::uint32_t{1} << style.number; }
};

/// The facts that the rule depends on besides the parts.
struct SceneFacts {
  bool reasons = false;    ///< a filter has removed floors, which then have a reason
  bool bothSides = false;  ///< fronts and backs of triangles have no meaning
  double down = 0;         ///< sine of the angle at which the camera looks down
};

struct SceneRule {
  /// The triangles of the environment that are drawn.
  enum class Environment : std::uint8_t { All, Floors, None };
  /// The drawing of pieces of the walkable area that are not shown as such.
  enum class Unseen : std::uint8_t {
    LeftOut,
    Plain,  ///< as floors without a state, because the triangles under them have the paint of another reason
    Gap     ///< neither they nor the floor under them are visible
  };

  SceneRule(const SceneParts& parts, const SceneFacts& facts);
  SceneRule() = default;

  Environment environment = Environment::All;
  bool wires = false;                    ///< the edges of triangles are drawn
  bool through = false;                  ///< nothing hides anything
  bool reasons = true;                   ///< floors have the paints of the filters that removed them
  bool walkable = true;                  ///< walkable pieces are drawn as such
  bool field = false;                    ///< all floors, in the colours of a heat map
  bool backs = true;                     ///< faces seen from behind
  bool covers = true;                    ///< roofs and outer walls of closed levels
  Unseen unseen = Unseen::LeftOut;       ///< all pieces, where `walkable` is off
  Unseen unseenLayer = Unseen::LeftOut;  ///< pieces of hidden layers whose triangle of the environment stays
  bool operator==(const SceneRule&) const = default;
};

}  // namespace footfall::ui
