// Shares as bytes: what is written is read again, and whatever else the bytes are is refused.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "core/distributed/cell_share.hpp"
#include "core/distributed/share_file.hpp"

using namespace footfall::detail;

namespace {

const ShareRange kRange{100, 50, 2, 3};

PlanLine edge(Index a, Index b) { return {PlanLine::Edge, a, b}; }
PlanLine trace(Index triangle, Index level) { return {PlanLine::Trace, triangle, level}; }

CellShare someShare() {
  auto cuts = std::make_shared<FaceCuts>();
  cuts->edgeWalls = 5;
  cuts->startWinding = 2;
  cuts->dependsOnFloors = true;
  cuts->lines = {edge(3, 99), trace(49, -2)};
  cuts->points = {PlanPoint::source(7), PlanPoint::edgePlane(9, 4, 20, 1),
                  PlanPoint::crossing(edge(1, 2), trace(3, 2), 5), PlanPoint::crossing(edge(1, 2), edge(5, 6), -1)};
  cuts->borders = {0, 3, 7, 1};
  cuts->segments = {{0, 1, 0, 1, -3, false}, {2, 3, 1, -1, 0, true}};
  auto mesh = std::make_shared<FaceMesh>();
  mesh->lines = {edge(3, 99)};
  mesh->points = {PlanPoint::source(1), PlanPoint::source(2), PlanPoint::source(3), PlanPoint::source(4)};
  mesh->approximate = {{1, 2, 0.5}, {-1, 1e300, 0}, {0, -0.0, 3}, {4, 5, 6}};
  mesh->facets.resize(2);
  mesh->facets[0] = {{0, 1, 2}, 4, 2, {-1, 0, 2}, {-1, 0, 0}};
  mesh->facets[1] = {{3, 2, 1}, 0, 7, {1, -1, -1}, {0, 0, 0}};
  auto removed = std::make_shared<FaceCuts>();
  removed->removed = true;
  CellShare share;
  share.faces = {{12, cuts, mesh}, {13, removed, nullptr}};
  FacePart& part = share.parts.emplace_back();
  part.face = 49;
  part.share.startWinding = -1;
  part.share.points = {PlanPoint::source(0)};
  part.share.borders = {1};
  part.share.lines = {trace(0, 0)};
  part.share.segments = {{0, 0, 0, 1, 1, false}};
  part.share.pieces = {{8, {-1, 0, 0, 1, 2, true}}, {8, {-1, -1, 0, 1, 2, false}}};
  share.times = {3, 1.5, 2.5, {{0, 1, 1.5, 2}, {2, 3, 2, 2.5}}};
  return share;
}

std::string bytes() { return encodeCellShare(someShare()); }

/// The message of BadBytes; empty: it was read.
std::string refusal(const std::function<void()>& read) {
  try {
    read();
    return {};
  } catch (const BadBytes& error) {
    return error.what();
  }
}

std::string refusal(const CellShare& share) {
  return refusal([&] { decodeCellShare(encodeCellShare(share), kRange); });
}

template <class Change>
std::string refusalOfCuts(const Change& change) {
  CellShare share = someShare();
  auto cuts = std::make_shared<FaceCuts>(*share.faces[0].cuts);
  change(*cuts);
  share.faces[0].cuts = cuts;
  return refusal(share);
}

template <class Change>
std::string refusalOfMesh(const Change& change) {
  CellShare share = someShare();
  auto mesh = std::make_shared<FaceMesh>(*share.faces[0].mesh);
  change(*mesh);
  share.faces[0].mesh = mesh;
  return refusal(share);
}

}  // namespace

class TestCellShare : public QObject {
  Q_OBJECT

