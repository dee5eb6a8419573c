// "Try it": two places and the shortest path between them on the last result, found in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "core/navigation/path_finder.hpp"
#include "core/pipeline/run_context.hpp"
#include "ui/background_queue.hpp"

namespace footfall {

/// Lives on the window's thread and never waits there. While one path is looked for, further changes wait for it, and
/// only the last of them counts: what is shown follows a drag as fast as paths are found. Nothing is prepared or found
/// while it is not active.
class PathModel : public QObject {
  Q_OBJECT

 public:
  explicit PathModel(QObject* parent = nullptr);
  ~PathModel() override;

  /// The result to walk on (null: none) and how far below a place it may lie (placeReach()).
  void setMesh(std::shared_ptr<const NavigationMesh> mesh, double reach);
  void setActive(bool active);
  void setStart(const std::optional<Vec3>& place) { setPlaces(place, target_); }
  void setTarget(const std::optional<Vec3>& place) { setPlaces(start_, place); }
  void setPlaces(const std::optional<Vec3>& start, const std::optional<Vec3>& target);

  [[nodiscard]] const std::optional<Vec3>& start() const { return start_; }
  [[nodiscard]] const std::optional<Vec3>& target() const { return target_; }
  /// Of the last two places for which it was found; nothing without both of them, or without a mesh.
  [[nodiscard]] const std::optional<PathResult>& result() const { return result_; }
  /// A path is being looked for.
  [[nodiscard]] bool busy() const { return context_ != nullptr; }

 signals:
  void placesChanged();
  void resultChanged();
  void failed(const QString& message);

 private:
  struct Finder;
  void refresh(bool meshChanged);
  void startJob();
  void finishJob(const std::shared_ptr<const NavigationMesh>& mesh, const std::optional<PathResult>& result,
                 const QString& error);

  std::shared_ptr<const NavigationMesh> mesh_;
  double reach_ = 0;
  bool active_ = false;
  std::optional<Vec3> start_, target_;
  std::optional<PathResult> result_;
  bool isStale_ = false;
  std::shared_ptr<RunContext> context_;
  std::shared_ptr<Finder> finder_;  ///< the background thread's
  BackgroundQueue queue_;           // last: its thread ends before the rest goes
};

}  // namespace footfall
