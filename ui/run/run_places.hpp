// Where runs are computed: what was chosen, for the session to keep.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>
#include <string>

#include "core/distributed/run_place.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

class CommandRegistry;

/// Results do not depend on it. This program at first.
class RunPlaces : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  [[nodiscard]] const RunPlace& chosen() const { return chosen_; }
  void choose(const RunPlace& place);
  /// What a session was run on and nobody has chosen here yet: opening a file neither starts work on other machines nor
  /// more processes than this one has processors.
  [[nodiscard]] const std::optional<RunPlace>& suggested() const { return suggested_; }
  /// Another level is there, which comes with no session: what was chosen here stays.
  void forgetSuggestion();

  /// As JSON, the suggestion where there is one. load() of an empty text is this program; it throws InputError with
  /// what is wrong.
  [[nodiscard]] std::string save() const;
  void load(const std::string& text);

 signals:
  /// The choice or the suggestion.
  void changed();

 private:
  void set(const RunPlace& chosen, const std::optional<RunPlace>& suggested);

  RunPlace chosen_;
  std::optional<RunPlace> suggested_;
};

/// What can be chosen from: "This program", "Processes of this machine", ...
QString placeText(RunPlace::Kind kind);
/// What was chosen, in a few words: "4 processes here".
QString placeText(const RunPlace& place);

/// What starts the processes of runs: beside the editor, or in PATH.
RunPrograms runPrograms();

/// The submenu Run on in the menu Pipeline. `ask` lets the user choose the rest where there is something to choose.
void addPlaceCommands(CommandRegistry& commands, RunPlaces& places, const std::function<void(RunPlace::Kind)>& ask);

}  // namespace footfall::ui
