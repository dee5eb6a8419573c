// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/filter_tools.hpp"

#include <QUndoView>
#include <nlohmann/json.hpp>

#include "ui/agents/agents_panel.hpp"
#include "ui/base/text/translated.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/run/stale_badge.hpp"
#include "ui/view/feature_host.hpp"

namespace footfall::ui {
namespace {

constexpr int kAgentKeys = 9;

// Uses the context that lupdate finds for functions that belong to no class.
void addListCommands(const FeatureHost& host, FilterList& list) {
  CommandRegistry& commands = host.commands;
  for (const FilterActions::Entry& entry : list.actions().entries())
    commands.registerAction(entry.action, {entry.id, CommandMenu::Pipeline, QStringLiteral("steps"), {}, entry.help});
  commands.registerAction(
      list.presets()->menuAction(),
      {QStringLiteral("pipeline.presets"), CommandMenu::Pipeline, QStringLiteral("files"), tr("Pr&esets"), {}});
  QObject::connect(&list, &FilterList::failed, &host.messages, [&messages = host.messages](const QString& text) {
    messages.showErrorOf(MessageSubject::Filters, text);
  });
  QObject::connect(
      list.presets(), &PresetsMenu::done, &host.messages,
      [&messages = host.messages](const QString& text, const QString& label, const std::function<void()>& undo) {
        messages.showHint(text, label, undo);
      });
}

void addRunning(const FeatureHost& host, LevelView& view, RunController& controller) {
  QAction* automatic = host.commands.add({.id = QStringLiteral("pipeline.automatic"),
                                          .menu = CommandMenu::Pipeline,
                                          .group = QStringLiteral("runs"),
                                          .text = tr("Run &automatically"),
                                          .help = tr("Run after each edit; off: F5 runs"),
                                          .checkable = true},
                                         [&controller](bool on) { controller.setAutomatic(on); });
  automatic->setChecked(controller.automatic());
  QObject::connect(&controller, &RunController::automaticChanged, automatic, &QAction::setChecked);
  new StaleBadge(controller, &view);
  host.sections.add({QStringLiteral("run"),
                     [&controller] {
                       return nlohmann::json{{"automatic", controller.automatic()}}.dump();
                     },
                     [&controller](const std::string& text) {
                       controller.setAutomatic(text.empty() || nlohmann::json::parse(text).value("automatic", true));
                     }});
  QObject::connect(&controller, &RunController::automaticChanged, &host.sections, &SessionSections::changed);
}

void addHistory(const FeatureHost& host, Document& document) {
  auto* history = new QUndoView(document.undoStack());
  history->setObjectName(QStringLiteral("undoHistory"));
  history->setAccessibleName(tr("Edits"));
  history->setEmptyLabel(tr("As opened"));
  host.panels.add({.id = QStringLiteral("panel.history"),
                   .title = tr("Undo history"),
                   .help = tr("All edits; choose one to go back to it"),
                   .icon = QStringLiteral("undo")},
                  history);
}

void addAgents(const FeatureHost& host, Document& document, RunController& controller) {
  auto* panel = new AgentsPanel(document, controller);
  host.panels.add(
      {.id = QStringLiteral("panel.agents"),
       .title = tr("Agents"),
       .help = tr("The agents of the level: their sizes set the filters, and a table compares what each can reach"),
       .keys = {QKeySequence(Qt::Key_G)},
       .icon = QStringLiteral("agent"),
       .area = Qt::BottomDockWidgetArea},
      panel);
  QObject::connect(panel, &AgentsPanel::failed, &host.messages, &MessageBar::showError);
  const auto takeUnits = [&units = host.units, panel] { panel->setUnits(units.units()); };
  QObject::connect(&host.units, &UnitChoice::changed, panel, takeUnits);
  takeUnits();

  const QString group = QStringLiteral("agents");
  QList<QAction*> switches;
  for (int i = 0; i < kAgentKeys; ++i) {
    switches << host.commands.add({.id = QStringLiteral("agent.%1").arg(i + 1),
                                   .menu = CommandMenu::Tools,
                                   .group = group,
                                   .text = tr("Agent %1").arg(i + 1),
                                   .help = tr("Set the filters to this agent's sizes"),
                                   .keys = {QKeySequence(Qt::ALT | static_cast<Qt::Key>(Qt::Key_1 + i))}},
                                  [panel, i](bool) { panel->activate(i); });
  }
  QAction* none = host.commands.add({.id = QStringLiteral("agent.none"),
                                     .menu = CommandMenu::Tools,
                                     .group = group,
                                     .text = tr("&No agent"),
                                     .help = tr("Deactivate the agent; the filters keep their values"),
                                     .keys = {QKeySequence(Qt::ALT | Qt::Key_0)}},
                                    [panel](bool) { panel->letGo(); });
  QAction* all = host.commands.add({.id = QStringLiteral("agent.all"),
                                    .menu = CommandMenu::Tools,
                                    .group = group,
                                    .text = tr("&Compute all agents"),
                                    .help = tr("Compute the results of all agents in the background"),
                                    .icon = QStringLiteral("agent")},
                                   [panel](bool) { panel->computeAll(); });
  const auto rename = [&document, switches, none, all] {
    const std::vector<NamedAgent>& agents = document.state().agents;
    for (int i = 0; i < switches.size(); ++i) {
      const bool there = i < static_cast<int>(agents.size());
      switches[i]->setVisible(there);
      switches[i]->setEnabled(there);
      if (there)
        switches[i]->setText(tr("Agent: %1").arg(QString::fromStdString(agents[static_cast<std::size_t>(i)].name)));
    }
    none->setEnabled(document.state().agent != 0);
    all->setEnabled(!agents.empty());
  };
  QObject::connect(&document, &Document::agentsChanged, &host.window, rename);
  rename();
}

}  // namespace

void addFilterTools(const FeatureHost& host, LevelView& view, Document& document, RunController& controller,
                    FilterList& list) {
  addListCommands(host, list);
  addRunning(host, view, controller);
  addHistory(host, document);
  addAgents(host, document, controller);
}

}  // namespace footfall::ui
