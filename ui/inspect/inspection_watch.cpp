// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/inspection_watch.hpp"

#include <exception>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "core/base/worker_arena.hpp"
#include "core/mesh/adjacency.hpp"
#include "footfall/errors.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kMostFilled = 4000;  // in triangles: larger components are not drawn anew in every frame

/// The chosen triangle, or the one nearest to the point where the triangle no longer exists.
std::optional<PickedPlace> resolve(const Inspector& inspector, const AskedPlace& asked) {
  const Environment& environment = inspector.environment();
  if (asked.triangle && *asked.triangle < environment.triangles.size()) {
    const Triangle& t = environment.triangles[*asked.triangle];
    bool same = true;
    for (std::size_t k = 0; k < 3; ++k) same = same && environment.vertices[t[k]] == asked.corners[k];
    if (same) return PickedPlace{*asked.triangle, asked.point};
  }
  return inspector.placeNear(asked.point);
}

}  // namespace

InspectionWatch::InspectionWatch(RunController& controller, QObject* parent)
    : QObject(parent), controller_(controller) {
  connect(&controller_, &RunController::finished, this, &InspectionWatch::refresh);
}

void InspectionWatch::ask(const AskedPlace& place) {
  asked_ = place;
  explanation_.reset();
  refresh();
}

void InspectionWatch::forget() {
  asked_.reset();
  explanation_.reset();
  refresh();
}

void InspectionWatch::setComponentsWanted(bool wanted) {
  if (wanted == componentsWanted_) return;
  componentsWanted_ = wanted;
  refresh();
}

void InspectionWatch::refresh() {
  work_.stop();
  const std::shared_ptr<const FinishedRun> run = controller_.finishedRun();
  if (!run || (!asked_ && !componentsWanted_)) {
    // States are large and are kept only while a place or the components are shown.
    inspected_.reset();
    if (std::exchange(inspector_, nullptr)) emit inspectorChanged();
    return;
  }
  const bool known = run == inspected_ && inspector_ != nullptr;
  if (known && (!asked_ || explanation_)) return;
  work_.start(
      *this,
      [run, cache = controller_.cache(), asked = asked_,
       inspector = known ? inspector_ : nullptr](RunContext& context) {
        return onThreads(0, [&](int) {
          Answer answer{inspector, std::nullopt};
          if (!answer.inspector) {
            answer.inspector =
                std::make_shared<Inspector>(run->environment, run->pipeline, run->result.mesh, cache.get(), &context);
          }
          if (!asked) return answer;
          if (const auto place = resolve(*answer.inspector, *asked))
            answer.explanation = answer.inspector->explain(*place, &context);
          return answer;
        });
      },
      [this, run](const Answer& answer) { take(answer, run); },
      [this](const std::exception& error) {
        emit failed(dynamic_cast<const std::bad_alloc*>(&error) != nullptr
                        ? tr("Why: memory ran out; close other programs or use a smaller environment")
                        : coreText(error));
      });
}

void InspectionWatch::take(const Answer& answer, const std::shared_ptr<const FinishedRun>& run) {
  const bool another = inspector_ != answer.inspector;
  inspector_ = answer.inspector;
  inspected_ = run;
  explanation_ = answer.explanation;
  if (another) emit inspectorChanged();
  if (asked_) emit explained();
}

void InspectionWatch::showComponent(std::uint32_t component) {
  const int number = ++shown_;
  if (!inspector_) return;
  work_.queue().post([this, number, component, inspector = inspector_] {
    ViewOverlay overlay = componentOverlay(*inspector, component);
    QMetaObject::invokeMethod(
        this,
        [this, number, overlay = std::move(overlay)] {
          if (number == shown_) emit componentShown(overlay);
        },
        Qt::QueuedConnection);
  });
}

ViewOverlay componentOverlay(const Inspector& inspector, std::uint32_t component) {
  const Components& components = inspector.components();
  const NavigationMesh& mesh = inspector.product();
  ViewOverlay overlay;
  if (component >= components.list.size()) return overlay;
  const Component& chosen = components.list[component];
  ViewOverlay::Surface surface;
  surface.colour = selectedCellColour();
  surface.colour.setAlpha(90);
  std::vector<Triangle> triangles;
  for (std::size_t t = chosen.firstTriangle; t < mesh.triangles.size(); ++t) {
    if (components.ofTriangle[t] == component) triangles.push_back(mesh.triangles[t]);
  }
  if (triangles.size() <= kMostFilled) {
    for (const Triangle& t : triangles)
      surface.triangles.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  }
  ViewOverlay::Lines outline{{}, selectedCellColour(), 2.5F, outlineColour()};
  const TriangleCorners corners(triangles);
  const Adjacency edges = findEdges(corners, mesh.vertices.size());
  for (Index e = 0; e < edges.edgeCount(); ++e) {
    const std::span<const Index> sides = edges.sidesOf(e);
    if (sides.size() == 1)
      outline.segments.push_back({mesh.vertices[corners.beginOf(sides[0])], mesh.vertices[corners.endOf(sides[0])]});
  }
  if (!surface.triangles.empty()) overlay.surfaces.push_back(std::move(surface));
  overlay.lines.push_back(std::move(outline));
  overlay.throughWalls = true;
  return overlay;
}

}  // namespace footfall::ui
