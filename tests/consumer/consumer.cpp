// A project outside the tree that uses the installed library: one square floor through the default pipeline.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <footfall/run.hpp>
#include <memory>

int main() {
  auto environment = std::make_shared<footfall::Environment>();
  environment->vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  environment->triangles = {{0, 1, 2}, {0, 2, 3}};
  footfall::RunContext context;
  const footfall::RunResult result =
      footfall::runPipeline(environment, footfall::defaultPipeline(*environment), context);
  std::printf("Footfall %s: %zu walkable triangles\n", FOOTFALL_VERSION, result.mesh->triangles.size());
  return result.mesh->triangles.size() == 2 ? 0 : 1;
}
