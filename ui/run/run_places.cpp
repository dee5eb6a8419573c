// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_places.hpp"

#include <QActionGroup>
#include <QCoreApplication>
#include <QFileInfo>
#include <QThread>
#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "footfall/errors.hpp"
#include "ui/base/commands/commands.hpp"

namespace footfall::ui {
namespace {

using Json = nlohmann::ordered_json;
using Kind = RunPlace::Kind;

constexpr std::array<std::pair<Kind, const char*>, 4> kKinds = {{{Kind::ThisProcess, "this_program"},
                                                                 {Kind::Processes, "processes"},
                                                                 {Kind::Hosts, "hosts"},
                                                                 {Kind::Slurm, "slurm"}}};

bool mayStartUnasked(const RunPlace& place) {
  return place.kind == Kind::ThisProcess ||
         (place.kind == Kind::Processes && place.processes <= std::max(2, QThread::idealThreadCount()));
}

int processesIn(const Json& json) {
  const Json count = json.value("processes", Json(2));
  // A number beyond 64 bits is not an integer in JSON, and one beyond 63 bits is negative here.
  const std::int64_t processes = count.is_number_integer() ? count.get<std::int64_t>() : 0;
  if (processes < 1 || processes > kMostProcesses)
    throw InputError(FOOTFALL_TEXT("run_on: %1 processes; give 1 to %2"), count.dump(), kMostProcesses);
  return static_cast<int>(processes);
}

}  // namespace

void RunPlaces::choose(const RunPlace& place) { set(place, std::nullopt); }

void RunPlaces::forgetSuggestion() { set(chosen_, std::nullopt); }

void RunPlaces::set(const RunPlace& chosen, const std::optional<RunPlace>& suggested) {
  if (chosen_ == chosen && suggested_ == suggested) return;
  chosen_ = chosen;
  suggested_ = suggested;
  emit changed();
}

std::string RunPlaces::save() const {
  const RunPlace& place = suggested_ ? *suggested_ : chosen_;
  Json json;
  for (const auto& [kind, name] : kKinds)
    if (kind == place.kind) json["on"] = name;
  if (place.kind != Kind::ThisProcess) json["processes"] = place.processes;
  if (place.kind == Kind::Hosts) json["host_file"] = place.hostFile;
  if (place.kind == Kind::Slurm) json["partition"] = place.partition;
  if (place.kind == Kind::Hosts || place.kind == Kind::Slurm) json["folder"] = place.folder;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void RunPlaces::load(const std::string& text) {
  if (text.empty()) return choose({});
  const Json json = Json::parse(text);
  const auto name = json.value("on", std::string());
  const auto* const known = std::ranges::find_if(kKinds, [&](const auto& kind) { return name == kind.second; });
  if (known == kKinds.end())
    throw InputError(FOOTFALL_TEXT("run_on is '%1'; give this_program, processes, hosts or slurm"), name);
  RunPlace place;
  place.kind = known->first;
  place.processes = processesIn(json);
  place.hostFile = json.value("host_file", std::string());
  place.partition = json.value("partition", std::string());
  place.folder = json.value("folder", std::string());
  if (place == chosen_ || mayStartUnasked(place)) return choose(place);
  set({}, place);
}

QString placeText(Kind kind) {
  switch (kind) {
    case Kind::ThisProcess:
      return RunPlaces::tr("This program");
    case Kind::Processes:
      return RunPlaces::tr("Processes of this machine");
    case Kind::Hosts:
      return RunPlaces::tr("Machines of a host file");
    case Kind::Slurm:
      return RunPlaces::tr("Machines of Slurm");
  }
  return {};
}

QString placeText(const RunPlace& place) {
  switch (place.kind) {
    case Kind::ThisProcess:
      break;
    case Kind::Processes:
      return RunPlaces::tr("%n process(es) here", nullptr, place.processes);
    case Kind::Hosts:
      return RunPlaces::tr("%n process(es) of %1", nullptr, place.processes)
          .arg(QFileInfo(QString::fromStdString(place.hostFile)).fileName());
    case Kind::Slurm:
      return place.partition.empty() ? RunPlaces::tr("%n machine(s) of Slurm", nullptr, place.processes)
                                     : RunPlaces::tr("%n machine(s) of %1", nullptr, place.processes)
                                           .arg(QString::fromStdString(place.partition));
  }
  return placeText(place.kind);
}

RunPrograms runPrograms() { return findPrograms(QCoreApplication::applicationDirPath().toStdString()); }

void addPlaceCommands(CommandRegistry& commands, RunPlaces& places, const std::function<void(Kind)>& ask) {
  auto* group = new QActionGroup(&places);
  const auto show = [&places, group] {
    for (QAction* action : group->actions())
      if (action->data().toInt() == static_cast<int>(places.chosen().kind)) action->setChecked(true);
  };
  for (const auto& [kind, name] : kKinds) {
    const bool asks = kind != Kind::ThisProcess;
    Command command{QStringLiteral("pipeline.runOn.%1").arg(QString::fromLatin1(name)),
                    CommandMenu::Pipeline,
                    QStringLiteral("run on"),
                    asks ? placeText(kind) + QStringLiteral("...") : placeText(kind),
                    RunPlaces::tr("Where the cells of a run are computed; the result does not depend on it"),
                    {},
                    {},
                    true};
    QAction* action = commands.add(command, [](bool) {});
    action->setData(static_cast<int>(kind));
    group->addAction(action);
    // The action is connected to triggered(), and not to toggled(), so that the present choice can be changed by
    // choosing it again. Nothing changes until the dialog is accepted.
    QObject::connect(action, &QAction::triggered, &places, [&places, ask, show, kind = kind, asks] {
      if (asks)
        ask(kind);
      else
        places.choose({});
      show();
    });
  }
  QObject::connect(&places, &RunPlaces::changed, group, show);
  show();
}

}  // namespace footfall::ui
