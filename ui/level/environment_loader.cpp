// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/environment_loader.hpp"

#include <QFile>
#include <new>
#include <utility>

#include "core/base/worker_arena.hpp"
#include "core/io/file_frame.hpp"
#include "core/io/import.hpp"
#include "core/io/write_targets.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"

namespace footfall::ui {

namespace {

// Null: the environment is opened like any other.
std::shared_ptr<const PackedEnvironment> tooLarge(const std::string& path, const ImportOptions& options,
                                                  const PackedLimits& limits) {
  if (lowerExtension(path) != kPackedExtension) return nullptr;
  auto packed = std::make_shared<const PackedEnvironment>(path, options);
  return packed->faceCount() > limits.whole ? packed : nullptr;
}

void takePart(OpenedPart opened, LoadedEnvironment& result) {
  result.geometry = makeEnvironmentGeometry(opened.environment, std::nullopt, true, opened.part.whole);
  result.environment = std::make_shared<const Environment>(std::move(opened.environment));
  result.part = std::make_shared<const PackedPart>(std::move(opened.part));
}

}  // namespace

EnvironmentLoader::EnvironmentLoader(QObject* parent) : QObject(parent) {}

void EnvironmentLoader::load(const QString& path, const ImportOptions& options, const std::optional<Vec3>& centre,
                             const std::optional<PartPlace>& place, const std::shared_ptr<const PackedPart>& before) {
  const std::string name = QFile::encodeName(path).toStdString();
  work_.start(
      *this,
      [options, centre, name, place, before, limits = limits_](RunContext& context) {
        LoadedEnvironment result;
        result.options = options;
        if (const auto packed = tooLarge(name, options, limits)) {
          takePart(openPart(packed, limits, place, centre, context, before.get()), result);
          return result;
        }
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
