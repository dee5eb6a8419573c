// The drawing of the view, and the program's screenshots.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProcess>
#include <cmath>

#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/run/provisional_content.hpp"
#include "ui/view/widgets/height_slider.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// Hue and saturation survive the shading; lightness does not.
bool looksLike(const QColor& pixel, const QColor& paint) {
  const int hue = std::abs(pixel.hsvHue() - paint.hsvHue());
  return std::min(hue, 360 - hue) < 12 && std::abs(pixel.hsvSaturationF() - paint.hsvSaturationF()) < 0.15F;
}

double shareOf(const QImage& image, const QColor& paint) {
  qint64 count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) count += looksLike(image.pixelColor(x, y), paint) ? 1 : 0;
  }
  return static_cast<double>(count) / (static_cast<double>(image.width()) * image.height());
}

struct Ended {
  int code = -1;
  QByteArray error;
};

Ended runProgram(const QStringList& arguments, const QProcessEnvironment& environment) {
  QProcess process;
  process.setProcessEnvironment(environment);
  process.start(FOOTFALL_EDITOR_PROGRAM, arguments);
  if (!process.waitForFinished(60000)) return {};
  QByteArray error = process.readAllStandardError();
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2, error};
}

QProcessEnvironment quietEnvironment(const QTemporaryDir& folder) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("XDG_RUNTIME_DIR", folder.path());  // Qt prints a warning without it
  return environment;
}

}  // namespace

class TestLevelView : public QObject {
  Q_OBJECT

