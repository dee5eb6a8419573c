// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/previews/link_preview.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/triangle_tree.hpp"
#include "core/base/vector.hpp"
#include "ui/view/scene/scene_picker.hpp"

namespace footfall::ui {
namespace {

constexpr double kLinkReach = 2;    // factor on the values of the run
constexpr double kOpposite = -0.5;  // cosine of edges that face each other
constexpr double kSame = 1e-6;      // share of the step: borders that are nearer form a seam, and no step
constexpr double kShortest = 1e-3;  // share of the step: shorter stretches are invisible
constexpr double kStrip = 0.15;     // share of the step
constexpr double kRounded = 1e-9;   // share of a value by which rounding may move a link beyond it
constexpr std::size_t kMostLinkPairs = 1'000'000;

Vec3 middleOf(const Vec3& a, const Vec3& b) { return 0.5 * (a + b); }

/// Finds obstacles between two floors at a height.
class Obstacles {
 public:
  Obstacles(const Environment& environment, Poll poll) : environment_(environment) {
    std::vector<Box> boxes;
    std::vector<std::int32_t> ids;
    for (std::size_t t = 0; t < environment.triangles.size(); ++t) {
      ids.push_back(static_cast<std::int32_t>(t));
      const std::array<Vec3, 3> p = cornersOf(t);
      boxes.push_back(boxAround({p[0], p[1], p[2]}, 0, 0));
    }
    tree_.build(boxes, ids, poll);
  }

  [[nodiscard]] bool stand(const Vec3& from, const Vec3& to) {
    const Ray ray{from, to - from};
    bool found = false;
    tree_.visitOverlapping(boxAround({from, to}, 0, 0), stack_, [&](std::int32_t id) {
      const std::optional<double> met = meet(ray, cornersOf(static_cast<std::size_t>(id)));
      found = met && *met <= 1;
      return !found;
    });
    return found;
  }

 private:
  [[nodiscard]] std::array<Vec3, 3> cornersOf(std::size_t t) const {
    const Triangle& corners = environment_.triangles[t];
    return {environment_.vertices[corners[0]], environment_.vertices[corners[1]], environment_.vertices[corners[2]]};
  }

