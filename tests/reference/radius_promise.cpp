// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/radius_promise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/assembly/walkable_state.hpp"
#include "core/mesh/gap_bridges.hpp"
#include "tests/support/run_filters.hpp"

namespace footfall::reference {

RadiusTally& RadiusTally::operator+=(const RadiusTally& other) {
  near += other.near;
  far += other.far;
  between += other.between;
  onNeedles += other.onNeedles;
  doubtful += other.doubtful;
  wrong += other.wrong;
  reports.insert(reports.end(), other.reports.begin(), other.reports.end());
  return *this;
}

RadiusPromise::RadiusPromise(const NavigationMesh& before, std::size_t floors, const NavigationMesh& after,
                             const RadiusDistances& distances)
    : mesh_(before),
      floors_(floors),
      before_(before),
      after_(after),
      asked_(distances),
      radius_(std::max(distances.walls, distances.ledges)) {
  double sum = 0;
  for (std::size_t i = 0; i < floors; ++i) {
    const Triangle& t = before.triangles[i];
    const Vec3 &a = before.vertices[t[0]], &b = before.vertices[t[1]], &c = before.vertices[t[2]];
    sums_.push_back(sum += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  }
}

// A place that is nearer than the smaller distance by a walk that bends is nearer than that to the border at the bend.
void RadiusPromise::divide(const Environment& environment, double step, double height) {
  before_.divide(environment, step, height, floors_);
  const BorderKind larger = asked_.walls > asked_.ledges ? BorderKind::Wall : BorderKind::Ledge;
  bent_ = std::make_unique<BentDistance>(mesh_, before_, larger, 1.2 * radius_);
}

RadiusTally RadiusPromise::look(int places, std::mt19937& random) const {
  RadiusTally tally;
  if (floors_ == 0) return tally;
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < places; ++i) {
    const double a = share(random), b = share(random), c = share(random);
    lookAt(i % 3 == 0 ? anywhere(a, b, c) : nearBorder(a, b, c), tally);
  }
  return tally;
}

SurfacePlace RadiusPromise::anywhere(double which, double u, double v) const {
  const auto found = std::lower_bound(sums_.begin(), sums_.end(), which * sums_.back());
  const auto t = static_cast<std::uint32_t>(std::min<std::ptrdiff_t>(found - sums_.begin(), std::ssize(sums_) - 1));
  return inside(t, u, v);
}

SurfacePlace RadiusPromise::inside(std::uint32_t t, double u, double v) const {
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const auto& f = mesh_.triangles[t];
  const Vec3 &a = mesh_.vertices[f[0]], &b = mesh_.vertices[f[1]], &c = mesh_.vertices[f[2]];
  return {t, a.x + u * (b.x - a.x) + v * (c.x - a.x), a.y + u * (b.y - a.y) + v * (c.y - a.y)};
}

SurfacePlace RadiusPromise::nearBorder(double which, double along, double how) const {
  if (before_.borders().empty()) return anywhere(which, along, how);
  const auto number = static_cast<std::size_t>(which * static_cast<double>(before_.borders().size()));
  const BorderDistance::Border& border = before_.borders()[std::min(number, before_.borders().size() - 1)];
  const auto t = border.triangle;
  const int side = border.side;
  const SurfacePlace start = inside(t, 0.3, 0.3);
  const Vec3 &a = mesh_.vertices[mesh_.triangles[t][side]], &b = mesh_.vertices[mesh_.triangles[t][(side + 1) % 3]];
  const double x = a.x + along * (b.x - a.x), y = a.y + along * (b.y - a.y);
  // The walk goes from inside the triangle to a place by the border, and from there in some direction.
  const SurfacePlace there{t, x + 1e-3 * (start.x - x), y + 1e-3 * (start.y - y)};
  const double angle = 7919 * along, length = 1.6 * how * radius_;
  const BorderDistance::Walk way =
      before_.walk(there, there.x + length * std::cos(angle), there.y + length * std::sin(angle));
  return way.isDoubtful ? there : way.end;  // A walk over a needle can reach a place that is not on the triangle there.
}

void RadiusPromise::lookAt(const SurfacePlace& place, RadiusTally& tally) const {
  constexpr double kRounding = 1e-9;      // error of the doubles of the two products, for coordinates of about 10
  if (place.triangle >= floors_) return;  // The place is above a gap.
  if (before_.isNeedle(place.triangle)) {
    ++tally.onNeedles;
    return;
  }
  const bool isLeft = after_.find(place.x, place.y, before_.height(place), 1e-6).has_value();
  const double slack = (bent_ ? BentDistance::kError : kRounding) * (1 + radius_);
  const Nearest certain = nearestTo(place, false), possible = nearestTo(place, true);
  const auto isNear = [&](const std::optional<double>& d, double asked) { return d && *d < asked - slack; };
  const auto isFar = [&](const std::optional<double>& d, double asked) {
    return !d || *d > (1 + asked_.tolerance) * asked + slack;
  };
  // A place on a border that keeps nothing away is on either side of it.
  const auto isOn = [&](const std::optional<double>& d) { return d && *d < slack; };
  if ((asked_.walls == 0 && isOn(possible.wall)) || (asked_.ledges == 0 && isOn(possible.ledge))) {
    ++tally.between;
  } else if (isNear(certain.wall, asked_.walls) || isNear(certain.ledge, asked_.ledges)) {
    ++tally.near;
    if (isLeft) tell("left", place, certain, tally);
  } else if (possible.isDoubtful) {
    ++tally.doubtful;
  } else if (isFar(possible.wall, asked_.walls) && isFar(possible.ledge, asked_.ledges)) {
    ++tally.far;
    if (!isLeft) tell("removed", place, possible, tally);
  } else {
    ++tally.between;
  }
}

// Walls need not be found if the distances are equal.
RadiusPromise::Nearest RadiusPromise::nearestTo(const SurfacePlace& place, bool orDoubtful) const {
  const double most = 1.2 * radius_;
  if (asked_.areEqual()) {
    const auto [distance, isDoubtful] = before_.at(place, most, orDoubtful);
    return {distance, distance, isDoubtful};
  }
  const auto at = [&](BorderKind kind, bool isLarger) {
    return isLarger ? bent_->at(place, orDoubtful) : before_.at(place, most, kind, orDoubtful);
  };
  const auto wall = at(BorderKind::Wall, asked_.walls > asked_.ledges);
  const auto ledge = at(BorderKind::Ledge, asked_.walls < asked_.ledges);
  return {wall.least, ledge.least, wall.isDoubtful || ledge.isDoubtful};
}

void RadiusPromise::tell(const char* what, const SurfacePlace& place, const Nearest& nearest,
                         RadiusTally& tally) const {
  if (++tally.wrong > 4) return;
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), "%s: %.17g %.17g %.17g, wall at %.17g of %g, ledge at %.17g of %g", what,
                place.x, place.y, before_.height(place), nearest.wall.value_or(-1), asked_.walls,
                nearest.ledge.value_or(-1), asked_.ledges);
  tally.reports.emplace_back(text.data());
}

