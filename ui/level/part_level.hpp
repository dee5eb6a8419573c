// The loaded environment with the roles of its parts, which obstacles are placed into.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <list>
#include <memory>
#include <vector>

#include "core/environment/part_rules.hpp"
#include "footfall/run_context.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/work/latest_work.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// A background thread applies other roles, and a file that was read again, as an edit of the environment that has
/// results (or of the one before), so that runs compute only the difference.
class PartLevel : public QObject {
  Q_OBJECT

 public:
  using EnvironmentPtr = std::shared_ptr<const Environment>;
  using GeometryPtr = std::shared_ptr<const EnvironmentGeometry>;

  explicit PartLevel(QObject* parent = nullptr);

  /// Sets another environment (null: nothing is loaded), at once; changed() is emitted only for a geometry() that is
  /// made later.
  void setLoaded(EnvironmentPtr loaded, GeometryPtr geometry, const std::vector<PartRule>& rules);
  /// Sets the same file, read again. `whole` is the environment that it is a part of, null for all of it.
  void replaceLoaded(EnvironmentPtr loaded, std::shared_ptr<const WholeBounds> whole,
                     const std::vector<PartRule>& rules);
  /// Has no effect when these are the rules already.
  void setRules(const std::vector<PartRule>& rules);
  /// Called when a run on base(), or on it with obstacles, has finished.
  void setComputed();

  /// The level with all roles, without ignored parts. It is older than the rules while busy().
  [[nodiscard]] const EnvironmentPtr& base() const { return base_; }
  /// The geometry of base(), around the centre of the first version; that of everything until it is made.
  [[nodiscard]] const GeometryPtr& geometry() const { return geometry_; }
  [[nodiscard]] bool busy() const { return work_.busy(); }

 signals:
  /// Emitted when base() and geometry() are others.
  void changed();
  /// Follows changed() as well.
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
  LatestWork work_;              // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
