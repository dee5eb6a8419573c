// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "core/base/box_tree.hpp"
#include "core/base/index_and_box.hpp"
#include "core/base/parallel.hpp"
#include "core/base/sorted_list.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/filters/rounding/rounded_mesh.hpp"
#include "core/mesh/triangle_split.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kBordersPerTask = 256;
/// All borders are looked up in rows where at least one in so many is looked up, which takes less.
constexpr std::size_t kShareOfRows = 3;

using Place = std::tuple<double, double, double>;
Place placeOf(const Vec3& v) { return {v.x, v.y, v.z}; }

/// An edge with a triangle on one side only.
struct Border {
  Index from = -1, to = -1;
  Index triangle = -1;
  int k = 0;
};

std::vector<Border> findBorders(const RoundedMesh& mesh, const Adjacency& topology) {
  std::vector<Border> borders;
  for (Index e = 0; e < topology.edgeCount(); ++e) {
    const auto sides = topology.sidesOf(e);
    if (sides.size() > 1) continue;
    const Index t = sides[0] / 3;
    const int k = sides[0] % 3;
    borders.push_back({mesh.triangles[t].corners[k], mesh.triangles[t].corners[next(k)], t, k});
  }
  return borders;
}

// Returns whether p lies strictly between a and b, which differ; the three points must be collinear.
bool isBetween(const Vec3& a, const Vec3& p, const Vec3& b) {
  const Place pa = placeOf(a), pp = placeOf(p), pb = placeOf(b);
  return (pa < pp && pp < pb) || (pb < pp && pp < pa);  // order along a line is the order of x, then y, then z
}

/// Contacts of borders with others that run the opposite way.
struct Contacts {
  std::vector<Index> closed;                       ///< borders that coincide with another one
  std::vector<std::pair<Index, Place>> innerEnds;  ///< borders, and ends of others strictly inside them
};

/// Adds the contacts of two borders.
void addContacts(const RoundedMesh& mesh, const std::vector<Border>& borders, Index i, Index o, Contacts& contacts) {
  const Vec3 &v = mesh.vertices[borders[i].from], &w = mesh.vertices[borders[i].to];
  const Vec3 &a = mesh.vertices[borders[o].from], &b = mesh.vertices[borders[o].to];
  if (a == w && b == v) {
    contacts.closed.insert(contacts.closed.end(), {i, o});
    return;
  }
  const double along = (w.x - v.x) * (b.x - a.x) + (w.y - v.y) * (b.y - a.y) + (w.z - v.z) * (b.z - a.z);
  if (along >= 0 || !isDegenerate(a, b, v) || !isDegenerate(a, b, w)) return;  // only opposite ones meet
  for (const Vec3* p : {&v, &w})
    if (isBetween(a, *p, b)) contacts.innerEnds.emplace_back(o, placeOf(*p));
  for (const Vec3* p : {&a, &b})
    if (isBetween(v, *p, w)) contacts.innerEnds.emplace_back(i, placeOf(*p));
}

