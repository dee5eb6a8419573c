// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/export.hpp"

#include <cstddef>

#include "core/environment/obj_text.hpp"

namespace footfall {
namespace {

std::string countsOf(const NavigationMesh& mesh) {
  std::string counts;
  appendNumber(counts, mesh.vertices.size());
  counts += " vertices, ";
  appendNumber(counts, mesh.triangles.size());
  counts += " triangles, ";
  appendNumber(counts, mesh.layerCount);
  counts += " layers, ";
  appendNumber(counts, mesh.connections.size());
  counts += " connections, ";
  appendNumber(counts, mesh.obstacleEdges.size());
  return counts + " obstacle edges";
}

void appendTriangles(std::string& text, const NavigationMesh& mesh) {
  if (mesh.layers.empty()) {
    text += "g walkable\n";
    for (const Triangle& triangle : mesh.triangles) appendElement(text, 'f', triangle);
    return;
  }
  std::vector<std::vector<std::size_t>> members(mesh.layerCount);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) members.at(mesh.layers[i]).push_back(i);
  for (std::size_t layer = 0; layer < members.size(); ++layer) {
    text += "g layer_";
    appendNumber(text, layer);
    text += '\n';
    for (const std::size_t i : members[layer]) appendElement(text, 'f', mesh.triangles[i]);
  }
}

void appendLines(std::string& text, const char* group, const std::vector<std::array<std::uint32_t, 2>>& lines) {
  if (lines.empty()) return;
  text.append("g ").append(group).append("\n");
  for (const auto& line : lines) appendElement(text, 'l', line);
}

}  // namespace

std::string formatObj(const NavigationMesh& mesh, const Environment& environment, const ExportHeader& header) {
  std::string text;
  text.reserve(1024 + 64 * mesh.vertices.size() + 28 * mesh.triangles.size() +
               20 * (mesh.connections.size() + mesh.obstacleEdges.size()));
  appendHeader(text, "Walkable area", environment, header, countsOf(mesh));
  for (const Vec3& p : mesh.vertices) appendVertex(text, p, environment.up);
  appendTriangles(text, mesh);
  appendLines(text, "connections", mesh.connections);
  appendLines(text, "obstacle_edges", mesh.obstacleEdges);
  return text;
}

void writeObj(const std::string& path, const NavigationMesh& mesh, const Environment& environment,
              const ExportHeader& header) {
  writeFileSafely(path, formatObj(mesh, environment, header));
}

}  // namespace footfall
