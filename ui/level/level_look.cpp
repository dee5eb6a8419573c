// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/level_look.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "footfall/errors.hpp"
#include "ui/level/layer_bounds.hpp"

namespace footfall::ui {
namespace {

using Json = nlohmann::ordered_json;
constexpr HeightRange kAll;

Vec3 placed(const std::array<float, 3>& p, const Vec3& centre) {
  return {p[0] + centre.x, p[1] + centre.y, p[2] + centre.z};
}

}  // namespace

LevelLook::LevelLook(const FeatureHost& host, LevelView& view, ViewLayout& layout, const Document& document,
                     LevelFile& file, LevelComposer& composer, RunController& controller)
    : QObject(&host.window),
      view_(view),
      layout_(layout),
      file_(file),
      controller_(controller),
      sections_(host.sections),
      modes_(host, view, layout, document, file, composer, controller) {
  setObjectName(QStringLiteral("levelLook"));
  addLayers(host);
  addCutPlane(host.commands);
  addInside(host.commands);
  frameWhileOpening();
  const auto takeUnits = [this, &units = host.units] {
    layers_->setUnits(units.units());
    cutBar_->setUnits(units.units());
  };
  connect(&host.units, &UnitChoice::changed, this, takeUnits);
  takeUnits();
  connect(&modes_, &ViewModes::modeChanged, &sections_, &SessionSections::changed);
  connect(&file_, &LevelFile::opened, this, &LevelLook::takeEnvironment);
  connect(&layout_.heights(), &HeightSlider::rangeChanged, &sections_, &SessionSections::changed);
  sections_.add({QStringLiteral("look"), [this] { return save(); }, [this](const std::string& text) { load(text); }});
}

void LevelLook::addLayers(const FeatureHost& host) {
  layers_ = new LayerPanel(&host.window);
  host.panels.add({QStringLiteral("panel.layers"),
                   tr("Layers"),
                   tr("List the layers, hide and show them"),
                   {},
                   QStringLiteral("layers"),
                   Qt::RightDockWidgetArea,
                   false},
                  layers_);
  connect(layers_, &LayerPanel::hiddenChanged, &view_, &LevelView::setHiddenLayers);
  connect(layers_, &LayerPanel::hiddenChanged, &sections_, &SessionSections::changed);
  connect(layers_, &LayerPanel::hiddenChanged, this, &LevelLook::nameLayer);
  connect(layers_, &LayerPanel::frameRequested, this, [this](const LayerFigures& layer) {
    const auto geometry = view_.environmentGeometry();
    if (geometry)
      view_.cameraController().frame(placed(layer.lower, geometry->centre), placed(layer.upper, geometry->centre));
  });
  connect(&controller_, &RunController::finished, this, [this] {
    const ViewContent& content = view_.content();
    layers_->setResult(content.walkable.empty() ? nullptr : content.walkable.front());
    nameLayer();
  });
  new LayerBounds(controller_, *layers_);
  const QString group = QStringLiteral("floors");
  // Lists and scroll areas use these keys themselves.
  const auto inView = [this](QAction* action) {
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    view_.addAction(action);
  };
  inView(host.commands.add({QStringLiteral("view.nextFloor"),
                            CommandMenu::View,
                            group,
                            tr("Next floor &up"),
                            tr("Show only the next layer, or the next storey where there are no layers"),
                            {Qt::Key_PageUp}},
                           [this](bool) { stepFloor(1); }));
  inView(host.commands.add({QStringLiteral("view.previousFloor"),
                            CommandMenu::View,
                            group,
                            tr("Next floor &down"),
                            tr("Show only the layer before, or the storey below"),
                            {Qt::Key_PageDown}},
                           [this](bool) { stepFloor(-1); }));
  host.commands.add({QStringLiteral("view.allFloors"),
                     CommandMenu::View,
                     group,
                     tr("Show &all floors"),
                     tr("Show all layers and heights again"),
                     {QKeySequence(Qt::SHIFT | Qt::Key_PageUp)}},
                    [this](bool) {
                      layers_->showAll();
                      layout_.heights().reset();
                    });
}

// The view shows the number of a layer that is shown alone.
void LevelLook::nameLayer() {
  const QString overlay = QStringLiteral("layer");
  const std::optional<std::uint32_t> layer = layers_->soloLayer();
  const LayerFigures* figures = layer ? layers_->figuresOf(*layer) : nullptr;
  const auto geometry = view_.environmentGeometry();
  if (!figures || !geometry) return view_.removeOverlay(overlay);
  const Vec3 lower = placed(figures->lower, geometry->centre), upper = placed(figures->upper, geometry->centre);
  ViewOverlay label;
  label.labels.push_back({{(lower.x + upper.x) / 2, (lower.y + upper.y) / 2, upper.z},
                          tr("Layer %1 of %2").arg(*layer).arg(layers_->layers())});
  view_.setOverlay(overlay, std::move(label));
}

void LevelLook::addCutPlane(CommandRegistry& commands) {
  cutBar_ = new CutBar(view_);
  layout_.setCutBar(cutBar_);
  QAction* cut = commands.add({QStringLiteral("view.cutPlane"),
                               CommandMenu::View,
                               QStringLiteral("floors"),
                               tr("&Cut plane"),
                               tr("Cut the view with an upright plane"),
                               {QKeySequence(Qt::SHIFT | Qt::Key_X)},
                               QStringLiteral("cut"),
                               true},
                              [this](bool on) {
                                if (file_.environment()) cutBar_->setOn(on);
                              });
  cut->setEnabled(false);
  connect(&file_, &LevelFile::opened, cut, [cut] { cut->setEnabled(true); });
  connect(cutBar_, &CutBar::changed, this, [this, cut](bool on) {
    cut->setChecked(on);
    layout_.update();
    emit sections_.changed();
  });
}

void LevelLook::addInside(CommandRegistry& commands) {
  inside_ = commands.add({QStringLiteral("view.inside"),
                          CommandMenu::View,
                          QStringLiteral("floors"),
                          tr("Look &inside"),
                          tr("Hide faces seen from behind, and roofs and outer walls while the camera looks down, to "
                             "show the floors inside"),
                          {QKeySequence(Qt::SHIFT | Qt::Key_I)},
                          {},
                          true},
                         [this](bool on) {
                           view_.setInside(on);
                           emit sections_.changed();
                         });
  inside_->setChecked(true);
  // Where roofs have been hidden, a hint explains it, and how to show a single storey.
  connect(&file_, &LevelFile::opened, this, [this] {
    const auto geometry = view_.environmentGeometry();
    if (!geometry || !geometry->covered || !view_.inside()) {
      hint_->hide();
    } else {
      hint_->showOnce(tr("Roofs and outer walls are open: %1 closes them.\nThe handles of Height show a single storey.")
                          .arg(inside_->shortcut().toString(QKeySequence::NativeText)));
    }
    layout_.update();
  });
  hint_ = new ViewHint(QStringLiteral("hints/inside"), &view_);
  layout_.setHint(hint_);
  connect(inside_, &QAction::toggled, hint_, &QWidget::hide);
  // The hint is removed once the user has begun to work, because it takes up room.
  connect(&view_, &LevelView::toolChanged, hint_, [this] {
    if (view_.tool()) hint_->hide();
  });
  connect(&layout_.heights(), &HeightSlider::rangeChanged, hint_, [this](const HeightRange& range) {
    if (range != HeightRange()) hint_->hide();
  });
}

// The first result makes the legend larger, and a hint about filters makes the view lower. Their order is up to two
// threads, so the level is framed until both are there.
void LevelLook::frameWhileOpening() {
  connect(&file_, &LevelFile::opened, this, [this] {
    isFraming_ = awaitsNotes_ = true;
    awaitsResult_ = controller_.busy();  // a list that cannot run has failed by now
  });
  const auto takeResult = [this] {
    awaitsResult_ = false;
    endFramingSoon();
  };
  connect(&controller_, &RunController::finished, this, takeResult);
  connect(&controller_, &RunController::cancelled, this, takeResult);
  connect(&controller_, &RunController::failed, this, takeResult);
}

void LevelLook::takeNotes() {
  awaitsNotes_ = false;
  endFramingSoon();
}

// Layouts change the view's size after the present event.
void LevelLook::endFramingSoon() {
  if (!isFraming_ || awaitsResult_ || awaitsNotes_) return;
  const auto end = [this] {
    if (awaitsResult_ || awaitsNotes_) return;
    isFraming_ = false;
    view_.cameraController().endFraming();
  };
  QMetaObject::invokeMethod(this, end, Qt::QueuedConnection);
}

void LevelLook::stepFloor(int direction) {
  if (layers_->layers() > 1) {
    layers_->stepSolo(direction);
    return;
  }
  HeightSlider& heights = layout_.heights();
  const auto floors = static_cast<int>(heights.floors().size());
  if (floors == 0) return;
  const std::optional<int> now = heights.shownFloor();
  heights.showFloor(now ? (*now + direction + floors) % floors : direction > 0 ? 0 : floors - 1);
}

void LevelLook::takeEnvironment() {
  const auto geometry = view_.environmentGeometry();
  if (!geometry) return;
  HeightSlider& heights = layout_.heights();
  const QString source = QString::fromStdString(file_.environment()->source);
  const bool other = source != source_;
  source_ = source;
  const HeightRange before = heights.range();
  const double z = geometry->centre.z;
  std::vector<double> floors = geometry->floors;
  for (double& floor : floors) floor += z;
  heights.setLevel(geometry->lower.z + z, geometry->upper.z + z, floors);
  if (other) layers_->setResult(nullptr);
  if (pending_) {
    modes_.setMode(pending_->mode);
    cutBar_->setPlane(pending_->cut);
    inside_->setChecked(pending_->inside);
    layers_->setHidden(pending_->hidden);
    heights.setRange(pending_->heights);
    pending_.reset();
  } else if (other) {
    layers_->showAll();
    cutBar_->setPlane(std::nullopt);
    inside_->setChecked(true);
  } else {
    heights.setRange(before);  // the same file, read again
  }
}

std::string LevelLook::save() const {
  Json json;
  json["hidden_layers"] = layers_->hidden();
  const HeightRange& heights = layout_.heights().range();
  if (heights.lower > kAll.lower) json["lower"] = heights.lower;
  if (heights.upper < kAll.upper) json["upper"] = heights.upper;
  json["mode"] = nameOf(modes_.mode());
  json["inside"] = inside_->isChecked();
  if (const auto& cut = view_.cutPlane()) json["cut"] = {cut->nx, cut->ny, cut->at};
  return json.dump();
}

void LevelLook::load(const std::string& text) {
  pending_.emplace();
  if (text.empty()) return;
  try {
    const Json json = Json::parse(text);
    Kept kept;
    kept.hidden = json.value("hidden_layers", kept.hidden);
    kept.heights.lower = json.value("lower", kAll.lower);
    kept.heights.upper = json.value("upper", kAll.upper);
    const auto mode = json.value("mode", std::string(nameOf(kept.mode)));
    if (!viewModeFrom(mode)) throw InputError(FOOTFALL_TEXT("there is no view mode '%1'"), mode);
    kept.mode = *viewModeFrom(mode);
    kept.inside = json.value("inside", kept.inside);
    if (json.contains("cut")) {
      const auto cut = json.at("cut").get<std::array<double, 3>>();
      const double norm = std::hypot(cut[0], cut[1]);
      if (!(norm > 0.99 && norm < 1.01)) throw InputError(FOOTFALL_TEXT("the cut plane has no direction"));
      kept.cut = CutPlane{cut[0], cut[1], cut[2]};
    }
    pending_ = kept;
  } catch (const Json::exception&) {
    throw InputError(FOOTFALL_TEXT("something is missing or of the wrong type"));
  }
}

}  // namespace footfall::ui
