// Whole stories, as a designer lives them, with mouse and keyboard in the real window. With FOOTFALL_PICTURES=FOLDER
// the pictures of the user guide are written there on the way (docs/make_pictures.sh).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <cmath>
#include <memory>

#include "core/io/import.hpp"
#include "footfall/filter.hpp"
#include "footfall/inspect.hpp"
#include "footfall/io.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "tests/support/soup.hpp"
#include "ui/base/commands/command_palette.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/inspect/corridors/corridors_feature.hpp"
#include "ui/inspect/inspection_feature.hpp"
#include "ui/level/obstacle_features.hpp"
#include "ui/path/path_feature.hpp"
#include "ui/view/widgets/height_slider.hpp"
#include "ui/view/widgets/view_layout.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

const QString kSamples = QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/");

// places of the sample "rooms", in metres
constexpr Vec3 kDoorway{8.875, 5.0, 0};
constexpr Vec3 kLivingRoom{2, 5, 0};
constexpr Vec3 kGallery{17, 8, 2.375};

constexpr int kRisers = 12;
constexpr double kRiser = 0.1875;

/// A lower and an upper floor, and stairs 4 wide between them; Z up.
QByteArray stairsObj() {
  Soup soup = Soup().floor(0, 0, 5, 8, 0).box({5 + 0.375 * (kRisers - 1), 0, 0}, {15, 8, kRisers * kRiser});
  for (int i = 1; i < kRisers; ++i) soup.box({5 + 0.375 * (i - 1), 2, 0}, {5 + 0.375 * i, 6, i * kRiser});
  QByteArray text;
  for (const std::array<Vec3, 3>& triangle : soup.triangles())
    for (const Vec3& p : triangle)
      text += "v " + QByteArray::number(p.x) + ' ' + QByteArray::number(p.y) + ' ' + QByteArray::number(p.z) + '\n';
  for (std::size_t i = 0; i < soup.size(); ++i)
    text += "f " + QByteArray::number(3 * i + 1) + ' ' + QByteArray::number(3 * i + 2) + ' ' +
            QByteArray::number(3 * i + 3) + '\n';
  return text;
}

}  // namespace

class TestStories : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void cleanup();
  void aDoorwayIsClosed();
  void aCrateIsMoved();
  void stairsAreClimbed();
  void severalAgents();
  void passagesAreMeasured();
  void aBuildingIsLookedInto();
  void theEditorWelcomes();
  void noTwoCommandsShareAKey();

 private:
  void open(const QString& sample);
  void picture(const QString& name);
  QAction* command(const char* id);
  void panelOnly(const char* id);
  void clickAt(const Vec3& place);
  [[nodiscard]] FilterRow* row(const char* filter);
  void setParameter(const char* filter, const char* value);
  void theWheelchairTriesTheDoor(const Bottleneck& door);

  QTemporaryDir folder_;
  QString pictures_;
  std::unique_ptr<EditorWindow> window_;
};

void TestStories::initTestCase() {
  pictures_ = qEnvironmentVariable("FOOTFALL_PICTURES");
  QVERIFY(pictures_.isEmpty() || QDir(pictures_).exists());
}

void TestStories::init() {
  window_ = std::make_unique<EditorWindow>();
  window_->setRemembering(false);
  window_->resize(1280, 800);
  QVERIFY(showWindow(*window_));
}

void TestStories::cleanup() { window_.reset(); }

void TestStories::open(const QString& sample) {
  window_->openWith(kSamples + sample + '/' + sample + ".obj",
                    readPipelineFile((kSamples + sample + '/' + sample + ".pipeline").toStdString()), {});
  QVERIFY(waitUntilIdle(*window_));
  QVERIFY(window_->controller().finishedRun() != nullptr);
}

void TestStories::picture(const QString& name) {
  QVERIFY(waitUntilIdle(*window_));
  QTest::qWait(400);  // transitions, and the whole frame after a hurried one
  if (pictures_.isEmpty()) return;
  window_->view().grabFramebuffer();  // all of it drawn
  QVERIFY(window_->grab().save(pictures_ + '/' + name + ".png"));
}

