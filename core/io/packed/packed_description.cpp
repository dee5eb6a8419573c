// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/packed/packed_description.hpp"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <utility>
#include <vector>

#include "core/base/byte_stream.hpp"
#include "core/environment/part_names.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

constexpr int kDeepestText = 8;
constexpr std::size_t kMostPlaces = 9;  // in a pattern

double finite(double value) {
  if (!std::isfinite(value)) throw BadBytes("a number is not finite");
  return value;
}

void encode(const Text& text, ByteWriter& out) {
  out.number(text.isPattern() ? 1 : text.isCount() ? 2 : 0);
  out.text(text.pattern());
  out.number(text.arguments().size());
  for (const Text& argument : text.arguments()) encode(argument, out);
}

/// Uses the first `Count` arguments, or all where there are fewer.
template <std::size_t Count>
Text decodePattern(const std::string& english, const std::vector<Text>& arguments) {
  const Pattern pattern{english.c_str()};
  if constexpr (Count == 0) {
    return pattern;
  } else {
    if (arguments.size() < Count) return decodePattern<Count - 1>(english, arguments);
    return [&]<std::size_t... I>(std::index_sequence<I...>) { return Text(pattern, arguments[I]...); }
    (std::make_index_sequence<Count>{});
  }
}

Text decodeText(ByteReader& in, int depth = 0) {
  if (depth > kDeepestText) throw BadBytes("texts are nested too deeply");
  const std::int32_t kind = in.below(3);
  const std::string words = cleanName(in.text());
  const std::size_t count = in.count(3);
  if (count > kMostPlaces) throw BadBytes("a text has too many arguments");
  std::vector<Text> arguments(count);
  for (Text& argument : arguments) argument = decodeText(in, depth + 1);
  if (kind == 1) return decodePattern<kMostPlaces>(words, arguments);
  if (kind == 0) return words;
  std::uint64_t number = 0;
  if (words.empty() || words.size() > 19) throw BadBytes("a count is no number");
  for (const char digit : words) {
    if (digit < '0' || digit > '9') throw BadBytes("a count is no number");
    number = 10 * number + static_cast<std::uint64_t>(digit - '0');
  }
  return Text::count(number);
}

void encode(const SkippedPolygon& polygon, UpAxis up, ByteWriter& out) {
  out.number(static_cast<std::uint64_t>(polygon.reason));
  out.number(polygon.cornerCount);
  out.number(polygon.line);
  out.number(polygon.face);
  out.text(polygon.mesh);
  out.number(polygon.corners.size());
  for (const Vec3& corner : polygon.corners) {
    const Vec3 place = inFileFrame(corner, up);
    for (const double x : {place.x, place.y, place.z}) out.real(x);
  }
}

SkippedPolygon decodeSkipped(ByteReader& in) {
  SkippedPolygon polygon;
  polygon.reason = static_cast<SkipReason>(in.below(static_cast<std::int64_t>(SkipReason::FreeForm) + 1));
  polygon.cornerCount = in.number();
  polygon.line = in.number();
  polygon.face = in.number();
  polygon.mesh = cleanName(in.text());
  polygon.corners.resize(static_cast<std::size_t>(in.below(3)));
  for (Vec3& corner : polygon.corners)
    for (double* x : {&corner.x, &corner.y, &corner.z}) *x = finite(in.real());
  return polygon;
}

void encode(const CoordinateGrid& grid, ByteWriter& out) {
  out.real(grid.step);
  out.number(grid.bits);
  out.real(grid.largestMovement);
  out.number(grid.weldedVertices);
  out.number(grid.degenerateTriangles);
  out.number(grid.splitTriangles);
}

CoordinateGrid decodeGrid(ByteReader& in) {
  CoordinateGrid grid;
  grid.step = finite(in.real());
  int exponent = 0;
  if (grid.step != 0 && std::frexp(grid.step, &exponent) != 0.5) throw BadBytes("the grid's step is no power of two");
  grid.bits = static_cast<std::uint32_t>(in.below(64));
  grid.largestMovement = finite(in.real());
  grid.weldedVertices = in.number();
  grid.degenerateTriangles = in.number();
  grid.splitTriangles = in.number();
  return grid;
}

std::string fileName(const Environment& environment) {
  if (!environment.origin.empty()) return environment.origin;
  std::filesystem::path source = environment.source;
  if (!source.has_filename()) source = source.parent_path();  // the source is a folder
  return source.filename().string();
}

void decodeLists(ByteReader& in, Environment& head) {
  head.parts.resize(in.count(2));
  for (EnvironmentPart& part : head.parts) {
    part.mesh = cleanName(in.text());
    part.material = cleanName(in.text());
  }
  head.usualRoles.resize(in.count(1));
  for (PartRole& role : head.usualRoles)
    role = static_cast<PartRole>(in.below(static_cast<std::int64_t>(PartRole::Ignored) + 1));
  if (!head.usualRoles.empty() && head.usualRoles.size() != head.parts.size())
    throw BadBytes("there are not as many roles as parts");
  head.storeys.resize(in.count(9));
  for (Storey& storey : head.storeys) {
    storey.name = cleanName(in.text());
    storey.height = finite(in.real());
  }
  head.notes.resize(in.count(3));
  for (Text& note : head.notes) note = decodeText(in);
}

}  // namespace

std::string encodeDescription(const Environment& environment) {
  ByteWriter out;
  out.text(fileName(environment));
  out.number(static_cast<std::uint64_t>(environment.up));
  out.number(environment.upGuessed ? 1 : 0);
  out.real(environment.metresPerUnit);
  out.number(environment.scaleGuessed ? 1 : 0);
  out.number(environment.bothSides ? 1 : 0);
  out.number(environment.parts.size());
  for (const EnvironmentPart& part : environment.parts) {
    out.text(part.mesh);
    out.text(part.material);
  }
  out.number(environment.usualRoles.size());
  for (const PartRole role : environment.usualRoles) out.number(static_cast<std::uint64_t>(role));
  out.number(environment.storeys.size());
  for (const Storey& storey : environment.storeys) {
    out.text(storey.name);
    out.real(storey.height);
  }
  out.number(environment.notes.size());
  for (const Text& note : environment.notes) encode(note, out);
  out.number(environment.skipped.points);
  out.number(environment.skipped.lines);
  out.number(environment.skipped.polygons);
  out.number(environment.skipped.listed.size());
  for (const SkippedPolygon& polygon : environment.skipped.listed) encode(polygon, environment.up, out);
  encode(environment.grid, out);
  return std::move(out.bytes);
}

Environment decodeDescription(std::string_view bytes, std::uint32_t version) {
  ByteReader in(bytes);
  Environment head;
  head.origin = cleanName(in.text());
  head.up = static_cast<UpAxis>(in.below(static_cast<std::int64_t>(UpAxis::NegativeX) + 1));
  head.upGuessed = in.below(2) != 0;
  head.metresPerUnit = finite(in.real());
  if (!(head.metresPerUnit > 0)) throw BadBytes("the scale is not above 0");
  head.scaleGuessed = in.below(2) != 0;
  head.bothSides = in.below(2) != 0;
  decodeLists(in, head);
  head.skipped.points = in.number();
  head.skipped.lines = in.number();
  head.skipped.polygons = in.number();
  const std::size_t listed = in.count(6);
  if (listed > SkippedElements::kMostListed) throw BadBytes("the list of polygons is too long");
  for (std::size_t i = 0; i < listed; ++i) head.skipped.listed.push_back(decodeSkipped(in));
  if (version > 2) head.grid = decodeGrid(in);
  in.expectEnd();
  return head;
}

}  // namespace footfall::detail
