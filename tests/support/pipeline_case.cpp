// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/pipeline_case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <random>

#include "core/base/number_text.hpp"
#include "tests/support/soup_generators.hpp"

namespace footfall::fuzz {
using namespace detail;
namespace {

using test::Soup;

/// std::mt19937_64 is the same everywhere; the standard's distributions are not.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  std::uint64_t bits() { return engine_(); }
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  bool oneIn(int count) { return below(count) == 0; }
  template <class T>
  T oneOf(std::initializer_list<T> values) {
    return values.begin()[below(static_cast<int>(values.size()))];
  }
  template <class T>
  void shuffle(std::vector<T>& values) {
    for (std::size_t i = values.size(); i > 1; --i)
      std::swap(values[i - 1], values[static_cast<std::size_t>(below(static_cast<int>(i)))]);
  }

 private:
  std::mt19937_64 engine_;
};

template <std::size_t N>
std::vector<std::array<int, N>> numbers(Dice& dice, int count, int limit) {
  std::vector<std::array<int, N>> result(static_cast<std::size_t>(count));
  for (auto& row : result)
    for (int& n : row) n = dice.below(limit);
  return result;
}

Soup gridSoup(Dice& dice, int plan, int height) {
  auto triangles = numbers<9>(dice, 2 + dice.below(1 + dice.below(13)), 1 << 20);
  for (auto& row : triangles)
    for (std::size_t i = 0; i < row.size(); ++i) row[i] %= i % 3 == 2 ? height : plan;
  return test::soupOf(triangles);
}

Soup wallsOverFloors(Dice& dice) {
  Soup soup = Soup().floor(0, 0, 4, 4, 0).floor(4, 0, 6, 4, 0);
  for (const auto& n : numbers<6>(dice, 1 + dice.below(10), 7))
    soup.triangle({double(n[0]), double(n[1]), n[4] % 4 - 1.0}, {double(n[2]), double(n[3]), n[4] % 3 - 1.0},
                  {double(n[0]), double(n[1]), double(n[5] % 4)});
  return soup;
}

Soup walk(Dice& dice) {
  std::vector<int> steps(static_cast<std::size_t>(1 + dice.below(7)));
  for (int& step : steps) step = dice.below(16);
  return test::walkOf(steps);
}

Soup anyNumbers(Dice& dice) {
  Soup soup;
  for (int i = 1 + dice.below(12); i > 0; --i) {
    const auto corner = [&] {
      const auto number = [&] { return std::ldexp(static_cast<double>(dice.bits() >> 11), -51); };
      const double x = number(), y = number(), z = number() / 8;
      return Vec3{x, y, z};
    };
    const Vec3 a = corner(), b = corner(), c = corner();
    soup.triangle(a, b, c);
  }
  return soup;
}

void chooseSoup(Dice& dice, PipelineCase& result) {
  result.roundingIsHarmless = true;
  switch (dice.below(9)) {
    case 0:
      result.kind = "flat grid";
      result.soup = gridSoup(dice, 4, 1);
      break;
    case 1:
      result.kind = "two levels";
      result.soup = gridSoup(dice, 4, 2);
      break;
    case 2:
      result.kind = "walls over floors";
      result.soup = wallsOverFloors(dice);
      break;
    case 3:
      result.kind = "building";
      result.soup = test::buildingOf(numbers<7>(dice, 1 + dice.below(8), 64));
      break;
    case 4:
      result.kind = "walk";
      result.soup = walk(dice);
      break;
    case 5:
      result.kind = "large grid";
      result.soup = gridSoup(dice, 1000, 5);
      result.roundingIsHarmless = false;
      break;
    case 6:
      result.kind = "any numbers";
      result.soup = anyNumbers(dice);
      result.roundingIsHarmless = false;
      break;
    default:
      result.kind = "tiny grid";
      result.soup = gridSoup(dice, 3, 3);
      break;
  }
}

/// Each vertex is moved, scaled or disturbed; returns how much longer heights become.
double chooseMap(Dice& dice, PipelineCase& result) {
  const auto map = [&](const char* words, bool harmless, const std::function<Vec3(const Vec3&)>& function) {
    result.kind += words;
    result.roundingIsHarmless = result.roundingIsHarmless && harmless;
    result.soup = result.soup.mapped(function);
  };
  const double scale = dice.oneOf({0x1p-100, 0x1p-20, 0x1p3, 0x1p20, 0x1p100, 1e-7, 0.1, 1e7});
  switch (dice.below(12)) {
    case 0:
    case 1: {
      const bool power = std::exp2(std::round(std::log2(scale))) == scale;
      map(", scaled", power, [&](const Vec3& v) { return Vec3{v.x * scale, v.y * scale, v.z * scale}; });
      return scale;
    }
    case 2:
      map(", moved far away", false, [](const Vec3& v) { return Vec3{122000.123 + v.x, 487000.456 + v.y, v.z}; });
      return 1;
    case 3:
      map(", moved far away, shrunk", false, [](const Vec3& v) {
        return Vec3{122000.123 + v.x / 3, 487000.456 + v.y / 7, v.z * 0.7};
      });
      return 0.7;
    case 4:
      map(", nearly degenerate", false, [&](const Vec3& v) {
        const auto shift = [&] { return (dice.below(3) - 1) * 0x1p-40; };
        const double x = v.x + shift(), y = v.y + shift(), z = v.z + shift();
        return Vec3{x, y, z};
      });
      return 1;
    case 5:
      map(", huge and tiny", false, [&](const Vec3& v) {
        const auto scaled = [&](double c) { return std::ldexp(c, dice.oneOf({0, 0, 0, 30, -30, 8})); };
        const double x = scaled(v.x), y = scaled(v.y), z = scaled(v.z);
        return Vec3{x, y, z};
      });
      result.copies = 1;  // every copy would reach over all others
      return 1;
    default:
      return 1;
  }
}

std::string filter(const char* name, double value) {
  std::string text = name;
  text += ' ';
  appendNumber(text, value);
  return text;
}

std::vector<std::string> chooseSameSetFilters(Dice& dice, double slope, double clearance) {
  std::vector<std::string> filters{filter("SlopeFilter", slope) + " 0", filter("VerticalClearanceFilter", clearance)};
  for (int more = dice.below(6); more > 0; --more) {
    switch (dice.below(7)) {
      case 0:
        filters.push_back(filter("SlopeFilter", slope + (90 - slope) * dice.oneOf({0.0, 0.25, 0.5})) + " 0");
        break;
      case 1:
        filters.push_back(filter("VerticalClearanceFilter", clearance * dice.oneOf({1.0, 0.75, 0.5})));
        break;
      default:
        filters.push_back(dice.oneOf({"DuplicationFilter 0", "DegeneracyFilter", "AreaFilter 0", "SimplificationFilter",
                                      "LayerSubdivisionFilter"}));
    }
  }
  dice.shuffle(filters);
  return filters;
}

double largestCoordinate(const Soup& soup) {
  double largest = 0;
  for (const auto& triangle : soup.triangles())
    for (const Vec3& v : triangle) largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return largest;
}

// A clearance and what needs one before it, in one piece: parts of a pipeline may be left out.
std::string chooseBody(Dice& dice, double scale, double least) {
  const auto length = [&](double factor) { return std::max(scale * factor, least); };
  std::string text = filter("VerticalClearanceFilter", scale * dice.oneOf({0.5, 1.0, 2.0}));
  text += '\n' + filter("StepFilter", length(dice.oneOf({0.1, 0.25, 0.5}))) +
          filter("", dice.oneIn(3) ? 0 : length(dice.oneOf({0.02, 0.1, 0.25})));
  if (dice.oneIn(4)) text += '\n' + filter("RadiusFilter", length(dice.oneOf({0.1, 0.35}))) + filter("", length(0.2));
  if (dice.oneIn(2)) text += '\n' + filter("DropFilter", length(dice.oneOf({1.0, 3.0}))) + filter("", length(0.3));
  return text;
}

// `leastRadius`: smaller ones are refused.
std::vector<std::string> chooseAnyFilters(Dice& dice, double scale, double leastRadius) {
  std::vector<std::string> filters;
  for (int count = 1 + dice.below(7); count > 0; --count) {
    switch (dice.below(9)) {
      case 0:
        filters.emplace_back("DegeneracyFilter");
        break;
      case 1:
        filters.push_back(filter("DuplicationFilter", scale * dice.oneOf({0.0, 1e-9, 0.3, 1.1})));
        break;
      case 2:
        filters.push_back(filter("SlopeFilter", dice.oneOf({30.0, 45.0, 60.0, 80.0})));
        break;
      case 3:
        filters.push_back(filter("VerticalClearanceFilter", scale * dice.oneOf({0.5, 1.0, 2.0, 1e30})));
        break;
      case 4:
        filters.push_back(filter("AreaFilter", scale * scale * dice.oneOf({0.0, 0.5, 1.0, 4.0})));
        break;
      case 5:
        filters.push_back(dice.oneOf({"SimplificationFilter", "SimplificationFilter true 0.000001",
                                      "SimplificationFilter true 0.01", "SimplificationFilter true 0.4"}));
        break;
      case 6:
        filters.emplace_back("LayerSubdivisionFilter");
        break;
      case 7:
        filters.push_back(filter("RadiusFilter", std::max(scale * dice.oneOf({0.0, 0.1, 0.35, 2.0}), leastRadius)));
        break;
      default:
        filters.push_back(dice.oneOf({"RoundingFilter", "RoundingFilter false"}));
    }
  }
  if (dice.oneIn(3)) filters.push_back(chooseBody(dice, scale, leastRadius));
  return filters;
}

double extentOf(const Soup& soup) {
  double least = INFINITY, largest = -INFINITY;
  for (const auto& triangle : soup.triangles()) {
    for (const Vec3& v : triangle) {
      least = std::min({least, v.x, v.y});
      largest = std::max({largest, v.x, v.y});
    }
  }
  return largest - least;
}

}  // namespace

PipelineCase makePipelineCase(std::uint64_t seed) {
  Dice dice(seed);
  PipelineCase result;
  chooseSoup(dice, result);
  result.copies = dice.oneIn(8) ? 2 + dice.below(8) : 1;
  const double scale = chooseMap(dice, result);
  result.bothSides = dice.oneIn(4);
  result.slope = dice.oneOf({45.0, 60.0, 30.0, 80.0, 54.7});
  result.clearance = scale * dice.oneOf({2.0, 1.0, 0.5, 1.5, 3.0, 1e30});
  result.sameSetFilters = chooseSameSetFilters(dice, result.slope, result.clearance);
  result.anyFilters = chooseAnyFilters(dice, scale, 1e-9 * largestCoordinate(result.soup));
  result.copyDistance = extentOf(result.soup) * dice.oneOf({0.5, 1.0, 1.5});
  result.order = dice.bits();
  return result;
}

std::string toPipelineText(const std::vector<std::string>& filters) {
  std::string text;
  for (const std::string& line : filters) text += line + '\n';
  return text;
}

}  // namespace footfall::fuzz
