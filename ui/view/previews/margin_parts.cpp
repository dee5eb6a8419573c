// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/previews/margin_parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/view/geometry/surface_triangles.hpp"
#include "ui/view/previews/face_parts.hpp"

namespace footfall::ui {

using detail::ClearanceField;
using detail::FieldFeature;
using detail::FieldVector;

namespace {

constexpr std::size_t kMostParts = 4'000'000;
constexpr std::size_t kMostShown = 1'000'000;  // triangles
constexpr double kTurn = 0.28;                 // between tangents of an arc: their corners are 1 % farther than the arc
constexpr std::uint32_t kFacesPerPoll = 1024;

FieldVector planOf(const Vec3& p) { return {p.x, p.y}; }

}  // namespace

/// The triangles of one surface.
class MarginParts::Drawing {
 public:
  Drawing(const MarginParts& parts, const Paint& paint) : parts_(parts) { setPaint(vertex_, paint); }

  void reserve(std::size_t triangles) { geometry_->surface.reserve(3 * std::min(triangles, kMostShown)); }
  [[nodiscard]] bool isTooLarge() const { return geometry_->surface.size() / 3 > kMostShown; }
  /// Adds the places of a part from `low` to `high`.
  void add(const Part& part, double low, double high);
  [[nodiscard]] std::shared_ptr<const NavigationMeshGeometry> finish() const {
    const std::size_t count = geometry_->surface.size() / 3;
    return count == 0 || isTooLarge() ? nullptr : geometry_;
  }

 private:
  void cut(const Part& part, double low, double high);
  [[nodiscard]] SurfaceVertex vertexAt(const Vec3& p) const {
    SurfaceVertex vertex = vertex_;
    vertex.position = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    return vertex;
  }

  const MarginParts& parts_;
  std::shared_ptr<NavigationMeshGeometry> geometry_ = std::make_shared<NavigationMeshGeometry>();
  SurfaceVertex vertex_;
  ConvexCutter cutter_;
};

MarginParts::MarginParts(const NavigationMesh& mesh, double bound, const Vec3& centre, Poll poll) : bound_(bound) {
  const ClearanceField field(mesh, {bound}, poll);
  origin_ = field.surface().origin - FieldVector{centre.x, centre.y};
  // Bridges over gaps come behind the faces of the mesh, and are no floor.
  const auto faces = static_cast<std::uint32_t>(mesh.triangles.size());
  normals_.reserve(faces);
  FaceDivider divider(field, bound, poll);
  ConvexPolygon triangle;
  for (std::uint32_t face = 0; face < faces && !hasTooMany_; ++face) {
    if (face % kFacesPerPoll == 0) poll();
    const auto corners = cornersOf(mesh.vertices, mesh.triangles[face]);
    const Vec3 normal = unitNormal(*corners[0], *corners[1], *corners[2]);
    normals_.push_back({toByte(normal.x), toByte(normal.y), toByte(normal.z)});
    if (!field.surface().takesPart(face)) continue;
    triangle.clear();
    for (const Vec3* p : corners)
      triangle.add({p->x - field.surface().origin.x, p->y - field.surface().origin.y, p->z - centre.z});
    for (const FacePart& part : divider.divide(face, triangle)) addPart(face, part);
    hasTooMany_ = divider.hasTooMany() || parts_.size() > kMostParts;
  }
  if (hasTooMany_) {
    parts_ = {};
    corners_ = {};
  }
  std::ranges::stable_sort(parts_, {}, &Part::nearest);
  // Corners follow each other as their parts do: drawing reads them in the order of memory.
  std::vector<Corner> corners;
  corners.reserve(corners_.size());
  for (Part& part : parts_) {
    const auto first = corners_.begin() + part.firstCorner;
    part.firstCorner = static_cast<std::uint32_t>(corners.size());
    corners.insert(corners.end(), first, first + part.cornerCount);
  }
  corners_ = std::move(corners);
}

void MarginParts::addPart(std::uint32_t face, const FacePart& shape) {
  const FieldFeature& feature = *shape.feature;
  const ConvexPolygon& polygon = shape.polygon;
  Part part;
  part.face = face;
  part.isRound = feature.isCorner();
  part.sharedFrom = static_cast<float>(shape.sharedFrom);
  part.sharedTo = static_cast<float>(shape.sharedTo);
  part.direction = feature.inward;
  if (part.isRound && !look(part, polygon, feature.place)) return;
  const auto [nearest, farthest] = distancesOf(polygon, feature);
  if (!(nearest < bound_)) return;
  part.nearest = static_cast<float>(nearest);
  part.farthest = static_cast<float>(farthest);
  part.place = feature.place + origin_;
  part.firstCorner = static_cast<std::uint32_t>(corners_.size());
  part.cornerCount = static_cast<std::uint32_t>(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i)
    corners_.push_back({static_cast<float>(polygon[i].x + origin_.x), static_cast<float>(polygon[i].y + origin_.y),
                        static_cast<float>(polygon[i].z)});
  parts_.push_back(part);
}

bool MarginParts::look(Part& part, const ConvexPolygon& polygon, FieldVector corner) {
  FieldVector towards;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const FieldVector way = planOf(polygon[i]) - corner;
    const double length = lengthOf(way);
    if (length > 0) towards = towards + way * (1 / length);
  }
  const double length = lengthOf(towards);
  if (!(length > 0)) return false;
  part.direction = towards * (1 / length);
  double spread = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const FieldVector way = planOf(polygon[i]) - corner;
    if (lengthOf(way) > 0)
      spread = std::max(spread, std::fabs(std::atan2(cross(part.direction, way), dot(part.direction, way))));
  }
  part.spread = static_cast<float>(spread);
  part.cosine = static_cast<float>(std::cos(spread));
  return true;
}