 private slots:
  void isReadAgain() {
    const CellShare share = decodeCellShare(bytes(), kRange);
    QCOMPARE(share.faces.size(), std::size_t{2});
    QCOMPARE(share.faces[0].face, 12);
    const FaceCuts& cuts = *share.faces[0].cuts;
    const CellShare original = someShare();
    const FaceCuts& before = *original.faces[0].cuts;
    QVERIFY(!cuts.removed && cuts.dependsOnFloors && cuts.edgeWalls == 5 && cuts.startWinding == 2);
    QCOMPARE(share.parts[0].share.startWinding, -1);
    QVERIFY(cuts.points == before.points && cuts.borders == before.borders && cuts.lines == before.lines);
    QCOMPARE(cuts.segments[1].direction, std::int8_t{-1});
    QCOMPARE(cuts.segments[0].winding, -3);
    QVERIFY(cuts.segments[1].wall && !cuts.segments[0].wall);
    const FaceMesh& mesh = *share.faces[0].mesh;
    QVERIFY(mesh.points == original.faces[0].mesh->points && mesh.lines == original.faces[0].mesh->lines);
    QCOMPARE(mesh.approximate[1].y, 1e300);
    QVERIFY(std::signbit(mesh.approximate[2].y));
    QVERIFY(mesh.facets[0].corners == (std::array<Index, 3>{0, 1, 2}) && mesh.facets[1].lines[2] == 0);
    QVERIFY(mesh.facets[0].obstacleEdges == 4 && mesh.facets[0].outlineEdges == 2 && mesh.facets[0].faceEdges[0] == -1);
    QVERIFY(share.faces[1].cuts->removed && share.faces[1].mesh == nullptr);
    QCOMPARE(share.parts[0].share.pieces[0].segment.from, -1);
    QCOMPARE(share.parts[0].share.pieces[1].obstacle, 8);
    QCOMPARE(share.times.spans[1].filter, std::size_t{2});
    QCOMPARE(share.times.endMs, 2.5);
    QVERIFY(encodeCellShare(share) == bytes());
  }

  // Each rule by itself.
  void numbersOutOfRangeAreRefused() {
    QVERIFY(refusal(someShare()).empty());
    CellShare share = someShare();
    share.faces[0].face = 50;
    QCOMPARE(refusal(share), std::string("a number is out of range"));
    share = someShare();
    FaceMesh mesh = *share.faces[0].mesh;
    mesh.facets[1].lines[2] = -1;
    share.faces[0].mesh = std::make_shared<const FaceMesh>(std::move(mesh));
    QCOMPARE(refusal(share), std::string("an outline has no line"));
    share = someShare();
    share.faces[1].face = 12;
    QCOMPARE(refusal(share), std::string("a floor is there twice"));
    share = someShare();
    share.faces[1].face = 49;  // Face 49 has a part.
    QCOMPARE(refusal(share), std::string("a floor is there twice"));
    share = someShare();
    share.parts.push_back(share.parts[0]);
    QCOMPARE(refusal(share), std::string("a floor is there twice"));
    share = someShare();
    share.parts[0].share.pieces[0].obstacle = 50;
    QCOMPARE(refusal(share), std::string("a number is out of range"));
    share = someShare();
    share.times.spans[0].filter = 3;
    QCOMPARE(refusal(share), std::string("a number is out of range"));
    share = someShare();
    share.times.startMs = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(refusal(share), std::string("a number is not finite"));
    QCOMPARE(refusalOfCuts([](FaceCuts& cuts) { cuts.points[0] = PlanPoint::source(100); }),
             std::string("a number is out of range"));
    QCOMPARE(refusalOfCuts([](FaceCuts& cuts) { cuts.points[1] = PlanPoint::edgePlane(9, 4, 20, 3); }),
             std::string("a level is out of range"));
    QCOMPARE(refusalOfCuts([](FaceCuts& cuts) { cuts.points[1] = PlanPoint::edgePlane(9, 9, 20, 1); }),
             std::string("an edge has one end"));
    QCOMPARE(refusalOfCuts([](FaceCuts& cuts) { cuts.points[2] = PlanPoint::crossing(edge(1, 2), trace(3, 2), -1); }),
             std::string("a trace has no face"));
    QCOMPARE(refusalOfCuts([](FaceCuts& cuts) { cuts.points[2] = PlanPoint::crossing(edge(1, 2), edge(1, 2), 5); }),
             std::string("a line crosses itself"));
    QCOMPARE(refusalOfCuts([](FaceCuts& cuts) { cuts.lines[0] = edge(4, 4); }),
             std::string("an edge has no second end"));
    QCOMPARE(refusalOfCuts([](FaceCuts& cuts) {
               cuts.lines[0] = {PlanLine::Border, 0, 1};
             }),
             std::string("a number is out of range"));
    QCOMPARE(refusalOfCuts([](FaceCuts& cuts) { cuts.segments[0].to = -1; }), std::string("a segment has no end"));
    QCOMPARE(refusalOfCuts([](FaceCuts& cuts) { cuts.segments[0].line = 2; }), std::string("a number is out of range"));
    QCOMPARE(refusalOfCuts([](FaceCuts& cuts) { cuts.segments.clear(); }),
             std::string("a winding number has no segments"));
    QCOMPARE(refusalOfMesh([](FaceMesh& mesh) { mesh.facets[1].corners[1] = 4; }),
             std::string("a number is out of range"));
    QCOMPARE(refusalOfMesh([](FaceMesh& mesh) { mesh.facets[1].lines[1] = 1; }),
             std::string("a number is out of range"));
    QCOMPARE(refusalOfMesh([](FaceMesh& mesh) {
               mesh.points.resize(2);
               mesh.facets.clear();
             }),
             std::string("a face has no corners"));
  }

