// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/level_look.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "footfall/errors.hpp"

namespace footfall::ui {
namespace {

using Json = nlohmann::ordered_json;
constexpr HeightRange kAll;

Vec3 placed(const std::array<float, 3>& p, const Vec3& centre) {
  return {p[0] + centre.x, p[1] + centre.y, p[2] + centre.z};
}

}  // namespace

LevelLook::LevelLook(EditorWindow& window) : QObject(&window), window_(window), modes_(window) {
  setObjectName(QStringLiteral("levelLook"));
  addLayers();
  addCutPlane();
  addInside();
  const auto takeUnits = [this] {
    layers_->setUnits(window_.units().units());
    cutBar_->setUnits(window_.units().units());
  };
  connect(&window_.units(), &UnitChoice::changed, this, takeUnits);
  takeUnits();
  connect(&modes_, &ViewModes::modeChanged, &window_, &EditorWindow::keepSoon);
  connect(&window_, &EditorWindow::environmentLoaded, this, &LevelLook::takeEnvironment);
  connect(&window_.heightSlider(), &HeightSlider::rangeChanged, &window_, &EditorWindow::keepSoon);
  window_.addSessionSection(
      {QStringLiteral("look"), [this] { return save(); }, [this](const std::string& text) { load(text); }});
}

void LevelLook::addLayers() {
  layers_ = new LayerPanel(&window_);
  window_.addPanel({QStringLiteral("panel.layers"),
                    tr("Layers"),
                    tr("List the layers, hide and show them"),
                    {},
                    QStringLiteral("layers"),
                    Qt::RightDockWidgetArea,
                    false},
                   layers_);
  connect(layers_, &LayerPanel::hiddenChanged, &window_.view(), &LevelView::setHiddenLayers);
  connect(layers_, &LayerPanel::hiddenChanged, &window_, &EditorWindow::keepSoon);
  connect(layers_, &LayerPanel::frameRequested, this, [this](const LayerFigures& layer) {
    const auto geometry = window_.view().environmentGeometry();
    if (geometry) window_.view().frame(placed(layer.lower, geometry->centre), placed(layer.upper, geometry->centre));
  });
  connect(&window_.controller(), &RunController::finished, this, [this] {
    const ViewContent& content = window_.view().content();
    layers_->setResult(content.walkable.empty() ? nullptr : content.walkable.front());
  });
  const QString group = QStringLiteral("floors");
  // Lists and scroll areas have a use of their own for these keys.
  const auto inView = [this](QAction* action) {
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    window_.view().addAction(action);
  };
  inView(window_.commands().add({QStringLiteral("view.nextFloor"),
                                 CommandMenu::View,
                                 group,
                                 tr("Next floor &up"),
                                 tr("Show only the next layer, or the next storey where there are no layers"),
                                 {Qt::Key_PageUp}},
                                [this](bool) { stepFloor(1); }));
  inView(window_.commands().add({QStringLiteral("view.previousFloor"),
                                 CommandMenu::View,
                                 group,
                                 tr("Next floor &down"),
                                 tr("Show only the layer before, or the storey below"),
                                 {Qt::Key_PageDown}},
                                [this](bool) { stepFloor(-1); }));
  window_.commands().add({QStringLiteral("view.allFloors"),
                          CommandMenu::View,
                          group,
                          tr("Show &all floors"),
                          tr("Show all layers and heights again"),
                          {QKeySequence(Qt::SHIFT | Qt::Key_PageUp)}},
                         [this](bool) {
                           layers_->showAll();
                           window_.heightSlider().reset();
                         });
}

void LevelLook::addCutPlane() {
  cutBar_ = new CutBar(window_.view());
  window_.overlays().cutBar = cutBar_;
  QAction* cut = window_.commands().add({QStringLiteral("view.cutPlane"),
                                         CommandMenu::View,
                                         QStringLiteral("floors"),
                                         tr("&Cut plane"),
                                         tr("Cut the view with an upright plane"),
                                         {QKeySequence(Qt::SHIFT | Qt::Key_X)},
                                         QStringLiteral("cut"),
                                         true},
                                        [this](bool on) {
                                          if (window_.environment()) cutBar_->setOn(on);
                                        });
  cut->setEnabled(false);
  connect(&window_, &EditorWindow::environmentLoaded, cut, [cut] { cut->setEnabled(true); });
  connect(cutBar_, &CutBar::changed, this, [this, cut](bool on) {
    cut->setChecked(on);
    window_.placeOverlays();
    window_.keepSoon();
  });
}

void LevelLook::addInside() {
  inside_ = window_.commands().add(
      {QStringLiteral("view.inside"),
       CommandMenu::View,
       QStringLiteral("floors"),
       tr("Look &inside"),
       tr("Leave out faces seen from behind, and roofs and outer walls while one looks down, to see the floors inside"),
       {QKeySequence(Qt::SHIFT | Qt::Key_I)},
       {},
       true},
      [this](bool on) {
        window_.view().setInside(on);
        window_.keepSoon();
      });
  inside_->setChecked(true);
  // Where roofs have been taken away, one is to know, and how to see a single storey.
  connect(&window_, &EditorWindow::environmentLoaded, this, [this] {
    const auto geometry = window_.view().environmentGeometry();
    if (!geometry || !geometry->covered || !window_.view().inside()) {
      hint_->hide();
    } else {
      hint_->tell(tr("Roofs and outer walls are open: %1 closes them.\nThe handles of Height show a single storey.")
                      .arg(inside_->shortcut().toString(QKeySequence::NativeText)));
    }
    window_.placeOverlays();
  });
  // The legend has grown by what the first result has shown.
  connect(&window_, &EditorWindow::environmentLoaded, this, [this] { fresh_ = true; });
  connect(&window_.controller(), &RunController::finished, this, [this] {
    if (std::exchange(fresh_, false)) window_.view().refit();
  });
  hint_ = new ViewHint(QStringLiteral("hints/inside"), &window_.view());
  window_.overlays().hint = hint_;
  connect(inside_, &QAction::toggled, hint_, &QWidget::hide);
  connect(&window_.heightSlider(), &HeightSlider::rangeChanged, hint_, [this](const HeightRange& range) {
    if (range != HeightRange()) hint_->hide();
  });
}

void LevelLook::stepFloor(int direction) {
  if (layers_->layers() > 1) {
    layers_->stepSolo(direction);
    return;
  }
  HeightSlider& heights = window_.heightSlider();
  const auto floors = static_cast<int>(heights.floors().size());
  if (floors == 0) return;
  const std::optional<int> now = heights.shownFloor();
  heights.showFloor(now ? (*now + direction + floors) % floors : direction > 0 ? 0 : floors - 1);
}

void LevelLook::takeEnvironment() {
  const auto geometry = window_.view().environmentGeometry();
  if (!geometry) return;
  HeightSlider& heights = window_.heightSlider();
  const QString source = QString::fromStdString(window_.environment()->source);
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
  const HeightRange& heights = window_.heightSlider().range();
  if (heights.lower > kAll.lower) json["lower"] = heights.lower;
  if (heights.upper < kAll.upper) json["upper"] = heights.upper;
  json["mode"] = nameOf(modes_.mode());
  json["inside"] = inside_->isChecked();
  if (const auto& cut = window_.view().cutPlane()) json["cut"] = {cut->nx, cut->ny, cut->at};
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

void installLevelLook(EditorWindow& window) { new LevelLook(window); }

}  // namespace footfall::ui
