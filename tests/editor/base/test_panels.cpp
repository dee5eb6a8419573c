// Docks and their commands: raised from behind tabs, never wider than they were made, at home on small screens.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QMenuBar>
#include <QSet>
#include <QToolBar>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/commands/command_palette.hpp"
#include "ui/base/commands/translations.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/widgets/panel_dock.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/window/window_placement.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr QSize kSmallScreen(1024, 700);

struct PanelCommand {
  QAction* action;
  QDockWidget* dock;
};

QList<QDockWidget*> docksOf(const EditorWindow& window) {
  return window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly);
}

/// The commands of the submenu Panels, with the docks that they show.
std::vector<PanelCommand> panelCommands(EditorWindow& window) {
  std::vector<PanelCommand> panels;
  for (const CommandRegistry::Entry& entry : partOf<CommandRegistry>(window).entries()) {
    if (entry.command.menu != CommandMenu::View || entry.command.group != "panels") continue;
    for (QDockWidget* dock : docksOf(window)) {
      const bool its = plainText(entry.action->text()) == dock->windowTitle();
      if (its) panels.push_back({entry.action, dock});
    }
  }
  return panels;
}

/// Names the mnemonics that two visible entries of one menu share.
void collectClashes(const QMenu& menu, QStringList& clashes) {
  QMap<QChar, QString> taken;
  for (const QAction* action : menu.actions()) {
    if (action->menu()) collectClashes(*action->menu(), clashes);
    if (!action->isVisible()) continue;
    QString text = action->text();
    text.replace("&&", "");
    const qsizetype at = text.indexOf('&');
    if (at < 0 || at + 1 >= text.size()) continue;
    const QChar key = text[at + 1].toLower();
    if (taken.contains(key)) clashes << menu.title() + ": " + taken[key] + " / " + text;
    taken[key] = text;
  }
}

}  // namespace

