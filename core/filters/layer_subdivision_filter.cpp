// LayerSubdivisionFilter (the thesis's PEELFilter): splits the walkable triangles into layers that do not overlap in
// the plan, with few connections (design section 2, thesis 3.2). SPDX-License-Identifier: GPL-3.0-or-later
//
// The minimum number of connections is NP-hard to find (Hillebrand et al. 2016). Here: pieces grow from the lowest
// triangle upwards (their height heuristic), taking what overlaps nothing in the piece; neighbouring pieces that do not
// overlap are merged; a local search moves triangles across the cuts while that saves connections; and the pieces are
// put into as few layers as a greedy pass finds.
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <queue>
#include <string>

#include "core/filters/filter_registry.hpp"
#include "core/filters/mesh_assembly.hpp"
#include "core/filters/mesh_geometry.hpp"
#include "core/filters/mesh_topology.hpp"

namespace footfall {
namespace {

constexpr Index kNone = -1;

class LayerSubdivision {
 public:
  LayerSubdivision(const PlanKernel& kernel, const WalkableMesh& mesh, RunContext& context)
      : kernel_(kernel), mesh_(mesh), context_(context), count_(static_cast<Index>(mesh.triangles.size())) {}

  std::vector<std::uint32_t> run() {
    findNeighbors();
    context_.checkCancelled();
    findOverlaps();
    growPieces();
    for (bool changed = true; changed;) changed = mergePieces() || moveTriangles();
    return colourPieces();
  }

  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }

 private:
  /// The lowest corner decides the order of growth; ties by number, so that the result is fixed.
  [[nodiscard]] double lowest(Index t) const {
    const auto& c = mesh_.triangles[t].corners;
    return std::min({mesh_.vertices[c[0]].z, mesh_.vertices[c[1]].z, mesh_.vertices[c[2]].z});
  }

  void findNeighbors() {
    neighbors_.resize(count_);
    const MeshTopology topology = findEdges(mesh_.triangles, mesh_.vertices.size());
    for (Index e = 0; e < topology.edgeCount(); ++e) {
      const auto sides = topology.sidesOf(e);
      if (isObstacle(mesh_.triangles, sides)) continue;
      for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
          const Index s = sides[i] / 3, t = sides[j] / 3;
          neighbors_[s].push_back(t);
          neighbors_[t].push_back(s);
        }
    }
  }

  // All pairs of triangles whose insides overlap in the plan, exactly.
  void findOverlaps() {
    std::vector<Box> boxes(count_);
    std::vector<std::int32_t> ids(count_);
    for (Index t = 0; t < count_; ++t) {
      Box& box = boxes[t];
      box.lower = {1, 1, 0};
      box.upper = {-1, -1, 0};
      for (int k = 0; k < 3; ++k) {
        const MeshVertex& v = mesh_.vertices[mesh_.triangles[t].corners[k]];
        const double r = v.error;
        box.lower[0] = k == 0 ? v.x - r : std::min(box.lower[0], v.x - r);
        box.lower[1] = k == 0 ? v.y - r : std::min(box.lower[1], v.y - r);
        box.upper[0] = k == 0 ? v.x + r : std::max(box.upper[0], v.x + r);
        box.upper[1] = k == 0 ? v.y + r : std::max(box.upper[1], v.y + r);
      }
      ids[t] = t;
    }
    TriangleTree tree;
    const std::vector<Box> queries = boxes;
    tree.build(std::move(boxes), std::move(ids), [this] { context_.checkCancelled(); });
    overlaps_.resize(count_);
    struct Local {
      explicit Local(const PlanKernel& kernel, const std::vector<MeshVertex>& vertices) : geometry(kernel, vertices) {}
      MeshGeometry geometry;
      std::vector<std::int32_t> stack;
    };
    tbb::enumerable_thread_specific<Local> locals([&] { return Local(kernel_, mesh_.vertices); });
    tbb::parallel_for(tbb::blocked_range<Index>(0, count_, 64), [&](const auto& range) {
      Local& local = locals.local();
      for (Index t = range.begin(); t != range.end(); ++t) {
        context_.checkCancelled();
        tree.visitOverlapping(queries[t], local.stack, [&](std::int32_t o) {
          if (o < t && !shareEdge(t, o) && local.geometry.overlap(mesh_.triangles[t], mesh_.triangles[o]))
            overlaps_[t].push_back(o);
          return true;
        });
        std::sort(overlaps_[t].begin(), overlaps_[t].end());
      }
    });
    for (const Local& local : locals) fallbacks_ += local.geometry.fallbacks;
    for (Index t = 0; t < count_; ++t) {
      const std::size_t own = overlaps_[t].size();
      for (std::size_t i = 0; i < own; ++i)
        if (overlaps_[t][i] < t) overlaps_[overlaps_[t][i]].push_back(t);
    }
  }

  /// Triangles on either side of an edge do not overlap; a test by numbers saves the exact one.
  [[nodiscard]] bool shareEdge(Index s, Index t) const {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (mesh_.triangles[s].corners[i] == mesh_.triangles[t].corners[(j + 1) % 3] &&
            mesh_.triangles[s].corners[(i + 1) % 3] == mesh_.triangles[t].corners[j])
          return true;
    return false;
  }

