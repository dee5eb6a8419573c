// Rows of the filter list: what they show of the run that is shown, how they open, are dragged, added and mended.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/filters/filter_list.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "DegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter 2\nAreaFilter 0.5\n";

}  // namespace

class TestFilterRows : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()), kPipeline));
  }
  void cleanup() { window_.reset(); }

  // Undo goes back to the result that is shown, whatever a failed, cancelled or overtaken run left.
  void rowsShowTheRunThatIsShownAfterUndo() {
    const QString figures = row(2)->figuresText();
    partOf<Document>(*window_).addFilter(filterDescriptor(FilterType::Collapse), 1);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(row(4)->stateText(), QString("failed"));
    undo();
    expectShown(figures);
    // The runs are one that is overtaken, one that is cancelled, and one that nothing waits for.
    for (const int kind : {0, 1, 2}) {
      partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[1].id, 0, 30 + kind, kind);
      if (kind == 0) partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[2].id, 0, 1.5, kind + 10);
      if (kind == 1) window_->controller().cancel();
      while (partOf<Document>(*window_).undoStack()->index() > 0) undo();
      QVERIFY(waitUntilIdle(*window_));
      expectShown(figures);
    }
  }

  void aCancelledRunLeavesOtherListsAlone() {
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[1].id, 0, 30, 1);
    window_->controller().cancel();
    QCOMPARE(row(0)->stateText(), QString("done"));
    QCOMPARE(row(3)->stateText(), QString("cancelled"));
    window_->controller().setAutomatic(false);
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[1].id, 0, 31, 2);
    QCOMPARE(row(3)->stateText(), QString("out of date"));
    undo();
    QCOMPARE(row(3)->stateText(), QString("cancelled"));
    undo();
    QCOMPARE(row(3)->stateText(), QString("done"));
  }

  void equalRowsThatChangePlacesStayDone() {
    Document& document = partOf<Document>(*window_);
    document.addFilter(filterDescriptor(FilterType::Degeneracy), 1);
    document.moveFilter(document.filters()[4].id, 1);
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(document.filters()[0].step, document.filters()[1].step);
    window_->controller().setAutomatic(false);
    const int first = document.filters()[0].id;
    document.moveFilter(first, 1);
    QCOMPARE(document.filters()[1].id, first);
    QVERIFY(window_->controller().upToDate());
    for (int i = 0; i < 5; ++i)
      QVERIFY2(row(i)->stateText() == "done" || row(i)->stateText() == "cached", qPrintable(row(i)->stateText()));
  }

  void aClickOnANameSelectsAndOpensTheRow() {
    QTest::mouseClick(row(2)->nameLabel(), Qt::LeftButton);
    QCOMPARE(selected(), (QList<int>{2}));
    QCOMPARE(enabled(), (QList<bool>{true, true, true, true}));
    QVERIFY(row(2)->field(0)->isVisible());
    QVERIFY(!row(1)->field(0)->isVisible());
    QCOMPARE(row(1)->summaryText(), QString::fromUtf8("45°  ·  0.01°"));
    const int open = row(2)->height();
    QTest::mouseClick(row(1)->nameLabel(), Qt::LeftButton);
    QTRY_VERIFY(row(2)->height() < open);
  }

  // Long names, as languages other than English have them, are not shortened: they take more lines.
  void namesWrapAndNeverLoseLetters() {
    window_->resize(700, 600);
    QDockWidget* dock = window_->findChild<QDockWidget*>("filterDock");
    QVERIFY(dock);
    window_->resizeDocks({dock}, {1}, Qt::Horizontal);
    QTest::qWait(50);
    QLabel* name = row(2)->nameLabel();
    for (const QString text : {"Durchgangshöhe", "Aufteilung in Ebenen", "Sortiert rekursiv aufgeteilte Umgebung"}) {
      name->setText(text);
      QTRY_VERIFY2(name->height() >= name->heightForWidth(name->width()), qPrintable(text));
    }
  }

  // Not only by the dots. A press into several selected rows takes them all along.
  void rowsAreDraggedByTheirHeader() {
    QWidget* name = row(1)->nameLabel();
    const QPoint below = name->mapFromGlobal(row(3)->mapToGlobal(QPoint(30, row(3)->height() - 2)));
    QTest::mousePress(name, Qt::LeftButton);
    QTest::mouseMove(name, name->rect().center() + QPoint(2, 1));  // a trembling hand drags nothing
    QTest::mouseMove(name, below / 2);
    QTest::mouseMove(name, below);
    QTest::mouseRelease(name, Qt::LeftButton, Qt::NoModifier, below);
    QCOMPARE(names(), (QStringList{"Degeneracy", "Clearance", "Area", "Slope"}));
  }

  void filtersAreAddedBehindTheSelection() {
    click(2);
    QMenu* menu = addMenu();
    QCOMPARE(menu->actions().front()->text(), QString("Behind Vertical clearance"));
    actionFor(menu, "StepFilter")->trigger();
    QCOMPARE(names(), (QStringList{"Degeneracy", "Slope", "Clearance", "Step", "Area"}));
    QCOMPARE(selected(), (QList<int>{3}));
    QCOMPARE(undoText(), QString("Add Steps"));
    // A strategy comes with its Collapse, around the local filters that follow.
    click(0);
    actionFor(addMenu(), "GridStrategy")->trigger();
    QCOMPARE(names().mid(0, 5), (QStringList{"Degeneracy", "GridStrategy", "Slope", "Clearance", "Step"}));
    QVERIFY(names().contains("Collapse"));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->controller().upToDate());
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(names(), (QStringList{"Degeneracy", "Slope", "Clearance", "Step", "Area"}));
  }

  void whatCannotRunThereSaysWhy() {
    click(1);
    const QAction* steps = actionFor(addMenu(), "StepFilter");
    QVERIFY(!steps->isEnabled());
    QCOMPARE(steps->text(), QString("Steps: needs Vertical clearance before it"));
    QVERIFY(actionFor(addMenu(), "SlopeFilter")->isEnabled());
    partOf<Document>(*window_).replacePipeline(
        parsePipeline("GridStrategy 2 2\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n", "test"), "test");
    click(1);
    QMenu* menu = addMenu();
    QVERIFY(actionFor(menu, "DegeneracyFilter")->isEnabled());
    for (const char* filter : {"GridStrategy", "Collapse", "LayerSubdivisionFilter"})
      QVERIFY2(!actionFor(menu, filter)->isEnabled(), filter);
  }

  // Filters that need the clearance are skipped while it is off; one click enables it again.
  void rowsWithoutTheirClearanceAreSkipped() {
    partOf<Document>(*window_).replacePipeline(
        parsePipeline("SlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4\nAreaFilter 0.5\n", "test"), "test");
    QVERIFY(waitUntilIdle(*window_));
    QCOMPARE(row(2)->stateText(), QString("done"));
    click(1);
    key(Qt::Key_Space);
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->controller().upToDate());
    QVERIFY(partOf<MessageBar>(*window_).text().isEmpty());
    QCOMPARE(row(2)->stateText(), QString("skipped"));
    QCOMPARE(row(2)->errorText(), QString("needs Vertical clearance"));
    QVERIFY(row(2)->mendButton()->isVisible());
    QCOMPARE(row(2)->mendButton()->text(), QString("Switch Vertical clearance on"));
    QCOMPARE(row(3)->stateText(), QString("done"));
    QTest::mouseClick(row(2)->mendButton(), Qt::LeftButton);
    QTRY_COMPARE(enabled(), (QList<bool>{true, true, true, true}));
    QVERIFY(waitUntilIdle(*window_));
    for (int i = 0; i < 4; ++i) QVERIFY(!row(i)->mendButton()->isVisible());
    // A clearance is added where the list has none.
    click(1);
    key(Qt::Key_Delete);
    QTRY_COMPARE(row(1)->stateText(), QString("skipped"));
    QCOMPARE(row(1)->mendButton()->text(), QString("Add Vertical clearance"));
    QTest::mouseClick(row(1)->mendButton(), Qt::LeftButton);
    QTRY_COMPARE(names(), (QStringList{"Slope", "Clearance", "Step", "Area"}));
    QVERIFY(waitUntilIdle(*window_));
  }

  // Errors of the list itself appear on its rows before any run.
  void errorsAreForeseen() {
    window_->controller().setAutomatic(false);
    partOf<Document>(*window_).addFilter(filterDescriptor(FilterType::Collapse), 1);
    QCOMPARE(row(4)->stateText(), QString("failed"));
    QVERIFY(row(4)->errorText().contains("Collapse ends no parallel block"));
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(names().size(), 4);
    for (int i = 0; i < 4; ++i) QCOMPARE(row(i)->stateText(), QString("done"));
  }

 private:
  FilterRow* row(int index) { return partOf<FilterList>(*window_).rows()[static_cast<std::size_t>(index)]; }
  void click(int index) { QTest::mouseClick(row(index)->nameLabel(), Qt::LeftButton); }
  void key(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }
  void undo() { partOf<Document>(*window_).undoStack()->undo(); }
  void expectShown(const QString& figures) {
    QCOMPARE(names().size(), 4);
    QVERIFY(window_->controller().upToDate());
    for (int i = 0; i < 4; ++i) {
      QVERIFY2(row(i)->stateText() == "done" || row(i)->stateText() == "cached", qPrintable(row(i)->stateText()));
      QVERIFY(row(i)->errorText().isEmpty());
    }
    const auto& steps = window_->controller().finishedRun()->result.steps;
    const StepStatus status = window_->controller().status(row(2)->entryId());
    QCOMPARE(status.trianglesIn.value(), steps[2].in.triangles);
    QCOMPARE(status.trianglesOut.value(), steps[2].out.triangles);
    QCOMPARE(row(2)->figuresText(), figures);
  }
  QMenu* addMenu() {
    QMenu* menu = partOf<FilterList>(*window_).addButton()->menu();
    emit menu->aboutToShow();
    return menu;
  }
  static QAction* actionFor(QMenu* menu, const char* filter) {
    for (QAction* action : menu->actions()) {
      if (action->data() == QVariant(filter)) return action;
    }
    qFatal("no filter %s", filter);
  }
  QString undoText() { return partOf<Document>(*window_).undoStack()->undoText(); }
  QList<int> selected() {
    QList<int> indices;
    for (std::size_t i = 0; i < partOf<FilterList>(*window_).rows().size(); ++i) {
      if (partOf<FilterList>(*window_).selection().contains(partOf<FilterList>(*window_).rows()[i]->entryId()))
        indices << static_cast<int>(i);
    }
    return indices;
  }
  QList<bool> enabled() {
    QList<bool> on;
    for (const FilterEntry& entry : partOf<Document>(*window_).filters()) on << entry.step.enabled;
    return on;
  }
  QStringList names() {
    QStringList names;
    for (QString name : filterNames(*window_)) names << name.replace("VerticalClearance", "Clearance").remove("Filter");
    return names;
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestFilterRows)
#include "test_filter_rows.moc"
