// RadiusFilter's promise at random places: nothing nearer than the radius is left, nothing farther than its tolerance
// is lost (docs/explanation/model.md, Margins). Slow, obvious, in doubles.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "footfall/environment.hpp"
#include "tests/reference/bent_distance.hpp"

namespace footfall::reference {

/// The distances that an agent keeps to walls and to ledges.
struct RadiusDistances {
  double walls = 0, ledges = 0;
  double tolerance = 0.01;
  [[nodiscard]] bool areEqual() const { return walls == ledges; }
};

/// The number of places that were checked.
struct RadiusTally {
  std::size_t near = 0, far = 0;     ///< number of those that certainly must go, or stay
  std::size_t between = 0;           ///< may go or stay
  std::size_t onNeedles = 0;         ///< triangles so thin that doubles say nothing of them
  std::size_t doubtful = 0;          ///< walks from there came upon one
  std::size_t wrong = 0;             ///< number of those that should have gone and stayed, or the other way round
  std::vector<std::string> reports;  ///< about the first of these
  RadiusTally& operator+=(const RadiusTally& other);
};

/// Looks at places of the area before the filter: evenly strewn, and along its border.
class RadiusPromise {
 public:
  /// Only the first `floors` triangles of `before` are area. The others are bridges over gaps: walks lead over them,
  /// and where one ends at their sides, there is a border.
  RadiusPromise(const NavigationMesh& before, std::size_t floors, const NavigationMesh& after,
                const RadiusDistances& distances);

  /// Tells walls from ledges, which must be done where the distances differ. Then walks may bend.
  void divide(const Environment& environment, double step, double height);

  [[nodiscard]] RadiusTally look(int places, std::mt19937& random) const;

 private:
  struct Nearest {
    std::optional<double> wall, ledge;
    bool isDoubtful = false;
  };
  [[nodiscard]] SurfacePlace anywhere(double which, double u, double v) const;
  [[nodiscard]] SurfacePlace inside(std::uint32_t t, double u, double v) const;
  [[nodiscard]] SurfacePlace nearBorder(double which, double along, double how) const;
  void lookAt(const SurfacePlace& place, RadiusTally& tally) const;
  [[nodiscard]] Nearest nearestTo(const SurfacePlace& place, bool orDoubtful) const;
  void tell(const char* what, const SurfacePlace& place, const Nearest& nearest, RadiusTally& tally) const;

  const NavigationMesh& mesh_;
  std::size_t floors_;
  BorderDistance before_, after_;
  std::unique_ptr<BentDistance> bent_;  ///< distance to the kind that keeps more away, if the distances differ
  RadiusDistances asked_;
  double radius_;  ///< the larger one
  std::vector<double> sums_;
};

/// A mesh with bridges over its gaps, behind its own triangles, and with no other links than steps.
NavigationMesh bridged(const NavigationMesh& mesh);

/// The mesh on which the area is measured. Where lines coincide but for roundings, the rounded products of the area as
/// it is and of the simplified area that RadiusFilter begins with differ, in what is joined and by slivers.
enum class MeasuredArea { AsGiven, Simplified };

/// A pipeline's text with RadiusFilter behind it, against the same without.
class RadiusCase {
 public:
  RadiusCase(const std::shared_ptr<const Environment>& environment, const std::string& before,
             const RadiusDistances& distances, MeasuredArea measured = MeasuredArea::AsGiven);

  /// A mesh that no product may be counts as wrong.
  [[nodiscard]] RadiusTally look(int places, std::mt19937& random) const;

 private:
  NavigationMesh all_, left_;
  std::string error_;
  std::unique_ptr<RadiusPromise> promise_;
};

/// The same at once.
RadiusTally lookAtRadius(const std::shared_ptr<const Environment>& environment, const std::string& before,
                         const RadiusDistances& distances, int places, std::mt19937& random,
                         MeasuredArea measured = MeasuredArea::AsGiven);

}  // namespace footfall::reference
