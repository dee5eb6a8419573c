// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/bottleneck_statistics.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/navigation/bottleneck_list.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

using Json = nlohmann::ordered_json;

Json placeJson(const Vec3& place, UpAxis up) {
  const Vec3 p = inFileFrame(place, up);
  return {p.x, p.y, p.z};
}

}  // namespace

std::string addBottlenecks(const std::string& statistics, const CorridorMap& map) {
  const BottleneckList list = listBottlenecks(map, usualBottlenecks(map.frame.metresPerUnit));
  const UpAxis up = map.frame.up;
  Json listed = Json::array();
  for (const std::size_t i : list.listed) {
    const Bottleneck& b = map.bottlenecks[i];
    Json sides = Json::array();
    for (const BottleneckSide& side : b.sides)
      sides.push_back({{"widest", map.vertices[side.widest].width}, {"area", side.area}});
    listed.push_back({{"place", placeJson(b.place, up)},
                      {"width", b.width},
                      {"left", placeJson(b.left, up)},
                      {"right", placeJson(b.right, up)},
                      {"only_way", b.isOnlyWay},
                      {"sides", std::move(sides)}});
  }
  Json json = Json::parse(statistics);
  json["bottlenecks"] = {{"count", map.bottlenecks.size()},
                         {"slits", list.slits},
                         {"shallow", list.shallow},
                         {"listed", std::move(listed)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace footfall::detail
