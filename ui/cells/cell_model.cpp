// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/cell_model.hpp"

#include <QMap>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/text/filter_text.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

bool sameShapes(const std::vector<CellBounds>& a, const std::vector<CellReport>& b) {
  return std::ranges::equal(a, b, [](const CellBounds& x, const CellReport& y) {
    return x.lower == y.bounds.lower && x.upper == y.bounds.upper;
  });
}

QString rangeText(double lower, double upper, const QString& unit) {
  if (std::isinf(lower) && std::isinf(upper)) return CellModel::tr("everything");
  if (std::isinf(lower)) return CellModel::tr("below %1 %2").arg(measureText(upper), unit);
  if (std::isinf(upper)) return CellModel::tr("from %1 %2").arg(measureText(lower), unit);
  return CellModel::tr("%1 to %2 %3").arg(measureText(lower), measureText(upper), unit);
}

}  // namespace

const CellBlock* CellModel::shownBlock() const { return empty() ? nullptr : &blocks()[shownIndex()]; }

void CellModel::setBlocks(CellBlocks blocks) {
  blocks_ = std::move(blocks);
  reuse_.clear();
  preview_.reset();
  shown_ = blocks_.empty() ? 0 : std::min(shown_, blocks_.size() - 1);
  changed();
}

void CellModel::setReuse(std::vector<std::vector<CellReuse>> reuse) {
  reuse_ = std::move(reuse);
  if (!preview_) emit figuresChanged();
}

const CellReuse* CellModel::reuseOf(const CellId& cell) const {
  const bool known = !preview_ && cell.block < blocks_.size() && cell.block < reuse_.size() &&
                     blocks_[cell.block].origin == CellBlock::Origin::Run &&
                     reuse_[cell.block].size() == blocks_[cell.block].report.cells.size();
  return known && cell.cell < reuse_[cell.block].size() ? &reuse_[cell.block][cell.cell] : nullptr;
}

bool CellModel::isCached(const CellId& cell) const {
  if (preview_ || cell.block >= blocks_.size()) return false;
  const CellReuse* reuse = reuseOf(cell);
  return blocks_[cell.block].origin == CellBlock::Origin::Cache || (reuse != nullptr && reuse->all());
}

int CellModel::cachedCells() const {
  int cached = 0;
  const std::size_t block = shownIndex();
  for (std::size_t i = 0; !preview_ && block < blocks_.size() && i < blocks_[block].report.cells.size(); ++i)
    cached += isCached({block, i}) ? 1 : 0;
  return cached;
}

// The part of a cell that earlier runs have computed; empty for none.
QString CellModel::cacheText(const CellId& cell) const {
  if (!preview_ && blocks_[cell.block].origin == CellBlock::Origin::Cache)
    return tr("all, with the figures of that run");
  const CellReuse* reuse = reuseOf(cell);
  if (reuse == nullptr || reuse->reused == 0) return {};
  return tr("%1 of %2 floors").arg(countText(reuse->reused), countText(reuse->floors));
}

void CellModel::showPreview(const Partition& partition) {
  CellBlock block;
  block.report.strategy = partition.strategy;
  block.report.reason = partition.reason;
  for (const Cell& cell : partition.cells) {
    CellReport& report = block.report.cells.emplace_back();
    report.bounds = cell.bounds;
    report.cost = cell.cost;
    report.trianglesIn = cell.floors + cell.obstacles;
  }
  block.finished.assign(block.report.cells.size(), 0);
  preview_ = CellBlocks{std::move(block)};
  changed();
}

void CellModel::endPreview() {
  if (!preview_) return;
  preview_.reset();
  changed();
}

void CellModel::setShownIndex(std::size_t block) {
  if (preview_ || block >= blocks_.size() || block == shown_) return;
  shown_ = block;
  changed();
}

void CellModel::changed() {
  const CellBlock* block = shownBlock();
  const bool same = block ? shapes_ && sameShapes(*shapes_, block->report.cells) : !shapes_;
  if (!same) {
    shapes_.reset();
    if (block) {
      auto bounds = std::make_shared<std::vector<CellBounds>>();
      for (const CellReport& cell : block->report.cells) bounds->push_back(cell.bounds);
      shapes_ = std::move(bounds);
    }
  }
  // Other cells with the same numbers are not the hovered ones.
  if (!same || !contains(hovered_)) setHovered({});
  if (!same || !contains(selected_)) select({}, false);
  if (!same) emit shapesChanged();
  emit figuresChanged();
}

