// The rounds in which windows of the clearance field spread (core/mesh/clearance_field.hpp).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "core/mesh/clearance_field.hpp"

namespace footfall::detail {

/// A stretch of an edge that rays of a feature reach.
struct FieldArrival {
  std::uint32_t edge = 0;
  std::uint32_t nextOfEdge = 0;  ///< the arrival before it at the same edge
  FieldWindow window;
};

class FieldSpread {
 public:
  FieldSpread(ClearanceField& field, const FieldOptions& options, Poll poll);
  /// Fills the field, whose surface is there.
  void run();

 private:
  /// The edge of the border that begins at a corner that is a feature, and the range of directions of its rays.
  struct Cone {
    std::uint32_t edge = 0, feature = 0;
    double from = 0, to = 0;  ///< angles from the edge that begins there
  };
  using Arrivals = std::vector<FieldArrival>;

  void findFeatures();
  void addCorner(std::uint32_t edge);
  void beginRays();
  void beginCone(const Cone& cone, Arrivals& out) const;
  /// Follows the rays between a left and a right one through a face, from its side to both others.
  void follow(std::uint32_t face, int side, FieldVector left, FieldVector right, std::uint32_t feature,
              Arrivals& out) const;
  void followWindow(std::uint32_t edge, const FieldWindow& window, Arrivals& out) const;
  void arrive(std::uint32_t half, std::uint32_t feature, bool spreads, double lo, double hi, Arrivals& out) const;
  void takeArrivals();
  void followFresh();
  void finish();
  void addTo(Arrivals& all, const Arrivals& more);

  ClearanceField& field_;
  const FieldSurface& surface_;
  Poll poll_;
  double margin_, tolerance_, bound_;
  std::vector<Cone> cones_;
  std::vector<std::vector<FieldWindow>> windows_;  ///< of each edge
  Arrivals arrivals_;
  std::vector<std::uint32_t> firstArrival_, reached_;  ///< of each edge; the edges that have one
  std::mutex mutex_;
};

}  // namespace footfall::detail
