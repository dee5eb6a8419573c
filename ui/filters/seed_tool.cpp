// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/seed_tool.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "footfall/up_axis.hpp"
#include "ui/base/look/core_colours.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/filters/seed_edits.hpp"

namespace footfall::ui {
namespace {

const QString kSeedsOverlay = QStringLiteral("seeds");
constexpr double kGrabPixels = 10;
constexpr double kGrain = 1e-5;  // the largest share of the extent
constexpr double kLift = 10;     // in grains, above the clicked place: enough for floors that slope by up to 86 degrees
constexpr std::size_t kMostLabels = 200;

QColor seedColour() { return toColour(kReddishPurple); }

}  // namespace

SeedTool::SeedTool(Document& document, LevelView& view, QObject* parent)
    : QObject(parent), document_(document), view_(view) {
  connect(&document_, &Document::filtersChanged, this, [this] {
    draw();
    emit hintChanged(hint());
  });
}

void SeedTool::setFilter(int id) {
  if (id == filter_) return;
  endDrag();
  filter_ = id;
  draw();
  emit hintChanged(hint());
}

void SeedTool::setShown(bool shown) {
  shown_ = shown;
  draw();
}

void SeedTool::setUnits(const LevelUnits& units) {
  units_ = units;
  draw();
}

void SeedTool::setExtent(double extent) {
  grain_ = extent > 0 && std::isfinite(extent) ? std::pow(10.0, std::floor(std::log10(extent * kGrain))) : 0.001;
}

QString SeedTool::hint() const {
  return seedsOf(document_, filter_).empty()
             ? tr("Place seeds: click where agents start. Esc ends.")
             : tr("Place seeds: click to add one, drag one to move it, Ctrl and a click remove it. Esc ends.");
}

std::optional<std::size_t> SeedTool::seedAt(const QPoint& place) const {
  const std::vector<Vec3> seeds = seedsOf(document_, filter_);
  std::optional<std::size_t> nearest;
  double least = kGrabPixels;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const auto at = view_.project(fromFileFrame(seeds[i], units_.up));
    const double distance = at ? std::hypot(at->x() - place.x(), at->y() - place.y()) : kGrabPixels + 1;
    if (distance > least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

Vec3 SeedTool::seedFor(const Vec3& place) const {
  // Keeps the shortest digits: 2.1 and not 2.1000000000000001.
  const auto rounded = [this](double value) {
    return QString::number(std::round(value / grain_) * grain_, 'g', 12).toDouble();
  };
  return inFileFrame({rounded(place.x), rounded(place.y), rounded(place.z + kLift * grain_)}, units_.up);
}

bool SeedTool::mousePressed(const ViewMouse& mouse) {
  if (mouse.button != Qt::LeftButton) return false;
  const auto seed = seedAt(mouse.place);
  if (!seed) return false;
  if (mouse.modifiers & (Qt::ControlModifier | Qt::ShiftModifier)) {
    hovered_.reset();
    removeSeed(document_, filter_, *seed);
    return true;
  }
  dragged_ = seed;
  ++session_;
  emit draggingChanged(true);
  return true;
}

void SeedTool::mouseMoved(const ViewMouse& mouse) {
  if (!dragged_) {
    const auto now = seedAt(mouse.place);
    if (now == hovered_) return;
    hovered_ = now;
    view_.setCursor(now ? Qt::OpenHandCursor : Qt::CrossCursor);
    draw();
    return;
  }
  if (seedAt(mouse.place) == dragged_) return;  // the mouse is still on the seed
  if (const auto found = view_.pick(mouse.place))
    moveSeed(document_, filter_, *dragged_, seedFor(found->point), QStringLiteral("seed/%1").arg(session_));
}

void SeedTool::mouseReleased(const ViewMouse& mouse) {
  mouseMoved(mouse);
  endDrag();
}

void SeedTool::endDrag() {
  if (std::exchange(dragged_, std::nullopt)) emit draggingChanged(false);
}

void SeedTool::clicked(const ViewMouse& mouse) {
  const auto found = view_.pick(mouse.place);
  if (!found) return;
  if (filter_ >= 0)
    addSeed(document_, filter_, seedFor(found->point));
  else
    emit filterAdded(addFilterWithSeed(document_, seedFor(found->point)));
}

bool SeedTool::keyPressed(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Backspace && event.key() != Qt::Key_Delete) return false;
  const std::size_t count = seedsOf(document_, filter_).size();
  if (count > 0) removeSeed(document_, filter_, count - 1);
  return true;
}

void SeedTool::mouseLeft() {
  hovered_.reset();
  draw();
}

void SeedTool::ended() {
  hovered_.reset();
  endDrag();
}

void SeedTool::draw() {
  const std::vector<Vec3> seeds = shown_ ? seedsOf(document_, filter_) : std::vector<Vec3>();
  if (seeds.empty()) {
    view_.removeOverlay(kSeedsOverlay);
    return;
  }
  ViewOverlay overlay;
  overlay.throughWalls = true;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const Vec3 at = fromFileFrame(seeds[i], units_.up);
    overlay.marks.push_back({at, seedColour(), i == hovered_ || i == dragged_ ? 16.0F : 12.0F});
    if (seeds.size() <= kMostLabels) overlay.labels.push_back({at, countText(i + 1)});
  }
  view_.setOverlay(kSeedsOverlay, std::move(overlay));
}

}  // namespace footfall::ui
