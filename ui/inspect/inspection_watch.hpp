// Answers about the last finished run, made in the background: why a place is walkable or not, and the components.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "footfall/inspect.hpp"
#include "ui/base/latest_work.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/view_overlay.hpp"

namespace footfall::ui {

/// A place that outlives edits of the environment: the triangle is known by its corners, and where it has gone, the
/// place is the nearest one to the point.
struct AskedPlace {
  Vec3 point;
  std::optional<std::uint32_t> triangle;  ///< index into the environment's triangles; empty: the nearest one
  std::array<Vec3, 3> corners{};          ///< of that triangle
};

/// Never waits. Works only while somebody wants to know; after each run
/// everything that is wanted is made anew, and what was overtaken is cancelled.
class InspectionWatch : public QObject {
  Q_OBJECT

 public:
  explicit InspectionWatch(RunController& controller, QObject* parent = nullptr);

  /// explained() or failed() follows, and again after each run.
  void ask(const AskedPlace& place);
  /// No place is asked for any more.
  void forget();
  [[nodiscard]] const std::optional<AskedPlace>& asked() const { return asked_; }
  void setComponentsWanted(bool wanted);
  /// componentShown() follows with what to draw of one of components(), now and after each run while it is there.
  void showComponent(std::uint32_t component);

  /// The inspector of the last run that was looked at; null when there is none.
  [[nodiscard]] std::shared_ptr<const Inspector> inspector() const { return inspector_; }
  /// The answer for asked(), by inspector(); empty until it is there.
  [[nodiscard]] const std::optional<PlaceExplanation>& explanation() const { return explanation_; }
  /// Something is being made.
  [[nodiscard]] bool busy() const { return work_.busy(); }

 signals:
  /// Another run's, or none.
  void inspectorChanged();
  void explained();
  void failed(const QString& message);
  void componentShown(const footfall::ui::ViewOverlay& overlay);

 private:
  struct Answer {
    std::shared_ptr<const Inspector> inspector;
    std::optional<PlaceExplanation> explanation;
  };

  void refresh();
  void take(const Answer& answer, const std::shared_ptr<const FinishedRun>& run);

  RunController& controller_;
  std::optional<AskedPlace> asked_;
  bool componentsWanted_ = false;
  std::shared_ptr<const Inspector> inspector_;
  std::shared_ptr<const FinishedRun> inspected_;  ///< what inspector_ is about
  std::optional<PlaceExplanation> explanation_;
  int shown_ = 0;    ///< counts showComponent(): what is older is not wanted any more
  LatestWork work_;  // last: its thread ends before the rest goes
};

/// The surface of a component and a line around it; of large ones the line alone.
ViewOverlay componentOverlay(const Inspector& inspector, std::uint32_t component);

}  // namespace footfall::ui
