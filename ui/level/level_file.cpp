// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/level_file.hpp"

#include <QFile>
#include <utility>

#include "core/environment/coordinate_grid.hpp"

namespace footfall::ui {

LevelFile::LevelFile(QObject* parent) : QObject(parent) {
  connect(&loader_, &EnvironmentLoader::started, this, &LevelFile::started);
  connect(&loader_, &EnvironmentLoader::loaded, this, &LevelFile::take);
  connect(&loader_, &EnvironmentLoader::cancelled, this, [this] {
    reading_ = Reading::Nothing;
    emit cancelled();
  });
  connect(&loader_, &EnvironmentLoader::failed, this, [this](const QString& message) {
    const bool again = std::exchange(reading_, Reading::Nothing) == Reading::Again;
    if (again) {
      emit rereadFailed(message);
    } else {
      emit failed(message);
    }
  });
}

QString LevelFile::path() const {
  return loaded_.environment ? QFile::decodeName(QByteArray::fromStdString(loaded_.environment->source)) : QString();
}

void LevelFile::open(const QString& path, const ImportOptions& options) { start(Reading::Another, path, options); }

void LevelFile::reread(const ImportOptions& options) {
  if (loaded_.environment && !busy()) start(Reading::Again, path(), options, loaded_.geometry->centre, place());
}

bool LevelFile::showPart(const PartPlace& place) {
  const bool isFree = reading_ == Reading::Nothing || reading_ == Reading::OtherPart;
  if (!loaded_.part || !isFree) return false;
  start(Reading::OtherPart, path(), loaded_.options, {}, place);
  return true;
}

std::optional<PartPlace> LevelFile::place() const {
  return loaded_.part ? std::optional(loaded_.part->place) : std::nullopt;
}

void LevelFile::cancel() {
  if (busy()) loader_.cancel();
}

void LevelFile::start(Reading reading, const QString& path, const ImportOptions& options,
                      const std::optional<Vec3>& centre, const std::optional<PartPlace>& place) {
  reading_ = reading;
  path_ = path;
  ImportOptions kept = options;
  if (reading != Reading::Another) kept.keptGridStep = loaded_.environment->grid.step;
  loader_.load(path, kept, centre, place, loaded_.part);
}

void LevelFile::setOptions(const ImportOptions& options) {
  if (!loaded_.environment || reading_ == Reading::Another) return;
  const std::optional<double> scale = options.metresPerUnit ? options.metresPerUnit : fileScale_;
  const bool sameGrid = options.grid == loaded_.options.grid && options.gridStep == loaded_.options.gridStep &&
                        (!scale || !detail::gridDependsOnScale(*loaded_.environment, *scale));
  const bool sameMesh = options.up == loaded_.options.up && options.bothSides == loaded_.options.bothSides && sameGrid;
  if (!sameMesh || !scale || busy()) {
    // A place in the plan has no meaning after a turn to another axis.
    start(Reading::OtherOptions, path(), options, {}, options.up == loaded_.options.up ? place() : std::nullopt);
    return;
  }
  // The scale changes no coordinate, so nothing is computed again.
  auto scaled = std::make_shared<Environment>(*loaded_.environment);
  scaled->metresPerUnit = *scale;
  scaled->scaleGuessed = !options.metresPerUnit && fileScaleGuessed_;
  loaded_.environment = std::move(scaled);
  loaded_.options = options;
  emit rescaled();
}

void LevelFile::take(const LoadedEnvironment& loaded) {
  const Reading reading = std::exchange(reading_, Reading::Nothing);
  const std::shared_ptr<const Environment> before = std::exchange(loaded_, loaded).environment;
  if (reading == Reading::Another) fileScale_.reset();
  keepScale();
  emit arrived(reading, before);
  if (reading == Reading::Again) {
    emit rereadDone();
  } else {
    emit opened(reading);
  }
}

// A scale that the user has given is not the file's.
void LevelFile::keepScale() {
  if (loaded_.options.metresPerUnit) return;
  fileScale_ = loaded_.environment->metresPerUnit;
  fileScaleGuessed_ = loaded_.environment->scaleGuessed;
}

}  // namespace footfall::ui