 private slots:
  void walkableAreaCoversWhatItShould() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1000, 800);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "table.obj", tableObj()), "SlopeFilter 45\nVerticalClearanceFilter 2\n"));
    window.view().cameraController().viewFromTop();
    const QImage picture = window.view().grabFramebuffer();
    // The floor and the table top are walkable, the ramp beside them is not; the rest is background.
    const double walkable = shareOf(picture, walkablePaint().colour);
    QVERIFY2(walkable > 0.2 && walkable < 0.7, qPrintable(QString::number(walkable)));
    QVERIFY(shareOf(picture, removalStyle(FilterType::Slope)->paint.colour) > 0.002);
    const QColor corner = picture.pixelColor(3, 3);
    QVERIFY(corner.lightness() > 200);
    QVERIFY(!looksLike(corner, walkablePaint().colour));

    SceneParts parts;
    parts.walkable = false;
    window.view().setParts(parts);
    QVERIFY(shareOf(window.view().grabFramebuffer(), walkablePaint().colour) < 0.01);
  }

  void obstacleEdgesAreSeenAtEveryHeight() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1000, 800);
    QVERIFY(showWindow(window));
    // Two floors, at the heights -3 and 3, each with a wall across its middle.
    QByteArray text;
    for (const int z : {-3, 3}) {
      for (const char* corner : {"-4 -4 ", "4 -4 ", "4 4 ", "-4 4 "})
        text += "v " + QByteArray(corner) + QByteArray::number(z) + '\n';
      for (const int x : {-3, 3}) {
        for (const int up : {0, 1}) {
          text += "v " + QByteArray::number(x) + (z < 0 ? " -2 " : " 2 ") + QByteArray::number(z + up) + '\n';
        }
      }
    }
    text += "f 1 2 3 4\nf 5 7 8 6\nf 9 10 11 12\nf 13 15 16 14\n";
    QVERIFY(openZUp(window, writeFile(folder, "walls.obj", text), "SlopeFilter 45\nVerticalClearanceFilter 2\n"));
    SceneParts parts;
    parts.environment = parts.walkable = parts.removed = false;
    window.view().setParts(parts);
    window.view().cameraController().viewFromTop();
    const QImage picture = window.view().grabFramebuffer();
    const QImage lower = picture.copy(0, picture.height() / 2, picture.width(), picture.height() / 2);
    const QImage upper = picture.copy(0, 0, picture.width(), picture.height() / 2);
    QVERIFY(shareOf(lower, obstacleEdgeColour()) > 0.001);
    QVERIFY(shareOf(upper, obstacleEdgeColour()) > 0.001);
  }

  void theCutLooksUnderRoofs() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1000, 800);
    QVERIFY(showWindow(window));
    // A walkable floor under a roof that faces down only: grey from above.
    const QByteArray roof = "v -4 -4 5\nv -4 4 5\nv 4 4 5\nv 4 -4 5\nf 5 6 7 8\n";
    QVERIFY(openZUp(window, writeFile(folder, "roof.obj", floorObj() + roof), "SlopeFilter 45\n"));
    window.view().cameraController().viewFromTop();
    QVERIFY(shareOf(window.view().grabFramebuffer(), walkablePaint().colour) > 0.2);  // the roof has no upper side
    window.view().setInside(false);
    QVERIFY(shareOf(window.view().grabFramebuffer(), walkablePaint().colour) < 0.01);
    partOf<HeightSlider>(window).setRange({.upper = 2.5});
    QVERIFY(shareOf(window.view().grabFramebuffer(), walkablePaint().colour) > 0.2);
  }

  void placesUnderTheTableShowWhy() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1000, 800);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "table.obj", tableObj()), "SlopeFilter 45\nVerticalClearanceFilter 2\n"));
    QCOMPARE(window.view().content().removed.size(), std::size_t{1});
    const ViewContent::Removed& removed = window.view().content().removed[0];
    QVERIFY(removed.style == removalStyle(FilterType::VerticalClearance));
    // The area that was walkable before shows through in the colour of its filter where the table is removed.
    CameraPose low;
    low.position = {0, -12, 0.8};
    low.pivot = {0, 0, 0};
    low.orientation = {std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
    window.view().cameraController().setPose(low);
    QVERIFY(shareOf(window.view().grabFramebuffer(), removed.style->paint.colour) > 0.0005);
  }

  void whatAnEditTakesAwayShowsBeforeTheResult() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1000, 800);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "table.obj", tableObj()), "SlopeFilter 70\nVerticalClearanceFilter 2\n"));
    window.view().cameraController().viewOblique();
    const QColor brown = removalStyle(FilterType::Slope)->paint.colour;
    QVERIFY(shareOf(window.view().grabFramebuffer(), brown) < 0.001);
    const ViewContent result = window.view().content();
    const QImage finished = window.view().grabFramebuffer();
    NavigationMesh ramp;
    ramp.vertices = window.file().environment()->vertices;
    ramp.triangles = {window.file().environment()->triangles[4], window.file().environment()->triangles[5]};
    const Vec3 centre = makeEnvironmentGeometry(*window.file().environment())->centre;
    ViewContent edited = result;
    edited.changes = changedTriangles(ramp, {}, removalStyle(FilterType::Slope)->paint, centre);
    window.view().setContent(edited);
    QVERIFY(shareOf(window.view().grabFramebuffer(), brown) > 0.005);
    // The kept picture has no trace of it.
    window.view().setContent(result);
    QCOMPARE(window.view().grabFramebuffer(), finished);
    // The same content made anew is drawn anew, onto the picture of the environment that is kept.
    ViewContent copied = result;
    for (auto& mesh : copied.walkable) mesh = std::make_shared<NavigationMeshGeometry>(*mesh);
    for (auto& removed : copied.removed) removed.before = std::make_shared<NavigationMeshGeometry>(*removed.before);
    window.view().setContent(copied);
    QCOMPARE(window.view().grabFramebuffer(), finished);
    // A surface that reappears lies over the change that removed it.
    edited.changes.push_back(makeMeshGeometry(ramp, centre, walkablePaint()));
    window.view().setContent(edited);
    QVERIFY(shareOf(window.view().grabFramebuffer(), brown) < 0.001);
  }

  void mapCoordinatesDoNotTremble() {
    const double east = 122000.123;
    const double north = 487000.456;
    Environment environment;
    environment.vertices = {{east, north, 0}, {east + 0.001, north, 0}, {east, north + 0.001, 0}};
    environment.triangles = {{0, 1, 2}};
    const auto geometry = makeEnvironmentGeometry(environment);
    const auto& a = geometry->surface[0].position;
    const auto& b = geometry->surface[1].position;
    QVERIFY(std::abs(static_cast<double>(b[0]) - a[0] - 0.001) < 1e-9);
  }

  void layersHaveDistinctColours() {
    for (std::uint32_t i = 0; i < 18; ++i) {
      for (std::uint32_t k = 0; k < i; ++k) QVERIFY(layerPaint(i).colour != layerPaint(k).colour);
    }
  }

  void mouseTurnsMovesAndZooms() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1000, 800);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "floor.obj", floorObj()), "SlopeFilter 45\n"));
    LevelView& view = window.view();
    const QPoint middle = view.rect().center();
    const auto drag = [&](Qt::MouseButton button) {
      QTest::mousePress(&view, button, Qt::NoModifier, middle);
      QMouseEvent move(QEvent::MouseMove, middle + QPoint(60, 10), view.mapToGlobal(middle + QPoint(60, 10)),
                       Qt::NoButton, button, Qt::NoModifier);
      QCoreApplication::sendEvent(&view, &move);
      QTest::mouseRelease(&view, button, Qt::NoModifier, middle + QPoint(60, 10));
    };
    const CameraPose start = view.cameraController().pose();
    drag(Qt::LeftButton);
    const CameraPose turned = view.cameraController().pose();
    QVERIFY(turned.orientation != start.orientation);
    drag(Qt::RightButton);
    const CameraPose moved = view.cameraController().pose();
    QCOMPARE(moved.orientation, turned.orientation);
    QVERIFY(!(moved.position == turned.position));
    QTest::keyClick(&window, Qt::Key_T);
    QVERIFY(view.cameraController().pose().orthographic);
    QTest::keyClick(&window, Qt::Key_O);
    const CameraPose oblique = view.cameraController().pose();
    QVERIFY(!oblique.orthographic);
    QTest::keyClick(&window, Qt::Key_Plus);
    QVERIFY(!(view.cameraController().pose().position == oblique.position));
    QTest::keyClick(&window, Qt::Key_F);
    QVERIFY(std::abs(view.cameraController().pose().position.x - oblique.position.x) < 1e-9);
  }

  void largeLevelsStayFluid() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1440, 900);
    QVERIFY(showWindow(window));
    QVERIFY(openZUp(window, writeFile(folder, "waves.obj", wavesObj(174)), "SlopeFilter 45\n"));  // 60,552 triangles
    window.view().grabFramebuffer();  // the first one uploads
    window.view().grabFramebuffer();
    const double whole = window.view().lastFrameMs();
    double sum = 0;
    constexpr int kFrames = 10;
    for (int i = 0; i < kFrames; ++i) {
      window.view().cameraController().zoomBy(1.01);
      window.view().grabFramebuffer();
      sum += window.view().lastFrameMs();
    }
    qInfo("60,552 triangles, %d x %d pixels: %.1f ms a frame in motion, %.1f ms the whole picture",
          window.view().width(), window.view().height(), sum / kFrames, whole);
    QVERIFY(sum / kFrames < 400);  // far above what it takes: a busy machine is no failure
  }

  void screenshotsShowTheResult() {
    const QTemporaryDir folder;
    const QString picture = folder.filePath("picture.png");
    const QString pipeline = writeFile(folder, "test.pipeline", "SlopeFilter 45\n");
    const Ended ended = runProgram({writeFile(folder, "floor.obj", floorObj()), "-p", pipeline, "--up", "z",
                                    "--screenshot", picture, "--size", "900x700", "--view", "top"},
                                   quietEnvironment(folder));
    QCOMPARE(ended.error, QByteArray());
    QCOMPARE(ended.code, 0);
    const QImage image(picture);
    QCOMPARE(image.size(), QSize(900, 700));
    QVERIFY(shareOf(image, walkablePaint().colour) > 0.15);
  }

  void screenshotsShowCellsAndTimeline() {
    const QTemporaryDir folder;
    const QString picture = folder.filePath("picture.png");
    const QString pipeline = writeFile(folder, "test.pipeline", "GridStrategy 2 1\nSlopeFilter 45\nCollapse\n");
    const QStringList arguments{writeFile(folder, "floor.obj", floorObj()),
                                "-p",
                                pipeline,
                                "--up",
                                "z",
                                "--screenshot",
                                picture,
                                "--size",
                                "1100x800",
                                "--view",
                                "top"};
    const Ended ended = runProgram(arguments + QStringList{"--show", "cells,timeline", "--cell-colours", "triangles"},
                                   quietEnvironment(folder));
    QCOMPARE(ended.error, QByteArray());
    QCOMPARE(ended.code, 0);
    // Both cells have as many triangles, and what lies under the colour takes a little of its saturation.
    const QImage image(picture);
    int purple = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const QColor pixel = image.pixelColor(x, y);
        purple += std::abs(pixel.hsvHue() - scaleColour(1).hsvHue()) < 12 && pixel.hsvSaturation() > 100 ? 1 : 0;
      }
    }
    QVERIFY2(purple > image.width() * image.height() / 50, qPrintable(QString::number(purple)));
    QCOMPARE(runProgram(arguments + QStringList{"--show", "nonsense"}, quietEnvironment(folder)).code, 2);
  }

  void screenshotsTakeSessions() {
    const QTemporaryDir folder;
    writeFile(folder, "floor.obj", floorObj());
    const QString session =
        writeFile(folder, "work.footfall",
                  "{\"footfall_session\": 1, \"environment\": \"floor.obj\", \"import\": {\"up\": \"z\"},"
                  "\"pipeline\": [{\"filter\": \"SlopeFilter\"}]}");
    const QString picture = folder.filePath("picture.png");
    const Ended ended = runProgram({session, "--screenshot", picture, "--size", "1400x900"}, quietEnvironment(folder));
    QCOMPARE(ended.error, QByteArray());
    QCOMPARE(ended.code, 0);
    QVERIFY(shareOf(QImage(picture), walkablePaint().colour) > 0.1);
    const QString empty = writeFile(folder, "empty.footfall", "{\"footfall_session\": 1, \"pipeline\": []}");
    QCOMPARE(runProgram({empty, "--screenshot", picture}, quietEnvironment(folder)).code, 2);
  }

  void problemsAreOneLineAndCodeTwo_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<bool>("display");
    QTest::newRow("missing file") << QStringList{"/no/such.obj", "--screenshot", "x.png"} << true;
    QTest::newRow("missing pipeline") << QStringList{"/no/such.obj", "-p", "/no/such.pipeline"} << true;
    QTest::newRow("no environment") << QStringList{"--screenshot", "x.png"} << true;
    QTest::newRow("bad size") << QStringList{"a.obj", "--screenshot", "x.png", "--size", "9x"} << true;
    QTest::newRow("bad option") << QStringList{"--nonsense"} << true;
    QTest::newRow("no display") << QStringList{} << false;
  }
  void problemsAreOneLineAndCodeTwo() {
    QFETCH(QStringList, arguments);
    QFETCH(bool, display);
    const QTemporaryDir folder;
    QProcessEnvironment environment = quietEnvironment(folder);
    if (!display) {
      for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) environment.remove(name);
    }
    const Ended ended = runProgram(arguments, environment);
    QCOMPARE(ended.code, 2);
    QCOMPARE(ended.error.count('\n'), 1);
    QVERIFY(ended.error.startsWith("footfall-editor: "));
  }
};

FOOTFALL_EDITOR_SUITE(TestLevelView)
#include "test_level_view.moc"
