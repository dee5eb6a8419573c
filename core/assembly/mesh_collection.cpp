// The part of MeshJoiner that collects the parts of all faces.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles, outlines and points have their places by the faces' order. Vertices are numbered by their first use. All
// is done by all threads, for ranges of points or triangles, since a single face can have most of them.

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <limits>
#include <mutex>
#include <numeric>

#include "core/assembly/mesh_joiner.hpp"
#include "core/base/index_and_box.hpp"
#include "core/base/numbered_table.hpp"
#include "core/base/parallel.hpp"
#include "core/mesh/lifted_vertex.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kFacesPerTask = 512;
constexpr std::size_t kPointsPerTask = 1024;
constexpr std::size_t kTrianglesPerTask = 1024;
constexpr std::size_t kPointsPerBlock = 2048;
constexpr Index kLastPlace = std::numeric_limits<Index>::max();

// The kind of a used point that is no source vertex. The last three are crossings on the face's own edges 0, 1, 2.
constexpr Index kOnSourceEdge = -1, kOfOneFace = -2, kUnused = -3, kCrossingOnEdge = -4;

template <class Work>
void forBlocks(std::size_t count, std::size_t size, RunContext& context, const Work& work) {
  forRanges((count + size - 1) / size, 1, [&](std::size_t block, std::size_t) {
    context.checkCancelled();
    work(block, block * size, std::min((block + 1) * size, count));
  });
}

}  // namespace

/// A point that has the same name in all faces at a source edge; for most points the name identifies the edge.
struct MeshJoiner::SharedPoint {
  PlanPoint point;
  Index from = -1, to = -1;  ///< source vertices of the edge of a crossing
  bool operator==(const SharedPoint&) const = default;
};

struct MeshJoiner::SharedUse {
  SharedPoint point;
  Index place = -1;
};

/// Uses of the points of some faces: those of one point are in one of the lists, whatever the face.
struct MeshJoiner::SharedUses {
  static constexpr std::size_t kLists = 16;
  std::vector<SharedUse> uses;
  std::array<std::size_t, kLists + 1> first{};  ///< start of each list, and the end

  static std::size_t listOf(const SharedUse& use) {
    return NumberedTable<SharedPoint>::hashOf(use.point) >> 20 & (kLists - 1);
  }
  explicit SharedUses(const std::vector<SharedUse>& given) : uses(given.size()) {
    for (const SharedUse& use : given) ++first[listOf(use) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    auto next = first;
    for (const SharedUse& use : given) uses[next[listOf(use)]++] = use;
  }
  [[nodiscard]] std::span<const SharedUse> list(std::size_t i) const {
    return {uses.data() + first[i], first[i + 1] - first[i]};
  }
};

struct MeshJoiner::Additions {
  std::span<const FaceToJoin> faces;
  std::size_t pointCount = 0, triangleCount = 0, outlineCount = 0;
  /// The number of outlines before the face of each block's first triangle.
  std::vector<Index> outlinesBefore;
  /// The points of each face in the order of their first use, from where its points begin; then -1 for those without.
  std::vector<Index> pointOf;
  std::vector<Index> names;  ///< name of each use: a source vertex, or the kind of the point
  /// The first use of the same vertex, of each use; once that one has a number, -1 - number.
  UnfilledArray<Index> firstUse;
  std::vector<std::atomic<Index>> firstUseOfSource;  ///< first use of each source vertex, subtracted from kLastPlace;
                                                     ///< 0: none
  std::vector<SharedUses> shared;
  UnfilledArray<Index> firstUseOf;  ///< place of the point of each vertex

