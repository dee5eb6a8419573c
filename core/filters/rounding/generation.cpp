// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/rounding/generation.hpp"

#include <cmath>
#include <memory>

#include "core/assembly/face_mesh.hpp"
#include "core/assembly/mesh_assembly.hpp"
#include "core/base/parallel.hpp"
#include "core/base/poll.hpp"
#include "core/exact/mesh_match.hpp"
#include "core/filters/steps/kept_links.hpp"
#include "core/mesh/gap_bridges.hpp"

namespace footfall::detail {
namespace {

using VertexNumber = std::uint32_t;

constexpr std::size_t kFacesPerTask = 8;
constexpr std::size_t kPointsPerTask = 256;
constexpr Index kPolled = 1 << 14;

class SoupBuilder {
 public:
  explicit SoupBuilder(const WalkableState& state, CoveredRecall* covered = nullptr)
      : state_(state), source_(state.kernel->mesh()), covered_(covered) {}

  GenerationSoup build(const NavigationMesh* product, RunContext& context, ExactFallbacks& fallbacks) {
    if (product != nullptr)
      addProduct(*product);
    else if (state_.mesh)
      addWalkable(roundWalkable(context));
    addOthers(context, fallbacks);
    return std::move(result_);
  }

  GenerationSoup buildFloors(const NavigationMesh& product) {
    addProduct(product);
    addObstacleEdges();
    return std::move(result_);
  }

  GenerationSoup buildLinked(std::shared_ptr<const NavigationMesh> product, RunContext& context,
                             ExactFallbacks& fallbacks) {
    roundWalkable(context);  // for what it meets
    addProduct(*product);
    result_.product = std::move(product);
    addOthers(context, fallbacks);
    return std::move(result_);
  }

 private:
  void addOthers(RunContext& context, ExactFallbacks& fallbacks) {
    addSourceTriangles(context, fallbacks);
    if (state_.dropped) addDropped(context);
  }

  VertexNumber addVertex(const Vec3& place) {
    result_.vertices.push_back(place);
    return static_cast<VertexNumber>(result_.vertices.size()) - 1;
  }
  /// The number in the soup of a vertex of the source.
  VertexNumber numberOf(Index vertex) {
    if (numbers_.empty()) numbers_.resize(source_.vertices.size(), kNone);
    if (numbers_[vertex] == kNone) numbers_[vertex] = addVertex(source_.vertices[vertex]);
    return numbers_[vertex];
  }
  void addTriangle(const Triangle& t, Index face, bool walkable) {
    result_.triangles.push_back(t);
    result_.inputTriangles.push_back(source_.inputTriangles[face]);
    result_.walkable.push_back(static_cast<char>(walkable));
  }

  void addProduct(const NavigationMesh& product) {
    result_.vertices = product.vertices;
    result_.triangles = product.triangles;
    result_.inputTriangles = product.sourceTriangles;
    result_.obstacleEdges = product.obstacleEdges;
    result_.walkable.assign(product.triangles.size(), 1);
  }

  RoundedMesh roundWalkable(RunContext& context) {
    RoundedMesh rounded;
    std::vector<char> exact;
    rounded.vertices = roundVertices(*state_.kernel, state_.mesh->vertices, exact, context);
    rounded.triangles = state_.mesh->triangles;
    const Poll poll(context);
    auto topology = topologyOf(state_, poll);
    const std::vector<Index> crowded = markBorders(rounded, *topology);
    result_.cases = repairRounding(rounded, exact, context, crowded);
    if (result_.cases.anyBroken())
      topology = std::make_shared<Adjacency>(findEdges(rounded.triangles, rounded.vertices.size(), poll));
    settleBorders(rounded, *topology);
    markClosedSlivers(rounded, *topology, {}, context);
    return rounded;
  }

  void addWalkable(const RoundedMesh& rounded) {
    for (const Vec3& v : rounded.vertices) addVertex(v);
    for (const MeshTriangle& t : rounded.triangles) {
      Triangle corners{};
      for (int k = 0; k < 3; ++k) corners[k] = static_cast<VertexNumber>(t.corners[k]);
      addTriangle(corners, t.face, true);
      for (int k = 0; k < 3; ++k)
        if ((t.obstacleEdges >> k & 1) != 0) result_.obstacleEdges.push_back({corners[k], corners[(k + 1) % 3]});
    }
  }

