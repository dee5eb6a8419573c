// Finds the floors of each cell, and the number of triangles that matter to them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/partitioning/partition_builder.hpp"

namespace footfall::detail {
namespace {

// A chunk has a counter for each cell, so there are few.
constexpr std::size_t kMostChunks = 16;
constexpr std::size_t kSmallestChunk = 4096;
constexpr std::size_t kVisitsPerPoll = 4096;  ///< visits of triangles and of the cells that they have a part in

struct HeightRange {
  double lower = CellBounds::kInfinity;
  double upper = -CellBounds::kInfinity;

  void include(double low, double high) {
    lower = std::min(lower, low);
    upper = std::max(upper, high);
  }
};

HeightRange heightsOf(const SourceMesh& mesh, Index triangle) {
  const auto& f = mesh.triangles[triangle];
  const double a = mesh.vertices[f[0]].z, b = mesh.vertices[f[1]].z, c = mesh.vertices[f[2]].z;
  return {std::min({a, b, c}), std::max({a, b, c})};
}

// The findings of one chunk of the triangles. Joined, they do not depend on where chunks begin.
struct Chunk {
  std::vector<std::pair<Index, Index>> listed;  // cell and floor, floors ascending
  std::vector<std::uint32_t> floors;            // floors of each cell
  std::vector<std::uint64_t> obstacles;         // number of obstacles of each cell
  std::vector<HeightRange> heights;             // heights of each cell's floors
};

class FloorAssignment {
 public:
  FloorAssignment(Partition& partition, const StrategyInput& input)
      : partition_(partition), input_(input), mesh_(input.mesh) {
    const std::size_t count = std::clamp<std::size_t>(mesh_.triangles.size() / kSmallestChunk, 1, kMostChunks);
    chunks_.resize(count);
    hasHeights_ = std::any_of(partition.nodes.begin(), partition.nodes.end(),
                              [](const Partition::Node& node) { return node.axis == 2; });
  }

  CellFloors run() {
    result_.cellCount.assign(mesh_.triangles.size(), 0);
    forChunks([&](Chunk& chunk, std::size_t first, std::size_t last) { listFloors(chunk, first, last); });
    makeLists();
    if (hasHeights_) findHeights();
    forChunks([&](Chunk& chunk, std::size_t first, std::size_t last) { countObstacles(chunk, first, last); });
    for (const Chunk& chunk : chunks_)
      for (std::size_t c = 0; c < partition_.cells.size(); ++c) partition_.cells[c].obstacles += chunk.obstacles[c];
    return std::move(result_);
  }

 private:
  template <class Body>
  void forChunks(const Body& body) {
    const std::size_t triangles = mesh_.triangles.size();
    forRanges(chunks_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        body(chunks_[i], triangles * i / chunks_.size(), triangles * (i + 1) / chunks_.size());
    });
  }

  void listFloors(Chunk& chunk, std::size_t first, std::size_t last) {
    chunk.floors.assign(partition_.cells.size(), 0);
    if (hasHeights_) chunk.heights.assign(partition_.cells.size(), {});
    std::vector<Index> touched;
    std::size_t visits = 0;
    for (std::size_t t = first; t < last; ++t) {
      if (++visits >= kVisitsPerPoll) visits = 0, input_.poll();
      if (input_.walkable[t] == 0) continue;
      const auto floor = static_cast<Index>(t);
      const PlanBox box = planBoxOf(mesh_, floor);
      const HeightRange heights = heightsOf(mesh_, floor);
      touched.clear();
      partition_.visitCells(box.lower, box.upper, heights.lower, [&](Index cell) { touched.push_back(cell); });
      visits += touched.size();
      Index count = 0;
      for (const Index cell : touched) {
        if (touched.size() > 1 && isOutside(floor, box, partition_.cells[cell].bounds)) continue;
        chunk.listed.emplace_back(cell, floor);
        ++chunk.floors[cell];
        if (hasHeights_) chunk.heights[cell].include(heights.lower, heights.upper);
        ++count;
      }
      result_.cellCount[t] = count;
    }
  }

