// How many threads runs may use: a setting of this machine's user.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <vector>

namespace footfall::ui {

class CommandRegistry;

/// How many threads this machine runs at the same time.
int processorCount();

/// The numbers of threads to choose from, increasing: some below that of the processors, and that one itself.
std::vector<int> threadChoices(int processors);

/// What was chosen is kept in the settings. Results do not depend on it.
class RunThreads : public QObject {
  Q_OBJECT

 public:
  explicit RunThreads(QObject* parent = nullptr);

  /// 0: as many as there are processors.
  [[nodiscard]] int chosen() const { return chosen_; }
  /// How many threads runs get.
  [[nodiscard]] int count() const { return chosen_ > 0 ? chosen_ : processorCount(); }
  void choose(int threads);

 signals:
  void changed();

 private:
  int chosen_ = 0;
};

/// "All 8 threads", "3 threads"; 0 stands for all.
QString threadsText(int threads);

/// The submenu Threads in the menu Pipeline.
void addThreadCommands(CommandRegistry& commands, RunThreads& threads);

}  // namespace footfall::ui
