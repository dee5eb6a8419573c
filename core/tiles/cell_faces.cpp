// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/cell_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/box_tree.hpp"
#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

using Tree = BoxTree<3>;

Tree::Bounds boundsOf(const Box& box) { return {box.lower, box.upper}; }

/// Boxes, and what touches one of them. A box beside all of them may be taken for one that does.
class BoxSet {
 public:
  BoxSet(std::vector<Box> boxes, RunContext& context) : boxes_(std::move(boxes)) {
    std::vector<Index> ids(boxes_.size());
    std::iota(ids.begin(), ids.end(), 0);
    tree_.build(
        ids, [this](Index i) { return boundsOf(boxes_[static_cast<std::size_t>(i)]); }, context);
  }

  [[nodiscard]] bool touches(const Box& box) const {
    bool found = false;
    tree_.visitOverlapping(boundsOf(box), [&found](Index) { found = true; });
    return found;
  }

 private:
  std::vector<Box> boxes_;
  Tree tree_;
};

std::vector<std::size_t> blocksTouching(const PackedEnvironment& environment, const BoxSet& boxes) {
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i < environment.blocks().size(); ++i)
    if (environment.blocks()[i].faces > 0 && boxes.touches(environment.boxOf(i))) blocks.push_back(i);
  return blocks;
}

bool contains(const std::vector<std::uint32_t>& ascending, std::uint32_t number) {
  return std::binary_search(ascending.begin(), ascending.end(), number);
}

constexpr double kAllHeights = 0x1p1000;

/// Larger by `around` in the plan, by `height` up and down, and everywhere by far more than boxes of borders are off
/// by.
void widen(Box& box, double around, double height) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double added = std::min(axis == 2 ? height : around, kAllHeights);
    const double margin = (std::max(std::fabs(box.lower[axis]), std::fabs(box.upper[axis])) + added) * 0x1p-22;
    box.lower[axis] -= added + margin;
    box.upper[axis] += added + margin;
  }
}

}  // namespace

/// Ascending by number; the boxes of all of them, with the clearance above.
struct CellCollector::Floors {
  std::vector<std::uint32_t> own, seen, near;
  std::vector<Box> boxes;

  [[nodiscard]] std::uint64_t count() const { return own.size() + seen.size() + near.size(); }
  [[nodiscard]] CellKind kindOf(std::uint32_t number) const {
    if (contains(own, number)) return CellKind::Own;
    if (contains(seen, number)) return CellKind::Seen;
    return contains(near, number) ? CellKind::Near : CellKind::Other;
  }
};

CellCollector::CellCollector(const PackedEnvironment& environment, FloorRule rule)
    : environment_(environment), rule_(std::move(rule)), first_{0} {
  for (const PackedBlock& block : environment.blocks()) first_.push_back(first_.back() + block.faces);
}

bool CellCollector::isFloor(const BlockFace& face) const {
  if (roleOf(face.part) != PartRole::Floor) return false;
  auto [a, b, c] = face.corners;
  const int side = facing(a, b, c);
  if (side == 0 || (side < 0 && !environment_.head().bothSides)) return false;
  if (side < 0) std::swap(b, c);
  return std::all_of(rule_.slopes.begin(), rule_.slopes.end(),
                     [p = a, q = b, r = c](double degrees) { return isWithinSlope(p, q, r, degrees); });
}

bool CellCollector::isOwn(const OwnFloors& own, const BlockFace& face) const {
  if (own.listed != nullptr) return contains(own.listed->floors, face.number);
  const std::uint64_t number = first_[face.block] + face.place;
  return number >= own.range.first && number < own.range.last;
}

std::vector<std::size_t> CellCollector::ownBlocks(const OwnFloors& own) const {
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i + 1 < first_.size(); ++i)
    if (own.listed != nullptr || (first_[i] < own.range.last && first_[i + 1] > own.range.first)) blocks.push_back(i);
  return blocks;
}

// Adds floors that touch boxes, except known ones.
void CellCollector::addTouching(std::vector<Box> boxes, const Fits& fits, RunContext& context, Floors& floors,
                                std::vector<std::uint32_t>& found) const {
  const BoxSet set(std::move(boxes), context);
  std::vector<std::uint32_t> added;
  for (const std::size_t block : blocksTouching(environment_, set)) {
    context.checkCancelled();
    if (!fits({floors.boxes.size(), floors.boxes.size()})) break;
    environment_.forFaces(block, [&](const BlockFace& face) {
      const Box box = boxOf(face);
      if (!set.touches(box) || floors.kindOf(face.number) != CellKind::Other || !isFloor(face)) return;
      added.push_back(face.number);
      floors.boxes.push_back(box);
    });
  }
  found.insert(found.end(), added.begin(), added.end());
  std::sort(found.begin(), found.end());
}