  // True when an edge certainly has the whole cell on its outer side; the sides of the cell are known to overlap the
  // triangle's box. Uncertain is inside. Beyond the triangle's box it does not matter where the cell ends.
  [[nodiscard]] bool isOutside(Index floor, const PlanBox& box, const CellBounds& bounds) const {
    const int facing = mesh_.facing[floor];
    if (facing == 0) return false;
    const std::array<double, 2> lower{std::max(bounds.lower[0], box.lower[0]), std::max(bounds.lower[1], box.lower[1])};
    const std::array<double, 2> upper{std::min(bounds.upper[0], box.upper[0]), std::min(bounds.upper[1], box.upper[1])};
    const auto& f = mesh_.triangles[floor];
    for (int k = 0; k < 3; ++k) {
      const Vec3& a = mesh_.vertices[f[facing > 0 ? k : (k + 1) % 3]];
      const Vec3& b = mesh_.vertices[f[facing > 0 ? (k + 1) % 3 : k]];
      // The corner that lies farthest to the left of the edge. Signs of differences are exact.
      const double x = b.y < a.y ? upper[0] : lower[0], y = b.x > a.x ? upper[1] : lower[1];
      // Not more than underflow can do to a product, and nothing beside any that matters.
      constexpr double kUnderflow = 0x1p-1000;
      if (filteredArea(b.x - a.x, b.y - a.y, x - a.x, y - a.y, kUnderflow) == -1) return true;
    }
    return false;
  }

  // Lists of all chunks one after another, cell by cell.
  void makeLists() {
    const std::size_t cells = partition_.cells.size();
    result_.first.assign(cells + 1, 0);
    std::size_t place = 0;
    for (std::size_t c = 0; c < cells; ++c) {
      result_.first[c] = place;
      for (const Chunk& chunk : chunks_) place += chunk.floors[c];
      partition_.cells[c].floors = place - result_.first[c];
      partition_.cells[c].obstacles = 0;
    }
    result_.first[cells] = place;
    result_.floors.resize(place);
    std::vector<std::size_t> next(result_.first.begin(), result_.first.end() - 1);
    for (Chunk& chunk : chunks_) {
      for (const auto& [cell, floor] : chunk.listed) result_.floors[next[cell]++] = floor;
      chunk.listed = {};
    }
  }

  void findHeights() {
    heights_.assign(partition_.cells.size(), {});
    for (const Chunk& chunk : chunks_)
      for (std::size_t c = 0; c < heights_.size(); ++c)
        heights_[c].include(chunk.heights[c].lower, chunk.heights[c].upper);
    for (std::size_t c = 0; c < heights_.size(); ++c) {
      const CellBounds& bounds = partition_.cells[c].bounds;
      if (std::isinf(bounds.lower[2]) && std::isinf(bounds.upper[2]))
        heights_[c] = {-CellBounds::kInfinity, CellBounds::kInfinity};
      else
        heights_[c].upper += input_.clearance;
    }
  }

  void countObstacles(Chunk& chunk, std::size_t first, std::size_t last) {
    chunk.obstacles.assign(partition_.cells.size(), 0);
    std::size_t visits = 0;
    for (std::size_t t = first; t < last; ++t) {
      if (++visits >= kVisitsPerPoll) visits = 0, input_.poll();
      if (input_.removed[t] != 0) continue;
      const PlanBox box = planBoxOf(mesh_, static_cast<Index>(t));
      const HeightRange heights = hasHeights_ ? heightsOf(mesh_, static_cast<Index>(t)) : HeightRange{0, 0};
      partition_.visitCells(box.lower, box.upper, -CellBounds::kInfinity, CellBounds::kInfinity, [&](Index cell) {
        ++visits;
        if (hasHeights_ && (heights.upper < heights_[cell].lower || heights.lower > heights_[cell].upper)) return;
        ++chunk.obstacles[cell];
      });
    }
  }

  Partition& partition_;
  const StrategyInput& input_;
  const SourceMesh& mesh_;
  bool hasHeights_ = false;
  std::vector<Chunk> chunks_;
  std::vector<HeightRange> heights_;
  CellFloors result_;
};

}  // namespace

CellFloors assignFloors(Partition& partition, const StrategyInput& input) {
  return FloorAssignment(partition, input).run();
}

}  // namespace footfall::detail