  const Environment& environment_;
  TriangleTree tree_;
  std::vector<std::int32_t> stack_;
};

}  // namespace

bool LinkPreview::Pair::fits(const Values& values) const {
  return height <= values[0] * (1 + kRounded) && width <= values[1] + kRounded * values[0];
}

LinkPreview::LinkPreview(const EditedStep& step, const Environment& environment, const Vec3& centre, Poll poll)
    : result_(step.result),
      centre_(centre),
      values_(step.values),
      limits_{kLinkReach * step.values[0], std::max(kLinkReach * step.values[1], step.values[0])},
      strip_(kStrip * step.values[0]) {
  const auto at = [this](std::uint32_t vertex) { return result_->vertices[vertex]; };
  for (const StepLink& link : result_->links)
    links_.push_back({{at(link.from[0]), at(link.from[1])}, {at(link.to[1]), at(link.to[0])}, link.height, link.width});
  findPairs(environment, poll);
}

// The stretch on which two borders run beside each other, with the first one's inside on its left.
std::optional<LinkPreview::Pair> LinkPreview::pairOf(const PreviewBorder& a, const PreviewBorder& b) {
  if (dot(a.along, b.along) > kOpposite) return std::nullopt;
  const double first = dot(b.to - a.from, a.along), last = dot(b.from - a.from, a.along);
  const double begin = std::max(0.0, first), end = std::min(a.size, last);
  if (!(end > begin)) return std::nullopt;
  Pair pair;
  for (const std::size_t i : {0U, 1U}) {
    const double way = i == 0 ? begin : end;
    pair.first[i] = a.from + (way / a.size) * (a.to - a.from);
    pair.second[i] = b.to + ((way - first) / (last - first)) * (b.from - b.to);
  }
  const Vec3 across = middleOf(pair.second[0], pair.second[1]) - middleOf(pair.first[0], pair.first[1]);
  pair.height = std::abs(across.z);
  pair.width = std::max(0.0, -dot(across, a.inward));
  // The other border is on the outer side.
  if (dot(across, a.inward) > kSame * (1 + pair.height)) return std::nullopt;
  return pair;
}

void LinkPreview::findPairs(const Environment& environment, Poll poll) {
  const std::vector<PreviewBorder> borders = findBorders(*result_, poll);
  std::vector<Box> boxes;
  std::vector<std::int32_t> ids;
  for (const PreviewBorder& border : borders) {
    ids.push_back(static_cast<std::int32_t>(ids.size()));
    boxes.push_back(boxAround({border.from, border.to}, 0, 0));
  }
  TriangleTree tree;
  tree.build(boxes, ids, poll);
  Obstacles obstacles(environment, poll);
  const double step = values_[0];
  std::vector<std::int32_t> stack;
  for (std::size_t i = 0; i < borders.size(); ++i) {
    poll();
    const PreviewBorder& a = borders[i];
    tree.visitOverlapping(boxAround({a.from, a.to}, limits_[1] + kSame * step, limits_[0]), stack,
                          [&](std::int32_t id) {
                            const auto j = static_cast<std::size_t>(id);
                            if (j <= i) return true;
                            const std::optional<Pair> pair = pairOf(a, borders[j]);
                            if (!pair || pair->height > limits_[0] || pair->width > limits_[1]) return true;
                            if (pair->height <= kSame * step && pair->width <= kSame * step) return true;
                            if (length(pair->first[1] - pair->first[0]) < kShortest * step) return true;
                            Vec3 from = middleOf(pair->first[0], pair->first[1]) + kShortest * step * a.inward;
                            Vec3 to = middleOf(pair->second[0], pair->second[1]) - kShortest * step * a.inward;
                            from.z = to.z = std::max(from.z, to.z) + step;
                            if (!obstacles.stand(from, to)) others_.push_back(*pair);
                            return true;
                          });
    if (others_.size() <= kMostLinkPairs) continue;
    others_.clear();
    limits_ = values_;
    return;
  }
}

bool LinkPreview::suits(const EditedStep& step) const { return step.result == result_ && step.values == values_; }

// The way over each link, and a strip on both floors, so that steps are visible from above and from both sides.
EditPreview::Surfaces LinkPreview::painted(const std::vector<const Pair*>& pairs, const Paint& paint) const {
  if (pairs.empty() || 12 * pairs.size() > kMostPreviewed) return {};
  NavigationMesh soup;
  const auto addQuad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto base = static_cast<std::uint32_t>(soup.vertices.size());
    for (const Vec3& p : {a, b, c, d}) soup.vertices.push_back(p);
    for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{2, 1, 0}, Triangle{3, 2, 0}})
      soup.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  };
  for (const Pair* pair : pairs) {
    addQuad(pair->first[0], pair->first[1], pair->second[1], pair->second[0]);
    Vec3 along = pair->first[1] - pair->first[0];
    along.z = 0;
    const double size = length(along);
    if (!(size > 0)) continue;
    const Vec3 inward = strip_ / size * Vec3{-along.y, along.x, 0};
    addQuad(pair->first[0], pair->first[1], pair->first[1] + inward, pair->first[0] + inward);
    addQuad(pair->second[0], pair->second[1], pair->second[1] - inward, pair->second[0] - inward);
  }
  return {makeMeshGeometry(soup, centre_, paint)};
}

EditPreview::Surfaces LinkPreview::changes(const Values& from, const Values& to) const {
  if (from != values_ || to[0] > limits_[0] || to[1] > limits_[1]) return {};
  std::vector<const Pair*> steps, gaps, gone;
  for (const Pair& pair : others_)
    if (pair.fits(to) && !pair.fits(from)) (pair.width > kSame * values_[0] ? gaps : steps).push_back(&pair);
  for (const Pair& link : links_)
    if (!link.fits(to)) gone.push_back(&link);
  Surfaces surfaces;
  for (const auto& [pairs, paint] : {std::pair{&steps, Paint{stepColour()}}, std::pair{&gaps, Paint{gapColour()}},
                                     std::pair{&gone, Paint{obstacleEdgeColour(), FillPattern::RisingStripes}}})
    for (const auto& surface : painted(*pairs, paint)) surfaces.push_back(surface);
  return surfaces;
}

}  // namespace footfall::ui
