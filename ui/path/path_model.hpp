// "Try it": two places and the shortest path between them on the last result, computed in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "ui/base/namespaces.hpp"
#include "ui/base/work/background_queue.hpp"
#include "ui/path/way_finder.hpp"

namespace footfall::ui {

/// Lives on the window's thread and never waits there. While one path is computed, further changes wait for it, and
/// only the last of them is used; the shown path thus follows a drag as fast as paths are found. A search that takes
/// longer than 0.1 s more is cancelled for the change that waits. Nothing is computed while the model is not active.
class PathModel : public QObject {
  Q_OBJECT

 public:
  using Ground = WayGround;

  explicit PathModel(QObject* parent = nullptr);
  ~PathModel() override;

  void setGround(Ground ground);
  void setActive(bool active);
  void setStart(const std::optional<Vec3>& place) { setPlaces(place, target_); }
  void setTarget(const std::optional<Vec3>& place) { setPlaces(start_, place); }
  /// The places are passed by value, because they may be the model's own.
  void setPlaces(std::optional<Vec3> start, std::optional<Vec3> target);
  /// A body walks on the result without its RadiusFilter, and takes no drops. Its ground takes as long to prepare as
  /// the corridor map.
  void setBody(const WalkingBody& body);

  [[nodiscard]] const std::optional<Vec3>& start() const { return start_; }
  [[nodiscard]] const std::optional<Vec3>& target() const { return target_; }
  [[nodiscard]] const WalkingBody& body() const { return body_; }
  /// The result for the last two places; empty without both places, without a mesh, and where a body does not fit. The
  /// barrier between two parts is added a little later, with another resultChanged().
  [[nodiscard]] const std::optional<PathResult>& result() const { return way_.path; }
  /// The same for a body, with its narrowest passage; empty for a point.
  [[nodiscard]] const std::optional<BodyPath>& bodyPath() const { return way_.body; }
  /// Returns whether a path, or the barrier between two parts, is being computed.
  [[nodiscard]] bool busy() const { return context_ != nullptr; }
  /// Returns whether the ground is being prepared for bodies.
  [[nodiscard]] bool isPreparing() const { return isPreparing_; }

 signals:
  void placesChanged();
  void bodyChanged();
  void resultChanged();
  void preparingChanged();
  void failed(const QString& message);

 private:
  struct Finders;
  struct Request;
  void refresh(bool groundChanged);
  [[nodiscard]] bool isWanted() const { return active_ && ground_.mesh && start_ && target_; }
  /// Starts computing the path, or, with `failed`, the barrier between the parts.
  void startJob(std::optional<PathResult> failed = {});
  void finishJob(const Request& request, const std::optional<FoundWay>& way, const QString& error);
  void setPreparing(bool preparing);
  void stop();

  Ground ground_;
  bool active_ = false;
  bool isSeparating_ = false;  ///< the running job computes a barrier
  bool isPreparing_ = false;
  std::optional<Vec3> start_, target_;
  WalkingBody body_;
  FoundWay way_;
  bool isStale_ = false;
  std::shared_ptr<RunContext> context_;  ///< of the running job
  std::shared_ptr<RunContext> search_;   ///< of the search in it, without preparing the ground
  QTimer overtaken_;                     ///< runs while a change waits for a search
  std::shared_ptr<Finders> finders_;     ///< used by the background thread only
  BackgroundQueue queue_;                // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
