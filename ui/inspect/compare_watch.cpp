// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/compare_watch.hpp"

#include <QFile>
#include <exception>
#include <new>
#include <utility>

#include "core/base/worker_arena.hpp"
#include "footfall/errors.hpp"
#include "footfall/io.hpp"
#include "ui/base/core_text.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

struct CompareWatch::Answer {
  MeshPtr saved;
  std::shared_ptr<const SurfaceDifference> difference;
  QString error;
};

CompareWatch::CompareWatch(QObject* parent) : QObject(parent) {}

CompareWatch::~CompareWatch() {
  if (context_) context_->cancel();
}

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
  if (!context_) return;
  context_->cancel();  // it ends by itself, soon
  context_.reset();
  isDropped_ = true;
}

void CompareWatch::resume() {
  if (isDropped_) refresh();
}

void CompareWatch::set(CompareWith with) {
  with_ = with;
  saved_.reset();
  difference_.reset();
  refresh();
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
    emit changed();
    return;
  }
  context_ = std::make_shared<RunContext>();
  const MeshPtr other = with_ == CompareWith::LastEdit ? before_ : saved_;
  queue_.post([this, context = context_, other, result = result_, path = path_, up = up_] {
    Answer answer{other, nullptr, {}};
    try {
      onThreads(0, [&](int) {
        context->checkCancelled();
        if (!answer.saved)
          answer.saved = std::make_shared<NavigationMesh>(
              readNavigationMesh(QFile::encodeName(path).toStdString(), std::nullopt, up, context.get()).mesh);
        answer.difference = std::make_shared<SurfaceDifference>(
            subtractSurfaces(*answer.saved, *result, *context, roundingHeight(*answer.saved, *result)));
        return true;
      });
    } catch (const Cancelled&) {
      return;  // whoever cancelled it knows
    } catch (const std::bad_alloc&) {
      answer.error = tr("The comparison: memory ran out; close other programs or use a smaller environment");
    } catch (const std::exception& error) {
      answer.error = coreText(error);
    }
    QMetaObject::invokeMethod(
        this,
        [this, context, answer] {
          if (context != context_) return;  // overtaken
          context_.reset();
          take(answer);
        },
        Qt::QueuedConnection);
  });
  emit changed();
}

void CompareWatch::take(const Answer& answer) {
  if (!answer.error.isEmpty()) {
    compareWithNothing();
    emit failed(answer.error);
    return;
  }
  if (with_ == CompareWith::SavedResult) saved_ = answer.saved;
  difference_ = answer.difference;
  emit changed();
}

}  // namespace footfall::ui
