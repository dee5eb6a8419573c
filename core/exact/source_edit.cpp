// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact/source_edit.hpp"

#include <algorithm>
#include <numeric>

#include "core/base/parallel.hpp"
#include "core/exact/source_predicates.hpp"

namespace footfall::detail {
namespace {

// The tree is built anew when more than one triangle in so many came after it.
constexpr std::size_t kMostAddedShare = 8;

constexpr std::size_t kTrianglesPerTask = 8192;
constexpr std::size_t kPolled = 1 << 15;

/// A triangle and its number in the environment: the order of a source mesh.
struct SortedTriangle {
  std::array<Index, 3> corners;
  std::uint32_t number;
  auto operator<=>(const SortedTriangle&) const = default;
};

class Editor {
 public:
  Editor(const SourceMesh& base, const SoupEdit& edit, Poll poll)
      : base_(base), edit_(edit), poll_(poll), changes_(std::make_shared<SourceEdit>()) {}

  std::shared_ptr<SourceMesh> run() {
    mergeVertices();
    chooseGrid(mesh_, poll_);
    if (mesh_.grid.scaleExponent() != base_.grid.scaleExponent()) return nullptr;
    mergeTriangles();
    makeTree();
    mesh_.edit = changes_;
    return std::make_shared<SourceMesh>(std::move(mesh_));
  }
  [[nodiscard]] const std::shared_ptr<SourceEdit>& changes() const { return changes_; }

 private:
  void mergeVertices() {
    std::vector<char> used(base_.vertices.size(), 0);
    for (const std::uint32_t v : edit_.keptVertices) used[base_.welded[v]] = 1;
    const auto firstAdded = static_cast<std::uint32_t>(edit_.keptVertices.size());
    std::vector<std::uint32_t> added(edit_.soup.vertices.size() - firstAdded);
    std::iota(added.begin(), added.end(), firstAdded);
    const auto place = [&](std::uint32_t v) { return withoutNegativeZeros(edit_.soup.vertices[v]); };
    std::sort(added.begin(), added.end(),
              [&](std::uint32_t a, std::uint32_t b) { return isBefore(place(a), place(b)); });

    mesh_.vertices.reserve(base_.vertices.size() + added.size());
    mesh_.planIds.reserve(base_.vertices.size() + added.size());
    std::vector<Index> welded(edit_.soup.vertices.size());
    changes_->vertexOf.assign(base_.vertices.size(), -1);
    changes_->planOf.assign(base_.vertices.size(), -1);
    const auto append = [&](const Vec3& v) {
      const auto index = static_cast<Index>(mesh_.vertices.size());
      if (index > 0 && mesh_.vertices.back() == v) return index - 1;
      const bool samePlan = index > 0 && mesh_.vertices.back().x == v.x && mesh_.vertices.back().y == v.y;
      mesh_.planIds.push_back(samePlan ? mesh_.planIds.back() : index);
      mesh_.vertices.push_back(v);
      return index;
    };
    std::size_t next = 0;
    const auto appendAdded = [&] {
      welded[added[next]] = append(place(added[next]));
      ++next;
    };
    for (std::size_t v = 0; v < base_.vertices.size(); ++v) {
      if (v % kPolled == 0) poll_();
      if (used[v] == 0) continue;
      while (next < added.size() && isBefore(place(added[next]), base_.vertices[v])) appendAdded();
      const Index index = append(base_.vertices[v]);
      changes_->vertexOf[v] = index;
      changes_->planOf[base_.planIds[v]] = mesh_.planIds[index];
    }
    while (next < added.size()) appendAdded();
    for (std::size_t i = 0; i < edit_.keptVertices.size(); ++i)
      welded[i] = changes_->vertexOf[base_.welded[edit_.keptVertices[i]]];
    mesh_.welded = SharedArray(std::move(welded));
  }

