// The parts of a face that are still open, on a grid: triangles certainly beside them need no exact look.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/exact/plan_kernel.hpp"

namespace footfall::detail {

class Slices;

/// A grid of 64 x 64 squares over the box of a face in the plan. Points are rounded, with their errors; a square counts
/// as closed only where that proves it, and open ones may be closed in truth.
///
/// Proof. The true triangle lies within the rounded one, moved by at most the largest error e of its corners along each
/// axis; so what holds for the rounded one between the heights low - e and high + e, and e further in or out, holds for
/// the true one between low and high. Where an edge passes a height is computed with at most eight roundings, each of
/// at most 2^-53 of the edge's coordinates; a margin of 2^-49 of those covers them. Upright edges have none.
class OpenGrid {
 public:
  using Outline = std::array<ApproximatePoint, 3>;  ///< outline of a triangle; either way round

  /// Opens all squares that the face reaches.
  OpenGrid(const PlanKernel& kernel, Index face);

  /// Closes everything.
  void close();
  /// Opens what a triangle may reach.
  void open(const Outline& triangle);
  /// Closes the squares that lie in a triangle.
  void cover(const Outline& triangle);
  /// True when a triangle may reach something open.
  [[nodiscard]] bool mayReach(const Outline& triangle) const;
  [[nodiscard]] bool isClosed() const;

  static constexpr std::size_t kSquares = 64;  ///< number of squares in a row, and of rows
  [[nodiscard]] bool isOpen(std::size_t column, std::size_t row) const { return (open_[row] >> column & 1) != 0; }
  /// The middle of a square, rounded.
  [[nodiscard]] std::array<double, 2> middle(std::size_t column, std::size_t row) const {
    return {(x_[column] + x_[column + 1]) / 2, (y_[row] + y_[row + 1]) / 2};
  }

 private:
  using Row = std::uint64_t;

  /// The bits of the columns that [low, high] meets, or of those that lie in it.
  [[nodiscard]] Row columnsMeeting(double low, double high) const;
  [[nodiscard]] Row columnsWithin(double low, double high) const;
  /// Calls visit(row) for each row that may have something in common with heights from low to high; until it is true.
  template <class Visit>
  bool visitRows(double low, double high, const Visit& visit) const;
  /// True when the box of a triangle meets an open square.
  [[nodiscard]] bool mayMeet(const Outline& triangle) const;
  [[nodiscard]] Row squaresMet(const Slices& triangle, std::size_t row) const;

  std::array<double, kSquares + 1> x_{}, y_{};  ///< the borders of columns and rows
  double columnsPerUnit_ = 0, rowsPerUnit_ = 0;
  std::array<Row, kSquares> open_{};
  Row openColumns_ = 0;  ///< columns with an open square
  /// The triangles opened since all was closed, while they are few: squares are coarse beside thin triangles.
  std::vector<Outline> opened_;
  bool areAllListed_ = true;
  double slack_;
};

/// The outline of a source triangle, relative to a vertex.
OpenGrid::Outline outlineInPlan(const PlanKernel& kernel, Index triangle, Index origin);

}  // namespace footfall::detail
