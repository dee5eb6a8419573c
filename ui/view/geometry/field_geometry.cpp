// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/geometry/field_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/vector.hpp"
#include "core/inspect/headroom.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

constexpr double kWallNormalZ = 0.02;          // as in render_geometry.cpp: steeper surfaces are walls
constexpr std::size_t kFieldPollEvery = 4096;  // triangles
constexpr int kRounds = 5;           // rounds of cutting where the height changes: an edge in four pieces each
constexpr double kInward = 0x1p-10;  // corners are sampled from inside their piece
constexpr std::size_t kPlaces = 4;   // samples of a piece: three corners and the middle
constexpr double kSameShare = 0.04;  // share of the scale: smaller differences cause no cut

/// A floor or a part of one.
struct Piece {
  std::array<Vec3, 3> corners;
  std::uint32_t source = 0;
};

struct Normal {
  double x, y, z, length;
};

Vec3 middleOf(const Vec3& a, const Vec3& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}; }

double squaredLength(const Vec3& a, const Vec3& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z);
}

Normal pieceNormal(const std::array<Vec3, 3>& p) {
  const auto [x, y, z] = detail::normalOf(p[0], p[1], p[2]);
  return {x, y, z, std::sqrt(x * x + y * y + z * z)};
}

std::vector<Piece> floorsOf(const Environment& environment, Poll poll) {
  std::vector<Piece> floors;
  for (std::size_t t = 0; t < environment.triangles.size(); ++t) {
    if (t % kFieldPollEvery == 0) poll();
    const Triangle& triangle = environment.triangles[t];
    Piece floor;
    for (std::size_t k = 0; k < 3; ++k) floor.corners[k] = environment.vertices[triangle[k]];
    floor.source = static_cast<std::uint32_t>(t);
    const Normal normal = pieceNormal(floor.corners);
    const double up = environment.bothSides ? std::abs(normal.z) : normal.z;
    if (up > kWallNormalZ * normal.length) floors.push_back(floor);
  }
  return floors;
}

/// Cuts the longest edge in its middle.
std::pair<Piece, Piece> halves(const Piece& piece) {
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (squaredLength(piece.corners[k], piece.corners[(k + 1) % 3]) >
        squaredLength(piece.corners[longest], piece.corners[(longest + 1) % 3]))
      longest = k;
  }
  const Vec3& a = piece.corners[longest];
  const Vec3& b = piece.corners[(longest + 1) % 3];
  const Vec3& c = piece.corners[(longest + 2) % 3];
  const Vec3 middle = middleOf(a, b);
  return {{{a, middle, c}, piece.source}, {{middle, b, c}, piece.source}};
}

double longestEdge(const Piece& piece) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, squaredLength(piece.corners[k], piece.corners[(k + 1) % 3]));
  return std::sqrt(longest);
}

/// Cuts all pieces larger than `edge`.
std::vector<Piece> cutTo(std::vector<Piece> pieces, double edge, std::size_t budget, Poll poll) {
  std::vector<Piece> small;
  small.reserve(pieces.size());
  std::size_t visited = 0;
  while (!pieces.empty()) {
    if (++visited % kFieldPollEvery == 0) poll();
    const Piece piece = pieces.back();
    pieces.pop_back();
    if (longestEdge(piece) <= edge || small.size() + pieces.size() >= budget) {
      small.push_back(piece);
      continue;
    }
    const auto [one, other] = halves(piece);
    pieces.push_back(one);
    pieces.push_back(other);
  }
  return small;
}

/// The free height at three corners and in the middle of each piece.
std::vector<float> heightsAbove(const HeadroomTree& tree, const std::vector<Piece>& pieces, double cap, Poll poll) {
  std::vector<Vec3> places;
  places.reserve(pieces.size() * kPlaces);
  for (const Piece& piece : pieces) {
    const auto& [a, b, c] = piece.corners;
    const Vec3 middle{a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3, a.z / 3 + b.z / 3 + c.z / 3};
    for (const Vec3& p : piece.corners) {
      places.push_back(
          {p.x + kInward * (middle.x - p.x), p.y + kInward * (middle.y - p.y), p.z + kInward * (middle.z - p.z)});
    }
    places.push_back(middle);
  }
  return headroomAt(tree, places, cap, poll);
}

void add(FieldGeometry& field, const Piece& piece, const std::array<float, 3>& values, const Vec3& centre) {
  Normal normal = pieceNormal(piece.corners);
  if (normal.z < 0) normal = {-normal.x, -normal.y, -normal.z, normal.length};
  FieldVertex vertex;
  const double length = normal.length > 0 ? normal.length : 1;
  vertex.normal = {static_cast<std::int8_t>(std::lround(normal.x / length * 127)),
                   static_cast<std::int8_t>(std::lround(normal.y / length * 127)),
                   static_cast<std::int8_t>(std::lround(normal.z / length * 127)), 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p = piece.corners[k];
    vertex.position = {static_cast<float>(p.x - centre.x), static_cast<float>(p.y - centre.y),
                       static_cast<float>(p.z - centre.z)};
    vertex.value = values[k];
    field.surface.push_back(vertex);
  }
  field.sources.push_back(piece.source);
}

}  // namespace

std::shared_ptr<const FieldGeometry> makeSlopeField(const Environment& environment, const Vec3& centre, Poll poll) {
  auto field = std::make_shared<FieldGeometry>();
  const std::vector<Piece> floors = floorsOf(environment, poll);
  field->surface.reserve(floors.size() * 3);
  for (std::size_t i = 0; i < floors.size(); ++i) {
    if (i % kFieldPollEvery == 0) poll();
    const Normal normal = pieceNormal(floors[i].corners);
    const double degrees = std::atan2(std::hypot(normal.x, normal.y), std::abs(normal.z)) * 180 / M_PI;
    const auto slope = static_cast<float>(degrees);
    add(*field, floors[i], {slope, slope, slope}, centre);
  }
  return field;
}

std::shared_ptr<const FieldGeometry> makeClearanceField(const std::shared_ptr<const Environment>& environment,
                                                        const Vec3& centre, double cap, std::size_t budget, Poll poll) {
  const HeadroomTree tree(environment, poll);
  auto field = std::make_shared<FieldGeometry>();
  std::vector<Piece> pieces = floorsOf(*environment, poll);
  double area = 0;
  for (const Piece& piece : pieces) area += pieceNormal(piece.corners).length / 2;
  // A quarter of the pieces forms an even net, so that no large change is missed; the others refine what the net finds.
  const double edge = std::sqrt(2 * area / (static_cast<double>(budget) / 4));
  pieces = cutTo(std::move(pieces), edge, std::max(budget / 2, pieces.size()), poll);
  std::size_t all = pieces.size();
  for (int round = 0; !pieces.empty(); ++round) {
    const std::vector<float> heights = heightsAbove(tree, pieces, cap, poll);
    std::vector<Piece> finer;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const float* const at = &heights[i * kPlaces];
      const auto [least, most] = std::minmax_element(at, at + kPlaces);
      if (round < kRounds && all + 3 <= budget && *most - *least > kSameShare * cap) {
        const auto [one, other] = halves(pieces[i]);
        for (const Piece& half : {one, other}) {
          const auto [first, second] = halves(half);
          finer.push_back(first);
          finer.push_back(second);
        }
        all += 3;
      } else {
        add(*field, pieces[i], {at[0], at[1], at[2]}, centre);
      }
    }
    pieces = std::move(finer);
  }
  return field;
}

}  // namespace footfall::ui
