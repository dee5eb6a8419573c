// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/packed_part.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "core/io/file_frame.hpp"
#include "footfall/errors.hpp"
#include "footfall/up_axis.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

bool touchInPlan(const Box& a, const Box& b) {
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (a.lower[axis] > b.upper[axis] || b.lower[axis] > a.upper[axis]) return false;
  return true;
}

Box boxOf(const std::array<Vec3, 3>& corners) {
  BlockFace face;
  face.corners = corners;
  return boxOf(face);
}

/// The bounds of all blocks.
Box boundsOf(const PackedEnvironment& environment) {
  constexpr double kMost = std::numeric_limits<double>::max();
  Box bounds{{kMost, kMost, kMost}, {-kMost, -kMost, -kMost}};
  for (std::size_t b = 0; b < environment.blocks().size(); ++b) {
    if (environment.blocks()[b].faces == 0) continue;
    const Box box = environment.boxOf(b);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.lower[axis] = std::min(bounds.lower[axis], box.lower[axis]);
      bounds.upper[axis] = std::max(bounds.upper[axis], box.upper[axis]);
    }
  }
  return bounds;
}

double middle(const Box& box, std::size_t axis) { return box.lower[axis] / 2 + box.upper[axis] / 2; }

/// The estimate assumes that the triangles of a block are spread evenly over its box.
double estimatedFaces(const PackedEnvironment& environment, const PartPlace& place) {
  const Box part = boxOf(place);
  double faces = 0;
  for (std::size_t b = 0; b < environment.blocks().size(); ++b) {
    const Box box = environment.boxOf(b);
    double share = 1;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double side = box.upper[axis] - box.lower[axis];
      const double common = std::min(box.upper[axis], part.upper[axis]) - std::max(box.lower[axis], part.lower[axis]);
      share *= common < 0 ? 0 : side > 0 ? std::min(1.0, common / side) : 1;
    }
    faces += share * environment.blocks()[b].faces;
  }
  return faces;
}

/// The square at a place that has at most `most` triangles, by the estimate.
PartPlace fitted(const PackedEnvironment& environment, PartPlace place, std::size_t most) {
  constexpr int kHalvings = 40;
  if (estimatedFaces(environment, place) <= static_cast<double>(most)) return place;
  double low = 0, high = place.half;
  for (int i = 0; i < kHalvings; ++i) {
    place.half = low / 2 + high / 2;
    (estimatedFaces(environment, place) <= static_cast<double>(most) ? low : high) = place.half;
  }
  place.half = low;
  return place;
}

/// A corner of a triangle in the block nearest to the middle of everything.
PartPlace middlePlace(const PackedEnvironment& environment, const Box& bounds) {
  PartPlace place{0, 0, std::max(bounds.upper[0] / 2 - bounds.lower[0] / 2, bounds.upper[1] / 2 - bounds.lower[1] / 2)};
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> nearestBlock;
  for (std::size_t b = 0; b < environment.blocks().size(); ++b) {
    if (environment.blocks()[b].faces == 0) continue;
    const Box box = environment.boxOf(b);
    const double away = std::hypot(middle(box, 0) - middle(bounds, 0), middle(box, 1) - middle(bounds, 1));
    if (nearestBlock && !(away < nearest)) continue;
    nearest = away;
    nearestBlock = b;
  }
  const BlockArrays arrays = environment.block(nearestBlock.value());
  const auto& [x, y, z] = arrays.places[arrays.corners.front()[0]];
  const Vec3 corner = fromFileFrame({x, y, z}, environment.head().up);
  place.x = corner.x;
  place.y = corner.y;
  return place;
}

