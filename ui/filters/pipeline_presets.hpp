// Named pipelines: presets of the program, and the user's own as files in the settings folder.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <vector>

#include "footfall/pipeline.hpp"

namespace footfall::ui {

struct BuiltInPreset {
  QString name, help;
  QString resource;      ///< path of the compiled-in file
  bool inMetres = true;  ///< lengths and areas follow the scale; else they are in units, as in the thesis
};
const std::vector<BuiltInPreset>& builtInPresets();
/// The preset in the units of an environment of that scale.
Pipeline builtInPipeline(const BuiltInPreset& preset, double metresPerUnit);

/// The user's presets. Every member throws InputError "FILE: what; what to do" when a file cannot be read or written.
/// Values are stored as they are, in the environment's units.
class PresetStore {
 public:
  /// Presets are files NAME.pipeline in `folder`, which is made when the first one is saved.
  explicit PresetStore(QString folder) : folder_(std::move(folder)) {}
  /// The presets in the program's settings folder.
  static PresetStore ofUser();

  /// The names of all presets, sorted; empty when there is no folder.
  [[nodiscard]] QStringList names() const;
  [[nodiscard]] Pipeline read(const QString& name) const;
  /// Saves a preset, replacing one of the same name.
  void save(const QString& name, const Pipeline& pipeline) const;
  /// `to` must not exist.
  void rename(const QString& from, const QString& to) const;
  /// Removes a preset. Returns the content of the file, for restore().
  QByteArray remove(const QString& name) const;
  void restore(const QString& name, const QByteArray& content) const;
  /// The problem of a name, e.g. that it has a slash; empty when it can be used.
  [[nodiscard]] static QString problemOf(const QString& name);
  [[nodiscard]] QString pathOf(const QString& name) const;

 private:
  QString folder_;
};

}  // namespace footfall::ui
