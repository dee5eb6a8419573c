// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/generation.hpp"

#include "core/filters/face_mesh.hpp"

namespace footfall {
namespace {

using VertexNumber = std::uint32_t;

class SoupBuilder {
 public:
  explicit SoupBuilder(const WalkableState& state) : state_(state), source_(state.kernel->mesh()) {}

  GenerationSoup build(RunContext& context, ExactFallbacks& fallbacks) {
    if (state_.mesh) addWalkable(context);
    addSourceTriangles(context, fallbacks);
    if (state_.dropped) addDropped(context);
    return std::move(result_);
  }

 private:
  VertexNumber addVertex(const Vec3& place) {
    result_.soup.vertices.push_back(place);
    return static_cast<VertexNumber>(result_.soup.vertices.size()) - 1;
  }
  void addTriangle(const Triangle& t, Index face, bool walkable) {
    result_.soup.triangles.push_back(t);
    result_.soup.inputTriangles.push_back(source_.inputTriangles[face]);
    result_.walkable.push_back(static_cast<char>(walkable));
  }

  void addWalkable(RunContext& context) {
    RoundedMesh rounded;
    std::vector<char> exact;
    rounded.vertices = roundVertices(*state_.kernel, state_.mesh->vertices, exact, context);
    rounded.triangles = state_.mesh->triangles;
    const auto poll = [&context] { context.checkCancelled(); };
    auto topology = topologyOf(state_, poll);
    markBorders(rounded, *topology);
    result_.cases = repairRounding(rounded, exact, context);
    if (result_.cases.anyBroken())
      topology = std::make_shared<MeshTopology>(findEdges(rounded.triangles, rounded.vertices.size(), poll));
    settleBorders(rounded, *topology);
    markClosedSlivers(rounded, *topology, {}, context);
    for (const Vec3& v : rounded.vertices) addVertex(v);
    for (const MeshTriangle& t : rounded.triangles) {
      Triangle corners{};
      for (int k = 0; k < 3; ++k) corners[k] = static_cast<VertexNumber>(t.corners[k]);
      addTriangle(corners, t.face, true);
      for (int k = 0; k < 3; ++k)
        if ((t.obstacleEdges >> k & 1) != 0) result_.soup.obstacleEdges.push_back({corners[k], corners[(k + 1) % 3]});
    }
  }

  void addSourceTriangles(RunContext& context, ExactFallbacks& fallbacks) {
    FaceMesher mesher(*state_.kernel, [&context] { context.checkCancelled(); });
    for (Index t = 0; t < static_cast<Index>(source_.triangles.size()); ++t) {
      if (state_.removed[t] != 0) continue;
      const bool floor = state_.walkable[t] != 0;
      const FaceCuts* cuts = floor && state_.cuts ? &(*state_.cuts)[t] : nullptr;
      const bool whole = cuts == nullptr || cuts->removed || cuts->segments.empty();
      if (whole) {
        const bool covered = cuts != nullptr && cuts->removed;
        if (floor && !covered && state_.mesh) continue;  // in the mesh
        const auto& f = source_.triangles[t];
        addTriangle(
            {addVertex(source_.vertices[f[0]]), addVertex(source_.vertices[f[1]]), addVertex(source_.vertices[f[2]])},
            t, floor && !covered);
        continue;
      }
      context.checkCancelled();
      const FaceMesh parts = mesher.mesh(t, cuts, true);
      std::vector<VertexNumber> numbers;
      for (const PlanPoint& p : parts.points) numbers.push_back(addVertex(state_.kernel->roundedPosition(p, t)));
      for (const FaceMesh::Cell& c : parts.cells)
        addTriangle({numbers[c.corners[0]], numbers[c.corners[1]], numbers[c.corners[2]]}, t, false);
    }
    fallbacks += mesher.fallbacks();
    for (const auto& [a, b] : source_.obstacleEdges)
      result_.soup.obstacleEdges.push_back({addVertex(source_.vertices[a]), addVertex(source_.vertices[b])});
  }

  void addDropped(RunContext& context) {
    std::vector<char> exact;
    const std::vector<Vec3> places = roundVertices(*state_.kernel, state_.dropped->vertices, exact, context);
    for (const MeshTriangle& t : state_.dropped->triangles)
      addTriangle({addVertex(places[t.corners[0]]), addVertex(places[t.corners[1]]), addVertex(places[t.corners[2]])},
                  t.face, false);
  }

  const WalkableState& state_;
  const SourceMesh& source_;
  GenerationSoup result_;
};

}  // namespace

GenerationSoup makeGenerationSoup(const WalkableState& state, RunContext& context, ExactFallbacks& fallbacks) {
  return SoupBuilder(state).build(context, fallbacks);
}

StatePtr startGeneration(const WalkableState& earlier, const GenerationSoup& soup, RunContext& context) {
  std::vector<std::uint32_t> order;
  auto mesh = std::make_shared<SourceMesh>(
      makeSourceMesh(soup.soup, earlier.environment->bothSides, &order, [&context] { context.checkCancelled(); }));
  auto state = std::make_shared<WalkableState>();
  state->environment = earlier.environment;
  state->removed.assign(order.size(), 0);
  state->walkable.resize(order.size());
  for (std::size_t t = 0; t < order.size(); ++t)
    state->walkable[t] = static_cast<char>(soup.walkable[order[t]] != 0 && mesh->facing[t] > 0);
  state->kernel = std::make_shared<PlanKernel>(std::move(mesh), std::vector<double>{});
  return state;
}

bool hasConstructedVertices(const WalkableState& state) {
  if (!state.mesh) return false;
  for (const MeshVertex& v : state.mesh->vertices)
    if (v.source < 0) return true;
  return false;
}

}  // namespace footfall
