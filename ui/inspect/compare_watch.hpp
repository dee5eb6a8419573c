// Computes the difference between the result and another one in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "core/compare/distance_bands.hpp"
#include "core/compare/surface_difference.hpp"
#include "footfall/environment.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/work/latest_work.hpp"

namespace footfall::ui {

enum class CompareWith { Nothing, LastEdit, SavedResult };

/// Never waits. The difference is computed anew when a result or the choice changes; overtaken work is cancelled.
/// Nothing is computed while there is no choice.
class CompareWatch : public QObject {
  Q_OBJECT

 public:
  using MeshPtr = std::shared_ptr<const NavigationMesh>;

  explicit CompareWatch(QObject* parent = nullptr);

  /// Discards the earlier results, because another level was opened.
  void forget();
  /// Called when a run has finished. `edit` is the number of the edit that it belongs to. The results of one edit, such
  /// as those during a drag, are compared with the last result of the edit before.
  void takeResult(const MeshPtr& mesh, int edit);
  /// Drops work on the old result, because a new one is being computed.
  void stop();
  /// Repeats the dropped work, because the old result stays.
  void resume();
  void compareWithNothing();
  void compareWithLastEdit();
  /// Compares with an OBJ file; `up` is its up axis where the file does not state it.
  void compareWithSaved(const QString& path, UpAxis up);
  /// Sets whether distances() are computed as well, in the background.
  void setDistancesWanted(bool wanted);

  [[nodiscard]] CompareWith with() const { return with_; }
  [[nodiscard]] const QString& path() const { return path_; }
  /// Returns whether there is a result to compare with: that of an edit, or the file.
  [[nodiscard]] bool hasOther() const { return with_ == CompareWith::SavedResult || before_ != nullptr; }
  [[nodiscard]] bool busy() const { return work_.busy(); }
  /// The difference. The first mesh is the other result, whose parts disappeared; the second is this result, whose
  /// parts appeared. Null while there is none; that of an older result while busy().
  [[nodiscard]] const std::shared_ptr<const SurfaceDifference>& difference() const { return difference_; }

  /// The distances from this result to the other one; null while there are none or they are not wanted.
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
  int edit_ = 0;            ///< edit that result_ belongs to
  bool isDropped_ = false;  ///< stop() has cancelled work
  QString path_;
  UpAxis up_ = UpAxis::Y;
  MeshPtr saved_;  ///< content of path_; null until it was read
  std::shared_ptr<const SurfaceDifference> difference_;
  bool wantsDistances_ = false;
  std::shared_ptr<const DistanceBands> distances_;
  LatestWork work_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
