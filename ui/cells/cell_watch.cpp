// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/cell_watch.hpp"

#include <QToolTip>
#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "footfall/filter.hpp"

namespace footfall::ui {
namespace {

// The wait before a preview, so that a run whose cells appear sooner replaces the old cells without flicker.
constexpr auto kPreviewAfter = std::chrono::milliseconds(200);

bool isStrategy(const FilterEntry& entry) { return entry.step.filter->kind == FilterKind::Strategy; }

}  // namespace

CellWatch::CellWatch(Document& document, RunController& controller, LevelView& view, CellModel& model, QObject* parent)
    : QObject(parent), document_(document), controller_(controller), view_(view), model_(model) {
  editTimer_.setSingleShot(true);
  editTimer_.setInterval(kPreviewAfter);
  connect(&editTimer_, &QTimer::timeout, this, [this] {
    if (!controller_.upToDate() && (shown_ || loadShown_)) preview(edited_);
  });
  connect(&document_, &Document::filtersChanged, this, &CellWatch::takeFilters);
  connect(&controller_, &RunController::cellsChanged, this, [this](const CellBlocks& blocks) {
    // A cancelled or refused run must not remove the preview that was requested instead of it.
    if (!controller_.busy() && !controller_.upToDate() && (model_.previewing() || preview_.busy())) return;
    editTimer_.stop();
    preview_.cancel();
    model_.setBlocks(blocks);
  });
  connect(&controller_, &RunController::finished, this, [this] {
    editTimer_.stop();
    const auto run = controller_.finishedRun();
    const auto cache = controller_.cache();
    if (run && cache) model_.setReuse(cellReuse(run->environment, run->pipeline, *cache));
  });
  connect(&preview_, &CellPreview::ready, &model_, &CellModel::showPreview);
  connect(&preview_, &CellPreview::failed, this, &CellWatch::previewFailed);
  connect(&model_, &CellModel::shapesChanged, this, &CellWatch::drape);
  connect(&model_, &CellModel::figuresChanged, this, [this] {
    if (!draping_.busy() && draped_ && draped_ == model_.shapes()) view_.setCellColours(colours());
  });
  connect(&model_, &CellModel::hoveredChanged, this, &CellWatch::mark);
  connect(&model_, &CellModel::selectedChanged, this, &CellWatch::mark);
  connect(&model_, &CellModel::frameRequested, this, [this](CellId cell) {
    if (shown_ && cell.block == model_.shownIndex()) view_.frameCell(cell.cell);
  });
  connect(&view_, &LevelView::cellHovered, this, [this](std::optional<std::size_t> cell) {
    model_.setHovered(cell ? std::optional(CellId{model_.shownIndex(), *cell}) : std::nullopt);
    QToolTip::showText(QCursor::pos(), model_.hovered() && cell ? model_.describe(*model_.hovered()) : QString(),
                       &view_);
  });
  connect(&view_, &LevelView::cellClicked, this, [this](std::optional<std::size_t> cell) {
    model_.select(cell ? std::optional(CellId{model_.shownIndex(), *cell}) : std::nullopt, true);
  });
}

void CellWatch::setEnvironment(std::shared_ptr<const Environment> environment, const Vec3& centre) {
  editTimer_.stop();
  preview_.cancel();
  environment_ = std::move(environment);
  centre_ = centre;
  draped_.reset();
  draping_.stop();
  model_.setBlocks({});
}

void CellWatch::editEnvironment(std::shared_ptr<const Environment> environment) {
  preview_.cancel();
  environment_ = std::move(environment);
  draped_.reset();  // the cells lie over floors that may have changed
}

int CellWatch::firstStrategy() const {
  const auto& filters = document_.filters();
  const auto found = std::ranges::find_if(filters, isStrategy);
  return found == filters.end() ? -1 : found->id;
}

void CellWatch::preview(int id) {
  const auto& filters = document_.filters();
  const auto found = std::ranges::find(filters, id, &FilterEntry::id);
  if (!environment_ || found == filters.end() || !isStrategy(*found)) return;
  preview_.request(environment_, document_.pipeline(), static_cast<std::size_t>(found - filters.begin()),
                   model_.threads());
}

// An edited or new strategy shows its cells when the run has none soon.
void CellWatch::takeFilters() {
  const std::vector<FilterEntry> before = std::exchange(filters_, document_.filters());
  emit blockChanged(
      std::ranges::any_of(filters_, [](const FilterEntry& entry) { return isStrategy(entry) && entry.step.enabled; }));
  edited_ = -1;
  for (const FilterEntry& entry : filters_) {
    if (isStrategy(entry) && std::ranges::find(before, entry) == before.end()) edited_ = entry.id;
  }
  preview_.cancel();
  if (edited_ >= 0 && environment_) {
    editTimer_.start();
  } else {
    editTimer_.stop();
    if (firstStrategy() < 0) model_.endPreview();
  }
}

void CellWatch::showCells(bool on) {
  shown_ = on;
  if (on) drape();
}

void CellWatch::mark() {
  MarkedCells marked;
  const auto inView = [this](const std::optional<CellId>& cell) {
    return cell && cell->block == model_.shownIndex() ? std::optional(cell->cell) : std::nullopt;
  };
  marked.hovered = inView(model_.hovered());
  marked.selected = inView(model_.selected());
  view_.setMarkedCells(marked);
}

CellColours CellWatch::colours() const {
  CellColours colours;
  const CellScale scale = model_.scaleOf(model_.shownIndex());
  for (std::size_t i = 0; i < draped_->size(); ++i) colours.push_back(scale.colourOf(i));
  return colours;
}

void CellWatch::drape() {
  if (draped_ == model_.shapes()) return;
  draped_ = shown_ ? model_.shapes() : nullptr;
  draping_.stop();
  if (!draped_ || !environment_) {
    view_.setCells(nullptr, {});
    return;
  }
  using Geometry = std::shared_ptr<const CellGeometry>;
  const auto show = [this](const Geometry& geometry) {
    view_.setCells(geometry, colours());
    mark();
  };
  draping_.start(
      *this,
      [environment = environment_, centre = centre_, shapes = draped_](RunContext& context) -> Geometry {
        return makeCellGeometry(*environment, centre, *shapes, context);
      },
      show, [show](const std::exception&) { show(nullptr); });  // memory ran out: the view shows no cells
}

}  // namespace footfall::ui
