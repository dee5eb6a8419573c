// The menu of presets: take one, keep the list as one, rename and delete one's own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <functional>

#include "ui/document/document.hpp"
#include "ui/filters/pipeline_presets.hpp"

namespace footfall::ui {

/// Filled each time it is shown, as files may come and go.
class PresetsMenu : public QMenu {
  Q_OBJECT

 public:
  PresetsMenu(Document& document, PresetStore store, QWidget* parent = nullptr);
  void setMetresPerUnit(double metresPerUnit) { metresPerUnit_ = metresPerUnit; }
  /// Asks for a name.
  void saveAs();

 signals:
  void failed(const QString& message);
  /// Something has been done that `undo` takes back.
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
