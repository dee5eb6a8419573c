// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/number_text.hpp"
#include "core/navigation/corridor_places.hpp"
#include "footfall/corridor_map.hpp"
#include "footfall/errors.hpp"
#include "footfall/up_axis.hpp"
#include "footfall/version.hpp"

namespace footfall {
using namespace detail;
namespace {

constexpr int kVersion = 1;
constexpr const char* kFormat = "footfall corridor map";

/// Lines of JSON, one for each vertex, edge and bottleneck.
class CorridorText {
 public:
  explicit CorridorText(const CorridorMap& map) : map_(map) {}

  std::string write() {
    nlohmann::ordered_json head;
    head["format"] = kFormat;
    head["version"] = kVersion;
    head["program"] = std::string("footfall ") + version();
    head["source"] = map_.frame.source;
    head["up"] = std::string(nameOf(map_.frame.up));
    text_ = head.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    text_.pop_back();
    number("metres_per_unit", map_.frame.metresPerUnit);
    text_ += std::string(",\n\"full\":") + (map_.isFull ? "true" : "false");
    list("vertices", map_.vertices, [this](const CorridorVertex& vertex) {
      text_ += "{\"place\":";
      place(vertex.place);
      number("width", vertex.width);
      number("triangle", vertex.triangle);
    });
    list("edges", map_.edges, [this](const CorridorEdge& edge) { write(edge); });
    list("bottlenecks", map_.bottlenecks, [this](const Bottleneck& bottleneck) { write(bottleneck); });
    return text_ + "}\n";
  }

 private:
  template <class Items, class Write>
  void list(const char* name, const Items& items, Write one) {
    text_ += std::string(",\n\"") + name + "\":[";
    for (std::size_t i = 0; i < items.size(); ++i) {
      text_ += i == 0 ? "\n" : ",\n";
      one(items[i]);
      text_ += '}';
    }
    text_ += "\n]";
  }
  template <class Number>
  void number(const char* name, Number value) {
    text_.append(",\"").append(name).append("\":");
    appendNumber(text_, value);
  }
  void place(const Vec3& p) {
    const Vec3 q = inFileFrame(p, map_.frame.up);
    text_ += '[';
    appendNumber(text_, q.x);
    text_ += ',';
    appendNumber(text_, q.y);
    text_ += ',';
    appendNumber(text_, q.z);
    text_ += ']';
  }
  void places(const char* name, const std::array<Vec3, 2>& both) {
    text_.append(",\"").append(name).append("\":[");
    place(both[0]);
    text_ += ',';
    place(both[1]);
    text_ += ']';
  }
  void named(const char* name, const Vec3& p) {
    text_.append(",\"").append(name).append("\":");
    place(p);
  }
  void write(const CorridorEdge& edge) {
    text_ += "{\"from\":";
    appendNumber(text_, edge.from);
    number("to", edge.to);
    text_ += std::string(",\"shape\":\"") + (edge.shape == CorridorShape::Straight ? "straight" : "parabola") + '"';
    places("left", edge.left);
    places("right", edge.right);
    number("length", edge.length);
    named("narrowest", edge.narrowest);
    number("width", edge.width);
    number("area", edge.area);
    text_ += ",\"triangles\":[";
    for (std::size_t i = 0; i < edge.triangles.size(); ++i) {
      if (i > 0) text_ += ',';
      appendNumber(text_, edge.triangles[i]);
    }
    text_ += ']';
  }
  void write(const Bottleneck& b) {
    text_ += "{\"place\":";
    place(b.place);
    number("width", b.width);
    named("left", b.left);
    named("right", b.right);
    number("edge", b.edge);
    text_ += std::string(",\"only_way\":") + (b.isOnlyWay ? "true" : "false") + ",\"sides\":[";
    for (int side = 0; side < 2; ++side) {
      text_ += side == 0 ? "{\"widest\":" : ",{\"widest\":";
      appendNumber(text_, b.sides[side].widest);
      number("area", b.sides[side].area);
      text_ += '}';
    }
    text_ += ']';
  }

  const CorridorMap& map_;
  std::string text_;
};

/// The content of a file, checked against the rules of a map.
class CorridorReader {
 public:
  CorridorReader(const nlohmann::json& json, std::string name) : json_(json), name_(std::move(name)) {}

