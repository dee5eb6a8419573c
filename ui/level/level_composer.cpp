// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/level_composer.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "footfall/edit.hpp"
#include "ui/base/text/core_text.hpp"

namespace footfall::ui {
namespace {

constexpr double kSpacingMetres = 0.4;  // distance of faces inside obstacles: no agent is lower

bool sameShape(const PlacedObstacle& a, const PlacedObstacle& b) {
  return a.shape == b.shape && a.base == b.base && a.size == b.size && a.turn == b.turn;
}

}  // namespace

LevelComposer::LevelComposer(Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &Document::levelChanged, this, [this] {
    parts_.setRules(document_.state().partRules);
    recompose();
  });
  connect(&parts_, &PartLevel::changed, this, &LevelComposer::recompose);
}

void LevelComposer::setLoaded(std::shared_ptr<const Environment> loaded,
                              std::shared_ptr<const EnvironmentGeometry> geometry) {
  base_ = nullptr;
  current_ = computed_ = {};
  parts_.setLoaded(std::move(loaded), std::move(geometry), document_.state().partRules);
  compose();
}

void LevelComposer::replaceLoaded(std::shared_ptr<const Environment> loaded, std::shared_ptr<const WholeBounds> whole) {
  parts_.replaceLoaded(std::move(loaded), std::move(whole), document_.state().partRules);
}

void LevelComposer::recompose() {
  const std::shared_ptr<const Environment> before = level();
  compose();
  if (level() && level() != before) emit edited(level());
}

void LevelComposer::compose() {
  if (parts_.base() != base_) {
    base_ = parts_.base();
    current_ = {base_, {}};
    computed_ = {};
  }
  if (!base_) return;
  const std::vector<PlacedObstacle>& wanted = document_.state().obstacles;
  if (holds(current_, wanted)) return;
  if (computed_.level && holds(computed_, wanted)) {
    current_ = computed_;
    return;
  }
  current_ = withObstacles(computed_.level ? computed_ : current_, wanted);
}

bool LevelComposer::holds(const Composed& composed, const std::vector<PlacedObstacle>& wanted) {
  return composed.placed.size() == wanted.size() && std::ranges::all_of(composed.placed, [&](const Placed& placed) {
           const auto found = std::ranges::find(wanted, placed.obstacle.id, &PlacedObstacle::id);
           return found != wanted.end() && sameShape(placed.obstacle, *found);
         });
}

LevelComposer::Composed LevelComposer::withObstacles(const Composed& from, const std::vector<PlacedObstacle>& wanted) {
  Composed next;
  std::vector<std::uint32_t> removed;
  auto triangles = static_cast<std::uint32_t>(base_->triangles.size());
  const auto place = [&](const PlacedObstacle& obstacle, std::uint32_t count) {
    next.placed.push_back({obstacle, {triangles, count}});
    triangles += count;
  };
  for (const auto& [obstacle, known] : from.placed) {
    const auto still = std::ranges::find(wanted, obstacle.id, &PlacedObstacle::id);
    if (still != wanted.end() && sameShape(*still, obstacle)) {
      place(*still, known.count);
    } else {
      for (std::uint32_t i = 0; i < known.count; ++i) removed.push_back(known.first + i);
    }
  }
  TriangleSoup added;
  const std::size_t kept = next.placed.size();
  for (const PlacedObstacle& obstacle : wanted) {
    const auto end = next.placed.begin() + static_cast<std::ptrdiff_t>(kept);
    if (std::any_of(next.placed.begin(), end, [&](const Placed& p) { return p.obstacle.id == obstacle.id; })) continue;
    TriangleSoup soup;
    try {
      soup = solidSoupOf(obstacle, kSpacingMetres / base_->metresPerUnit);
    } catch (const std::exception& error) {
      emit failed(coreText(error));
    }
    place(obstacle, static_cast<std::uint32_t>(soup.triangles.size()));
    const auto first = static_cast<std::uint32_t>(added.vertices.size());
    added.vertices.insert(added.vertices.end(), soup.vertices.begin(), soup.vertices.end());
    for (const Triangle& t : soup.triangles) added.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  const bool same = removed.empty() && added.triangles.empty();
  next.level = same ? from.level : editEnvironment(from.level, removed, added);
  return next;
}

void LevelComposer::setComputed(const std::shared_ptr<const Environment>& level) {
  if (level && level == current_.level) computed_ = current_;
}

LevelComposer::Triangles LevelComposer::trianglesOf(std::uint32_t obstacle) const {
  const auto found = std::ranges::find(current_.placed, obstacle, [](const Placed& p) { return p.obstacle.id; });
  return found == current_.placed.end() ? Triangles{} : found->triangles;
}

std::optional<std::uint32_t> LevelComposer::obstacleOf(std::uint32_t triangle) const {
  for (const auto& [obstacle, triangles] : current_.placed)
    if (triangle >= triangles.first && triangle - triangles.first < triangles.count) return obstacle.id;
  return std::nullopt;
}

}  // namespace footfall::ui
