// The content of the view between an edit and the result.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "ui/run/provisional_content.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;

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
std::vector<int> facesOf(const NavigationMeshGeometry& geometry) {
  std::vector<int> faces;
  for (std::size_t v = 0; v < geometry.surface.size(); v += 3)
    faces.push_back(static_cast<int>(geometry.surface[v].position[0]));
  return faces;
}

}  // namespace

class TestProvisionalContent : public QObject {
  Q_OBJECT

 private slots:
  void onlyWhatChangesIsDrawn() {
    const Paint brown = removalStyle(FilterType::Slope)->paint;
    const auto changes = changedTriangles(trianglesOn({0, 1, 2, 3}), trianglesOn({3, 2, 7, 1}), brown, {});
    QCOMPARE(changes.size(), std::size_t{2});
    QCOMPARE(facesOf(*changes[0]), (std::vector<int>{0}));
    QCOMPARE(int{changes[0]->surface[0].colour[0]}, brown.colour.red());
    QCOMPARE(facesOf(*changes[1]), (std::vector<int>{7}));
    QCOMPARE(int{changes[1]->surface[0].colour[0]}, walkablePaint().colour.red());
  }

  void sameTrianglesChangeNothing() {
    QVERIFY(changedTriangles(trianglesOn({0, 4}), trianglesOn({4, 0}), walkablePaint(), {}).empty());
  }

  void piecesTakeThePlaceOfTheirFaces() {
    const auto mesh = std::make_shared<const NavigationMesh>(trianglesOn({1, 1, 1}));
    const RunEventBuffer::Part piece{mesh, makeMeshGeometry(*mesh, {}), std::nullopt};
    const ShownResult shown = show({0, 1, 1, 2});
    const ViewContent content = withPieces(shown, {piece}, Environment());
    QCOMPARE(content.walkable.size(), std::size_t{2});
    QCOMPARE(facesOf(*content.walkable[0]), (std::vector<int>{0, 2}));
    QCOMPARE(content.walkable[1], piece.geometry);
    // The shown content stays as it was.
    QCOMPARE(facesOf(*shown.content.walkable[0]), (std::vector<int>{0, 1, 1, 2}));
  }
};

QTEST_MAIN(TestProvisionalContent)
#include "test_provisional_content.moc"
