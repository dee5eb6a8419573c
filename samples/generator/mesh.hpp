// A triangle soup under construction, and its OBJ text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lengths.hpp"

namespace footfall::samples {

/// Z is up; units of 1/64 m.
struct Point {
  int x = 0, y = 0, z = 0;
  bool operator==(const Point&) const = default;
};

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

class Mesh {
 public:
  /// While one lives, points are given in a frame of their own: turned about Z, then moved. Frames nest. Turns other
  /// than quarter turns round to the grid, which bends sloped quads a little, as rounding in real files does.
  class Frame {
   public:
    Frame(Mesh& mesh, Point origin, int angle);
    ~Frame();
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

   private:
    Mesh& mesh_;
    Point outerOrigin_;
    int outerAngle_;
  };

  /// Starts a named group; an earlier group of that name is continued under a second heading.
  void group(std::string name);

  /// Adds a vertex, even where one lies already: objects share no vertices. Returns its index.
  int vertex(Point point);
  /// Counter-clockwise seen from the front.
  void triangle(int a, int b, int c);
  /// Triangles a b c and a c d.
  void quad(int a, int b, int c, int d);
  /// A polygon with vertices of its own, as a fan around its first corner.
  void polygon(const std::vector<Point>& corners);

  std::size_t triangleCount() const { return triangles_.size(); }
  std::size_t vertexCount() const { return vertices_.size(); }
  Point at(int vertex) const { return vertices_[vertex]; }
  std::array<int, 3> corners(std::size_t triangle) const { return triangles_[triangle]; }

  /// The OBJ text, Y up, metres: (x, y, z) is written as x, z, -y. `description` becomes its first comment.
  std::string obj(std::string_view description) const;
  /// Its two parts: comments, and all else behind `vertices` of other meshes in the same file.
  static std::string objHead(std::string_view description);
  std::string objBody(std::uint64_t vertices) const;

 private:
  Point placed(Point point) const;

  std::vector<Point> vertices_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<std::pair<std::size_t, std::string>> groups_;  // first triangle, name
  Point origin_;
  int angle_ = 0;
};

}  // namespace footfall::samples
