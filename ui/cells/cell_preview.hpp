// Computes the cells that a strategy would make, in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <memory>

#include "core/partitioning/partition.hpp"
#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/work/latest_work.hpp"

namespace footfall::ui {

/// Lives on the window's thread and never waits there; a new request replaces the earlier one.
class CellPreview : public QObject {
  Q_OBJECT

 public:
  /// Makes the cells of a pipeline that is one parallel block, for a number of threads.
  using Make =
      std::function<Partition(const std::shared_ptr<const Environment>&, const Pipeline& block, RunContext&, int)>;

  /// `make` runs in the background; by default it is the core's previewPartition.
  explicit CellPreview(QObject* parent = nullptr, Make make = {});

  /// Requests the cells of the strategy at `step` of the pipeline. The strategy may be switched off, and its block may
  /// lack its end. The cells are those of a run on this many threads (0: all).
  void request(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, std::size_t step, int threads);
  /// Drops the present request; no signal is emitted for it any more.
  void cancel() { work_.stop(); }
  [[nodiscard]] bool busy() const { return work_.busy(); }

 signals:
  void ready(const footfall::detail::Partition& partition);
  void failed(const QString& message);

 private:
  Make make_;
  LatestWork work_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
