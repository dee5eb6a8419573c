// The cells that the window shows. The view, the timeline and the load figures share this model, so that they agree on
// the hovered and the selected cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/partitioning/partition.hpp"
#include "core/pipeline/cell_reuse.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/level_units.hpp"
#include "ui/run/run_threads.hpp"
#include "ui/view/cells/cell_block.hpp"
#include "ui/view/cells/cell_colours.hpp"

namespace footfall::ui {

/// Holds the blocks of a run, or temporarily the cells that a strategy would make (a preview). The view shows one
/// block; hovered and selected cells are always cells of blocks().
class CellModel : public QObject {
  Q_OBJECT

 public:
  using Shapes = std::shared_ptr<const std::vector<CellBounds>>;

  using QObject::QObject;

  /// Shows the blocks of the present or the last run. Figures that arrive during a run keep hover and selection.
  void setBlocks(CellBlocks blocks);
  /// The floors of the cells of those blocks that the run took from the cache; empty for blocks of which that is not
  /// known, as for all after setBlocks().
  void setReuse(std::vector<std::vector<CellReuse>> reuse);
  /// All of the cell's floors came from the cache; never in a preview.
  [[nodiscard]] bool isCached(const CellId& cell) const;
  /// The number of such cells in the shown block.
  [[nodiscard]] int cachedCells() const;
  /// Shown until endPreview() or other blocks.
  void showPreview(const Partition& partition);
  void endPreview();

  [[nodiscard]] bool previewing() const { return preview_.has_value(); }
  [[nodiscard]] const CellBlocks& blocks() const { return preview_ ? *preview_ : blocks_; }
  [[nodiscard]] bool empty() const { return blocks().empty(); }
  /// The block that the view shows; null when there is none.
  [[nodiscard]] const CellBlock* shownBlock() const;
  [[nodiscard]] std::size_t shownIndex() const { return preview_ ? 0 : shown_; }
  void setShownIndex(std::size_t block);
  /// The bounds of its cells; cells with other bounds are another object. Null when there is none.
  [[nodiscard]] Shapes shapes() const { return shapes_; }

  [[nodiscard]] CellColouring colouring() const { return colouring_; }
  void setColouring(CellColouring colouring);
  [[nodiscard]] CellScale scaleOf(std::size_t block) const { return {blocks()[block], colouring_}; }

  [[nodiscard]] std::optional<CellId> hovered() const { return hovered_; }
  void setHovered(std::optional<CellId> cell);
  [[nodiscard]] std::optional<CellId> selected() const { return selected_; }
  /// Selects a cell; with `frame`, the view moves to it.
  void select(std::optional<CellId> cell, bool frame);

  /// The number of threads that a run would have; at first all of the machine.
  [[nodiscard]] int threads() const { return threads_; }
  void setThreads(int threads);

  void setUnits(const LevelUnits& units);
  /// All known figures of a cell, as rich text.
  [[nodiscard]] QString describe(CellId cell) const;

 signals:
  /// Emitted when there are other cells, or another block is shown.
  void shapesChanged();
  /// Emitted when figures, colours or their meaning changed.
  void figuresChanged();
  void hoveredChanged();
  void selectedChanged();
  void frameRequested(footfall::ui::CellId cell);

 private:
  void changed();
  void describePlace(const CellBounds& bounds, const std::function<void(const QString&, const QString&)>& row) const;
  [[nodiscard]] bool contains(const std::optional<CellId>& cell) const;

  [[nodiscard]] const CellReuse* reuseOf(const CellId& cell) const;
  [[nodiscard]] QString cacheText(const CellId& cell) const;

  CellBlocks blocks_;
  std::vector<std::vector<CellReuse>> reuse_;
  std::optional<CellBlocks> preview_;
  std::size_t shown_ = 0;
  Shapes shapes_;
  CellColouring colouring_ = CellColouring::Thread;
  std::optional<CellId> hovered_, selected_;
  int threads_ = processorCount();
  LevelUnits units_;
};

}  // namespace footfall::ui
