// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh.hpp"

#include <cstdlib>

namespace footfall::samples {

namespace {

/// A multiple of 1/64 has at most six decimals: written exactly, without trailing zeros.
void appendMetres(std::string& text, int units) {
  if (units < 0) text += '-';
  const int size = std::abs(units);
  text += std::to_string(size / kUnitsPerMetre);
  int millionths = size % kUnitsPerMetre * (1000000 / kUnitsPerMetre);
  if (millionths == 0) return;
  text += '.';
  for (int digit = 100000; millionths != 0; digit /= 10) {
    text += static_cast<char>('0' + millionths / digit);
    millionths %= digit;
  }
}

}  // namespace

Mesh::Frame::Frame(Mesh& mesh, Point origin, int angle)
    : mesh_(mesh), outerOrigin_(mesh.origin_), outerAngle_(mesh.angle_) {
  mesh.origin_ = mesh.placed(origin);
  mesh.angle_ += angle;
}

Mesh::Frame::~Frame() {
  mesh_.origin_ = outerOrigin_;
  mesh_.angle_ = outerAngle_;
}

Point Mesh::placed(Point point) const {
  const Direction turn = direction(angle_);
  return origin_ + Point{scaled(point.x, turn.cos) - scaled(point.y, turn.sin),
                         scaled(point.x, turn.sin) + scaled(point.y, turn.cos), point.z};
}

void Mesh::group(std::string name) {
  if (!groups_.empty() && groups_.back().second == name) return;
  if (!groups_.empty() && groups_.back().first == triangles_.size()) groups_.pop_back();
  groups_.emplace_back(triangles_.size(), std::move(name));
}

int Mesh::vertex(Point point) {
  vertices_.push_back(placed(point));
  return static_cast<int>(vertices_.size()) - 1;
}

void Mesh::triangle(int a, int b, int c) { triangles_.push_back({a, b, c}); }

void Mesh::quad(int a, int b, int c, int d) {
  triangle(a, b, c);
  triangle(a, c, d);
}

void Mesh::polygon(const std::vector<Point>& corners) {
  const int first = static_cast<int>(vertices_.size());
  for (const Point& corner : corners) vertex(corner);
  for (int i = 2; i < static_cast<int>(corners.size()); ++i) triangle(first, first + i - 1, first + i);
}

std::string Mesh::obj(std::string_view description) const { return objHead(description) + objBody(0); }

std::string Mesh::objHead(std::string_view description) {
  std::string text = "# ";
  text += description;
  text += "\n# Y up, metres. Made by footfall-samples; GPL-3.0-or-later.\n";
  return text;
}

std::string Mesh::objBody(std::uint64_t vertices) const {
  std::string text;
  for (const Point& point : vertices_) {
    text += "v ";
    appendMetres(text, point.x);
    text += ' ';
    appendMetres(text, point.z);
    text += ' ';
    appendMetres(text, -point.y);
    text += '\n';
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    if (next < groups_.size() && groups_[next].first == i)
      text.append("g ").append(groups_[next++].second).append("\n");
    text += 'f';
    for (int corner : triangles_[i])
      text.append(" ").append(std::to_string(vertices + static_cast<std::uint64_t>(corner) + 1));
    text += '\n';
  }
  return text;
}

}  // namespace footfall::samples
