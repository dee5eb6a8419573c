// Running filters in a test with one line, and measuring what comes out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/filters/apply_filter.hpp"

namespace footfall::test {
using namespace detail;

/// `filters` is a pipeline's text ("SlopeFilter 45\nVerticalClearanceFilter 2"). Does not use the runner, because tests
/// need the exact state.
StatePtr runFilters(std::shared_ptr<const Environment> environment, const std::string& filters);
/// Continues from a state.
StatePtr runFilters(StatePtr state, const std::string& filters);

/// "SlopeFilter 45 0" and "VerticalClearanceFilter h".
std::string minimalPipeline(double clearance, double slope = 45);

NavigationMesh navigationMesh(const StatePtr& state);

/// Parts of the product that hang together over edges with the same two vertex indices.
std::size_t countParts(const NavigationMesh& mesh);
/// Parts that hang together over vertex indices: what a reader finds who joins whatever shares a vertex.
std::size_t countPartsByVertex(const NavigationMesh& mesh);
/// Areas and lengths in plain doubles.
double area(const NavigationMesh& mesh);
double planArea(const NavigationMesh& mesh);
double obstacleLength(const NavigationMesh& mesh);
double connectionLength(const NavigationMesh& mesh);

/// The first thing in words that no product may have: indices out of range, a triangle that does not face up
/// (exactly), an edge with more than two triangles or with two on one side, an edge or connection that is no edge of
/// the mesh, lists of different lengths, a layer out of range. Empty when there is none.
std::string findMeshError(const NavigationMesh& mesh);

}  // namespace footfall::test