QAction* TestStories::command(const char* id) {
  QAction* found = window_->findChild<QAction*>(QLatin1String(id));
  if (!found) qFatal("no command %s", id);
  return found;
}

// The dock of a command in front of those beside it.
void TestStories::panelOnly(const char* id) {
  QAction* action = command(id);
  if (!action->isChecked()) action->trigger();
  if (auto* dock = window_->findChild<QDockWidget*>(QLatin1String(id))) dock->raise();
}

void TestStories::clickAt(const Vec3& place) {
  const std::optional<QPointF> at = window_->view().project(place);
  QVERIFY(at.has_value());
  QTest::mouseMove(&window_->view(), at->toPoint());
  QTest::mouseClick(&window_->view(), Qt::LeftButton, {}, at->toPoint());
}

FilterRow* TestStories::row(const char* filter) {
  for (std::size_t i = 0; i < partOf<FilterList>(*window_).rows().size(); ++i) {
    if (partOf<Document>(*window_).filters()[i].step.filter->name == filter)
      return partOf<FilterList>(*window_).rows()[i];
  }
  return nullptr;
}

void TestStories::setParameter(const char* filter, const char* value) {
  FilterRow* found = row(filter);
  QVERIFY(found != nullptr);
  partOf<FilterList>(*window_).choose({found->entryId()});
  QWidget* field = found->field(0);
  field->setFocus();
  QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(field, QLatin1String(value));
  QTest::keyClick(field, Qt::Key_Return);
  QVERIFY(waitUntilIdle(*window_));
}

// Open a level, find why a doorway is closed, change the clearance, walk through, export, and come back the next day.
void TestStories::aDoorwayIsClosed() {
  open(QStringLiteral("rooms"));
  picture(QStringLiteral("guide-opened"));

  // There is no way through: the path ends at the doorway.
  auto* paths = window_->findChild<PathFeature*>();
  QVERIFY(paths != nullptr);
  command("view.top")->trigger();
  QTest::keyClick(&window_->view(), Qt::Key_P);
  clickAt(kLivingRoom);
  clickAt(kGallery);
  QTRY_VERIFY(paths->model().result().has_value());
  QVERIFY(!paths->model().result()->reached());
  picture(QStringLiteral("guide-no-path"));
  QTest::keyClick(&window_->view(), Qt::Key_Escape);

  // Why? The lintel is in the way of the eye as well: cut above 1.5 m.
  auto* inspection = window_->findChild<InspectionFeature*>();
  QVERIFY(inspection != nullptr);
  partOf<HeightSlider>(*window_).setRange({-1, 1.5});
  QTest::keyClick(&window_->view(), Qt::Key_Y);
  clickAt(kDoorway);
  QTRY_VERIFY(!inspection->watch().busy() && inspection->watch().explanation().has_value());
  const auto told = inspection->watch().explanation();
  QVERIFY(told->obstacle.has_value());
  QCOMPARE(told->obstacle->height, 1.890625);  // walls of the samples begin 1/64 above their floor
  panelOnly("inspect.whyPanel");
  picture(QStringLiteral("guide-why"));

  // A smaller agent fits; the answer and the path follow.
  setParameter("VerticalClearanceFilter", "1.8");
  QCOMPARE(partOf<Document>(*window_).undoStack()->count(), 1);
  QTRY_VERIFY(paths->model().result() && paths->model().result()->reached());
  partOf<HeightSlider>(*window_).setRange({});
  QTest::keyClick(&window_->view(), Qt::Key_Escape);
  command("view.oblique")->trigger();
  panelOnly("panel.path");
  picture(QStringLiteral("guide-path"));

  // Export, and read it back.
  const QString exported = folder_.filePath(QStringLiteral("rooms-walkable.obj"));
  window_->exportResult(exported);
  QVERIFY(waitUntilIdle(*window_));
  const NavigationMesh mesh = readNavigationMesh(exported.toStdString()).mesh;
  QCOMPARE(mesh.triangles.size(), window_->controller().finishedRun()->result.mesh->triangles.size());

  // Save the session, and come back.
  const QString session = folder_.filePath(QStringLiteral("rooms.footfall"));
  window_->saveSession(session);
  QVERIFY(waitUntilIdle(*window_));
  const Pipeline pipeline = partOf<Document>(*window_).pipeline();
  cleanup();
  init();
  window_->open(session);
  QVERIFY(waitUntilIdle(*window_));
  QVERIFY(partOf<Document>(*window_).pipeline() == pipeline);
  const auto again = window_->controller().finishedRun();
  QVERIFY(again && again->result.mesh->triangles.size() == mesh.triangles.size());
}

