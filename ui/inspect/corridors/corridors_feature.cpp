// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/corridors/corridors_feature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "ui/base/look/core_colours.hpp"
#include "ui/base/widgets/panel_dock.hpp"
#include "ui/inspect/corridors/corridor_colours.hpp"
#include "ui/inspect/corridors/dimension_line.hpp"
#include "ui/run/without_radius.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

const QString kMapOverlay = QStringLiteral("corridors");
const QString kBottlenecksOverlay = QStringLiteral("bottlenecks");
const QString kChosenOverlay = QStringLiteral("bottleneck");
constexpr double kUsualAgentWidth = 0.6;  // metres: a person, shoulder to shoulder
constexpr double kShownAround = 1.5;      // metres around a bottleneck that is brought into sight
constexpr int kMostDimensions = 2000;     // bottlenecks that are drawn: overlays are sent with every frame
constexpr float kMapPixels = 3, kNarrowPixels = 1.5F, kDimensionPixels = 2;

Passage passageOf(const Bottleneck& b) { return {b.place, b.left, b.right, b.width}; }

}  // namespace

CorridorsFeature::CorridorsFeature(const FeatureHost& host, LevelView& view, LevelFile& file, RunController& controller)
    : QObject(&host.window),
      view_(view),
      file_(file),
      controller_(controller),
      units_(host.units),
      watch_(new CorridorWatch(controller, this)),
      panel_(new CorridorsPanel) {
  setObjectName(QStringLiteral("corridors"));
  dock_ = host.panels.add({QStringLiteral("panel.corridors"),
                           tr("Corridors"),
                           tr("Show how wide every passage is, and list the bottlenecks"),
                           {},
                           {},
                           Qt::RightDockWidgetArea,
                           false},
                          panel_);
  connectPanel(host);
  connect(watch_, &CorridorWatch::changed, this, &CorridorsFeature::show);
  connect(watch_, &CorridorWatch::failed, &host.messages, &MessageBar::showError);
  connect(&controller_, &RunController::finished, this, &CorridorsFeature::takeUsualWidth);
  connect(&file_, &LevelFile::opened, this, &CorridorsFeature::takeLevel);
  const auto takeUnits = [this] {
    panel_->setUnits(units_.units());
    drawBottlenecks();
  };
  connect(&units_, &UnitChoice::changed, this, takeUnits);
  takeUnits();
  host.sections.add(
      {QStringLiteral("corridors"), [this] { return save(); }, [this](const std::string& text) { load(text); }});
  follow();
}

void CorridorsFeature::connectPanel(const FeatureHost& host) {
  // A dock behind another one is not hidden, and its map stays in sight.
  connect(dock_->toggleViewAction(), &QAction::toggled, this, &CorridorsFeature::follow);
  connect(dock_->toggleViewAction(), &QAction::toggled, &host.sections, &SessionSections::changed);
  // While the window is destroyed, its docks are hidden when the view no longer exists.
  connect(&host.commands, &QObject::destroyed, this, [this] { dock_->toggleViewAction()->disconnect(this); });
  for (const auto draw : {&CorridorsFeature::drawMap, &CorridorsFeature::drawBottlenecks})
    connect(panel_, &CorridorsPanel::agentWidthChanged, this, draw);
  connect(panel_, &CorridorsPanel::agentWidthEdited, this, [this] { isWidthGiven_ = true; });
  connect(panel_, &CorridorsPanel::agentWidthEdited, &host.sections, &SessionSections::changed);
  connect(panel_, &CorridorsPanel::mapToggled, this, &CorridorsFeature::drawMap);
  for (const auto toggled : {&CorridorsPanel::mapToggled, &CorridorsPanel::onlyWaysToggled})
    connect(panel_, toggled, &host.sections, &SessionSections::changed);
  connect(panel_, &CorridorsPanel::chosen, this, &CorridorsFeature::choose);
  connect(panel_, &CorridorsPanel::frameRequested, this, &CorridorsFeature::frame);
}

void CorridorsFeature::follow() {
  watch_->setWanted(!dock_->isHidden());
  show();
}

void CorridorsFeature::takeLevel() {
  const std::string source = file_.environment() ? file_.environment()->source : std::string();
  if (!std::exchange(fromSession_, false) && source != environment_) isWidthGiven_ = false;
  environment_ = source;
  takeUsualWidth();
}

void CorridorsFeature::takeUsualWidth() {
  if (isWidthGiven_) return;
  const auto run = controller_.finishedRun();
  const double width = run ? 2 * radiusOf(run->pipeline) : 0;
  const double metres = file_.environment() ? file_.environment()->metresPerUnit : 1;
  panel_->setAgentWidth(width > 0 ? width : kUsualAgentWidth / metres);
}

QString CorridorsFeature::noteOf() const {
  if (!file_.environment()) return tr("Open an environment first.");
  if (watch_->isBusy()) return tr("Making the corridor map …");
  if (watch_->shown()) return {};
  return controller_.finishedRun() && !controller_.busy() ? QString()
                                                          : tr("The corridors follow when a run has finished.");
}

void CorridorsFeature::show() {
  panel_->show(watch_->shown(), noteOf());
  panel_->setWaiting(watch_->shown() && (watch_->isBusy() || controller_.busy()));
  drawMap();
  drawBottlenecks();
}

