// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/steps/edge_signs.hpp"

#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/exact/face_geometry.hpp"
#include "core/exact/plan_predicates.hpp"
#include "core/exact/rounded_quotient.hpp"

namespace footfall::detail {
namespace {

// More than the rounding error of the nearest double of a number up to 1.
constexpr double kMargin = 0x1p-50;

IntegerView viewOf(const FixedInteger& x) { return x; }
IntegerView viewOf(const mpz_class& x) {
  const mpz_srcptr z = x.get_mpz_t();
  return {mpz_limbs_read(z), z->_mp_size};
}

void setZero(double zero, SignAlong& sign) {
  sign.low = zero - kMargin;
  sign.high = zero + kMargin;
}

/// The zero of a linear function that is value / weight at 0 and at 1, to the nearest double. Points and lines have the
/// widths of fixed_integer.hpp: value is below 2^(13D + 14) and weight below 2^(8D + 7). Both products together are
/// narrower than 21D + 23 bits, so FixedInteger holds them.
template <class T>
double zeroOf(const T& beginValue, const T& beginWeight, const T& endValue, const T& endWeight) {
  const T begin = beginValue * endWeight;
  const T difference = begin - T(endValue * beginWeight);
  return roundedQuotient(viewOf(begin), viewOf(difference), 0);
}

template <class T>
double zeroOf(const std::array<T, 3>& line, const Homogeneous<T>& begin, const Homogeneous<T>& end) {
  return zeroOf<T>(lineAtPoint<T>(line, begin), begin[2], lineAtPoint<T>(line, end), end[2]);
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

// n (p + h - a) over n_z, a being a corner of the triangle. Every factor is known to within an error: n to within that
// of the normal, the place to within its own and, for the sums, 2 u of what they are made of (u = 2^-53). A product
// adds u of itself, the two sums 2 u of everything.
int EdgeSigns::quickHeight(Index triangle, Index level, const MeshVertex& p) const {
  constexpr double kU = 0x1p-53;
  const SourceMesh& mesh = kernel_.mesh();
  const Vec3& a = mesh.scaled[mesh.triangles[triangle][0]];
  const auto& [nx, ny, nz] = mesh.normals[triangle];
  double raised = 0;
  if (level != 0) {
    const double height = std::ldexp(kernel_.heights()[std::abs(level) - 1], mesh.grid.scaleExponent());
    raised = level > 0 ? height : -height;
  }
  const double dx = p.x - a.x, dy = p.y - a.y, dz = p.z + raised - a.z;
  const double inPlan = p.error + (std::fabs(dx) + std::fabs(dy)) * (2 * kU);
  const double inHeight = p.error + (std::fabs(p.z) + std::fabs(raised) + std::fabs(a.z)) * (4 * kU);
  const double x = nx.value * dx, y = ny.value * dy, z = nz.value * dz;
  const double error =
      ((std::fabs(x) + std::fabs(y) + std::fabs(z)) * (8 * kU) + (std::fabs(nx.value) + std::fabs(ny.value)) * inPlan +
       std::fabs(nz.value) * inHeight + nx.error * (std::fabs(dx) + inPlan) + ny.error * (std::fabs(dy) + inPlan) +
       nz.error * (std::fabs(dz) + inHeight)) *
      kInflate;
  return -mesh.facing[triangle] * kernel_.sign()({x + y + z, error}).value_or(0);
}

SignAlong EdgeSigns::height(const BorderEdge& edge, Index triangle, Index face, Index level) {
  const PlanLine line{PlanLine::Trace, triangle, level};
  if (face != edge.face) return ofLine(edge, line, face);
  const auto at = [&](const MeshVertex& p) {
    const int quick = quickHeight(triangle, level, p);
    return quick != 0 ? quick : sideAt(line, face, p);
  };
  SignAlong sign{at(edge.begin), at(edge.end)};
  sign.line = {line.kind, line.a, line.b, face};
  return sign;
}

SignAlong EdgeSigns::ofLine(const BorderEdge& edge, const PlanLine& line, Index face) {
  SignAlong sign{sideAt(line, face, edge.begin), sideAt(line, face, edge.end)};
  sign.line = {line.kind, line.a, line.b, face};
  return sign;
}

void EdgeSigns::locate(const BorderEdge& edge, SignAlong& sign) const {
  if (!sign.changes() || sign.isLocated()) return;
  const PlanLine line{sign.line[0], sign.line[1], sign.line[2]};
  const Index face = sign.line[3], origin = kernel_.mesh().triangles[edge.face][0];
  const PlanPoint &begin = edge.begin.point, &end = edge.end.point;
  setZero(kernel_.fitsFixedIntegers()
              ? zeroOf(kernel_.fixedCoefficients(line, face, origin), kernel_.fixedHomogeneous(begin, origin),
                       kernel_.fixedHomogeneous(end, origin))
              : zeroOf(kernel_.exactCoefficients(line, face, origin), kernel_.exactHomogeneous(begin, origin),
                       kernel_.exactHomogeneous(end, origin)),
          sign);
}

void EdgeSigns::locate(const BorderEdge& edge, const MeshVertex& from, const MeshVertex& to, SignAlong& sign) const {
  if (!sign.changes() || sign.isLocated()) return;
  const Index origin = kernel_.mesh().triangles[edge.face][0];
  const auto placeOf = [&](const MeshVertex& v) { return kernel_.exactHomogeneous(v.point, origin); };
  const Homogeneous<mpz_class> a = placeOf(from), b = placeOf(to), begin = placeOf(edge.begin), end = placeOf(edge.end);
  setZero(zeroOf<mpz_class>(determinant<mpz_class>(a, b, begin), begin[2], determinant<mpz_class>(a, b, end), end[2]),
          sign);
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
  constexpr Index kBetweenVertices = -2;  // not a kind of line
  sign.line = {kBetweenVertices, std::min(name[0], name[1]), std::max(name[0], name[1]), -1};
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