class TestPanels : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    open(QSize(1200, 900));
  }
  void cleanup() { window_.reset(); }

  void everyDockHasACommand() {
    QSet<QDockWidget*> reached;
    for (const PanelCommand& panel : panelCommands(*window_)) reached << panel.dock;
    for (QDockWidget* dock : docksOf(*window_)) QVERIFY2(reached.contains(dock), qPrintable(dock->objectName()));
  }

  void aPanelsCommandShowsRaisesAndHides() {
    const auto panels = panelCommands(*window_);
    for (const PanelCommand& panel : panels) {
      for (const PanelCommand& other : panels) {
        const bool neighbours = window_->dockWidgetArea(panel.dock) == window_->dockWidgetArea(other.dock);
        if (!neighbours || panel.dock == other.dock) continue;
        bringToFront(*panel.dock);
        bringToFront(*other.dock);
        QTRY_VERIFY(isInFront(*other.dock));
        if (isInFront(*panel.dock)) continue;  // one above the other
        QVERIFY2(!panel.action->isChecked(), qPrintable(panel.dock->objectName()));
        panel.action->trigger();
        QTRY_VERIFY2(isInFront(*panel.dock), qPrintable(panel.dock->objectName()));
        QTRY_VERIFY(panel.action->isChecked());
        break;
      }
      bringToFront(*panel.dock);
      QTRY_VERIFY(panel.action->isChecked());
      panel.action->trigger();
      QVERIFY2(panel.dock->isHidden(), qPrintable(panel.dock->objectName()));
      QVERIFY(!panel.action->isChecked());
      panel.action->trigger();
      QTRY_VERIFY2(isInFront(*panel.dock), qPrintable(panel.dock->objectName()));
    }
  }

  void theFocusFollowsThePanel() {
    QAction* layers = window_->findChild<QAction*>("panel.layers");
    auto* dock = window_->findChild<QDockWidget*>("panel.layers");
    window_->view().setFocus();
    layers->trigger();
    QTRY_VERIFY(dock->isAncestorOf(QApplication::focusWidget()));
    layers->trigger();
    QCOMPARE(QApplication::focusWidget(), &window_->view());
  }

  void keysOfToolsRaiseTheirPanels_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<QString>("panel");
    QTest::newRow("path") << int(Qt::Key_P) << "panel.path";
    QTest::newRow("measure") << int(Qt::Key_M) << "panel.measure";
    QTest::newRow("why") << int(Qt::Key_Y) << "inspect.whyPanel";
  }
  void keysOfToolsRaiseTheirPanels() {
    QFETCH(int, key);
    QFETCH(QString, panel);
    auto* dock = window_->findChild<QDockWidget*>(panel);
    LevelView& view = window_->view();
    view.setFocus();
    QTest::keyClick(&view, Qt::Key(key));
    QTRY_VERIFY(isInFront(*dock));
    ViewTool* tool = view.tool();
    QVERIFY(tool);
    bringToFront(*window_->findChild<QDockWidget*>("panel.layers"));
    QTRY_VERIFY(!isInFront(*dock));
    QTest::keyClick(&view, Qt::Key(key));
    QTRY_VERIFY(isInFront(*dock));
    QCOMPARE(view.tool(), tool);
    QTest::keyClick(&view, Qt::Key(key));
    QVERIFY(!view.tool());
  }

  void docksKeepTheirWidthWhateverTheyShow() {
    auto* dock = window_->findChild<QDockWidget*>("filterDock");
    const int width = dock->width();
    const int view = window_->view().width();
    const QString longName = QString(180, 'w') + ".obj";
    QVERIFY(openZUp(*window_, writeFile(*folder_, longName, tableObj()),
                    "AutoStrategy\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\nSimplificationFilter\n"));
    QTest::qWait(100);
    QCOMPARE(dock->width(), width);
    auto* field = openField(*window_, 1);
    field->setFocus();
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, QString(90, '7'));
    QVERIFY(!partOf<FilterList>(*window_).rows()[1]->errorText().isEmpty());
    QTest::qWait(100);
    QCOMPARE(dock->width(), width);
    QCOMPARE(window_->view().width(), view);
  }

  void docksCanBeDraggedSmaller() {
    QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()),
                    "AutoStrategy\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n"));
    for (const char* name : {"filterDock", "panel.path", "view.obstacles", "inspect.components", "panel.measure"}) {
      auto* dock = window_->findChild<QDockWidget*>(name);
      bringToFront(*dock);
      QTest::qWait(50);
      window_->resizeDocks({dock}, {230}, Qt::Horizontal);
      QTRY_VERIFY2(dock->width() <= 232, qPrintable(QString("%1: %2").arg(name).arg(dock->width())));
    }
  }

  void noPanelNeedsMoreThanASmallScreen_data() {
    QTest::addColumn<double>("scale");
    QTest::newRow("usual font") << 1.0;
    QTest::newRow("large font") << 1.5;
  }
  void noPanelNeedsMoreThanASmallScreen() {
    QFETCH(double, scale);
    const QFont usual = QApplication::font();
    QFont font = usual;
    font.setPointSizeF(usual.pointSizeF() * scale);
    window_.reset();
    QApplication::setFont(font);
    open(kSmallScreen);
    QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()),
                    "AutoStrategy\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\nLayerSubdivisionFilter\n"));
    partOf<MessageBar>(*window_).showError(QString(40, 'x') + ": " + QString("a long story ").repeated(12));
    for (QDockWidget* dock : docksOf(*window_)) {
      bringToFront(*dock);
      QTest::qWait(30);
      QVERIFY2(window_->size() == kSmallScreen,
               qPrintable(QString("%1: %2 x %3").arg(dock->objectName()).arg(window_->width()).arg(window_->height())));
    }
    QApplication::setFont(usual);
  }

  void panelsFitTheDocksThatTheyOpenIn() {
    window_.reset();
    open(QSize(1440, 900));
    QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()),
                    "AutoStrategy\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\nLayerSubdivisionFilter\n"));
    for (QDockWidget* dock : docksOf(*window_)) {
      const auto* area = dock->findChild<PanelArea*>("panelArea");
      if (!area) continue;
      bringToFront(*dock);
      QTest::qWait(50);
      QVERIFY2(area->widget()->width() <= area->viewport()->width(), qPrintable(QString("%1: %2 in %3")
                                                                                    .arg(dock->objectName())
                                                                                    .arg(area->widget()->width())
                                                                                    .arg(area->viewport()->width())));
    }
  }

  void theFirstWindowFitsItsScreen() {
    const QMargins frame(4, 30, 4, 4);
    const QRect small(0, 28, 1440, 872);
    const QRect place = firstGeometry(small, frame, {1440, 900});
    QVERIFY(small.contains(place.marginsAdded(frame)));
    QCOMPARE(firstGeometry({0, 0, 3840, 2160}, frame, {1440, 900}).size(), QSize(1440, 900));
    QWidget window;
    placeAtFirst(window, {9000, 9000});
    QVERIFY(window.screen()->availableGeometry().contains(window.geometry()));
    QVERIFY(window.height() < window.screen()->availableGeometry().height());
  }

  void f11FillsTheScreen() {
    QTest::keyClick(window_.get(), Qt::Key_F11);
    QTRY_VERIFY(window_->isFullScreen());
    QTest::keyClick(window_.get(), Qt::Key_F11);
    QTRY_VERIFY(!window_->isFullScreen());
  }

  void menusAreShortAndTheirKeysUnique() {
    QStringList clashes;
    for (const QAction* action : window_->menuBar()->actions()) {
      QVERIFY(action->menu());
      collectClashes(*action->menu(), clashes);
      int entries = 0;
      for (const QAction* entry : action->menu()->actions()) entries += !entry->isSeparator() && entry->isVisible();
      QVERIFY2(entries <= 16, qPrintable(QString("%1: %2").arg(action->text()).arg(entries)));
    }
    QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join("; ")));
  }

  void noButtonStaysLitBehindADialog() {
    auto* bar = window_->findChild<QToolBar*>("toolBar");
    QWidget* button = bar->widgetForAction(window_->findChild<QAction*>("file.open"));
    QVERIFY(button);
    QCursor::setPos(button->mapToGlobal(button->rect().center()));
    QTRY_VERIFY(button->underMouse());
    QTest::mouseClick(button, Qt::LeftButton);
    QTRY_VERIFY(QApplication::activeModalWidget());
    QTRY_VERIFY(!button->underMouse());
    QApplication::activeModalWidget()->close();
    QCursor::setPos(window_->mapToGlobal(window_->rect().center()));
    QTest::qWait(100);
    QVERIFY(!button->underMouse());
  }

  void oneThingIsNotCountedAsMany() {
    FilterRow row(FilterEntry{1, defaultStep(filterDescriptor(FilterType::Slope), 1)});
    StepStatus status;
    status.state = StepState::Done;
    status.trianglesIn = 3;
    status.trianglesOut = 1;
    row.setStatus(status);
    QCOMPARE(row.figuresText(), QString("3 → 1 triangle"));
    status.trianglesIn.reset();
    row.setStatus(status);
    QCOMPARE(row.figuresText(), QString("1 triangle"));
    status.trianglesOut = 2;
    row.setStatus(status);
    QCOMPARE(row.figuresText(), QString("2 triangles"));
  }

  // "removed" must not appear beside numbers of walkable triangles that are the same before and after.
  void whatIsLeftOutSaysWhetherItWasWalkable() {
    QVERIFY(openZUp(*window_, writeFile(*folder_, "flat.obj", tableObj() + "v 0 -4 0\nv 4 0 0\nf 1 2 13\nf 2 3 14\n"),
                    "DegeneracyFilter\nSlopeFilter 45\n"));
    const StepStatus status = window_->controller().status(partOf<Document>(*window_).filters()[0].id);
    QCOMPARE(status.trianglesIn, status.trianglesOut);
    QCOMPARE(status.note, QString("2 triangles without area left out; none was walkable"));
  }

  void thePaletteFindsWhatIsInSubmenus() {
    const auto entries = commandEntries(partOf<CommandRegistry>(*window_));
    for (const CommandRegistry::Entry& entry : partOf<CommandRegistry>(*window_).entries()) {
      if (entry.action->menu()) continue;
      const QString title = plainText(entry.action->text());
      QVERIFY2(std::ranges::any_of(entries, [&](const PaletteEntry& found) { return found.title == title; }),
               qPrintable(title));
    }
    const auto top = std::ranges::find(entries, QString("From the top"), &PaletteEntry::title);
    QVERIFY(top != entries.end());
    QCOMPARE(top->detail, QString("View > Camera"));
  }

 private:
  void open(const QSize& size) {
    window_ = std::make_unique<EditorWindow>();
    window_->resize(size);
    QVERIFY(showWindow(*window_));
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestPanels)
#include "test_panels.moc"
