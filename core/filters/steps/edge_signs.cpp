// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/edge_signs.hpp"

#include <utility>

#include "core/exact/face_geometry.hpp"

namespace footfall::detail {
namespace {

// More than the nearest double of a number up to 1 is off by.
constexpr double kMargin = 0x1p-50;

/// Where a linear function is zero that is `begin` at 0 and `end` at 1.
void setZero(const mpq_class& begin, const mpq_class& end, SignAlong& sign) {
  const double zero = nearestDouble(begin / (begin - end));
  sign.low = zero - kMargin;
  sign.high = zero + kMargin;
}

mpq_class valueOf(const std::array<mpz_class, 3>& line, const Homogeneous<mpz_class>& p) {
  mpq_class value(line[0] * p[0] + line[1] * p[1] + line[2] * p[2], p[2]);
  value.canonicalize();
  return value;
}

using Place = std::array<mpq_class, 3>;

mpq_class crossOf(const Place& a, const Place& b, const Place& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

}  // namespace

int EdgeSigns::sideAt(const PlanLine& line, Index face, const MeshVertex& p) {
  const SourceMesh& mesh = kernel_.mesh();
  if (line.kind == PlanLine::Edge) {
    const double slack = kernel_.sign().slack;
    const Vec3 &a = mesh.scaled[line.a], &b = mesh.scaled[line.b];
    if (const MaybeSign sign = filteredOrientation({a.x, a.y, slack}, {b.x, b.y, slack}, {p.x, p.y, p.error}, slack))
      return *sign;
  }
  return kernel_.side(line, face, p.point, mesh.triangles[p.face][0], fallbacks);
}

SignAlong EdgeSigns::ofLine(const BorderEdge& edge, const PlanLine& line, Index face) {
  SignAlong sign{sideAt(line, face, edge.begin), sideAt(line, face, edge.end)};
  sign.line = {line.kind, line.a, line.b, face};
  if (sign.changes()) {
    const Index origin = kernel_.mesh().triangles[edge.face][0];
    const auto coefficients = kernel_.exactCoefficients(line, face, origin);
    setZero(valueOf(coefficients, kernel_.exactHomogeneous(edge.begin.point, origin)),
            valueOf(coefficients, kernel_.exactHomogeneous(edge.end.point, origin)), sign);
  }
  return sign;
}

SignAlong EdgeSigns::inside(const BorderEdge& edge, Index triangle, int k) {
  const SourceMesh& mesh = kernel_.mesh();
  const auto& f = mesh.triangles[triangle];
  const Index a = mesh.planIds[f[k]], b = mesh.planIds[f[next(k)]];
  SignAlong sign = ofLine(edge, {PlanLine::Edge, std::min(a, b), std::max(a, b)}, -1);
  const int turn = a < b ? mesh.facing[triangle] : -mesh.facing[triangle];
  sign.begin *= turn;
  sign.end *= turn;
  return sign;
}

SignAlong EdgeSigns::leftOf(const BorderEdge& edge, const MeshVertex& from, const MeshVertex& to,
                            const std::array<Index, 2>& name) {
  const Index origin = kernel_.mesh().triangles[edge.face][0];
  const auto at = [&](const MeshVertex& p) {
    if (const MaybeSign sign = filteredOrientation({from.x, from.y, from.error}, {to.x, to.y, to.error},
                                                   {p.x, p.y, p.error}, kernel_.sign().slack))
      return *sign;
    return kernel_.orientation(from.point, to.point, p.point, origin, fallbacks);
  };
  SignAlong sign{at(edge.begin), at(edge.end)};
  constexpr Index kBetweenVertices = -2;  // no kind of line
  sign.line = {kBetweenVertices, std::min(name[0], name[1]), std::max(name[0], name[1]), -1};
  if (sign.changes()) {
    const auto placeOf = [&](const MeshVertex& v) { return kernel_.exactPosition(v.point, v.face); };
    const Place a = placeOf(from), b = placeOf(to);
    setZero(crossOf(a, b, placeOf(edge.begin)), crossOf(a, b, placeOf(edge.end)), sign);
  }
  return sign;
}

int EdgeSigns::orientation(const BorderEdge& edge, Index vertex) {
  const SourceMesh& mesh = kernel_.mesh();
  const Vec3& p = mesh.scaled[vertex];
  const MeshVertex &a = edge.begin, &b = edge.end;
  const double slack = kernel_.sign().slack;
  if (const MaybeSign sign = filteredOrientation({a.x, a.y, a.error}, {b.x, b.y, b.error}, {p.x, p.y, slack}, slack))
    return *sign;
  return kernel_.orientation(a.point, b.point, PlanPoint::source(mesh.planIds[vertex]), mesh.triangles[edge.face][0],
                             fallbacks);
}

int EdgeSigns::orientation(const BorderEdge& edge, const MeshVertex& vertex) {
  const MeshVertex &a = edge.begin, &b = edge.end;
  if (const MaybeSign sign = filteredOrientation({a.x, a.y, a.error}, {b.x, b.y, b.error},
                                                 {vertex.x, vertex.y, vertex.error}, kernel_.sign().slack))
    return *sign;
  return kernel_.orientation(a.point, b.point, vertex.point, kernel_.mesh().triangles[edge.face][0], fallbacks);
}

void EdgePieces::sort() {
  std::sort(zones_.begin(), zones_.end(),
            [](const Zone& a, const Zone& b) { return std::pair(a.low, a.line) < std::pair(b.low, b.line); });
}

std::vector<EdgePiece> common(const std::vector<EdgePiece>& a, const std::vector<EdgePiece>& b) {
  std::vector<EdgePiece> result;
  for (const EdgePiece& p : a)
    for (const EdgePiece& q : b)
      if (const EdgePiece both{std::max(p.begin, q.begin), std::min(p.end, q.end)}; !both.isEmpty())
        result.push_back(both);
  return result;
}

std::vector<EdgePiece> without(std::vector<EdgePiece> pieces, std::vector<EdgePiece> blocked) {
  std::sort(blocked.begin(), blocked.end(), [](const EdgePiece& a, const EdgePiece& b) { return a.begin < b.begin; });
  std::vector<EdgePiece> result;
  for (EdgePiece piece : pieces) {
    for (const EdgePiece& b : blocked) {
      if (b.end < piece.begin || b.begin > piece.end) continue;
      if (const EdgePiece left{piece.begin, b.begin}; !left.isEmpty()) result.push_back(left);
      piece.begin = std::max(piece.begin, b.end);
    }
    if (!piece.isEmpty()) result.push_back(piece);
  }
  return result;
}

}  // namespace footfall::detail
