// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/number_field.hpp"

#include <QApplication>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QWheelEvent>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "core/environment/number_text.hpp"
#include "core/filters/descriptor_text.hpp"
#include "core/pipeline/pipeline.hpp"
#include "ui/core_text.hpp"
#include "ui/filter_text.hpp"

namespace footfall {
namespace {

constexpr double kPixelsPerStep = 4;
constexpr double kFiner = 0.1;
constexpr double kCoarser = 10;
constexpr int kWheelStep = 120;  // QWheelEvent::angleDelta() of one notch

double factorOf(Qt::KeyboardModifiers modifiers) {
  return modifiers.testFlag(Qt::ShiftModifier) ? kFiner : modifiers.testFlag(Qt::ControlModifier) ? kCoarser : 1;
}

// The core's words, with the name that people see: "Maximum slope 95 is out of range; give ...".
QString problemOf(const ParameterDescriptor& parameter, double value) {
  const std::string label = filterText(parameter.label).toStdString();
  ParameterDescriptor shown = parameter;
  shown.name = label;
  return coreText(checkValue(shown, value));
}

// In the shortest digits: 2.1 and not 2.1000000000000001.
double tidy(double value) { return QString::number(value, 'g', 12).toDouble(); }

}  // namespace

std::optional<double> parseNumber(const QString& text) {
  std::string digits = text.trimmed().toStdString();
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.erase(0, 1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

QString numberText(double value) {
  std::string text;
  appendNumber(text, value);
  return QString::fromStdString(text);
}

QString unitText(Unit unit) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("footfall", text); };
  switch (unit) {
    case Unit::Degrees:
      return tr("degrees");
    case Unit::Length:
      return tr("units");
    case Unit::Area:
      return tr("units²");
    case Unit::Count:
      return tr("count");
    case Unit::None:
      break;
  }
  return {};
}

QString unitText(Unit unit, double value, double metresPerUnit) {
  const QString text = unitText(unit);
  if (metresPerUnit == 1 || (unit != Unit::Length && unit != Unit::Area)) return text;
  const bool area = unit == Unit::Area;
  const double metric = value * metresPerUnit * (area ? metresPerUnit : 1);
  return text + QStringLiteral(" = %1 ").arg(metric, 0, 'g', 4) + (area ? QStringLiteral("m²") : QStringLiteral("m"));
}

NumberField::NumberField(const ParameterDescriptor& parameter, QWidget* parent)
    : QLineEdit(parent), parameter_(parameter) {
  setAlignment(Qt::AlignRight);
  setCursor(Qt::SizeHorCursor);
  connect(this, &QLineEdit::textEdited, this, &NumberField::readText);
}

void NumberField::setValue(double value) {
  const auto shown = parseNumber(text());
  value_ = value;
  setProblem({});
  if (!shown || *shown != value) setText(QString::fromStdString(formatValue(parameter_, value)));
}

void NumberField::readText(const QString& text) {
  const auto number = parseNumber(text);
  if (!number) {
    setProblem(text.contains(QLatin1Char(',')) ? tr("not a number; write decimals with a point")
                                               : tr("not a number; give %1").arg(coreText(describeRange(parameter_))));
    return;
  }
  const QString wrong = problemOf(parameter_, *number);
  setProblem(wrong);
  if (!wrong.isEmpty() || *number == value_) return;
  value_ = *number;
  emit valueEdited(value_);
}

void NumberField::setProblem(const QString& problem) {
  if (problem == problem_) return;
  problem_ = problem;
  setProperty("invalid", !problem.isEmpty());
  style()->unpolish(this);  // the style sheet looks at the property
  style()->polish(this);
  emit problemChanged();
}

double NumberField::stepSize() const {
  if (parameter_.type != ParameterType::Real || parameter_.unit == Unit::Degrees) return 1;
  // A tenth of the leading digit's weight: 2 becomes 2.1, 40 becomes 41.
  return value_ == 0 ? 0.1 : std::pow(10.0, std::floor(std::log10(std::abs(value_))) - 1);
}

void NumberField::stepBy(double steps) {
  const double step = stepSize() * std::min(std::abs(steps), 1.0);
  const double grain = parameter_.type == ParameterType::Real ? step : std::max(1.0, step);
  const double whole = steps > 0 ? std::max(steps, 1.0) : std::min(steps, -1.0);
  const double next = tidy(std::round(value_ / grain + whole) * grain);
  if (!checkValue(parameter_, next).empty()) return;
  setText(QString::fromStdString(formatValue(parameter_, next)));
  readText(text());
}

QString NumberField::takeNear(double wanted, double grain) {
  const double asked = tidy(std::round(wanted / grain) * grain);
  const QString wrong = problemOf(parameter_, asked);
  double next = asked;
  if (asked > parameter_.maximum || (asked == parameter_.maximum && parameter_.maximumOpen)) {
    next = tidy(std::floor(parameter_.maximum / grain) * grain);
    if (next == parameter_.maximum && parameter_.maximumOpen) next = tidy(next - grain);
  } else if (asked < parameter_.minimum || (asked == parameter_.minimum && parameter_.minimumOpen)) {
    next = tidy(std::ceil(parameter_.minimum / grain) * grain);
    if (next == parameter_.minimum && parameter_.minimumOpen) next = tidy(next + grain);
  }
  if (next != value_ && checkValue(parameter_, next).empty()) {
    value_ = next;
    setText(QString::fromStdString(formatValue(parameter_, next)));
    emit valueEdited(value_);
  }
  return wrong;
}

// --- Dragging -------------------------------------------------------------------------------------------------------

void NumberField::takeDragsOf(QWidget* label) {
  label->setCursor(Qt::SizeHorCursor);
  label->installEventFilter(this);
}

void NumberField::beginDrag(double x, bool onField) { drag_ = Drag{value_, stepSize(), 0, x, x, false, onField}; }

void NumberField::dragTo(double x, Qt::KeyboardModifiers modifiers) {
  if (!drag_) return;
  if (!drag_->moved) {
    if (std::abs(x - drag_->start) < QApplication::startDragDistance()) return;
    drag_->moved = true;
    drag_->x = drag_->start;
    ++editSession_;
    setCursor(Qt::SizeHorCursor);
    if (!problem_.isEmpty()) setText(QString::fromStdString(formatValue(parameter_, value_)));
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
  if (!keep && value_ != drag.from) {
    value_ = drag.from;
    setText(QString::fromStdString(formatValue(parameter_, value_)));
    emit valueEdited(value_);
  }
  setProblem({});
  ++editSession_;  // what follows is another edit
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

// A click without a drag is the beginning of typing.
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
      setFocus(Qt::OtherFocusReason);  // so that Escape comes here
      beginDrag(mouse->globalPosition().x(), false);
      break;  // the row takes it as a click, too
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
    // Cancelling a run is for those who have nothing here to take back.
    if (key->key() == Qt::Key_Escape && (drag_ || !problem_.isEmpty())) {
      event->accept();
      return true;
    }
  }
  return QLineEdit::event(event);
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
      setText(QString::fromStdString(formatValue(parameter_, value_)));
      setProblem({});
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
}

}  // namespace footfall
