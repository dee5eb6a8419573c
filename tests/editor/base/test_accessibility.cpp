// Everything in the window can be reached with the keyboard, is seen to have it, and has a name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QMenuBar>
#include <QScrollBar>
#include <QSet>
#include <QTabBar>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/look/theme.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/widgets/focus_ring.hpp"
#include "ui/window/welcome_page.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

QString describe(const QWidget* widget) {
  QString text = QString("%1 '%2'").arg(widget->metaObject()->className(), widget->objectName());
  for (const QWidget* parent = widget->parentWidget(); parent && !parent->isWindow(); parent = parent->parentWidget()) {
    if (!parent->objectName().isEmpty()) return text + " in '" + parent->objectName() + '\'';
  }
  return text;
}

/// Parts of Qt's own widgets, which these take care of.
bool isInternal(const QWidget* widget) {
  if (widget->objectName().startsWith("qt_")) return true;
  for (const QWidget* parent = widget->parentWidget(); parent; parent = parent->parentWidget()) {
    if (qobject_cast<const QComboBox*>(parent) || qobject_cast<const QLineEdit*>(parent) ||
        qobject_cast<const QTabBar*>(parent) || qobject_cast<const QScrollBar*>(parent))
      return true;
  }
  const QByteArray name = widget->metaObject()->className();
  if (qobject_cast<const QHeaderView*>(widget) || qobject_cast<const QTabBar*>(widget) || name == "QTableCornerButton")
    return true;
  return name == "QDockWidgetTitleButton" || name == "QToolBarExtension" || name == "QLineEditIconButton";
}

/// Neither it nor what it is part of is shown at present; docks behind others are.
bool isTakenAway(const QWidget* widget) {
  for (; widget && !widget->isWindow(); widget = widget->parentWidget()) {
    if (widget->isHidden() && !qobject_cast<const QDockWidget*>(widget)) return true;
  }
  return false;
}

bool isControl(const QWidget* widget) {
  if (qobject_cast<const QLabel*>(widget)) return false;  // texts that can be selected with the mouse
  return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
         qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractItemView*>(widget) ||
         (qobject_cast<const QAbstractSlider*>(widget) && !qobject_cast<const QScrollBar*>(widget)) ||
         widget->focusPolicy() != Qt::NoFocus;
}

QString nameOf(const QWidget* widget) {
  if (!widget->accessibleName().isEmpty()) return widget->accessibleName();
  if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
    // A lone sign is no name.
    for (const QChar c : button->text()) {
      if (c.isLetter()) return button->text();
    }
  }
  for (const QLabel* label : widget->window()->findChildren<QLabel*>()) {
    if (label->buddy() == widget && !label->text().isEmpty()) return label->text();
  }
  return {};
}

}  // namespace

