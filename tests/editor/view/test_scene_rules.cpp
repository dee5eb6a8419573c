// Visible things are the pickable ones, each switch governs what it names, and drawing leaves no OpenGL state behind.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/house_obj.hpp"
#include "ui/level/level_look.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline =
    "SlopeFilter 45\nVerticalClearanceFilter 2\nSimplificationFilter\nLayerSubdivisionFilter\n";

/// The table and the ramp, with a second storey over x > 0 (a slab 0.5 thick), over a part of it a ceiling that faces
/// down only, and a wall that faces +x. The upper floor and the one below are two triangles each.
QByteArray storeysObj() {
  return tableObj() +
         "v 0 -4 3\nv 4 -4 3\nv 4 4 3\nv 0 4 3\nf 13 14 15\nf 13 15 16\n"
         "v 0 -4 2.5\nv 4 -4 2.5\nv 4 4 2.5\nv 0 4 2.5\nf 17 19 18\nf 17 20 19\n"
         "v 1 1 6\nv 4 1 6\nv 4 4 6\nv 1 4 6\nf 21 24 23 22\n"
         "v -4 -4 0\nv -4 4 0\nv -4 4 4\nv -4 -4 4\nf 25 26 27 28\n";
}

/// All that may be left behind, by name.
std::vector<std::pair<const char*, std::vector<double>>> stateNow() {
  auto* gl = QOpenGLContext::currentContext()->functions();
  const auto get = [&](GLenum name, std::size_t count = 1) {
    std::vector<double> values(count);
    std::array<GLfloat, 4> read{};
    gl->glGetFloatv(name, read.data());
    std::copy_n(read.begin(), count, values.begin());
    return values;
  };
  std::vector<std::pair<const char*, std::vector<double>>> state = {
      {"unpack alignment", get(GL_UNPACK_ALIGNMENT)},
      {"unpack row length", get(GL_UNPACK_ROW_LENGTH)},
      {"pack alignment", get(GL_PACK_ALIGNMENT)},
      {"active texture", get(GL_ACTIVE_TEXTURE)},
      {"program", get(GL_CURRENT_PROGRAM)},
      {"vertex array", get(GL_VERTEX_ARRAY_BINDING)},
      {"array buffer", get(GL_ARRAY_BUFFER_BINDING)},
      {"draw framebuffer", get(GL_DRAW_FRAMEBUFFER_BINDING)},
      {"read framebuffer", get(GL_READ_FRAMEBUFFER_BINDING)},
      {"blend", get(GL_BLEND)},
      {"blend source", get(GL_BLEND_SRC_RGB)},
      {"blend destination", get(GL_BLEND_DST_RGB)},
      {"blend source alpha", get(GL_BLEND_SRC_ALPHA)},
      {"blend destination alpha", get(GL_BLEND_DST_ALPHA)},
      {"depth test", get(GL_DEPTH_TEST)},
      {"depth function", get(GL_DEPTH_FUNC)},
      {"depth mask", get(GL_DEPTH_WRITEMASK)},
      {"colour mask", get(GL_COLOR_WRITEMASK, 4)},
      {"cull face", get(GL_CULL_FACE)},
      {"culled face", get(GL_CULL_FACE_MODE)},
      {"front face", get(GL_FRONT_FACE)},
      {"scissor", get(GL_SCISSOR_TEST)},
      {"stencil", get(GL_STENCIL_TEST)},
      {"polygon mode", get(GL_POLYGON_MODE, 2)},
      {"offset of surfaces", get(GL_POLYGON_OFFSET_FILL)},
      {"offset of lines", get(GL_POLYGON_OFFSET_LINE)},
      {"offset factor", get(GL_POLYGON_OFFSET_FACTOR)},
      {"offset units", get(GL_POLYGON_OFFSET_UNITS)},
      {"line width", get(GL_LINE_WIDTH)},
      {"viewport", get(GL_VIEWPORT, 4)}};
  for (GLenum i = 0; i < 3; ++i) state.push_back({"clip distance", get(GL_CLIP_DISTANCE0 + i)});
  const double active = get(GL_ACTIVE_TEXTURE)[0];
  for (GLenum unit = 0; unit < 2; ++unit) {
    gl->glActiveTexture(GL_TEXTURE0 + unit);
    state.push_back({"texture", get(GL_TEXTURE_BINDING_2D)});
  }
  gl->glActiveTexture(static_cast<GLenum>(active));
  return state;
}

