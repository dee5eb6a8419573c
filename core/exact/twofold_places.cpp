// Rounds places by doubles of twice the length, where these decide all digits.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <cmath>
#include <optional>

#include "core/exact/error_twofold.hpp"
#include "core/exact/plan_kernel.hpp"
#include "core/exact/plan_predicates.hpp"

namespace footfall::detail {
namespace {

struct TwofoldContext {
  using T = ErrorTwofold;
  const SourceMesh& mesh;
  const std::vector<double>& scaledHeights;
  const std::array<std::vector<ErrorDouble>, 2>& scaledBorders;
  Index origin;

  T difference(Index a, Index b, int axis) const {
    return T::sum(coordinate(mesh.scaled[a], axis), -coordinate(mesh.scaled[b], axis));
  }
  T local(Index v, int axis) const { return difference(v, origin, axis); }
  T height(Index level) const { return level > 0 ? T(scaledHeights[level - 1]) : T(-scaledHeights[-level - 1]); }
  T localBorder(const PlanLine& border) const {
    const ErrorDouble& at = scaledBorders[border.a][border.b];
    return T::sum(at.value, -coordinate(mesh.scaled[origin], border.a), at.error);
  }
  T one() const { return 1.0; }
  const std::array<T, 3>& normal(Index t) const { return normals.of(*this, t); }

  mutable LatestNormals<T> normals{};
};

/// The exponent of the smallest double: scaled coordinates are exact on a grid that is no finer.
constexpr int kLeastExponent = -1074;

/// A product, a remainder or a bound that underflows loses at most 2^-1074. Scaled coordinates are below 2^38 and
/// formulas of places have degree 11 and fewer than 2^10 operations: later factors make that 2^-605 at most.
constexpr double kLostInProducts = 0x1p-600;
/// The same divided by a denominator, which is not below kLostInProducts.
constexpr double kLostInQuotients = 0x1p-450;

/// Adds a double to a number and rounds to the nearest double. Empty where that is not certain, and where the sum may
/// be a double itself. Rounding is monotone: when both ends of the interval round to `high`, so does all between.
std::optional<double> roundedSum(const ErrorTwofold& number, double base) {
  constexpr double kLeast = 0x1p-200;
  ErrorTwofold sum = number + ErrorTwofold(base);
  sum.error += kLostInQuotients;
  const double doubt = sum.error + std::fabs(sum.low) * 0x1p-52;  // of the additions below, too
  if (!(std::fabs(sum.low) > sum.error) || !(std::fabs(sum.high) > kLeast)) return std::nullopt;
  if (sum.high + (sum.low + doubt) != sum.high || sum.high + (sum.low - doubt) != sum.high) return std::nullopt;
  return sum.high;
}

}  // namespace

std::optional<Vec3> PlanKernel::placeByTwofolds(const PlanPoint& point, Index face,
                                                const std::array<std::optional<double>, 2>& known, bool isLevel) const {
  const int scale = mesh_->grid.scaleExponent();
  if (!std::isfinite(sign_.slack) || grid_.low + scale < kLeastExponent) return std::nullopt;
  const Index origin = mesh_->triangles[face][0];
  const Vec3& base = mesh_->scaled[origin];
  const TwofoldContext context{*mesh_, scaledHeights_, scaledBorders_, origin, {}};
  const PowerOfTwo toUnits(-scale);
  const auto h = rawHomogeneous(context, point);
  bool isCertain = true;
  const auto round = [&](ErrorTwofold numerator, ErrorTwofold denominator, double start) {
    numerator.error += kLostInProducts;
    denominator.error += kLostInProducts;
    const std::optional<double> rounded = roundedSum(numerator / denominator, start);
    const double result = rounded ? toUnits(*rounded) : 0;
    isCertain = isCertain && std::isnormal(result);  // no digit was lost
    return result;
  };
  Vec3 place = mesh_->vertices[origin];
  place.x = known[0] ? *known[0] : round(h[0], h[2], base.x);
  if (isCertain) place.y = known[1] ? *known[1] : round(h[1], h[2], base.y);
  if (isCertain && !isLevel) {
    const auto& n = context.normal(face);
    place.z = round(-(n[0] * h[0] + n[1] * h[1]), n[2] * h[2], base.z);
  }
  return isCertain ? std::optional(place) : std::nullopt;
}

}  // namespace footfall::detail
