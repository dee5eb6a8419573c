// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/previews/edit_preview.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/vector.hpp"
#include "core/mesh/adjacency.hpp"
#include "footfall/filter_type.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/previews/headroom_preview.hpp"
#include "ui/view/previews/link_preview.hpp"
#include "ui/view/previews/margin_preview.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kTrianglesPerPoll = 4096;

struct ThresholdTriangle {
  double value = 0;  ///< the triangle changes sides where the threshold passes this value
  std::uint32_t triangle = 0;
};

/// Triangles in the order in which a moving threshold passes them.
class ThresholdOrder {
 public:
  ThresholdOrder(std::shared_ptr<const NavigationMesh> mesh, const std::vector<double>& values)
      : mesh_(std::move(mesh)) {
    order_.reserve(values.size());
    for (std::uint32_t t = 0; t < values.size(); ++t) order_.push_back({values[t], t});
    std::sort(order_.begin(), order_.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  }

  /// The triangles whose value is above `low` and not above `high`; none when they are too many to be previewed.
  [[nodiscard]] NavigationMesh between(double low, double high) const {
    const auto above = [](double limit, const ThresholdTriangle& t) { return limit < t.value; };
    const auto first = std::upper_bound(order_.begin(), order_.end(), low, above);
    const auto last = std::upper_bound(first, order_.end(), high, above);
    NavigationMesh soup;
    if (last - first > static_cast<std::ptrdiff_t>(kMostPreviewed)) return soup;
    for (auto it = first; it != last; ++it) {
      const auto base = static_cast<std::uint32_t>(soup.vertices.size());
      for (const std::uint32_t corner : mesh_->triangles[it->triangle])
        soup.vertices.push_back(mesh_->vertices[corner]);
      soup.triangles.push_back({base, base + 1, base + 2});
    }
    return soup;
  }

  [[nodiscard]] const std::shared_ptr<const NavigationMesh>& mesh() const { return mesh_; }

 private:
  std::shared_ptr<const NavigationMesh> mesh_;
  std::vector<ThresholdTriangle> order_;
};

Vec3 normalOfFace(const NavigationMesh& mesh, const Triangle& triangle) {
  return detail::normalOf(mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]);
}

EditPreview::Surfaces painted(const NavigationMesh& mesh, const Vec3& centre, const Paint& paint) {
  if (mesh.triangles.empty()) return {};
  return {makeMeshGeometry(mesh, centre, paint)};
}

/// SlopeFilter: whole faces appear and disappear by their angle.
class SlopePreview : public EditPreview {
 public:
  SlopePreview(const EditedStep& step, const Vec3& centre, Poll poll)
      : centre_(centre), order_(step.before, anglesOf(*step.before, poll)) {}

  [[nodiscard]] Surfaces changes(const Values& from, const Values& to) const override {
    if (to[0] < from[0])
      return painted(order_.between(to[0], from[0]), centre_, removalStyle(FilterType::Slope)->paint);
    return painted(order_.between(from[0], to[0]), centre_, walkablePaint());
  }
  [[nodiscard]] bool suits(const EditedStep& step) const override { return step.before == order_.mesh(); }

 private:
  static std::vector<double> anglesOf(const NavigationMesh& mesh, Poll poll) {
    std::vector<double> angles;
    angles.reserve(mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
      if (angles.size() % kTrianglesPerPoll == 0) poll();
      const Vec3 n = normalOfFace(mesh, triangle);
      angles.push_back(std::atan2(std::hypot(n.x, n.y), std::abs(n.z)) * 180 / std::numbers::pi);
    }
    return angles;
  }

  Vec3 centre_;
  ThresholdOrder order_;
};

/// AreaFilter: regions of the result disappear by their area. Only the run can compute which ones reappear, because
/// removed regions are not known.
class AreaPreview : public EditPreview {
 public:
  AreaPreview(const EditedStep& step, const Vec3& centre, Poll poll)
      : centre_(centre), order_(step.result, areasOfRegions(*step.result, poll)) {}

  [[nodiscard]] Surfaces changes(const Values& from, const Values& to) const override {
    return painted(order_.between(from[0], std::max(from[0], to[0])), centre_, removalStyle(FilterType::Area)->paint);
  }
  [[nodiscard]] bool suits(const EditedStep& step) const override { return step.result == order_.mesh(); }

 private:
  // The area of each triangle's region. Triangles are in one region when they share an edge; the result has separate
  // vertices on each side of an obstacle edge.
  static std::vector<double> areasOfRegions(const NavigationMesh& mesh, Poll poll) {
    Index count = 0;
    const std::vector<Index> region = findParts(mesh.triangles, mesh.vertices.size(), count, poll);
    poll();
    std::vector<double> areas(static_cast<std::size_t>(count), 0);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const Vec3 n = normalOfFace(mesh, mesh.triangles[t]);
      areas[region[t]] += std::hypot(n.x, n.y, n.z) / 2;
    }
    std::vector<double> ofRegion(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) ofRegion[t] = areas[region[t]];
    return ofRegion;
  }

  Vec3 centre_;
  ThresholdOrder order_;
};

}  // namespace

std::shared_ptr<const EditPreview> makeEditPreview(const EditedStep& step,
                                                   const std::shared_ptr<const Environment>& environment,
                                                   const Vec3& centre, Poll poll) {
  if (step.filter == FilterType::Slope && step.before) return std::make_shared<SlopePreview>(step, centre, poll);
  if (step.filter == FilterType::Area && step.result) return std::make_shared<AreaPreview>(step, centre, poll);
  if (step.filter == FilterType::VerticalClearance && step.before)
    return std::make_shared<HeadroomPreview>(step, environment, centre, poll);
  if (step.filter == FilterType::Step && step.result)
    return std::make_shared<LinkPreview>(step, *environment, centre, poll);
  if (step.filter == FilterType::Radius && step.before) return std::make_shared<MarginPreview>(step, centre, poll);
  return nullptr;
}

}  // namespace footfall::ui
