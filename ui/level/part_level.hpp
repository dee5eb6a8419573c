// The loaded environment with the roles that its parts have: what obstacles are placed into, and runs compute on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <list>
#include <memory>
#include <vector>

#include "core/environment/part_rules.hpp"
#include "footfall/run_context.hpp"
#include "ui/base/latest_work.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/render_geometry.hpp"

namespace footfall::ui {

/// Other roles, and a file that was read again, are worked in by a background thread, as an edit of the environment
/// that has results (or of the one before): runs then compute only what differs.
class PartLevel : public QObject {
  Q_OBJECT

 public:
  using EnvironmentPtr = std::shared_ptr<const Environment>;
  using GeometryPtr = std::shared_ptr<const EnvironmentGeometry>;

  explicit PartLevel(QObject* parent = nullptr);

  /// Starts anew (null: nothing is loaded), at once; changed() is emitted only for a geometry() that is made later.
  void setLoaded(EnvironmentPtr loaded, GeometryPtr geometry, const std::vector<PartRule>& rules);
  /// The same file, read again. `whole`: what it is a part of, null for all of it.
  void replaceLoaded(EnvironmentPtr loaded, std::shared_ptr<const WholeBounds> whole,
                     const std::vector<PartRule>& rules);
  /// Does nothing when these are the rules already.
  void setRules(const std::vector<PartRule>& rules);
  /// A run on base(), or on it with obstacles, has finished.
  void setComputed();

  /// The level with all roles, ignored parts left out. Older than the rules while busy().
  [[nodiscard]] const EnvironmentPtr& base() const { return base_; }
  /// The geometry of base(), around the centre of the first version; that of everything until it is made.
  [[nodiscard]] const GeometryPtr& geometry() const { return geometry_; }
  [[nodiscard]] bool busy() const { return work_.busy(); }

 signals:
  /// base() is another one, and so is geometry().
  void changed();
  /// Comes after changed(), too.
  void geometryChanged();
  void failed(const QString& message);

 private:
  struct Version {
    EnvironmentPtr loaded;
    std::vector<PartRule> rules;
    EnvironmentPtr base;
    GeometryPtr geometry;
  };
  void update();
  void work(EnvironmentPtr base);
  void take(const EnvironmentPtr& base, const GeometryPtr& geometry);

  EnvironmentPtr loaded_, base_, computed_;
  GeometryPtr geometry_;
  std::shared_ptr<const WholeBounds> whole_;
  std::vector<PartRule> rules_;
  std::list<Version> versions_;  ///< most recent first: undo finds its results in the cache
  LatestWork work_;              // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