  void noteSource(Index source, Index place) {
    std::atomic<Index>& known = firstUseOfSource[source];
    Index before = known.load(std::memory_order_relaxed);
    while (before < kLastPlace - place &&
           !known.compare_exchange_weak(before, kLastPlace - place, std::memory_order_relaxed))
      continue;
  }
  [[nodiscard]] Index firstOfSource(Index source) const {
    return kLastPlace - firstUseOfSource[source].load(std::memory_order_relaxed);
  }
};

// Places for the points and triangles of the faces.
void MeshJoiner::layOut(Additions& additions, RunContext& context) {
  const auto& faces = additions.faces;
  auto& entries = memory_.entries;
  entries.resize(faces.size() + 1);
  firstTriangle_.resize(faces.size() + 1);
  forBlocks(faces.size(), kFacesPerTask, context, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const FaceMesh* parts = faces[i].parts;
      entries[i] = {faces[i].face, parts != nullptr ? static_cast<Index>(parts->points.size()) : 3, 0};
      firstTriangle_[i] = parts != nullptr ? static_cast<Index>(parts->facets.size()) : 1;
    }
  });
  Index points = 0, triangles = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    points += std::exchange(entries[i].firstPoint, points);
    triangles += std::exchange(firstTriangle_[i], triangles);
  }
  entries.back().firstPoint = points;
  firstTriangle_.back() = triangles;
  additions.pointCount = static_cast<std::size_t>(points);
  additions.triangleCount = static_cast<std::size_t>(triangles);
}

// The points that a face uses, in that order, and places for its outlines.
Index MeshJoiner::listUses(std::size_t entry, Additions& additions) {
  const auto& entries = memory_.entries;
  const FaceMesh* parts = additions.faces[entry].parts;
  Index* use = additions.pointOf.data() + entries[entry].firstPoint;
  Index triangle = firstTriangle_[entry];
  const auto noteOutlines = [&](Index count) {
    if (triangle % kTrianglesPerTask == 0) additions.outlinesBefore[triangle / kTrianglesPerTask] = count;
    ++triangle;
  };
  if (parts == nullptr) {
    for (Index k = 0; k < 3; ++k) *use++ = k;
    noteOutlines(0);
    return 0;
  }
  Index* const seen = memory_.vertexOf.data() + entries[entry].firstPoint;
  Index outlines = 0;
  for (const FaceMesh::Facet& facet : parts->facets) {
    for (const Index p : facet.corners)
      if (std::exchange(seen[p], 0) < 0) *use++ = p;
    noteOutlines(outlines);
    outlines += std::popcount(facet.outlineEdges);
  }
  std::fill(use, additions.pointOf.data() + entries[entry + 1].firstPoint, -1);
  return outlines;
}

MeshJoiner::SharedPoint MeshJoiner::sharedPoint(const FaceToJoin& given, Index point, Index name) const {
  SharedPoint shared{given.parts->points[point]};
  if (name <= kCrossingOnEdge) {
    const auto& f = mesh_.triangles[given.face];
    const int k = kCrossingOnEdge - name;
    shared.from = std::min(f[k], f[next(k)]);
    shared.to = std::max(f[k], f[next(k)]);
  }
  return shared;
}

