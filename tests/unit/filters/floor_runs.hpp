// Runs of pipelines that leave a part of floors at height 0.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/pipeline/runner.hpp"
#include "footfall/pipeline.hpp"

namespace footfall::test {

/// The area in the plan of all triangles at height 0.
inline double floorArea(const NavigationMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    if (a.z == 0 && b.z == 0 && c.z == 0) sum += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  }
  return sum;
}

inline NavigationMesh run(const Environment& environment, const std::string& filters, int threads) {
  RunContext context;
  return *runPipeline(std::make_shared<Environment>(environment), parsePipeline(filters, "test"), context, nullptr,
                      threads)
              .mesh;
}

inline bool same(const NavigationMesh& a, const NavigationMesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles && a.obstacleEdges == b.obstacleEdges;
}

}  // namespace footfall::test
