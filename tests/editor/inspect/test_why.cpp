// The tool "Why?" as a person uses it: the key, clicks in the view, the panel, its buttons, and edits afterwards.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/inspect/inspection_feature.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// Two rooms of 4 x 4 with walls of 1/4 around, and a doorway of 1 x 1.75 between them at x = 0; Z up.
QByteArray doorwayObj() {
  QByteArray text;
  int vertices = 0;
  const auto quad = [&](const std::array<std::array<double, 3>, 4>& corners) {
    for (const auto& p : corners)
      text += "v " + QByteArray::number(p[0]) + ' ' + QByteArray::number(p[1]) + ' ' + QByteArray::number(p[2]) + '\n';
    text += "f";
    for (int k = 1; k <= 4; ++k) text += ' ' + QByteArray::number(vertices + k);
    text += '\n';
    vertices += 4;
  };
  const auto box = [&](double x0, double y0, double z0, double x1, double y1, double z1) {
    quad({{{x0, y0, z0}, {x0, y1, z0}, {x1, y1, z0}, {x1, y0, z0}}});
    quad({{{x0, y0, z1}, {x1, y0, z1}, {x1, y1, z1}, {x0, y1, z1}}});
    quad({{{x0, y0, z0}, {x1, y0, z0}, {x1, y0, z1}, {x0, y0, z1}}});
    quad({{{x1, y1, z0}, {x0, y1, z0}, {x0, y1, z1}, {x1, y1, z1}}});
    quad({{{x0, y1, z0}, {x0, y0, z0}, {x0, y0, z1}, {x0, y1, z1}}});
    quad({{{x1, y0, z0}, {x1, y1, z0}, {x1, y1, z1}, {x1, y0, z1}}});
  };
  text += "o floor\nusemtl stone\n";
  quad({{{-4, -2, 0}, {4, -2, 0}, {4, 2, 0}, {-4, 2, 0}}});
  text += "o wall\nusemtl brick\n";
  box(-0.125, -2, 0, 0.125, -0.5, 3);
  box(-0.125, 0.5, 0, 0.125, 2, 3);
  text += "o lintel\nusemtl oak\n";
  box(-0.125, -0.5, 1.75, 0.125, 0.5, 3);
  return text;
}

constexpr const char* kPipeline =
    "DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 0\nLayerSubdivisionFilter\n";

bool sameShare(const QImage& image, const QColor& colour, double least) {
  qint64 count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor p = image.pixelColor(x, y);
      count +=
          std::abs(p.red() - colour.red()) + std::abs(p.green() - colour.green()) + std::abs(p.blue() - colour.blue()) <
                  30
              ? 1
              : 0;
    }
  return static_cast<double>(count) >= least;
}

}  // namespace

