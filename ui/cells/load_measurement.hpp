// Repeated runs of the pipeline, without caches, for reliable figures.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core/pipeline/runner.hpp"
#include "ui/base/work/latest_work.hpp"
#include "ui/base/work/processor_use.hpp"
#include "ui/view/cells/cell_block.hpp"

namespace footfall::ui {

/// The median and the extremes of some values. The median of an even number of values is the smaller of the middle two.
struct Spread {
  double median = 0, least = 0, most = 0;
};
Spread spreadOf(std::vector<double> values);

struct MeasuredRun {
  RunResult result;  ///< without its mesh
  ProcessorUse processors;
};

/// The run with the median total time.
std::size_t medianRun(const std::vector<MeasuredRun>& runs);
/// The blocks of a measured run.
CellBlocks blocksOf(const MeasuredRun& run);

class LoadMeasurement : public QObject {
  Q_OBJECT

 public:
  explicit LoadMeasurement(QObject* parent = nullptr);

  /// Runs in the background, one after the other. Replaces the present measurement.
  void start(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, int threads, int count);
  void stop();
  [[nodiscard]] bool busy() const { return work_.busy(); }
  [[nodiscard]] const std::vector<MeasuredRun>& runs() const { return runs_; }
  /// Discards figures that no longer belong to what is shown.
  void clear();

 signals:
  /// Emitted when `done` of `all` runs have finished.
  void progressed(int done, int all);
  /// Emitted when runs() are available.
  void finished();
  void failed(const QString& message);
  /// Emitted when the measurement is stopped or cleared.
  void ended();

 private:
  std::vector<MeasuredRun> runs_;
  int number_ = 0;   ///< number of the measurement; progress of an earlier one is ignored
  LatestWork work_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
