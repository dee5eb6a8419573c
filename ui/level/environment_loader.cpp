// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/environment_loader.hpp"

#include <QFile>
#include <new>

#include "core/base/worker_arena.hpp"
#include "core/io/import.hpp"
#include "core/io/write_targets.hpp"
#include "ui/base/core_text.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

EnvironmentLoader::EnvironmentLoader(QObject* parent) : QObject(parent) {}

EnvironmentLoader::~EnvironmentLoader() {
  if (context_) context_->cancel();
}

void EnvironmentLoader::load(const QString& path, const ImportOptions& options, const std::optional<Vec3>& centre) {
  if (context_) context_->cancel();
  context_ = std::make_shared<RunContext>();
  emit started(path);
  queue_.post([this, context = context_, options, centre, name = QFile::encodeName(path).toStdString()] {
    LoadedEnvironment result;
    result.options = options;
    QString error;
    try {
      context->checkCancelled();
      result.environment = onThreads(0, [&](int) { return importEnvironment(name, options, context.get()); });
      context->checkCancelled();
      result.companions = companionFiles(name);
      context->checkCancelled();
      result.geometry = makeEnvironmentGeometry(*result.environment, centre);
    } catch (const Cancelled&) {
      result = {};
    } catch (const std::bad_alloc&) {
      error =
          tr("%1: memory ran out; close other programs or use a smaller environment").arg(QString::fromStdString(name));
    } catch (const std::exception& problem) {
      error = coreText(problem);
    }
    QMetaObject::invokeMethod(
        this,
        [this, context, result, error] {
          if (context != context_) return;  // overtaken or cancelled
          context_.reset();
          if (!error.isEmpty()) {
            emit failed(error);
          } else if (result.geometry) {
            emit loaded(result);
          }
        },
        Qt::QueuedConnection);
  });
}

void EnvironmentLoader::cancel() {
  if (!context_) return;
  context_->cancel();
  context_.reset();
  emit cancelled();
}

}  // namespace footfall::ui
