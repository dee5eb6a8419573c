// What of a scene is drawn. SceneRenderer draws by this rule and LevelView picks by it: what is seen is what is
// clicked.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "ui/view/appearance.hpp"
#include "ui/view/view_mode.hpp"

namespace footfall::ui {

/// What to draw of the scene; the legend and the View menu switch these. Each governs what it names and nothing else.
struct SceneParts {
  bool environment = true;  ///< walls, ceilings and the floors that nothing is said about
  bool walkable = true;
  bool removed = true;             ///< floors in the paint of the filter that removed them
  std::uint8_t plainRemovals = 0;  ///< bits of reasons whose floors are drawn as if nothing was said about them
  bool obstacleEdges = true;
  bool connections = true;
  bool steps = true;
  bool gaps = true;
  bool drops = true;
  bool outlines = true;              ///< creases of the environment and outlines of the walkable area
  bool cells = false;                ///< of a parallel block, over everything that faces up
  bool inside = true;                ///< one looks into closed levels; LevelView::setInside() knows better, as with:
  ViewMode mode = ViewMode::Result;  ///< LevelView::setMode() knows better than who switches parts
  [[nodiscard]] bool shows(Removal removal) const { return (plainRemovals & bitOf(removal)) == 0; }
  void show(Removal removal, bool on) {
    plainRemovals = static_cast<std::uint8_t>(on ? plainRemovals & ~bitOf(removal) : plainRemovals | bitOf(removal));
  }
  bool operator==(const SceneParts&) const = default;

 private:
  static unsigned bitOf(Removal removal) { return 1U << static_cast<unsigned>(removal); }
};

/// What the rule depends on besides the parts.
struct SceneFacts {
  bool reasons = false;    ///< a filter has removed something: floors of the environment have a reason
  bool bothSides = false;  ///< fronts and backs of triangles mean nothing
  double down = 0;         ///< sine of the angle at which the camera looks down
};

struct SceneRule {
  /// Which triangles of the environment are drawn.
  enum class Environment : std::uint8_t { All, Floors, None };
  /// How pieces of the walkable area are drawn that are not to be seen as such.
  enum class Unseen : std::uint8_t {
    LeftOut,
    Plain,  ///< as floor about which nothing is said: what lies under them has the paint of a reason that is not theirs
    Gap     ///< so that one sees neither them nor the floor that they lie on
  };

  SceneRule(const SceneParts& parts, const SceneFacts& facts);
  SceneRule() = default;

  Environment environment = Environment::All;
  bool wires = false;                    ///< the edges of triangles are drawn
  bool through = false;                  ///< nothing hides anything
  bool reasons = true;                   ///< floors have the paints of the filters that removed them
  bool walkable = true;                  ///< as such
  bool field = false;                    ///< all floors, in the colours of a heat map
  bool backs = true;                     ///< faces seen from behind
  bool covers = true;                    ///< roofs and outer walls of what is closed
  Unseen unseen = Unseen::LeftOut;       ///< all pieces, where `walkable` is off
  Unseen unseenLayer = Unseen::LeftOut;  ///< pieces of hidden layers whose triangle of the environment stays
  bool operator==(const SceneRule&) const = default;
};

}  // namespace footfall::ui