// Classifies a face's points: source vertices, points on source edges, which faces may share, and all others.
void MeshJoiner::nameUses(std::size_t entry, Index first, Index last, Additions& additions,
                          std::vector<SharedUse>& shared, ExactFallbacks& fallbacks) const {
  const FaceToJoin& given = additions.faces[entry];
  const auto& f = mesh_.triangles[given.face];
  const auto isCorner = [&](Index v) { return f[0] == v || f[1] == v || f[2] == v; };
  const auto nameOf = [&](Index p) {
    if (p < 0) return kUnused;
    if (p < 3) return f[p];
    const PlanPoint& point = given.parts->points[p];
    if (point.kind() == PlanPoint::Source) {
      // an obstacle's vertex seen from above: it may itself lie on the floor
      for (Index v = point.planId(); v < static_cast<Index>(mesh_.planIds.size()) && mesh_.planIds[v] == point.planId();
           ++v)
        if (kernel_.heightSign(given.face, v, 0, fallbacks) == 0) return v;
    }
    if (point.kind() == PlanPoint::Crossing) {
      for (int k = 0; k < 3 && point.face() < 0; ++k) {
        const Index a = mesh_.planIds[f[k]], b = mesh_.planIds[f[next(k)]];
        const PlanLine edge{PlanLine::Edge, std::min(a, b), std::max(a, b)};
        if (point.firstLine() == edge || point.secondLine() == edge) return kCrossingOnEdge - k;
      }
      return kOfOneFace;
    }
    const bool isOnSourceEdge =
        point.kind() == PlanPoint::EdgePlane && ((isCorner(point.edgeBegin()) && isCorner(point.edgeEnd())) ||
                                                 (point.triangle() == given.face && point.level() == 0));
    return isOnSourceEdge ? kOnSourceEdge : kOfOneFace;
  };
  for (Index place = first; place < last; ++place) {
    const Index name = additions.names[place] = nameOf(additions.pointOf[place]);
    if (name >= 0)
      additions.noteSource(name, place);
    else if (name == kOfOneFace)
      additions.firstUse.fill(place, place);
    else if (name != kUnused)
      shared.push_back({sharedPoint(given, additions.pointOf[place], name), place});
  }
}

void MeshJoiner::listAllUses(Additions& additions, RunContext& context) {
  memory_.vertexOf.assign(additions.pointCount, -1);
  additions.pointOf.resize(additions.pointCount);
  additions.names.resize(additions.pointCount);
  additions.outlinesBefore.resize(additions.triangleCount / kTrianglesPerTask + 1);
  additions.firstUse = UnfilledArray<Index>(additions.pointCount);
  additions.firstUseOfSource = std::vector<std::atomic<Index>>(mesh_.vertices.size());
  auto& entries = memory_.entries;
  const std::size_t count = additions.faces.size();
  PerThread<ExactFallbacks> fallbacks;
  std::vector<Index> large;  // a face can have most of the points
  std::mutex mutex;
  const auto addShared = [&](const std::vector<SharedUse>& shared) {
    if (shared.empty()) return;
    SharedUses divided(shared);
    const std::lock_guard lock(mutex);
    additions.shared.push_back(std::move(divided));
  };
  forBlocks(count, kFacesPerTask, context, [&](std::size_t, std::size_t firstFace, std::size_t lastFace) {
    ExactFallbacks& found = fallbacks.local();
    std::vector<SharedUse> shared;
    for (std::size_t i = firstFace; i < lastFace; ++i) {
      entries[i].firstOutline = listUses(i, additions);
      const Index first = entries[i].firstPoint, last = entries[i + 1].firstPoint;
      if (static_cast<std::size_t>(last - first) <= kPointsPerTask) {
        nameUses(i, first, last, additions, shared, found);
        continue;
      }
      const std::lock_guard lock(mutex);
      large.push_back(static_cast<Index>(i));
    }
    addShared(shared);
  });
  for (const Index i : large) {
    const Index begin = entries[i].firstPoint;
    forBlocks(static_cast<std::size_t>(entries[i + 1].firstPoint - begin), kPointsPerTask, context,
              [&](std::size_t, std::size_t first, std::size_t last) {
                std::vector<SharedUse> shared;
                nameUses(i, begin + static_cast<Index>(first), begin + static_cast<Index>(last), additions, shared,
                         fallbacks.local());
                addShared(shared);
              });
  }
  for (const ExactFallbacks& found : fallbacks) fallbacks_ += found;
  Index outlines = 0;
  for (std::size_t i = 0; i < count; ++i) outlines += std::exchange(entries[i].firstOutline, outlines);
  entries.back().firstOutline = outlines;
  additions.outlineCount = static_cast<std::size_t>(outlines);
}