  void mergeTriangles() {
    const std::size_t kept = edit_.keptTriangles.size(), count = edit_.soup.triangles.size();
    std::vector<Index> numberOf(base_.triangles.size(), -1);  // present number of each triangle
    for (std::size_t i = 0; i < kept; ++i) numberOf[edit_.keptTriangles[i]] = static_cast<Index>(i);
    std::vector<SortedTriangle> added;
    for (std::size_t i = kept; i < count; ++i)
      added.push_back({turnedTriangle(mesh_, edit_.soup.triangles[i], edit_.bothSides), static_cast<std::uint32_t>(i)});
    std::sort(added.begin(), added.end());

    // The origin of each triangle: a triangle of the base, or -1 - its place among the added ones.
    changes_->triangleOf.assign(base_.triangles.size(), -1);
    changes_->baseOf.reserve(count);
    std::size_t next = 0;
    const auto appendAdded = [&] { changes_->baseOf.push_back(-1 - static_cast<Index>(next++)); };
    for (std::size_t t = 0; t < base_.triangles.size(); ++t) {
      if (t % kPolled == 0) poll_();
      const Index number = numberOf[base_.inputTriangles[t]];
      if (number < 0) {
        changes_->removed.push_back(boxOf(base_, static_cast<Index>(t)));
        continue;
      }
      if (next < added.size()) {
        SortedTriangle triangle{base_.triangles[t], static_cast<std::uint32_t>(number)};
        for (Index& v : triangle.corners) v = changes_->vertexOf[v];
        while (next < added.size() && added[next] < triangle) appendAdded();
      }
      changes_->triangleOf[t] = static_cast<Index>(changes_->baseOf.size());
      changes_->baseOf.push_back(static_cast<Index>(t));
    }
    while (next < added.size()) appendAdded();

    mesh_.triangles = SharedArray<std::array<Index, 3>>(count);
    mesh_.inputTriangles = SharedArray<std::uint32_t>(count);
    auto* const triangles = mesh_.triangles.own();
    std::uint32_t* const inputTriangles = mesh_.inputTriangles.own();
    forRanges(count, kTrianglesPerTask, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) {
        const Index then = changes_->baseOf[t];
        if (then < 0) continue;
        for (int k = 0; k < 3; ++k) triangles[t][k] = changes_->vertexOf[base_.triangles[then][k]];
        inputTriangles[t] = static_cast<std::uint32_t>(numberOf[base_.inputTriangles[then]]);
      }
    });
    mesh_.normals = valuesOfKept(base_.normals);
    mesh_.facing = valuesOfKept(base_.facing);
    mesh_.degenerate = valuesOfKept(base_.degenerate);
    const SignRule sign = mesh_.grid.signRule(mesh_.grid.scaleExponent());
    for (Index t = 0; t < static_cast<Index>(count); ++t) {
      if (changes_->baseOf[t] >= 0) continue;
      const SortedTriangle& triangle = added[-1 - changes_->baseOf[t]];
      changes_->baseOf[t] = -1;
      triangles[t] = triangle.corners;
      inputTriangles[t] = triangle.number;
      classifyTriangle(mesh_, t, sign);
      if (mesh_.degenerate[t] == 0) changes_->addedTriangles.push_back(t);
      changes_->added.push_back(boxOf(mesh_, t));
    }
  }

  // Copies runs of elements that stay; added triangles get a default.
  template <class T>
  [[nodiscard]] SharedArray<T> valuesOfKept(const SharedArray<T>& before) const {
    const std::vector<Index>& from = changes_->baseOf;
    std::vector<T> now;
    now.reserve(from.size());
    for (std::size_t first = 0; first < from.size();) {
      std::size_t last = first + 1;
      if (from[first] < 0) {
        now.emplace_back();
      } else {
        while (last < from.size() && from[last] == from[last - 1] + 1) ++last;
        now.insert(now.end(), before.begin() + from[first], before.begin() + from[last - 1] + 1);
      }
      first = last;
    }
    return SharedArray(std::move(now));
  }

  void makeTree() {
    // Triangles that the shared tree lacks: added now, or by earlier edits.
    std::vector<Box> boxes;
    std::vector<std::int32_t> ids;
    const auto add = [&](Index t) {
      if (mesh_.degenerate[t] != 0) return;
      boxes.push_back(boxOf(mesh_, t));
      ids.push_back(t);
    };
    for (Index t = 0; t < static_cast<Index>(mesh_.triangles.size()); ++t) {
      const Index earlier = changes_->baseOf[t];
      if (earlier < 0 || (!base_.addedLater.empty() && base_.addedLater[earlier] != 0)) add(t);
    }
    if (ids.size() * kMostAddedShare < mesh_.triangles.size()) {
      mesh_.addedLater.assign(mesh_.triangles.size(), 0);
      for (const std::int32_t t : ids) mesh_.addedLater[t] = 1;
      mesh_.tree = SourceTree::edited(base_.tree, changes_->triangleOf, boxes, ids);
      return;
    }
    buildTree(mesh_, poll_);
  }

  const SourceMesh& base_;
  const SoupEdit& edit_;
  Poll poll_;
  std::shared_ptr<SourceEdit> changes_;
  SourceMesh mesh_;
};

}  // namespace

std::shared_ptr<const SourceMesh> editSourceMesh(const std::shared_ptr<const SourceMesh>& base, const SoupEdit& edit,
                                                 Poll poll) {
  if (base->welded.empty() || !base->obstacleEdges.empty()) return nullptr;
  Editor editor(*base, edit, poll);
  auto mesh = editor.run();
  if (mesh) editor.changes()->base = base;
  return mesh;
}

}  // namespace footfall::detail
