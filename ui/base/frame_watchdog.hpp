// How long the window did not answer, and while it was doing what.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <chrono>
#include <vector>

class QEvent;

namespace footfall::ui {

/// Measures, on the window's thread, every stretch between two moments at which the event loop could take the next
/// event. GuardedApplication tells it of every event while it runs; a loop inside an event (a menu, a dialog) counts as
/// a loop, and waiting for events as nothing. One a program; not for other threads.
class FrameWatchdog : public QObject {
  Q_OBJECT

 public:
  explicit FrameWatchdog(QObject* parent = nullptr);
  ~FrameWatchdog() override;

  /// Forgets what was measured and measures from here on.
  void start();
  void stop();

  struct Stall {
    double milliseconds = 0;
    /// "QEvent::Paint (12) in footfall::ui::LevelView 'levelView'": the event that the loop had handed out.
    QString during;
  };
  /// 0 when nothing has been measured.
  [[nodiscard]] double longestStallMs() const { return longest_.milliseconds; }
  [[nodiscard]] const Stall& longestStall() const { return longest_; }
  /// Those of at least `milliseconds`, in the order in which they were; the first 1,000.
  [[nodiscard]] std::vector<Stall> stallsOver(double milliseconds) const;

  /// The one that runs; null when none does.
  static FrameWatchdog* running();

  /// Around the handling of one event; does nothing while no watchdog runs.
  class Handling {
   public:
    Handling(const QObject* receiver, const QEvent* event);
    ~Handling();
    Handling(const Handling&) = delete;
    Handling& operator=(const Handling&) = delete;

   private:
    FrameWatchdog* watchdog_;
  };

 private:
  using Clock = std::chrono::steady_clock;
  struct Level {
    int loop = 0;  ///< of the event loop that handed the event out
    const QObject* receiver = nullptr;
    QByteArray className;
    int type = 0;
  };

  void begin(const QObject* receiver, const QEvent* event);
  void end();
  void closeStretch();

  std::vector<Level> levels_;  ///< events being handled, each handed out by a loop inside the one before
  int depth_ = 0;              ///< of notify() in all; events that code sends to itself belong to the one they are in
  std::vector<int> depths_;    ///< depth at which each level began
  bool measuring_ = false;
  Clock::time_point from_;
  Stall longest_;
  std::vector<Stall> stalls_;
};

}  // namespace footfall::ui
