// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/session_history.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "ui/window/session.hpp"

namespace footfall::ui {
namespace {

using HistoryJson = nlohmann::json;

// A state is written as a session without environment and view.
HistoryJson toJson(const DocumentState& state) {
  Session session;
  for (const FilterEntry& entry : state.filters) session.pipeline.steps.push_back(entry.step);
  session.import = state.import;
  session.agents = state.agents;
  session.agent = state.agent;
  session.partRules = state.partRules;
  session.obstacles = state.obstacles;
  HistoryJson json = HistoryJson::parse(formatSession(session, {}));
  json["rows"] = HistoryJson::array();
  for (const FilterEntry& entry : state.filters) json["rows"].push_back(entry.id);
  return json;
}

DocumentState stateFrom(const HistoryJson& json) {
  Session session = parseSession(json.dump(), {});
  DocumentState state;
  for (std::size_t i = 0; i < session.pipeline.steps.size(); ++i)
    state.filters.push_back({json.at("rows").at(i).get<int>(), session.pipeline.steps[i]});
  state.import = session.import;
  state.agents = std::move(session.agents);
  state.agent = session.agent;
  state.partRules = std::move(session.partRules);
  state.obstacles = std::move(session.obstacles);
  return state;
}

}  // namespace

std::string formatHistory(const EditHistory& history, std::size_t most) {
  const std::size_t dropped =
      history.edits.size() > most
          ? std::min(history.edits.size() - most, static_cast<std::size_t>(std::max(0, history.index)))
          : 0;
  const auto skip = static_cast<int>(dropped);
  HistoryJson json;
  json["index"] = history.index - skip;
  json["clean"] = history.clean - skip;
  json["first"] = toJson(dropped > 0 ? history.edits[dropped - 1].after : history.first);
  json["edits"] = HistoryJson::array();
  for (std::size_t i = dropped; i < history.edits.size(); ++i)
    json["edits"].push_back({{"text", history.edits[i].text.toStdString()}, {"after", toJson(history.edits[i].after)}});
  return json.dump(-1, ' ', false, HistoryJson::error_handler_t::replace);
}

std::optional<EditHistory> parseHistory(const std::string& text) {
  try {
    const HistoryJson json = HistoryJson::parse(text);
    EditHistory history;
    history.first = stateFrom(json.at("first"));
    history.index = json.at("index").get<int>();
    history.clean = json.at("clean").get<int>();
    for (const HistoryJson& edit : json.at("edits"))
      history.edits.push_back(
          {QString::fromStdString(edit.at("text").get<std::string>()), stateFrom(edit.at("after"))});
    if (history.index < 0 || history.index > static_cast<int>(history.edits.size())) return std::nullopt;
    return history;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace footfall::ui
