// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/widgets/number_field.hpp"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/filters/descriptor_text.hpp"
#include "footfall/pipeline.hpp"
#include "ui/base/commands/keys_back.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

constexpr double kPixelsPerStep = 4;
constexpr double kFiner = 0.1;
constexpr double kCoarser = 10;
constexpr int kWheelStep = 120;  // QWheelEvent::angleDelta() of one notch

double factorOf(Qt::KeyboardModifiers modifiers) {
  return modifiers.testFlag(Qt::ShiftModifier) ? kFiner : modifiers.testFlag(Qt::ControlModifier) ? kCoarser : 1;
}

// The core's message with the label that users see: "Maximum slope 95 is out of range; give ...".
QString problemOf(const ParameterDescriptor& parameter, double value) {
  const std::string label = filterText(parameter.label).toStdString();
  ParameterDescriptor shown = parameter;
  shown.name = label;
  return coreText(checkValue(shown, value));
}

// Keeps the shortest digits: 2.1 and not 2.1000000000000001.
double tidy(double value) { return QString::number(value, 'g', 12).toDouble(); }

}  // namespace

QString unitText(Unit unit, const LevelUnits& units) {
  switch (unit) {
    case Unit::Degrees:
      return NumberField::tr("degrees");
    case Unit::Length:
      return units.name();
    case Unit::Area:
      return units.areaName();
    case Unit::Count:
    case Unit::None:
      break;
  }
  return {};
}

NumberField::NumberField(const ParameterDescriptor& parameter, QWidget* parent)
    : QLineEdit(parent), parameter_(parameter), asShown_(parameter) {
  setAlignment(Qt::AlignRight);
  setCursor(Qt::SizeHorCursor);
  selectNumberByDoubleClick(*this);
  connect(this, &QLineEdit::textEdited, this, &NumberField::readText);
}

void NumberField::setUnits(const LevelUnits& units) {
  if (units == units_) return;
  units_ = units;
  const double factor = units.factor(parameter_.unit);
  asShown_ = parameter_;
  // The end of the type's range is no limit for users.
  if (parameter_.minimum > std::numeric_limits<double>::lowest()) asShown_.minimum = parameter_.minimum * factor;
  if (parameter_.maximum < std::numeric_limits<double>::max()) asShown_.maximum = parameter_.maximum * factor;
  if (factor != 1) asShown_.unit = Unit::None;  // the core's texts give the file's units
  if (text().isEmpty()) return;
  number_ = units.shown(value_, parameter_.unit);
  setProblem({});
  showNumber();
}

void NumberField::setValue(double value) {
  const auto typed = parseNumber(text());
  value_ = value;
  setProblem({});
  if (typed && units_.stored(*typed, parameter_.unit) == value) {
    number_ = *typed;
    return;
  }
  number_ = units_.shown(value, parameter_.unit);
  showNumber();
}

QString NumberField::textOf(double number) const {
  return parameter_.type == ParameterType::Real ? numberText(number)
                                                : QString::fromStdString(formatValue(parameter_, number));
}

// Shows the number from its beginning, because its last digits matter least.
void NumberField::showNumber() {
  setText(textOf(number_));
  if (!hasFocus()) setCursorPosition(0);
}

void NumberField::take(double number) {
  number_ = number;
  const double value = units_.stored(number, parameter_.unit);
  if (value == value_) return;
  value_ = value;
  emit valueEdited(value_);
}

QString NumberField::problemOf(double number) const {
  const QString wrong = ::footfall::ui::problemOf(asShown_, number);
  return wrong.isEmpty() ? ::footfall::ui::problemOf(parameter_, units_.stored(number, parameter_.unit)) : wrong;
}

void NumberField::readText(const QString& text) {
  const auto number = parseNumber(text);
  if (!number) {
    const bool comma = text.contains(QLatin1Char(','));
    setProblem(!comma ? tr("not a number; give %1").arg(coreText(describeRange(asShown_)))
               : numberLocale().decimalPoint() == QLatin1String(",")
                   ? tr("not a number; leave out what stands between thousands")
                   : tr("not a number; write decimals with a point"));
    return;
  }
  const QString wrong = problemOf(*number);
  setProblem(wrong);
  if (wrong.isEmpty()) take(*number);
}

