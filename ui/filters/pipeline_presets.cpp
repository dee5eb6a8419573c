// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/pipeline_presets.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/io/export.hpp"
#include "footfall/errors.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/translated.hpp"
#include "ui/document/document.hpp"

namespace footfall::ui {
namespace {

constexpr const char* kEnding = ".pipeline";
constexpr qsizetype kLongestName = 80;

std::string encoded(const QString& path) { return QFile::encodeName(path).toStdString(); }

}  // namespace

const std::vector<BuiltInPreset>& builtInPresets() {
  static const auto path = [](const char* name) {
    return QStringLiteral(":/resources/pipelines/") + QLatin1String(name);
  };
  static const std::vector<BuiltInPreset> presets = {
      {tr("Sequential"), tr("The filters of a new environment"), path("default.pipeline"), true},
      {tr("Parallel"), tr("The same result, with the clearance in cells on all threads"), path("parallel.pipeline"),
       true},
      {tr("Thesis, sequential"), tr("As in the thesis's experiments (5.4), in the units of its environments"),
       path("thesis_sequential.pipeline"), false},
      {tr("Thesis, parallel"), tr("As in the thesis's experiments (5.4), in the units of its environments"),
       path("thesis_parallel.pipeline"), false}};
  return presets;
}

Pipeline builtInPipeline(const BuiltInPreset& preset, double metresPerUnit) {
  QFile file(preset.resource);
  if (!file.open(QIODevice::ReadOnly))
    throw InputError(FOOTFALL_TEXT("%1: is missing; install again"), preset.resource.toStdString());
  const Pipeline pipeline = parsePipeline(file.readAll().toStdString(), preset.resource.toStdString());
  return preset.inMetres ? rescaleDefaults(pipeline, 1, metresPerUnit) : pipeline;
}

PresetStore PresetStore::ofUser() {
  return PresetStore(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + QStringLiteral("/presets"));
}

QString PresetStore::pathOf(const QString& name) const {
  return folder_ + QLatin1Char('/') + name + QLatin1String(kEnding);
}

QStringList PresetStore::names() const {
  QStringList names;
  const QDir folder(folder_);
  const QStringList files = folder.entryList({QLatin1Char('*') + QLatin1String(kEnding)}, QDir::Files,
                                             QDir::Name | QDir::IgnoreCase | QDir::LocaleAware);
  for (const QString& file : files) names << file.chopped(static_cast<qsizetype>(qstrlen(kEnding)));
  return names;
}

Pipeline PresetStore::read(const QString& name) const { return readPipelineFile(encoded(pathOf(name))); }

void PresetStore::save(const QString& name, const Pipeline& pipeline) const {
  const QString wrong = problemOf(name);
  if (!wrong.isEmpty()) throw InputError(wrong.toStdString());
  QDir().mkpath(folder_);
  writeFileSafely(encoded(pathOf(name)), formatPipeline(pipeline));
}

void PresetStore::rename(const QString& from, const QString& to) const {
  const QString wrong = problemOf(to);
  if (!wrong.isEmpty()) throw InputError(wrong.toStdString());
  if (QFileInfo::exists(pathOf(to)))
    throw InputError(tr("a preset named '%1' already exists; choose another name").arg(to).toStdString());
  if (!QFile::rename(pathOf(from), pathOf(to)))
    throw InputError(tr("%1: cannot be renamed; check the folder").arg(pathOf(from)).toStdString());
}

QByteArray PresetStore::remove(const QString& name) const {
  QFile file(pathOf(name));
  QByteArray content;
  if (file.open(QIODevice::ReadOnly)) content = file.readAll();
  file.close();
  if (!file.remove()) throw InputError(tr("%1: cannot be deleted; check the folder").arg(pathOf(name)).toStdString());
  return content;
}

void PresetStore::restore(const QString& name, const QByteArray& content) const {
  writeFileSafely(encoded(pathOf(name)), content.toStdString());
}

QString PresetStore::problemOf(const QString& name) {
  if (name.trimmed().isEmpty()) return tr("the preset has no name; give one");
  if (name != name.trimmed() || name.startsWith(QLatin1Char('.')))
    return tr("'%1' begins with a point, or begins or ends with a blank; choose another name").arg(name);
  if (name.size() > kLongestName) return tr("the name is too long; give at most %1 letters").arg(kLongestName);
  for (const QChar letter : name) {
    if (letter.unicode() < 0x20 || QStringLiteral("/\\:*?\"<>|").contains(letter))
      return tr("a name of a preset is a name of a file and cannot have '%1'; leave it out").arg(letter);
  }
  return {};
}

}  // namespace footfall::ui
