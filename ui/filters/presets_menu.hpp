// The menu of presets: loads a preset, saves the list as one, and renames and deletes the user's own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <functional>

#include "ui/document/document.hpp"
#include "ui/filters/pipeline_presets.hpp"

namespace footfall::ui {

/// The menu is filled each time it is shown, because files may change.
class PresetsMenu : public QMenu {
  Q_OBJECT

 public:
  PresetsMenu(Document& document, PresetStore store, QWidget* parent = nullptr);
  void setMetresPerUnit(double metresPerUnit) { metresPerUnit_ = metresPerUnit; }
  /// Opens a dialog for the name.
  void saveAs();

 signals:
  void failed(const QString& message);
  /// Emitted after an action that `undo` reverses.
  void done(const QString& text, const QString& undoLabel, const std::function<void()>& undo);

 private:
  void fill();
  void guarded(const std::function<void()>& work);
  void askForName(const QString& title, const QString& suggested, const std::function<void(const QString&)>& use);
  void remove(const QString& name);

  Document& document_;
  PresetStore store_;
  double metresPerUnit_ = 1;
};

}  // namespace footfall::ui
