// Measures how long the window did not respond, and during which event.
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
/// event. GuardedApplication reports every event to the running watchdog. A loop inside an event (a menu, a dialog)
/// counts as a loop, and waiting for events does not count. There is one in a program; other threads must not use it.
class FrameWatchdog : public QObject {
  Q_OBJECT

 public:
  explicit FrameWatchdog(QObject* parent = nullptr);
  ~FrameWatchdog() override;

  /// Discards earlier measurements and starts measuring.
  void start();
  void stop();

  struct Stall {
    double milliseconds = 0;
    /// The event that the loop had dispatched: "QEvent::Paint (12) in footfall::ui::LevelView 'levelView'".
    QString during;
  };
  /// The longest stall; 0 when nothing has been measured.
  [[nodiscard]] double longestStallMs() const { return longest_.milliseconds; }
  [[nodiscard]] const Stall& longestStall() const { return longest_; }
  /// Stalls of at least `milliseconds`, in order of time; the first 1,000.
  [[nodiscard]] std::vector<Stall> stallsOver(double milliseconds) const;

  /// The running watchdog; null when there is none.
  static FrameWatchdog* running();

  /// Marks the handling of one event; does nothing while no watchdog runs.
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
    int loop = 0;  ///< event loop that dispatched the event
    const QObject* receiver = nullptr;
    QByteArray className;
    int type = 0;
  };

  void begin(const QObject* receiver, const QEvent* event);
  void end();
  void closeStretch();

  std::vector<Level> levels_;  ///< events being handled, each dispatched by a loop inside the one before
  int depth_ = 0;              ///< nesting of notify(); events that code sends directly belong to the event around them
  std::vector<int> depths_;    ///< depth at which each level began
  bool measuring_ = false;
  Clock::time_point from_;
  Stall longest_;
  std::vector<Stall> stalls_;
};

}  // namespace footfall::ui