  CorridorMap read() {
    if (!json_.is_object() || json_.value("format", nlohmann::json()) != kFormat)
      fail("is no corridor map; give a file that `footfall corridors -o` wrote");
    if (json_.value("version", nlohmann::json()) != kVersion)
      fail("is a corridor map of another version; write it again with this program");
    CorridorMap map;
    map.isFull = json_.at("full").get<bool>();
    map.frame.source = json_.at("source").get<std::string>();
    const auto up = upAxisFrom(json_.at("up").get<std::string>());
    if (!up) fail("names no up axis; write it again");
    map.frame.up = up_ = *up;
    map.frame.metresPerUnit = number(json_.at("metres_per_unit"));
    for (const auto& vertex : json_.at("vertices"))
      map.vertices.push_back(
          {place(vertex.at("place")), number(vertex.at("width")), vertex.at("triangle").get<std::uint32_t>()});
    for (const auto& edge : json_.at("edges")) map.edges.push_back(readEdge(edge, map.vertices.size()));
    for (const auto& bottleneck : json_.at("bottlenecks")) map.bottlenecks.push_back(readBottleneck(bottleneck, map));
    return map;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(name_ + ": " + what); }
  double number(const nlohmann::json& json) const {
    const double value = json.get<double>();
    if (!std::isfinite(value)) fail("has a number that is not finite; write it again");
    return value;
  }
  std::uint32_t index(const nlohmann::json& json, std::size_t count) const {
    const auto value = json.get<std::uint64_t>();
    if (value >= count) fail("has an index out of range; write it again");
    return static_cast<std::uint32_t>(value);
  }
  Vec3 place(const nlohmann::json& json) const {
    return fromFileFrame({number(json.at(0)), number(json.at(1)), number(json.at(2))}, up_);
  }
  CorridorEdge readEdge(const nlohmann::json& json, std::size_t vertices) const {
    CorridorEdge edge;
    edge.from = index(json.at("from"), vertices);
    edge.to = index(json.at("to"), vertices);
    edge.shape = json.at("shape") == "straight" ? CorridorShape::Straight : CorridorShape::Parabola;
    edge.left = {place(json.at("left").at(0)), place(json.at("left").at(1))};
    edge.right = {place(json.at("right").at(0)), place(json.at("right").at(1))};
    edge.length = number(json.at("length"));
    edge.narrowest = place(json.at("narrowest"));
    edge.width = number(json.at("width"));
    edge.area = number(json.at("area"));
    edge.triangles = json.at("triangles").get<std::vector<std::uint32_t>>();
    return edge;
  }
  Bottleneck readBottleneck(const nlohmann::json& json, const CorridorMap& map) const {
    Bottleneck b;
    b.place = place(json.at("place"));
    b.width = number(json.at("width"));
    b.left = place(json.at("left"));
    b.right = place(json.at("right"));
    b.edge = index(json.at("edge"), map.edges.size());
    b.isOnlyWay = json.at("only_way").get<bool>();
    for (std::size_t side = 0; side < 2; ++side) {
      b.sides[side].widest = index(json.at("sides").at(side).at("widest"), map.vertices.size());
      b.sides[side].area = number(json.at("sides").at(side).at("area"));
    }
    return b;
  }

  const nlohmann::json& json_;
  std::string name_;
  UpAxis up_ = UpAxis::Z;
};

/// A feature of GeoJSON from place to place.
void appendLine(std::string& text, const CorridorMap& map, const std::vector<Vec3>& places) {
  text += text.back() == '[' ? "\n" : ",\n";
  text += R"({"type": "Feature", "geometry": {"type": "LineString", "coordinates": [)";
  for (std::size_t i = 0; i < places.size(); ++i) {
    text += i == 0 ? "[" : ", [";
    appendNumber(text, places[i].x * map.frame.metresPerUnit);
    text += ", ";
    appendNumber(text, places[i].y * map.frame.metresPerUnit);
    text += ", ";
    appendNumber(text, places[i].z * map.frame.metresPerUnit);
    text += ']';
  }
  text += "]}, \"properties\": {";
}

}  // namespace

std::string formatCorridorsJson(const CorridorMap& map) { return CorridorText(map).write(); }

CorridorMap parseCorridorsJson(const std::string& text, const std::string& name) {
  try {
    return CorridorReader(nlohmann::json::parse(text), name).read();
  } catch (const nlohmann::json::exception& error) {
    throw InputError(name + ": is no corridor map that can be read (" + error.what() + "); write it again");
  }
}

std::string formatCorridorsGeoJson(const CorridorMap& map) {
  const double metres = map.frame.metresPerUnit;
  std::string text = "{\"type\": \"FeatureCollection\",\n\"features\": [";
  const auto property = [&text](const char* name, double value) {
    text.append(", \"").append(name).append("\": ");
    appendNumber(text, value);
  };
  for (const CorridorEdge& edge : map.edges) {
    appendLine(text, map, placesAlong(map, edge));
    text += R"("kind": "corridor")";
    property("width", edge.width * metres);
    property("from_width", map.vertices[edge.from].width * metres);
    property("to_width", map.vertices[edge.to].width * metres);
    text += "}}";
  }
  for (const Bottleneck& b : map.bottlenecks) {
    appendLine(text, map, {b.left, b.right});
    text += R"("kind": "bottleneck")";
    property("width", b.width * metres);
    text += std::string(", \"only_way\": ") + (b.isOnlyWay ? "true" : "false") + "}}";
  }
  return text + "\n]}\n";
}

}  // namespace footfall
