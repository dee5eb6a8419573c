// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/foreign_stream.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/environment/part_names.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

constexpr std::string_view kStart = "footfall-import 1\n", kEnd = "\nend\n";
constexpr std::uint8_t kEnvironment = 1, kError = 2;
constexpr std::uint8_t kNoAxis = 255;
constexpr int kDeepestText = 8;
constexpr std::size_t kMostArguments = 9;

class Writer {
 public:
  explicit Writer(std::uint8_t kind) : bytes_(kStart) { number(kind); }

  template <class Number>
  void number(Number value) {
    static_assert(std::is_trivially_copyable_v<Number>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void words(std::string_view text) {
    number(std::uint64_t{text.size()});
    bytes_ += text;
  }
  template <class Item>
  void array(const std::vector<Item>& items) {
    static_assert(std::is_trivially_copyable_v<Item>);
    number(std::uint64_t{items.size()});
    bytes_.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item));
  }
  template <class Item, class Write>
  void list(const std::vector<Item>& items, const Write& write) {
    number(std::uint64_t{items.size()});
    for (const Item& item : items) write(item);
  }
  void text(const Text& text) {
    number(static_cast<std::uint8_t>((text.isPattern() ? 1 : 0) + (text.isCount() ? 2 : 0)));
    words(text.pattern());
    list(text.arguments(), [this](const Text& argument) { this->text(argument); });
  }
  void reserve(std::size_t bytes) { bytes_.reserve(bytes_.size() + bytes); }
  std::string finish() {
    bytes_ += kEnd;
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
};

template <std::size_t... I>
Text patternText(const std::string& pattern, const std::vector<Text>& arguments, std::index_sequence<I...> /*count*/) {
  return Text(Pattern{pattern.c_str()}, arguments[I]...);
}

/// The constructor of a text needs its arguments as a parameter pack.
template <std::size_t Count = kMostArguments>
Text patternText(const std::string& pattern, const std::vector<Text>& arguments) {
  if constexpr (Count == 0) {
    return Text(Pattern{pattern.c_str()});
  } else {
    if (arguments.size() == Count) return patternText(pattern, arguments, std::make_index_sequence<Count>());
    return patternText<Count - 1>(pattern, arguments);
  }
}

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {
    if (!rest_.starts_with(kStart) || !rest_.ends_with(kEnd) || rest_.size() < kStart.size() + kEnd.size())
      throw BadStream{};
    rest_.remove_prefix(kStart.size());
    rest_.remove_suffix(kEnd.size());
  }

  template <class Number>
  Number number() {
    Number value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string words() {
    const auto size = number<std::uint64_t>();
    return std::string(take(size));
  }
  std::string name() { return cleanName(words()); }
  template <class Item>
  void array(std::vector<Item>& items) {
    const std::uint64_t count = countOf(sizeof(Item));
    const std::string_view bytes = take(count * sizeof(Item));
    items.resize(static_cast<std::size_t>(count));
    if (count > 0) std::memcpy(items.data(), bytes.data(), bytes.size());
  }
  /// Each item takes at least `least` bytes.
  template <class Read>
  void list(std::size_t least, const Read& read) {
    for (std::uint64_t count = countOf(least); count > 0; --count) read();
  }
  Text text(int depth = 0) {
    if (depth > kDeepestText) throw BadStream{};
    const auto kind = number<std::uint8_t>();
    const std::string pattern = words();
    std::vector<Text> arguments;
    list(17, [&] { arguments.push_back(text(depth + 1)); });
    if (kind > 3 || arguments.size() > kMostArguments) throw BadStream{};
    if (kind == 1) return patternText(pattern, arguments);
    if (kind == 0) return Text(pattern);
    const bool isNumber = !pattern.empty() && pattern.size() < 20 &&
                          std::all_of(pattern.begin(), pattern.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!isNumber) throw BadStream{};
    return Text::count(std::stoull(pattern));
  }
  double finite() {
    const auto value = number<double>();
    if (!std::isfinite(value)) throw BadStream{};
    return value;
  }
  Vec3 place() {
    const double x = finite(), y = finite(), z = finite();
    return {x, y, z};
  }
  void end() const {
    if (!rest_.empty()) throw BadStream{};
  }

 private:
  std::uint64_t countOf(std::size_t itemBytes) {
    const auto count = number<std::uint64_t>();
    if (count > rest_.size() / itemBytes) throw BadStream{};
    return count;
  }
  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) throw BadStream{};
    const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(count));
    rest_.remove_prefix(static_cast<std::size_t>(count));
    return taken;
  }

  std::string_view rest_;
};