  void whatEndsEarlyOrLateIsRefused() {
    const std::string whole = bytes();
    for (std::size_t size = 0; size < whole.size(); ++size)
      QVERIFY(!refusal([&] { decodeCellShare(std::string_view(whole).substr(0, size), kRange); }).empty());
    QCOMPARE(refusal([&] { decodeCellShare(whole + '\0', kRange); }), std::string("there are bytes behind the end"));
  }

  // A list that claims to be long must not be made room for.
  void longListsAreRefused() {
    ByteWriter out;
    out.number(std::uint64_t{1} << 62);
    QCOMPARE(refusal([&] { decodeCellShare(out.bytes, kRange); }), std::string("a list is longer than the bytes"));
    const std::string endless(20, '\xff');
    QCOMPARE(refusal([&] { decodeCellShare(endless, kRange); }), std::string("a number is too long"));
  }

  void anyByteThatChangesInASealedShareIsSeen() {
    const ShareName name{{1, 2}, 3, 4};
    const std::string sealed = sealShare(name, bytes());
    QCOMPARE(sealed.size(), bytes().size() + kShareHead);
    QVERIFY(openShare(sealed).name == name);
    QVERIFY(openShare(sealed).bytes == bytes());
    for (std::size_t i = 0; i < sealed.size(); ++i) {
      for (const char bit : {'\x01', '\x80'}) {
        std::string damaged = sealed;
        damaged[i] = static_cast<char>(damaged[i] ^ bit);
        const std::string told = refusal([&] { openShare(damaged); });
        QVERIFY2(!told.empty(), qPrintable(QString::number(i)));
        if (i < 8) QCOMPARE(told, std::string("is no share"));
        if (i >= 8 && i < 16) QCOMPARE(told, std::string("is of another version"));
      }
    }
    for (std::size_t size = 0; size < sealed.size(); ++size) {
      const std::string told = refusal([&] { openShare(std::string_view(sealed).substr(0, size)); });
      QCOMPARE(told, std::string(size < 8 ? "is no share" : "is cut off"));
    }
    QCOMPARE(refusal([&] { openShare(sealed + 'x'); }), std::string("is damaged"));
  }
};

QTEST_APPLESS_MAIN(TestCellShare)
#include "test_cell_share.moc"
