// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/export.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string_view>

#include "core/environment/number_text.hpp"

#ifndef FOOTFALL_VERSION
#define FOOTFALL_VERSION "unknown"
#endif

namespace footfall {
namespace {

/// One comment line for each line of `content`. A text of the user must neither end the comment early nor, by a
/// backslash at its end, pull the next line into it.
void appendComment(std::string& text, std::string_view label, std::string_view content) {
  while (!content.empty()) {
    const std::size_t stop = content.find('\n');
    text.append("# ").append(label);
    for (const char c : content.substr(0, stop)) text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    if (text.back() == '\\') text += ' ';
    text += '\n';
    content.remove_prefix(stop == std::string_view::npos ? content.size() : stop + 1);
  }
}

void appendHeader(std::string& text, const NavigationMesh& mesh, const Environment& environment,
                  const ExportHeader& header) {
  appendComment(text, "", "Walkable area by Footfall " FOOTFALL_VERSION);
  // The name alone: the same file gives the same bytes wherever it lies.
  std::string name = std::filesystem::path(environment.source).filename().string();
  std::replace(name.begin(), name.end(), '\n', ' ');
  appendComment(text, "source: ", name);
  appendComment(text, "pipeline: ", header.pipeline);
  appendComment(text, "agent: ", header.agent);
  std::string frame = environment.up == UpAxis::Y ? "Y up, " : "Z up, ";
  appendNumber(frame, environment.metresPerUnit);
  appendComment(text, "frame: ", frame + " metres per unit");
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
  appendComment(text, "content: ", counts + " obstacle edges");
}

void appendVertices(std::string& text, const NavigationMesh& mesh, UpAxis up) {
  for (const Vec3& p : mesh.vertices) {
    text += "v ";
    appendNumber(text, p.x);
    text += ' ';
    appendNumber(text, up == UpAxis::Y ? p.z : p.y);
    text += ' ';
    appendNumber(text, up == UpAxis::Y ? -p.y : p.z);
    text += '\n';
  }
}

/// A statement with vertex indices; OBJ counts from 1.
template <std::size_t Count>
void appendElement(std::string& text, char statement, const std::array<std::uint32_t, Count>& indices) {
  text += statement;
  for (const std::uint32_t index : indices) {
    text += ' ';
    appendNumber(text, std::uint64_t{index} + 1);
  }
  text += '\n';
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
  appendHeader(text, mesh, environment, header);
  appendVertices(text, mesh, environment.up);
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
