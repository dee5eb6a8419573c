// Measures how far it is from a place of a navigation mesh to one kind of border by the shortest walk, which may bend
// round corners (docs/explanation/model.md, Margins): all corners that see each other, slow, obvious, in doubles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "tests/reference/border_distance.hpp"

namespace footfall::reference {

class BentDistance {
 public:
  /// The error of its distances: a corner is a place beside it.
  static constexpr double kError = 1e-6;

  /// Measures on a divided border, up to a limit. Both must outlive it.
  BentDistance(const NavigationMesh& mesh, const BorderDistance& straight, BorderKind kind, double most);

  /// The distance, as in BorderDistance::at().
  [[nodiscard]] BorderDistance::Distance at(const SurfacePlace& from, bool orDoubtful) const;

 private:
  /// The corner at which triangles go round an end of the border, from one edge of it to the next one.
  struct Corner {
    double x = 0, y = 0;
    std::vector<SurfacePlace> beside;            ///< place in each of these triangles
    std::array<std::optional<double>, 2> least;  ///< certain, and with what is doubtful
    bool isDoubtful = false;
  };
  using Cell = std::array<int, 2>;
  void findCorners();
  void findDistances(bool orDoubtful);
  [[nodiscard]] Cell cellOf(double x, double y) const;
  template <class Visit>
  void visitNear(double x, double y, const Visit& visit) const;
  struct Sight {
    std::optional<double> length;
    bool isDoubtful = false;
  };
  [[nodiscard]] Sight see(const SurfacePlace& from, const Corner& corner, bool orDoubtful) const;

  const NavigationMesh& mesh_;
  const BorderDistance& straight_;
  BorderKind kind_;
  double most_;
  std::vector<Corner> corners_;
  std::map<Cell, std::vector<std::size_t>> cells_;
};

}  // namespace footfall::reference
