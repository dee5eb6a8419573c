// A project outside the tree that uses the installed library: one square floor through the default pipeline.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>

#include "core/environment/environment.hpp"
#include "core/pipeline/pipeline.hpp"
#include "core/pipeline/run_context.hpp"
#include "core/pipeline/runner.hpp"

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
