// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/number_field.hpp"

#include <QKeyEvent>
#include <QStyle>
#include <charconv>
#include <cmath>
#include <string>

#include "core/environment/number_text.hpp"
#include "core/filters/descriptor_text.hpp"
#include "core/pipeline/pipeline.hpp"

namespace footfall {

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
  switch (unit) {
    case Unit::Degrees:
      return QStringLiteral("degrees");
    case Unit::Length:
      return QStringLiteral("units");
    case Unit::Area:
      return QStringLiteral("units²");
    case Unit::None:
    case Unit::Count:
      break;
  }
  return {};
}

NumberField::NumberField(const ParameterDescriptor& parameter, QWidget* parent)
    : QLineEdit(parent), parameter_(parameter) {
  setAlignment(Qt::AlignRight);
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
    setProblem(text.contains(QLatin1Char(','))
                   ? tr("not a number; write decimals with a point")
                   : tr("not a number; give %1").arg(QString::fromStdString(describeRange(parameter_))));
    return;
  }
  const std::string wrong = checkValue(parameter_, *number);
  setProblem(QString::fromStdString(wrong));
  if (!wrong.empty() || *number == value_) return;
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

void NumberField::stepBy(int steps) {
  double step = 1;
  if (parameter_.type == ParameterType::Real && parameter_.unit != Unit::Degrees) {
    // A tenth of the leading digit's weight: 2 becomes 2.1, 40 becomes 41.
    step = value_ == 0 ? 0.1 : std::pow(10.0, std::floor(std::log10(std::abs(value_))) - 1);
  }
  // Multiples of the step in the shortest digits: 2.1 and not 2.1000000000000001.
  const double next = std::round(value_ / step + steps) * step;
  const auto rounded = parseNumber(QString::number(next, 'g', 12));
  if (!rounded || !checkValue(parameter_, *rounded).empty()) return;
  setText(QString::fromStdString(formatValue(parameter_, *rounded)));
  readText(text());
}

bool NumberField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return true;
    }
  }
  return QLineEdit::event(event);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
      stepBy(1);
      return;
    case Qt::Key_Down:
      stepBy(-1);
      return;
    case Qt::Key_Escape:
      setText(QString::fromStdString(formatValue(parameter_, value_)));
      setProblem({});
      return;
    default:
      QLineEdit::keyPressEvent(event);
  }
}

void NumberField::focusInEvent(QFocusEvent* event) {
  ++editSession_;
  QLineEdit::focusInEvent(event);
}

}  // namespace footfall
