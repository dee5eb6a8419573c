// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scene/view_scene.hpp"

#include <utility>

#include "core/base/vector.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

void ViewScene::setEnvironment(std::shared_ptr<const EnvironmentGeometry> environment) {
  environment_ = std::move(environment);
  renderer_.setEnvironment(environment_);
  setContent({});
  setCells(nullptr, {});
}

void ViewScene::replaceEnvironment(std::shared_ptr<const EnvironmentGeometry> environment) {
  environment_ = std::move(environment);
  renderer_.replaceEnvironment(environment_);
}

void ViewScene::setBackdrop(BackdropPtr backdrop) {
  backdrop_ = std::move(backdrop);
  renderer_.setBackdrop(backdrop_);
}

void ViewScene::setContent(ViewContent content) {
  content_ = std::move(content);
  renderer_.setContent(content_);
}

void ViewScene::setParts(const SceneParts& parts) {
  const ViewMode mode = parts_.mode;
  const bool inside = parts_.inside;
  parts_ = parts;
  parts_.mode = mode;
  parts_.inside = inside;
}

void ViewScene::setHiddenLayers(const std::set<std::uint32_t>& hidden) {
  hidden_ = hidden;
  renderer_.setHiddenLayers(hidden);
}

void ViewScene::setCells(std::shared_ptr<const CellGeometry> cells, CellColours colours) {
  cells_ = std::move(cells);
  renderer_.setCells(cells_, std::move(colours));
}

ShownSpace ViewScene::shown() const { return environment_ ? shownSpace(heights_, cut_, *environment_) : ShownSpace(); }

PickedScene ViewScene::picked(const QVector3D& viewDirection) const {
  return {*environment_, content_, hidden_, sceneRule(parts_, content_, environment_.get(), viewDirection),
          showsCells(),  shown()};
}

std::optional<SurfacePoint> ViewScene::seenAlong(const Ray& ray, const QVector3D& viewDirection) const {
  return environment_ ? pickSeen(ray, picked(viewDirection)) : std::nullopt;
}

std::optional<Vec3> ViewScene::placeAlong(const Ray& ray, const QVector3D& viewDirection) const {
  const std::optional<SurfacePoint> seen = seenAlong(ray, viewDirection);
  if (!backdrop_) return seen ? std::optional(seen->point) : std::nullopt;
  const bool backs = sceneRule(parts_, content_, environment_.get(), viewDirection).backs;
  const std::optional<double> met = meetBackdrop(ray, *backdrop_, shown(), backs);
  if (!met) return seen ? std::optional(seen->point) : std::nullopt;
  const Vec3 place = pointOn(ray, *met);
  const bool isBefore = seen && dot(seen->point - ray.origin, ray.direction) < dot(place - ray.origin, ray.direction);
  return isBefore ? seen->point : place;
}

std::optional<std::size_t> ViewScene::cellAlong(const Ray& ray, const QVector3D& viewDirection) const {
  if (!showsCells() || !environment_) return std::nullopt;
  const PickedScene scene = picked(viewDirection);
  ShownSpace space = scene.space;
  space.shows = shownTriangles(scene);
  return pickCell(ray, *environment_, *cells_, space);
}

std::optional<SceneBox> ViewScene::boundsOfCell(std::size_t cell) const {
  if (!cells_ || !environment_) return std::nullopt;
  return ui::boundsOfCell(*cells_, cell, environment_->centre);
}

}  // namespace footfall::ui
