// Measures how far it is from a place of a navigation mesh to its border, by walking there (docs/explanation/model.md,
// Margins): slow, obvious, in doubles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "footfall/navigation_mesh.hpp"
#include "tests/reference/border_kinds.hpp"

namespace footfall::reference {

/// A place on a triangle of a mesh, seen in the plan.
struct SurfacePlace {
  std::uint32_t triangle = 0;
  double x = 0, y = 0;
};

class BorderDistance {
 public:
  explicit BorderDistance(const NavigationMesh& mesh);

  /// A border: a side of a triangle that can neither be crossed nor be stepped over.
  struct Border {
    std::uint32_t triangle = 0;
    int side = 0;
    BorderStretch stretch{};  ///< part of the side; all of it until divide()
  };
  [[nodiscard]] const std::vector<Border>& borders() const { return borders_; }

  /// Divides the border of the first `floors` triangles into walls and ledges; what the others have is doubtful.
  void divide(const Environment& environment, double step, double height, std::size_t floors);

  struct Distance {
    std::optional<double> least;  ///< nothing where it is above the limit
    bool isDoubtful = false;      ///< a walk came upon a needle, and may have missed a border
  };
  /// The least length, in the plan, of a straight walk from a place to the border, up to a limit. Where `orDoubtful`,
  /// also where the walk ends on another triangle as high as the border.
  [[nodiscard]] Distance at(const SurfacePlace& from, double most, bool orDoubtful) const;
  /// The same to one kind of border, once it is divided, and where `orDoubtful`, to what may be of it.
  [[nodiscard]] Distance at(const SurfacePlace& from, double most, BorderKind kind, bool orDoubtful) const;

  struct Walk {
    SurfacePlace end;
    double length = 0;
    bool isStopped = false;   ///< stopped at a border
    bool isDoubtful = false;  ///< came over a needle
  };
  /// Straight on to a place of the plan, or to the first border.
  [[nodiscard]] Walk walk(const SurfacePlace& from, double x, double y) const;

  /// The triangles behind a side.
  [[nodiscard]] const std::vector<std::uint32_t>& beyond(std::uint32_t triangle, int side) const {
    return beyond_[triangle][side];
  }
  [[nodiscard]] double height(const SurfacePlace& place) const;
  /// Returns whether a triangle is too thin or too small for doubles.
  [[nodiscard]] bool isNeedle(std::uint32_t triangle) const;
  /// The triangle over or under a place of the plan whose height is nearest, if it differs by at most `most`; none
  /// that is hardly wider than roundings.
  [[nodiscard]] std::optional<std::uint32_t> find(double x, double y, double z, double most) const;

 private:
  [[nodiscard]] std::array<double, 2> corner(std::uint32_t triangle, int k) const;
  [[nodiscard]] bool isWide(std::uint32_t triangle) const;
  [[nodiscard]] double heightOn(const Border& border, double x, double y) const;
  template <class Counts>
  [[nodiscard]] Distance leastOf(const SurfacePlace& from, double most, const Counts& counts) const;
  void makeGrid();
  [[nodiscard]] int cell(double value, int axis) const;

  const NavigationMesh& mesh_;
  std::vector<std::array<std::vector<std::uint32_t>, 3>> beyond_;  ///< triangles
  std::vector<Border> borders_;
  int cells_ = 1;  ///< cells of the grid, along either axis
  std::array<double, 2> lower_{}, upper_{};
  std::vector<std::vector<std::uint32_t>> trianglesIn_, bordersIn_;  ///< triangles in each cell of a grid over the plan
};

}  // namespace footfall::reference