// A crate in the doorway closes it; moved aside, it opens again, and undo restores it.
void TestStories::aCrateIsMoved() {
  open(QStringLiteral("rooms"));
  setParameter("VerticalClearanceFilter", "1.8");
  // Counts the parts of the walkable area that nobody can leave.
  const auto regions = [&] {
    const auto run = window_->controller().finishedRun();
    return findComponents(*run->result.mesh).list.size();
  };
  QVERIFY(regions() > 0);
  const std::size_t openRegions = regions();

  partOf<HeightSlider>(*window_).setRange({-1, 1.5});
  command("view.top")->trigger();
  command("obstacle.box")->trigger();
  QVERIFY(window_->view().tool() != nullptr);
  clickAt(kDoorway);
  QTRY_COMPARE(partOf<Document>(*window_).state().obstacles.size(), std::size_t{1});
  QVERIFY(waitUntilIdle(*window_));
  // Wide enough to fill the doorway, in numbers; its top is too small to be walkable.
  DocumentState next = partOf<Document>(*window_).state();
  next.obstacles[0].size = {0.75, 1.3, 1};
  next.obstacles[0].base = {8.875, 5.125, 0};
  partOf<Document>(*window_).edit(next, QStringLiteral("Resize Box 1"));
  QVERIFY(waitUntilIdle(*window_));
  QTRY_COMPARE(regions(), openRegions + 1);  // the rooms are apart
  panelOnly("view.obstacles");
  partOf<HeightSlider>(*window_).setRange({});
  command("view.oblique")->trigger();
  picture(QStringLiteral("guide-crate"));

  // Dragged by its body into the room.
  partOf<HeightSlider>(*window_).setRange({-1, 1.5});
  command("view.top")->trigger();
  if (!command("obstacle.select")->isChecked()) command("obstacle.select")->trigger();
  const QPoint from = window_->view().project({8.875, 5.125, 1})->toPoint();
  const QPoint to = window_->view().project({5, 5.125, 1})->toPoint();
  clickAt({8.875, 5.125, 1});
  QTest::mousePress(&window_->view(), Qt::LeftButton, {}, from + QPoint(0, 12));
  for (int i = 1; i <= 8; ++i) {
    QTest::mouseMove(&window_->view(), from + QPoint(0, 12) + (to - from) * i / 8);
    QTest::qWait(30);
  }
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, to + QPoint(0, 12));
  QVERIFY(waitUntilIdle(*window_));
  QVERIFY(partOf<Document>(*window_).state().obstacles[0].base.x < 7);
  QTRY_COMPARE(regions(), openRegions);
  QTest::keyClick(&window_->view(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(waitUntilIdle(*window_));
  QTRY_COMPARE(regions(), openRegions + 1);
}

// Each tread is a part of its own with a step below the risers: the path ends at the first one. One click raises the
// step, and the path goes up.
void TestStories::stairsAreClimbed() {
  const QString file = folder_.filePath(QStringLiteral("stairs.obj"));
  writeFile(folder_, QStringLiteral("stairs.obj"), stairsObj());
  QVERIFY(openZUp(*window_, file,
                  "DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.1\nAreaFilter 1\n"
                  "SimplificationFilter\nLayerSubdivisionFilter\n"));
  const auto parts = [&] { return findComponents(*window_->controller().finishedRun()->result.mesh).list.size(); };
  QCOMPARE(parts(), std::size_t{kRisers + 1});

  auto* paths = window_->findChild<PathFeature*>();
  QVERIFY(paths != nullptr);
  QTest::keyClick(&window_->view(), Qt::Key_P);
  panelOnly("panel.path");
  QTest::qWait(50);  // the dock takes its width
  command("view.fit")->trigger();
  const Vec3 start{2, 4, 0};
  const Vec3 target{12, 4, kRisers * kRiser};
  for (const QRect& rect : partOf<ViewLayout>(*window_).covered()) {
    for (const Vec3& end : {start, target}) QVERIFY(!rect.contains(window_->view().project(end)->toPoint()));
  }
  clickAt(start);
  clickAt(target);
  QTRY_VERIFY(paths->model().result() && paths->model().result()->separation);
  QVERIFY(!paths->model().result()->reached());
  auto* mend = window_->findChild<QPushButton*>(QStringLiteral("pathMend"));
  QVERIFY(mend && mend->isVisible());
  QVERIFY2(mend->text().contains(QStringLiteral("Raise Step to 0.1")), qPrintable(mend->text()));
  picture(QStringLiteral("guide-stairs-apart"));

  mend->click();
  QVERIFY(waitUntilIdle(*window_));
  const double step = partOf<Document>(*window_).pipeline().steps[3].values[0];
  QVERIFY(step >= kRiser && step < 1.1 * kRiser);
  QTRY_VERIFY(paths->model().result() && paths->model().result()->reached());
  QCOMPARE(paths->model().result()->steps.size(), std::size_t{kRisers});
  QCOMPARE(paths->model().result()->climb, kRisers * kRiser);
  QCOMPARE(parts(), std::size_t{1});
  QVERIFY(!mend->isVisible());
  picture(QStringLiteral("guide-stairs-climbed"));
  // One edit, which undo takes back.
  QTest::keyClick(&window_->view(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(waitUntilIdle(*window_));
  QTRY_VERIFY(paths->model().result() && !paths->model().result()->reached());
}

void TestStories::severalAgents() {
  open(QStringLiteral("villa"));
  panelOnly("panel.agents");
  auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("panel.agents"));
  QVERIFY(dock && dock->isVisible());
  auto* add = dock->findChild<QToolButton*>(QStringLiteral("addAgent"));
  QVERIFY(add && add->menu());
  for (int i = 0; i < 3; ++i) {
    add->menu()->actions().at(i)->trigger();
    QVERIFY(waitUntilIdle(*window_));
  }
  QCOMPARE(partOf<Document>(*window_).state().agents.size(), std::size_t{3});
  const double tall = partOf<Document>(*window_).state().agents[0].height;
  const double small = partOf<Document>(*window_).state().agents[1].height;
  QVERIFY(tall != small);
  command("agent.all")->trigger();
  QTest::qWait(3000);
  // Keys switch from one to the other, and the filters follow.
  window_->view().setFocus();
  for (const auto& [key, height] : {std::pair{Qt::Key_1, tall}, std::pair{Qt::Key_2, small}}) {
    QTest::keyClick(&window_->view(), key, Qt::AltModifier);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(partOf<Document>(*window_).pipeline().steps[3].values[0], height);
  }
  picture(QStringLiteral("guide-agents"));
}

void TestStories::passagesAreMeasured() {
  open(QStringLiteral("villa"));
  panelOnly("panel.corridors");
  auto& corridors = partOf<CorridorsFeature>(*window_);
  BottleneckModel& model = corridors.panel().model();
  QTRY_VERIFY_WITH_TIMEOUT(model.rowCount() > 0, kWaitMs);
  // A wide wheelchair, and the highest door that is too narrow for it.
  corridors.panel().setAgentWidth(1.1);
  corridors.panel().setOnlyWays(true);
  int door = -1;
  for (int row = 0; row < model.rowCount(); ++row) {
    const Bottleneck& b = *model.bottleneckOf(row);
    if (std::abs(b.width - 1) < 1e-9 && (door < 0 || b.place.z > model.bottleneckOf(door)->place.z)) door = row;
  }
  QVERIFY(door >= 0);
  QCOMPARE(model.index(door, BottleneckModel::Agent).data().toString(), QString("too narrow"));
  QTableView* table = corridors.panel().table();
  table->setCurrentIndex(model.index(door, 0));
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(model.index(door, 0)).center());
  const std::optional<QPointF> at = window_->view().project(model.bottleneckOf(door)->place);
  QVERIFY(at && window_->view().rect().contains(at->toPoint()));
  const double floor = model.bottleneckOf(door)->place.z;
  partOf<HeightSlider>(*window_).setRange({floor - 1, floor + 2});  // under the attic
  picture(QStringLiteral("guide-corridors"));
  theWheelchairTriesTheDoor(*model.bottleneckOf(door));
}

// The same door as the end of a path: the wheelchair does not fit through it, and one that is narrower does.
void TestStories::theWheelchairTriesTheDoor(const Bottleneck& door) {
  PathModel& path = partOf<PathFeature>(*window_).model();
  window_->findChild<QDockWidget*>(QStringLiteral("panel.corridors"))->close();
  panelOnly("panel.path");
  const double wide = 1.5 / door.width;
  const Vec3 across{wide * (door.left.y - door.right.y), wide * (door.right.x - door.left.x), 0};
  const Vec3& at = door.place;
  path.setPlaces(Vec3{at.x - across.x, at.y - across.y, at.z}, Vec3{at.x + across.x, at.y + across.y, at.z});
  QTRY_VERIFY_WITH_TIMEOUT(path.result() && path.result()->reached(), kWaitMs);  // a point
  auto* radius = window_->findChild<QLineEdit*>(QStringLiteral("pathRadius"));
  const auto type = [&](const char* number) {
    radius->setFocus();
    QTest::keyClick(radius, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(radius, QLatin1String(number));
  };
  type("0.55");
  QTRY_VERIFY_WITH_TIMEOUT(path.bodyPath() && path.bodyPath()->status == BodyPathStatus::TooNarrow, 3 * kWaitMs);
  QVERIFY(std::abs(path.bodyPath()->lacking - 0.1) < 1e-9);
  QTest::mouseClick(window_->findChild<QPushButton*>(QStringLiteral("pathShowPassage")), Qt::LeftButton);
  picture(QStringLiteral("guide-wheelchair"));
  type("0.45");
  QTRY_VERIFY_WITH_TIMEOUT(path.result() && path.result()->reached(), 3 * kWaitMs);
  partOf<PathFeature>(*window_).walk().walker().setTime(
      partOf<PathFeature>(*window_).walk().walker().track().seconds() / 3);
  picture(QStringLiteral("guide-wheelchair-fits"));
}

void TestStories::aBuildingIsLookedInto() {
  open(QStringLiteral("villa"));
  panelOnly("panel.layers");
  picture(QStringLiteral("guide-layers"));
  for (const char* mode : {"view.mode.slope", "view.mode.clearance", "view.mode.rejected", "view.mode.wireframe"}) {
    if (!command(mode)->isEnabled()) QTRY_VERIFY(command(mode)->isEnabled());
    command(mode)->trigger();
    picture(QStringLiteral("guide-mode-") + QString::fromLatin1(mode).section('.', -1));
  }
}

void TestStories::theEditorWelcomes() {
  picture(QStringLiteral("guide-welcome"));
  QTest::keyClick(window_.get(), Qt::Key_K, Qt::ControlModifier);
  QTRY_VERIFY(partOf<CommandPalette>(*window_).isVisible());
  QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("cl"));
  QTest::qWait(100);
  if (!pictures_.isEmpty()) QVERIFY(partOf<CommandPalette>(*window_).grab().save(pictures_ + "/guide-palette.png"));
  partOf<CommandPalette>(*window_).close();
}

// Qt calls neither of two actions with the same key.
void TestStories::noTwoCommandsShareAKey() {
  QMap<QString, QStringList> owners;
  for (const QAction* action : window_->findChildren<QAction*>()) {
    if (action->shortcutContext() != Qt::WindowShortcut) continue;
    for (const QKeySequence& keys : action->shortcuts()) owners[keys.toString()] << action->objectName();
  }
  QVERIFY(owners.size() > 30);
  for (auto it = owners.cbegin(); it != owners.cend(); ++it) {
    QVERIFY2(it->size() == 1, qPrintable(it.key() + QStringLiteral(": ") + it->join(QStringLiteral(", "))));
  }
}

FOOTFALL_EDITOR_SUITE(TestStories)
#include "test_stories.moc"
