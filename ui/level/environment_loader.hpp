// Loads environments in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "footfall/environment.hpp"
#include "ui/base/work/latest_work.hpp"
#include "ui/level/packed_part.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

struct LoadedEnvironment {
  std::shared_ptr<const Environment> environment;
  std::shared_ptr<const EnvironmentGeometry> geometry;
  ImportOptions options;                ///< options of the request
  std::vector<std::string> companions;  ///< companionFiles() of its file
  /// The part of a packed environment that `environment` is, when the whole is too large to be loaded; null for all
  /// others.
  std::shared_ptr<const PackedPart> part;
};

/// Runs one load at a time: another one cancels it. Signals are emitted on the thread that the loader lives on.
class EnvironmentLoader : public QObject {
  Q_OBJECT

 public:
  explicit EnvironmentLoader(QObject* parent = nullptr);

  /// Loads a file. Its geometry is made around `centre`, if given: the centre of the version before. Of a packed
  /// environment that is too large, the part at `place` is loaded, or the part in its middle. The surface of `before`,
  /// the present part (null: none), is used again where it is of the same file.
  void load(const QString& path, const ImportOptions& options, const std::optional<Vec3>& centre = std::nullopt,
            const std::optional<PartPlace>& place = std::nullopt,
            const std::shared_ptr<const PackedPart>& before = nullptr);
  void setPackedLimits(const PackedLimits& limits) { limits_ = limits; }
  void cancel();
  [[nodiscard]] bool busy() const { return work_.busy(); }

 signals:
  void started(const QString& path);
  void loaded(const footfall::ui::LoadedEnvironment& environment);
  /// One line: what, where and what to do.
  void failed(const QString& message);
  void cancelled();

 private:
  PackedLimits limits_;
  LatestWork work_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
