// The dialog with all settings: keys that can be edited, units, theme.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QSettings>

#include "tests/editor/editor_driver.hpp"
#include "ui/base/look/theme.hpp"
#include "ui/window/preferences.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

class TestPreferences : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    QSettings().clear();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1024, 700);
    QVERIFY(showWindow(*window_));
  }
  void cleanup() { window_.reset(); }

  void keysCanBeEdited() {
    Preferences& dialog = open();
    shoot(dialog, "preferences");
    select(dialog, "view.fit");
    const QKeySequence key(Qt::CTRL | Qt::SHIFT | Qt::Key_F9);
    type(dialog, key);
    QCOMPARE(window_->findChild<QAction*>("view.fit")->shortcut(), key);
    // A key of another command is refused, and by its name.
    select(dialog, "view.top");
    type(dialog, key);
    QVERIFY2(dialog.keyProblem().contains("already used by"), qPrintable(dialog.keyProblem()));
    QCOMPARE(window_->findChild<QAction*>("view.top")->shortcut(), QKeySequence(Qt::Key_T));
    // The next window has it.
    EditorWindow other;
    QCOMPARE(other.findChild<QAction*>("view.fit")->shortcut(), key);
    select(dialog, "view.fit");
    for (auto* button : dialog.findChildren<QPushButton*>())
      if (button->text() == "&Usual keys") button->click();
    QVERIFY(window_->findChild<QAction*>("view.fit")->shortcut() != key);
    QVERIFY(!QSettings().contains("keys/view.fit"));
  }

  void choicesTakeEffectAtOnce() {
    Preferences& dialog = open();
    choose(dialog, "preferredTheme", 2);
    QVERIFY(isDarkTheme());
    choose(dialog, "preferredTheme", 1);
    QVERIFY(!isDarkTheme());
    choose(dialog, "preferredScale", 4);
    QCOMPARE(interfaceScale(), 125);
    choose(dialog, "preferredScale", 2);
    QCOMPARE(interfaceScale(), 100);
  }

 private:
  Preferences& open() {
    window_->findChild<QAction*>("edit.preferences")->trigger();
    auto* dialog = window_->findChild<Preferences*>();
    if (!dialog) qFatal("no preferences");
    return *dialog;
  }
  static void select(Preferences& dialog, const QString& id) {
    QTreeWidget* table = dialog.keyTable();
    for (int i = 0; i < table->topLevelItemCount(); ++i)
      if (table->topLevelItem(i)->data(0, Qt::UserRole) == id) table->setCurrentItem(table->topLevelItem(i));
  }
  static void type(Preferences& dialog, const QKeySequence& key) {
    dialog.keyField()->setKeySequence(key);
    emit dialog.keyField()->editingFinished();
  }
  static void choose(Preferences& dialog, const QString& name, int index) {
    auto* box = dialog.findChild<QComboBox*>(name);
    QVERIFY(box);
    box->setCurrentIndex(index);
    emit box->activated(index);
  }

  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestPreferences)
#include "test_preferences.moc"
