// The content of a view of a level, and the intersection of lines of sight with it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>

#include "ui/view/camera/camera_pose.hpp"
#include "ui/view/scene/scene_picker.hpp"
#include "ui/view/scene/scene_renderer.hpp"

namespace footfall::ui {

/// Holds the environment, the result on it, cells and heat maps, and which parts of them are switched off or cut away.
/// It passes drawn content to a renderer. Rays are in the scene's coordinates: the environment's, relative to its
/// centre.
class ViewScene {
 public:
  /// The renderer must outlive this object.
  explicit ViewScene(SceneRenderer& renderer) : renderer_(renderer) {}

  /// Sets another environment, without content and cells.
  void setEnvironment(std::shared_ptr<const EnvironmentGeometry> environment);
  /// Sets an edit of the environment, with the same centre; content and cells stay.
  void replaceEnvironment(std::shared_ptr<const EnvironmentGeometry> environment);
  /// Sets the surroundings of the environment; null: none.
  void setBackdrop(BackdropPtr backdrop);
  void setContent(ViewContent content);
  /// Sets all parts except the mode and whether closed levels are opened, which have setters of their own.
  void setParts(const SceneParts& parts);
  void setMode(ViewMode mode) { parts_.mode = mode; }
  void setInside(bool on) { parts_.inside = on; }
  void setHeights(const HeightRange& heights) { heights_ = heights; }
  void setCutPlane(const std::optional<CutPlane>& cut) { cut_ = cut; }
  void setHiddenLayers(const std::set<std::uint32_t>& hidden);
  void setCells(std::shared_ptr<const CellGeometry> cells, CellColours colours);

  [[nodiscard]] const std::shared_ptr<const EnvironmentGeometry>& environment() const { return environment_; }
  [[nodiscard]] const BackdropPtr& backdrop() const { return backdrop_; }
  [[nodiscard]] const ViewContent& content() const { return content_; }
  [[nodiscard]] const SceneParts& parts() const { return parts_; }
  [[nodiscard]] const HeightRange& heights() const { return heights_; }
  [[nodiscard]] const std::optional<CutPlane>& cutPlane() const { return cut_; }
  [[nodiscard]] const std::set<std::uint32_t>& hiddenLayers() const { return hidden_; }
  [[nodiscard]] bool showsCells() const { return parts_.cells && cells_; }
  /// The scene's origin, in the environment's coordinates.
  [[nodiscard]] Vec3 centre() const { return environment_ ? environment_->centre : Vec3{}; }
  /// The space between the heights and the cut plane, in the scene's coordinates.
  [[nodiscard]] ShownSpace shown() const;

  // `viewDirection` is the direction of the camera, which decides whether covers are open.
  [[nodiscard]] std::optional<SurfacePoint> seenAlong(const Ray& ray, const QVector3D& viewDirection) const;
  /// The visible place, which may be on the backdrop.
  [[nodiscard]] std::optional<Vec3> placeAlong(const Ray& ray, const QVector3D& viewDirection) const;
  /// Empty where there is no cell, or none are shown.
  [[nodiscard]] std::optional<std::size_t> cellAlong(const Ray& ray, const QVector3D& viewDirection) const;
  /// The box is in the environment's coordinates.
  [[nodiscard]] std::optional<SceneBox> boundsOfCell(std::size_t cell) const;

 private:
  [[nodiscard]] PickedScene picked(const QVector3D& viewDirection) const;

  SceneRenderer& renderer_;
  std::shared_ptr<const EnvironmentGeometry> environment_;
  BackdropPtr backdrop_;
  ViewContent content_;
  SceneParts parts_;
  HeightRange heights_;
  std::optional<CutPlane> cut_;
  std::set<std::uint32_t> hidden_;
  std::shared_ptr<const CellGeometry> cells_;
};

}  // namespace footfall::ui
