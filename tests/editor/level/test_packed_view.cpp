// Environments that are too large to be loaded: blocks by camera and heights, within a budget, and runs over a part.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProcess>
#include <cstring>
#include <fstream>

#include "core/io/import.hpp"
#include "core/io/packed/pack.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "tests/unit/first_packed_version.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/messages/status_line.hpp"
#include "ui/level/packed_feature.hpp"

using namespace footfall;
using namespace footfall::test;

namespace {

constexpr PackedLimits kTiny{.whole = 1000, .part = 20'000, .shown = 60'000};

Box boxAround(const std::array<Vec3, 3>& corners) {
  BlockFace face;
  face.corners = corners;
  return boxOf(face);
}

std::size_t shownTriangles(const Backdrop& backdrop) {
  std::size_t triangles = 0;
  for (const BackdropPiecePtr& piece : backdrop.loaded) triangles += piece->triangles();
  return triangles;
}

std::size_t shownCoarse(const Backdrop& backdrop) {
  std::size_t triangles = 0;
  for (const auto& [first, count] : backdrop.shownCoarse) triangles += count;
  return triangles;
}

}  // namespace

class TestPackedView : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    const QString obj = folder_.filePath("city.obj");
    QCOMPARE(QProcess::execute(QStringLiteral(FOOTFALL_BINARY_DIR "/footfall-samples"), {"city", "200000", obj}), 0);
    city_ = folder_.filePath("city.ffenv");
    packEnvironment(obj.toStdString(), city_.toStdString(), {}, nullptr);
    packed_ = std::make_unique<PackedEnvironment>(city_.toStdString());
    QVERIFY(packed_->faceCount() > 190'000 && packed_->blocks().size() > 10);
  }

  void init() {
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    window_->resize(1100, 800);
    QVERIFY(showWindow(*window_));
  }
  void cleanup() { window_.reset(); }

  void whatFitsOpensAsAnyOther() {
    window_->open(city_);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(window_->file().environment()->triangles.size(), std::size_t{packed_->faceCount()});
    QVERIFY(!window_->view().backdrop());
    QVERIFY(window_->packed().statusText().isEmpty());
    QVERIFY(!window_->findChild<QAction*>("pipeline.runHere")->isEnabled());
  }

  void aLargeOneIsCoarseAndAPartRuns() {
    openLarge();
    const auto level = window_->file().environment();
    QVERIFY(!level->triangles.empty() && level->triangles.size() <= kTiny.part);
    // Exports say that they are of a part.
    const QString source = QString::fromStdString(level->frame().source);
    QCOMPARE(source,
             QString("city.obj (a part: %1 of %2 triangles)").arg(level->triangles.size()).arg(packed_->faceCount()));
    QVERIFY(window_->controller().finishedRun());
    QVERIFY(partOf<MessageBar>(*window_).text().contains("city.ffenv has 0.201 million triangles"));
    // The picture is complete, and nothing is in it twice.
    const BackdropPtr backdrop = window_->view().backdrop();
    const PackedPart& part = *window_->file().loaded().part;
    QVERIFY(backdrop && shownCoarse(*backdrop) > 0);
    std::vector<bool> isShown(backdrop->coarse->triangles());
    for (const auto& [first, count] : backdrop->shownCoarse)
      for (std::size_t t = first; t < first + count; ++t) isShown[t] = true;
    const std::set<std::size_t> loaded = window_->packed().loadedBlocks();
    for (std::size_t b = 0; b < packed_->blocks().size(); ++b)
      for (std::size_t t = part.firstCoarse[b]; t < part.firstCoarse[b + 1]; ++t)
        QCOMPARE(isShown[t], !loaded.contains(b) && part.isCoarseInPart[t] == 0);
    // The whole of it is in sight and measures what it measures.
    const auto whole = importEnvironment(city_.toStdString());
    const auto geometry = makeEnvironmentGeometry(*whole);
    QVERIFY(window_->view().environmentGeometry()->lower == geometry->lower);
    QVERIFY(window_->view().environmentGeometry()->upper == geometry->upper);
    QVERIFY(window_->view().environmentGeometry()->centre == geometry->centre);
    shoot(*window_, "packed-opened");
  }

  void thePartHasAllThatTouchesIt() {
    openLarge();
    const PartPlace place = window_->file().loaded().part->place;
    const PackedFaces faces = packed_->facesTouching(boxOf(place));
    QCOMPARE(window_->file().environment()->triangles, faces.soup.triangles);
    QVERIFY(window_->file().environment()->vertices == faces.soup.vertices);
    QCOMPARE(window_->file().environment()->partOf, faces.partOf);
  }

  void blocksComeAndGoWithTheCamera() {
    openLarge();
    // Looks from above the corner that is the farthest from the part.
    const std::size_t corner = farthestBlock();
    const Box box = packed_->boxOf(corner);
    window_->view().cameraController().frame(pointOf(box.lower), pointOf(box.upper));
    QVERIFY(QTest::qWaitFor([&] { return window_->packed().loadedBlocks().contains(corner); }, kWaitMs));
    QVERIFY(waitUntilIdle(*window_));
    const std::set<std::size_t> near = window_->packed().loadedBlocks();
    QVERIFY(near.size() < packed_->blocks().size() - 1);
    QVERIFY(shownTriangles(*window_->view().backdrop()) <= kTiny.shown);
    std::uint64_t triangles = 0;
    for (const std::size_t block : near) triangles += packed_->blocks()[block].faces;
    QVERIFY(triangles <= kTiny.shown);
    QVERIFY2(window_->packed().statusText().startsWith(
                 QString("Coarse; in full: %1 of %2 blocks, ").arg(near.size()).arg(packed_->blocks().size())),
             qPrintable(window_->packed().statusText()));
    QVERIFY(window_->packed().statusText().endsWith(" of 0.201 million triangles"));
    shoot(*window_, "packed-corner");
    // From far away, no block is loaded.
    for (int i = 0; i < 12; ++i) window_->view().cameraController().zoomBy(0.5);
    QVERIFY(QTest::qWaitFor([&] { return window_->packed().loadedBlocks().empty(); }, kWaitMs));
    QVERIFY(window_->view().backdrop()->loaded.empty());
  }

  void heightsLeaveBlocksOut() {
    openLarge();
    QVERIFY(waitUntilIdle(*window_));
    const Box box = packed_->boxOf(farthestBlock());
    window_->view().cameraController().frame(pointOf(box.lower), pointOf(box.upper));
    QVERIFY(QTest::qWaitFor([&] { return window_->packed().loadedBlocks().contains(farthestBlock()); }, kWaitMs));
    HeightRange range;
    range.lower = box.upper[2] + 1;
    window_->view().setHeights(range);
    QVERIFY(QTest::qWaitFor([&] { return !window_->packed().loadedBlocks().contains(farthestBlock()); }, kWaitMs));
    window_->view().setHeights({});
    QVERIFY(QTest::qWaitFor([&] { return window_->packed().loadedBlocks().contains(farthestBlock()); }, kWaitMs));
  }

  void runsGoOverWhatIsLookedAt() {
    openLarge();
    const Vec3 before = window_->view().cameraController().pose().position;
    const PartPlace first = window_->file().loaded().part->place;
    const std::size_t corner = farthestBlock();
    const Box box = packed_->boxOf(corner);
    window_->view().cameraController().frame(pointOf(box.lower), pointOf(box.upper));
    QVERIFY(!(window_->view().cameraController().pose().position == before));
    QVERIFY(waitUntilIdle(*window_));
    const Vec3 middle = window_->view().placeInTheMiddle();
    const QPointF seen = onScreen(middle);
    QAction* here = window_->findChild<QAction*>("pipeline.runHere");
    QVERIFY(here->isEnabled());
    here->trigger();
    QVERIFY(waitUntilIdle(*window_));
    const PartPlace second = window_->file().loaded().part->place;
    QVERIFY(!(second == first));
    QCOMPARE(second.x, middle.x);
    QCOMPARE(second.y, middle.y);
    // The message has gone, and the view is larger: what was seen is still there on the screen.
    const QPointF moved = onScreen(middle) - seen;
    QVERIFY2(moved.manhattanLength() < 3, qPrintable(QString("%1, %2").arg(moved.x()).arg(moved.y())));
    QVERIFY(window_->file().environment()->triangles.size() <= kTiny.part);
    QCOMPARE(window_->file().environment()->triangles.size(),
             packed_->facesTouching(boxOf(second)).soup.triangles.size());
    QVERIFY(window_->controller().finishedRun());
    // The picture around the part has no triangles of the part.
    const Vec3 centre = window_->view().environmentGeometry()->centre;
    for (const BackdropPiecePtr& piece : window_->view().backdrop()->loaded)
      for (std::size_t t = 0; t < piece->triangles(); ++t) {
        std::array<Vec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
          const auto& p = piece->surface[3 * t + k].position;
          corners[k] = {p[0] + centre.x, p[1] + centre.y, p[2] + centre.z};
        }
        const Box face = boxAround(corners);
        constexpr double kRounded = 1e-3;  // floats
        const bool isOut =
            face.lower[0] > second.x + second.half - kRounded || face.upper[0] < second.x - second.half + kRounded ||
            face.lower[1] > second.y + second.half - kRounded || face.upper[1] < second.y - second.half + kRounded;
        QVERIFY(isOut);
      }
    shoot(*window_, "packed-moved");
  }

  void sessionsKnowThePart() {
    openLarge();
    const Box box = packed_->boxOf(farthestBlock());
    window_->view().cameraController().frame(pointOf(box.lower), pointOf(box.upper));
    QVERIFY(waitUntilIdle(*window_));
    window_->packed().runHere();
    QVERIFY(waitUntilIdle(*window_));
    const PartPlace place = window_->file().loaded().part->place;
    const QString session = folder_.filePath("city.session.json");
    window_->saveSession(session);
    QVERIFY(waitUntilIdle(*window_));
    EditorWindow other;
    other.setRemembering(false);
    other.file().setPackedLimits(kTiny);
    QVERIFY(showWindow(other));
    other.open(session);
    QVERIFY(QTest::qWaitFor(
        [&] { return other.file().loaded().part && other.file().loaded().part->place == place && other.idle(); },
        kWaitMs));
    QCOMPARE(other.file().environment()->triangles.size(), window_->file().environment()->triangles.size());
    QVERIFY(other.openedSession());
  }

  void damageIsTold() {
    const QString bad = folder_.filePath("bad.ffenv");
    QFile::remove(bad);
    QVERIFY(QFile::copy(city_, bad));
    openLarge();
    const std::size_t corner = farthestBlock();
    QVERIFY(!touchesPart(*window_->file().loaded().part, corner));
    {
      std::fstream file(bad.toStdString(), std::ios::in | std::ios::out | std::ios::binary);
      file.seekp(static_cast<std::streamoff>(packed_->blocks()[corner].offset + 1000));
      file.put('x').put('y').put('z');
    }
    window_->file().setPackedLimits({.whole = 1000, .part = 4000, .shown = 60'000});  // it needs no other blocks
    window_->open(bad);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(window_->file().path(), bad);
    const Box box = packed_->boxOf(corner);
    window_->view().cameraController().frame(pointOf(box.lower), pointOf(box.upper));
    QVERIFY(QTest::qWaitFor([&] { return partOf<MessageBar>(*window_).text().contains("is damaged"); }, kWaitMs));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY2(window_->controller().finishedRun(), qPrintable(partOf<MessageBar>(*window_).text()));
  }

  void filesOfTheFirstVersionAreBoxes() {
    const QByteArray bytes = firstPackedVersion(readFile(city_));
    window_->file().setPackedLimits(kTiny);
    window_->open(writeFile(folder_, "first.ffenv", bytes));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->view().backdrop());
    QCOMPARE(window_->view().backdrop()->coarse->triangles(), 12 * packed_->blocks().size());
    QVERIFY(window_->controller().finishedRun());
    shoot(*window_, "packed-first");
  }

  void aFileThatIsPackedAgainIsReadAgain() {
    const QString file = folder_.filePath("again.ffenv");
    QFile::remove(file);
    QVERIFY(QFile::copy(city_, file));
    window_->file().setPackedLimits(kTiny);
    window_->open(file);
    QVERIFY(waitUntilIdle(*window_));
    const auto before = window_->file().environment();
    const PartPlace place = window_->file().loaded().part->place;
    // A wall over the part.
    QByteArray obj = readFile(folder_.filePath("city.obj"));
    const Box box = boxOf(place);
    for (const double x : {box.lower[0], box.upper[0]})
      for (const double y : {0.0, 5.0})
        obj += "v " + QByteArray::number(x) + ' ' + QByteArray::number(y) + ' ' + QByteArray::number(-place.y) + '\n';
    obj += "f -4 -3 -1 -2\n";
    const QString changed = writeFile(folder_, "changed.obj", obj);
    packEnvironment(changed.toStdString(), file.toStdString(), {}, nullptr);
    QVERIFY(QTest::qWaitFor([&] { return partOf<MessageBar>(*window_).text().contains("read again"); }, kWaitMs));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->file().loaded().part->place == place);
    QCOMPARE(window_->file().environment()->triangles.size(), before->triangles.size() + 2);
    QCOMPARE(partOf<LevelComposer>(*window_).level()->triangles.size(), before->triangles.size() + 2);
    QVERIFY(window_->view().environmentGeometry()->whole);
    QCOMPARE(window_->file().loaded().part->environment->faceCount(), packed_->faceCount() + 2);
  }

  void anotherExtentIsSeen() {
    openCopy("farther.ffenv", kTiny);
    const Vec3 lower = window_->view().environmentGeometry()->lower,
               upper = window_->view().environmentGeometry()->upper;
    const Vec3 centre = window_->view().environmentGeometry()->centre;
    const auto coarse = window_->view().backdrop()->coarse;
    packWith("farther.ffenv", "v 5000 0 0\nv 5010 0 0\nv 5000 0 -10\nf -3 -2 -1\n");
    QVERIFY(QTest::qWaitFor([&] { return partOf<MessageBar>(*window_).text().contains("read again"); }, kWaitMs));
    QVERIFY(waitUntilIdle(*window_));
    const auto geometry = window_->view().environmentGeometry();
    QVERIFY(geometry->centre == centre && geometry->lower == lower);
    QCOMPARE(geometry->upper.x, 5010 - centre.x);
    QCOMPARE(geometry->upper.y, upper.y);
    QVERIFY(window_->view().backdrop()->coarse != coarse);
    shoot(*window_, "packed-farther");
  }

  void aFileThatGrowsBecomesAPart() {
    openCopy("grows.ffenv", {.whole = packed_->faceCount(), .part = 20'000, .shown = 60'000});
    QVERIFY(!window_->view().backdrop() && partOf<MessageBar>(*window_).text().isEmpty());
    packWith("grows.ffenv", "v 0 0 0\nv 10 0 0\nv 0 0 -10\nf -3 -2 -1\n");
    QVERIFY(QTest::qWaitFor([&] { return window_->file().loaded().part != nullptr; }, kWaitMs));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->view().backdrop());
    QVERIFY(window_->findChild<QAction*>("pipeline.runHere")->isEnabled());
    QVERIFY2(partOf<MessageBar>(*window_).text().contains("grows.ffenv has 0.201 million triangles"),
             qPrintable(partOf<MessageBar>(*window_).text()));
    QCOMPARE(partOf<LevelComposer>(*window_).level()->triangles.size(),
             window_->file().environment()->triangles.size());
    QVERIFY(window_->view().environmentGeometry()->whole);
    shoot(*window_, "packed-grown");
  }

  void whileAFileIsReadThePartStays() {
    openLarge();
    const PartPlace place = window_->file().loaded().part->place;
    const Box box = packed_->boxOf(farthestBlock());
    window_->view().cameraController().frame(pointOf(box.lower), pointOf(box.upper));
    window_->file().reread({});
    QVERIFY(window_->file().busy());
    window_->findChild<QAction*>("pipeline.runHere")->trigger();
    QVERIFY2(said().startsWith("A file is being read"), qPrintable(said()));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->file().loaded().part->place == place);
  }

  void otherPartsHaveTheSameSurface() {
    openLarge();
    const auto before = window_->file().loaded().part;
    const Box box = packed_->boxOf(farthestBlock());
    window_->view().cameraController().frame(pointOf(box.lower), pointOf(box.upper));
    QVERIFY(waitUntilIdle(*window_));
    window_->packed().runHere();
    QVERIFY(waitUntilIdle(*window_));
    const auto part = window_->file().loaded().part;
    QVERIFY(!(part->place == before->place));
    QVERIFY(part->coarse == before->coarse);
    QCOMPARE(part->firstCoarse, before->firstCoarse);
    QVERIFY(part->isCoarseInPart != before->isCoarseInPart);
    // The triangles of the part do not depend on an earlier part.
    RunContext context;
    const OpenedPart fresh = openPart(part->environment, kTiny, part->place, std::nullopt, context);
    QVERIFY(fresh.part.coarse != part->coarse && fresh.part.place == part->place);
    QCOMPARE(fresh.part.firstCoarse, part->firstCoarse);
    QCOMPARE(fresh.part.isCoarseInPart, part->isCoarseInPart);
  }

  // The part is as large as allowed, in steps of a seventh.
  void thePartIsAsLargeAsItMayBe() {
    const PartPlace asked{middle().x, middle().y, 1e6};
    const auto facesAt = [&](const PartPlace& place) {
      return packed_->facesTouching(boxOf(place)).soup.triangles.size();
    };
    int shrunk = 0;
    for (const std::size_t most : {20'000, 5000, 2000, 1000, 300, 100}) {
      RunContext context;
      const auto environment = std::make_shared<const PackedEnvironment>(city_.toStdString());
      const OpenedPart opened = openPart(environment, {.whole = 1000, .part = most}, asked, std::nullopt, context);
      PartPlace place = opened.part.place;
      const std::size_t count = opened.environment.triangles.size();
      QVERIFY(opened.part.isSmaller && count > 0 && count <= most);
      QCOMPARE(count, facesAt(place));
      place.half /= 0.85;
      shrunk += facesAt(place) > most ? 1 : 0;
    }
    QVERIFY(shrunk >= 4);  // else the blocks' boxes promised too much
  }

  void toolsSayThatTheyKnowThePart() {
    openLarge();
    const QString remark = "Only the part in the frame is known. ";
    for (const char* tool : {"inspect.why", "tools.path", "tools.measure"}) {
      QAction* action = window_->findChild<QAction*>(tool);
      QVERIFY2(action, tool);
      action->trigger();
      QVERIFY2(said().startsWith(remark) && said().size() > remark.size(), qPrintable(said()));
      shoot(*window_, QString("packed-") + tool);
      window_->view().setTool(nullptr);
      QVERIFY2(!said().contains(remark), qPrintable(said()));
    }
    QVERIFY(openZUp(*window_, writeFile(folder_, "table.obj", tableObj()), "SlopeFilter 45"));
    window_->findChild<QAction*>("inspect.why")->trigger();
    QVERIFY2(!said().isEmpty() && !said().contains(remark), qPrintable(said()));
  }

  void aWholeOneAfterALargeOne() {
    openLarge();
    QVERIFY(openZUp(*window_, writeFile(folder_, "table.obj", tableObj()), "SlopeFilter 45"));
    QVERIFY(!window_->view().backdrop());
    QVERIFY(window_->packed().statusText().isEmpty());
    QVERIFY(!window_->findChild<QAction*>("pipeline.runHere")->isEnabled());
  }

  void whatIsLargeOnTheScreenComesFirst() {
    SceneCamera camera;
    camera.viewport = {1000, 1000};  // The view spans -1 to 1 along x and y.
    const auto block = [](std::size_t number, double x, double size) {
      return BlockInView{number, 100, {{x, 0, 0}, {x + size, size, 0.1}}};
    };
    const std::vector<BlockInView> blocks{block(0, -0.9, 0.1),  block(1, 0, 0.5), block(2, -0.5, 0.3),
                                          block(3, -0.2, 0.19), block(4, 3, 0.5), block(5, 0.9, 0.13)};
    using Blocks = std::vector<std::size_t>;
    // 50 pixels are too few, and what is beside the view is not seen.
    QCOMPARE(chooseBlocks(blocks, camera, 1000, {}), (Blocks{1, 2, 3}));
    QCOMPARE(chooseBlocks(blocks, camera, 200, {}), (Blocks{1, 2}));
    QCOMPARE(chooseBlocks(blocks, camera, 1000, {5}), (Blocks{1, 2, 3, 5}));  // stays while it is a little smaller
    camera.clip.planes[0] = {1, 0, 0, 0};                                     // The remainder has x of at least 0.
    QCOMPARE(chooseBlocks(blocks, camera, 1000, {}), (Blocks{1}));
  }

 private:
  [[nodiscard]] QPointF onScreen(const Vec3& place) const {
    return window_->view().mapToGlobal(window_->view().project(place).value_or(QPointF()));
  }
  static Vec3 pointOf(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }

  void openLarge() {
    window_->file().setPackedLimits(kTiny);
    window_->open(city_);
    QVERIFY(QTest::qWaitFor([&] { return window_->file().loaded().part != nullptr; }, kWaitMs));
    QVERIFY(waitUntilIdle(*window_));
  }

  /// A copy of the city, which is then open.
  void openCopy(const QString& name, const PackedLimits& limits) {
    const QString file = folder_.filePath(name);
    QFile::remove(file);
    QVERIFY(QFile::copy(city_, file));
    window_->file().setPackedLimits(limits);
    window_->open(file);
    QVERIFY(waitUntilIdle(*window_));
  }
  /// The city with more in it takes the copy's place.
  void packWith(const QString& name, const QByteArray& more) {
    const QString changed = writeFile(folder_, "changed.obj", readFile(folder_.filePath("city.obj")) + more);
    packEnvironment(changed.toStdString(), folder_.filePath(name).toStdString(), {}, nullptr);
  }
  [[nodiscard]] QString said() const { return partOf<StatusLine>(*window_).text(); }

  /// The block farthest from the part, among those that are no larger than others.
  [[nodiscard]] std::size_t farthestBlock() const {
    const PartPlace place = middle();
    std::size_t found = 0;
    double farthest = -1;
    for (std::size_t b = 0; b < packed_->blocks().size(); ++b) {
      const Box box = packed_->boxOf(b);
      const double away =
          std::hypot(box.lower[0] / 2 + box.upper[0] / 2 - place.x, box.lower[1] / 2 + box.upper[1] / 2 - place.y);
      if (away <= farthest || box.upper[0] - box.lower[0] > place.half) continue;
      farthest = away;
      found = b;
    }
    return found;
  }
  [[nodiscard]] PartPlace middle() const {
    Box all = packed_->boxOf(0);
    for (std::size_t b = 0; b < packed_->blocks().size(); ++b)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        all.lower[axis] = std::min(all.lower[axis], packed_->boxOf(b).lower[axis]);
        all.upper[axis] = std::max(all.upper[axis], packed_->boxOf(b).upper[axis]);
      }
    return {(all.lower[0] + all.upper[0]) / 2, (all.lower[1] + all.upper[1]) / 2, (all.upper[0] - all.lower[0]) / 2};
  }

  QTemporaryDir folder_;
  QString city_;
  std::unique_ptr<PackedEnvironment> packed_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestPackedView)
#include "test_packed_view.moc"