class TestAccessibility : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    table_ = writeFile(folder_, "table.obj", tableObj());
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1600, 1000);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 45\nVerticalClearanceFilter 2\nAutoStrategy\nCollapse\n"));
    // Everything open that can be.
    for (auto* dock : window_->findChildren<QDockWidget*>()) dock->show();
    QTest::qWait(200);
  }
  void cleanupTestCase() { window_.reset(); }

  void everyControlHasANameAndAToolTip() {
    QStringList nameless, wordless;
    for (const QWidget* widget : window_->findChildren<QWidget*>()) {
      if (widget->isWindow() || isInternal(widget) || !isControl(widget) || isTakenAway(widget)) continue;
      if (nameOf(widget).isEmpty() && widget->toolTip().isEmpty()) nameless << describe(widget);
      const auto* button = qobject_cast<const QAbstractButton*>(widget);
      if (button && nameOf(widget).isEmpty()) nameless << describe(widget);
      if (button && button->text().isEmpty() && button->toolTip().isEmpty()) wordless << describe(widget);
    }
    QVERIFY2(nameless.isEmpty(), qPrintable("no name: " + nameless.join("; ")));
    QVERIFY2(wordless.isEmpty(), qPrintable("no tool tip: " + wordless.join("; ")));
  }

  void everyCommandSaysWhatItDoes() {
    QSet<QString> ids, keys;
    for (const CommandRegistry::Entry& entry : partOf<CommandRegistry>(*window_).entries()) {
      QVERIFY2(!entry.action->text().isEmpty(), qPrintable(entry.command.id));
      QVERIFY2(!ids.contains(entry.command.id), qPrintable("twice: " + entry.command.id));
      ids << entry.command.id;
      if (entry.action->shortcutContext() != Qt::WindowShortcut) continue;
      for (const QKeySequence& key : entry.action->shortcuts()) {
        QVERIFY2(!keys.contains(key.toString()), qPrintable("two commands for " + key.toString()));
        keys << key.toString();
      }
    }
  }

  void tabReachesEveryControl() {
    partOf<MessageBar>(*window_).showHint(
        "A word", "Do it", [] {}, "Leave it", [] {});
    QSet<QWidget*> wanted;
    for (QWidget* widget : window_->findChildren<QWidget*>()) {
      const bool tabs = (widget->focusPolicy() & Qt::TabFocus) != 0;
      const bool control = isControl(widget) && !isInternal(widget) && !widget->isWindow();
      if (control && widget->isVisible() && widget->isEnabled() && (tabs || !inToolBar(widget))) wanted << widget;
    }
    QVERIFY(wanted.size() > 20);
    window_->view().setFocus();
    for (int i = 0; i < 600 && !wanted.isEmpty(); ++i) {
      wanted.remove(QApplication::focusWidget());
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    QStringList missed;
    for (const QWidget* widget : wanted) missed << describe(widget);
    QVERIFY2(missed.isEmpty(), qPrintable("not reached: " + missed.join("; ")));
  }

  void theFocusIsSeen() {
    auto* ring = window_->findChild<FocusRing*>();
    QVERIFY(ring);
    window_->view().setFocus();
    int seen = 0;
    for (int i = 0; i < 40; ++i) {
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
      QWidget* now = QApplication::focusWidget();
      QVERIFY(now);
      if (now->window() != window_.get()) continue;
      QVERIFY2(ring->target() == now, qPrintable(describe(now)));
      ++seen;
    }
    QVERIFY(seen > 30);
    QTest::mouseClick(openField(*window_, 0), Qt::LeftButton);
    QVERIFY(!ring->target());
  }

  void everyMenuEntryCanBeReached() {
    for (const QAction* menu : window_->menuBar()->actions())
      QVERIFY2(menu->text().contains('&'), qPrintable("no mnemonic: " + menu->text()));
  }

  void textsFitOnASmallScreen() {
    for (auto* dock : window_->findChildren<QDockWidget*>()) {
      const bool left = dock->objectName() == "environmentDock" || dock->objectName() == "filterDock";
      dock->setVisible(left);
    }
    window_->resize(1280, 800);
    QTest::qWait(200);
    QCOMPARE(window_->size(), QSize(1280, 800));
    for (const QWidget* widget : window_->findChildren<QWidget*>()) {
      if (!widget->isVisible() || isInternal(widget)) continue;
      const auto* label = qobject_cast<const QLabel*>(widget);
      const auto* button = qobject_cast<const QAbstractButton*>(widget);
      const bool text = (label && !label->text().isEmpty() && !label->wordWrap() && !label->text().startsWith('<')) ||
                        (button && !button->text().isEmpty());
      // The summary in the status bar may be longer than the window; its tool tip has all of it.
      if (!text || widget->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored) continue;
      QVERIFY2(widget->width() + 1 >= std::min(widget->sizeHint().width(), widget->minimumSizeHint().width()),
               qPrintable("cut off: " + describe(widget) + (label ? label->text() : button->text())));
    }
  }

 private:
  // Their commands have keys and stand in the menus.
  static bool inToolBar(const QWidget* widget) {
    for (const QWidget* parent = widget->parentWidget(); parent; parent = parent->parentWidget()) {
      if (qobject_cast<const QToolBar*>(parent)) return true;
    }
    return false;
  }

  QTemporaryDir folder_;
  std::unique_ptr<EditorWindow> window_;
  QString table_;
};

FOOTFALL_EDITOR_SUITE(TestAccessibility)
#include "test_accessibility.moc"
