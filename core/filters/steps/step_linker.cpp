// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/step_linker.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>

#include "core/base/geometry.hpp"
#include "core/mesh/lifted_vertex.hpp"
#include "core/mesh/triangle_split.hpp"

namespace footfall::detail {
namespace {

using Tree = BoxTree<3>;

constexpr Index kBordersPerTask = 64;

Tree::Bounds boundsBetween(const MeshVertex& a, const MeshVertex& b) {
  Tree::Bounds bounds;
  const auto set = [&](int k, double p, double q) {
    const double margin = std::max(a.error, b.error) + std::max(std::fabs(p), std::fabs(q)) * 0x1p-50;
    bounds.lower[k] = std::min(p, q) - margin;
    bounds.upper[k] = std::max(p, q) + margin;
  };
  set(0, a.x, b.x);
  set(1, a.y, b.y);
  set(2, a.z, b.z);
  return bounds;
}

/// A coordinate of the plan in which two vertices differ, the one in which they seem to differ most; -1 where they are
/// one point of the plan.
int axisBetween(const MeshVertex& a, const MeshVertex& b, MeshGeometry& geometry) {
  const int likely = std::fabs(a.x - b.x) >= std::fabs(a.y - b.y) ? 0 : 1;
  if (geometry.compare(a, b, likely) != 0) return likely;
  return geometry.compare(a, b, 1 - likely) != 0 ? 1 - likely : -1;
}

}  // namespace

StepLinker::StepLinker(const WalkableState& state, RunContext& context)
    : state_(state),
      kernel_(state.kernel),
      mesh_(*state.mesh),
      context_(context),
      topology_(topologyOf(state, context)),
      geometry_(std::in_place, *kernel_, mesh_.vertices) {
  findBorders();
  buildTree();
}

std::shared_ptr<const WalkableMesh> StepLinker::link(double step, double height, double gap, StepMemory* memory) {
  gap_ = gap;
  if (memory != nullptr) *memory = {state_.mesh, step, height, gap, borders_, {}};
  findStretches(step, height, gap, memory);
  return makeMesh();
}

std::shared_ptr<const WalkableMesh> StepLinker::relink(const WalkableMesh& earlier) {
  const Adjacency topology = findEdges(earlier.triangles, earlier.vertices.size(), context_);
  const auto borderOf = [&](const std::array<Index, 2>& edge) {
    const Index side = findSide(earlier.triangles, topology, edge[0], edge[1]);
    if (side < 0) throw std::logic_error("a link without its triangle");
    return Border{side, -1, edge[0], edge[1], earlier.triangles[side / 3].face};
  };
  for (const MeshLink& link : earlier.links) {
    context_.checkCancelled();
    addStretches(earlier, borderOf(link.from), borderOf(link.to), link.isGap);
  }
  return makeMesh();
}

void StepLinker::findBorders() {
  const TriangleCorners corners(mesh_.triangles);
  for (Index e = 0; e < topology_->edgeCount(); ++e) {
    const auto sides = topology_->sidesOf(e);
    if (sides.size() > 1 && !isObstacle(mesh_.triangles, sides)) continue;
    for (const Index side : sides)
      borders_.push_back({side, e, corners.beginOf(side), corners.endOf(side), mesh_.triangles[side / 3].face});
  }
}

void StepLinker::buildTree() {
  std::vector<Index> all(borders_.size());
  std::iota(all.begin(), all.end(), 0);
  tree_.build(
      all, [&](Index i) { return boundsOf(borders_[i]); }, context_);
}

BoxTree<3>::Bounds StepLinker::boundsOf(const Border& border) const {
  return boundsBetween(mesh_.vertices[border.from], mesh_.vertices[border.to]);
}

void StepLinker::findStretches(double step, double height, double gap, StepMemory* memory) {
  const auto count = static_cast<Index>(borders_.size());
  const Index stepLevel = kernel_->levelOf(step).value(), heightLevel = kernel_->levelOf(height).value();
  const int scale = kernel_->mesh().grid.scaleExponent();
  const double scaledStep = std::ldexp(step, scale), scaledHeight = std::ldexp(height, scale);
  const double scaledGap = std::ldexp(gap, scale);
  if (gap > 0) findGapBorders();
  tbb::enumerable_thread_specific<Worker> workers([&] {
    return Worker{{*kernel_, mesh_.vertices},
                  {*kernel_, state_.removed, stepLevel, heightLevel},
                  {kernel_->mesh(), state_.removed, scaledStep, scaledHeight, scaledGap},
                  {}};
  });
  tbb::parallel_for(tbb::blocked_range<Index>(0, count, kBordersPerTask), [&](const auto& range) {
    Worker& worker = workers.local();
    for (Index i = range.begin(); i != range.end(); ++i) {
      context_.checkCancelled();
      if (isKnown(i)) continue;
      Tree::Bounds query = boundsOf(borders_[i]);
      for (const int k : {0, 1, 2}) {
        query.lower[k] -= k < 2 ? scaledGap : scaledStep;
        query.upper[k] += k < 2 ? scaledGap : scaledStep;
      }
      tree_.visitOverlapping(query, [&](Index other) {
        // What is known does not look for others.
        if (other == i || (other < i && !isKnown(other))) return;
        const Index first = std::min(i, other), second = std::max(i, other);
        const std::size_t undecided = worker.conditions.undecided();
        tryPair(first, second, worker);
        worker.found.undecided.insert(worker.found.undecided.end(), worker.conditions.undecided() - undecided,
                                      {first, second});
        if (gap > 0) tryGap(first, second, worker);
      });
    }
  });
  StepFindings found = std::move(known_);
  const auto append = [](auto& all, auto& more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  for (Worker& worker : workers) {
    fallbacks_ += worker.geometry.fallbacks;
    append(found.stretches, worker.found.stretches);
    append(found.gaps, worker.found.gaps);
    append(found.undecided, worker.found.undecided);
  }
  const auto isBefore = [](const auto& a, const auto& b) {
    return std::array{a.first, a.second} < std::array{b.first, b.second};
  };
  std::stable_sort(found.stretches.begin(), found.stretches.end(), isBefore);
  std::stable_sort(found.gaps.begin(), found.gaps.end(), isBefore);
  std::sort(found.undecided.begin(), found.undecided.end());
  undecided_ = found.undecided.size();
  if (memory != nullptr) memory->found = found;
  stretches_ = std::move(found.stretches);
  gaps_ = std::move(found.gaps);
}

// What is left of the two borders of a link, which run against each other.
void StepLinker::addStretches(const WalkableMesh& earlier, const Border& from, const Border& to, bool isGap) {
  const auto remainsOf = [&](const Border& old) {
    const MeshVertex &a = earlier.vertices[old.from], &b = earlier.vertices[old.to];
    std::vector<Index> numbers;
    const Index origin = kernel_->mesh().triangles[old.face][0];
    const auto isOn = [&](Index v) {
      return kernel_->orientation(a.point, b.point, mesh_.vertices[v].point, origin, geometry_->fallbacks) == 0;
    };
    tree_.visitOverlapping(boundsBetween(a, b), [&](Index i) {
      if (borders_[i].face == old.face && isOn(borders_[i].from) && isOn(borders_[i].to)) numbers.push_back(i);
    });
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  };
  if (isGap) {
    const std::vector<Index> others = remainsOf(to);
    for (const Index first : remainsOf(from))
      for (const Index second : others) {
        const GapBorder e = gapBorderOf(borders_[first]), f = gapBorderOf(borders_[second]);
        if (const auto frame = GapConditions::frameOf(e, f)) {
          const double begin = std::max(frame->along(e.from.x, e.from.y), frame->along(f.to.x, f.to.y));
          const double finish = std::min(frame->along(e.to.x, e.to.y), frame->along(f.from.x, f.from.y));
          if (finish - begin > GapConditions::kShort) gaps_.push_back({first, second, {*frame, {begin, finish}, {}}});
        }
      }
    return;
  }
  const MeshVertex &begin = earlier.vertices[from.from], &end = earlier.vertices[from.to];
  const int axis = axisBetween(begin, end, *geometry_);
  if (axis < 0) return;
  const int direction = geometry_->compare(end, begin, axis);
  const auto order = [&](const MeshVertex& a, const MeshVertex& b) {
    return direction * geometry_->compare(a, b, axis);
  };
  const auto vertex = [&](Index v) -> const MeshVertex& { return mesh_.vertices[v]; };
  const std::vector<Index> others = remainsOf(to);
  for (const Index first : remainsOf(from)) {
    const Border& e = borders_[first];
    if (order(vertex(e.from), vertex(e.to)) >= 0) continue;
    for (const Index second : others) {
      const Border& f = borders_[second];
      if (order(vertex(f.to), vertex(f.from)) >= 0) continue;
      MeshVertex low = begin, high = end;
      for (const MeshVertex* p : {&vertex(e.from), &vertex(f.to)})
        if (order(*p, low) > 0) low = *p;
      for (const MeshVertex* p : {&vertex(e.to), &vertex(f.from)})
        if (order(*p, high) < 0) high = *p;
      if (order(low, high) < 0) stretches_.push_back({first, second, low, high});
    }
  }
}

void StepLinker::tryPair(Index first, Index second, Worker& worker) const {
  const Border &e = borders_[first], &f = borders_[second];
  MeshGeometry& geometry = worker.geometry;
  if (geometry.orientation(e.from, e.to, f.from) != 0 || geometry.orientation(e.from, e.to, f.to) != 0) return;
  SharedStretch stretch;
  stretch.faces = {e.face, f.face};
  stretch.axis = axisBetween(mesh_.vertices[e.from], mesh_.vertices[e.to], geometry);
  if (stretch.axis < 0) return;
  const auto compare = [&](Index a, Index b) { return geometry.compare(a, b, stretch.axis); };
  stretch.direction = compare(e.to, e.from);
  if (compare(f.to, f.from) != -stretch.direction) return;  // walkable sides on the same side
  const Index begin = stretch.direction * compare(e.from, f.to) >= 0 ? e.from : f.to;
  const Index end = stretch.direction * compare(e.to, f.from) <= 0 ? e.to : f.from;
  if (stretch.direction * compare(begin, end) >= 0) return;
  stretch.begin = mesh_.vertices[begin];
  stretch.end = mesh_.vertices[end];
  const auto lines = [&] {
    std::vector<KnownLine> known = linesOf(e, geometry);
    const std::vector<KnownLine> others = linesOf(f, geometry);
    known.insert(known.end(), others.begin(), others.end());
    return known;
  };
  const Tree::Bounds own = boundsOf(e), other = boundsOf(f);
  for (int k = 0; k < 3; ++k) {
    stretch.box.lower[k] = k < 2 ? std::max(own.lower[k], other.lower[k]) : std::min(own.lower[k], other.lower[k]);
    stretch.box.upper[k] = k < 2 ? std::min(own.upper[k], other.upper[k]) : std::max(own.upper[k], other.upper[k]);
  }
  for (const auto& [from, to] : worker.conditions.find(stretch, lines, geometry))
    worker.found.stretches.push_back({first, second, from, to});
}

// What its vertices were made of, and the edges of its triangle's face.
std::vector<KnownLine> StepLinker::ownLinesOf(const Border& border, MeshGeometry& geometry) const {
  const SourceMesh& source = kernel_->mesh();
  const PlanPoint &a = mesh_.vertices[border.from].point, &b = mesh_.vertices[border.to].point;
  std::vector<KnownLine> lines;
  const auto edgeLine = [&](Index u, Index v) {
    return PlanLine{PlanLine::Edge, std::min(source.planIds[u], source.planIds[v]),
                    std::max(source.planIds[u], source.planIds[v])};
  };
  const auto tryLine = [&](const PlanLine& line, Index face) {
    const Index origin = source.triangles[border.face][0];
    const auto isOn = [&](const PlanPoint& p) { return kernel_->side(line, face, p, origin, geometry.fallbacks) == 0; };
    if (isOn(a) && isOn(b)) lines.push_back({line, face});
  };
  if (a.kind() == PlanPoint::Source && b.kind() == PlanPoint::Source) {
    lines.push_back({edgeLine(a.planId(), b.planId()), -1});
    return lines;
  }
  for (const PlanPoint* p : {&a, &b}) {
    if (p->kind() == PlanPoint::EdgePlane) tryLine(edgeLine(p->edgeBegin(), p->edgeEnd()), -1);
    if (p->kind() != PlanPoint::Crossing) continue;
    for (const PlanLine& line : {p->firstLine(), p->secondLine()})
      tryLine(line, line.kind == PlanLine::Trace ? p->face() : -1);
  }
  const auto& f = source.triangles[border.face];
  for (int k = 0; k < 3; ++k) tryLine(edgeLine(f[k], f[next(k)]), -1);
  return lines;
}

std::vector<KnownLine> StepLinker::linesOf(const Border& border, MeshGeometry& geometry) const {
  std::vector<KnownLine> lines = ownLinesOf(border, geometry);
  if (!lines.empty() || !state_.cuts) return lines;
  const PlanPoint &a = mesh_.vertices[border.from].point, &b = mesh_.vertices[border.to].point;
  const Index origin = kernel_->mesh().triangles[border.face][0];
  for (const PlanLine& line : (*state_.cuts)[border.face].lines) {
    const Index face = line.kind == PlanLine::Trace ? border.face : -1;
    const auto isOn = [&](const PlanPoint& p) { return kernel_->side(line, face, p, origin, geometry.fallbacks) == 0; };
    if (isOn(a) && isOn(b)) lines.push_back({line, face});
  }
  return lines;
}

bool StepLinker::insertSplit(Index edge, const MeshVertex& place) {
  const Index side = topology_->sidesOf(edge)[0];
  const TriangleCorners corners(mesh_.triangles);
  const MeshVertex &from = mesh_.vertices[corners.beginOf(side)], &to = mesh_.vertices[corners.endOf(side)];
  const int axis = axisBetween(from, to, *geometry_), direction = geometry_->compare(to, from, axis);
  const auto order = [&](const MeshVertex& a, const MeshVertex& b) {
    return direction * geometry_->compare(a, b, axis);
  };
  if (order(place, from) <= 0 || order(place, to) >= 0) return false;
  std::vector<MeshVertex>& splits = splits_[edge];
  const auto at = std::find_if(splits.begin(), splits.end(), [&](const MeshVertex& s) { return order(place, s) <= 0; });
  if (at != splits.end() && order(place, *at) == 0) return false;
  splits.insert(at, place);
  return true;
}

std::vector<MeshVertex> StepLinker::splitsBetween(Index edge, const MeshVertex& a, const MeshVertex& b) {
  std::vector<MeshVertex> between;
  const auto found = splits_.find(edge);
  if (found == splits_.end()) return between;
  const int axis = axisBetween(a, b, *geometry_), direction = geometry_->compare(b, a, axis);
  for (const MeshVertex& s : found->second)
    if (direction * geometry_->compare(s, a, axis) > 0 && direction * geometry_->compare(s, b, axis) < 0)
      between.push_back(s);
  return between;
}

// Both borders of a stretch end with it, and get all vertices that either has inside it, until nothing changes. No
// place comes in that was not there: so it ends.
void StepLinker::splitAtSteps() {
  for (const Stretch& s : stretches_)
    for (const Index border : {s.first, s.second})
      for (const MeshVertex* end : {&s.begin, &s.end}) insertSplit(borders_[border].edge, *end);
  for (bool isChanged = true; isChanged;) {
    isChanged = false;
    context_.checkCancelled();
    for (const Stretch& s : stretches_) {
      const Index first = borders_[s.first].edge, second = borders_[s.second].edge;
      if (first == second) continue;
      for (const auto& [own, other] : {std::array{first, second}, std::array{second, first}})
        for (const MeshVertex& split : splitsBetween(own, s.begin, s.end))
          isChanged = insertSplit(other, split) || isChanged;
    }
  }
}

void StepLinker::splitEdges() {
  splitAtSteps();
  if (!gaps_.empty()) splitAtGaps();
}

std::shared_ptr<const WalkableMesh> StepLinker::makeMesh() {
  splitEdges();
  context_.checkCancelled();
  auto result = std::make_shared<WalkableMesh>();
  result->layerCount = mesh_.layerCount;
  result->vertices = mesh_.vertices;
  // New vertices of each edge, in the direction of its first side and in the other one.
  std::vector<Index> edges;
  for (const auto& [edge, places] : splits_) edges.push_back(edge);
  std::sort(edges.begin(), edges.end());
  std::unordered_map<Index, std::array<std::vector<Index>, 2>> inside;
  std::vector<EdgeVertices> on;  // of triangles that are split
  std::vector<Index> slotOf(mesh_.triangles.size(), -1);
  const TriangleCorners corners(mesh_.triangles);
  for (const Index edge : edges) {
    const auto sides = topology_->sidesOf(edge);
    auto& [forward, backward] = inside[edge];
    for (const MeshVertex& place : splits_[edge]) {
      forward.push_back(static_cast<Index>(result->vertices.size()));
      result->vertices.push_back(liftedVertex(*kernel_, mesh_.triangles[sides[0] / 3].face, place.point));
    }
    backward.assign(forward.rbegin(), forward.rend());
    for (const Index side : sides) {
      Index& slot = slotOf[side / 3];
      if (slot < 0) {
        slot = static_cast<Index>(on.size());
        on.emplace_back();
      }
      on[slot][side % 3] = corners.beginOf(side) == corners.beginOf(sides[0]) ? &forward : &backward;
    }
  }
  result->triangles.reserve(mesh_.triangles.size() + 2 * edges.size());
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (slotOf[t] < 0)
      result->triangles.push_back(mesh_.triangles[t]);
    else
      splitTriangle(mesh_.triangles[t], on[slotOf[t]], result->triangles);
    if (!mesh_.layers.empty()) result->layers.resize(result->triangles.size(), mesh_.layers[t]);
  }

  const auto verticesOf = [&](const Border& border) {
    std::vector<Index> chain{border.from};
    if (const auto found = inside.find(border.edge); found != inside.end()) {
      const bool isForward = border.from == corners.beginOf(topology_->sidesOf(border.edge)[0]);
      const std::vector<Index>& between = found->second[isForward ? 0 : 1];
      chain.insert(chain.end(), between.begin(), between.end());
    }
    chain.push_back(border.to);
    return chain;
  };
  // Those from one place to another, in the border's own direction.
  const auto chainOf = [&](const Border& border, const MeshVertex& a, const MeshVertex& b) {
    std::vector<Index> chain = verticesOf(border);
    const int axis = axisBetween(a, b, *geometry_), direction = geometry_->compare(b, a, axis);
    std::erase_if(chain, [&](Index v) {
      const MeshVertex& p = result->vertices[v];
      return direction * geometry_->compare(p, a, axis) < 0 || direction * geometry_->compare(p, b, axis) > 0;
    });
    return chain;
  };
  for (const Stretch& s : stretches_) {
    const std::vector<Index> from = chainOf(borders_[s.first], s.begin, s.end);
    const std::vector<Index> to = chainOf(borders_[s.second], s.end, s.begin);
    for (std::size_t i = 0; i + 1 < from.size(); ++i) {
      const std::size_t j = to.size() - 1 - i;
      MeshLink link{{from[i], from[i + 1]}, {to[j - 1], to[j]}};
      if (link.to < link.from) std::swap(link.from, link.to);
      result->links.push_back(link);
    }
  }
  for (const GapStretch& gap : gaps_) {
    context_.checkCancelled();
    if (!gap.isDropped) addGapLinks(*result, gap, verticesOf(borders_[gap.first]), verticesOf(borders_[gap.second]));
  }
  std::sort(result->links.begin(), result->links.end());
  result->links.erase(std::unique(result->links.begin(), result->links.end()), result->links.end());
  fallbacks_ += geometry_->fallbacks;
  return result;
}

}  // namespace footfall::detail
