// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/commands/keys_back.hpp"

#include <QDialog>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMouseEvent>

namespace footfall::ui {
namespace {

constexpr const char* kKeysGoTo = "keysGoTo";

class EscapeWatch : public QObject {
 public:
  explicit EscapeWatch(QLineEdit& field) : QObject(&field), field_(field) { field.installEventFilter(this); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::KeyPress || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
      return QObject::eventFilter(watched, event);
    return giveKeysBack(field_);
  }

 private:
  QLineEdit& field_;
};

class DoubleClickWatch : public QObject {
 public:
  explicit DoubleClickWatch(QLineEdit& field) : QObject(&field), field_(field) { field.installEventFilter(this); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::MouseButtonDblClick || static_cast<QMouseEvent*>(event)->button() != Qt::LeftButton)
      return QObject::eventFilter(watched, event);
    field_.selectAll();
    return true;
  }

 private:
  QLineEdit& field_;
};

}  // namespace

void setKeysGoTo(QWidget& central, QWidget& child) {
  central.setProperty(kKeysGoTo, QVariant::fromValue<QWidget*>(&child));
}

bool giveKeysBack(QWidget& field) {
  for (QWidget* widget = field.parentWidget(); widget != nullptr; widget = widget->parentWidget()) {
    if (qobject_cast<QDialog*>(widget)) return false;
    const auto* window = qobject_cast<QMainWindow*>(widget);
    if (!window || !window->centralWidget()) continue;
    if (field.window() != widget) widget->activateWindow();  // out of a dock that floats
    auto* child = window->centralWidget()->property(kKeysGoTo).value<QWidget*>();
    (child ? child : window->centralWidget())->setFocus(Qt::OtherFocusReason);
    return true;
  }
  return false;
}

void giveKeysBackAfterTyping(QLineEdit& field) {
  QObject::connect(&field, &QLineEdit::returnPressed, &field, [&field] { giveKeysBack(field); });
  new EscapeWatch(field);
}

void giveKeysBackAfterClick(QAbstractButton& button) {
  QObject::connect(&button, &QAbstractButton::clicked, &button, [&button] { giveKeysBack(button); });
}

void selectNumberByDoubleClick(QLineEdit& field) { new DoubleClickWatch(field); }

}  // namespace footfall::ui