void NumberField::setProblem(const QString& problem) {
  if (problem == problem_) return;
  problem_ = problem;
  setProperty("invalid", !problem.isEmpty());
  style()->unpolish(this);  // the style sheet depends on the property
  style()->polish(this);
  emit problemChanged();
}

double NumberField::stepSize() const {
  if (parameter_.type != ParameterType::Real || parameter_.unit == Unit::Degrees) return 1;
  // A tenth of the leading digit's weight: 2 becomes 2.1, 40 becomes 41.
  return number_ == 0 ? 0.1 : std::pow(10.0, std::floor(std::log10(std::abs(number_))) - 1);
}

void NumberField::stepBy(double steps) {
  const double step = stepSize() * std::min(std::abs(steps), 1.0);
  const double grain = parameter_.type == ParameterType::Real ? step : std::max(1.0, step);
  const double whole = steps > 0 ? std::max(steps, 1.0) : std::min(steps, -1.0);
  const double next = tidy(std::round(number_ / grain + whole) * grain);
  if (!problemOf(next).isEmpty()) return;
  setText(textOf(next));
  readText(text());
}

QString NumberField::takeNear(double wanted, double grain) {
  const double asked = tidy(std::round(wanted / grain) * grain);
  const QString wrong = problemOf(asked);
  double next = asked;
  if (asked > asShown_.maximum || (asked == asShown_.maximum && asShown_.maximumOpen)) {
    next = tidy(std::floor(asShown_.maximum / grain) * grain);
    if (next == asShown_.maximum && asShown_.maximumOpen) next = tidy(next - grain);
  } else if (asked < asShown_.minimum || (asked == asShown_.minimum && asShown_.minimumOpen)) {
    next = tidy(std::ceil(asShown_.minimum / grain) * grain);
    if (next == asShown_.minimum && asShown_.minimumOpen) next = tidy(next + grain);
  }
  if (next != number_ && problemOf(next).isEmpty()) {
    setText(textOf(next));
    take(next);
  }
  return wrong;
}

// --- Dragging -------------------------------------------------------------------------------------------------------

void NumberField::takeDragsOf(QWidget* label) {
  label->setCursor(Qt::SizeHorCursor);
  label->installEventFilter(this);
}

void NumberField::beginDrag(double x, bool onField) { drag_ = Drag{number_, stepSize(), 0, x, x, false, onField}; }

void NumberField::dragTo(double x, Qt::KeyboardModifiers modifiers) {
  if (!drag_) return;
  if (!drag_->moved) {
    if (std::abs(x - drag_->start) < QApplication::startDragDistance()) return;
    drag_->moved = true;
    drag_->x = drag_->start;
    ++editSession_;
    setCursor(Qt::SizeHorCursor);
    if (!problem_.isEmpty()) showNumber();
    emit draggingChanged(true);
  }
  const double factor = factorOf(modifiers);
  drag_->steps += (x - drag_->x) / kPixelsPerStep * factor;
  drag_->x = x;
  const bool whole = parameter_.type != ParameterType::Real;
  const double grain = whole ? 1 : drag_->step * factor;
  const QString wrong = takeNear(drag_->from + drag_->steps * drag_->step, grain);
  setProblem(wrong.isEmpty() ? QString() : tr("%1; it stays %2").arg(wrong, text()));
}

void NumberField::endDrag(bool keep) {
  if (!drag_) return;
  const Drag drag = *std::exchange(drag_, std::nullopt);
  if (!drag.moved) return;
  if (!keep && number_ != drag.from) {
    setText(textOf(drag.from));
    take(drag.from);
  }
  setProblem({});
  ++editSession_;  // the next change is another edit
  setCursor(hasFocus() ? Qt::IBeamCursor : Qt::SizeHorCursor);
  emit draggingChanged(false);
}

void NumberField::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !std::exchange(focusedByClick_, false)) {
    QLineEdit::mousePressEvent(event);
    return;
  }
  beginDrag(event->globalPosition().x(), true);
  event->accept();
}