/// The place, or the largest of a series of ever smaller squares around it, that at most `most` faces touch; empty
/// where all squares have more. Reads each block once.
std::optional<PartPlace> placeWithin(const PackedEnvironment& environment, const PartPlace& place, std::size_t most,
                                     RunContext& context) {
  constexpr double kSmaller = 0.85;
  constexpr int kTries = 40;
  std::vector<PartPlace> tries{place};
  for (int i = 0; i < kTries; ++i) tries.push_back({place.x, place.y, tries.back().half * kSmaller});
  std::vector<Box> boxes;
  for (const PartPlace& each : tries) boxes.push_back(boxOf(each));
  // for each square, the faces that touch the square before it but not this one
  std::vector<std::size_t> lost(tries.size() + 1);
  for (const std::size_t block : environment.blocksTouching(boxes.front())) {
    context.checkCancelled();
    environment.forFaces(block, [&](const BlockFace& face) {
      const Box own = boxOf(face);
      const auto first =
          std::partition_point(boxes.begin(), boxes.end(), [&](const Box& box) { return touchInPlan(own, box); });
      if (first != boxes.begin()) ++lost[static_cast<std::size_t>(first - boxes.begin())];
    });
  }
  std::size_t count = std::accumulate(lost.begin(), lost.end(), std::size_t{0});
  for (std::size_t i = 0; i < tries.size(); ++i) {
    if (count <= most) return tries[i];
    count -= lost[i + 1];
  }
  return std::nullopt;
}

PackedFaces facesAt(const PackedEnvironment& environment, const PartPlace& place, RunContext& context) {
  const Box box = boxOf(place);
  return environment.facesOf(
      environment.blocksTouching(box), [&](const BlockFace& face) { return touchInPlan(boxOf(face), box); }, &context);
}

/// Files of version 1 have no coarse surface, so the boxes of blocks are shown.
void addBox(BackdropPiece& piece, const Box& box, const Vec3& centre) {
  const auto corner = [&](unsigned i) {
    return Vec3{(i & 1U) != 0 ? box.upper[0] : box.lower[0], (i & 2U) != 0 ? box.upper[1] : box.lower[1],
                (i & 4U) != 0 ? box.upper[2] : box.lower[2]};
  };
  constexpr unsigned kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& side : kSides) {
    addBackdropTriangle(piece, {corner(side[0]), corner(side[1]), corner(side[2])}, centre, false);
    addBackdropTriangle(piece, {corner(side[0]), corner(side[2]), corner(side[3])}, centre, false);
  }
}

/// Some of these boxes reach farthest.
BackdropPiece boxesOf(const PackedEnvironment& environment, const Vec3& centre) {
  BackdropPiece boxes;
  for (std::size_t b = 0; b < environment.blocks().size(); ++b)
    if (environment.blocks()[b].faces > 0) addBox(boxes, environment.boxOf(b), centre);
  return boxes;
}

void makeCoarse(PackedPart& part) {
  const PackedEnvironment& environment = *part.environment;
  const Vec3& centre = part.whole->centre;
  auto piece = std::make_shared<BackdropPiece>();
  std::vector<std::size_t> ends(environment.blocks().size());
  environment.forCoarseFaces([&](std::size_t block, const CoarseFace& face) {
    addBackdropTriangle(*piece, face, centre, environment.head().bothSides);
    ends[block] = piece->triangles();
  });
  if (piece->surface.empty()) {
    for (std::size_t b = 0; b < environment.blocks().size(); ++b) {
      if (environment.blocks()[b].faces == 0) continue;
      addBox(*piece, environment.boxOf(b), centre);
      ends[b] = piece->triangles();
    }
  }
  part.firstCoarse = {0};
  for (const std::size_t end : ends) part.firstCoarse.push_back(std::max(part.firstCoarse.back(), end));
  part.coarse = std::move(piece);
}

/// Marks the coarse triangles that stand for triangles of the part.
void markCoarse(PackedPart& part) {
  const PackedEnvironment& environment = *part.environment;
  const Box region = boxOf(part.place);
  environment.forCoarseFaces([&](std::size_t, const CoarseFace& face) {
    part.isCoarseInPart.push_back(touchInPlan(boxOf(face), region) ? 1 : 0);
  });
  if (!part.isCoarseInPart.empty()) return;
  part.isCoarseInPart.resize(part.coarse->triangles());
  for (std::size_t b = 0; b < environment.blocks().size(); ++b)
    if (touchInPlan(environment.boxOf(b), region))
      for (std::size_t t = part.firstCoarse[b]; t < part.firstCoarse[b + 1]; ++t) part.isCoarseInPart[t] = 1;
}

}  // namespace

