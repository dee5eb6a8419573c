// Repeated runs of the pipeline, without caches, for figures that can be trusted.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core/pipeline/runner.hpp"
#include "ui/base/latest_work.hpp"
#include "ui/base/processor_use.hpp"
#include "ui/view/cell_block.hpp"

namespace footfall::ui {

/// The middle and the ends of some values; of an even number of them, the middle is the smaller of the two.
struct Spread {
  double median = 0, least = 0, most = 0;
};
Spread spreadOf(std::vector<double> values);

struct MeasuredRun {
  RunResult result;  ///< without its mesh
  ProcessorUse processors;
};

/// The run whose whole time is the median.
std::size_t medianRun(const std::vector<MeasuredRun>& runs);
/// The blocks of a measured run.
CellBlocks blocksOf(const MeasuredRun& run);

class LoadMeasurement : public QObject {
  Q_OBJECT

 public:
  explicit LoadMeasurement(QObject* parent = nullptr);

  /// Runs in the background, one after the other. Replaces a measurement under way.
  void start(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, int threads, int count);
  void stop();
  [[nodiscard]] bool busy() const { return work_.busy(); }
  [[nodiscard]] const std::vector<MeasuredRun>& runs() const { return runs_; }
  /// The figures do not belong to what is shown any more.
  void clear();

 signals:
  /// `done` of `all` runs have finished.
  void progressed(int done, int all);
  /// runs() are there.
  void finished();
  void failed(const QString& message);
  /// Stopped or cleared.
  void ended();

 private:
  std::vector<MeasuredRun> runs_;
  int number_ = 0;   ///< of the measurement, so that progress of an earlier one is not taken for its own
  LatestWork work_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