/// The contacts of borders one of which is a suspect: one of its ends is marked, or no end of any is.
Contacts findContacts(const RoundedMesh& mesh, const std::vector<Border>& borders, const std::vector<char>& suspects,
                      RunContext& context) {
  using Tree = BoxTree<3>;
  const auto boundsOf = [&](Index i) {
    const Vec3 &a = mesh.vertices[borders[i].from], &b = mesh.vertices[borders[i].to];
    return Tree::Bounds{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                        {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
  };
  const auto count = static_cast<Index>(borders.size());
  std::vector<Index> all(borders.size()), queries;
  std::vector<char> isQuery(borders.size(), 0);
  for (Index i = 0; i < count; ++i) {
    all[i] = i;
    if (!suspects.empty() && suspects[borders[i].from] == 0 && suspects[borders[i].to] == 0) continue;
    queries.push_back(i);
    isQuery[i] = 1;
  }
  Contacts result;
  if (queries.empty()) return result;
  Tree tree;
  tree.build(all, boundsOf, context);

  PerThread<Contacts> locals;
  const bool areMany = queries.size() > borders.size() / kShareOfRows;
  parallelRanges(areMany ? borders.size() : queries.size(), kBordersPerTask, [&](const auto& range) {
    context.checkCancelled();
    Contacts& local = locals.local();
    if (!areMany) {
      for (std::size_t q = range.begin(); q != range.end(); ++q)
        tree.visitOverlapping(boundsOf(queries[q]), [&](Index o) { addContacts(mesh, borders, queries[q], o, local); });
      return;
    }
    std::vector<Tree::Bounds> row;
    const auto end = static_cast<Index>(range.end());
    for (auto first = static_cast<Index>(range.begin()); first < end; first += Tree::kRow) {
      row.clear();
      for (Index place = first; place < std::min(first + Tree::kRow, end); ++place)
        row.push_back(boundsOf(tree.idAt(place)));
      tree.visitOverlapping(first, row, [&](Index place, Index o) {
        const Index own = tree.idAt(place);
        if (isQuery[own] != 0 || isQuery[o] != 0) addContacts(mesh, borders, own, o, local);
      });
    }
  });
  for (const Contacts& local : locals) {
    result.closed.insert(result.closed.end(), local.closed.begin(), local.closed.end());
    result.innerEnds.insert(result.innerEnds.end(), local.innerEnds.begin(), local.innerEnds.end());
  }
  return result;
}

void splitBorders(RoundedMesh& mesh, const std::vector<Border>& borders,
                  std::vector<std::pair<Index, Place>>& innerEnds) {
  sortOnce(innerEnds);
  std::map<Index, std::array<std::vector<Index>, 3>> splits;
  for (auto first = innerEnds.begin(); first != innerEnds.end();) {
    const Index number = first->first;
    const auto last = std::find_if(first, innerEnds.end(), [&](const auto& end) { return end.first != number; });
    const Border& e = borders[number];
    if (placeOf(mesh.vertices[e.to]) < placeOf(mesh.vertices[e.from])) std::reverse(first, last);
    for (; first != last; ++first) {
      const auto& [x, y, z] = first->second;
      splits[e.triangle][e.k].push_back(static_cast<Index>(mesh.vertices.size()));
      mesh.vertices.push_back({x, y, z});
    }
  }
  std::vector<MeshTriangle> triangles;
  std::vector<std::uint32_t> layers;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    if (const auto it = splits.find(t); it != splits.end())
      splitTriangle(mesh.triangles[t], {&it->second[0], &it->second[1], &it->second[2]}, triangles);
    else
      triangles.push_back(mesh.triangles[t]);
    if (!mesh.layers.empty()) layers.resize(triangles.size(), mesh.layers[t]);
  }
  mesh.triangles = std::move(triangles);
  mesh.layers = std::move(layers);
}

}  // namespace

std::vector<Index> markBorders(RoundedMesh& mesh, const Adjacency& topology) {
  for (const Border& e : findBorders(mesh, topology))
    mesh.triangles[e.triangle].obstacleEdges |= static_cast<std::uint8_t>(1 << e.k);
  std::vector<Index> crowded;
  const auto beginOf = [&](Index side) { return mesh.triangles[side / 3].corners[side % 3]; };
  for (Index e = 0; e < topology.edgeCount(); ++e) {
    const auto sides = topology.sidesOf(e);
    if (sides.size() < 2 || (sides.size() == 2 && beginOf(sides[0]) != beginOf(sides[1]))) continue;
    for (const Index s : sides) crowded.push_back(s / 3);
  }
  sortOnce(crowded);
  return crowded;
}

bool settleBorders(RoundedMesh& mesh, const Adjacency& topology) {
  bool shared = false;
  for (Index e = 0; e < topology.edgeCount(); ++e) {
    const auto sides = topology.sidesOf(e);
    const bool flagged = isObstacle(mesh.triangles, sides);
    if (!flagged) continue;
    const bool obstacle = sides.size() > 1;
    shared = shared || obstacle;
    for (const Index s : sides) {
      std::uint8_t& flags = mesh.triangles[s / 3].obstacleEdges;
      const auto bit = static_cast<std::uint8_t>(1 << (s % 3));
      flags = static_cast<std::uint8_t>(obstacle ? flags | bit : flags & ~bit);
    }
  }
  return shared;
}

void dropSharedObstacles(RoundedMesh& mesh, const Adjacency& topology) {
  for (Index e = 0; e < topology.edgeCount(); ++e) {
    const auto sides = topology.sidesOf(e);
    if (sides.size() < 2 || !isObstacle(mesh.triangles, sides)) continue;
    for (const Index s : sides) mesh.triangles[s / 3].obstacleEdges &= static_cast<std::uint8_t>(~(1 << s % 3));
  }
}

bool markClosedSlivers(RoundedMesh& mesh, const Adjacency& topology, const std::vector<char>& suspects,
                       RunContext& context) {
  std::vector<Border> borders = findBorders(mesh, topology);
  Contacts contacts = findContacts(mesh, borders, suspects, context);
  const bool split = !contacts.innerEnds.empty();
  if (split) {
    // Now no border ends inside another one.
    splitBorders(mesh, borders, contacts.innerEnds);
    borders = findBorders(mesh, findEdges(mesh.triangles, mesh.vertices.size(), context));
    contacts = findContacts(mesh, borders, {}, context);
  }
  for (const Index i : contacts.closed)
    mesh.triangles[borders[i].triangle].obstacleEdges |= static_cast<std::uint8_t>(1 << borders[i].k);
  return split;
}

}  // namespace footfall::detail
