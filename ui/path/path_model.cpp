// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/path_model.hpp"

#include <array>
#include <functional>
#include <new>
#include <utility>

#include "core/navigation/path_ground.hpp"
#include "footfall/errors.hpp"
#include "ui/base/core_text.hpp"

namespace footfall::ui {

/// Data prepared for a ground, and the last answer about two of its parts, because most places are on the same parts.
struct PathModel::Finder {
  void prepare(const Ground& wanted, const RunContext& context) {
    if (finder && ground == wanted) return;
    separations.reset();
    last.reset();
    finder.reset();
    finder = std::make_unique<PathFinder>(wanted.mesh, &context);
    ground = wanted;
  }

  [[nodiscard]] PathResult find(const Vec3& start, const Vec3& target, const RunContext& context) const {
    PathResult result = finder->find(start, target, ground.reach, &context);
    if (result.status == PathStatus::NotConnected && last && last->parts == partsOf(result))
      result.separation = last->separation;
    return result;
  }

  void separate(PathResult& result, const RunContext& context) {
    if (!ground.environment) return;
    if (!separations)
      separations = std::make_unique<SeparationFinder>(*finder, ground.environment, ground.agentHeight,
                                                       ground.agentStep, &context, ground.agentGap);
    addSeparation(result, *separations, &context);
    last = {partsOf(result), result.separation};
  }

 private:
  struct Answer {
    std::array<std::uint32_t, 2> parts;
    std::optional<Separation> separation;
  };
  [[nodiscard]] std::array<std::uint32_t, 2> partsOf(const PathResult& result) const {
    const auto& components = finder->inside()->topology.components;
    return {components[result.start->triangle], components[result.target->triangle]};
  }

  Ground ground;
  std::unique_ptr<PathFinder> finder;
  std::unique_ptr<SeparationFinder> separations;
  std::optional<Answer> last;
};

PathModel::PathModel(QObject* parent) : QObject(parent), finder_(std::make_shared<Finder>()) {}

PathModel::~PathModel() {
  if (context_) context_->cancel();
}

void PathModel::setGround(Ground ground) {
  if (ground == ground_) return;
  ground_ = std::move(ground);
  refresh(true);
}

void PathModel::setActive(bool active) {
  if (std::exchange(active_, active) != active) refresh(false);
}

void PathModel::setPlaces(std::optional<Vec3> start, std::optional<Vec3> target) {
  if (start == start_ && target == target_) return;
  start_ = start;
  target_ = target;
  emit placesChanged();
  refresh(false);
}

void PathModel::refresh(bool groundChanged) {
  if (!isWanted()) {
    if (context_) context_->cancel();
    isStale_ = false;
    if (std::exchange(result_, std::nullopt)) emit resultChanged();
    return;
  }
  if (context_) {
    isStale_ = true;
    if (groundChanged || isSeparating_) context_->cancel();
    return;
  }
  startJob();
}

void PathModel::startJob(std::optional<PathResult> failed) {
  isStale_ = false;
  isSeparating_ = failed.has_value();
  context_ = std::make_shared<RunContext>();
  queue_.post([this, context = context_, finder = finder_, ground = ground_, failed = std::move(failed),
               start = *start_, target = *target_] {
    std::optional<PathResult> result;
    QString error;
    try {
      context->checkCancelled();
      finder->prepare(ground, *context);
      PathResult found = failed ? *failed : finder->find(start, target, *context);
      if (failed) finder->separate(found, *context);
      result = std::move(found);
    } catch (const Cancelled&) {
    } catch (const std::bad_alloc&) {
      error = tr("the path: memory ran out; close other programs or use a smaller environment");
    } catch (const std::exception& problem) {
      error = coreText(problem);
    }
    QMetaObject::invokeMethod(
        this, [this, ground, result, error] { finishJob(ground, result, error); }, Qt::QueuedConnection);
  });
}

void PathModel::finishJob(const Ground& ground, const std::optional<PathResult>& result, const QString& error) {
  context_.reset();
  const bool separated = std::exchange(isSeparating_, false);
  const bool isCurrent = isWanted() && ground == ground_;
  // The barrier between the parts is not used once the places have moved.
  const bool isUsed = isCurrent && result && !(separated && isStale_);
  if (isUsed) {
    result_ = result;
    emit resultChanged();
  }
  if (!error.isEmpty()) emit failed(error);
  if (context_) return;
  // A cancelled request counts too when it is needed again.
  const bool isMissing = isWanted() && !result && error.isEmpty();
  if (isStale_ || isMissing) {
    if (isWanted()) startJob();
  } else if (isUsed && !separated && result->status == PathStatus::NotConnected && !result->separation &&
             ground.environment) {
    startJob(*result);
  }
}

}  // namespace footfall::ui