NavigationMesh bridged(const NavigationMesh& mesh) {
  NavigationMesh result = detail::withBridges(mesh);
  std::erase_if(result.links, [](const StepLink& link) { return link.kind == StepKind::Gap; });
  return result;
}

RadiusCase::RadiusCase(const std::shared_ptr<const Environment>& environment, const std::string& before,
                       const RadiusDistances& distances, MeasuredArea measured) {
  std::array<char, 200> filter{};
  std::snprintf(filter.data(), filter.size(), "\nRadiusFilter %.17g %.17g %.17g\n", distances.walls, distances.ledges,
                distances.tolerance);
  const test::StatePtr state = test::runFilters(environment, before);
  // The order of several gaps at one edge decides which has the bridge: the area must have the triangles that the
  // filter has.
  NavigationMesh floors = test::navigationMesh(state);
  if (measured == MeasuredArea::Simplified ||
      std::any_of(floors.links.begin(), floors.links.end(),
                  [](const StepLink& link) { return link.kind == StepKind::Gap; }))
    floors = test::navigationMesh(test::runFilters(state, "SimplificationFilter"));
  all_ = bridged(floors);
  left_ = test::navigationMesh(test::runFilters(environment, before + filter.data()));
  error_ = test::findMeshError(left_);
  promise_ = std::make_unique<RadiusPromise>(all_, floors.triangles.size(), left_, distances);
  if (!distances.areEqual()) promise_->divide(*environment, state->step, state->clearance);
}

RadiusTally RadiusCase::look(int places, std::mt19937& random) const {
  if (error_.empty()) return promise_->look(places, random);
  RadiusTally broken;
  broken.wrong = 1;
  broken.reports.push_back(error_);
  return broken;
}

RadiusTally lookAtRadius(const std::shared_ptr<const Environment>& environment, const std::string& before,
                         const RadiusDistances& distances, int places, std::mt19937& random, MeasuredArea measured) {
  return RadiusCase(environment, before, distances, measured).look(places, random);
}

}  // namespace footfall::reference
