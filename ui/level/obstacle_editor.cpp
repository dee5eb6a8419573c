// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/obstacle_editor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace footfall::ui {
namespace {

constexpr int kRestMs = 150;
constexpr int kPauseMs = 600;

/// The largest of 1, 2.5 or 5 times a power of ten that is not above `length`.
double roundLength(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length) + 1e-9));
  for (const double digits : {5.0, 2.5})
    if (digits * power <= length * (1 + 1e-9)) return digits * power;
  return power;
}

QString fromName(const PlacedObstacle& obstacle) { return QString::fromStdString(obstacle.name); }

}  // namespace

ObstacleEditor::ObstacleEditor(Document& document, LevelComposer& composer, RunController& controller, QObject* parent)
    : QObject(parent), document_(document), composer_(composer), controller_(controller) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, &ObstacleEditor::commit);
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseMs);
  connect(&pause_, &QTimer::timeout, this, &ObstacleEditor::endDrag);
  connect(&document_, &Document::levelChanged, this, &ObstacleEditor::documentChanged);
  const auto proceed = [this] {
    if (drag_) commit();
  };
  connect(&controller_, &RunController::finished, this, proceed);
  connect(&controller_, &RunController::failed, this, proceed);
}

const PlacedObstacle* ObstacleEditor::inDocument(std::uint32_t id) const {
  const auto found = std::ranges::find(obstacles(), id, &PlacedObstacle::id);
  return found == obstacles().end() ? nullptr : &*found;
}

const PlacedObstacle* ObstacleEditor::find(std::uint32_t id) const {
  return drag_ && drag_->id == id ? &drag_->live : inDocument(id);
}

void ObstacleEditor::select(std::optional<std::uint32_t> id) {
  if (id && !find(*id)) id.reset();
  if (std::exchange(selected_, id) != id) emit changed();
}

QString ObstacleEditor::nameOf(PlacedObstacle::Shape shape) {
  switch (shape) {
    case PlacedObstacle::Shape::Cylinder:
      return tr("Cylinder");
    case PlacedObstacle::Shape::Ramp:
      return tr("Ramp");
    case PlacedObstacle::Shape::Box:
      break;
  }
  return tr("Box");
}

PlacedObstacle ObstacleEditor::makeDefault(PlacedObstacle::Shape shape) const {
  const double metre = roundShown(1);
  PlacedObstacle obstacle;
  obstacle.shape = shape;
  obstacle.size = {metre, metre, metre};
  if (shape == PlacedObstacle::Shape::Ramp) obstacle.size.x = 2 * metre;  // walkable for most slope limits
  return obstacle;
}

double ObstacleEditor::step(bool coarse) const { return roundShown(coarse ? 0.25 : 0.01); }

// Rounds lengths that users read.
double ObstacleEditor::roundShown(double metres) const {
  return units_.stored(roundLength(metres / units_.metresPerUnit * units_.factor()));
}

std::uint32_t ObstacleEditor::newId() const {
  std::uint32_t id = 1;
  for (const PlacedObstacle& obstacle : obstacles()) id = std::max(id, obstacle.id + 1);
  return id;
}

QString ObstacleEditor::newName(const QString& stem) const {
  for (int number = 1;; ++number) {
    const QString name = stem + QLatin1Char(' ') + QString::number(number);
    if (std::ranges::none_of(obstacles(), [&](const auto& o) { return fromName(o) == name; })) return name;
  }
}

std::uint32_t ObstacleEditor::add(PlacedObstacle obstacle) {
  endDrag();
  obstacle.id = newId();
  if (obstacle.name.empty()) obstacle.name = newName(nameOf(obstacle.shape)).toStdString();
  DocumentState next = document_.state();
  next.obstacles.push_back(obstacle);
  document_.edit(std::move(next), tr("Place %1").arg(fromName(obstacle)));
  select(obstacle.id);
  return obstacle.id;
}

std::optional<std::uint32_t> ObstacleEditor::duplicate(std::uint32_t id, const Vec3& offset) {
  endDrag();
  const PlacedObstacle* original = inDocument(id);
  if (!original) return std::nullopt;
  PlacedObstacle copy = *original;
  copy.id = newId();
  copy.name = newName(nameOf(copy.shape)).toStdString();
  copy.base = {copy.base.x + offset.x, copy.base.y + offset.y, copy.base.z + offset.z};
  DocumentState next = document_.state();
  next.obstacles.push_back(copy);
  document_.edit(std::move(next), tr("Duplicate %1").arg(fromName(*original)));
  select(copy.id);
  return copy.id;
}

