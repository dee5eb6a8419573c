// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_threads.hpp"

#include <QActionGroup>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "core/base/worker_arena.hpp"
#include "ui/base/commands/commands.hpp"

namespace footfall::ui {
namespace {

const auto kSetting = QStringLiteral("threads");
constexpr int kAllListed = 8;  // powers of two suffice for more processors

}  // namespace

int processorCount() { return detail::machineThreads(); }

std::vector<int> threadChoices(int processors) {
  std::vector<int> choices;
  for (int n = 1; n < processors; n += processors <= kAllListed ? 1 : n) choices.push_back(n);
  choices.push_back(processors);
  return choices;
}

RunThreads::RunThreads(QObject* parent) : QObject(parent) {
  setObjectName(QStringLiteral("runThreads"));
  const int kept = QSettings().value(kSetting).toInt();
  // Settings may come from a machine with more processors.
  if (kept > 0 && kept < processorCount()) chosen_ = kept;
}

void RunThreads::choose(int threads) {
  const int next = threads >= processorCount() ? 0 : std::max(0, threads);
  if (std::exchange(chosen_, next) == next) return;
  QSettings().setValue(kSetting, next);
  emit changed();
}

QString threadsText(int threads) {
  if (threads == 0) return RunThreads::tr("All threads (%1)").arg(processorCount());
  return threads == 1 ? RunThreads::tr("1 thread") : RunThreads::tr("%1 threads").arg(threads);
}

void addThreadCommands(CommandRegistry& commands, RunThreads& threads) {
  auto* group = new QActionGroup(&threads);
  std::vector<int> choices = threadChoices(processorCount());
  choices.back() = 0;
  if (threads.chosen() > 0 && std::ranges::find(choices, threads.chosen()) == choices.end())
    choices.insert(std::ranges::upper_bound(choices.begin(), choices.end() - 1, threads.chosen()), threads.chosen());
  for (const int n : choices) {
    Command command{QStringLiteral("pipeline.threads.%1").arg(n),
                    CommandMenu::Pipeline,
                    QStringLiteral("threads"),
                    threadsText(n),
                    RunThreads::tr("The largest number of threads of a run; the result does not depend on it"),
                    {},
                    {},
                    true};
    QAction* action = commands.add(command, [&threads, n](bool on) {
      if (on) threads.choose(n);
    });
    action->setData(n);
    group->addAction(action);
    action->setChecked(threads.chosen() == n);
    QObject::connect(&threads, &RunThreads::changed, action, [&threads, action, n] {
      if (threads.chosen() == n) action->setChecked(true);
    });
  }
}

}  // namespace footfall::ui
