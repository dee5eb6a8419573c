// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/filter_tools.hpp"

#include <QCoreApplication>
#include <QUndoView>
#include <nlohmann/json.hpp>

#include "ui/agents/agents_panel.hpp"
#include "ui/run/stale_badge.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::ui {
namespace {

constexpr int kAgentKeys = 9;

// In the context that lupdate finds for functions that belong to no class.
QString tr(const char* text) { return QCoreApplication::translate("footfall::ui", text); }

void addListCommands(EditorWindow& window) {
  FilterList& list = window.filterList();
  CommandRegistry& commands = window.commands();
  for (const FilterActions::Entry& entry : list.actions().entries())
    commands.adopt(entry.action, {entry.id, CommandMenu::Pipeline, QStringLiteral("steps"), {}, entry.help});
  commands.adopt(
      list.presets()->menuAction(),
      {QStringLiteral("pipeline.presets"), CommandMenu::Pipeline, QStringLiteral("files"), tr("Pr&esets"), {}});
  QObject::connect(&list, &FilterList::failed, &window.messageBar(),
                   [&window](const QString& text) { window.messageBar().showErrorOf(MessageSubject::Filters, text); });
  QObject::connect(list.presets(), &PresetsMenu::done, &window.messageBar(),
                   [&window](const QString& text, const QString& label, const std::function<void()>& undo) {
                     window.messageBar().showHint(text, label, undo);
                   });
}

void addRunning(EditorWindow& window) {
  RunController& controller = window.controller();
  QAction* automatic = window.commands().add({.id = QStringLiteral("pipeline.automatic"),
                                              .menu = CommandMenu::Pipeline,
                                              .group = QStringLiteral("runs"),
                                              .text = tr("Run &automatically"),
                                              .help = tr("Run after each edit; off: F5 runs"),
                                              .checkable = true},
                                             [&controller](bool on) { controller.setAutomatic(on); });
  automatic->setChecked(controller.automatic());
  QObject::connect(&controller, &RunController::automaticChanged, automatic, &QAction::setChecked);
  new StaleBadge(controller, &window.view());
  window.addSessionSection({QStringLiteral("run"),
                            [&controller] {
                              return nlohmann::json{{"automatic", controller.automatic()}}.dump();
                            },
                            [&controller](const std::string& text) {
                              controller.setAutomatic(text.empty() ||
                                                      nlohmann::json::parse(text).value("automatic", true));
                            }});
  QObject::connect(&controller, &RunController::automaticChanged, &window, &EditorWindow::keepSoon);
}

void addHistory(EditorWindow& window) {
  auto* history = new QUndoView(window.document().undoStack());
  history->setObjectName(QStringLiteral("undoHistory"));
  history->setAccessibleName(tr("Edits"));
  history->setEmptyLabel(tr("As opened"));
  window.addPanel({.id = QStringLiteral("panel.history"),
                   .title = tr("Undo history"),
                   .help = tr("All edits; choose one to go back to it"),
                   .icon = QStringLiteral("undo")},
                  history);
}

void addAgents(EditorWindow& window) {
  auto* panel = new AgentsPanel(window.document(), window.controller());
  window.addPanel({.id = QStringLiteral("panel.agents"),
                   .title = tr("Agents"),
                   .help = tr("Who is to walk: heights and slopes that the filters follow, and what each can reach"),
                   .keys = {QKeySequence(Qt::Key_G)},
                   .icon = QStringLiteral("agent"),
                   .area = Qt::BottomDockWidgetArea},
                  panel);
  QObject::connect(panel, &AgentsPanel::failed, &window.messageBar(), &MessageBar::showError);
  const auto takeUnits = [&window, panel] { panel->setUnits(window.units().units()); };
  QObject::connect(&window.units(), &UnitChoice::changed, panel, takeUnits);
  takeUnits();

  const QString group = QStringLiteral("agents");
  QList<QAction*> switches;
  for (int i = 0; i < kAgentKeys; ++i) {
    switches << window.commands().add({.id = QStringLiteral("agent.%1").arg(i + 1),
                                       .menu = CommandMenu::Tools,
                                       .group = group,
                                       .text = tr("Agent %1").arg(i + 1),
                                       .help = tr("Give the filters this agent's sizes"),
                                       .keys = {QKeySequence(Qt::ALT | static_cast<Qt::Key>(Qt::Key_1 + i))}},
                                      [panel, i](bool) { panel->activate(i); });
  }
  QAction* none = window.commands().add({.id = QStringLiteral("agent.none"),
                                         .menu = CommandMenu::Tools,
                                         .group = group,
                                         .text = tr("&No agent"),
                                         .help = tr("Let go of the active agent; the filters stay as they are"),
                                         .keys = {QKeySequence(Qt::ALT | Qt::Key_0)}},
                                        [panel](bool) { panel->letGo(); });
  QAction* all = window.commands().add({.id = QStringLiteral("agent.all"),
                                        .menu = CommandMenu::Tools,
                                        .group = group,
                                        .text = tr("&Compute all agents"),
                                        .help = tr("Compute the results of all agents in the background"),
                                        .icon = QStringLiteral("agent")},
                                       [panel](bool) { panel->computeAll(); });
  const auto rename = [&window, switches, none, all] {
    const std::vector<NamedAgent>& agents = window.document().state().agents;
    for (int i = 0; i < switches.size(); ++i) {
      const bool there = i < static_cast<int>(agents.size());
      switches[i]->setVisible(there);
      switches[i]->setEnabled(there);
      if (there)
        switches[i]->setText(tr("Agent: %1").arg(QString::fromStdString(agents[static_cast<std::size_t>(i)].name)));
    }
    none->setEnabled(window.document().state().agent != 0);
    all->setEnabled(!agents.empty());
  };
  QObject::connect(&window.document(), &Document::agentsChanged, &window, rename);
  rename();
}

}  // namespace

void addFilterTools(EditorWindow& window) {
  addListCommands(window);
  addRunning(window);
  addHistory(window);
  addAgents(window);
}

}  // namespace footfall::ui
