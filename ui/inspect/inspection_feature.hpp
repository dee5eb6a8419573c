// Puts the questions "why?" and "which components?" into the window.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QObject>
#include <QPoint>
#include <QString>

#include "ui/inspect/components_panel.hpp"
#include "ui/inspect/inspection_watch.hpp"
#include "ui/inspect/why_panel.hpp"
#include "ui/inspect/why_tool.hpp"

namespace footfall::ui {

class EditorWindow;

class InspectionFeature : public QObject {
  Q_OBJECT

 public:
  /// Belongs to the window.
  explicit InspectionFeature(EditorWindow& window);

  [[nodiscard]] InspectionWatch& watch() { return *watch_; }
  [[nodiscard]] WhyPanel& whyPanel() { return *why_; }
  [[nodiscard]] ComponentsPanel& componentsPanel() { return *components_; }
  /// Asks about what is seen at a place of the view.
  void ask(const QPoint& place);

 private:
  void createWhy();
  void createComponents();
  void takeUnits();
  void showAnswer();
  void takeAnswerBack();
  void frame(const std::vector<std::uint32_t>& triangles);
  void showFilter();
  [[nodiscard]] const Component* componentAt(std::uint32_t component) const;
  void forgetComponent();
  void frameComponent(std::uint32_t component);

  EditorWindow& window_;
  InspectionWatch* watch_;
  WhyTool tool_;
  WhyPanel* why_ = nullptr;
  QDockWidget* whyDock_ = nullptr;
  ComponentsPanel* components_ = nullptr;
  QDockWidget* componentsDock_ = nullptr;
  QString source_;  ///< of the environment that the place belongs to
};

}  // namespace footfall::ui
