// Everything that other projects may include.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The common case:
//
//     footfall::Environment level = footfall::load("level.glb");
//     footfall::NavigationMesh mesh = footfall::walkableArea(level, {.maxSlope = 45, .height = 2});
//     footfall::save(mesh, "level.obj");
//
// Inside, Z is up and lengths are in the units of the file; Agent is in metres. Errors that a user can cause are
// InputError or RunError, and say what, where and what to do. Long calls take a RunContext, which cancels them from any
// thread and reports their progress; where it is a pointer, it may be null. All functions may be called from several
// threads at the same time; objects may be shared by threads that only read them. version.hpp says what is stable.
#pragma once

#include "footfall/agent.hpp"
#include "footfall/agent_list.hpp"
#include "footfall/body_path.hpp"
#include "footfall/compare.hpp"
#include "footfall/corridor_map.hpp"
#include "footfall/edit.hpp"
#include "footfall/environment.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "footfall/geometry.hpp"
#include "footfall/ground.hpp"
#include "footfall/inspect.hpp"
#include "footfall/io.hpp"
#include "footfall/navigation_mesh.hpp"
#include "footfall/parameter.hpp"
#include "footfall/path.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/place_verdict.hpp"
#include "footfall/plan_areas.hpp"
#include "footfall/report.hpp"
#include "footfall/run.hpp"
#include "footfall/run_context.hpp"
#include "footfall/statistics.hpp"
#include "footfall/text.hpp"
#include "footfall/up_axis.hpp"
#include "footfall/version.hpp"
#include "footfall/walkable_area.hpp"
