// The spatial index of one generation, which an edited environment shares with the one that it was made of.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/poll.hpp"
#include "core/base/triangle_tree.hpp"
#include "core/exact/grid.hpp"
#include "core/exact/tree_turn.hpp"

namespace footfall::detail {

/// A tree over the triangles of an environment. Triangles that were added later are stored beside it, and removed ones
/// are skipped. The order of the visits has no meaning.
class SourceTree {
 public:
  /// Builds the tree as TriangleTree::build() does. `bounds` and the boxes are in the frame of `turn` where there is
  /// one.
  template <class BoxOf>
  void build(const Box& bounds, std::span<const std::int32_t> ids, const BoxOf& boxOf, std::optional<TreeTurn> turn,
             Poll poll) {
    turn_ = turn;
    auto tree = std::make_shared<TriangleTree>();
    tree->build(bounds, ids, boxOf, poll);
    tree_ = std::move(tree);
    numbers_ = nullptr;
    added_ = nullptr;
  }

  /// The tree of an edited environment: `renumbered` gives for each triangle of `earlier` its number now, or -1;
  /// `addedBoxes` and `addedIds` are all triangles that `earlier`'s own tree does not hold.
  static SourceTree edited(const SourceTree& earlier, const std::vector<std::int32_t>& renumbered,
                           std::vector<Box> addedBoxes, std::span<const std::int32_t> addedIds) {
    SourceTree result;
    result.turn_ = earlier.turn_;
    for (Box& box : addedBoxes) box = earlier.inFrame(box);
    result.tree_ = earlier.tree_;
    auto numbers = std::make_shared<std::vector<std::int32_t>>();
    if (earlier.numbers_) {
      numbers->reserve(earlier.numbers_->size());
      for (const std::int32_t id : *earlier.numbers_) numbers->push_back(id < 0 ? -1 : renumbered[id]);
    } else {
      *numbers = renumbered;
    }
    result.numbers_ = std::move(numbers);
    auto added = std::make_shared<TriangleTree>();
    added->build(addedBoxes, addedIds);
    result.added_ = std::move(added);
    return result;
  }

  /// See TriangleTree.
  template <class Visit>
  void visitOverlapping(const Box& query, std::vector<std::int32_t>& stack, Visit visit) const {
    visitInFrame(inFrame(query), stack, visit);
  }

  /// Visits what overlaps the convex hull of some places of the plan, within the heights of a box around them, and
  /// perhaps more of what overlaps the box.
  template <class Visit>
  void visitOver(std::span<const Vec3> places, const Box& box, std::vector<std::int32_t>& stack, Visit visit) const {
    visitInFrame(turn_ ? turn_->around(places, box) : box, stack, visit);
  }

  /// See TriangleTree; only where isExactOn() the grid.
  template <class Visit>
  void visitCrossing(const Box& query, std::vector<std::int32_t>& stack, Visit visit) const {
    if (!tree_) return;
    if (!numbers_) {
      tree_->visitCrossing(query, stack, visit);
      return;
    }
    bool stopped = false;
    tree_->visitCrossing(query, stack, [&](std::int32_t id, bool crosses) {
      stopped = (*numbers_)[id] >= 0 && !visit((*numbers_)[id], crosses);
      return !stopped;
    });
    if (!stopped) added_->visitCrossing(query, stack, visit);
  }

  /// True when different coordinates of triangles on the grid stay different here (TriangleTree::isExactOn()).
  [[nodiscard]] bool isExactOn(const Grid& grid) const {
    const auto isExact = [&](const TriangleTree& tree) { return tree.empty() || tree.isExactOn(grid.low, grid.top); };
    return tree_ && !turn_ && isExact(*tree_) && (!added_ || isExact(*added_));
  }

 private:
  [[nodiscard]] Box inFrame(const Box& box) const { return turn_ ? turn_->around(box) : box; }

  template <class Visit>
  void visitInFrame(const Box& query, std::vector<std::int32_t>& stack, Visit visit) const {
    if (!tree_) return;
    if (!numbers_) {
      tree_->visitOverlapping(query, stack, visit);
      return;
    }
    bool stopped = false;
    tree_->visitOverlapping(query, stack, [&](std::int32_t id) {
      stopped = (*numbers_)[id] >= 0 && !visit((*numbers_)[id]);
      return !stopped;
    });
    if (!stopped) added_->visitOverlapping(query, stack, visit);
  }

  std::optional<TreeTurn> turn_;
  std::shared_ptr<const TriangleTree> tree_;
  std::shared_ptr<const std::vector<std::int32_t>> numbers_;  ///< number of each id in tree_; null: the id itself
  std::shared_ptr<const TriangleTree> added_;                 ///< null together with numbers_
};

}  // namespace footfall::detail
