// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/path_feature.hpp"

#include <QDockWidget>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "footfall/path.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/run/without_radius.hpp"

namespace footfall::ui {

// The names of the walker's cameras in sessions.
NLOHMANN_JSON_SERIALIZE_ENUM(WalkCamera, {{WalkCamera::Free, "stays"},
                                          {WalkCamera::Follows, "follows"},
                                          {WalkCamera::Eyes, "eyes"}})

// The names of the ways of a body.
NLOHMANN_JSON_SERIALIZE_ENUM(BodyWay, {{BodyWay::Shortest, "shortest"},
                                       {BodyWay::PrefersWide, "prefers_wide"},
                                       {BodyWay::Widest, "widest"}})

namespace {

using Json = nlohmann::json;

constexpr double kShownAroundLinks = 1.5;  // metres shown around the barrier between two parts

Json toJson(const std::optional<Vec3>& place) { return place ? Json{place->x, place->y, place->z} : Json(nullptr); }

std::optional<Vec3> toPlace(const Json& json) {
  if (json.is_null()) return std::nullopt;
  const auto numbers = json.get<std::array<double, 3>>();
  for (const double x : numbers)
    if (!std::isfinite(x)) throw std::runtime_error("a place that is not finite");
  return Vec3{numbers[0], numbers[1], numbers[2]};
}

}  // namespace

PathFeature::PathFeature(const FeatureHost& host, LevelView& view, Document& document, LevelFile& file,
                         RunController& controller)
    : QObject(&host.window),
      view_(view),
      file_(file),
      controller_(controller),
      tool_(model_, view, nullptr),
      panel_(new PathPanel(model_)),
      passage_(new PassageView(model_, view, panel_)),
      separation_(new SeparationView(model_, view, panel_)),
      walk_(new WalkFeature(host, view, model_, this)) {
  panel_->addButton(passage_);
  panel_->addBelowFailure(separation_);
  panel_->addBelowText(walk_->bar());
  separation_->setMends(
      [&document](const Separation& separation) { return mendOf(separation, document.filters(), document.units()); });
  connect(separation_, &SeparationView::mendRequested, this,
          [&document](const SeparationMend& mend) { document.setValue(mend.filter, mend.parameter, mend.value, -1); });
  connect(&document, &Document::filtersChanged, separation_, &SeparationView::refreshMend);
  dock_ = host.panels.add({QStringLiteral("panel.path"),
                           tr("Try it"),
                           tr("Enter two places and see the shortest path between them"),
                           {},
                           {},
                           Qt::RightDockWidgetArea,
                           false},
                          panel_);
  host.tools.add({QStringLiteral("tools.path"),
                  CommandMenu::Tools,
                  QStringLiteral("tools"),
                  tr("&Try it"),
                  tr("Click two places and see the shortest path between them"),
                  {Qt::Key_P},
                  QStringLiteral("path")},
                 &tool_, dock_);
  connect(&view_, &LevelView::toolChanged, this, &PathFeature::follow);
  connect(dock_, &QDockWidget::visibilityChanged, this, &PathFeature::follow);
  connect(&tool_, &PathTool::hintChanged, this, [this, &status = host.status](const QString& hint) {
    if (view_.tool() == &tool_) status.say(StatusSubject::Tool, hint);
  });
  const auto takeUnits = [this, &choice = host.units] {
    const LevelUnits units = choice.units();
    panel_->setUnits(units);
    tool_.setUnits(units);
    passage_->setUnits(units);
    separation_->setWriter({[units](double length) { return units.length(length); },
                            [units](const Vec3& place) { return units.place(place); }});
  };
  connect(&host.units, &UnitChoice::changed, this, takeUnits);
  takeUnits();
  connect(&controller_, &RunController::finished, this, &PathFeature::takeResult);
  connect(&file_, &LevelFile::opened, this, [this] {
    const std::string source = file_.environment() ? file_.environment()->source : std::string();
    if (!std::exchange(fromSession_, false) && source != environment_) {
      model_.setPlaces(std::nullopt, std::nullopt);
      model_.setBody({});
    }
    environment_ = source;
    takeResult();
  });
  connectModel(host);
  host.sections.add(
      {QStringLiteral("path"), [this] { return save(); }, [this](const std::string& text) { load(text); }});
  takeResult();
}

void PathFeature::connectModel(const FeatureHost& host) {
  connect(&model_, &PathModel::placesChanged, &host.sections, &SessionSections::changed);
  connect(&model_, &PathModel::bodyChanged, &host.sections, &SessionSections::changed);
  connect(&model_, &PathModel::bodyChanged, this, &PathFeature::takeBody);
  connect(&model_, &PathModel::resultChanged, this, &PathFeature::boundSelection);
  connect(panel_, &PathPanel::speedEdited, &host.sections, &SessionSections::changed);
  connect(walk_->bar(), &WalkBar::chosen, &host.sections, &SessionSections::changed);
  connect(panel_, &PathPanel::speedEdited, this, [this] { walk_->setSpeed(panel_->speed()); });
  connect(&tool_, &PathTool::playRequested, &walk_->walker(),
          [this] { walk_->walker().setPlaying(!walk_->walker().isPlaying()); });
  connect(&model_, &PathModel::failed, this,
          [&messages = host.messages](const QString& text) { messages.showErrorOf(MessageSubject::Path, text); });
  connect(&model_, &PathModel::resultChanged, this,
          [&messages = host.messages] { messages.finish(MessageSubject::Path); });
}

void PathFeature::follow() {
  const bool shown = view_.tool() == &tool_ || !dock_->isHidden();
  tool_.setShown(shown);
  passage_->setShown(shown);
  separation_->setShown(shown);
  walk_->setShown(shown);
  model_.setActive(shown);
  boundSelection();
}

void PathFeature::takeResult() {
  const auto run = controller_.finishedRun();
  const double metres = file_.environment() ? file_.environment()->metresPerUnit : 1;
  if (run) {
    const PathModel::Ground ground{run->result.mesh,
                                   placeReach(run->pipeline),
                                   run->environment,
                                   agentHeight(run->pipeline, run->environment->metresPerUnit),
                                   agentStep(run->pipeline),
                                   agentGap(run->pipeline),
                                   run,
                                   controller_.cache()};
    walk_->setGround(ground, radiusOf(run->pipeline), run->environment->metresPerUnit);
    model_.setGround(ground);
  } else {
    walk_->setGround({}, 0, metres);
    model_.setGround({});
  }
  panel_->setMargins(run && hasRadius(run->pipeline));
  takeBody();
  passage_->setMargin(kShownAroundLinks / metres);
  separation_->setMargin(kShownAroundLinks / metres);
  panel_->setNotice(!file_.environment() ? tr("Open an environment first.")
                    : run                ? QString()
                                         : tr("There is no result to walk on yet."));
  follow();
}

// The walker has the radius that is entered, or else that of the filter.
void PathFeature::takeBody() { walk_->setBodyRadius(model_.body().radius); }

// "Frame selection" shows the path, or the part up to which it gets, or the passage that is too narrow.
void PathFeature::boundSelection() {
  std::optional<SceneBox> bounds;
  const bool shown = view_.tool() == &tool_ || !dock_->isHidden();
  if (shown && model_.result() && model_.result()->hasPath()) {
    for (const Vec3& p : model_.result()->points) {
      if (!bounds) bounds = SceneBox{p, p};
      Vec3 &lower = bounds->lower, &upper = bounds->upper;
      lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
      upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
    }
  }
  if (shown && !bounds) bounds = passage_->bounds();
  view_.cameraController().setSelectionBounds(QStringLiteral("path"), bounds);
}

std::string PathFeature::save() const {
  Json json;
  json["start"] = toJson(model_.start());
  json["target"] = toJson(model_.target());
  json["radius"] = model_.body().radius;
  json["way"] = model_.body().way;
  json["speed"] = panel_->speed();
  json["pace"] = walk_->walker().pace();
  json["camera"] = walk_->walkerView().camera();
  return json.dump();
}

void PathFeature::load(const std::string& text) {
  fromSession_ = true;
  if (text.empty()) {
    model_.setPlaces(std::nullopt, std::nullopt);
    model_.setBody({});
    return;
  }
  const Json json = Json::parse(text);
  const double speed = json.value("speed", panel_->speed());
  if (!(speed > 0 && std::isfinite(speed))) throw std::runtime_error("a walking speed that is not above 0");
  const WalkingBody body{json.value("radius", 0.0), json.value("way", BodyWay::Shortest)};
  if (!(body.radius >= 0 && std::isfinite(body.radius))) throw std::runtime_error("a radius that is not at least 0");
  model_.setBody(body);
  model_.setPlaces(toPlace(json.value("start", Json())), toPlace(json.value("target", Json())));
  panel_->setSpeed(speed);
  walk_->setSpeed(speed);
  walk_->bar()->choose(json.value("pace", 1.0), json.value("camera", WalkCamera::Free));
}

}  // namespace footfall::ui
