// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/height_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/number_text.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

double largestCoordinate(const SourceMesh& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.vertices) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return largest;
}

}  // namespace

std::shared_ptr<const PlanKernel> kernelWithHeight(const std::shared_ptr<const PlanKernel>& kernel, double height) {
  if (kernel->levelOf(height)) return kernel;
  std::vector<double> heights = kernel->heights();
  heights.push_back(height);
  return std::make_shared<PlanKernel>(kernel->sharedMesh(), std::move(heights));
}

double sufficientHeight(const SourceMesh& mesh, double height) {
  if (mesh.vertices.empty()) return height;
  const auto [low, high] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                                               [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
  const double extent = high->z - low->z;
  if (!std::isfinite(extent) || mesh.grid.empty()) return height;
  // Any would do: one that makes no number wider.
  if (extent == 0) return std::clamp(height, std::ldexp(1.0, mesh.grid.low), std::ldexp(1.0, mesh.grid.top));
  int exponent = 0;
  std::frexp(extent, &exponent);  // The extent is below 2^exponent, and not only after rounding: that is a double.
  return std::min(height, std::ldexp(1.0, exponent));
}

void checkHeight(const SourceMesh& mesh, double height, Pattern tooSmall) {
  Grid grid = mesh.grid;
  grid.include(height);
  constexpr int kMostAdded = 64;  // bits: a double of about the coordinates' step has 53
  if (mesh.grid.empty() || grid.width() <= std::max(kWidestFixedGrid, mesh.grid.width() + kMostAdded)) return;
  const auto shown = [](double x) {
    std::string text;
    appendNumber(text, x);
    return text;
  };
  constexpr int kDigits = std::numeric_limits<double>::digits;
  throw InputError(
      tooSmall, shown(height), shown(largestCoordinate(mesh)),
      shown(std::ldexp(1.0, std::min(mesh.grid.top - kWidestFixedGrid, mesh.grid.low - kMostAdded) + kDigits)));
}

}  // namespace footfall::detail
