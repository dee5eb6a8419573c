// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/layers_text.hpp"

#include "core/base/counted_text.hpp"
#include "footfall/inspect.hpp"

namespace footfall {

std::string layersText(const NavigationMesh& mesh) {
  const std::string text = detail::counted(mesh.layerCount, "layer", "layers");
  if (mesh.layerCount <= 1) return text;
  const std::uint32_t least = leastLayers(mesh);
  return text + (least == mesh.layerCount ? " (as few as possible)" : " (at least " + std::to_string(least) + ')');
}

}  // namespace footfall
