// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_writer.hpp"

#include <QFileInfo>
#include <utility>

#include "core/io/write_targets.hpp"
#include "footfall/errors.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/work/guarded_application.hpp"
#include "ui/window/file_dialogs.hpp"
#include "ui/window/replace_question.hpp"

namespace footfall::ui {

FileWriter::FileWriter(const Uses& uses) : QObject(&uses.window), uses_(uses) {}

void FileWriter::write(std::function<void()> write, const QString& path, std::function<void(bool)> then) {
  ++writing_;
  uses_.messages.finish(MessageSubject::Writing);
  emit started(path);
  uses_.queue.post([this, write = std::move(write), then = std::move(then), path] {
    const QString error = errorOf(write);
    QMetaObject::invokeMethod(
        this,
        [this, error, path, then] {
          --writing_;
          emit ended();
          if (error.isEmpty()) {
            uses_.messages.finish(MessageSubject::Writing);
            uses_.status.say(StatusSubject::Note, tr("Wrote %1").arg(path));
            uses_.log.add(MessageLevel::Note, tr("Wrote %1").arg(path));
          } else {
            uses_.messages.showErrorOf(MessageSubject::Writing, error);
          }
          if (then) then(error.isEmpty());
          if (error.isEmpty()) emit written(path);
          emit settled(error.isEmpty());
        },
        Qt::QueuedConnection);
  });
}

void FileWriter::writeLong(std::function<void(const RunContext&)> write, const QString& path) {
  std::erase_if(contexts_, [](const auto& context) { return context.expired(); });
  auto context = std::make_shared<RunContext>();
  contexts_.push_back(context);
  this->write(
      [context, path, write = std::move(write)] {
        try {
          context->checkCancelled();
          write(*context);
        } catch (const Cancelled&) {
          throw RunError(FOOTFALL_TEXT("%1: not written, as it was cancelled; export again"), toPath(path));
        }
      },
      path);
}

void FileWriter::cancel() {
  for (const auto& weak : contexts_)
    if (const auto context = weak.lock()) context->cancel();
}

QString FileWriter::refusal(const QString& path, WrittenKind kind) const {
  WriteTargets targets;
  const LoadedEnvironment& loaded = uses_.level.loaded();
  if (loaded.environment) targets.protectEnvironment(loaded.environment->source, loaded.companions);
  if (uses_.level.reading() != Reading::Nothing) targets.protectEnvironment(toPath(uses_.level.pathBeingRead()));
  if (kind != WrittenKind::Session) targets.protect(toPath(session_), FOOTFALL_TEXT("the session that is open"));
  if (kind != WrittenKind::Pipeline) targets.protect(toPath(pipeline_), FOOTFALL_TEXT("the pipeline that is open"));
  return errorOf([&] { targets.check(toPath(path)); });
}

bool FileWriter::refuses(const QString& path, WrittenKind kind) {
  const QString why = refusal(path, kind);
  if (!why.isEmpty()) uses_.messages.showErrorOf(MessageSubject::Writing, why);
  return !why.isEmpty();
}

void FileWriter::writeAsking(const QString& path, WrittenKind kind, std::function<void()> write,
                             std::function<void()> keep) {
  if (refuses(path, kind)) {
    if (keep) keep();
  } else if (sameFile(toPath(path), toPath(openPath(kind)))) {
    write();
  } else {
    askReplacing(&uses_.window, path, std::move(write), std::move(keep));
  }
}

QString FileWriter::openPath(WrittenKind kind) const {
  return kind == WrittenKind::Session ? session_ : kind == WrittenKind::Pipeline ? pipeline_ : QString();
}

void FileWriter::setOpenPath(WrittenKind kind, const QString& path) {
  (kind == WrittenKind::Session ? session_ : pipeline_) = path;
}

}  // namespace footfall::ui
