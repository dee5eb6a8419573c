// Explains places and finds components of the last finished run, in the background.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "footfall/inspect.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/work/latest_work.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/overlays/view_overlay.hpp"

namespace footfall::ui {

/// A place that survives edits of the environment. Its triangle is identified by its corners; where the triangle no
/// longer exists, the place is the nearest one to the point.
struct AskedPlace {
  Vec3 point;
  std::optional<std::uint32_t> triangle;  ///< index into the environment's triangles; empty: the nearest one
  std::array<Vec3, 3> corners{};          ///< corners of that triangle
};

/// Never waits. Works only while something is requested. Everything that is requested is computed anew after each run,
/// and overtaken work is cancelled.
class InspectionWatch : public QObject {
  Q_OBJECT

 public:
  explicit InspectionWatch(RunController& controller, QObject* parent = nullptr);

  /// Emits explained() or failed(), and again after each run.
  void ask(const AskedPlace& place);
  /// Ends the explanation of a place.
  void forget();
  [[nodiscard]] const std::optional<AskedPlace>& asked() const { return asked_; }
  void setComponentsWanted(bool wanted);
  /// Emits componentShown() with an overlay for one of components(), now and after each run while the component exists.
  void showComponent(std::uint32_t component);

  /// The inspector of the last run that was inspected; null when there is none.
  [[nodiscard]] std::shared_ptr<const Inspector> inspector() const { return inspector_; }
  /// The explanation of asked(), by inspector(); empty until it is ready.
  [[nodiscard]] const std::optional<PlaceExplanation>& explanation() const { return explanation_; }
  /// Returns whether work is under way.
  [[nodiscard]] bool busy() const { return work_.busy(); }

 signals:
  /// Emitted when there is the inspector of another run, or none.
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
  std::shared_ptr<const FinishedRun> inspected_;  ///< the run of inspector_
  std::optional<PlaceExplanation> explanation_;
  int shown_ = 0;    ///< counts calls of showComponent(); results of older calls are dropped
  LatestWork work_;  // declared last: its thread ends before the other members are destroyed
};

/// The surface of a component and a line around it; only the line of a large component.
ViewOverlay componentOverlay(const Inspector& inspector, std::uint32_t component);

}  // namespace footfall::ui
