// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/layers_text.hpp"

#include <cstddef>

#include "core/base/counted_text.hpp"
#include "footfall/inspect.hpp"

namespace footfall {

namespace {

std::string withBound(const std::string& text, std::size_t count, std::size_t least) {
  if (count == least) return text + " (as few as possible)";
  return text + " (at least " + std::to_string(least) + ')';
}

}  // namespace

std::string layersText(const NavigationMesh& mesh) {
  const std::string text = detail::counted(mesh.layerCount, "layer", "layers");
  return mesh.layerCount <= 1 ? text : withBound(text, mesh.layerCount, leastLayers(mesh));
}

std::string connectionsText(const NavigationMesh& mesh) {
  const std::size_t count = mesh.connections.size();
  const std::string text = detail::counted(count, "connection", "connections");
  return count <= 1 ? text : withBound(text, count, leastConnections(mesh));
}

}  // namespace footfall