template <class Work>
void MeshJoiner::forUses(const Additions& additions, std::size_t first, std::size_t last, Work work) const {
  const auto& entries = memory_.entries;
  std::size_t entry = entryOfPoint(first);
  for (std::size_t place = first; place < last; ++place) {
    while (static_cast<std::size_t>(entries[entry + 1].firstPoint) <= place) ++entry;
    if (additions.names[place] != kUnused) work(entry, static_cast<Index>(place));
  }
}

// A point on a source edge lies, in space, on that edge itself: all faces that have one by this name mean the same
// vertex.
void MeshJoiner::findUsesOfShared(Additions& additions, RunContext& context) {
  auto& firstUse = additions.firstUse;
  forRanges(SharedUses::kLists, 1, [&](std::size_t list, std::size_t) {
    NumberedTable<SharedPoint> points;
    std::vector<Index> firstOf;
    for (const SharedUses& some : additions.shared) {
      context.checkCancelled();
      for (const SharedUse& use : some.list(list)) {
        const auto [number, isNew] = points.insert(use.point);
        if (isNew) firstOf.push_back(use.place);
        firstOf[number] = std::min(firstOf[number], use.place);
        firstUse.fill(use.place, number);
      }
    }
    for (const SharedUses& some : additions.shared)
      for (const SharedUse& use : some.list(list)) firstUse[use.place] = firstOf[firstUse[use.place]];
  });
  additions.shared = {};
}

void MeshJoiner::numberUses(Additions& additions, RunContext& context) {
  findUsesOfShared(additions, context);
  auto& firstUse = additions.firstUse;
  std::vector<Index> newBefore((additions.pointCount + kPointsPerBlock - 1) / kPointsPerBlock + 1, 0);
  forBlocks(additions.pointCount, kPointsPerBlock, context,
            [&](std::size_t block, std::size_t first, std::size_t last) {
              Index found = 0;
              forUses(additions, first, last, [&](std::size_t, Index place) {
                if (const Index name = additions.names[place]; name >= 0)
                  firstUse.fill(place, additions.firstOfSource(name));
                found += static_cast<Index>(firstUse[place] == place);
              });
              newBefore[block + 1] = found;
            });
  std::partial_sum(newBefore.begin(), newBefore.end(), newBefore.begin());
  std::vector<std::atomic<Index>>().swap(additions.firstUseOfSource);
  additions.firstUseOf = UnfilledArray<Index>(static_cast<std::size_t>(newBefore.back()));
  const auto slotOf = [&](std::size_t entry, Index place) {
    return memory_.entries[entry].firstPoint + additions.pointOf[place];
  };
  // First uses get the numbers, all others those of the first.
  forBlocks(additions.pointCount, kPointsPerBlock, context,
            [&](std::size_t block, std::size_t first, std::size_t last) {
              Index number = newBefore[block];
              forUses(additions, first, last, [&](std::size_t entry, Index place) {
                if (firstUse[place] != place) return;
                additions.firstUseOf.fill(number, place);
                firstUse[place] = -1 - number;
                memory_.vertexOf[slotOf(entry, place)] = number++;
              });
            });
  forBlocks(additions.pointCount, kPointsPerBlock, context, [&](std::size_t, std::size_t first, std::size_t last) {
    forUses(additions, first, last, [&](std::size_t entry, Index place) {
      if (const Index use = firstUse[place]; use >= 0) memory_.vertexOf[slotOf(entry, place)] = -1 - firstUse[use];
    });
  });
}

MeshVertex MeshJoiner::sourceVertex(Index source, Index face) const {
  const Vec3& p = mesh_.scaled[source];
  return {PlanPoint::source(mesh_.planIds[source]), face, source, p.x, p.y, p.z, kernel_.sign().slack};
}

