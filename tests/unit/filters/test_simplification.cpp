// SimplificationFilter on borders of which one side keeps its vertices: the work grows as their length.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>

#include "core/assembly/walkable_state.hpp"
#include "core/filters/simplification/region_simplifier.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall::detail;
using namespace footfall::test;

namespace {

/// The remainder of a row of `count` quads of which only the vertices on one long side may go, and the number of polls
/// for cancelling.
struct SimplifiedRow {
  std::size_t triangles = 0, polls = 0;
};

SimplifiedRow simplifyRow(int count) {
  Soup soup;
  for (int i = 0; i < count; ++i) soup.floor(i, 0, i + 1, 5, 0);
  const StatePtr state = runFilters(soup.environment(), minimalPipeline(2));
  const WalkableMesh& given = *state->mesh;
  SimplifiedMesh mesh{given.vertices, given.triangles, {}, {}, {}, {}};
  mesh.neighbors.assign(3 * mesh.triangles.size(), -1);
  const auto topology = topologyOf(*state);
  for (Index e = 0; e < topology->edgeCount(); ++e)
    if (const auto sides = topology->sidesOf(e); sides.size() == 2) {
      mesh.neighbors[sides[0]] = sides[1];
      mesh.neighbors[sides[1]] = sides[0];
    }
  double last = 0;
  for (const MeshVertex& v : mesh.vertices) last = std::max(last, v.x);
  std::vector<char> mayGo;
  std::vector<Index> vertices, triangles;
  for (const MeshVertex& v : mesh.vertices) {
    mayGo.push_back(v.y == 0 && v.x > 0 && v.x < last ? 1 : 0);
    if (mayGo.back() != 0) vertices.push_back(static_cast<Index>(mayGo.size()) - 1);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) triangles.push_back(static_cast<Index>(t));
  mesh.alive.assign(mesh.triangles.size(), 1);
  mesh.around.build(mesh.triangles, mayGo);

  SimplifiedRow result;
  const auto poll = [&] { ++result.polls; };
  RegionSimplifier(*state->kernel, mesh, {}, poll).simplify(vertices, triangles);
  result.triangles = static_cast<std::size_t>(std::count(mesh.alive.begin(), mesh.alive.end(), 1));
  return result;
}

}  // namespace

class TestSimplification : public QObject {
  Q_OBJECT
 private slots:
  // Polls come after about so many triangles each.
  void longBordersTakeWorkAsTheirLength() {
    const SimplifiedRow few = simplifyRow(2000), many = simplifyRow(8000);
    QCOMPARE(few.triangles, std::size_t{2001});
    QCOMPARE(many.triangles, std::size_t{8001});
    QVERIFY2(many.polls < 5 * few.polls, qPrintable(QString("%1, then %2").arg(few.polls).arg(many.polls)));
  }
};

QTEST_GUILESS_MAIN(TestSimplification)
#include "test_simplification.moc"
