// What a view shows of a level, and what a line of sight meets there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>

#include "ui/view/camera_pose.hpp"
#include "ui/view/scene_picker.hpp"
#include "ui/view/scene_renderer.hpp"

namespace footfall::ui {

/// The environment, the result on it, cells and heat maps, and what of them is switched off or cut away. What is drawn
/// goes on to a renderer. Rays are in the scene's coordinates: the environment's, from its centre.
class ViewScene {
 public:
  /// The renderer must outlive it.
  explicit ViewScene(SceneRenderer& renderer) : renderer_(renderer) {}

  /// Another environment, without content and cells.
  void setEnvironment(std::shared_ptr<const EnvironmentGeometry> environment);
  /// An edit of it, with the same centre; content and cells stay.
  void replaceEnvironment(std::shared_ptr<const EnvironmentGeometry> environment);
  /// What lies around the environment; null: nothing.
  void setBackdrop(BackdropPtr backdrop);
  void setContent(ViewContent content);
  /// All but the mode and whether one looks inside, which have setters of their own.
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
  /// What heights and cut plane leave, in the scene's coordinates.
  [[nodiscard]] ShownSpace shown() const;

  // While the camera looks along `viewDirection`, which decides what is open:
  [[nodiscard]] std::optional<SurfacePoint> seenAlong(const Ray& ray, const QVector3D& viewDirection) const;
  /// The place where the camera sees something, which may be of the backdrop.
  [[nodiscard]] std::optional<Vec3> placeAlong(const Ray& ray, const QVector3D& viewDirection) const;
  /// Nothing where there is no cell, or none are shown.
  [[nodiscard]] std::optional<std::size_t> cellAlong(const Ray& ray, const QVector3D& viewDirection) const;
  /// In the environment's coordinates.
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
