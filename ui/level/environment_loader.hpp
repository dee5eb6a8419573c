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
#include "ui/base/latest_work.hpp"
#include "ui/level/packed_part.hpp"
#include "ui/view/render_geometry.hpp"

namespace footfall::ui {

struct LoadedEnvironment {
  std::shared_ptr<const Environment> environment;
  std::shared_ptr<const EnvironmentGeometry> geometry;
  ImportOptions options;                ///< as asked for
  std::vector<std::string> companions;  ///< companionFiles() of its file
  /// Of a packed environment that is too large to be loaded: what of it `environment` is; null for all others.
  std::shared_ptr<const PackedPart> part;
};

/// One load at a time: another one cancels it. Signals come on the thread that the loader lives on.
class EnvironmentLoader : public QObject {
  Q_OBJECT

 public:
  explicit EnvironmentLoader(QObject* parent = nullptr);

  /// The geometry is made around `centre`, when one is given: that of the version before. Of a packed environment that
  /// is too large, the part at `place` is loaded; nothing: in its middle. `before`: the part that is there (null:
  /// none), whose surface is used again where it is of the same file.
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
  LatestWork work_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
