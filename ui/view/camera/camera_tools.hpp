// The camera's commands, its bookmarks, the axis gizmo, and flying.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QObject>
#include <QString>
#include <map>
#include <string>

#include "ui/view/camera/axis_gizmo.hpp"
#include "ui/view/feature_host.hpp"
#include "ui/view/steering/fly_tool.hpp"
#include "ui/view/widgets/view_layout.hpp"

namespace footfall::ui {

/// A child of its window; found as window.findChild<CameraTools*>(). Bookmarks are kept in sessions as the section
/// "bookmarks".
class CameraTools : public QObject {
  Q_OBJECT

 public:
  static constexpr int kBookmarks = 9;

  struct Bookmark {
    QString name;
    CameraPose pose;
  };

  CameraTools(const FeatureHost& host, LevelView& view, ViewLayout& layout);

  /// Sets whether a person uses the window; only then the camera may glide. Off at first.
  void setInteractive(bool on);
  /// Saves a bookmark. Slots count from 1 to kBookmarks. An empty name becomes "View 3".
  void keepBookmark(int slot, const QString& name = {});
  void recallBookmark(int slot);
  [[nodiscard]] const std::map<int, Bookmark>& bookmarks() const { return bookmarks_; }
  [[nodiscard]] AxisGizmo& gizmo() { return *gizmo_; }
  [[nodiscard]] FlyTool& fly() { return fly_; }

 private:
  void addSides(CommandRegistry& commands);
  void addMoves(const FeatureHost& host);
  void addBookmarks(CommandRegistry& commands);
  void fillMenu();
  void askForName();
  [[nodiscard]] std::string save() const;
  void load(const std::string& text);

  QWidget& window_;  ///< parent of dialogs and keys
  LevelView& view_;
  CameraController& camera_;
  StatusLine& status_;
  UnitChoice& units_;
  SessionSections& sections_;
  FlyTool fly_;
  AxisGizmo* gizmo_;
  QMenu* menu_ = nullptr;
  QAction* smooth_ = nullptr;
  bool interactive_ = false;
  std::map<int, Bookmark> bookmarks_;
};

}  // namespace footfall::ui