void NumberField::mouseMoveEvent(QMouseEvent* event) {
  if (drag_) {
    dragTo(event->globalPosition().x(), event->modifiers());
  } else {
    QLineEdit::mouseMoveEvent(event);
  }
}

// A click without a drag begins typing.
void NumberField::mouseReleaseEvent(QMouseEvent* event) {
  if (!drag_) {
    QLineEdit::mouseReleaseEvent(event);
    return;
  }
  const bool click = !drag_->moved;
  endDrag(true);
  if (click) selectAll();
}

bool NumberField::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (mouse->button() != Qt::LeftButton || !isEnabled()) break;
      setFocus(Qt::OtherFocusReason);  // so that the field receives Escape
      beginDrag(mouse->globalPosition().x(), false);
      return true;  // the widget below would take the focus and end the drag
    }
    case QEvent::MouseMove: {
      if (!drag_) break;
      const auto* mouse = static_cast<QMouseEvent*>(event);
      dragTo(mouse->globalPosition().x(), mouse->modifiers());
      return true;
    }
    case QEvent::MouseButtonRelease:
      if (!drag_) break;
      if (!drag_->moved) selectAll();
      endDrag(true);
      return true;
    default:
      break;
  }
  return QLineEdit::eventFilter(watched, event);
}

void NumberField::wheelEvent(QWheelEvent* event) {
  if (!hasFocus() || drag_) {
    event->ignore();  // the list scrolls
    return;
  }
  const QPoint turned = event->angleDelta();
  wheel_ += turned.y() != 0 ? turned.y() : turned.x();
  const int notches = wheel_ / kWheelStep;
  wheel_ -= notches * kWheelStep;
  const double factor = factorOf(event->modifiers());
  for (int i = 0; i < std::abs(notches); ++i) stepBy(notches > 0 ? factor : -factor);
  event->accept();
}

// --- Keys -----------------------------------------------------------------------------------------------------------

bool NumberField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return true;
    }
    // Escape cancels a run only where this field has nothing to reset.
    if (key->key() == Qt::Key_Escape && (drag_ || !problem_.isEmpty())) {
      event->accept();
      return true;
    }
  }
  if (event->type() == QEvent::ToolTip && !text().isEmpty()) {
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), help(), this);
    return true;
  }
  return QLineEdit::event(event);
}

// The number with every digit, because the field may be too narrow for it, and the value of the file where that
// differs.
QString NumberField::help() const {
  QString full = textOf(number_);
  const QString unit = unitText(parameter_.unit, units_);
  if (!unit.isEmpty()) full += QLatin1Char(' ') + unit;
  if (units_.factor(parameter_.unit) != 1) {
    const LevelUnits file;
    full = tr("%1 = %2 %3 of the file").arg(full, textOf(value_), unitText(parameter_.unit, file));
  }
  return QStringLiteral("<p><b>%1</b></p>").arg(full) + toolTip();
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
      stepBy(factorOf(event->modifiers()));
      return;
    case Qt::Key_Down:
      stepBy(-factorOf(event->modifiers()));
      return;
    case Qt::Key_PageUp:
      stepBy(kCoarser);
      return;
    case Qt::Key_PageDown:
      stepBy(-kCoarser);
      return;
    case Qt::Key_Escape:
      if (drag_) {
        endDrag(false);
        return;
      }
      showNumber();
      setProblem({});
      giveKeysBack(*this);
      return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      QLineEdit::keyPressEvent(event);
      if (problem_.isEmpty() && giveKeysBack(*this)) event->accept();  // dialogs handle the key themselves
      return;
    default:
      QLineEdit::keyPressEvent(event);
  }
}

void NumberField::focusInEvent(QFocusEvent* event) {
  ++editSession_;
  focusedByClick_ = event->reason() == Qt::MouseFocusReason;
  wheel_ = 0;
  setCursor(Qt::IBeamCursor);
  QLineEdit::focusInEvent(event);
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  endDrag(true);
  focusedByClick_ = false;
  setCursor(Qt::SizeHorCursor);
  QLineEdit::focusOutEvent(event);
  deselect();
  setCursorPosition(0);
}

}  // namespace footfall::ui