Box boxOf(const PartPlace& place) {
  constexpr double kMost = std::numeric_limits<double>::max();
  return {{place.x - place.half, place.y - place.half, -kMost}, {place.x + place.half, place.y + place.half, kMost}};
}

BackdropPiecePtr makeBlockPiece(const PackedPart& part, std::size_t block) {
  auto piece = std::make_shared<BackdropPiece>();
  const Box region = boxOf(part.place);
  part.environment->forFaces(block, [&](const BlockFace& face) {
    if (!touchInPlan(boxOf(face), region))
      addBackdropTriangle(*piece, face.corners, part.whole->centre, part.environment->head().bothSides);
  });
  piece->surface.shrink_to_fit();
  return piece;
}

bool isInPart(const PackedPart& part, std::size_t block) {
  const Box region = boxOf(part.place), box = part.environment->boxOf(block);
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (box.lower[axis] < region.lower[axis] || box.upper[axis] > region.upper[axis]) return false;
  return true;
}

bool touchesPart(const PackedPart& part, std::size_t block) {
  return touchInPlan(part.environment->boxOf(block), boxOf(part.place));
}

bool isSameFile(const PackedPart& a, const PackedPart& b) {
  const Environment &head = a.environment->head(), &other = b.environment->head();
  return a.environment->tableSum() == b.environment->tableSum() && head.source == other.source && head.up == other.up &&
         head.bothSides == other.bothSides && a.whole->centre == b.whole->centre;
}

OpenedPart openPart(std::shared_ptr<const PackedEnvironment> environment, const PackedLimits& limits,
                    const std::optional<PartPlace>& asked, const std::optional<Vec3>& givenCentre, RunContext& context,
                    const PackedPart* before) {
  const Box bounds = boundsOf(*environment);
  OpenedPart opened;
  PackedPart& part = opened.part;
  part.limits = limits;
  const std::size_t most = asked ? limits.part : std::min(limits.first, limits.part);
  // A place of a saved session that had no more triangles than this is used as it is, whatever the estimate.
  constexpr std::size_t kDoubt = 2;
  part.place = asked ? fitted(*environment, *asked, kDoubt * most)
                     : fitted(*environment, middlePlace(*environment, bounds), most);
  const std::optional<PartPlace> place = placeWithin(*environment, part.place, most, context);
  if (!place)
    throw InputError(FOOTFALL_TEXT("%1: more than %2 triangles lie above one place; use footfall run --memory"),
                     environment->head().source, most);
  part.place = *place;
  part.isSmaller = asked && part.place.half < asked->half;
  PackedFaces faces = facesAt(*environment, part.place, context);
  if (faces.soup.triangles.empty())
    throw InputError(FOOTFALL_TEXT("%1: there are no triangles at that place; choose another one"),
                     environment->head().source);
  opened.environment = environment->head();
  opened.environment.vertices = std::move(faces.soup.vertices);
  opened.environment.triangles = std::move(faces.soup.triangles);
  opened.environment.partOf = std::move(faces.partOf);
  // Exports name the part.
  opened.environment.origin += " (a part: " + std::to_string(opened.environment.triangles.size()) + " of " +
                               std::to_string(environment->faceCount()) + " triangles)";
  part.environment = std::move(environment);
  const Vec3 centre = givenCentre.value_or(Vec3{middle(bounds, 0), middle(bounds, 1), middle(bounds, 2)});
  part.whole = makeWholeBounds({bounds.lower[0], bounds.lower[1], bounds.lower[2]},
                               {bounds.upper[0], bounds.upper[1], bounds.upper[2]}, centre,
                               boxesOf(*part.environment, centre).surface);
  if (before != nullptr && isSameFile(*before, part)) {
    part.coarse = before->coarse;
    part.firstCoarse = before->firstCoarse;
  } else {
    makeCoarse(part);
  }
  markCoarse(part);
  return opened;
}

}  // namespace footfall::ui
