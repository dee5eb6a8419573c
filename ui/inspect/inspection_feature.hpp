// The tools "Why?" and "Components": their panels, and their overlays in the view.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QObject>
#include <QPoint>
#include <QString>

#include "ui/document/document.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/inspect/components_panel.hpp"
#include "ui/inspect/inspection_watch.hpp"
#include "ui/inspect/why_panel.hpp"
#include "ui/inspect/why_tool.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/level/level_file.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/feature_host.hpp"

namespace footfall::ui {

/// A child of its window; found as window.findChild<InspectionFeature*>().
class InspectionFeature : public QObject {
  Q_OBJECT

 public:
  InspectionFeature(const FeatureHost& host, LevelView& view, const Document& document, LevelFile& file,
                    LevelComposer& composer, RunController& controller, FilterList& filters);

  [[nodiscard]] InspectionWatch& watch() { return *watch_; }
  [[nodiscard]] WhyPanel& whyPanel() { return *why_; }
  [[nodiscard]] ComponentsPanel& componentsPanel() { return *components_; }
  /// Explains the place that is visible at a point of the view.
  void ask(const QPoint& place);

 private:
  void createWhy(const FeatureHost& host, RunController& controller);
  void createComponents(const FeatureHost& host);
  void takeUnits();
  void showAnswer();
  void takeAnswerBack();
  void frame(const std::vector<std::uint32_t>& triangles);
  void showFilter();
  [[nodiscard]] const Component* componentAt(std::uint32_t component) const;
  void forgetComponent();
  void frameComponent(std::uint32_t component);

  LevelView& view_;
  const Document& document_;
  LevelComposer& composer_;
  FilterList& filters_;
  StatusLine& status_;
  UnitChoice& units_;
  InspectionWatch* watch_;
  WhyTool tool_;
  WhyPanel* why_ = nullptr;
  QDockWidget* whyDock_ = nullptr;
  ComponentsPanel* components_ = nullptr;
  QDockWidget* componentsDock_ = nullptr;
  QString source_;  ///< source of the environment that the place belongs to
};

}  // namespace footfall::ui
