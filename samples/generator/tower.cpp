// The stacked tower (thesis, 5.4, figure 33), which is hard for methods that only use the plan.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples.hpp"
#include "shapes.hpp"

namespace footfall::samples {

Mesh makeTower() {
  constexpr int kStoreys = 26;
  constexpr int kHeight = 1.75_m;
  Mesh mesh;
  for (int storey = 0; storey < kStoreys; ++storey) {
    mesh.group(std::string("storey_").append(std::to_string(storey + 1)));
    const int foot = storey * kHeight;
    // A step narrower every few storeys, and overhanging on changing sides.
    const int half = 8_m - storey / 4 * 0.75_m;
    const int shift = storey % 2 == 0 ? 0.5_m : -0.5_m;
    const Mesh::Frame frame(mesh, {0, 0, foot}, storey % 4 * kQuarterTurn);
    if (storey % 8 < 3 && storey < 25) {  // 10 whole boxes, 16 with a corner taken out: 440 triangles, 272 vertices
      box(mesh, {shift - half, -half, 0}, {shift + half, half, kHeight});
    } else {
      // The inner corner comes first: it alone sees all others.
      const int cut = half / 4;
      prism(mesh,
            {{shift + half - 2 * cut, half - 2 * cut, 0},
             {shift + half - 2 * cut, half, 0},
             {shift - half, half, 0},
             {shift - half, -half, 0},
             {shift + half, -half, 0},
             {shift + half, half - 2 * cut, 0}},
            kHeight);
    }
  }
  return mesh;
}

}  // namespace footfall::samples