bool CellModel::contains(const std::optional<CellId>& cell) const {
  return !cell || (cell->block < blocks().size() && cell->cell < blocks()[cell->block].report.cells.size());
}

void CellModel::setThreads(int threads) {
  if (std::exchange(threads_, threads) != threads) emit figuresChanged();
}

void CellModel::setColouring(CellColouring colouring) {
  if (std::exchange(colouring_, colouring) != colouring) emit figuresChanged();
}

void CellModel::setHovered(std::optional<CellId> cell) {
  if (!contains(cell)) cell.reset();
  if (std::exchange(hovered_, cell) != cell) emit hoveredChanged();
}

void CellModel::select(std::optional<CellId> cell, bool frame) {
  if (!contains(cell)) cell.reset();
  if (cell && !preview_) setShownIndex(cell->block);
  if (std::exchange(selected_, cell) != cell) emit selectedChanged();
  if (cell && frame) emit frameRequested(*cell);
}

// The places are along the file's axes.
void CellModel::describePlace(const CellBounds& bounds,
                              const std::function<void(const QString&, const QString&)>& row) const {
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (axis == 2 && !std::isfinite(bounds.lower[i]) && !std::isfinite(bounds.upper[i])) continue;  // cells of the plan
    const LevelUnits::FileAxis file = units_.fileAxis(axis);
    const double factor = file.same ? units_.factor() : -units_.factor();
    const auto [lower, upper] = std::minmax({bounds.lower[i] * factor, bounds.upper[i] * factor});
    const QString name = axisName(file.axis).toLower();
    row(axis == 2 ? tr("height (%1)").arg(name) : name, rangeText(lower, upper, units_.name()));
  }
}

void CellModel::setUnits(const LevelUnits& units) {
  units_ = units;
  emit figuresChanged();
}

QString CellModel::describe(CellId id) const {
  if (!contains(id)) return {};
  const CellBlock& block = blocks()[id.block];
  const CellReport& cell = block.report.cells[id.cell];
  QStringList rows;
  const auto row = [&](const QString& name, const QString& value) {
    rows << QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>").arg(name, value);
  };
  describePlace(cell.bounds, row);
  row(tr("estimated cost"), valueText(CellColouring::Cost, cell.cost));
  if (block.finished[id.cell]) {
    row(tr("triangles"), tr("%1 in, %2 out").arg(countText(cell.trianglesIn), countText(cell.trianglesOut)));
    row(tr("time"), durationText(cell.workMs()));
    if (const QString cache = cacheText(id); !cache.isEmpty()) row(tr("from the cache"), cache);
    QMap<int, double> threads;
    std::vector<std::pair<QString, double>> filters;
    for (const CellSpan& span : cell.spans) {
      threads[span.thread] += span.endMs - span.startMs;
      const QString name = filterName(span.filter);
      auto known = std::ranges::find(filters, name, &std::pair<QString, double>::first);
      if (known == filters.end()) known = filters.insert(known, {name, 0});
      known->second += span.endMs - span.startMs;
    }
    QStringList helpers;
    for (const int thread : threads.keys()) {
      if (thread != cell.thread) helpers << QString::number(thread);
    }
    if (!block.ranks.empty())
      row(tr("rank"), QString::number(block.ranks.placeOf(cell.thread).rank));
    else
      row(tr("thread"), helpers.isEmpty()
                            ? QString::number(cell.thread)
                            : tr("%1, helped by %2").arg(cell.thread).arg(helpers.join(QStringLiteral(", "))));
    for (const auto& [name, time] : filters) row(name, durationText(time));
  } else if (cell.trianglesIn > 0) {
    row(tr("triangles"), tr("%1 in").arg(countText(cell.trianglesIn)));
  }
  QString title = tr("Cell %1 of %2").arg(id.cell + 1).arg(block.report.cells.size());
  if (previewing()) {
    title += tr(" (preview)");
  } else if (!block.finished[id.cell]) {
    title += tr(" (not finished)");
  }
  return QStringLiteral("<b>%1</b><table cellspacing=0>%2</table>").arg(title, rows.join(QString()));
}

}  // namespace footfall::ui
