// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/walk/walk_feature.hpp"

namespace footfall::ui {

WalkFeature::WalkFeature(const FeatureHost& host, LevelView& view, PathModel& model, QObject* parent)
    : QObject(parent),
      model_(model),
      walkerView_(walker_, view),
      tool_(view, nullptr),
      bar_(new WalkBar(walker_, walkerView_)) {
  setObjectName(QStringLiteral("walkFeature"));
  host.tools.add({QStringLiteral("tools.walk"),
                  CommandMenu::Tools,
                  QStringLiteral("camera"),
                  tr("Wal&k"),
                  tr("Walk over the result in first person, as tall as the agent"),
                  {QKeySequence(Qt::SHIFT | Qt::Key_W)},
                  QStringLiteral("walk")},
                 &tool_);
  play_ = host.commands.add({QStringLiteral("tools.walkPath"), CommandMenu::Tools, QStringLiteral("tools"),
                             tr("Walk the pat&h"), tr("Let somebody of the agent's size walk the path of Try it")},
                            [this](bool) { walker_.setPlaying(!walker_.isPlaying()); });
  connect(&walker_, &Walker::changed, this, [this] { play_->setEnabled(!walker_.track().isEmpty()); });
  play_->setEnabled(false);
  connect(&tool_, &WalkTool::hintChanged, this, [this, &view, &status = host.status](const QString& hint) {
    if (view.tool() == &tool_) status.say(StatusSubject::Tool, hint);
  });
  connect(&tool_, &WalkTool::failed, &host.messages, &MessageBar::showError);
  connect(&model_, &PathModel::resultChanged, this, &WalkFeature::takePath);
}

void WalkFeature::setGround(const PathModel::Ground& ground, double radius, double metresPerUnit) {
  metresPerUnit_ = metresPerUnit;
  height_ = ground.agentHeight;
  groundRadius_ = radius;
  const WalkBody body = walkBodyFor(ground.agentHeight, radius);
  walkerView_.setMetre(1 / metresPerUnit);
  walkerView_.setBody(body);
  tool_.setGround(ground, body, metresPerUnit);
}

void WalkFeature::setBodyRadius(double radius) {
  walkerView_.setBody(walkBodyFor(height_, radius > 0 ? radius : groundRadius_));
}

void WalkFeature::setSpeed(double speed) {
  speed_ = speed;
  tool_.setSpeed(speed);
  takePath();
}

void WalkFeature::setShown(bool shown) {
  if (!shown) walker_.setPlaying(false);
  walkerView_.setShown(shown);
}

void WalkFeature::takePath() {
  const auto& result = model_.result();
  walker_.setTrack(result && result->hasPath() ? WalkTrack(*result, metresPerUnit_, speed_) : WalkTrack());
}

}  // namespace footfall::ui
