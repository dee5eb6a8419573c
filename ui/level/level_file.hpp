// The file that the level comes from.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "ui/level/environment_loader.hpp"

namespace footfall::ui {

/// Why a file is being read.
enum class Reading {
  Nothing,       ///< none is
  Another,       ///< another file
  OtherOptions,  ///< the same file with other import options
  OtherPart,     ///< another part of the same file, which is too large to be loaded as a whole
  Again          ///< the same file with the same options, as another program has saved it
};

/// Reads the file in the background. While one is read, the level that was there stays.
class LevelFile : public QObject {
  Q_OBJECT

 public:
  explicit LevelFile(QObject* parent = nullptr);

  /// Takes the place of what is being read.
  void open(const QString& path, const ImportOptions& options);
  /// Reads the file again; nothing while something is being read. Errors come as rereadFailed() alone.
  void reread(const ImportOptions& options);
  /// Other options for the file: it is read again where they make a difference to the mesh, else rescaled() follows at
  /// once. Nothing while another file is being read, which has options of its own.
  void setOptions(const ImportOptions& options);
  /// Another part of a file of which a part is loaded (LoadedEnvironment::part), with the same options. False: nothing
  /// is done, as something else is being read.
  bool showPart(const PartPlace& place);
  void setPackedLimits(const PackedLimits& limits) { loader_.setPackedLimits(limits); }
  void cancel();

  [[nodiscard]] bool busy() const { return loader_.busy(); }
  [[nodiscard]] Reading reading() const { return reading_; }
  /// What is being read; empty: nothing.
  [[nodiscard]] QString pathBeingRead() const { return reading_ == Reading::Nothing ? QString() : path_; }
  /// The environment as the file gave it, without roles of parts and obstacles; null while nothing is loaded.
  [[nodiscard]] const std::shared_ptr<const Environment>& environment() const { return loaded_.environment; }
  [[nodiscard]] const LoadedEnvironment& loaded() const { return loaded_; }
  /// Path of the level, as it was opened; empty while nothing is loaded.
  [[nodiscard]] QString path() const;

 signals:
  void started(const QString& path);
  /// The file has been read: document, runs and view are to take the level. Null: there was none before.
  void arrived(footfall::ui::Reading reading, const std::shared_ptr<const footfall::Environment>& before);
  /// They have taken it: the editor shows another level, or the same one with other options.
  void opened(footfall::ui::Reading reading);
  /// The same, when the file was read again.
  void rereadDone();
  /// The scale is another one; nothing else has changed.
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
  QString path_;                     ///< being read
  std::optional<double> fileScale_;  ///< the loaded file's own, or the guess; what holds while the user gives none
  bool fileScaleGuessed_ = true;
  EnvironmentLoader loader_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
