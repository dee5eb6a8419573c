// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path_model.hpp"

#include <new>
#include <utility>

#include "core/errors.hpp"
#include "ui/core_text.hpp"

namespace footfall {

struct PathModel::Finder {
  std::shared_ptr<const NavigationMesh> mesh;
  std::unique_ptr<PathFinder> finder;
};

PathModel::PathModel(QObject* parent) : QObject(parent), finder_(std::make_shared<Finder>()) {}

PathModel::~PathModel() {
  if (context_) context_->cancel();
}

void PathModel::setMesh(std::shared_ptr<const NavigationMesh> mesh, double reach) {
  if (mesh == mesh_ && reach == reach_) return;
  mesh_ = std::move(mesh);
  reach_ = reach;
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

void PathModel::refresh(bool meshChanged) {
  if (!active_ || !mesh_ || !start_ || !target_) {
    if (context_) context_->cancel();
    isStale_ = false;
    if (std::exchange(result_, std::nullopt)) emit resultChanged();
    return;
  }
  if (context_) {
    isStale_ = true;
    if (meshChanged) context_->cancel();
    return;
  }
  startJob();
}

void PathModel::startJob() {
  isStale_ = false;
  context_ = std::make_shared<RunContext>();
  queue_.post(
      [this, context = context_, finder = finder_, mesh = mesh_, reach = reach_, start = *start_, target = *target_] {
        std::optional<PathResult> result;
        QString error;
        try {
          const auto poll = [&context] { context->checkCancelled(); };
          poll();
          if (finder->mesh != mesh) {
            finder->mesh.reset();
            finder->finder.reset();
            finder->finder = std::make_unique<PathFinder>(mesh, poll);
            finder->mesh = mesh;
          }
          result = finder->finder->find(start, target, reach, poll);
        } catch (const Cancelled&) {
        } catch (const std::bad_alloc&) {
          error = tr("the path: memory ran out; close other programs or use a smaller environment");
        } catch (const std::exception& problem) {
          error = coreText(problem);
        }
        QMetaObject::invokeMethod(
            this, [this, mesh, result, error] { finishJob(mesh, result, error); }, Qt::QueuedConnection);
      });
}

void PathModel::finishJob(const std::shared_ptr<const NavigationMesh>& mesh, const std::optional<PathResult>& result,
                          const QString& error) {
  context_.reset();
  const bool isWanted = active_ && mesh == mesh_ && start_ && target_;
  if (isWanted && result) {
    result_ = result;
    emit resultChanged();
  }
  if (!error.isEmpty()) emit failed(error);
  // Also what was cancelled and is wanted again by now.
  const bool isMissing = active_ && mesh_ && start_ && target_ && !result && error.isEmpty();
  if (!context_ && (isStale_ || isMissing)) startJob();
}

}  // namespace footfall
