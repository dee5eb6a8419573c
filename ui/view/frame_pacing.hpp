// How much of a picture is drawn when: frames while the camera moves, and large pictures between two events.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>

#include "ui/view/scene_renderer.hpp"

namespace footfall::ui {

/// While the camera moves, frames leave out what would make them slow. When it rests, a frame shows everything; where
/// that takes long, slices of drawing come between the events of the window until it does.
class FramePacing : public QObject {
  Q_OBJECT

 public:
  static constexpr double kSliceMs = 20;  ///< of drawing between two events

  FramePacing();
  /// The camera, or something else that is dragged, moves.
  void move() { rest_.start(); }
  /// It rests from now on.
  void rest() { rest_.stop(); }
  [[nodiscard]] bool isMoving() const { return rest_.isActive(); }
  /// Frames are to show everything, however long that takes.
  void setUnhurried(bool on) { unhurried_ = on; }
  /// A run is under way: slices of a picture that takes long leave it the processors for most of the time.
  void setComputing(bool on);
  /// Another scene: how long it takes is not known.
  void forget() { wholeMs_ = 0; }

  /// A frame begins; what it may leave out.
  SceneRenderer::Haste begin();
  /// It has ended. `whole`: it shows everything; `wholeMs`: the time of everything, where the renderer knows.
  void end(const SceneRenderer::Haste& haste, bool whole, double wholeMs);
  /// A slice has been drawn.
  void endSlice(bool complete);

  /// The last frame showed everything, and nothing moves.
  [[nodiscard]] bool isWhole() const { return whole_ && !isMoving(); }
  /// 0 before the first frame.
  [[nodiscard]] double lastMs() const { return lastMs_; }
  /// How long it takes to draw everything anew; 0 while that is not known.
  [[nodiscard]] double wholeMs() const { return wholeMs_; }
  /// When the last frame began.
  [[nodiscard]] std::chrono::steady_clock::time_point lastBegun() const { return begun_; }

 signals:
  /// A frame is due.
  void frameDue();
  /// A slice is due, of at most kSliceMs.
  void sliceDue();

 private:
  void startSlices();

  QTimer rest_;    ///< runs while something moves
  QTimer slices_;  ///< to the next slice of a picture
  bool whole_ = false;
  bool unhurried_ = false;
  bool computing_ = false;
  int slicesDrawn_ = 0;  ///< since a picture was complete
  double lastMs_ = 0;
  double wholeMs_ = 0;
  std::chrono::steady_clock::time_point begun_;
};

}  // namespace footfall::ui
