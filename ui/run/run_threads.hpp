// The number of threads of runs, a user setting on this machine.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <vector>

namespace footfall::ui {

class CommandRegistry;

/// The number of threads that this machine runs at the same time.
int processorCount();

/// The numbers of threads to choose from, ascending: some below the number of processors, and that number itself.
std::vector<int> threadChoices(int processors);

/// The choice is kept in the settings. Results do not depend on it.
class RunThreads : public QObject {
  Q_OBJECT

 public:
  explicit RunThreads(QObject* parent = nullptr);

  /// The chosen number; 0: that of the processors.
  [[nodiscard]] int chosen() const { return chosen_; }
  /// The number of threads that runs use.
  [[nodiscard]] int count() const { return chosen_ > 0 ? chosen_ : processorCount(); }
  void choose(int threads);

 signals:
  void changed();

 private:
  int chosen_ = 0;
};

/// The text of a number: "All 8 threads", "3 threads"; 0 stands for all.
QString threadsText(int threads);

/// Adds the submenu Threads to the menu Pipeline.
void addThreadCommands(CommandRegistry& commands, RunThreads& threads);

}  // namespace footfall::ui