void CorridorsFeature::drawMap() {
  const auto& shown = watch_->shown();
  if (!shown || dock_->isHidden() || !panel_->isMapShown()) {
    view_.removeOverlay(kMapOverlay);
    return;
  }
  // Gaps between furniture are many, and nobody goes there: their lines are thin.
  std::array<ViewOverlay::Lines, kWidthColours> colours;
  for (std::size_t i = 0; i < kWidthColours; ++i) {
    colours.at(i).colour = widthColour(i);
    colours.at(i).width = i == 0 ? kNarrowPixels : kMapPixels;
    if (i > 0) colours.at(i).rim = outlineColour();
  }
  for (const CorridorLine& line : shown->lines.lines)
    colours.at(colourNumberOf(line.width, panel_->agentWidth())).segments.push_back(line.ends);
  ViewOverlay overlay;
  // The narrow ones are drawn last, over the others.
  for (auto lines = colours.rbegin(); lines != colours.rend(); ++lines)
    if (!lines->segments.empty()) overlay.lines.push_back(std::move(*lines));
  view_.setOverlay(kMapOverlay, std::move(overlay));
}

void CorridorsFeature::drawBottlenecks() {
  const BottleneckModel& model = panel_->model();
  if (dock_->isHidden() || model.rowCount() == 0) {
    view_.removeOverlay(kBottlenecksOverlay);
    view_.removeOverlay(kChosenOverlay);
    view_.cameraController().setSelectionBounds(kChosenOverlay, std::nullopt);
    return;
  }
  ViewOverlay overlay;
  ViewOverlay::Lines narrow{{}, widthColour(0), kDimensionPixels, {}};
  ViewOverlay::Lines wide{{}, QColor(Qt::white), kDimensionPixels, outlineColour()};
  // Where it is wide, a line across would only be in the way.
  const double widest = kWidthLimits.back() * panel_->agentWidth();
  for (int row = 0; row < std::min(model.rowCount(), kMostDimensions); ++row) {
    const Bottleneck& b = *model.bottleneckOf(row);
    if (b.width > widest) break;
    if (row != chosen_) (b.width < panel_->agentWidth() ? narrow : wide).segments.push_back({b.left, b.right});
  }
  if (!wide.segments.empty()) overlay.lines.push_back(std::move(wide));
  if (!narrow.segments.empty()) overlay.lines.push_back(std::move(narrow));
  view_.setOverlay(kBottlenecksOverlay, std::move(overlay));
  drawChosen();
}

// Visible through walls and through the floors above it.
void CorridorsFeature::drawChosen() {
  const Bottleneck* chosen = panel_->model().bottleneckOf(chosen_);
  if (!chosen) return view_.removeOverlay(kChosenOverlay);
  const bool isTooNarrow = chosen->width < panel_->agentWidth();
  const QColor colour = isTooNarrow ? widthColour(0) : toColour(kYellow);
  ViewOverlay overlay;
  overlay.throughWalls = true;
  const QString width = units_.units().length(chosen->width);
  addDimension(overlay, passageOf(*chosen), colour, isTooNarrow ? tr("%1, too narrow").arg(width) : width);
  view_.setOverlay(kChosenOverlay, std::move(overlay));
}

void CorridorsFeature::choose(int row) {
  chosen_ = row;
  drawBottlenecks();
  const Bottleneck* chosen = panel_->model().bottleneckOf(row);
  const double metres = file_.environment() ? file_.environment()->metresPerUnit : 1;
  view_.cameraController().setSelectionBounds(
      kChosenOverlay, chosen ? std::optional(boxAround(passageOf(*chosen), kShownAround / metres)) : std::nullopt);
}

void CorridorsFeature::frame(int row) {
  choose(row);
  const Bottleneck* chosen = panel_->model().bottleneckOf(row);
  if (!chosen) return;
  const SceneBox box = boxAround(passageOf(*chosen), kShownAround / file_.environment()->metresPerUnit);
  view_.cameraController().frame(box.lower, box.upper);
}

std::string CorridorsFeature::save() const {
  nlohmann::json json;
  json["shown"] = !dock_->isHidden();
  json["map"] = panel_->isMapShown();
  json["onlyWays"] = panel_->hasOnlyWays();
  if (isWidthGiven_) json["agentWidth"] = panel_->agentWidth();
  return json.dump();
}

void CorridorsFeature::load(const std::string& text) {
  fromSession_ = true;
  isWidthGiven_ = false;
  if (text.empty()) return;
  const nlohmann::json json = nlohmann::json::parse(text);
  if (const auto width = json.find("agentWidth"); width != json.end()) {
    const auto number = width->get<double>();
    if (!(number > 0 && std::isfinite(number))) throw std::runtime_error("an agent's width that is not above 0");
    isWidthGiven_ = true;
    panel_->setAgentWidth(number);
  }
  panel_->setMapShown(json.value("map", true));
  panel_->setOnlyWays(json.value("onlyWays", false));
  dock_->setVisible(json.value("shown", false));
  if (!dock_->isHidden()) bringToFront(*dock_);
}

}  // namespace footfall::ui
