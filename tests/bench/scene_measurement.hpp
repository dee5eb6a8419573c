// Measures scenes as people have them: the default pipeline, the grid of coordinates, a radius, and levels that
// somebody turned.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "footfall/environment.hpp"
#include "tests/bench/sampling.hpp"
#include "tests/bench/subject.hpp"

namespace footfall::bench {

/// The radius of the rows with a radius, in metres.
inline constexpr double kSceneRadius = 0.3;
/// How deep agents drop in the rows with drops, in metres.
inline constexpr double kSceneDrop = 1.5;
/// The angle by which environments are turned, in degrees.
inline constexpr double kTurnDegrees = 17;

enum class SceneFilters {
  Default,      ///< the default pipeline, with steps and gaps
  WithoutSteps  ///< the default pipeline without StepFilter, as it is measured beside Recast
};

struct SceneRun {
  std::string key;  ///< under which its figures stand
  SceneFilters filters = SceneFilters::Default;
  GridChoice grid = GridChoice::Auto;
  double radius = 0;  ///< metres; 0 for none
  double drop = 0;    ///< metres; 0 for none
  int threads = 1;
};

/// Runs that are compared take turns. For each run's key gives `wall_ms` and `cpu_ms` (the least of all rounds, from
/// the loaded environment to the navigation mesh), `exact_decisions`, `square_metres` and `share` (of random pairs of
/// places that are connected); also `triangles` and `grid_step` of the file as import reads it by default. To be run
/// isolated.
Json measureSceneRuns(const Subject& subject, const std::vector<SceneRun>& runs, const Repetition& repetition);

/// Loads the scene and runs the default pipeline once: `peak_bytes` of the process. To be run isolated.
Json measureScenePeak(const Subject& subject, int threads);

/// Turns the environment by kTurnDegrees about the vertical, and runs the default pipeline on one thread on the
/// `original`, on the turned one `on` the grid and on the turned one `off` it, in turns: the figures of
/// measureSceneRuns() for each; also `triangles`, and `welded` and `split` (of the turned one on the grid). To be run
/// isolated.
Json measureTurned(const Subject& subject, const Repetition& repetition);

/// Writes a generated scene of at least so many triangles as OBJ. `kind` is one of sceneKinds(). Throws
/// std::runtime_error.
void writeScene(const std::string& kind, std::uint64_t triangles, const std::string& path);
std::vector<std::string> sceneKinds();

}  // namespace footfall::bench
