// The benchmark of scenes as people have them, and of levels that somebody turned.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/benchmark.hpp"

namespace footfall::bench {

/// Measures the given scenes, one generated scene of each kind, and the levels to turn, with progress on standard
/// error. The result has
/// - `scenes`: a list; each with `name`, `group` ("file" or "generated"), and `runs` of measureSceneRuns()
/// (`triangles`,
///   `grid_step`; `default_1`, `default_2`: the default pipeline on one thread and on two; `plain`: without steps, one
///   thread; `radius`: the same with kSceneRadius; `on`, `off`: as `plain`, on the usual grid and without any);
///   `radius_drops` of the same, with `default_1` alone, which has kSceneRadius and kSceneDrop; `peak` of
///   measureScenePeak() on two threads; `recast`: `plain` and `radius`, each a list with one entry a cell size (`cell`)
///   of measureRecast(), or null without Recast;
/// - `turned`: a list; each with `name`, and what measureTurned() says.
/// Whatever cannot be measured has `fails` with the reason in the place of its figures.
Json measureScenes(const BenchmarkOptions& options);

}  // namespace footfall::bench
