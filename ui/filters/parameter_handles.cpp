// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/parameter_handles.hpp"

#include <QKeyEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/vector.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/filters/measure_place.hpp"

namespace footfall::ui {
namespace {

constexpr double kGrabPixels = 10;
constexpr double kArmPixels = 140;        // length of an angle's sides
constexpr int kRestMs = 150;              // time without a movement of the camera
constexpr int kFirstSession = 1'000'000;  // fields count their sessions from 0
constexpr double kLengthGrain = 0.01, kMillimetreGrain = 1, kAngleGrain = 0.5, kFine = 0.1;
constexpr double kSteepest = 89.9;  // in degrees, the limit of a drag

QString overlayName(std::size_t measure) { return QStringLiteral("measure.%1").arg(measure); }

}  // namespace

ParameterHandles::ParameterHandles(const FeatureHost& host, LevelView& view, Document& document,
                                   RunController& controller, FilterList& list)
    : QObject(&host.window),
      view_(view),
      document_(document),
      controller_(controller),
      list_(list),
      status_(host.status),
      session_(kFirstSession) {
  resting_.setSingleShot(true);
  resting_.setInterval(kRestMs);
  connect(&resting_, &QTimer::timeout, this, &ParameterHandles::update);
  connect(&view_.cameraController(), &CameraController::moved, this, [this] {
    searched_ = false;
    resting_.start();
    draw();
  });
  connect(&view_, &LevelView::toolChanged, this, &ParameterHandles::update);
  connect(&view_, &LevelView::environmentChanged, this, [this] {
    place_.reset();
    searched_ = false;
    resting_.start();  // nothing has been drawn yet
  });
  connect(&list_, &FilterList::selectionChanged, this, &ParameterHandles::update);
  connect(&list_, &FilterList::parameterPointed, this, [this](int id, std::size_t parameter, bool on) {
    pointed_ = on ? std::optional(Pointed{id, parameter}) : std::nullopt;
    update();
  });
  connect(&document_, &Document::filtersChanged, this, &ParameterHandles::update);
  connect(&controller_, &RunController::finished, this, [this] {
    searched_ = false;
    update();
  });
  const auto takeUnits = [this, &choice = host.units] {
    units_ = choice.units();
    update();
  };
  connect(&host.units, &UnitChoice::changed, this, takeUnits);
  takeUnits();
  view_.setHandles(this);
  view_.installEventFilter(this);
}

// --- Display

void ParameterHandles::update() {
  const std::size_t before = measures_.size();
  measures_.clear();
  const auto isPointed = [this](const FilterEntry& entry) { return entry.id == pointed_->filter; };
  if (pointed_ && std::ranges::none_of(document_.filters(), isPointed)) pointed_.reset();  // its row was removed
  const int current = pointed_ && !hold_ ? pointed_->filter : list_.selection().current();
  const auto entry = std::ranges::find(document_.filters(), current, &FilterEntry::id);
  const bool isThere = entry != document_.filters().end() && entry->step.enabled && !view_.tool() &&
                       view_.environmentGeometry() != nullptr;
  if (isThere) {
    bool hasMeasure = false;
    for (std::size_t i = 0; i < entry->step.values.size(); ++i)
      hasMeasure = hasMeasure || measureKindOf(*entry->step.filter, i).has_value();
    if (!hold_ && hasMeasure) findPlace();
    for (std::size_t i = 0; place_ && i < entry->step.values.size(); ++i)
      if (!pointed_ || hold_ || pointed_->parameter == i) addMeasure(*entry, i);
  }
  if (measures_.empty() && !hold_) hover({});
  for (std::size_t i = measures_.size(); i < before; ++i) view_.removeOverlay(overlayName(i));
  draw();
}

void ParameterHandles::draw() {
  for (std::size_t i = 0; i < measures_.size(); ++i) {
    const ParameterMeasure& measure = measures_[i];
    const bool held = hold_ && hold_->start.parameter == measure.parameter;
    view_.setOverlay(overlayName(i), measure.overlay(unitsPerPixelAt(measure.at), held || hovered_ == i));
  }
}

bool ParameterHandles::isInView(const Vec3& place) const {
  const std::optional<QPointF> at = view_.project(place);
  return at && view_.rect().contains(at->toPoint());
}

std::optional<Vec3> ParameterHandles::floorAt(const QPoint& place) const {
  const std::optional<SurfacePoint> found = view_.pick(place);
  const auto geometry = view_.environmentGeometry();
  if (!found || geometry->surface[std::size_t{3} * found->triangle].colour[3] != 0) return std::nullopt;
  return found->point;
}

// Keeps the present place as long as it is visible; otherwise finds the first floor around the middle.
void ParameterHandles::findPlace() {
  if ((place_ && isInView(*place_)) || resting_.isActive() || std::exchange(searched_, true)) return;
  constexpr std::array<std::array<double, 2>, 9> kAround{
      {{0, 0}, {0, 0.15}, {0.15, 0}, {-0.15, 0}, {0, -0.15}, {0.2, 0.25}, {-0.2, 0.25}, {0.3, 0}, {-0.3, 0}}};
  place_.reset();
  for (const auto& [x, y] : kAround) {
    place_ = floorAt({static_cast<int>((0.5 + x) * view_.width()), static_cast<int>((0.5 + y) * view_.height())});
    if (place_) return;
  }
}

double ParameterHandles::unitsPerPixelAt(const Vec3& place) const {
  const Vec3 centre = view_.environmentGeometry() ? view_.environmentGeometry()->centre : Vec3{};
  return static_cast<double>(
      view_.camera()->pixelGLRatio(qglviewer::Vec(place.x - centre.x, place.y - centre.y, place.z - centre.z)));
}

void ParameterHandles::addMeasure(const FilterEntry& entry, std::size_t parameter) {
  const FilterDescriptor& filter = *entry.step.filter;
  const std::optional<MeasureKind> kind = measureKindOf(filter, parameter);
  if (!kind) return;
  const ParameterDescriptor& description = filter.parameterOf(parameter);
  // A value that follows another and is equal is drawn with it.
  const std::vector<double>& values = entry.step.values;
  if (!pointed_ && description.follows >= 0 &&
      values[static_cast<std::size_t>(description.follows)] == values[parameter])
    return;
  ParameterMeasure measure;
  measure.filter = entry.id;
  measure.parameter = parameter;
  measure.kind = *kind;
  measure.value = values[parameter];
  measure.at = *place_;
  // The direction is across the line of sight, where angles and lengths are most visible.
  const qglviewer::Vec right = view_.camera()->rightVector();
  const double level = std::hypot(right.x, right.y);
  measure.along = level > 0 ? Vec3{right.x / level, right.y / level, 0} : Vec3{1, 0, 0};
  if (parameter > 0 && *kind == MeasureKind::Distance) measure.along = -1.0 * measure.along;
  measure.arm = kArmPixels * unitsPerPixelAt(*place_);
  const QString value = *kind == MeasureKind::Angle ? QStringLiteral("%1°").arg(QString::number(measure.value, 'g', 6))
                                                    : units_.length(measure.value);
  measure.text = tr("%1: %2").arg(filterText(description.label), value);
  const auto run = controller_.finishedRun();
  if (filter.type == FilterType::Step && run && run->result.mesh) {
    // The link does not change while its handle is held, even when the link disappears.
    if (hold_ && hold_->start.parameter == parameter) {
      measure.at = hold_->start.at;
      measure.along = hold_->start.along;
    } else if (const auto link = findLink(*run->result.mesh, parameter == 0 ? StepKind::Step : StepKind::Gap, *place_,
                                          [this](const Vec3& at) { return isInView(at); })) {
      measure.at = link->at;
      measure.along = link->along;
      measure.text = tr("%1: %2 (here %3)").arg(filterText(description.label), value, units_.length(link->value));
    }
  }
  measures_.push_back(std::move(measure));
}

// --- Mouse

std::optional<std::size_t> ParameterHandles::handleAt(const QPoint& place) const {
  std::optional<std::size_t> nearest;
  double least = kGrabPixels;
  for (std::size_t i = 0; i < measures_.size(); ++i) {
    const std::optional<QPointF> at = view_.project(measures_[i].handle());
    if (!at) continue;
    const double distance = std::hypot(at->x() - place.x(), at->y() - place.y());
    if (distance > least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

void ParameterHandles::hover(std::optional<std::size_t> measure) {
  if (std::exchange(hovered_, measure) == measure) return;
  if (measure) {
    view_.setCursor(Qt::PointingHandCursor);
    status_.say(StatusSubject::Note, tr("Drag the handle to change the value. Shift: finer, Esc: back."));
  } else if (!view_.tool()) {
    view_.unsetCursor();
  }
  draw();
}

bool ParameterHandles::mousePressed(const ViewMouse& mouse) {
  if (mouse.button != Qt::LeftButton || (mouse.modifiers & ~Qt::ShiftModifier)) return false;
  const auto measure = handleAt(mouse.place);
  if (!measure) return false;
  hold_ = Hold{measures_[*measure], view_.rayAt(mouse.place), mouse.place, ++session_};
  controller_.setDragging(true);
  draw();
  return true;
}

void ParameterHandles::mouseMoved(const ViewMouse& mouse) {
  if (hold_) {
    hold_->moved = hold_->moved || mouse.place != hold_->pressed;
    if (hold_->moved) drag(mouse);
  } else {
    hover(handleAt(mouse.place));
  }
}

void ParameterHandles::drag(const ViewMouse& mouse) {
  const ParameterMeasure& start = hold_->start;
  const auto value = start.dragged(hold_->from, view_.rayAt(mouse.place));
  const auto entry = std::ranges::find(document_.filters(), start.filter, &FilterEntry::id);
  if (!value || entry == document_.filters().end()) return;
  ParameterDescriptor shown = entry->step.filter->parameterOf(start.parameter);
  const bool isAngle = start.kind == MeasureKind::Angle;
  const double fine = mouse.modifiers.testFlag(Qt::ShiftModifier) ? kFine : 1;
  const double length = units_.unit() == LengthUnit::Millimetres ? kMillimetreGrain : kLengthGrain;
  const double grain = fine * (isAngle ? kAngleGrain : length);
  if (isAngle) return setValue(keptInRange(shown, std::min(*value, kSteepest), grain));
  shown.minimum = units_.shown(shown.minimum);
  shown.maximum = units_.shown(shown.maximum);
  setValue(units_.stored(keptInRange(shown, units_.shown(*value), grain)));
}

void ParameterHandles::setValue(double value) {
  const Hold& hold = *hold_;
  document_.setValue(hold.start.filter, hold.start.parameter, value, hold.session);
}

void ParameterHandles::mouseReleased(const ViewMouse& mouse) {
  if (!hold_) return;
  if (hold_->moved || mouse.place != hold_->pressed) drag(mouse);
  endHold();
}

void ParameterHandles::endHold() {
  if (!std::exchange(hold_, std::nullopt)) return;
  controller_.setDragging(false);
  update();
}

void ParameterHandles::clicked(const ViewMouse& mouse) {
  if (measures_.empty()) return;
  if (const auto floor = floorAt(mouse.place)) {
    place_ = floor;
    update();
  }
}

void ParameterHandles::mouseLeft() {
  if (!hold_) hover({});
}

void ParameterHandles::ended() {
  endHold();
  hovered_.reset();
}

// Esc is also the shortcut of Cancel.
bool ParameterHandles::eventFilter(QObject* watched, QEvent* event) {
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (!hold_ || !isKey || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
    return QObject::eventFilter(watched, event);
  event->accept();
  if (event->type() == QEvent::KeyPress) {
    setValue(hold_->start.value);
    endHold();
  }
  return true;
}

}  // namespace footfall::ui
