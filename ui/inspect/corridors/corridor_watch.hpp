// Makes the corridor map of the result in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "core/navigation/bottleneck_list.hpp"
#include "ui/base/work/latest_work.hpp"
#include "ui/inspect/corridors/corridor_lines.hpp"
#include "ui/run/run_controller.hpp"

namespace footfall::ui {

/// The corridor map of a run, for panel and view.
struct ShownCorridors {
  CorridorMap map;
  CorridorLines lines;
  double slit = 0;               ///< a passage that is at most as wide is a slit between modelled things
  BottleneckList list;           ///< the bottlenecks that are listed, and how many are not
  bool isWithoutRadius = false;  ///< the pipeline's RadiusFilter was left out
};

/// Never waits. The map is made only while it is wanted, anew for each result; overtaken work is cancelled. The
/// passages are those of the pipeline without an agent's radius, which would make each of them narrower.
class CorridorWatch : public QObject {
  Q_OBJECT

 public:
  explicit CorridorWatch(RunController& controller, QObject* parent = nullptr);

  void setWanted(bool wanted);
  [[nodiscard]] bool isWanted() const { return isWanted_; }
  [[nodiscard]] bool isBusy() const { return work_.busy(); }
  /// Null while there is none; that of an older result while isBusy(), or while a run is under way.
  [[nodiscard]] const std::shared_ptr<const ShownCorridors>& shown() const { return shown_; }

 signals:
  void changed();
  void failed(const QString& message);

 private:
  void refresh();
  void pause();

  RunController& controller_;
  bool isWanted_ = false;
  std::shared_ptr<const FinishedRun> run_;  ///< run that shown_ belongs to, or will belong to
  std::shared_ptr<const ShownCorridors> shown_;
  LatestWork work_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