void MeshJoiner::fillVertices(const Additions& additions, RunContext& context) {
  const auto& firstUseOf = additions.firstUseOf;
  vertices_ = UnfilledArray<MeshVertex>(firstUseOf.size());
  const auto& entries = memory_.entries;
  forBlocks(firstUseOf.size(), kPointsPerTask, context, [&](std::size_t, std::size_t first, std::size_t last) {
    std::size_t i = entryOfPoint(firstUseOf[first]);
    for (std::size_t v = first; v < last; ++v) {
      const Index place = firstUseOf[v], name = additions.names[place];
      while (entries[i + 1].firstPoint <= place) ++i;
      const FaceToJoin& given = additions.faces[i];
      const Index p = additions.pointOf[place];
      vertices_.fill(v, name >= 0
                            ? sourceVertex(name, given.face)
                            : liftedVertex(kernel_, given.face, given.parts->points[p], given.parts->approximate[p]));
    }
  });
}

void MeshJoiner::fillTriangles(const Additions& additions, RunContext& context) {
  const auto& faces = additions.faces;
  const auto& firstTriangle = firstTriangle_;
  const auto& entries = memory_.entries;
  triangles_ = UnfilledArray<MeshTriangle>(additions.triangleCount);
  outlines_ = UnfilledArray<Outline>(additions.outlineCount);
  const auto fillPart = [&](const FaceToJoin& given, const FaceMesh::Facet& facet, Index t, Index& outline,
                            const Index* vertexOf) {
    const auto& f = mesh_.triangles[given.face];
    const auto& c = facet.corners;
    const MeshTriangle triangle{{vertexOf[c[0]], vertexOf[c[1]], vertexOf[c[2]]}, given.face, facet.obstacleEdges};
    triangles_.fill(t, triangle);
    for (int k = 0; k < 3; ++k) {
      if ((facet.outlineEdges >> k & 1) == 0) continue;
      std::pair<Index, Index> sourceEdge{-1, -1};
      if (facet.faceEdges[k] >= 0) {
        const Index u = f[facet.faceEdges[k]], v = f[next(facet.faceEdges[k])];
        sourceEdge = {std::min(u, v), std::max(u, v)};
      }
      outlines_.fill(outline++, {triangle.corners[k], triangle.corners[next(k)], t, static_cast<std::int8_t>(k),
                                 given.face, given.parts->lines[facet.lines[k]], sourceEdge});
    }
  };
  forBlocks(additions.triangleCount, kTrianglesPerTask, context,
            [&](std::size_t block, std::size_t first, std::size_t last) {
              auto i = static_cast<std::size_t>(
                  std::upper_bound(firstTriangle.begin(), firstTriangle.end(), static_cast<Index>(first)) -
                  firstTriangle.begin() - 1);
              Index outline = entries[i].firstOutline + additions.outlinesBefore[block];
              for (auto t = static_cast<Index>(first); t < static_cast<Index>(last); ++t) {
                while (firstTriangle[i + 1] <= t) ++i;
                const FaceToJoin& given = faces[i];
                const Index* const vertexOf = memory_.vertexOf.data() + entries[i].firstPoint;
                if (given.parts == nullptr)
                  triangles_.fill(t, {{vertexOf[0], vertexOf[1], vertexOf[2]}, given.face, given.obstacleEdges});
                else
                  fillPart(given, given.parts->facets[t - firstTriangle[i]], t, outline, vertexOf);
              }
            });
}

void MeshJoiner::addFaces(std::span<const FaceToJoin> faces, RunContext& context) {
  Additions additions;
  additions.faces = faces;
  layOut(additions, context);
  listAllUses(additions, context);
  numberUses(additions, context);
  additions.firstUse = {};
  fillVertices(additions, context);
  additions.pointOf = {};
  additions.names = {};
  additions.firstUseOf = {};
  fillTriangles(additions, context);
}

std::size_t MeshJoiner::entryOfPoint(std::size_t place) const {
  const auto& entries = memory_.entries;
  const auto after =
      std::upper_bound(entries.begin(), entries.end(), static_cast<Index>(place),
                       [](Index point, const JoinMemory::Entry& entry) { return point < entry.firstPoint; });
  return static_cast<std::size_t>(after - entries.begin()) - 1;
}

}  // namespace footfall::detail
