// What differs between the result and another one, found in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "core/compare/distance_bands.hpp"
#include "core/compare/surface_difference.hpp"
#include "footfall/environment.hpp"
#include "ui/base/latest_work.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

enum class CompareWith { Nothing, LastEdit, SavedResult };

/// Never waits. Everything is found anew when a result or the choice changes;
/// what was overtaken is cancelled. Nothing is computed while it compares with nothing.
class CompareWatch : public QObject {
  Q_OBJECT

 public:
  using MeshPtr = std::shared_ptr<const NavigationMesh>;

  explicit CompareWatch(QObject* parent = nullptr);

  /// Another level: no result of the one before counts.
  void forget();
  /// A run has finished. `edit` is the number of the edit that it belongs to: the results of one edit, such as those
  /// while something is dragged, are compared with the last one of the edit before.
  void takeResult(const MeshPtr& mesh, int edit);
  /// The result is being computed anew: work on the old one is dropped.
  void stop();
  /// It stays after all: what was dropped is done again.
  void resume();
  void compareWithNothing();
  void compareWithLastEdit();
  /// An OBJ file; `up` is the axis that it has where it does not say.
  void compareWithSaved(const QString& path, UpAxis up);
  /// Whether distances() are found as well, in the background.
  void setDistancesWanted(bool wanted);

  [[nodiscard]] CompareWith with() const { return with_; }
  [[nodiscard]] const QString& path() const { return path_; }
  /// There is something to compare with: an edit, or the file.
  [[nodiscard]] bool hasOther() const { return with_ == CompareWith::SavedResult || before_ != nullptr; }
  [[nodiscard]] bool busy() const { return work_.busy(); }
  /// First mesh: the other one, so that its parts went; second: the result, whose parts appeared. Null while there is
  /// none; of an older result while busy().
  [[nodiscard]] const std::shared_ptr<const SurfaceDifference>& difference() const { return difference_; }

  [[nodiscard]] bool areDistancesWanted() const { return wantsDistances_; }
  /// From the result to the other one; null while there are none or they are not wanted.
  [[nodiscard]] const std::shared_ptr<const DistanceBands>& distances() const { return distances_; }

 signals:
  void changed();
  void failed(const QString& message);

 private:
  struct Answer {
    MeshPtr saved;
    std::shared_ptr<const SurfaceDifference> difference;
    std::shared_ptr<const DistanceBands> distances;
  };
  void set(CompareWith with);
  void refresh();
  void take(const Answer& answer);

  CompareWith with_ = CompareWith::Nothing;
  MeshPtr before_, result_;
  int edit_ = 0;            ///< the edit that result_ belongs to
  bool isDropped_ = false;  ///< stop() has cancelled work
  QString path_;
  UpAxis up_ = UpAxis::Y;
  MeshPtr saved_;  ///< what path_ held; null until it was read
  std::shared_ptr<const SurfaceDifference> difference_;
  bool wantsDistances_ = false;
  std::shared_ptr<const DistanceBands> distances_;
  LatestWork work_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
