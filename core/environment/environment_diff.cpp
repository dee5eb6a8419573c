// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/environment_diff.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/numbered_table.hpp"
#include "core/environment/environment_head.hpp"
#include "footfall/edit.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPolled = 1 << 15;
constexpr std::size_t kLeastKeptOf = 4;  // at most one triangle in this many may come or go
constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// Elements with numbers, equal ones chained in ascending order, to be taken one by one.
class Chains {
 public:
  explicit Chains(std::size_t elements) : next_(elements, kNone) {}
  /// Elements must come in descending order.
  void push(std::int32_t key, std::uint32_t element) {
    const auto k = static_cast<std::size_t>(key);
    if (k >= first_.size()) first_.resize(k + 1, kNone);
    next_[element] = std::exchange(first_[k], element);
  }
  /// The smallest that is left, or kNone.
  std::uint32_t take(std::int32_t key) {
    const auto k = static_cast<std::size_t>(key);
    if (k >= first_.size() || first_[k] == kNone) return kNone;
    return std::exchange(first_[k], next_[first_[k]]);
  }

 private:
  std::vector<std::uint32_t> first_;  ///< indexed by key
  std::vector<std::uint32_t> next_;   ///< indexed by element
};

class Differ {
 public:
  Differ(const Environment& before, const Environment& now, RunContext* context)
      : before_(before), now_(now), context_(context) {}

  /// False when too little is the same.
  bool match() {
    numberPositions();
    matchTriangles();
    const std::size_t most = std::max(before_.triangles.size(), now_.triangles.size());
    return (most - keptTriangles_.size()) * kLeastKeptOf <= most;
  }

  std::shared_ptr<const Environment> edited(const std::shared_ptr<const Environment>& base) {
    auto result = std::make_shared<Environment>();
    copyHead(now_, *result);
    auto edit = std::make_shared<EnvironmentEdit>();
    edit->base = base;
    arrangeVertices(*result, *edit);
    arrangeTriangles(*result);
    edit->keptTriangles = std::move(keptTriangles_);
    result->edit = std::move(edit);
    return result;
  }

 private:
  void poll(std::size_t i) const {
    if (i % kPolled == 0 && context_ != nullptr) context_->checkCancelled();
  }

  // Equal numbers for equal positions; there are no negative zeros after import, but other makers may have some.
  void numberPositions() {
    NumberedTable<std::array<std::uint64_t, 3>> table;
    const auto number = [&](const std::vector<Vec3>& vertices, std::vector<std::int32_t>& numbers) {
      numbers.reserve(vertices.size());
      for (std::size_t v = 0; v < vertices.size(); ++v) {
        poll(v);
        const Vec3& p = vertices[v];
        numbers.push_back(table
                              .insert({std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
                                       std::bit_cast<std::uint64_t>(p.z + 0.0)})
                              .first);
      }
    };
    number(now_.vertices, positionNow_);
    number(before_.vertices, positionBefore_);
  }

  /// Its corners' positions, from the smallest.
  static std::array<std::int32_t, 3> keyOf(const Triangle& t, const std::vector<std::int32_t>& positions) {
    std::array<std::int32_t, 3> key{positions[t[0]], positions[t[1]], positions[t[2]]};
    std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
    return key;
  }

  void matchTriangles() {
    NumberedTable<std::array<std::int32_t, 3>> table;
    Chains chains(now_.triangles.size());
    for (std::size_t t = now_.triangles.size(); t-- > 0;) {
      poll(t);
      chains.push(table.insert(keyOf(now_.triangles[t], positionNow_)).first, static_cast<std::uint32_t>(t));
    }
    isTaken_.assign(now_.triangles.size(), 0);
    for (std::size_t t = 0; t < before_.triangles.size(); ++t) {
      poll(t);
      const std::uint32_t same = chains.take(table.insert(keyOf(before_.triangles[t], positionBefore_)).first);
      if (same == kNone) continue;
      isTaken_[same] = 1;
      keptTriangles_.push_back(static_cast<std::uint32_t>(t));
      order_.push_back(same);
    }
    for (std::size_t t = 0; t < now_.triangles.size(); ++t)
      if (isTaken_[t] == 0) order_.push_back(static_cast<std::uint32_t>(t));
  }

  // Each position keeps as many vertices as both versions have there.
  void arrangeVertices(Environment& result, EnvironmentEdit& edit) {
    const std::size_t count = now_.vertices.size();
    Chains chains(count);
    for (std::size_t v = count; v-- > 0;) chains.push(positionNow_[v], static_cast<std::uint32_t>(v));
    vertexOf_.assign(count, kNone);
    result.vertices.reserve(count);
    const auto append = [&](std::size_t v) {
      vertexOf_[v] = static_cast<std::uint32_t>(result.vertices.size());
      result.vertices.push_back(now_.vertices[v]);
    };
    for (std::size_t v = 0; v < before_.vertices.size(); ++v) {
      poll(v);
      const std::uint32_t same = chains.take(positionBefore_[v]);
      if (same == kNone) continue;
      append(same);
      edit.keptVertices.push_back(static_cast<std::uint32_t>(v));
    }
    for (std::size_t v = 0; v < count; ++v)
      if (vertexOf_[v] == kNone) append(v);
  }

  void arrangeTriangles(Environment& result) const {
    result.triangles.reserve(order_.size());
    for (const std::uint32_t t : order_) {
      const Triangle& f = now_.triangles[t];
      result.triangles.push_back({vertexOf_[f[0]], vertexOf_[f[1]], vertexOf_[f[2]]});
    }
    if (!now_.partOf.empty())
      for (const std::uint32_t t : order_) result.partOf.push_back(now_.partOf[t]);
    if (!now_.obstacleOnly.empty())
      for (const std::uint32_t t : order_) result.obstacleOnly.push_back(now_.obstacleOnly[t]);
  }

  const Environment& before_;
  const Environment& now_;
  RunContext* context_;
  std::vector<std::int32_t> positionBefore_, positionNow_;  ///< one per vertex
  std::vector<char> isTaken_;                               ///< one flag per triangle of now_: before_ has it too
  std::vector<std::uint32_t> keptTriangles_;                ///< kept triangles of before_
  std::vector<std::uint32_t> order_;                        ///< the triangles of now_ in the order of the result
  std::vector<std::uint32_t> vertexOf_;                     ///< number in the result of each vertex of now_
};

}  // namespace

std::shared_ptr<const Environment> diffEnvironments(const std::shared_ptr<const Environment>& before,
                                                    const std::shared_ptr<const Environment>& now,
                                                    RunContext* context) {
  if (!before || before == now || before->bothSides != now->bothSides) return now;
  Differ differ(*before, *now, context);
  return differ.match() ? differ.edited(before) : now;
}

}  // namespace footfall::detail