class TestWhy : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    feature_ = window_->findChild<InspectionFeature*>();
    QVERIFY(feature_ != nullptr);
  }
  void cleanup() { window_.reset(); }

  void saysHowToAsk() {
    QAction* action = window_->findChild<QAction*>(QStringLiteral("inspect.why"));
    QVERIFY(action && action->shortcut() == QKeySequence(Qt::Key_Y));
    QVERIFY(!dock()->isVisible());
    QTest::keyClick(window_.get(), Qt::Key_Y);
    QTRY_VERIFY(dock()->isVisible());
    QVERIFY(panel().findChild<QLabel*>(QStringLiteral("whyEmpty"))->isVisible());
    QVERIFY(window_->view().tool() != nullptr);
    // A click without a level gets a message, and no more.
    QTest::mouseClick(&window_->view(), Qt::LeftButton, {}, window_->view().rect().center());
    QVERIFY(!feature_->watch().busy());
    QTest::keyClick(&window_->view(), Qt::Key_Escape);
    QVERIFY(window_->view().tool() == nullptr && !action->isChecked());
  }

  void howFarWallsAndLedgesAre() {
    const QTemporaryDir folder;
    const QByteArray walled = floorObj() + "v -4 -4 3\nv -4 4 3\nf 1 4 6 5\n";  // a wall at x = -4
    QVERIFY(openZUp(*window_, writeFile(folder, "walled.obj", walled),
                    "SlopeFilter 45\nVerticalClearanceFilter 2\nRadiusFilter 0.5\n"));
    window_->view().cameraController().viewFromTop();
    QTest::keyClick(window_.get(), Qt::Key_Y);
    const auto borders = [this] { return panel().findChild<QLabel*>(QStringLiteral("whyBorders"))->text(); };
    clickAt({-3, 0, 0});
    QVERIFY(answered());
    // The border as it is before the radius narrows it; a pixel is some 0.01.
    const PlaceExplanation told = *feature_->watch().explanation();
    QVERIFY(told.wallDistance && std::abs(*told.wallDistance - 1) < 0.03);
    QVERIFY(told.ledgeDistance && std::abs(*told.ledgeDistance - 4) < 0.03);
    QVERIFY2(borders().contains("a wall at ") && borders().contains(", a ledge at "), qPrintable(borders()));
    // The margin works the same.
    clickAt({3.75, 0, 0});
    QVERIFY(answered());
    QCOMPARE(panel().headline(), QStringLiteral("Not walkable: too near a ledge"));
    QVERIFY2(borders().contains("a ledge at 0.2"), qPrintable(borders()));
  }

  // The test clicks a closed doorway, reads the reason, moves to the lintel and to the filter, changes the filter, and
  // finds the doorway open.
  void whyADoorwayIsClosed() {
    const QTemporaryDir folder;
    QVERIFY(openZUp(*window_, writeFile(folder, "rooms.obj", doorwayObj()), kPipeline));
    window_->view().cameraController().viewFromTop();
    window_->view().setHeights({-2, 0.5});  // a look under the lintel
    QTest::keyClick(window_.get(), Qt::Key_Y);
    clickAt({0, 0.1, 0});
    QVERIFY(answered());
    QCOMPARE(panel().headline(), QStringLiteral("Not walkable: too low"));
    QVERIFY2(panel().reason().contains("is 1.75 units above") && panel().reason().contains("need 2 units"),
             qPrintable(panel().reason()));
    QVERIFY(panel().isVisible() && panel().filterButton()->isVisible());
    QVERIFY2(panel().filterButton()->text().contains("VerticalClearanceFilter 2"),
             qPrintable(panel().filterButton()->text()));
    const auto told = feature_->watch().explanation();
    QVERIFY(told->obstacle && told->obstacle->height == 1.75);
    QVERIFY2(panel().reason().contains("lintel, oak"), qPrintable(panel().reason()));
    QVERIFY(panel().findChild<QLabel*>(QStringLiteral("whyTriangle"))->text().contains("floor, stone"));
    const Environment& level = *partOf<LevelComposer>(*window_).level();
    for (const auto v : level.triangles[told->obstacle->triangle]) QCOMPARE(level.vertices[v].z, 1.75);

    // Seen through the view: the obstacle's colour, and the label.
    window_->view().cameraController().viewOblique();
    QTest::mouseClick(panel().obstacleButton(), Qt::LeftButton);
    QTest::qWait(100);
    QVERIFY(sameShare(window_->view().grabFramebuffer(), obstacleEdgeColour(), 100));
    const auto middle = window_->view().project({0, 0, 1.75});
    QVERIFY(middle && QRectF(window_->view().rect()).contains(*middle));
    QTest::mouseClick(panel().placeButton(), Qt::LeftButton);
    QVERIFY(QRectF(window_->view().rect()).contains(*window_->view().project({0, 0.1, 0})));

    // Goes to the filter by keyboard; the answer follows the edit.
    panel().filterButton()->setFocus();
    QTest::keyClick(panel().filterButton(), Qt::Key_Space);
    auto* field = qobject_cast<NumberField*>(window_->focusWidget());
    QVERIFY(field != nullptr);
    QCOMPARE(field, partOf<FilterList>(*window_).rows()[2]->field(0));
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, QStringLiteral("1.75"));
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(panel().headline(), QStringLiteral("Walkable"));
    QVERIFY2(panel().reason().contains("component 1 of"), qPrintable(panel().reason()));
    QVERIFY(!panel().filterButton()->isVisible());
    partOf<Document>(*window_).undoStack()->undo();
    QTRY_COMPARE(panel().headline(), QStringLiteral("Not walkable: too low"));

    // Esc in the view ends the tool and what it drew; closing the panel ends the work.
    window_->view().setFocus();
    QTest::keyClick(&window_->view(), Qt::Key_Escape);
    QTest::qWait(100);
    QVERIFY(!sameShare(window_->view().grabFramebuffer(), selectedCellColour(), 30));
    dock()->close();
    QVERIFY(feature_->watch().inspector() == nullptr && !feature_->watch().asked());
  }

  void wallsRampsAndCeilings() {
    const QTemporaryDir folder;
    const QByteArray level = tableObj() + "v -3 -4 0\nv -3 4 0\nv -3 4 2\nv -3 -4 2\nf 13 14 15 16\n";
    QVERIFY(openZUp(*window_, writeFile(folder, "table.obj", level),
                    "SlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 5\n"));
    window_->view().cameraController().viewFromTop();
    QTest::keyClick(window_.get(), Qt::Key_Y);
    const auto headlineAt = [&](const Vec3& place) {
      clickAt(place);
      return answered() ? panel().headline() : QString();
    };
    QCOMPARE(headlineAt({5.5, 0, 0.9}), QStringLiteral("Not walkable: too steep"));
    QVERIFY(panel().reason().contains("60") && panel().reason().contains("45"));
    QCOMPARE(headlineAt({0.5, 0.2, 1}), QStringLiteral("Not walkable: too small an area"));
    QVERIFY(panel().reason().contains("4.00 units²") && panel().reason().contains("5.00 units²"));
    QCOMPARE(headlineAt({2, 2.5, 0}), QStringLiteral("Walkable"));
    QVERIFY(!panel().obstacleButton()->isEnabled());
    window_->view().cameraController().viewOblique();
    // The wall faces away: it is skipped or picked, as it is drawn.
    QCOMPARE(headlineAt({-3, 0.1, 1}), QStringLiteral("Walkable"));
    window_->findChild<QAction*>("view.inside")->trigger();
    QCOMPARE(headlineAt({-3, 0.1, 1}), QStringLiteral("Not walkable: a wall"));
    // Return picks the place of the mouse.
    const QPoint place = window_->view().project({2, 2.5, 0})->toPoint();
    QTest::mouseMove(&window_->view(), place);
    QTest::mouseMove(&window_->view(), place + QPoint(1, 0));
    QTest::keyClick(&window_->view(), Qt::Key_Return);
    QTRY_COMPARE(panel().headline(), QStringLiteral("Walkable"));
    // A click beside everything shows a message in the status bar, and the last answer stays.
    QTest::mouseClick(&window_->view(), Qt::LeftButton, {}, QPoint(5, 5));
    QCOMPARE(panel().headline(), QStringLiteral("Walkable"));
  }

  // Another environment has other places; the same file again, or another level of it, keeps them.
  void anotherEnvironmentForgets() {
    const QTemporaryDir folder;
    QVERIFY(openZUp(*window_, writeFile(folder, "rooms.obj", doorwayObj()), kPipeline));
    window_->view().cameraController().viewFromTop();
    QTest::keyClick(window_.get(), Qt::Key_Y);
    clickAt({2, 1, 0});
    QVERIFY(answered());
    QVERIFY(openZUp(*window_, writeFile(folder, "rooms.obj", doorwayObj()), kPipeline));
    QVERIFY(answered());
    QCOMPARE(panel().headline(), QStringLiteral("Walkable"));
    QVERIFY(openZUp(*window_, writeFile(folder, "other.obj", tableObj()), kPipeline));
    QVERIFY(panel().findChild<QLabel*>(QStringLiteral("whyEmpty"))->isVisible());
    QVERIFY(!feature_->watch().asked());
  }

  void samples_data() {
    QTest::addColumn<QString>("sample");
    for (const char* name : {"house", "villa", "rooms"}) QTest::newRow(name) << name;
  }
  // The answer agrees with the picture: a walkable place is covered by the result, and a rejected one is not.
  void samples() {
    QFETCH(QString, sample);
    window_->open(QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/%1/%1.obj").arg(sample));
    QVERIFY(QTest::qWaitFor([&] { return window_->controller().finishedRun() && window_->idle(); }, 60000));
    window_->view().cameraController().viewFromTop();
    QTest::keyClick(window_.get(), Qt::Key_Y);
    const NavigationMesh& mesh = *window_->controller().finishedRun()->result.mesh;
    std::set<QString> headlines;
    for (int i = 1; i < 8; ++i) {
      for (int j = 1; j < 5; ++j) {
        const QPoint at(window_->view().width() * i / 8, window_->view().height() * j / 5);
        const auto picked = window_->view().pick(at);
        if (!picked) continue;
        QTest::mouseClick(&window_->view(), Qt::LeftButton, {}, at);
        QVERIFY(answered());
        headlines.insert(panel().headline());
        const Vec3& p = feature_->watch().explanation()->place.point;
        int covers = 0;
        for (const Triangle& t : mesh.triangles) {
          const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
          const auto side = [&](const Vec3& u, const Vec3& v) {
            return (v.x - u.x) * (p.y - u.y) - (v.y - u.y) * (p.x - u.x) >= -1e-7;
          };
          const double nx = (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y),
                       ny = (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z),
                       nz = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
          if (side(a, b) && side(b, c) && side(c, a) &&
              std::fabs(nx * (p.x - a.x) + ny * (p.y - a.y) + nz * (p.z - a.z)) < 1e-6 * nz)
            ++covers;
        }
        QCOMPARE(panel().headline().startsWith("Walkable"), covers > 0);
      }
    }
    QVERIFY(!headlines.empty() && headlines.count(QString()) == 0);
  }

 private:
  [[nodiscard]] WhyPanel& panel() const { return feature_->whyPanel(); }
  [[nodiscard]] QDockWidget* dock() const {
    return window_->findChild<QDockWidget*>(QStringLiteral("inspect.whyPanel"));
  }
  void clickAt(const Vec3& place) {
    const auto at = window_->view().project(place);
    QVERIFY(at);
    QTest::mouseClick(&window_->view(), Qt::LeftButton, {}, at->toPoint());
  }
  bool answered() {
    return QTest::qWaitFor([&] { return !feature_->watch().busy() && feature_->watch().explanation(); }, 20000);
  }

  std::unique_ptr<EditorWindow> window_;
  InspectionFeature* feature_ = nullptr;
};

FOOTFALL_EDITOR_SUITE(TestWhy)
#include "test_why.moc"
