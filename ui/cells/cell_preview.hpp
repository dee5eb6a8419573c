// The cells that a strategy would make, computed in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <memory>

#include "core/partitioning/partition.hpp"
#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/run_context.hpp"
#include "ui/base/latest_work.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

/// Lives on the window's thread and never waits there; the last request wins.
class CellPreview : public QObject {
  Q_OBJECT

 public:
  /// Takes a pipeline that is one parallel block, and how many threads are to run it.
  using Make =
      std::function<Partition(const std::shared_ptr<const Environment>&, const Pipeline& block, RunContext&, int)>;

  /// `make` runs in the background; by default it is the core's previewPartition.
  explicit CellPreview(QObject* parent = nullptr, Make make = {});

  /// Cells of the strategy at `step` of the pipeline, which may be switched off, and whose block may lack its end;
  /// as a run on so many threads would have them (0: on all).
  void request(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, std::size_t step, int threads);
  /// Drops the request under way: no signal is emitted for it any more.
  void cancel() { work_.stop(); }
  [[nodiscard]] bool busy() const { return work_.busy(); }

 signals:
  void ready(const footfall::detail::Partition& partition);
  void failed(const QString& message);

 private:
  Make make_;
  LatestWork work_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
