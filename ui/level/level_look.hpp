// The display of the level: the mode, hidden layers, heights and the cut plane, with their commands and docks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QObject>
#include <QString>
#include <optional>
#include <set>
#include <string>

#include "ui/level/view_modes.hpp"
#include "ui/view/widgets/cut_bar.hpp"
#include "ui/view/widgets/layer_panel.hpp"
#include "ui/view/widgets/view_hint.hpp"

namespace footfall::ui {

/// A child of its window; found as window.findChild<LevelLook*>(). Kept in sessions as the section "look".
class LevelLook : public QObject {
  Q_OBJECT

 public:
  LevelLook(const FeatureHost& host, LevelView& view, ViewLayout& layout, const Document& document, LevelFile& file,
            LevelComposer& composer, RunController& controller);

  [[nodiscard]] LayerPanel& layers() { return *layers_; }
  [[nodiscard]] ViewModes& modes() { return modes_; }
  [[nodiscard]] CutBar& cutBar() { return *cutBar_; }
  /// Called when a level that was opened has its hint about filters, which makes the view lower, or has none.
  void takeNotes();
  /// Returns whether a level that was opened will be framed anew without another run: its hint is not there yet, or
  /// both have just come. A run that is awaited may have been stopped by an edit.
  [[nodiscard]] bool isFraming() const { return isFraming_ && (awaitsNotes_ || !awaitsResult_); }

 private:
  void addLayers(const FeatureHost& host);
  void addCutPlane(CommandRegistry& commands);
  void addInside(CommandRegistry& commands);
  void frameWhileOpening();
  void endFramingSoon();
  void nameLayer();
  void stepFloor(int direction);
  [[nodiscard]] std::string save() const;
  void load(const std::string& text);
  void takeEnvironment();

  LevelView& view_;
  ViewLayout& layout_;
  LevelFile& file_;
  RunController& controller_;
  SessionSections& sections_;
  ViewModes modes_;
  LayerPanel* layers_ = nullptr;
  CutBar* cutBar_ = nullptr;
  QAction* inside_ = nullptr;
  ViewHint* hint_ = nullptr;
  bool isFraming_ = false;
  bool awaitsResult_ = false;  ///< the first run of the opened file has not ended yet
  bool awaitsNotes_ = false;   ///< takeNotes() has not been called for the opened file yet
  QString source_;             ///< the file of the shown level
  /// Settings of a session, until its environment is shown.
  struct Kept {
    std::set<std::uint32_t> hidden;
    HeightRange heights;
    ViewMode mode = ViewMode::Result;
    std::optional<CutPlane> cut;
    bool inside = true;
  };
  std::optional<Kept> pending_;
};

}  // namespace footfall::ui