void MarginParts::Drawing::cut(const Part& part, double low, double high) {
  const auto cutAt = [&](FieldVector direction, double distance, double sign) {
    const double offset = dot(part.place, direction) + distance;
    cutter_.cut([&](const Vec3& p) { return sign * (p.x * direction.x + p.y * direction.y - offset); });
  };
  if (part.nearest < low) cutAt(part.direction, low * part.cosine, 1);
  if (!(part.farthest > high)) return;
  const double spread = part.spread;
  const int tangents = std::max(1, static_cast<int>(std::ceil(2 * spread / kTurn)));
  if (tangents == 1) return cutAt(part.direction, high, -1);
  for (int i = 0; i < tangents; ++i) {
    const double angle = spread * ((2 * i + 1.0) / tangents - 1);
    cutAt(part.direction * std::cos(angle) + leftOf(part.direction) * std::sin(angle), high, -1);
  }
}

void MarginParts::Drawing::add(const Part& part, double low, double high) {
  ConvexPolygon& whole = cutter_.polygon();
  whole.clear();
  for (std::uint32_t i = 0; i < part.cornerCount; ++i) {
    const Corner& p = parts_.corners_[part.firstCorner + i];
    whole.add({p[0], p[1], p[2]});
  }
  cut(part, low, high);
  const ConvexPolygon& polygon = cutter_.polygon();
  if (polygon.size() < 3) return;
  for (std::size_t k = 0; k < 3; ++k) vertex_.normal[k] = parts_.normals_[part.face][k];
  const SurfaceVertex first = vertexAt(polygon[0]);
  SurfaceVertex last = vertexAt(polygon[1]);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const SurfaceVertex next = vertexAt(polygon[i]);
    geometry_->surface.insert(geometry_->surface.end(), {first, last, next});
    last = next;
  }
}

std::vector<MarginParts::Part>::const_iterator MarginParts::endOf(double high) const {
  return std::ranges::partition_point(parts_, [high](const Part& part) { return part.nearest < high; });
}

std::shared_ptr<const NavigationMeshGeometry> MarginParts::between(double low, double high, const Paint& paint) const {
  return draw(low, high, paint, [low](const Part& part) { return part.farthest > low; });
}

std::shared_ptr<const NavigationMeshGeometry> MarginParts::below(double low, double high, const Paint& paint) const {
  std::vector<char> isChanged(normals_.size(), 0);
  const auto end = endOf(high);
  for (auto part = parts_.begin(); part != end; ++part)
    if (part->farthest > low) isChanged[part->face] = 1;
  return draw(0, low, paint, [&](const Part& part) {
    const bool isShared = part.sharedFrom < low && low < part.sharedTo;
    const bool isBent = part.isRound && 2 * part.spread > kTurn && part.farthest > low;
    return (isShared || isBent) && isChanged[part.face] != 0;
  });
}

template <class IsWanted>
std::shared_ptr<const NavigationMeshGeometry> MarginParts::draw(double low, double high, const Paint& paint,
                                                                const IsWanted& isWanted) const {
  const auto end = endOf(high);
  std::size_t most = 0;
  for (auto part = parts_.begin(); part != end; ++part)
    if (isWanted(*part)) most += part->cornerCount - 2;
  Drawing drawing(*this, paint);
  drawing.reserve(most);
  for (auto part = parts_.begin(); part != end && !drawing.isTooLarge(); ++part)
    if (isWanted(*part)) drawing.add(*part, low, high);
  return drawing.finish();
}

}  // namespace footfall::ui
