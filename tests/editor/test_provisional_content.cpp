// What the view shows between an edit and the result.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/editor_driver.hpp"
#include "ui/provisional_content.hpp"

using namespace footfall;

namespace {

// Separate triangles side by side, one for each of the given faces, twice for a face that is given twice.
NavigationMesh trianglesOn(const std::vector<std::uint32_t>& faces) {
  NavigationMesh mesh;
  for (const std::uint32_t face : faces) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const double x = face;
    mesh.vertices.insert(mesh.vertices.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.sourceTriangles.push_back(face);
  }
  return mesh;
}

ShownResult show(const std::vector<std::uint32_t>& faces) {
  ShownResult shown;
  shown.mesh = std::make_shared<NavigationMesh>(trianglesOn(faces));
  shown.content.walkable = {makeMeshGeometry(*shown.mesh, {})};
  return shown;
}

// The faces on which a geometry has triangles, in its order.
std::vector<int> facesOf(const MeshGeometry& geometry) {
  std::vector<int> faces;
  for (std::size_t v = 0; v < geometry.surface.size(); v += 3)
    faces.push_back(static_cast<int>(geometry.surface[v].position[0]));
  return faces;
}

}  // namespace

class TestProvisionalContent : public QObject {
  Q_OBJECT

 private slots:
  void wholeFacesAreTold() {
    QVERIFY(holdsWholeFaces(trianglesOn({0, 3, 1})));
    QVERIFY(!holdsWholeFaces(trianglesOn({0, 3, 0})));
  }

  void facesGoAndComeAlone() {
    // 1 is cut in two in the result, and nothing is left of 2: neither is touched.
    const ShownResult shown = show({0, 1, 1, 3});
    const RemovalStyle* slope = removalStyle("SlopeFilter");
    const auto content = withChangedFaces(shown, trianglesOn({0, 1, 2, 3}), trianglesOn({1, 2, 3, 7}), slope, {});
    QVERIFY(content.has_value());
    QCOMPARE(content->walkable.size(), std::size_t{2});
    QCOMPARE(facesOf(*content->walkable[0]), (std::vector<int>{1, 1, 3}));
    QCOMPARE(facesOf(*content->walkable[1]), (std::vector<int>{7}));
    QCOMPARE(content->removed.size(), std::size_t{1});
    QVERIFY(content->removed[0].style == slope);
    QCOMPARE(facesOf(*content->removed[0].before), (std::vector<int>{0}));
    // What was shown stays what it was.
    QCOMPARE(facesOf(*shown.content.walkable[0]), (std::vector<int>{0, 1, 1, 3}));
  }

  void sameFacesChangeNothing() {
    QVERIFY(!withChangedFaces(show({0}), trianglesOn({0, 4}), trianglesOn({4, 0}), nullptr, {}));
  }

  void piecesTakeThePlaceOfTheirFaces() {
    const auto piece = makeMeshGeometry(trianglesOn({1, 1, 1}), {});
    const ViewContent content = withPieces(show({0, 1, 1, 2}), {piece}, {1, 1, 1});
    QCOMPARE(content.walkable.size(), std::size_t{2});
    QCOMPARE(facesOf(*content.walkable[0]), (std::vector<int>{0, 2}));
    QCOMPARE(content.walkable[1], piece);
  }
};

QTEST_MAIN(TestProvisionalContent)
#include "test_provisional_content.moc"