CellCollector::Floors CellCollector::findFloors(const OwnFloors& own, const Fits& fits, RunContext& context,
                                                int reach) const {
  Floors floors;
  for (const std::size_t block : ownBlocks(own)) {
    context.checkCancelled();
    environment_.forFaces(block, [&](const BlockFace& face) {
      if (!isOwn(own, face) || !isFloor(face)) return;
      floors.own.push_back(face.number);
      floors.boxes.push_back(boxOf(face));
    });
  }
  std::sort(floors.own.begin(), floors.own.end());
  if (rule_.step > 0 && reach > 0) {
    std::vector<Box> raised = floors.boxes;
    for (Box& box : raised) widen(box, rule_.gap, reach * rule_.step);
    if (own.listed != nullptr)
      for (const FloorsAtGaps::Corner& corner : own.listed->corners) {
        raised.push_back({{corner.x, corner.y, 0}, {corner.x, corner.y, 0}});
        widen(raised.back(), 2 * rule_.gap, kAllHeights);
      }
    addTouching(std::move(raised), fits, context, floors, floors.seen);
    // The first ring has whole vertices where it touches, the second one makes it conforming there.
    addTouching(floors.boxes, fits, context, floors, floors.near);
  }
  addTouching(floors.boxes, fits, context, floors, floors.near);
  // The height of a box in the clearance, as in clearanceBox().
  for (Box& box : floors.boxes) {
    if (rule_.step > 0) widen(box, rule_.gap, 0);
    box.upper[2] = std::nextafter(box.upper[2] + rule_.height, std::numeric_limits<double>::infinity());
  }
  return floors;
}

std::optional<CellFaces> CellCollector::collect(const OwnFloors& own, const Fits& fits, RunContext& context,
                                                CellSize* size, int reach) const {
  Floors floors = findFloors(own, fits, context, reach);
  CellSize found{0, floors.count()};
  const auto tell = [&] {
    if (size != nullptr) *size = found;
  };
  tell();
  if (!fits({found.floors, found.floors})) return std::nullopt;
  CellFaces cell;
  cell.floors = found.floors;
  cell.reach = reach;
  cell.isListed = own.listed != nullptr;
  if (floors.own.empty()) return cell;
  const BoxSet boxes(std::move(floors.boxes), context);
  const std::vector<std::size_t> blocks = blocksTouching(environment_, boxes);
  bool isFull = false;
  PackedFaces faces = environment_.facesOf(
      blocks,
      [&](const BlockFace& face) {
        if (isFull || roleOf(face.part) == PartRole::Ignored || !boxes.touches(boxOf(face))) return false;
        ++found.faces;
        isFull = !fits(found);
        return true;
      },
      &context);
  tell();
  if (isFull) return std::nullopt;
  cell.faces = std::move(faces);
  for (const std::uint32_t number : cell.faces.faceNumbers) cell.kinds.push_back(floors.kindOf(number));
  if (std::ranges::find(rule_.roles, PartRole::ObstacleOnly) != rule_.roles.end())
    for (std::size_t f = 0; f < cell.kinds.size(); ++f) {
      const std::uint32_t part = cell.faces.partOf.empty() ? 0 : cell.faces.partOf[f];
      cell.obstacleOnly.push_back(static_cast<std::uint8_t>(roleOf(part) == PartRole::ObstacleOnly));
    }
  return cell;
}

CellSize CellCollector::measure(const OwnFloors& own, RunContext& context, int reach) const {
  Floors floors = findFloors(
      own, [](const CellSize&) { return true; }, context, reach);
  CellSize size{0, floors.count()};
  if (floors.own.empty()) return size;
  const BoxSet boxes(std::move(floors.boxes), context);
  for (const std::size_t block : blocksTouching(environment_, boxes)) {
    context.checkCancelled();
    environment_.forFaces(block, [&](const BlockFace& face) {
      size.faces += roleOf(face.part) != PartRole::Ignored && boxes.touches(boxOf(face)) ? 1U : 0U;
    });
  }
  return size;
}

}  // namespace footfall::detail
