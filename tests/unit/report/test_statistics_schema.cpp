// The output of `--stats` matches docs/reference/statistics.schema.json, no more and no less.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/report/bottleneck_statistics.hpp"
#include "footfall/corridor_map.hpp"
#include "footfall/io.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/report.hpp"
#include "footfall/run.hpp"
#include "footfall/up_axis.hpp"
#include "tests/support/soup.hpp"

using namespace footfall;
using footfall::detail::addBottlenecks;
using footfall::test::Soup;
using Json = nlohmann::json;

namespace {

bool isOfType(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  if (type == "null") return value.is_null();
  throw std::invalid_argument("the schema has a type that this check does not know: " + type);
}

bool isOfTypes(const Json& value, const Json& types) {
  if (types.is_string()) return isOfType(value, types);
  return std::any_of(types.begin(), types.end(), [&value](const Json& type) { return isOfType(value, type); });
}

/// The part of JSON Schema that ours uses; another keyword is an error, so that nothing is passed over. Empty: valid.
std::string complaint(const Json& value, const Json& schema, const std::string& at) {
  static const std::set<std::string> known{
      "$schema",  "title",    "description",          "type", "properties", "required", "items",
      "minItems", "maxItems", "additionalProperties", "enum", "minimum",    "maximum",  "exclusiveMinimum"};
  for (const auto& [keyword, ignored] : schema.items())
    if (!known.contains(keyword)) return at + ": unknown keyword " + keyword;
  if (!isOfTypes(value, schema.at("type"))) return at + ": " + value.dump() + " is no " + schema.at("type").dump();
  if (schema.contains("enum") && std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
    return at + ": not one of the enum";
  if (value.is_number()) {
    const double number = value;
    if (number < schema.value("minimum", number) || number > schema.value("maximum", number))
      return at + ": out of range";
    if (schema.contains("exclusiveMinimum") && number <= schema["exclusiveMinimum"]) return at + ": out of range";
  }
  if (value.is_array()) {
    if (value.size() < schema.value("minItems", value.size()) || value.size() > schema.value("maxItems", value.size()))
      return at + ": wrong length";
    for (std::size_t i = 0; schema.contains("items") && i < value.size(); ++i)
      if (auto found = complaint(value[i], schema["items"], at + '[' + std::to_string(i) + ']'); !found.empty())
        return found;
  }
  if (!value.is_object()) return {};
  const Json properties = schema.value("properties", Json::object());
  for (const Json& name : schema.value("required", Json::array()))
    if (!value.contains(name)) return at + ": lacks " + name.get<std::string>();
  for (const auto& [name, member] : value.items()) {
    const Json others = schema.value("additionalProperties", Json(true));
    if (!properties.contains(name) && others == false) return at + ": " + name + " is not in the schema";
    const Json rule = properties.contains(name) ? properties[name] : others;
    if (!rule.is_object()) continue;
    if (auto found = complaint(member, rule, at + '.' + name); !found.empty()) return found;
  }
  return {};
}

Json schema() {
  std::ifstream file(FOOTFALL_SOURCE_DIR "/docs/reference/statistics.schema.json");
  return Json::parse(file);
}

Json statisticsOf(const Environment& environment, const Pipeline& pipeline, const ProgramTimes& times = {}) {
  RunContext context;
  const RunResult result = runPipeline(std::make_shared<Environment>(environment), pipeline, context);
  return Json::parse(formatStatistics(environment, result, times));
}

}  // namespace

class TestStatisticsSchema : public QObject {
  Q_OBJECT

 private slots:
  void sample() {
    const Environment house = load(FOOTFALL_SOURCE_DIR "/samples/house/house.obj");
    const Json json = statisticsOf(house, defaultPipeline(house));
    QVERIFY(json.at("layer_list").size() > 1 && json.at("links") > 0);
    QVERIFY2(complaint(json, schema(), "").empty(), complaint(json, schema(), "").c_str());
    double area = 0;
    for (const Json& layer : json.at("layer_list")) area += layer.at("area").get<double>();
    QVERIFY(std::abs(area - json.at("area").get<double>()) <= 1e-9 * area);
  }

