// Any bytes as a PLY file (the first byte is p) or an STL file: an environment in order, or one line of error. Through
// Assimp, whose own mistakes show as its library on top of the stack; what it has for other formats hangs or writes
// where it must not within seconds, and is left out (README.md).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <new>

#include "core/io/import.hpp"
#include "tests/fuzz/fuzz_folder.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::fuzz;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const FuzzFolder folder;
  if (size == 0) return 0;
  const std::string path = folder.write(data[0] == 'p' ? "fuzz.ply" : "fuzz.stl", textOf(data + 1, size - 1));
  try {
    const auto environment = importEnvironment(path);
    require(!environment->triangles.empty(), "an environment without triangles was accepted");
    for (const Vec3& v : environment->vertices)
      require(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z), "a coordinate is not finite");
    for (const Triangle& t : environment->triangles)
      for (const std::uint32_t v : t) require(v < environment->vertices.size(), "an index is out of range");
  } catch (const InputError& error) {
    requireGoodMessage(error.what(), path);
  } catch (const std::bad_alloc&) {  // Assimp believes counts in files
  }
  return 0;
}