static_assert(std::is_trivially_copyable_v<Vec3> && sizeof(Vec3) == 3 * sizeof(double));

void writeSkipped(const SkippedElements& skipped, Writer& out) {
  out.number(skipped.points);
  out.number(skipped.lines);
  out.number(skipped.polygons);
  out.list(skipped.listed, [&](const SkippedPolygon& polygon) {
    out.number(polygon.reason);
    out.number(std::uint64_t{polygon.cornerCount});
    out.number(polygon.line);
    out.number(polygon.face);
    out.words(polygon.mesh);
    out.array(polygon.corners);
  });
}

void readSkipped(SkippedElements& skipped, Reader& in) {
  skipped.points = in.number<std::uint64_t>();
  skipped.lines = in.number<std::uint64_t>();
  skipped.polygons = in.number<std::uint64_t>();
  in.list(41, [&] {
    SkippedPolygon& polygon = skipped.listed.emplace_back();
    polygon.reason = in.number<SkipReason>();
    polygon.cornerCount = static_cast<std::size_t>(in.number<std::uint64_t>());
    polygon.line = in.number<std::uint64_t>();
    polygon.face = in.number<std::uint64_t>();
    polygon.mesh = in.name();
    in.array(polygon.corners);
    const auto isFinite = [](const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
    if (polygon.reason > SkipReason::FreeForm || !std::ranges::all_of(polygon.corners, isFinite)) throw BadStream{};
  });
  if (skipped.listed.size() > SkippedElements::kMostListed) throw BadStream{};
}

void readFrame(FileFrame& frame, Reader& in) {
  const auto up = in.number<std::uint8_t>();
  if (up != kNoAxis) {
    if (up > static_cast<std::uint8_t>(kUpAxes.back())) throw BadStream{};
    frame.up = static_cast<UpAxis>(up);
  }
  const double metres = in.finite();  // 0: the file does not state it
  if (metres < 0) throw BadStream{};
  if (metres > 0) frame.metresPerUnit = metres;
}

void checkSoup(const Environment& environment) {
  for (const Vec3& p : environment.vertices)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) throw BadStream{};
  for (const Triangle& triangle : environment.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= environment.vertices.size()) throw BadStream{};
  if (!environment.partOf.empty() && environment.partOf.size() != environment.triangles.size()) throw BadStream{};
  for (const std::uint32_t part : environment.partOf)
    if (part >= environment.parts.size()) throw BadStream{};
}

}  // namespace

std::string encodeEnvironment(const Environment& environment, const FileFrame& frame) {
  Writer out(kEnvironment);
  out.reserve(environment.vertices.size() * sizeof(Vec3) + environment.triangles.size() * (sizeof(Triangle) + 4) +
              4096);
  out.number(frame.up ? static_cast<std::uint8_t>(*frame.up) : kNoAxis);
  out.number(frame.metresPerUnit.value_or(0));
  writeSkipped(environment.skipped, out);
  out.list(environment.parts, [&](const EnvironmentPart& part) {
    out.words(part.mesh);
    out.words(part.material);
  });
  out.list(environment.notes, [&](const Text& note) { out.text(note); });
  out.array(environment.vertices);
  out.array(environment.triangles);
  out.array(environment.partOf);
  return out.finish();
}

std::string encodeError(const Text& message) {
  Writer out(kError);
  out.text(message);
  return out.finish();
}

std::optional<Text> decodeStream(std::string_view bytes, Environment& environment, FileFrame& frame) {
  Reader in(bytes);
  const auto kind = in.number<std::uint8_t>();
  if (kind == kError) {
    Text message = in.text();
    in.end();
    return message.inOneLine();
  }
  if (kind != kEnvironment) throw BadStream{};
  readFrame(frame, in);
  readSkipped(environment.skipped, in);
  in.list(16, [&] {
    std::string mesh = in.name(), material = in.name();
    environment.parts.push_back({std::move(mesh), std::move(material)});
  });
  in.list(17, [&] { environment.notes.push_back(in.text().inOneLine()); });
  in.array(environment.vertices);
  in.array(environment.triangles);
  in.array(environment.partOf);
  in.end();
  checkSoup(environment);
  return std::nullopt;
}

}  // namespace footfall::detail
