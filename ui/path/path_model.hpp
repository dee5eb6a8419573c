// "Try it": two places and the shortest path between them on the last result, found in the background.
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

/// Lives on the window's thread and never waits there. While one path is looked for, further changes wait for it, and
/// only the last of them counts: what is shown follows a drag as fast as paths are found. Nothing is prepared or found
/// while it is not active.
class PathModel : public QObject {
  Q_OBJECT

 public:
  explicit PathModel(QObject* parent = nullptr);
  ~PathModel() override;

  /// What a path needs of a finished run.
  struct Ground {
    std::shared_ptr<const NavigationMesh> mesh;      ///< to walk on; null: none
    double reach = 0;                                ///< how far below a place it may lie (placeReach())
    std::shared_ptr<const Environment> environment;  ///< what stands between its parts
    double agentHeight = 0, agentStep = 0, agentGap = 0;
    bool operator==(const Ground&) const = default;
  };
  void setGround(Ground ground);
  void setActive(bool active);
  void setStart(const std::optional<Vec3>& place) { setPlaces(place, target_); }
  void setTarget(const std::optional<Vec3>& place) { setPlaces(start_, place); }
  /// Values, as the model's own places may be given.
  void setPlaces(std::optional<Vec3> start, std::optional<Vec3> target);

  [[nodiscard]] const std::optional<Vec3>& start() const { return start_; }
  [[nodiscard]] const std::optional<Vec3>& target() const { return target_; }
  /// The result for the last two places; nothing without both of them, or without a mesh. What keeps two
  /// parts apart is added a little later, with one more resultChanged().
  [[nodiscard]] const std::optional<PathResult>& result() const { return result_; }
  /// A path, or what keeps two parts apart, is being looked for.
  [[nodiscard]] bool busy() const { return context_ != nullptr; }

 signals:
  void placesChanged();
  void resultChanged();
  void failed(const QString& message);

 private:
  struct Finder;
  void refresh(bool groundChanged);
  [[nodiscard]] bool isWanted() const { return active_ && ground_.mesh && start_ && target_; }
  /// Looks for the path, or for what keeps the parts apart where `failed` failed.
  void startJob(std::optional<PathResult> failed = {});
  void finishJob(const Ground& ground, const std::optional<PathResult>& result, const QString& error);

  Ground ground_;
  bool active_ = false;
  bool isSeparating_ = false;  ///< the job under way is about what keeps parts apart
  std::optional<Vec3> start_, target_;
  std::optional<PathResult> result_;
  bool isStale_ = false;
  std::shared_ptr<RunContext> context_;
  std::shared_ptr<Finder> finder_;  ///< the background thread's
  BackgroundQueue queue_;           // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