  void growPieces() {
    piece_.assign(count_, kNone);
    std::vector<Index> order(count_), blockedFor(count_, kNone);
    for (Index t = 0; t < count_; ++t) order[t] = t;
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return lowest(a) != lowest(b) ? lowest(a) < lowest(b) : a < b; });
    using Candidate = std::pair<double, Index>;
    for (const Index seed : order) {
      if (piece_[seed] != kNone) continue;
      context_.checkCancelled();
      const Index piece = pieceCount_++;
      std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> front;
      front.emplace(lowest(seed), seed);
      while (!front.empty()) {
        const Index t = front.top().second;
        front.pop();
        if (piece_[t] != kNone || blockedFor[t] == piece) continue;
        piece_[t] = piece;
        for (const Index o : overlaps_[t]) blockedFor[o] = piece;
        for (const Index n : neighbors_[t])
          if (piece_[n] == kNone && blockedFor[n] != piece) front.emplace(lowest(n), n);
      }
    }
  }

  // Unites neighbouring pieces that overlap nowhere, most connections first.
  bool mergePieces() {
    std::map<std::pair<Index, Index>, int> cuts;
    std::vector<std::pair<Index, Index>> conflicts;
    for (Index t = 0; t < count_; ++t) {
      for (const Index n : neighbors_[t])
        if (piece_[n] > piece_[t]) ++cuts[{piece_[t], piece_[n]}];
      for (const Index o : overlaps_[t])
        if (piece_[o] > piece_[t]) conflicts.emplace_back(piece_[t], piece_[o]);
    }
    std::sort(conflicts.begin(), conflicts.end());
    const std::pair<Index, Index>* best = nullptr;
    int most = 0;
    for (const auto& [pair, size] : cuts)
      if (size > most && !std::binary_search(conflicts.begin(), conflicts.end(), pair)) {
        best = &pair;
        most = size;
      }
    if (best == nullptr) return false;
    const auto [into, from] = *best;
    for (Index& p : piece_)
      if (p == from) p = into;
    return true;
  }

  // Moves single triangles to a neighbouring piece while that saves connections.
  bool moveTriangles() {
    bool changed = false;
    std::vector<Index> queue;
    for (Index t = 0; t < count_; ++t) queue.push_back(t);
    for (std::size_t head = 0; head < queue.size(); ++head) {
      if ((head & 1023) == 0) context_.checkCancelled();
      const Index t = queue[head];
      const auto links = [&](Index piece) {
        return std::count_if(neighbors_[t].begin(), neighbors_[t].end(), [&](Index n) { return piece_[n] == piece; });
      };
      const auto own = links(piece_[t]);
      Index target = kNone;
      auto gain = own;
      for (const Index n : neighbors_[t]) {
        const Index p = piece_[n];
        if (p == piece_[t] || links(p) <= gain) continue;
        if (std::any_of(overlaps_[t].begin(), overlaps_[t].end(), [&](Index o) { return piece_[o] == p; })) continue;
        target = p;
        gain = links(p);
      }
      if (target == kNone) continue;
      piece_[t] = target;
      changed = true;
      queue.insert(queue.end(), neighbors_[t].begin(), neighbors_[t].end());
    }
    return changed;
  }

  // Each piece, lowest first, goes to the layer without overlap with which it shares most edges, else the first one.
  std::vector<std::uint32_t> colourPieces() {
    std::vector<std::vector<Index>> members(pieceCount_);
    for (Index t = 0; t < count_; ++t) members[piece_[t]].push_back(t);
    std::vector<Index> order;
    for (Index p = 0; p < pieceCount_; ++p)
      if (!members[p].empty()) order.push_back(p);
    std::vector<std::uint32_t> layer(count_, 0);
    std::vector<char> placed(count_, 0);
    std::uint32_t layers = 0;
    std::vector<char> blocked;
    std::vector<int> shared;
    for (const Index p : order) {
      context_.checkCancelled();
      blocked.assign(layers, 0);
      shared.assign(layers, 0);
      for (const Index t : members[p]) {
        for (const Index o : overlaps_[t])
          if (placed[o] != 0) blocked[layer[o]] = 1;
        for (const Index n : neighbors_[t])
          if (placed[n] != 0) ++shared[layer[n]];
      }
      std::uint32_t best = layers;
      for (std::uint32_t l = 0; l < layers; ++l)
        if (blocked[l] == 0 && (best == layers || shared[l] > shared[best])) best = l;
      if (best == layers) ++layers;
      for (const Index t : members[p]) {
        layer[t] = best;
        placed[t] = 1;
      }
    }
    return layer;
  }

  const PlanKernel& kernel_;
  const WalkableMesh& mesh_;
  RunContext& context_;
  Index count_;
  std::vector<std::vector<Index>> neighbors_;
  std::vector<std::vector<Index>> overlaps_;
  std::vector<Index> piece_;
  Index pieceCount_ = 0;
  ExactFallbacks fallbacks_;
};

}  // namespace

FilterOutcome applyLayerSubdivision(const StatePtr& given, RunContext& context) {
  FilterOutcome outcome;
  const StatePtr state = withMesh(given, context, outcome.fallbacks);
  LayerSubdivision subdivision(*state->kernel, *state->mesh, context);
  auto mesh = std::make_shared<WalkableMesh>(*state->mesh);
  mesh->layers = subdivision.run();
  mesh->layerCount = 0;
  for (const std::uint32_t l : mesh->layers) mesh->layerCount = std::max(mesh->layerCount, l + 1);
  outcome.fallbacks += subdivision.fallbacks();

  outcome.note =
      std::to_string(mesh->layerCount) + " layers, " + std::to_string(countConnections(*mesh,findEdges(mesh->triangles, mesh->vertices.size()))) + " connections";
  auto result = std::make_shared<WalkableState>(*state);
  result->mesh = std::move(mesh);
  outcome.state = std::move(result);
  return outcome;
}

}  // namespace footfall
