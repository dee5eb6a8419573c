// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/obstacle_features.hpp"

#include <QDockWidget>
#include <QEvent>
#include <QKeyEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/base/text/localized_numbers.hpp"
#include "ui/view/camera/sight_lines.hpp"
#include "ui/view/geometry/obstacle_geometry.hpp"
#include "ui/view/overlays/handle_colours.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

using Shape = PlacedObstacle::Shape;

constexpr std::array kShapes{Shape::Box, Shape::Cylinder, Shape::Ramp};
constexpr const char* kSelection = "obstacle.selection";

// The box holds the obstacle at any turn.
SceneBox boundsOf(const PlacedObstacle& o) {
  const double reach = std::hypot(o.size.x, o.size.y) / 2;
  return {{o.base.x - reach, o.base.y - reach, o.base.z}, {o.base.x + reach, o.base.y + reach, o.base.z + o.size.z}};
}

}  // namespace

ObstacleFeatures::ObstacleFeatures(const FeatureHost& host, LevelView& view, Document& document, LevelFile& file,
                                   LevelComposer& composer, RunController& controller)
    : QObject(&host.window),
      view_(view),
      file_(file),
      composer_(composer),
      controller_(controller),
      units_(host.units),
      geometry_(new LevelGeometry(composer, view, this)) {
  followLevel();
  editor_ = new ObstacleEditor(document, composer, controller, this);
  createTools(host);
  createPanel(host);
  createCommands(host.commands);
  connect(editor_, &ObstacleEditor::changed, this, &ObstacleFeatures::showSelection);
  connect(editor_, &ObstacleEditor::changed, this, &ObstacleFeatures::boundSelection);
  connect(&file_, &LevelFile::opened, editor_, [this] { editor_->select(std::nullopt); });
  view_.installEventFilter(this);
}

PlaceObstacleTool& ObstacleFeatures::placeTool(Shape shape) { return *place_[static_cast<std::size_t>(shape)]; }

// The view shows the level that runs compute on, and both number triangles alike. The composer gets results before the
// editor, which then makes the next level from them.
void ObstacleFeatures::followLevel() {
  connect(&file_, &LevelFile::opened, this, [this] { geometry_->follow(); });
  connect(&controller_, &RunController::finished, this,
          [this] { composer_.setComputed(controller_.finishedRun()->environment); });
}

void ObstacleFeatures::createTools(const FeatureHost& host) {
  const ObstacleContext context{view_, composer_, *editor_, [&status = host.status](const QString& text) {
                                  status.say(StatusSubject::Tool, text);
                                }};
  const QString group = QStringLiteral("obstacles");
  select_ = new SelectObstacleTool(context, this);
  host.tools.add({QStringLiteral("obstacle.select"),
                  CommandMenu::Tools,
                  group,
                  tr("&Select and move obstacles"),
                  tr("Select obstacles; move, turn and resize them with handles"),
                  {Qt::Key_V},
                  QStringLiteral("move")},
                 select_);
  const std::array<QString, 3> texts{tr("Place a &box"), tr("Place a &cylinder"), tr("Place a &ramp")};
  const std::array<QString, 3> helps{
      tr("Click where a box is to stand, or draw its base and then its height"),
      tr("Click where a cylinder is to stand, or draw its base and then its height"),
      tr("Click where a ramp is to stand, or draw its base, the way it rises, and then its height")};
  const std::array<QKeySequence, 3> keys{Qt::SHIFT | Qt::Key_B, Qt::SHIFT | Qt::Key_N, Qt::SHIFT | Qt::Key_R};
  for (const Shape shape : kShapes) {
    const auto i = static_cast<std::size_t>(shape);
    auto* tool = new PlaceObstacleTool(shape, context, this);
    place_.push_back(tool);
    constexpr std::array<const char*, 3> kIcons{"obstacle-box", "obstacle-cylinder", "obstacle-ramp"};
    constexpr std::array<const char*, 3> kIds{"obstacle.box", "obstacle.cylinder", "obstacle.ramp"};
    host.tools.add(
        {QLatin1String(kIds[i]), CommandMenu::Tools, group, texts[i], helps[i], {keys[i]}, QLatin1String(kIcons[i])},
        tool);
    connect(tool, &PlaceObstacleTool::placed, this, [this](bool more) {
      if (!more) view_.setTool(select_);
    });
  }
}