  [[nodiscard]] const FaceCuts* cutsOf(Index t) const {
    return state_.walkable[t] != 0 && state_.cuts ? &(*state_.cuts)[t] : nullptr;
  }
  [[nodiscard]] bool isDivided(Index t) const {
    const FaceCuts* cuts = cutsOf(t);
    return state_.removed[t] == 0 && cuts != nullptr && !cuts->removed && !cuts->segments.empty();
  }
  /// Divided or not, it is the same obstacle: what rounding makes of its parts is exactly in its plane, and where cuts
  /// meet its edges, exactly on these, too, as they are parallel to an axis.
  [[nodiscard]] bool isWholeObstacle(Index t) const {
    const auto& f = source_.triangles[t];
    const auto place = [&](int k) -> const Vec3& { return source_.vertices[f[k % 3]]; };
    if (place(0).z != place(1).z || place(1).z != place(2).z) return false;
    unsigned slanting = 0;
    for (int k = 0; k < 3; ++k)
      if (place(k).x != place(k + 1).x && place(k).y != place(k + 1).y) slanting |= 1U << k;
    const FaceCuts& cuts = *cutsOf(t);
    for (std::size_t i = 0; i < cuts.points.size(); ++i)
      if ((cuts.borders[i] & slanting) != 0 && cuts.points[i].kind() != PlanPoint::Source) return false;
    return true;
  }

  [[nodiscard]] std::shared_ptr<const CoveredPart> knownPart(Index face) const {
    if (covered_ == nullptr || covered_->earlier == nullptr || !state_.cuts) return nullptr;
    const EarlierResult& earlier = *covered_->earlier;
    const Index before = earlier.faceBefore(face);
    if (before < 0 || !earlier.state().cuts || !(*covered_->before)[before]) return nullptr;
    return earlier.hasSameCuts(face, *state_.cuts) ? (*covered_->before)[before] : nullptr;
  }

  [[nodiscard]] CoveredParts findCoveredParts(RunContext& context, ExactFallbacks& fallbacks) const {
    CoveredParts parts(source_.triangles.size());
    std::vector<Index> faces;
    for (Index t = 0; t < static_cast<Index>(source_.triangles.size()); ++t)
      if (isDivided(t) && !isWholeObstacle(t)) faces.push_back(t);
    const Poll poll(context);
    PerThread<std::unique_ptr<FaceMesher>> meshers;
    parallelRanges(faces.size(), kFacesPerTask, [&](const auto& range) {
      auto& mesher = meshers.local();
      if (!mesher) mesher = std::make_unique<FaceMesher>(*state_.kernel, poll);
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        poll();
        const Index face = faces[i];
        parts[face] = knownPart(face);
        if (parts[face]) continue;
        const FaceMesh& mesh = mesher->mesh(face, cutsOf(face), true);
        const auto part = std::make_shared<CoveredPart>();
        for (const FaceMesh::Facet& facet : mesh.facets) part->triangles.push_back(facet.corners);
        part->places.resize(mesh.points.size());
        // A face can carry most of a level's points. Isolated, so that no other face's work starts on top of this
        // one's, which would make another mesh in this one's memory.
        isolated([&] {
          parallelRanges(mesh.points.size(), kPointsPerTask, [&](const auto& points) {
            poll();
            for (std::size_t p = points.begin(); p != points.end(); ++p)
              part->places[p] = state_.kernel->roundedPosition(mesh.points[p], face);
          });
        });
        parts[face] = part;
      }
    });
    for (const auto& mesher : meshers) fallbacks += mesher->fallbacks();
    return parts;
  }

  void addSourceTriangles(RunContext& context, ExactFallbacks& fallbacks) {
    CoveredParts divided = findCoveredParts(context, fallbacks);
    for (Index t = 0; t < static_cast<Index>(source_.triangles.size()); ++t) {
      if (t % kPolled == 0) context.checkCancelled();
      if (state_.removed[t] != 0) continue;
      if (std::shared_ptr<const CoveredPart>& part = divided[t]) {
        const auto base = static_cast<VertexNumber>(result_.vertices.size());
        result_.vertices.insert(result_.vertices.end(), part->places.begin(), part->places.end());
        for (const auto& [a, b, c] : part->triangles)
          addTriangle({base + static_cast<VertexNumber>(a), base + static_cast<VertexNumber>(b),
                       base + static_cast<VertexNumber>(c)},
                      t, false);
        if (covered_ == nullptr) part = nullptr;
        continue;
      }
      const bool floor = state_.walkable[t] != 0;
      const FaceCuts* cuts = cutsOf(t);
      // The remaining part of a divided floor is in the mesh, too.
      const bool covered = cuts != nullptr && (cuts->removed || isDivided(t));
      if (floor && !covered && state_.mesh) continue;  // in the mesh
      const auto& f = source_.triangles[t];
      addTriangle({numberOf(f[0]), numberOf(f[1]), numberOf(f[2])}, t, floor && !covered);
    }
    if (covered_ != nullptr) covered_->found = std::move(divided);
    addObstacleEdges();
  }

