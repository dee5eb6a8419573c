// Seeds of a ReachableFilter: placed, moved and removed in the view, edited in their row, kept by sessions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QToolButton>
#include <cmath>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/filters/seed_edits.hpp"
#include "ui/filters/seed_feature.hpp"
#include "ui/view/widgets/legend.hpp"
#include "ui/window/session.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 0.5\nAreaFilter 0.5\n";

/// The floor of 8 x 8, and an island of 2 x 4 beside it.
QByteArray islandObj() { return floorObj() + "v 6 -2 0\nv 8 -2 0\nv 8 2 0\nv 6 2 0\nf 5 6 7 8\n"; }

}  // namespace

class TestSeeds : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, writeFile(*folder_, "island.obj", islandObj()), kPipeline));
    QCOMPARE(area(), 72.0);
  }
  void cleanup() {
    window_.reset();
    folder_.reset();
  }

  void theFirstClickAddsTheFilter() {
    startTool();
    clickInView(*window_, {-2, -2, 0});
    QCOMPARE(filterNames(*window_),
             (QStringList{"SlopeFilter", "VerticalClearanceFilter", "ReachableFilter", "AreaFilter"}));
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(area(), 64.0);
    QCOMPARE(seeds().size(), 1U);
    // The removed part states its reason.
    const auto* legend = window_->view().findChild<Legend*>();
    QVERIFY(legend);
    QTRY_VERIFY2(legendTexts(*legend).contains("Cannot be reached"), qPrintable(legendTexts(*legend).join("; ")));
    const QColor island = colourInView(*window_, {7.5, 1.5, 0});
    QVERIFY2(island.green() > island.blue() + 20 && island.red() + 20 > island.green(), qPrintable(island.name()));
    shoot(*window_, "unreachable");
    // A little over the floor, on numbers of few digits.
    QVERIFY(std::fabs(seeds()[0].x + 2) < 0.05 && seeds()[0].z > 0 && seeds()[0].z < 0.01);
    QVERIFY(QString::number(seeds()[0].x, 'g', 17).size() < 9);
    clickInView(*window_, {7, 0, 0});
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(area(), 72.0);
    QCOMPARE(seeds().size(), 2U);
    shoot(*window_, "seeds");
    // Each click is one edit; the row follows.
    undo();
    QCOMPARE(seeds().size(), 1U);
    QCOMPARE(row()->fieldCount(), 3U);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(area(), 64.0);
    undo();
    QCOMPARE(filterNames(*window_), (QStringList{"SlopeFilter", "VerticalClearanceFilter", "AreaFilter"}));
    partOf<Document>(*window_).undoStack()->redo();
    partOf<Document>(*window_).undoStack()->redo();
    QCOMPARE(row()->fieldCount(), 6U);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(area(), 72.0);
  }

  void seedsAreMovedAndRemovedInTheView() {
    startTool();
    clickInView(*window_, {-2, -2, 0});
    clickInView(*window_, {2, 2, 0});
    const int edits = partOf<Document>(*window_).undoStack()->count();
    const CameraPose pose = window_->view().cameraController().pose();
    QTest::mousePress(&window_->view(), Qt::LeftButton, {}, placeInView(*window_, seeds()[1]));
    for (int i = 1; i <= 5; ++i) {
      QTest::mouseMove(&window_->view(), placeInView(*window_, {2.0 + i, 2 - 0.4 * i, 0}));
      QTest::qWait(10);
    }
    QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, placeInView(*window_, {7, 0, 0}));
    QVERIFY(std::fabs(seeds()[1].x - 7) < 0.05 && std::fabs(seeds()[1].y) < 0.05);
    QCOMPARE(partOf<Document>(*window_).undoStack()->count(), edits + 1);
    QVERIFY(window_->view().cameraController().pose().position == pose.position);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(area(), 72.0);
    // A click on a seed places none on top of it.
    clickInView(*window_, seeds()[1]);
    QCOMPARE(seeds().size(), 2U);
    clickInView(*window_, seeds()[0], Qt::ControlModifier);
    QCOMPARE(seeds().size(), 1U);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(area(), 8.0);
    clickInView(*window_, {0, 0, 0}, Qt::ControlModifier);  // The click is beside all of them.
    QCOMPARE(seeds().size(), 1U);
    clickInView(*window_, {0, 0, 0});
    QTest::keyClick(&window_->view(), Qt::Key_Backspace);
    QCOMPARE(seeds().size(), 1U);
    QTest::keyClick(&window_->view(), Qt::Key_Escape);
    QVERIFY(!window_->findChild<QAction*>("tools.seeds")->isChecked());
    QVERIFY(!row()->placeButton()->isChecked());
  }

  void theRowPlacesEditsAndRemoves() {
    partOf<Document>(*window_).addFilter(filterDescriptor(FilterType::Reachable), 1);
    QCOMPARE(row()->fieldCount(), 0U);
    QTRY_VERIFY2(row()->errorText().contains("has no seed; give the coordinates"), qPrintable(row()->errorText()));
    QCOMPARE(area(), 72.0);  // the result before stays
    QTest::mouseClick(row()->nameLabel(), Qt::LeftButton);
    QTest::mouseClick(row()->placeButton(), Qt::LeftButton);
    QVERIFY(window_->findChild<QAction*>("tools.seeds")->isChecked() && row()->placeButton()->isChecked());
    clickInView(*window_, {-2, -2, 0});
    QVERIFY(row()->placeButton()->isChecked());
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY2(row()->errorText().isEmpty(), qPrintable(row()->errorText()));
    QCOMPARE(area(), 64.0);
    // Its fields are those of any number.
    auto* x = qobject_cast<NumberField*>(row()->field(0));
    x->setFocus();
    x->selectAll();
    QTest::keyClicks(x, "7");
    QCOMPARE(seeds()[0].x, 7.0);
    auto* y = qobject_cast<NumberField*>(row()->field(1));
    y->setFocus();
    y->selectAll();
    QTest::keyClicks(y, "-1.5");
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(area(), 8.0);
    QVERIFY2(partOf<Document>(*window_).undoStack()->undoText().startsWith("Change y "),
             qPrintable(partOf<Document>(*window_).undoStack()->undoText()));
    x->selectAll();
    QTest::keyClicks(x, "5");  // The place is between floor and island.
    QTRY_VERIFY2(row()->errorText().contains("seed 1 at 5 -1.5 "), qPrintable(row()->errorText()));
    QTest::mouseClick(row()->removeGroupButton(0), Qt::LeftButton);
    QTRY_COMPARE(row()->fieldCount(), 0U);
    QTest::mouseClick(row()->placeButton(), Qt::LeftButton);
    QVERIFY(!window_->findChild<QAction*>("tools.seeds")->isChecked());
  }

  void marksAreDrawnWhileTheirRowIsCurrent() {
    startTool();
    clickInView(*window_, {-2, -2, 0});
    QTest::mouseMove(&window_->view(), placeInView(*window_, {3, 3, 0}));
    QVERIFY(waitUntilIdle(*window_));
    const auto isMarked = [&] {
      const QColor colour = colourInView(*window_, seeds()[0]);
      return colour.red() > colour.green() + 40 && colour.blue() > colour.green() + 20;
    };
    QTRY_VERIFY(isMarked());
    window_->view().setTool(nullptr);
    QVERIFY(isMarked());
    partOf<FilterList>(*window_).choose({partOf<Document>(*window_).filters()[0].id});
    QTRY_VERIFY(!isMarked());
  }

  void sessionsKeepThem() {
    startTool();
    clickInView(*window_, {-2, -2, 0});
    clickInView(*window_, {7, 0, 0});
    partOf<Document>(*window_).addFilter(filterDescriptor(FilterType::Reachable),
                                         1);  // The filter has no seeds, and is off.
    partOf<Document>(*window_).setEnabled(partOf<Document>(*window_).filters().back().id, false);
    const Pipeline pipeline = partOf<Document>(*window_).pipeline();
    Session session;
    session.pipeline = pipeline;
    const QString path = folder_->filePath("a.footfall");
    const std::string text = formatSession(session, path.toStdString());
    writeFile(*folder_, "a.footfall", QByteArray::fromStdString(text));
    QVERIFY2(text.find("\"seeds\"") != std::string::npos, text.c_str());
    QVERIFY(readSession(path.toStdString()).pipeline == pipeline);
    QCOMPARE(pipeline.steps[2].values.size(), 6U);
  }

  void aFilterOfManySeedsHasARowOfReasonableHeight() {
    std::string text = "ReachableFilter";
    for (int i = 0; i < 1000; ++i) text += " 1 1 0.25";
    partOf<Document>(*window_).replacePipeline(parsePipeline(text + "\n", "test"), "many");
    QCOMPARE(row()->fieldCount(), 72U);
    QCOMPARE(row()->findChild<QLabel*>("moreSeeds")->text(), QString("and 976 more"));
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(area(), 64.0);
    partOf<Document>(*window_).replacePipeline(parsePipeline("ReachableFilter 7 0 0\n", "test"), "one");
    QVERIFY(row()->findChild<QLabel*>("moreSeeds")->isHidden());
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(area(), 8.0);
  }

  void placesAreAlongTheFilesAxesAndStayWhenTheScaleChanges() {
    ImportOptions import;
    import.up = UpAxis::Y;
    window_->openWith(writeFile(*folder_, "up.obj", "v -4 0 4\nv 4 0 4\nv 4 0 -4\nv -4 0 -4\nf 1 2 3 4\n"),
                      parsePipeline(kPipeline, "test"), import);
    QVERIFY(waitUntilIdle(*window_));
    startTool();
    clickInView(*window_, {2, -3, 0});
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(area(), 64.0);
    const Vec3 seed = seeds()[0];
    QVERIFY(std::fabs(seed.x - 2) < 0.05 && seed.y > 0 && seed.y < 0.01 && std::fabs(seed.z - 3) < 0.05);
    const Pipeline scaled = rescaleLengths(partOf<Document>(*window_).pipeline(), 1, 0.01);
    QCOMPARE(scaled.steps[2].values, partOf<Document>(*window_).pipeline().steps[2].values);
    QCOMPARE(scaled.steps[1].values[0], 50.0);
  }

 private:
  static QStringList legendTexts(const QWidget& legend) {
    QStringList texts;
    for (const auto* label : legend.findChildren<QLabel*>()) texts << label->text();
    for (const auto* box : legend.findChildren<QCheckBox*>()) texts << box->text();
    return texts;
  }
  void startTool() {
    window_->findChild<QAction*>("tools.seeds")->trigger();
    window_->view().setFocus();
  }
  void undo() { partOf<Document>(*window_).undoStack()->undo(); }
  [[nodiscard]] double area() const { return window_->controller().finishedRun()->result.summary.area; }
  [[nodiscard]] std::vector<Vec3> seeds() const {
    return seedsOf(partOf<Document>(*window_), filterOfSeeds(partOf<Document>(*window_)));
  }
  [[nodiscard]] FilterRow* row() const {
    const int id = filterOfSeeds(partOf<Document>(*window_));
    for (FilterRow* row : partOf<FilterList>(*window_).rows())
      if (row->entryId() == id) return row;
    return nullptr;
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestSeeds)
#include "test_seeds.moc"
