// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/inspection_feature.hpp"

#include <QAction>
#include <QScrollArea>
#include <algorithm>
#include <cmath>

#include "ui/base/widgets/panel_dock.hpp"

namespace footfall::ui {
namespace {

const QString kWhyOverlay = QStringLiteral("why");
const QString kComponentOverlay = QStringLiteral("component");

/// Returns whether a point that was picked on a triangle, in floats, is still near that triangle.
bool isNear(const Vec3& point, const std::array<Vec3, 3>& corners) {
  const auto [x0, x1] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
  const auto [y0, y1] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const auto [z0, z1] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
  const double slack = 1e-3 * ((x1 - x0) + (y1 - y0) + (z1 - z0)) +
                       1e-5 * (std::fabs(point.x) + std::fabs(point.y) + std::fabs(point.z));
  return point.x >= x0 - slack && point.x <= x1 + slack && point.y >= y0 - slack && point.y <= y1 + slack &&
         point.z >= z0 - slack && point.z <= z1 + slack;
}

}  // namespace

InspectionFeature::InspectionFeature(const FeatureHost& host, LevelView& view, const Document& document,
                                     LevelFile& file, LevelComposer& composer, RunController& controller,
                                     FilterList& filters)
    : QObject(&host.window),
      view_(view),
      document_(document),
      composer_(composer),
      filters_(filters),
      status_(host.status),
      units_(host.units),
      watch_(new InspectionWatch(controller, this)),
      tool_([this](const QPoint& place) { ask(place); }, [this] { takeAnswerBack(); }) {
  setObjectName(QStringLiteral("inspection"));
  createWhy(host, controller);
  createComponents(host);
  // While the window is destroyed, its docks are hidden when the objects that they inspect no longer exist.
  connect(&host.commands, &QObject::destroyed, this, [this] {
    for (QDockWidget* dock : {whyDock_, componentsDock_}) dock->toggleViewAction()->disconnect(this);
  });
  connect(&units_, &UnitChoice::changed, this, &InspectionFeature::takeUnits);
  takeUnits();
  connect(watch_, &InspectionWatch::failed, &host.messages, &MessageBar::showError);
  connect(&file, &LevelFile::opened, this, [this, &file] {
    const QString source = QString::fromStdString(file.environment()->source);
    if (source == source_) return;  // the same file again: the place remains
    source_ = source;
    watch_->forget();
    why_->clear();
    takeAnswerBack();
    forgetComponent();
  });
}

void InspectionFeature::createWhy(const FeatureHost& host, RunController& controller) {
  why_ = new WhyPanel;
  whyDock_ = host.panels.add({QStringLiteral("inspect.whyPanel"),
                              tr("Why?"),
                              tr("Show why the last clicked place is walkable or not"),
                              {},
                              QStringLiteral("why")},
                             why_);
  QAction* action = host.tools.add({QStringLiteral("inspect.why"),
                                    CommandMenu::Tools,
                                    QStringLiteral("inspect"),
                                    tr("&Why?"),
                                    tr("Click a place to learn why it is walkable, or what stands in the way"),
                                    {Qt::Key_Y},
                                    QStringLiteral("why")},
                                   &tool_, whyDock_);
  connect(watch_, &InspectionWatch::explained, this, &InspectionFeature::showAnswer);
  connect(&controller, &RunController::started, why_, [this] { why_->setWaiting(true); });
  for (const auto signal : {&RunController::cancelled, &RunController::finished})
    connect(&controller, signal, why_, [this] { why_->setWaiting(watch_->busy()); });
  connect(whyDock_->toggleViewAction(), &QAction::toggled, this, [this, action](bool on) {
    if (on) return;
    action->setChecked(false);
    if (view_.tool() == &tool_) view_.setTool(nullptr);
    takeAnswerBack();
    watch_->forget();
    why_->clear();
  });
  connect(why_, &WhyPanel::framePlaceRequested, this, [this] {
    if (watch_->explanation()) frame({watch_->explanation()->place.triangle});
  });
  connect(why_, &WhyPanel::frameObstacleRequested, this, [this] {
    if (watch_->explanation()) frame(obstaclesOf(*watch_->explanation()));
  });
  connect(why_, &WhyPanel::showFilterRequested, this, &InspectionFeature::showFilter);
}

void InspectionFeature::createComponents(const FeatureHost& host) {
  components_ = new ComponentsPanel;
  componentsDock_ = host.panels.add({QStringLiteral("inspect.components"),
                                     tr("Components"),
                                     tr("List the connected parts of the walkable area by their size"),
                                     {},
                                     QStringLiteral("components")},
                                    components_);
  connect(componentsDock_->toggleViewAction(), &QAction::toggled, this, [this](bool on) {
    watch_->setComponentsWanted(on);
    components_->setInspector(on ? watch_->inspector() : nullptr);
    if (!on) forgetComponent();
  });
  watch_->setComponentsWanted(!componentsDock_->isHidden());
  connect(watch_, &InspectionWatch::inspectorChanged, this, [this] {
    forgetComponent();  // it may be another component now
    components_->setInspector(componentsDock_->isHidden() ? nullptr : watch_->inspector());
  });
  connect(components_, &ComponentsPanel::chosen, this, [this](std::uint32_t component) {
    watch_->showComponent(component);
    if (const Component* chosen = componentAt(component))
      view_.cameraController().setSelectionBounds(kComponentOverlay, SceneBox{chosen->lower, chosen->upper});
  });
  connect(components_, &ComponentsPanel::frameRequested, this, &InspectionFeature::frameComponent);
  connect(watch_, &InspectionWatch::componentShown, this, [this](const ViewOverlay& overlay) {
    if (!componentsDock_->isHidden()) view_.setOverlay(kComponentOverlay, overlay);
  });
}

void InspectionFeature::ask(const QPoint& place) {
  const auto level = composer_.level();
  const std::optional<SurfacePoint> picked = view_.pick(place);
  if (!level || !picked) {
    status_.say(StatusSubject::Tool, tr("Nothing is there; click the level itself."));
    return;
  }
  AskedPlace asked;
  asked.point = picked->point;
  // The view may still show the level before an edit.
  if (picked->triangle < level->triangles.size()) {
    asked.corners = cornersOf(*level, picked->triangle);
    if (isNear(asked.point, asked.corners)) asked.triangle = picked->triangle;
  }
  source_ = QString::fromStdString(level->source);
  bringToFront(*whyDock_);
  why_->setWaiting(true);
  watch_->ask(asked);
  if (!watch_->busy())
    status_.say(StatusSubject::Tool, tr("There is no result yet; the answer follows when a run has finished."));
}

void InspectionFeature::takeUnits() {
  components_->setUnits(units_.units());
  if (watch_->explanation()) showAnswer();
}

void InspectionFeature::showAnswer() {
  const auto& told = watch_->explanation();
  if (!told) {
    why_->clear();
    takeAnswerBack();
    return;
  }
  why_->show(watch_->inspector(), *told, units_.units());
  ViewOverlay overlay = whyOverlay(*watch_->inspector(), *told, units_.units());
  view_.setOverlay(kWhyOverlay, std::move(overlay));
  const auto corners = cornersOf(watch_->inspector()->environment(), told->place.triangle);
  const auto [x0, x1] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
  const auto [y0, y1] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const auto [z0, z1] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
  view_.cameraController().setSelectionBounds(kWhyOverlay, SceneBox{{x0, y0, z0}, {x1, y1, z1}});
}

void InspectionFeature::takeAnswerBack() {
  view_.removeOverlay(kWhyOverlay);
  view_.cameraController().setSelectionBounds(kWhyOverlay, std::nullopt);
}

void InspectionFeature::frame(const std::vector<std::uint32_t>& triangles) {
  const auto inspector = watch_->inspector();
  const auto& told = watch_->explanation();
  if (!inspector || !told || triangles.empty()) return;
  Vec3 lower = told->place.point, upper = lower;
  for (const std::uint32_t t : triangles) {
    for (const Vec3& p : cornersOf(inspector->environment(), t)) {
      lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
      upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
    }
  }
  view_.setOverlay(kWhyOverlay, whyOverlay(*inspector, *told, units_.units()));
  view_.cameraController().frame(lower, upper);
}

void InspectionFeature::showFilter() {
  const auto& told = watch_->explanation();
  if (!told || !told->step) return;
  const PipelineStep& step = watch_->inspector()->pipeline().steps[*told->step];
  const std::vector<FilterEntry>& filters = document_.filters();
  // The list may have been edited since: the filter at the same place is used when it is still the same kind, else the
  // first of that kind.
  const auto sameFilter = [&](const FilterEntry& entry) { return entry.step.filter == step.filter; };
  auto entry = filters.begin() + static_cast<std::ptrdiff_t>(std::min(*told->step, filters.size()));
  if (entry == filters.end() || !sameFilter(*entry)) entry = std::find_if(filters.begin(), filters.end(), sameFilter);
  if (entry == filters.end()) {
    status_.say(StatusSubject::Note, tr("This filter is not in the list any more."));
    return;
  }
  for (FilterRow* row : filters_.rows()) {
    if (row->entryId() != entry->id) continue;
    for (QWidget* parent = row->parentWidget(); parent != nullptr; parent = parent->parentWidget()) {
      if (auto* dock = qobject_cast<QDockWidget*>(parent)) bringToFront(*dock);
      if (auto* scroll = qobject_cast<QScrollArea*>(parent)) scroll->ensureWidgetVisible(row);
    }
    filters_.choose({row->entryId()});
    QWidget* target = entry->step.values.empty() ? row->enabledBox() : row->field(0);
    target->setFocus(Qt::ShortcutFocusReason);
    return;
  }
}

const Component* InspectionFeature::componentAt(std::uint32_t component) const {
  const auto inspector = components_->model().inspector();
  return inspector && component < inspector->components().list.size() ? &inspector->components().list[component]
                                                                      : nullptr;
}

void InspectionFeature::forgetComponent() {
  view_.removeOverlay(kComponentOverlay);
  view_.cameraController().setSelectionBounds(kComponentOverlay, std::nullopt);
}

void InspectionFeature::frameComponent(std::uint32_t component) {
  const Component* const chosen = componentAt(component);
  if (!chosen) return;
  watch_->showComponent(component);
  view_.cameraController().setSelectionBounds(kComponentOverlay, SceneBox{chosen->lower, chosen->upper});
  view_.cameraController().frame(chosen->lower, chosen->upper);
}

}  // namespace footfall::ui
