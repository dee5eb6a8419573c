// Any bytes as an OBJ file: an environment in order that reads back equal from its own text, or one line of error.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/base/number_text.hpp"
#include "core/io/obj_reader.hpp"
#include "footfall/environment.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::fuzz;

namespace {

const std::string kFile = "fuzz.obj";

/// Only what the reader kept, as plainly as OBJ can say it.
std::string plainText(const Environment& environment) {
  std::string text;
  for (const Vec3& v : environment.vertices) {
    text += "v";
    for (const double c : {v.x, v.y, v.z}) {
      text += ' ';
      appendNumber(text, c);
    }
    text += '\n';
  }
  for (const Triangle& t : environment.triangles) {
    text += "f";
    for (const std::uint32_t v : t) {
      text += ' ';
      appendNumber(text, v + 1);
    }
    text += '\n';
  }
  return text;
}

void requireInOrder(const Environment& environment) {
  for (const Vec3& v : environment.vertices)
    require(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z), "a coordinate is not finite");
  for (const Triangle& t : environment.triangles) {
    for (const std::uint32_t v : t) require(v < environment.vertices.size(), "an index is out of range");
    require(t[0] != t[1] && t[1] != t[2] && t[2] != t[0], "a triangle repeats a vertex");
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Environment environment;
  try {
    readObj(kFile, std::string(textOf(data, size)), environment, nullptr);
  } catch (const InputError& error) {
    requireGoodMessage(error.what(), kFile + ":");
    return 0;
  }
  requireInOrder(environment);
  Environment again;
  readObj(kFile, plainText(environment), again, nullptr);
  require(again.vertices == environment.vertices, "vertices change when they are written and read");
  require(again.triangles == environment.triangles, "triangles change when they are written and read");
  return 0;
}
