// The command palette, the list of keys and the help panel, by keyboard and mouse.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/commands/command_palette.hpp"
#include "ui/base/commands/fuzzy_match.hpp"
#include "ui/base/commands/shortcut_window.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/window/help_panel.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

int score(const char* pattern, const char* text) {
  const auto match = fuzzyMatch(pattern, text);
  return match ? match->score : -1;
}

}  // namespace

class TestCommandPalette : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    table_ = writeFile(*folder_, "table.obj", tableObj());
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1100, 800);
    QVERIFY(showWindow(*window_));
  }
  void cleanup() { window_.reset(); }

  void fuzzyMatching() {
    QVERIFY(fuzzyMatch("sf", "Slope filter"));
    QVERIFY(!fuzzyMatch("fs", "Slope fit"));
    QVERIFY(!fuzzyMatch("slopes", "Slope"));
    QVERIFY(score("sf", "Slope filter") > score("sf", "Massif"));
    QVERIFY(score("open", "Open...") > score("open", "Stop evening"));
    QVERIFY(score("top", "From the top") > score("top", "Translate or pan"));
    QVERIFY(score("ADD slope", "Add Slope") > 0);
    QCOMPARE(fuzzyMatch("sf", "Slope filter")->positions, (QList<int>{0, 6}));
    QCOMPARE(fuzzyMatch("", "anything")->score, 0);
    QVERIFY(fuzzyMatch("ß", "Größe"));
    QVERIFY(fuzzyMatch(QString(500, 'a'), QString(5000, 'a')) == std::nullopt);  // beyond what is looked at
  }

  void opensWithCtrlKAndDoesWhatIsMarked() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    CommandPalette& palette = openPalette();
    QVERIFY(palette.titles().size() > 15);
    QTest::keyClicks(palette.field(), "add area");
    QCOMPARE(palette.titles().front(), QString("Add Area"));
    QTest::keyClick(palette.field(), Qt::Key_Return);
    QTRY_COMPARE(filterNames(*window_).back(), QString("AreaFilter"));
    QVERIFY(!palette.isVisible());
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);  // an edit like any other
    QCOMPARE(filterNames(*window_).size(), 1);
  }

  void aToolIsFoundBeforeItsPanel() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    for (const char* tool : {"Why?", "Try it", "Measure"}) {
      CommandPalette& palette = openPalette();
      QTest::keyClicks(palette.field(), tool);
      QCOMPARE(palette.titles().front(), QString(tool));
      QTest::keyClick(palette.field(), Qt::Key_Return);
      QTRY_VERIFY2(window_->view().tool(), tool);
      window_->view().setTool(nullptr);
    }
  }

  void wordsOfTheHelpAreFound() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    CommandPalette& palette = openPalette();
    // No title contains it; a sample whose title has these letters somewhere must not come first.
    QTest::keyClicks(palette.field(), "report");
    QVERIFY2(palette.titles().front().startsWith("Export"), qPrintable(palette.titles().front()));
    QTest::keyClick(palette.field(), Qt::Key_Escape);
  }

  void theMouseChoosesToo() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\n"));
    CommandPalette& palette = openPalette();
    QTest::keyClicks(palette.field(), "from the top");
    const QRect row = palette.list()->visualRect(palette.list()->model()->index(0, 0));
    QTest::mouseClick(palette.list()->viewport(), Qt::LeftButton, Qt::NoModifier, row.center());
    QTRY_VERIFY(window_->view().cameraController().pose().orthographic);
  }

  void arrowsMoveTheMarkAndEscCloses() {
    CommandPalette& palette = openPalette();
    QCOMPARE(palette.list()->currentIndex().row(), 0);
    QTest::keyClick(palette.field(), Qt::Key_Down);
    QTest::keyClick(palette.field(), Qt::Key_Down);
    QCOMPARE(palette.list()->currentIndex().row(), 2);
    QTest::keyClick(palette.field(), Qt::Key_Up);
    QCOMPARE(palette.list()->currentIndex().row(), 1);
    QTest::keyClick(palette.field(), Qt::Key_Escape);
    QVERIFY(!palette.isVisible());
  }

  void whatCannotBeDoneSaysSoAndDoesNothing() {
    CommandPalette& palette = openPalette();
    QTest::keyClicks(palette.field(), "undo");
    QCOMPARE(palette.titles().front(), QString("Undo"));
    const QModelIndex row = palette.list()->model()->index(0, 0);
    QVERIFY(row.data(Qt::AccessibleTextRole).toString().contains("not available now"));
    QVERIFY(!row.flags().testFlag(Qt::ItemIsEnabled));
    QTest::keyClick(palette.field(), Qt::Key_Return);
    QVERIFY(palette.isVisible());
  }

  void everyCommandIsThereWithItsKeys() {
    CommandPalette& palette = openPalette();
    const QStringList titles = palette.titles();
    for (const CommandRegistry::Entry& entry : partOf<CommandRegistry>(*window_).entries()) {
      if (!entry.action->menu())
        QVERIFY2(titles.contains(plainText(entry.action->text())), qPrintable(entry.command.id));
    }
    QTest::keyClicks(palette.field(), "oblique");
    QCOMPARE(palette.titles().front(), QString("Oblique"));
  }

  void opensRecentFilesAndSamples() {
    QSettings().setValue("recentFiles", QStringList{table_});
    CommandPalette& palette = openPalette();
    QTest::keyClicks(palette.field(), "sample house");
    QCOMPARE(palette.titles().front(), QString("Open sample House"));
    palette.field()->clear();
    QTest::keyClicks(palette.field(), "table.obj");
    QCOMPARE(palette.titles().front(), QString("Open table.obj"));
    QTest::keyClick(palette.field(), Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() != nullptr; }));
  }

  void nothingFoundIsSaid() {
    CommandPalette& palette = openPalette();
    QTest::keyClicks(palette.field(), "qqqqxx");
    QVERIFY(palette.titles().isEmpty());
    QTest::keyClick(palette.field(), Qt::Key_Return);
    QVERIFY(palette.isVisible());
  }

  void f1ListsAllKeysAndFindsThem() {
    QTest::keyClick(window_.get(), Qt::Key_F1);
    auto* keys = window_->findChild<ShortcutWindow*>();
    QTRY_VERIFY(keys && keys->isVisible());
    const auto shown = [&] {
      QStringList rows;
      for (int i = 0; i < keys->table()->topLevelItemCount(); ++i) {
        const QTreeWidgetItem* group = keys->table()->topLevelItem(i);
        for (int j = 0; j < group->childCount(); ++j) {
          if (!group->child(j)->isHidden()) rows << group->child(j)->text(0) + '|' + group->child(j)->text(1);
        }
      }
      return rows;
    };
    for (const CommandRegistry::Entry& entry : partOf<CommandRegistry>(*window_).entries()) {
      const QString row =
          plainText(entry.action->text()) + '|' +
          QKeySequence::listToString(entry.action->shortcuts(), QKeySequence::NativeText).replace("; ", ", ");
      if (!entry.action->menu()) QVERIFY2(shown().contains(row), qPrintable(row));
    }
    QTest::keyClicks(keys->search(), "Ctrl+K");
    QCOMPARE(shown(), QStringList{"Find a command...|Ctrl+K"});
    keys->search()->clear();
    QTest::keyClicks(keys->search(), "pivot");
    QCOMPARE(shown().size(), 1);
    QTest::keyClick(keys->search(), Qt::Key_Escape);
    QTRY_VERIFY(!window_->findChild<ShortcutWindow*>());
  }

  void helpFollowsTheFocus() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\nVerticalClearanceFilter 2\n"));
    window_->findChild<QAction*>("view.help")->trigger();
    HelpPanel& help = partOf<HelpPanel>(*window_);
    QTRY_VERIFY(help.isVisible());
    QVERIFY(help.toPlainText().contains("F1"));
    const auto& rows = partOf<FilterList>(*window_).rows();
    QTest::mouseClick(openField(*window_, 0), Qt::LeftButton);
    const FilterDescriptor& slope = filterDescriptor(FilterType::Slope);
    QTRY_VERIFY(help.toPlainText().contains(filterText(slope.help)));
    QVERIFY(help.toPlainText().contains(QString("▶ ") + filterText(slope.parameters[0].label)));
    rows[1]->enabledBox()->setFocus(Qt::TabFocusReason);
    QTRY_VERIFY(help.toPlainText().contains(filterText(filterDescriptor(FilterType::VerticalClearance).help)));
    window_->view().setFocus();
    QVERIFY(help.toPlainText().contains(filterText(filterDescriptor(FilterType::VerticalClearance).help)));
  }

 private:
  CommandPalette& openPalette() {
    QTest::keyClick(window_.get(), Qt::Key_K, Qt::ControlModifier);
    CommandPalette& palette = partOf<CommandPalette>(*window_);
    if (!QTest::qWaitFor([&] { return palette.isVisible(); })) qFatal("the palette did not open");
    palette.field()->setFocus();
    return palette;
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  QString table_;
};

FOOTFALL_EDITOR_SUITE(TestCommandPalette)
#include "test_command_palette.moc"