void ObstacleFeatures::createPanel(const FeatureHost& host) {
  panel_ = new ObstaclePanel(*editor_, &host.window);
  dock_ = host.panels.add({QStringLiteral("view.obstacles"), tr("Obstacles"),
                           tr("List of placed obstacles, with their places and sizes in numbers")},
                          panel_);
  connect(panel_, &ObstaclePanel::placeRequested, this, [this](Shape shape) {
    if (!composer_.level()) return;
    view_.setTool(&placeTool(shape));
    view_.setFocus();
  });
  connect(panel_, &ObstaclePanel::duplicateRequested, this, &ObstacleFeatures::duplicate);
  connect(panel_, &ObstaclePanel::frameRequested, this, &ObstacleFeatures::frame);
  panel_->setPlacing(false);
  connect(&file_, &LevelFile::opened, panel_, [this] { panel_->setPlacing(true); });
  const auto takeUnits = [this] {
    editor_->setUnits(units_.units());
    panel_->setUnits(units_.units());
  };
  connect(&units_, &UnitChoice::changed, this, takeUnits);
  takeUnits();
  connect(panel_, &ObstaclePanel::stickingChanged, this, [this](bool on) { select_->setSticking(on); });
}

// Their keys work in the view and in the dock only: elsewhere they belong to filters and texts.
void ObstacleFeatures::createCommands(CommandRegistry& commands) {
  const QString group = QStringLiteral("obstacles");
  QAction* copy = commands.add({QStringLiteral("obstacle.duplicate"),
                                CommandMenu::Tools,
                                group,
                                tr("&Duplicate obstacle"),
                                tr("A copy beside the selected obstacle"),
                                {QKeySequence(Qt::CTRL | Qt::Key_D)},
                                QStringLiteral("duplicate")},
                               [this](bool) { duplicate(); });
  QAction* remove = commands.add({QStringLiteral("obstacle.delete"),
                                  CommandMenu::Tools,
                                  group,
                                  tr("D&elete obstacle"),
                                  tr("Take the selected obstacle out of the level"),
                                  {QKeySequence::Delete},
                                  QStringLiteral("remove")},
                                 [this](bool) {
                                   if (const auto* o = editor_->selected()) editor_->remove(o->id);
                                 });
  for (QAction* action : {copy, remove}) {
    action->setShortcutContext(Qt::WidgetShortcut);
    view_.addAction(action);
    panel_->list()->addAction(action);
    // Other tools have marks of their own that Del removes.
    const auto enable = [this, action] {
      const ViewTool* tool = view_.tool();
      action->setEnabled(editor_->selected() && (!tool || tool == select_ || std::ranges::count(place_, tool) > 0));
    };
    connect(editor_, &ObstacleEditor::changed, action, enable);
    connect(&view_, &LevelView::toolChanged, action, enable);
    enable();
  }
}

void ObstacleFeatures::duplicate() {
  const PlacedObstacle* o = editor_->selected();
  if (!o) return;
  const Vec3 beside = placeOn(*o, {o->size.x, 0, 0});
  const double step = editor_->step(false);
  editor_->duplicate(o->id, {roundTo(beside.x - o->base.x, step), roundTo(beside.y - o->base.y, step), 0});
}

// The selected obstacle is highlighted, with or without the tool; during a drag it is drawn at its new place at once.
void ObstacleFeatures::showSelection() {
  const QString name = QLatin1String(kSelection);
  const PlacedObstacle* selected = editor_->selected();
  if (!selected) {
    view_.removeOverlay(name);
    return;
  }
  const ObstacleShape shape = shapeOf(*selected);
  ViewOverlay overlay;
  overlay.throughWalls = true;
  overlay.lines.push_back({shape.edges, highlightColour(), 2, outlineColour()});
  if (editor_->dragging()) {
    QColor fill = highlightColour();
    fill.setAlphaF(0.25F);
    overlay.surfaces.push_back({shape.triangles, fill});
    const LevelUnits& units = units_.units();
    overlay.labels.push_back({placeOn(*selected, {0, 0, selected->size.z}),
                              tr("%1: %2; size %3; %4°")
                                  .arg(QString::fromStdString(selected->name), units.place(selected->base),
                                       units.size(selected->size), shortText(selected->turn))});
  }
  view_.setOverlay(name, std::move(overlay));
}

void ObstacleFeatures::boundSelection() {
  const PlacedObstacle* selected = editor_->selected();
  view_.cameraController().setSelectionBounds(QLatin1String(kSelection),
                                              selected ? std::optional(boundsOf(*selected)) : std::nullopt);
}

void ObstacleFeatures::frame(std::uint32_t id) {
  const PlacedObstacle* o = editor_->find(id);
  if (!o) return;
  const SceneBox bounds = boundsOf(*o);
  view_.cameraController().frame(bounds.lower, bounds.upper);
}

bool ObstacleFeatures::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && view_.tool()) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool nudges =
        view_.tool() == select_ && editor_->selected() && (key == Qt::Key_PageUp || key == Qt::Key_PageDown);
    if (key == Qt::Key_Escape || nudges) {
      event->accept();
      return true;
    }
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace footfall::ui
