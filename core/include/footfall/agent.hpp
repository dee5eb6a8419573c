// The agent that walks, in metres and degrees, and the pipeline that computes its area.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "footfall/environment.hpp"
#include "footfall/pipeline.hpp"

namespace footfall {

/// An agent as a point of a given height.
struct Agent {
  double maxSlope = 45;  ///< degrees, above 0 and below 90: the steepest ground that it walks on
  double height = 2;     ///< metres, above 0: the free height that it needs
  /// Square metres, at least 0: connected parts that are no larger are left out.
  double minimumArea = 1;
  /// Metres, at least 0: how high it climbs at once, on stairs, kerbs, low walls. 0: it does not lift its feet.
  double step = 0.4;
  /// Metres, at least 0: how wide a gap it steps over, seen from above. 0: it steps where borders coincide.
  double gap = 0.05;
  /// Metres, at least 0: how far its middle stays away from walls and ledges. 0: it is as thin as a point.
  double radius = 0;
  /// Metres, at least 0: how deep it drops from a ledge, one way. 0: it drops nowhere.
  double drop = 0;
  bool operator==(const Agent&) const = default;
};

/// The default pipeline with the numbers of `agent`, turned into the environment's units by its metresPerUnit: weld
/// equal vertices, drop triangles without area, slope, clearance, steps (left out where it climbs none), radius
/// (left out where it has none), area, simplification, layers, drops (left out where it drops nowhere; they reach as
/// far outwards as DropFilter does by default, and with a radius over its margins above and below: 2.1 times the
/// radius, if that is more). For the default agent it is defaultPipeline(). Throws InputError when a number is out of
/// range.
Pipeline pipelineFor(const Environment& environment, const Agent& agent = {});

/// Throws InputError when a number is out of range, whatever the environment.
void checkAgent(const Agent& agent);

struct KnownAgent {
  std::string_view name;
  Agent agent;
};

/// Sizes of people and things that walk or roll ("Human", "Child", "Wheelchair", "Cart", "Giant", "Crawler", "Robot"),
/// and the defaults of other navigation tools ("Unity", "Unreal", "Godot", "Recast"), which use no minimum area and no
/// gap: those are Footfall's. core/pipeline/known_agents.cpp cites where the numbers come from.
std::span<const KnownAgent> knownAgents();

}  // namespace footfall
