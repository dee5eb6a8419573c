// "Try it": two places and the shortest path between them on the last result, computed in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "footfall/path.hpp"
#include "footfall/run_context.hpp"
#include "ui/base/background_queue.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

/// Lives on the window's thread and never waits there. While one path is computed, further changes wait for it, and
/// only the last of them is used; the shown path thus follows a drag as fast as paths are found. Nothing is computed
/// while the model is not active.
class PathModel : public QObject {
  Q_OBJECT

 public:
  explicit PathModel(QObject* parent = nullptr);
  ~PathModel() override;

  /// The data of a finished run that a path needs.
  struct Ground {
    std::shared_ptr<const NavigationMesh> mesh;  ///< mesh to walk on; null: none
    double reach = 0;                            ///< distance below a place at which its ground may lie (placeReach())
    std::shared_ptr<const Environment> environment;  ///< environment between its parts
    double agentHeight = 0, agentStep = 0, agentGap = 0;
    bool operator==(const Ground&) const = default;
  };
  void setGround(Ground ground);
  void setActive(bool active);
  void setStart(const std::optional<Vec3>& place) { setPlaces(place, target_); }
  void setTarget(const std::optional<Vec3>& place) { setPlaces(start_, place); }
  /// The places are passed by value, because they may be the model's own.
  void setPlaces(std::optional<Vec3> start, std::optional<Vec3> target);

  [[nodiscard]] const std::optional<Vec3>& start() const { return start_; }
  [[nodiscard]] const std::optional<Vec3>& target() const { return target_; }
  /// The result for the last two places; empty without both places or without a mesh. The barrier between two parts is
  /// added a little later, with another resultChanged().
  [[nodiscard]] const std::optional<PathResult>& result() const { return result_; }
  /// Returns whether a path, or the barrier between two parts, is being computed.
  [[nodiscard]] bool busy() const { return context_ != nullptr; }

 signals:
  void placesChanged();
  void resultChanged();
  void failed(const QString& message);

 private:
  struct Finder;
  void refresh(bool groundChanged);
  [[nodiscard]] bool isWanted() const { return active_ && ground_.mesh && start_ && target_; }
  /// Starts computing the path, or, with `failed`, the barrier between the parts.
  void startJob(std::optional<PathResult> failed = {});
  void finishJob(const Ground& ground, const std::optional<PathResult>& result, const QString& error);

  Ground ground_;
  bool active_ = false;
  bool isSeparating_ = false;  ///< the running job computes a barrier
  std::optional<Vec3> start_, target_;
  std::optional<PathResult> result_;
  bool isStale_ = false;
  std::shared_ptr<RunContext> context_;
  std::shared_ptr<Finder> finder_;  ///< used by the background thread only
  BackgroundQueue queue_;           // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
