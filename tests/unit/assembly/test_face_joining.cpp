// Faces that meet where very much is near: everything that lies on an outline is found all the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include "tests/reference/comparison.hpp"
#include "tests/support/run_filters.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using namespace footfall::test;
using namespace footfall::reference;

namespace {

/// Empty when all triangles share whole edges, and are connected as in the reference.
std::string findJoiningError(const Soup& soup) {
  const StatePtr state = runFilters(soup.environment(), minimalPipeline(1));
  const auto pieces = toPieces(exactWalkableTriangles(*state));
  if (std::string error = findConformityError(pieces); !error.empty()) return error;
  const NavigationMesh mesh = navigationMesh(state);
  if (std::string error = findMeshError(mesh); !error.empty()) return error;
  const std::size_t found = test::countParts(mesh), expected = reference::countParts(connectedParts(pieces));
  return found == expected ? std::string() : std::to_string(found) + " parts instead of " + std::to_string(expected);
}

/// A floor of 16 x 16 with rows and columns of low boxes on it; their insides are not walkable.
Soup floorWithBoxes(int rows) {
  const double step = 16.0 / rows;
  Soup soup;
  soup.floor(0, 0, 16, 16, 0);
  for (int x = 0; x < rows; ++x)
    for (int y = 0; y < rows; ++y) {
      const double left = (x + 0.25) * step, front = (y + 0.25) * step;
      soup.box({left, front, 0}, {left + step / 2, front + step / 2, 0.5});
    }
  return soup;
}

/// Triangles around the middle of a square of 16 x 16, so many at each of its sides; between them nothing, or `gap`
/// times their width.
Soup fan(double x, double y, double z, int perSide, int gap = 0) {
  Soup soup;
  const Vec3 middle{x + 8, y + 8, z};
  const double length = 16.0 / perSide;
  for (int i = 0; i < perSide; ++i) {
    const double from = i * length, to = from + length / (gap + 1);
    soup.triangle(middle, {x + from, y, z}, {x + to, y, z})
        .triangle(middle, {x + 16, y + from, z}, {x + 16, y + to, z});
    soup.triangle(middle, {x + to, y + 16, z}, {x + from, y + 16, z})
        .triangle(middle, {x, y + to, z}, {x, y + from, z});
  }
  return soup;
}

/// Narrow floors that end at the sides of a square of 16 x 16.
Soup floorsAround() {
  Soup soup;
  for (int i = 0; i < 64; ++i) {
    const double from = i / 4.0, to = from + 0.25;
    soup.floor(16, from, 18, to, 0).floor(from, 16, to, 17, 0);
  }
  return soup;
}

}  // namespace

class TestFaceJoining : public QObject {
  Q_OBJECT
 private slots:
  // Each of the floor's two triangles has hundreds of outlines; narrow floors end on two of its edges.
  void atAFloorWithManyOutlines() {
    for (const int rows : {3, 8, 14}) {
      Soup soup = floorWithBoxes(rows);
      QCOMPARE(findJoiningError(soup.add(floorsAround())), std::string());
    }
  }

  // The same where what covers the floor leaves rays between: hundreds of outlines end at one place.
  void atAFloorOfRays() {
    for (const int perSide : {4, 16, 40}) {
      Soup soup = fan(0, 0, 0.5, perSide, 3);
      QCOMPARE(findJoiningError(soup.floor(0, 0, 16, 16, 0).add(floorsAround())), std::string());
    }
  }

  // Many triangles have one corner in common, and their other ends lie on the long edges of a floor, whole or cut.
  void atAFan() {
    for (const int perSide : {3, 16, 48})
      for (const int rows : {0, 1, 8}) {
        Soup soup = fan(16, 0, 0, perSide);
        soup.add(rows == 0 ? Soup().floor(0, 0, 16, 16, 0) : floorWithBoxes(rows));
        soup.floor(16, 16, 32, 20, 0).floor(15, -4, 40, 0, 0);
        QCOMPARE(findJoiningError(soup), std::string());
      }
  }
};

QTEST_APPLESS_MAIN(TestFaceJoining)
#include "test_face_joining.moc"
