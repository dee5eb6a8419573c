// The chosen place to run, which sessions save.
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

/// Results do not depend on the place. It is this program at first.
class RunPlaces : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  [[nodiscard]] const RunPlace& chosen() const { return chosen_; }
  void choose(const RunPlace& place);
  /// The place of a session that the user has not chosen yet. Opening a file starts neither work on other machines nor
  /// more processes than this machine has processors.
  [[nodiscard]] const std::optional<RunPlace>& suggested() const { return suggested_; }
  /// Called when a level without a session is opened; a choice of the user stays.
  void forgetSuggestion();

  /// The place as JSON, preferably the suggestion. load() of an empty text chooses this program; it throws InputError
  /// for an invalid text.
  [[nodiscard]] std::string save() const;
  void load(const std::string& text);

 signals:
  /// Emitted when the choice or the suggestion changed.
  void changed();

 private:
  void set(const RunPlace& chosen, const std::optional<RunPlace>& suggested);

  RunPlace chosen_;
  std::optional<RunPlace> suggested_;
};

/// The name of a choice: "This program", "Processes of this machine", ...
QString placeText(RunPlace::Kind kind);
/// The chosen place in a few words: "4 processes here".
QString placeText(const RunPlace& place);

/// The program that starts the processes of runs: beside the editor, or in PATH.
RunPrograms runPrograms();

/// Adds the submenu Run on to the menu Pipeline. `ask` opens a dialog for the other settings of a place that has some.
void addPlaceCommands(CommandRegistry& commands, RunPlaces& places, const std::function<void(RunPlace::Kind)>& ask);

}  // namespace footfall::ui
