// The common case: three_lines LEVEL OUTPUT computes where an agent can walk in a level.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <exception>
#include <footfall/footfall.hpp>

int main(int count, char** arguments) {
  if (count != 3) return 2;
  try {
    footfall::Environment level = footfall::load(arguments[1]);
    footfall::NavigationMesh mesh = footfall::walkableArea(level, {.maxSlope = 45, .height = 2});
    footfall::save(mesh, arguments[2]);

    std::printf("Footfall %s: %zu walkable triangles in %u layers\n", footfall::version(), mesh.triangles.size(),
                mesh.layerCount);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
