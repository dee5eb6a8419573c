// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/environment_text.hpp"

#include "core/base/counted_text.hpp"
#include "core/io/obj_text.hpp"

namespace footfall::detail {

std::string formatEnvironment(const Environment& environment) {
  std::string text;
  appendHeader(text, "Environment", environment.frame(), {},
               counted(environment.vertices.size(), "vertex", "vertices") + ", " +
                   counted(environment.triangles.size(), "triangle", "triangles"));
  for (const Vec3& p : environment.vertices) appendVertex(text, p, environment.up);
  for (const Triangle& t : environment.triangles) appendElement(text, 'f', t);
  return text;
}

}  // namespace footfall::detail