  void blocksDropsAndSkippedPolygons() {
    const auto soup = Soup().floor(0, 0, 8, 4, 0).floor(0, 4, 8, 8, 1).wall(8, 4, 0, 4, 0, 1).environment();
    soup->skipped.polygons = 2;
    soup->skipped.listed.resize(2);
    soup->skipped.listed[0].line = 3;
    soup->skipped.listed[1].face = 1;
    const Json json =
        statisticsOf(*soup,
                     parsePipeline("GridStrategy 2 2\nSlopeFilter 45\nVerticalClearanceFilter 2\nCollapse\n"
                                   "LayerSubdivisionFilter\nDropFilter 2\nReachableFilter 1 1 0 1 7 1\n",
                                   "test"),
                     {1, 1, 1, SpeedUp{2, 1}});
    QVERIFY(json.at("blocks").size() == 1 && json.at("drops") > 0 && json.at("speed_up").is_object());
    QVERIFY2(complaint(json, schema(), "").empty(), complaint(json, schema(), "").c_str());
  }

  void bottlenecks() {
    // Two rooms with a passage of 1 between them, and two with one of 0.08.
    const auto soup = Soup()
                          .floor(0, 0, 4, 4, 0)
                          .floor(4, 1.5, 6, 2.5, 0)
                          .floor(6, 0, 10, 4, 0)
                          .floor(20, 0, 24, 4, 0)
                          .floor(24, 1.5, 26, 1.58, 0)
                          .floor(26, 0, 30, 4, 0)
                          .environment();
    soup->up = UpAxis::Y;
    RunContext context;
    const RunResult result = runPipeline(soup, parsePipeline("SlopeFilter 45\n", "test"), context);
    const std::string without = formatStatistics(*soup, result);
    const Json json = Json::parse(addBottlenecks(without, makeCorridorMap(*result.mesh)));
    QVERIFY2(complaint(json, schema(), "").empty(), complaint(json, schema(), "").c_str());
    const Json& bottlenecks = json.at("bottlenecks");
    QVERIFY(bottlenecks.at("count") == 2 && bottlenecks.at("slits") == 1 && bottlenecks.at("shallow") == 0);
    QCOMPARE(bottlenecks.at("listed").size(), std::size_t{1});
    const Json& door = bottlenecks.at("listed")[0];
    QVERIFY(door.at("width") == 1 && door.at("only_way") == true && door.at("place") == Json({5, 0, -2}));
    QVERIFY2(std::abs(door.at("sides")[0].at("area").get<double>() - 17) < 1e-9, door.dump().c_str());
    // Nothing else changes.
    Json rest = json;
    rest.erase("bottlenecks");
    QVERIFY(rest == Json::parse(without));
  }

  void emptyResult() {
    const auto soup = Soup().wall(0, 0, 1, 0, 0, 1).environment();
    const Json json = statisticsOf(*soup, parsePipeline("SlopeFilter 45\n", "test"));
    QVERIFY2(complaint(json, schema(), "").empty(), complaint(json, schema(), "").c_str());
    QVERIFY(json.at("components").empty() && json.at("highest_link").is_null());
  }

  // The check finds what is wrong.
  void wrongStatistics() {
    const auto soup = Soup().floor(0, 0, 1, 1, 0).environment();
    const Json right = statisticsOf(*soup, parsePipeline("SlopeFilter 45\n", "test"));
    QVERIFY(complaint(right, schema(), "").empty());
    Json other = right;
    other["more"] = 1;
    QVERIFY(!complaint(other, schema(), "").empty());
    other = right;
    other.erase("area");
    QVERIFY(!complaint(other, schema(), "").empty());
    other = right;
    other["components"][0]["area"] = "1";
    QVERIFY(!complaint(other, schema(), "").empty());
    other = right;
    other["environment"]["up"] = "up";
    QVERIFY(!complaint(other, schema(), "").empty());
  }
};

QTEST_GUILESS_MAIN(TestStatisticsSchema)
#include "test_statistics_schema.moc"