void ObstacleEditor::remove(std::uint32_t id) {
  endDrag();
  const PlacedObstacle* obstacle = inDocument(id);
  if (!obstacle) return;
  const QString text = tr("Delete %1").arg(fromName(*obstacle));
  DocumentState next = document_.state();
  std::erase_if(next.obstacles, [id](const PlacedObstacle& o) { return o.id == id; });
  document_.edit(std::move(next), text);
}

void ObstacleEditor::change(const PlacedObstacle& changed, const QString& text, const QString& mergeKey) {
  endDrag();
  DocumentState next = document_.state();
  const auto found = std::ranges::find(next.obstacles, changed.id, &PlacedObstacle::id);
  if (found == next.obstacles.end()) return;
  *found = changed;
  document_.edit(std::move(next), text.arg(fromName(changed)), mergeKey);
}

void ObstacleEditor::changeSoon(const PlacedObstacle& next, const QString& text, const QString& mergeKey) {
  const PlacedObstacle* known = find(next.id);
  if (!known) return;
  const QString named = text.arg(fromName(*known));
  const bool follows = drag_ && pause_.isActive() && drag_->id == next.id && drag_->text == named &&
                       (mergeKey.isEmpty() || drag_->mergeKey == mergeKey);
  if (!follows) startDrag(PlacedObstacle(*known), named, mergeKey);
  pause_.start();
  dragTo(next);
}

void ObstacleEditor::startDrag(const PlacedObstacle& live, const QString& text, const QString& mergeKey) {
  endDrag();
  const QString key = mergeKey.isEmpty() ? QStringLiteral("obstacle/drag/%1").arg(++drags_) : mergeKey;
  drag_ = Drag{live.id, text, key, live, document_.state()};
  controller_.setDragging(true);
  selected_ = live.id;
  emit changed();
}

void ObstacleEditor::beginDrag(std::uint32_t id, const QString& text) {
  if (const PlacedObstacle* obstacle = inDocument(id))
    startDrag(PlacedObstacle(*obstacle), text.arg(fromName(*obstacle)));
}

void ObstacleEditor::beginDragOfCopy(std::uint32_t id) {
  const PlacedObstacle* original = inDocument(id);
  if (!original) return;
  const QString text = tr("Duplicate %1").arg(fromName(*original));
  PlacedObstacle copy = *original;
  copy.id = newId();
  copy.name = newName(nameOf(copy.shape)).toStdString();
  startDrag(copy, text);
}

void ObstacleEditor::dragTo(const PlacedObstacle& next) {
  if (!drag_ || next.id != drag_->id || drag_->live == next) return;
  drag_->live = next;
  if (controller_.busy()) {
    rest_.start();
  } else {
    commit();
  }
  emit changed();
}

void ObstacleEditor::commit() {
  rest_.stop();
  if (!drag_) return;
  const PlacedObstacle* known = inDocument(drag_->id);
  const std::vector<PlacedObstacle>& before = drag_->before.obstacles;
  if (!known && drag_->committed) return;
  if (known && *known == drag_->live) return;
  // A copy that has not moved yet lies in its original.
  if (!known && std::ranges::any_of(before, [&](const PlacedObstacle& o) {
        return o.base == drag_->live.base && o.size == drag_->live.size && o.turn == drag_->live.turn;
      }))
    return;
  DocumentState next = document_.state();
  const auto place = std::ranges::find(next.obstacles, drag_->id, &PlacedObstacle::id);
  if (place == next.obstacles.end()) {
    next.obstacles.push_back(drag_->live);
  } else {
    *place = drag_->live;
  }
  drag_->committed = true;
  committing_ = true;
  document_.edit(std::move(next), drag_->text, drag_->mergeKey);
  committing_ = false;
}

void ObstacleEditor::endDrag() {
  pause_.stop();
  if (!drag_) return;
  commit();
  controller_.setDragging(false);  // a run that waits for more edits begins now
  drag_.reset();
  if (selected_ && !inDocument(*selected_)) selected_.reset();
  emit changed();
}

void ObstacleEditor::cancelDrag() {
  if (!drag_) return;
  rest_.stop();
  pause_.stop();
  controller_.setDragging(false);
  const Drag drag = *std::exchange(drag_, std::nullopt);
  if (drag.committed) {
    DocumentState back = document_.state();
    back.obstacles = drag.before.obstacles;
    document_.edit(std::move(back), drag.text, drag.mergeKey);  // together they make no entry
  }
  if (selected_ && !inDocument(*selected_)) selected_.reset();
  emit changed();
}

// After another edit, undo or another level, the dragged obstacle may no longer exist.
void ObstacleEditor::documentChanged() {
  if (!committing_) {
    rest_.stop();
    pause_.stop();
    if (std::exchange(drag_, std::nullopt)) controller_.setDragging(false);
    if (selected_ && !inDocument(*selected_)) selected_.reset();
  }
  emit changed();
}

}  // namespace footfall::ui
