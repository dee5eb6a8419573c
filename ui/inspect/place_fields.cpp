// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/place_fields.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QVariant>
#include <cmath>

#include "ui/base/commands/keys_back.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {

PlaceFields::PlaceFields(const QString& name, const QString& id, QWidget* parent) : QWidget(parent), name_(name) {
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
    giveKeysBackAfterTyping(*field);
    selectNumberByDoubleClick(*field);
    field->setMinimumWidth(64);
    field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // three fields would make the panel wide otherwise
    connect(field, &QLineEdit::textEdited, this, &PlaceFields::read);
    layout->addWidget(field, 1);
    fields_[i] = field;
  }
  setFocusProxy(fields_[0]);
  showUnits();
}

void PlaceFields::showUnits() {
  const int up = units_.fileAxis(2).axis;
  for (int i = 0; i < 3; ++i)
    fields_[static_cast<std::size_t>(i)]->setToolTip(
        (i == up ? tr("%1: %2, the file's vertical axis, in %3") : tr("%1: %2 of the file, in %3"))
            .arg(name_, axisName(i), units_.name()));
}

void PlaceFields::setUnits(const LevelUnits& units) {
  units_ = units;
  showUnits();
  // The text that is being typed stays.
  if (place_) setPlace(place_);
}

namespace {

double axisOf(const Vec3& place, std::size_t axis) { return axis == 0 ? place.x : axis == 1 ? place.y : place.z; }

// A conversion between units and back may change the last bit.
bool isSame(double a, double b) { return std::abs(a - b) <= 1e-14 * std::abs(a); }

}  // namespace

void PlaceFields::setPlace(const std::optional<Vec3>& place) {
  const bool changed = place != place_;
  place_ = place;
  const Vec3 shown = place ? units_.shownPlace(*place) : Vec3{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!place) {
      // A place that is only partly typed stays.
      if (changed && !fields_[i]->hasFocus()) fields_[i]->clear();
      continue;
    }
    const double value = axisOf(shown, i);
    // Typed text stays as it is while it stands for the same number.
    if (const auto typed = parseNumber(fields_[i]->text()); typed && isSame(*typed, value)) continue;
    const QString text = measureText(axisOf(shown, i));
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
  const std::optional<Vec3> before = place_ ? std::optional(units_.shownPlace(*place_)) : std::nullopt;
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (before && fields_[i]->text() == measureText(axisOf(*before, i))) {
      values[i] = axisOf(*before, i);
      continue;
    }
    const auto value = parseNumber(fields_[i]->text());
    if (!value || !std::isfinite(*value)) return;
    values[i] = *value;
  }
  place_ = units_.storedPlace({values[0], values[1], values[2]});
  emit edited(*place_);
}

}  // namespace footfall::ui
