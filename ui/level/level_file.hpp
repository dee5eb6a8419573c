// The file that the level comes from.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "ui/level/environment_loader.hpp"

namespace footfall::ui {

/// The reason why a file is being read.
enum class Reading {
  Nothing,       ///< no file is being read
  Another,       ///< another file
  OtherOptions,  ///< the same file with other import options
  OtherPart,     ///< another part of the same file, which is too large to be loaded as a whole
  Again          ///< the same file with the same options, after another program has saved it
};

/// Reads the file in the background. The present level stays while a file is being read.
class LevelFile : public QObject {
  Q_OBJECT

 public:
  explicit LevelFile(QObject* parent = nullptr);

  /// Replaces the read that is under way.
  void open(const QString& path, const ImportOptions& options);
  /// Reads the file again, unless a file is being read. Errors emit rereadFailed() only.
  void reread(const ImportOptions& options);
  /// Sets other options. The file is read again where they change the mesh, else rescaled() follows at once. Ignored
  /// while another file is being read, which has options of its own.
  void setOptions(const ImportOptions& options);
  /// Loads another part of a file of which a part is loaded (LoadedEnvironment::part), with the same options. Returns
  /// false, and does nothing, while a file is being read.
  bool showPart(const PartPlace& place);
  void setPackedLimits(const PackedLimits& limits) { loader_.setPackedLimits(limits); }
  void cancel();

  [[nodiscard]] bool busy() const { return loader_.busy(); }
  [[nodiscard]] Reading reading() const { return reading_; }
  /// The path of the file that is being read; empty: none.
  [[nodiscard]] QString pathBeingRead() const { return reading_ == Reading::Nothing ? QString() : path_; }
  /// The environment as the file gave it, without roles of parts and obstacles; null while nothing is loaded.
  [[nodiscard]] const std::shared_ptr<const Environment>& environment() const { return loaded_.environment; }
  [[nodiscard]] const LoadedEnvironment& loaded() const { return loaded_; }
  /// Path of the level, as it was opened; empty while nothing is loaded.
  [[nodiscard]] QString path() const;

 signals:
  void started(const QString& path);
  /// Emitted when the file has been read; document, runs and view then take the level. `before` is null when there was
  /// no level.
  void arrived(footfall::ui::Reading reading, const std::shared_ptr<const footfall::Environment>& before);
  /// Emitted after arrived(): the editor shows another level, or the same one with other options.
  void opened(footfall::ui::Reading reading);
  /// Emitted when the file has been read again.
  void rereadDone();
  /// Emitted when only the scale has changed.
  void rescaled();
  /// One line: what, where and what to do. The level before stays.
  void failed(const QString& message);
  void rereadFailed(const QString& message);
  void cancelled();

 private:
  void start(Reading reading, const QString& path, const ImportOptions& options,
             const std::optional<Vec3>& centre = std::nullopt, const std::optional<PartPlace>& place = std::nullopt);
  [[nodiscard]] std::optional<PartPlace> place() const;
  void take(const LoadedEnvironment& loaded);
  void keepScale();

  LoadedEnvironment loaded_;
  Reading reading_ = Reading::Nothing;
  QString path_;  ///< path of the file being read
  /// the loaded file's own scale, or the guess; applies while the user has given none
  std::optional<double> fileScale_;
  bool fileScaleGuessed_ = true;
  EnvironmentLoader loader_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
