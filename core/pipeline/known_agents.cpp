// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "footfall/agent.hpp"

namespace footfall {
namespace {

constexpr double kArea = Agent().minimumArea;
constexpr double kRiser = 0.22, kThreshold = 0.013, kOpening = 0.013, kJoint = 0.05, kShoulder = 0.27;

// Steps: what is built for who walks or rolls.
// - Stairs: Approved Document K to the Building Regulations 2010 of England (2013 edition), table 1.1: a riser of a
//   private stair is at most 220 mm, the most that the codes looked at allow (190 mm for other stairs there).
// - Wheels: 2010 ADA Standards for Accessible Design, 404.2.5: a threshold is at most 1/2 inch (13 mm); 405.2: a ramp
//   is at most 1 in 12 (4.76 degrees).
// - Robot: Boston Dynamics, "About Spot": 840 mm high standing, 500 mm wide, slopes up to 30 degrees, steps up to 300
//   mm.
// Gaps, seen from above:
// - Wheels: 2010 ADA Standards, 302.3: an opening in the floor lets no sphere of 1/2 inch (13 mm) pass.
// - Others: 50 mm, the default of StepFilter, for joints and floors that miss each other; no code allows people more.
// Radii: half of what they are wide.
// - People: Gordon et al., 1988 Anthropometric Survey of U.S. Army Personnel: men are 0.535 m broad at the shoulders
//   (bideltoid breadth, 95th percentile). A child, a cart, a giant and a crawler are ours.
// - Wheelchair: 2010 ADA Standards, 305.3: the clear floor space for one is 760 mm wide.
// Defaults of others, which have no number for gaps (voxels close those narrower than a cell or two):
// - Unity: the agent type Humanoid of a new project (ProjectSettings/NavMeshAreas.asset).
// - Unreal: the supported agent and NavMeshResolutionParams of RecastNavMesh in BaseEngine.ini, and AgentRadius of
//   ARecastNavMesh, in centimetres.
// - Godot 4: agent_height, agent_radius, agent_max_slope and agent_max_climb of NavigationMesh.
// - Recast: RecastDemo, Sample::resetCommonSettings().
constexpr std::array<KnownAgent, 11> kKnownAgents{{
    {"Human", {45, 2, kArea, kRiser, kJoint, kShoulder}},
    {"Child", {45, 1.2, kArea, kRiser, kJoint, 0.18}},
    {"Wheelchair", {5, 1.5, kArea, kThreshold, kOpening, 0.38}},
    {"Cart", {10, 1.2, kArea, kThreshold, kOpening, 0.3}},
    {"Giant", {45, 4, kArea, 0.8, 0.1, 1}},
    {"Crawler", {60, 0.5, kArea, 0.1, 0.02, 0.2}},
    {"Robot", {30, 0.84, kArea, 0.3, kJoint, 0.25}},
    {"Unity", {45, 2, kArea, 0.75, kJoint, 0.5}},
    {"Unreal", {44, 1.44, kArea, 0.35, kJoint, 0.34}},
    {"Godot", {45, 1.5, kArea, 0.25, kJoint, 0.5}},
    {"Recast", {45, 2, kArea, 0.9, kJoint, 0.6}},
}};

}  // namespace

std::span<const KnownAgent> knownAgents() { return kKnownAgents; }

}  // namespace footfall