/// Takes down what each frame leaves behind.
class WatchedView : public LevelView {
 public:
  QStringList left;

 protected:
  void draw() override {
    const auto before = stateNow();
    LevelView::draw();
    const auto after = stateNow();
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (before[i].second != after[i].second) left << QString::fromLatin1(before[i].first);
    }
  }
};

}  // namespace

class TestSceneRules : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    emptyLook_.reset();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1100, 760);
    QVERIFY(showWindow(*window_));
    look_ = window_->findChild<LevelLook*>();
  }
  void cleanup() { window_.reset(); }

  void theSwitchesGovernWhatTheyName() {
    open();
    const Vec3 ramp{5.6, 0.5, 1.04};
    const Vec3 walkable{-2, -3, 0};
    SceneParts parts;
    parts.outlines = false;
    // Rejected parts stay without walls.
    parts.environment = false;
    view().setParts(parts);
    QVERIFY(sameHue(colourAt(ramp), removalStyle(FilterType::Slope)->paint.colour));
    // Nothing else replaces the walkable area, and no false reason is shown.
    for (const bool environment : {true, false}) {
      parts.environment = environment;
      parts.walkable = false;
      view().setParts(parts);
      const QColor there = colourAt(walkable);
      QVERIFY2(there.hsvSaturationF() < 0.12F, qPrintable(there.name()));
      QCOMPARE(view().pick(at(walkable)).has_value(), environment);
      QVERIFY(sameHue(colourAt(ramp), removalStyle(FilterType::Slope)->paint.colour));
    }
  }

  void hiddenLayersAreNotRejected_data() {
    QTest::addColumn<QByteArray>("more");
    QTest::newRow("once") << QByteArray();
    // The clearance keeps one of both.
    QTest::newRow("copied") << QByteArray("f 13 14 15\nf 13 15 16\n");
    QTest::newRow("copied otherwise") << QByteArray("f 13 14 16\nf 14 15 16\n");
  }
  void hiddenLayersAreNotRejected() {
    QFETCH(QByteArray, more);
    QVERIFY(openZUp(*window_, writeFile(folder_, "doubled.obj", storeysObj() + more), kPipeline));
    view().cameraController().viewFromTop();
    QCOMPARE(window_->controller().finishedRun()->result.mesh->layerCount, 2U);
    SceneParts parts;
    parts.outlines = false;
    view().setParts(parts);
    // Both triangles of the upper floor go, and the parts below become visible: none counts as too steep.
    const std::uint32_t upper = layerAt(3);
    view().setHiddenLayers({upper});
    for (const Vec3& place : {Vec3{3, -3, 3}, Vec3{1, 0, 3}, Vec3{2, -1, 3}}) {
      const auto seen = view().pick(at(place));
      QVERIFY(!seen || seen->point.z < 2.95);
      for (const FilterType type : {FilterType::Slope, FilterType::VerticalClearance})
        QVERIFY(!sameHue(colourAt(place), removalStyle(type)->paint.colour));
    }
    // No line of them, or of their copies, is left.
    const QColor without = colourAt({2, 0, 3});
    parts.outlines = true;
    view().setParts(parts);
    QCOMPARE(colourAt({2, 0, 3}), without);
    // A layer goes on its own triangles as well where nothing else is drawn.
    look_->modes().setMode(ViewMode::WalkableOnly);
    QCOMPARE(colourAt({3, -3, 3}).hsvSaturationF() < 0.12F, !view().pick(at({3, -3, 3})).has_value());
  }

  void whatIsSeenIsPicked_data() {
    QTest::addColumn<bool>("inside");
    QTest::addColumn<bool>("top");
    QTest::newRow("inside, oblique") << true << false;
    QTest::newRow("closed, oblique") << false << false;
    QTest::newRow("inside, top") << true << true;
    QTest::newRow("closed, top") << false << true;
  }
  void whatIsSeenIsPicked() {
    QFETCH(bool, inside);
    QFETCH(bool, top);
    open();
    if (!top) view().cameraController().viewOblique();
    view().setInside(inside);
    const std::uint32_t upper = layerAt(3);
    int seen = 0;
    int missing = 0;
    const auto compare = [&](const QString& what) {
      const auto [some, none] = compareWithPicture(what);
      seen += some;
      missing += none;
    };
    for (const ViewMode mode : kViewModes) {
      if (mode == ViewMode::Wireframe) continue;  // everything is visible through wireframes
      look_->modes().setMode(mode);
      QVERIFY(QTest::qWaitFor([&] { return look_->modes().upToDate(); }, 20000));
      for (unsigned switches = 0; switches < 8; ++switches) {
        SceneParts parts;
        parts.outlines = parts.connections = parts.obstacleEdges = false;
        parts.environment = (switches & 1U) != 0;
        parts.walkable = (switches & 2U) != 0;
        parts.removed = (switches & 4U) != 0;
        view().setParts(parts);
        const QString what = QStringLiteral("%1, parts %2").arg(labelOf(mode)).arg(switches);
        compare(what);
        view().setHiddenLayers({upper});
        compare(what + QStringLiteral(", hidden layer"));
        view().setHiddenLayers({});
        if (switches != 7 && switches != 6) continue;
        view().setHeights({.upper = 4});
        compare(what + QStringLiteral(", cut above"));
        view().setHeights({.lower = 0.5});
        compare(what + QStringLiteral(", cut below"));
        view().setHeights({});
        view().setCutPlane(CutPlane{1, 0, 2});
        compare(what + QStringLiteral(", cut plane"));
        view().setCutPlane(std::nullopt);
      }
    }
    QVERIFY(seen > 1000);
    QVERIFY(missing > 1000);
  }

  void wireframesArePickedThrough() {
    open();
    look_->modes().setMode(ViewMode::Wireframe);
    // The ceiling over the upper floor faces down: its edges are seen, the floor is meant.
    QCOMPARE(view().pick(at({2.5, 2.5, 6}))->point.z, 3.0);
  }

  void aHouseIsLookedIntoFromAbove() {
    QVERIFY(
        openZUp(*window_, writeFile(folder_, "house.obj", houseObj()), "SlopeFilter 45\nVerticalClearanceFilter 2\n"));
    view().cameraController().viewOblique();
    QVERIFY(view().environmentGeometry()->covered);
    const Vec3 floor{0.5, 0.2, 0.1};
    QVERIFY(view().inside());
    QVERIFY(std::abs(view().pick(at(floor))->point.z - 0.1) < 1e-3);
    QVERIFY(sameHue(colourAt(floor), walkablePaint().colour));
    // The meadow outside is no cover, and from the side a house is a house.
    QVERIFY(std::abs(view().pick(at({8, 8, 0}))->point.z) < 1e-3);
    window_->findChild<QAction*>("view.inside")->setChecked(false);
    QVERIFY(view().pick(at(floor))->point.z > 0.5);
    window_->findChild<QAction*>("view.inside")->setChecked(true);
    view().cameraController().viewFrom(ViewSide::Front);
    QVERIFY(std::abs(view().pick(at({0, -2, 1.5}))->point.y + 2) < 1e-3);
  }

  void sessionsKeepTheSwitch() {
    open();
    window_->findChild<QAction*>("view.inside")->setChecked(false);
    const QString session = folder_.filePath("closed.footfall");
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(session);
    QVERIFY(written.wait());
    QVERIFY(openZUp(*window_, writeFile(folder_, "floor.obj", floorObj()), kPipeline));
    QVERIFY(view().inside());
    window_->open(session);
    QVERIFY(QTest::qWaitFor([&] { return !view().inside(); }));
    QVERIFY(waitUntilIdle(*window_));
  }

  void drawingLeavesNoStateBehind() {
    open();
    WatchedView watched;
    watched.resize(500, 400);
    dress(watched);
    watched.show();
    QVERIFY(QTest::qWaitForWindowExposed(&watched));
    drawEverything(watched);
    watched.left.removeDuplicates();
    QVERIFY2(watched.left.isEmpty(), qPrintable(watched.left.join(", ")));
  }

  void wordsStayReadable() {
    open();
    const auto pictureOf = [&](bool after) {
      LevelView fresh;
      fresh.resize(500, 400);
      dress(fresh);
      fresh.show();
      if (!QTest::qWaitForWindowExposed(&fresh)) return QImage();
      if (after) drawEverything(fresh);
      fresh.cameraController().viewOblique();
      // New letters go to OpenGL now.
      ViewOverlay overlay;
      overlay.labels.push_back({{0, 0, 0}, QStringLiteral("Hamburgefonstiv 0123456789")});
      fresh.setOverlay(QStringLiteral("words"), overlay);
      const QImage picture = fresh.grabFramebuffer();
      const QPoint label = fresh.project({0, 0, 0})->toPoint();
      return picture.copy(QRect(label + QPoint(8, -30), QSize(180, 28)));
    };
    const QImage before = pictureOf(false);
    const QImage after = pictureOf(true);
    QVERIFY(!before.isNull());
    QCOMPARE(after, before);
  }

 private:
  LevelView& view() { return window_->view(); }
  void open() {
    QVERIFY(openZUp(*window_, writeFile(folder_, "storeys.obj", storeysObj()), kPipeline));
    view().cameraController().viewFromTop();
  }
  static bool sameHue(const QColor& a, const QColor& b) {
    const int hue = std::abs(a.hsvHue() - b.hsvHue());
    return std::min(hue, 360 - hue) < 12 && std::abs(a.hsvSaturationF() - b.hsvSaturationF()) < 0.15F;
  }
  QPoint at(const Vec3& place) { return placeInView(*window_, place); }
  QColor colourAt(const Vec3& place) { return colourInView(*window_, place); }
  std::uint32_t layerAt(double height) {
    const NavigationMesh& mesh = *window_->controller().finishedRun()->result.mesh;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.vertices[mesh.triangles[t][0]].z == height) return mesh.layers[t];
    }
    return 99;
  }

  /// The depth of the picture at places all over it against that of what a click there hits; places with and without.
  std::pair<int, int> compareWithPicture(const QString& what) {
    const SceneParts parts = view().parts();
    const ViewMode mode = parts.mode;
    const QImage& empty = emptyPicture();
    const QImage picture = view().grabFramebuffer();
    std::vector<float> depths(static_cast<std::size_t>(picture.width()) * static_cast<std::size_t>(picture.height()));
    view().makeCurrent();
    auto* gl = QOpenGLContext::currentContext()->functions();
    gl->glReadPixels(0, 0, picture.width(), picture.height(), GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    view().doneCurrent();
    const bool wires = mode == ViewMode::HiddenLine;
    int some = 0;
    int nothing = 0;
    for (int y = 10; y < view().height(); y += 23) {
      for (int x = 10; x < view().width(); x += 23) {
        const auto seen = view().pick({x, y});
        const bool blank = isLike(picture.pixelColor(x, y), empty.pixelColor(x, y));
        // Half a pixel decides as well where two surfaces of one colour meet in the picture.
        const auto distanceTo = [&](const Vec3& point) {
          double least = std::numeric_limits<double>::infinity();
          for (const auto& [dx, dy] :
               {std::pair{0, 0}, std::pair{1, 0}, std::pair{-1, 0}, std::pair{0, 1}, std::pair{0, -1}}) {
            const auto at = static_cast<std::size_t>((picture.height() - 1 - y - dy) * picture.width() + x + dx);
            least = std::min(least, distanceOf(point, placeAt(x + dx, y + dy, depths[at])));
          }
          return least;
        };
        const QString place = QStringLiteral("%1 at %2, %3").arg(what).arg(x).arg(y);
        if (!wires || parts.environment) {
          [&] { QVERIFY2(blank == !seen || isEdge(picture, x, y), qPrintable(place)); }();
        }
        if (!seen) {
          ++nothing;
          continue;
        }
        ++some;
        if (wires || isEdge(picture, x, y) || blank) continue;
        const double apart = distanceTo(seen->point);
        // Upright surfaces that are nearly seen from the side lie behind themselves by their polygon offset.
        const auto slope = view().environmentGeometry()->surface[std::size_t{3} * seen->triangle].normal[2];
        [&] {
          QVERIFY2(apart < (std::abs(slope) > 60 ? 0.3 : 1.0),
                   qPrintable(place + QStringLiteral(": %1 apart").arg(apart)));
        }();
      }
    }
    return {some, nothing};
  }
  /// The picture with nothing in it: the same for all modes and parts of one camera, heights and cut plane.
  const QImage& emptyPicture() {
    const auto look = std::tuple(view().sceneCamera(), view().heights(), view().cutPlane());
    if (emptyLook_ == look) return empty_;
    const SceneParts parts = view().parts();
    SceneParts none = parts;
    none.environment = none.walkable = none.removed = false;
    view().setMode(ViewMode::Result);
    view().setParts(none);
    empty_ = view().grabFramebuffer();
    emptyLook_ = look;
    view().setMode(parts.mode);
    view().setParts(parts);
    return empty_;
  }
  static bool isLike(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) <= 3;
  }
  /// True beside another surface: half a pixel decides.
  static bool isEdge(const QImage& picture, int x, int y) {
    const QColor middle = picture.pixelColor(x, y);
    for (const auto& [dx, dy] : {std::pair{2, 0}, std::pair{-2, 0}, std::pair{0, 2}, std::pair{0, -2}}) {
      const QColor other = picture.pixelColor(x + dx, y + dy);
      if (std::abs(other.red() - middle.red()) + std::abs(other.green() - middle.green()) +
              std::abs(other.blue() - middle.blue()) >
          6)
        return true;
    }
    return false;
  }
  static double distanceOf(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }
  Vec3 placeAt(int x, int y, float depth) {
    const Vec3& centre = view().environmentGeometry()->centre;
    const qglviewer::Vec at =
        view().camera()->unprojectedCoordinatesOf(qglviewer::Vec(x + 0.5, y + 0.5, static_cast<double>(depth)));
    return {at.x + centre.x, at.y + centre.y, at.z + centre.z};
  }

  /// Sets the view up like the window's, without the drawings of tools.
  void dress(LevelView& other) {
    other.setEnvironment(view().environmentGeometry(), true);
    other.setContent(view().content());
  }
  void drawEverything(LevelView& other) {
    const NavigationMesh& mesh = *window_->controller().finishedRun()->result.mesh;
    const std::uint32_t upper = layerAt(3);
    const Vec3 centre = view().environmentGeometry()->centre;
    const Environment& level = *partOf<LevelComposer>(*window_).level();
    other.setField(makeSlopeField(level, centre, [] {}), {0, 90, 45.0, true});
    other.setSources(makeMeshGeometry(mesh, centre));
    CellBounds left, right;
    left.upper[0] = right.lower[0] = 0;
    const auto cells = makeCellGeometry(level, centre, {left, right}, [] {});
    for (const ViewMode mode : kViewModes) {
      other.setMode(mode);
      other.grabFramebuffer();
      other.setHiddenLayers({upper});
      other.grabFramebuffer();
      other.setHiddenLayers({});
    }
    other.setMode(ViewMode::Result);
    other.setHeights({.upper = 4});
    other.grabFramebuffer();
    other.setHeights({});
    other.setCutPlane(CutPlane{1, 0, 2});
    other.grabFramebuffer();
    other.setCutPlane(std::nullopt);
    SceneParts parts;
    parts.cells = true;
    other.setCells(cells, {QColor(Qt::red), std::nullopt});
    other.setMarkedCells({0, 1});
    other.setParts(parts);
    other.grabFramebuffer();
    parts = {};
    parts.environment = parts.walkable = false;
    other.setParts(parts);
    other.grabFramebuffer();
    other.setParts({});
    other.setMarkedCells({});
    ViewContent changed = view().content();
    changed.changes.push_back(makeMeshGeometry(mesh, centre, walkablePaint()));
    other.setContent(changed);
    other.grabFramebuffer();
    other.setContent(view().content());
    ViewOverlay overlay;
    overlay.throughWalls = true;
    overlay.lines.push_back({{{Vec3{0, 0, 0}, Vec3{1, 1, 1}}}, Qt::blue, 2, Qt::black});
    overlay.surfaces.push_back({{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}}, Qt::red});
    other.setOverlay(QStringLiteral("obstacle"), overlay);
    other.grabFramebuffer();
    other.removeOverlay(QStringLiteral("obstacle"));
    other.cameraController().turnBy(10, 0);  // moving
    QCoreApplication::processEvents();
    other.cameraController().turnBy(-10, 0);
    other.cameraController().viewOblique();
    other.grabFramebuffer();
  }

  QTemporaryDir folder_;
  std::unique_ptr<EditorWindow> window_;
  LevelLook* look_ = nullptr;
  QImage empty_;
  std::optional<std::tuple<SceneCamera, HeightRange, std::optional<CutPlane>>> emptyLook_;
};

FOOTFALL_EDITOR_SUITE(TestSceneRules)
#include "test_scene_rules.moc"
