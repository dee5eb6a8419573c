// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/path_model.hpp"

#include <new>
#include <utility>

#include "footfall/errors.hpp"
#include "ui/base/text/core_text.hpp"

namespace footfall::ui {
namespace {

constexpr int kOvertakenMs = 100;

}  // namespace

struct PathModel::Finders {
  WayFinder points, bodies;
};

struct PathModel::Request {
  Ground ground;
  WalkingBody body;
  Vec3 start, target;
  std::optional<PathResult> failed;  ///< the path whose barrier is computed
};

PathModel::PathModel(QObject* parent) : QObject(parent), finders_(std::make_shared<Finders>()) {
  overtaken_.setSingleShot(true);
  overtaken_.setInterval(kOvertakenMs);
  connect(&overtaken_, &QTimer::timeout, this, [this] {
    if (isStale_ && search_) search_->cancel();
  });
}

PathModel::~PathModel() { stop(); }

void PathModel::stop() {
  for (const auto& context : {context_, search_})
    if (context) context->cancel();
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

void PathModel::setBody(const WalkingBody& body) {
  const WalkingBody before = std::exchange(body_, body);
  if (before == body) return;
  emit bodyChanged();
  // A point's path does not depend on the way, and its ground is another one than a body's.
  if (!before.isPoint() || !body.isPoint()) refresh(before.isPoint() != body.isPoint());
}

void PathModel::refresh(bool groundChanged) {
  if (!isWanted()) {
    stop();
    isStale_ = false;
    const bool wasShown = way_.path || way_.body;
    way_ = {};
    if (wasShown) emit resultChanged();
    return;
  }
  if (context_) {
    isStale_ = true;
    if (groundChanged || isSeparating_) {
      stop();
    } else if (!overtaken_.isActive()) {
      overtaken_.start();
    }
    return;
  }
  startJob();
}

void PathModel::setPreparing(bool preparing) {
  if (std::exchange(isPreparing_, preparing) != preparing) emit preparingChanged();
}

void PathModel::startJob(std::optional<PathResult> failed) {
  isStale_ = false;
  isSeparating_ = failed.has_value();
  context_ = std::make_shared<RunContext>();
  search_ = std::make_shared<RunContext>();
  const Request request{ground_, body_, *start_, *target_, std::move(failed)};
  setPreparing(!body_.isPoint() && !way_.body);
  queue_.post([this, context = context_, search = search_, finders = finders_, request] {
    std::optional<FoundWay> result;
    QString error;
    try {
      context->checkCancelled();
      const bool isPoint = request.body.isPoint();
      WayFinder& finder = isPoint ? finders->points : finders->bodies;
      finder.prepare(request.ground, !isPoint, *context);
      FoundWay found = request.failed ? FoundWay{request.failed, {}}
                                      : finder.find(request.start, request.target, request.body, *search);
      if (request.failed) finder.separate(*found.path, *search);
      result = std::move(found);
    } catch (const Cancelled&) {
    } catch (const std::bad_alloc&) {
      error = tr("the path: memory ran out; close other programs or use a smaller environment");
    } catch (const std::exception& problem) {
      error = coreText(problem);
    }
    QMetaObject::invokeMethod(
        this, [this, request, result, error] { finishJob(request, result, error); }, Qt::QueuedConnection);
  });
}

void PathModel::finishJob(const Request& request, const std::optional<FoundWay>& way, const QString& error) {
  context_.reset();
  search_.reset();
  overtaken_.stop();
  const bool separated = std::exchange(isSeparating_, false);
  const bool isSameKind = request.body.isPoint() == body_.isPoint();
  const bool isCurrent = isWanted() && request.ground == ground_ && isSameKind;
  // The barrier between the parts is not used once the places have moved.
  const bool isUsed = isCurrent && way && !(separated && isStale_);
  if (isUsed) {
    way_.path = way->path;
    if (!separated) way_.body = way->body;
    isPreparing_ = false;
    emit resultChanged();
  }
  if (!error.isEmpty()) emit failed(error);
  if (context_) return;
  // A cancelled request counts too when it is needed again.
  const bool isMissing = isWanted() && !way && error.isEmpty();
  if (isStale_ || isMissing) {
    if (isWanted()) startJob();
  } else if (isUsed && !separated && way->path && way->path->status == PathStatus::NotConnected &&
             !way->path->separation && request.ground.environment) {
    startJob(*way->path);
  }
  if (!context_) setPreparing(false);
}

}  // namespace footfall::ui
