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

void EnvironmentLoader::load(const QString& path, const ImportOptions& options, const std::optional<Vec3>& centre) {
  const std::string name = QFile::encodeName(path).toStdString();
  work_.start(
      *this,
      [options, centre, name](RunContext& context) {
        LoadedEnvironment result;
        result.options = options;
        result.environment = onThreads(0, [&](int) { return importEnvironment(name, options, &context); });
        context.checkCancelled();
        result.companions = companionFiles(name);
        context.checkCancelled();
        result.geometry = makeEnvironmentGeometry(*result.environment, centre);
        return result;
      },
      [this](const LoadedEnvironment& result) { emit loaded(result); },
      [this, name](const std::exception& error) {
        emit failed(dynamic_cast<const std::bad_alloc*>(&error) != nullptr
                        ? tr("%1: memory ran out; close other programs or use a smaller environment")
                              .arg(QString::fromStdString(name))
                        : coreText(error));
      });
  emit started(path);
}

void EnvironmentLoader::cancel() {
  if (!busy()) return;
  work_.stop();
  emit cancelled();
}

}  // namespace footfall::ui
