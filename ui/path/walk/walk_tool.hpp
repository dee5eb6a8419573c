// Walking over the result in first person, with the agent's own body.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "footfall/path.hpp"
#include "ui/base/work/latest_work.hpp"
#include "ui/path/path_model.hpp"
#include "ui/path/walk/ground_walk.hpp"
#include "ui/path/walk/walk_figure.hpp"
#include "ui/view/level_view.hpp"
#include "ui/view/steering/eye_pose.hpp"
#include "ui/view/steering/steering_input.hpp"
#include "ui/view/view_tool.hpp"

namespace footfall::ui {

/// A click (or Enter, in the middle of the view) says where to stand; from then on W, A, S and D or the arrows walk,
/// and the mouse looks. Esc leaves, and the camera goes back to where it was. A new result is walked on as soon as it
/// is there, from the nearest place of it.
class WalkTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  WalkTool(LevelView& view, QObject* parent);

  /// What is walked on, and how large the body is; prepared in the background while the tool has the mouse.
  void setGround(const PathModel::Ground& ground, const WalkBody& body, double metresPerUnit);
  /// Metres a second.
  void setSpeed(double speed) { speed_ = speed; }

  /// Stands at the walkable place that is nearest, and looks as the camera does.
  void standAt(const Vec3& place);
  [[nodiscard]] bool isWalking() const { return walk_ && walk_->place(); }
  /// Where the feet are; the tool must be walking.
  [[nodiscard]] Vec3 feet() const { return walk_->place()->position; }
  [[nodiscard]] const Sight& sight() const { return sight_; }
  /// The result can be walked on.
  [[nodiscard]] bool isReady() const { return finder_ != nullptr; }

  void mouseMoved(const ViewMouse& mouse) override;
  void clicked(const ViewMouse& mouse) override;
  bool keyPressed(const QKeyEvent& event) override;
  void mouseLeft() override;
  void ended() override;
  [[nodiscard]] QString hint() const override;

 signals:
  void hintChanged(const QString& hint);
  void failed(const QString& message);

 private:
  void prepare();
  void takeFinder(std::shared_ptr<const PathFinder> finder);
  void advance(double seconds);
  void placeCamera();
  void showBody(const std::optional<Vec3>& at);

  LevelView& view_;
  SteeringInput input_;
  PathModel::Ground ground_;
  WalkBody body_;
  double metresPerUnit_ = 1;
  double speed_ = 1.4;
  std::shared_ptr<const PathFinder> finder_;   ///< the ground's; null until it is prepared
  std::shared_ptr<const PathFinder> earlier_;  ///< an earlier ground's, of which the next one is made
  std::optional<GroundWalk> walk_;
  Sight sight_;
  double height_ = 0;     ///< the eyes' height, which follows the feet
  double fallSpeed_ = 0;  ///< units a second, while it falls
  bool isFalling_ = false;
  std::optional<CameraPose> before_;  ///< the camera to go back to
  std::optional<Vec3> wanted_;        ///< to stand at once the ground is prepared
  LatestWork work_;                   // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
