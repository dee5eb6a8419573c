// Decides what each frame draws: reduced frames while the camera moves, and slices of large pictures between events.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>

#include "ui/view/scene/scene_renderer.hpp"

namespace footfall::ui {

/// While the camera moves, frames omit everything that would make them slow. When it rests, a frame shows everything;
/// where that takes long, the picture is drawn in slices between the events of the window.
class FramePacing : public QObject {
  Q_OBJECT

 public:
  static constexpr double kSliceMs = 20;  ///< of drawing between two events

  FramePacing();
  /// The camera, or a dragged object, moves.
  void move() { rest_.start(); }
  /// The camera rests from now on.
  void rest() { rest_.stop(); }
  [[nodiscard]] bool isMoving() const { return rest_.isActive(); }
  /// Sets whether frames show everything, however long that takes.
  void setUnhurried(bool on) { unhurried_ = on; }
  /// Sets whether a run is under way; slices of a slow picture then leave it the processors for most of the time.
  void setComputing(bool on);
  /// Called for another scene: its drawing time is not known.
  void forget() { wholeMs_ = 0; }

  /// Begins a frame and returns what it may omit.
  SceneRenderer::Haste begin();
  /// Ends a frame. `whole`: it shows everything; `wholeMs`: the time of everything, where the renderer knows it.
  void end(const SceneRenderer::Haste& haste, bool whole, double wholeMs);
  /// A slice has been drawn.
  void endSlice(bool complete);

  /// Returns whether the last frame showed everything, and nothing moves.
  [[nodiscard]] bool isWhole() const { return whole_ && !isMoving(); }
  /// Time of the last frame; 0 before the first.
  [[nodiscard]] double lastMs() const { return lastMs_; }
  /// Time to draw everything anew; 0 while that is not known.
  [[nodiscard]] double wholeMs() const { return wholeMs_; }
  /// Time at which the last frame began.
  [[nodiscard]] std::chrono::steady_clock::time_point lastBegun() const { return begun_; }

 signals:
  /// Emitted when a frame is due.
  void frameDue();
  /// Emitted when a slice is due, of at most kSliceMs.
  void sliceDue();

 private:
  void startSlices();

  QTimer rest_;    ///< runs while something moves
  QTimer slices_;  ///< time to the next slice of a picture
  bool whole_ = false;
  bool unhurried_ = false;
  bool computing_ = false;
  int slicesDrawn_ = 0;  ///< number since the last complete picture
  double lastMs_ = 0;
  double wholeMs_ = 0;
  std::chrono::steady_clock::time_point begun_;
};

}  // namespace footfall::ui
