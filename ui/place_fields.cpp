// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/place_fields.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QVariant>
#include <cmath>

#include "ui/path_text.hpp"

namespace footfall {

PlaceFields::PlaceFields(const QString& name, const QString& id, QWidget* parent) : QWidget(parent) {
  setObjectName(id);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  const std::array<QString, 3> axes{QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")};
  for (std::size_t i = 0; i < 3; ++i) {
    auto* field = new QLineEdit(this);
    field->setObjectName(id + axes[i]);
    field->setPlaceholderText(axes[i]);
    field->setAccessibleName(tr("%1, %2").arg(name, axes[i]));
    field->setToolTip(i == 2 ? tr("%1: height (Z is up here), in the environment's units").arg(name)
                             : tr("%1: %2 in the environment's units").arg(name, axes[i]));
    field->setMinimumWidth(64);
    field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // or three of them make the panel wide
    connect(field, &QLineEdit::textEdited, this, &PlaceFields::read);
    layout->addWidget(field, 1);
    fields_[i] = field;
  }
  setFocusProxy(fields_[0]);
}

namespace {

double axisOf(const Vec3& place, std::size_t axis) { return axis == 0 ? place.x : axis == 1 ? place.y : place.z; }

// A picked place is rounded somewhere on its way: what is left of a 0 is shown as one. The place stays as it is.
QString textOf(const Vec3& place, std::size_t axis) {
  const double value = axisOf(place, axis);
  const double extent = std::abs(place.x) + std::abs(place.y) + std::abs(place.z);
  return measureText(std::abs(value) < 1e-12 * extent ? 0 : value);
}

}  // namespace

void PlaceFields::setPlace(const std::optional<Vec3>& place) {
  const bool changed = place != place_;
  place_ = place;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!place) {
      // Half a place that is being typed stays.
      if (changed && !fields_[i]->hasFocus()) fields_[i]->clear();
      continue;
    }
    const double value = axisOf(*place, i);
    // What has been typed stays as it was typed, while it means the same.
    if (const auto typed = parseNumber(fields_[i]->text()); typed && *typed == value) continue;
    const QString text = textOf(*place, i);
    if (fields_[i]->text() == text) continue;
    fields_[i]->setText(text);
    fields_[i]->setCursorPosition(0);
  }
  if (place) showProblems();
}

void PlaceFields::showProblems() {
  for (QLineEdit* field : fields_) {
    const auto value = parseNumber(field->text());
    const bool invalid = !field->text().isEmpty() && !(value && std::isfinite(*value));
    if (field->property("invalid").toBool() == invalid) continue;
    field->setProperty("invalid", invalid);
    field->style()->unpolish(field);
    field->style()->polish(field);
  }
}

void PlaceFields::read() {
  showProblems();
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (place_ && fields_[i]->text() == measureText(axisOf(*place_, i))) {
      values[i] = axisOf(*place_, i);
      continue;
    }
    const auto value = parseNumber(fields_[i]->text());
    if (!value || !std::isfinite(*value)) return;
    values[i] = *value;
  }
  place_ = Vec3{values[0], values[1], values[2]};
  emit edited(*place_);
}

}  // namespace footfall
