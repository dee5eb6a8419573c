// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/compare_watch.hpp"

#include <QFile>
#include <exception>
#include <new>
#include <utility>

#include "core/base/worker_arena.hpp"
#include "footfall/errors.hpp"
#include "footfall/io.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kMostDistances = 40'000;  // in triangles: overlays are sent to the graphics card with every frame

}  // namespace

CompareWatch::CompareWatch(QObject* parent) : QObject(parent) {}

void CompareWatch::forget() {
  before_.reset();
  result_.reset();
  edit_ = 0;
  compareWithNothing();
}

void CompareWatch::takeResult(const MeshPtr& mesh, int edit) {
  if (mesh == result_) {
    edit_ = edit;
    return;
  }
  if (result_ && edit != edit_) before_ = result_;
  result_ = mesh;
  edit_ = edit;
  refresh();
}

void CompareWatch::stop() {
  if (!work_.busy()) return;
  work_.stop();
  isDropped_ = true;
}

void CompareWatch::resume() {
  if (isDropped_) refresh();
}

void CompareWatch::set(CompareWith with) {
  with_ = with;
  saved_.reset();
  difference_.reset();
  distances_.reset();
  refresh();
}

void CompareWatch::setDistancesWanted(bool wanted) {
  if (wanted == wantsDistances_) return;
  wantsDistances_ = wanted;
  if (!wanted) {
    distances_.reset();
    emit changed();
  } else if (!distances_) {
    refresh();
  }
}

void CompareWatch::compareWithNothing() {
  path_.clear();
  set(CompareWith::Nothing);
}

void CompareWatch::compareWithLastEdit() {
  path_.clear();
  set(CompareWith::LastEdit);
}

void CompareWatch::compareWithSaved(const QString& path, UpAxis up) {
  path_ = path;
  up_ = up;
  set(CompareWith::SavedResult);
}

void CompareWatch::refresh() {
  stop();
  isDropped_ = false;
  const bool isPossible = with_ != CompareWith::Nothing && result_ && hasOther();
  if (!isPossible) {
    difference_.reset();
    distances_.reset();
    emit changed();
    return;
  }
  const MeshPtr other = with_ == CompareWith::LastEdit ? before_ : saved_;
  work_.start(
      *this,
      [other, result = result_, path = path_, up = up_, wantsDistances = wantsDistances_](RunContext& context) {
        return onThreads(0, [&](int) {
          Answer answer{other, nullptr, nullptr};
          if (!answer.saved)
            answer.saved = std::make_shared<NavigationMesh>(
                readNavigationMesh(QFile::encodeName(path).toStdString(), std::nullopt, up, &context).mesh);
          answer.difference = std::make_shared<SurfaceDifference>(
              subtractSurfaces(*answer.saved, *result, context, roundingHeight(*answer.saved, *result)));
          if (wantsDistances)
            answer.distances =
                std::make_shared<DistanceBands>(findDistanceBands(*result, *answer.saved, kMostDistances, context));
          return answer;
        });
      },
      [this](const Answer& answer) { take(answer); },
      [this](const std::exception& error) {
        compareWithNothing();
        emit failed(dynamic_cast<const std::bad_alloc*>(&error) != nullptr
                        ? tr("The comparison: memory ran out; close other programs or use a smaller environment")
                        : coreText(error));
      });
  emit changed();
}

void CompareWatch::take(const Answer& answer) {
  if (with_ == CompareWith::SavedResult) saved_ = answer.saved;
  difference_ = answer.difference;
  distances_ = wantsDistances_ ? answer.distances : nullptr;
  emit changed();
}

}  // namespace footfall::ui
