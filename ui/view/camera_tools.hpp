// The camera's commands, its bookmarks, the gizmo with the axes, and flying.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QObject>
#include <QString>
#include <map>
#include <string>

#include "ui/view/axis_gizmo.hpp"
#include "ui/view/fly_tool.hpp"
#include "ui/window/editor_window.hpp"

namespace footfall::ui {

/// Lives as long as the window. Bookmarks are kept in sessions as the section "bookmarks".
class CameraTools : public QObject {
  Q_OBJECT

 public:
  static constexpr int kBookmarks = 9;

  struct Bookmark {
    QString name;
    CameraPose pose;
  };

  explicit CameraTools(EditorWindow& window);

  /// Slots count from 1 to kBookmarks. An empty name: "View 3".
  void keepBookmark(int slot, const QString& name = {});
  void recallBookmark(int slot);
  [[nodiscard]] const std::map<int, Bookmark>& bookmarks() const { return bookmarks_; }
  [[nodiscard]] AxisGizmo& gizmo() { return *gizmo_; }
  [[nodiscard]] FlyTool& fly() { return fly_; }

 private:
  void addSides();
  void addMoves();
  void addBookmarks();
  void fillMenu();
  void askForName();
  [[nodiscard]] std::string save() const;
  void load(const std::string& text);

  EditorWindow& window_;
  FlyTool fly_;
  AxisGizmo* gizmo_;
  QMenu* menu_ = nullptr;
  std::map<int, Bookmark> bookmarks_;
};

/// For EditorWindow::createFeatures().
void installCameraTools(EditorWindow& window);

}  // namespace footfall::ui