  void addObstacleEdges() {
    for (const auto& [a, b] : source_.obstacleEdges) result_.obstacleEdges.push_back({numberOf(a), numberOf(b)});
  }

  void addDropped(RunContext& context) {
    std::vector<char> exact;
    const std::vector<Vec3> places = roundVertices(*state_.kernel, state_.dropped->vertices, exact, context);
    for (const MeshTriangle& t : state_.dropped->triangles)
      addTriangle({addVertex(places[t.corners[0]]), addVertex(places[t.corners[1]]), addVertex(places[t.corners[2]])},
                  t.face, false);
  }

  static constexpr auto kNone = static_cast<VertexNumber>(-1);

  const WalkableState& state_;
  const SourceMesh& source_;
  std::vector<VertexNumber> numbers_;  ///< in the soup, of the source's vertices
  CoveredRecall* covered_;
  GenerationSoup result_;
};

}  // namespace

GenerationSoup makeGenerationSoup(const StatePtr& state, RunContext& context, ExactFallbacks& fallbacks) {
  if (state->mesh && !state->mesh->links.empty())
    return SoupBuilder(*state).buildLinked(makeNavigationMesh(state, context), context, fallbacks);
  return SoupBuilder(*state).build(nullptr, context, fallbacks);
}

GenerationSoup makeGenerationSoup(const WalkableState& state, const NavigationMesh& product, RunContext& context,
                                  ExactFallbacks& fallbacks, CoveredRecall* covered) {
  return SoupBuilder(state, covered).build(&product, context, fallbacks);
}

GenerationSoup makeSoupOfFloors(const WalkableState& state, const NavigationMesh& product) {
  return SoupBuilder(state).buildFloors(product);
}

StatePtr startGeneration(const WalkableState& earlier, const GenerationSoup& soup, RunContext& context,
                         std::vector<Index>* faces, const std::shared_ptr<const SourceMesh>& before) {
  std::vector<std::uint32_t> order;
  SoupView view(soup.vertices, soup.triangles, soup.inputTriangles);
  view.obstacleEdges = soup.obstacleEdges;
  // The scale is the same with obstacles and without.
  view.grid.top = earlier.kernel->mesh().grid.top;
  auto mesh = std::make_shared<SourceMesh>(makeSourceMesh(view, earlier.environment->bothSides, &order, context));
  if (before) mesh->edit = matchSourceMeshes(before, *mesh, context);
  if (faces != nullptr) {
    faces->resize(order.size());
    for (std::size_t t = 0; t < order.size(); ++t) (*faces)[order[t]] = static_cast<Index>(t);
  }
  auto state = std::make_shared<WalkableState>();
  state->environment = earlier.environment;
  state->clearance = earlier.clearance;
  state->agentHeight = earlier.agentHeight;
  state->step = earlier.step;
  state->removed.assign(order.size(), 0);
  state->walkable.resize(order.size());
  for (std::size_t t = 0; t < order.size(); ++t)
    state->walkable[t] = static_cast<char>(soup.walkable[order[t]] != 0 && mesh->facing[t] > 0);
  state->kernel = std::make_shared<PlanKernel>(std::move(mesh), std::vector<double>{});
  return state;
}

StatePtr nextGeneration(const WalkableState& earlier, const GenerationSoup& soup, bool isMoved, RunContext& context,
                        ExactFallbacks& fallbacks) {
  std::vector<Index> faces;
  StatePtr state = startGeneration(earlier, soup, context, &faces);
  if (!earlier.mesh) return state;
  state = withMesh(state, context, fallbacks);
  if (!soup.product) return state;
  const auto floors = floorsOf(*soup.product, state->kernel->mesh(), faces, state->kernel->sign().slack);
  if (isMoved) {
    const std::vector<Vec3>& places = soup.vertices;
    const auto isAsBefore = [&](const StepLink& link) {
      for (const int end : {0, 1})
        if (std::fabs(places[link.from[end]].z - places[link.to[1 - end]].z) > link.height) return false;
      return widthOf(link, places) <= link.width;
    };
    floors->links.clear();
    for (const StepLink& link : soup.product->links)
      if (isAsBefore(link)) floors->links.push_back(linkOf(link));
  }
  return withLinks(state, *floors, isMoved, context, fallbacks);
}

bool hasConstructedVertices(const WalkableState& state) {
  if (!state.mesh) return false;
  for (const MeshVertex& v : state.mesh->vertices)
    if (v.source < 0) return true;
  return false;
}

}  // namespace footfall::detail
