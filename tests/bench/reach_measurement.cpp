// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/reach_measurement.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/base/number_text.hpp"
#include "footfall/inspect.hpp"
#include "footfall/path.hpp"
#include "footfall/run.hpp"
#if FOOTFALL_BENCH_RECAST
#include "tests/bench/recast_measurement.hpp"
#endif

namespace footfall::bench {
using namespace detail;
namespace {

/// The gap of the default pipeline, in metres.
constexpr double kGap = 0.05;

RunResult runWith(const Subject& subject, const std::shared_ptr<const Environment>& environment, double step,
                  int threads) {
  std::string text = "DuplicationFilter 0\nDegeneracyFilter\nSlopeFilter 45\nVerticalClearanceFilter ";
  appendNumber(text, subject.clearance);
  text += '\n';
  if (step > 0) {
    text += "StepFilter ";
    appendNumber(text, step);
    text += ' ';
    appendNumber(text, kGap / subject.metresPerUnit());
    text += '\n';
  }
  RunContext context;
  return runPipeline(environment, parsePipeline(text, "reach"), context, nullptr, threads);
}

Json reachOf(const RunResult& result) {
  const Components components = findComponents(*result.mesh);
  return {{"components", components.list.size()}, {"share", components.connectedShare()}};
}

tbb::global_control limitTo(int threads) {
  return {tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)};
}

#if FOOTFALL_BENCH_RECAST
/// The probability that two of the places are in one group.
template <class Counts>
double shareOf(const Counts& counts, std::size_t total) {
  double share = 0;
  for (const auto& [group, count] : counts) {
    const double part = static_cast<double>(count) / static_cast<double>(total);
    share += part * part;
  }
  return share;
}
#endif

}  // namespace

Json measureReach(const Subject& subject, double step, int threads) {
  const tbb::global_control limit = limitTo(threads);
  const auto environment = loadSubject(subject);
  const RunResult plain = runWith(subject, environment, 0, threads),
                  linked = runWith(subject, environment, step, threads);
  return {{"step", step},
          {"plain", reachOf(plain)},
          {"steps", reachOf(linked)},
          {"links", linked.mesh->links.size()},
          {"plain_run_ms", plain.totalMs},
          {"run_ms", linked.totalMs}};
}

#if FOOTFALL_BENCH_RECAST
Json compareReach(const Subject& subject, double step, int threads) {
  constexpr RecastCell kCell{0.1, 0.05};
  constexpr double kNear = 0.25;  // metres: a span is as high as the highest point in its cell
  const tbb::global_control limit = limitTo(threads);
  const auto environment = loadSubject(subject);
  const double metres = subject.metresPerUnit();
  const RecastPlaces theirs = findRecastPlaces(*environment, metres, kCell, step * metres);
  const RunResult run = runWith(subject, environment, step, threads);
  const Components components = findComponents(*run.mesh);
  const PathFinder finder(run.mesh);

  std::map<std::uint32_t, std::size_t> ofTheirs, commonOurs, commonTheirs;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> commonBoth;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> firstPlaces;
  std::size_t common = 0;
  for (std::size_t i = 0; i < theirs.places.size(); ++i) {
    const std::uint32_t part = theirs.parts[i];
    ++ofTheirs[part];
    const auto place = finder.locate(theirs.places[i], kNear / metres);
    if (!place) continue;
    const std::uint32_t component = components.ofTriangle[place->triangle];
    ++common;
    ++commonOurs[component];
    ++commonTheirs[part];
    ++commonBoth[{component, part}];
    firstPlaces.try_emplace({component, part}, theirs.places[i]);
  }
  if (common == 0) throw std::runtime_error("no place of Recast's lies on ours");
  // The components of ours that Recast joins, and a place of each: the pair with the largest weight first.
  std::vector<std::pair<double, Json>> joined;
  const auto listOf = [](const Vec3& p) { return Json{p.x, p.y, p.z}; };
  for (const auto& [one, count] : commonBoth)
    for (const auto& [other, otherCount] : commonBoth) {
      if (one.second != other.second || one.first >= other.first) continue;
      const double all = static_cast<double>(common);
      const double weight = 2 * (static_cast<double>(count) / all) * (static_cast<double>(otherCount) / all);
      joined.emplace_back(
          -weight,
          Json{{"share", weight}, {"from", listOf(firstPlaces.at(one))}, {"to", listOf(firstPlaces.at(other))}});
    }
  constexpr std::size_t kMostPairs = 8;
  std::sort(joined.begin(), joined.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Json pairs = Json::array();
  for (std::size_t i = 0; i < std::min(joined.size(), kMostPairs); ++i) pairs.push_back(joined[i].second);

  const double ours = shareOf(commonOurs, common), other = shareOf(commonTheirs, common),
               both = shareOf(commonBoth, common);
  const std::size_t places = theirs.places.size();
  return {{"places", places},
          {"parts", theirs.partCount},
          {"share", shareOf(ofTheirs, places)},
          {"common", static_cast<double>(common) / static_cast<double>(places)},
          {"ours", ours},
          {"theirs", other},
          {"only_ours", ours - both},
          {"only_theirs", other - both},
          {"only_theirs_pairs", pairs}};
}
#else
Json compareReach(const Subject&, double, int) { throw std::runtime_error("this program was built without Recast"); }
#endif

}  // namespace footfall::bench
