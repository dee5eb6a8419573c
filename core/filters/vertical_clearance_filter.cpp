// VerticalClearanceFilter: removes what has an obstacle within the clearance above it (design section 2, thesis 3.2).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "core/environment/background_release.hpp"
#include "core/filters/assembly_memory.hpp"
#include "core/filters/clearance_clipper.hpp"
#include "core/filters/earlier_result.hpp"
#include "core/filters/filter_registry.hpp"
#include "core/filters/mesh_assembly.hpp"

namespace footfall {
namespace {

constexpr Index kFacesPerTask = 64;

std::shared_ptr<const PlanKernel> kernelWithHeight(const std::shared_ptr<const PlanKernel>& kernel, double height) {
  if (kernel->levelOf(height)) return kernel;
  std::vector<double> heights = kernel->heights();
  heights.push_back(height);
  return std::make_shared<PlanKernel>(kernel->sharedMesh(), std::move(heights));
}

// A height above the whole extent in z lets no obstacle escape, and neither does any other: the smallest power of two
// above it stands for all of them, and does not stretch the grid on which doubles can decide.
double sufficientHeight(const SourceMesh& mesh, double height) {
  if (mesh.vertices.empty()) return height;
  const auto [low, high] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                                               [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
  const double extent = high->z - low->z;
  if (!std::isfinite(extent) || mesh.grid.empty()) return height;
  if (extent == 0) return std::min(height, std::ldexp(1.0, mesh.grid.top));  // any would do
  int exponent = 0;
  std::frexp(extent, &exponent);  // below 2^exponent, and not only after rounding: that is a double
  return std::min(height, std::ldexp(1.0, exponent));
}

// What AreaFilter took away does not come back when floors are cut anew. The outlines of earlier parts stay among the
// cuts, so a new triangle lies in an earlier part as a whole, and any inner point tells which.
std::shared_ptr<const WalkableMesh> withoutDropped(const PlanKernel& kernel, const WalkableMesh& mesh,
                                                   const WalkableMesh& dropped, RunContext& context,
                                                   ExactFallbacks& fallbacks) {
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  const auto boxOf = [](const WalkableMesh& m, const MeshTriangle& t) {
    Box box;
    for (int k = 0; k < 3; ++k) {
      const MeshVertex& v = m.vertices[t.corners[k]];
      const std::array<double, 3> c{v.x, v.y, v.z};
      for (int i = 0; i < 3; ++i) {
        const double low = c[i] - v.error, high = c[i] + v.error;
        box.lower[i] = k == 0 ? low : std::min(box.lower[i], low);
        box.upper[i] = k == 0 ? high : std::max(box.upper[i], high);
      }
    }
    return box;
  };
  for (std::size_t i = 0; i < dropped.triangles.size(); ++i) {
    boxes.push_back(boxOf(dropped, dropped.triangles[i]));
    ids.push_back(static_cast<std::int32_t>(i));
  }
  TriangleTree tree;
  tree.build(std::move(boxes), std::move(ids), [&context] { context.checkCancelled(); });

  using Place = std::array<mpq_class, 3>;
  const auto placeOf = [&](const MeshVertex& v) { return kernel.exactPosition(v.point, v.face); };
  const auto contains = [&](const MeshTriangle& t, const mpq_class& x, const mpq_class& y) {
    std::array<Place, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = placeOf(dropped.vertices[t.corners[k]]);
    for (int k = 0; k < 3; ++k) {
      const Place &a = p[k], &b = p[(k + 1) % 3];
      if ((b[0] - a[0]) * (y - a[1]) < (b[1] - a[1]) * (x - a[0])) return false;
    }
    return true;
  };
  auto result = std::make_shared<WalkableMesh>();
  result->vertices = mesh.vertices;
  std::vector<std::int32_t> stack;
  for (const MeshTriangle& t : mesh.triangles) {
    context.checkCancelled();
    std::optional<std::array<mpq_class, 2>> centre;
    bool gone = false;
    tree.visitOverlapping(boxOf(mesh, t), stack, [&](std::int32_t i) {
      const MeshTriangle& d = dropped.triangles[i];
      if (d.face != t.face && !kernel.coplanar(t.face, d.face, fallbacks)) return true;
      if (!centre) {
        centre.emplace();
        for (const Index c : t.corners) {
          const Place p = placeOf(mesh.vertices[c]);
          (*centre)[0] += p[0] / 3;
          (*centre)[1] += p[1] / 3;
        }
      }
      gone = contains(d, (*centre)[0], (*centre)[1]);
      return !gone;
    });
    if (!gone) result->triangles.push_back(t);
  }
  return result;
}

/// What an earlier run of the filter knows of each face.
class KnownCuts {
 public:
  KnownCuts(const std::optional<EarlierResult>& earlier, const WalkableState& state, double height)
      : earlier_(earlier), state_(state), height_(height) {
    if (!earlier_) return;
    const WalkableState& before = earlier_->state();
    // On a grid with another slack doubles may know less, or more, of the same points, and round them otherwise.
    sameClearance_ = before.memory->clearance == height && before.kernel->heights() == state.kernel->heights() &&
                     before.kernel->sign().slack == state.kernel->sign().slack;
    for (std::size_t t = 0; t < state.walkable.size() && !floorsDiffer_; ++t) {
      const Index then = earlier_->faceBefore(static_cast<Index>(t));
      floorsDiffer_ = then >= 0 && before.walkable[then] != state.walkable[t];
    }
  }

  /// The face's number then, when it was a floor and what is remembered of it can be used; else -1.
  [[nodiscard]] Index before(Index face) const {
    if (!earlier_) return -1;
    const Index then = earlier_->faceBefore(face);
    if (then < 0 || earlier_->state().walkable[then] == 0) return -1;
    return floorsDiffer_ && (*earlier_->state().cuts)[then].dependsOnFloors ? -1 : then;
  }
  /// Whether standing() is complete: it leaves out what was in the face's plane and no floor.
  [[nodiscard]] bool knowsAll(Index faceBefore) const {
    return faceBefore >= 0 && !(*earlier_->state().cuts)[faceBefore].dependsOnFloors;
  }
  /// Whether something came or went in the clearance above the face.
  [[nodiscard]] bool isTouched(Index face) const {
    return earlier_->isTouched(clearanceBox(state_.kernel->mesh(), face, std::max(height_, clearance())));
  }
  /// All that may stand above a face within clearance().
  [[nodiscard]] std::vector<Index> standing(Index faceBefore, const CopyMemory& copies) const {
    const auto known = earlier_->candidates(faceBefore, copies);
    std::vector<Index> result = earlier_->added();
    if (known) result.insert(result.end(), known->begin(), known->end());
    return result;
  }
  [[nodiscard]] bool sameClearance() const { return sameClearance_; }
  [[nodiscard]] double clearance() const { return earlier_->state().memory->clearance; }

 private:
  const std::optional<EarlierResult>& earlier_;
  const WalkableState& state_;
  double height_;
  bool sameClearance_ = false;
  bool floorsDiffer_ = false;
};

// Floors that are a large share of all, largest first. They carry most of the obstacles, and neighbours among them have
// neighbouring numbers: each is a task of its own, begun before all others.
std::vector<Index> findGiants(const SourceMesh& mesh, const std::vector<char>& walkable) {
  constexpr double kShare = 1.0 / 64;
  const auto planArea = [&](Index t) {
    const Box box = boxOf(mesh, t);
    return (box.upper[0] - box.lower[0]) * (box.upper[1] - box.lower[1]);
  };
  const auto count = static_cast<Index>(walkable.size());
  double sum = 0;
  for (Index t = 0; t < count; ++t)
    if (walkable[t] != 0) sum += planArea(t);
  std::vector<std::pair<double, Index>> giants;
  for (Index t = 0; t < count; ++t)
    if (walkable[t] != 0)
      if (const double area = planArea(t); area > sum * kShare) giants.emplace_back(-area, t);
  std::sort(giants.begin(), giants.end());
  std::vector<Index> result;
  for (const auto& [area, t] : giants) result.push_back(t);
  return result;
}

}  // namespace

FilterOutcome applyVerticalClearance(const StatePtr& state, double given, const Recall& recall, RunContext& context) {
  ReleaseOnException large(state->walkable.size() >= kLargeRelease);
  const double height = sufficientHeight(state->kernel->mesh(), given);
  FilterOutcome outcome;
  auto result = std::make_shared<WalkableState>(*state);
  result->kernel = kernelWithHeight(state->kernel, height);
  const PlanKernel& kernel = *result->kernel;
  const Index level = *kernel.levelOf(height);
  const auto count = static_cast<Index>(kernel.mesh().triangles.size());

  // Only a first clearance filter can be taken over or remembered: later ones add to the cuts of others.
  std::shared_ptr<AssemblyMemory> memory;
  std::optional<EarlierResult> earlier;
  if (!state->cuts && recall.keep) {
    memory = std::make_shared<AssemblyMemory>();
    large.hold(memory);
    memory->candidates.resize(count);
    memory->clearance = height;
    if (recall.before && recall.before->memory) earlier = EarlierResult::relate(recall.before, kernel);
  }
  const KnownCuts known(earlier, *result, height);

  auto cuts = std::make_shared<CutTable>(count);
  large.hold(cuts);
  std::vector<char> isChanged(count, 0);
  tbb::enumerable_thread_specific<std::unique_ptr<ClearanceClipper>> clippers;
  tbb::enumerable_thread_specific<CopyMemory> copies(makeCopyMemory);
  std::atomic<Index> done{0};
  const std::vector<Index> giants = findGiants(kernel.mesh(), state->walkable);
  std::vector<char> isGiant(count, 0);
  for (const Index t : giants) isGiant[t] = 1;
  const auto giantCount = static_cast<Index>(giants.size());
  std::atomic<Index> nextTask{0};
  tbb::parallel_for(Index{0}, giantCount + (count + kFacesPerTask - 1) / kFacesPerTask, [&](Index) {
    const Index task = nextTask.fetch_add(1, std::memory_order_relaxed);
    const bool isOne = task < giantCount;
    const Index first = isOne ? giants[task] : (task - giantCount) * kFacesPerTask;
    const Index last = isOne ? first + 1 : std::min(first + kFacesPerTask, count);
    const CopyMemory& ownCopies = copies.local();
    auto& clipper = clippers.local();
    if (!clipper)
      clipper =
          std::make_unique<ClearanceClipper>(kernel, state->walkable, level, [&context] { context.checkCancelled(); });
    for (Index t = first; t != last; ++t) {
      context.checkCancelled();
      if (state->walkable[t] == 0 || (isGiant[t] != 0 && !isOne)) continue;
      const Index then = known.before(t);
      if (then >= 0 && known.sameClearance() && !known.isTouched(t)) {
        cuts->set(t, earlier->cuts(then, ownCopies));
        memory->candidates[t] = earlier->candidates(then, ownCopies);
        continue;
      }
      isChanged[t] = 1;
      cuts->set(t, known.knowsAll(then) ? clipper->clip(t, known.standing(then, ownCopies), known.clearance())
                                        : clipper->clip(t, state->cuts ? &(*state->cuts)[t] : nullptr));
      if (!memory) continue;
      if (const std::vector<Index> found = clipper->candidates(); !found.empty())
        memory->candidates[t] = std::make_shared<const std::pmr::vector<Index>>(found.begin(), found.end());
    }
    if (isOne) return;
    const Index finished = done.fetch_add(last - first, std::memory_order_relaxed);
    context.progress(0.5 * finished / count);
  });
  for (const auto& clipper : clippers) outcome.fallbacks += clipper->fallbacks();
  result->cuts = std::move(cuts);
  const bool partly = earlier && known.sameClearance();
  std::vector<Index> changed;
  for (Index t = 0; t < count && partly; ++t)
    if (isChanged[t] != 0) changed.push_back(t);
  result->mesh = assembleMesh(*result, partly ? &*earlier : nullptr, changed, memory.get(), context, outcome.fallbacks);
  result->simplified = false;
  result->memory = memory;
  if (result->dropped)
    result->mesh = withoutDropped(kernel, *result->mesh, *result->dropped, context, outcome.fallbacks);
  outcome.state = std::move(result);
  return outcome;
}

}  // namespace footfall
