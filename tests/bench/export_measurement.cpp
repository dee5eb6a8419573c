// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/export_measurement.hpp"

#include <cmath>
#include <random>

#include "core/base/process_usage.hpp"
#include "core/io/formats/detour_export.hpp"
#include "core/io/formats/save.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

/// Squares of 1 m, of two triangles each, whose corners are up to 0.2 m off a plane; the halves are layers.
NavigationMesh makeRoughTerrain(std::uint32_t triangles) {
  const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 2.0)));
  NavigationMesh mesh;
  std::mt19937 random(1);
  const auto number = [side](std::uint32_t x, std::uint32_t y) { return y * (side + 1) + x; };
  for (std::uint32_t y = 0; y <= side; ++y)
    for (std::uint32_t x = 0; x <= side; ++x)
      mesh.vertices.push_back(
          {static_cast<double>(x), static_cast<double>(y), static_cast<double>(random() % 1024) / 5120});
  mesh.layerCount = 2;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      for (const Triangle& t : {Triangle{number(x, y), number(x + 1, y), number(x + 1, y + 1)},
                                Triangle{number(x, y), number(x + 1, y + 1), number(x, y + 1)}}) {
        mesh.triangles.push_back(t);
        mesh.layers.push_back(x < side / 2 ? 0 : 1);
      }
  for (std::uint32_t y = 0; y < side; ++y) mesh.connections.push_back({number(side / 2, y), number(side / 2, y + 1)});
  return mesh;
}

}  // namespace

Json measureExports(std::uint32_t triangles, const std::string& folder, const Repetition& repetition) {
  const NavigationMesh mesh = makeRoughTerrain(triangles);
  Json result{{"triangles", mesh.triangles.size()}, {"formats", Json::array()}};
  for (const FormatDescriptor& format : exportFormats()) {
    if (format.format == ExportFormat::Detour && !hasDetour()) continue;
    Samples samples;
    std::size_t bytes = 0;
    repeat(
        repetition,
        [&] {
          const Stopwatch making;
          const ExportFiles made = formatExport(format.format, folder + "/export" + format.ending, mesh, {}, {});
          samples.add("make_ms", making.wallMs());
          const Stopwatch writing;
          writeFilesSafely(made.files);
          samples.add("write_ms", writing.wallMs());
          bytes = 0;
          for (const OutputFile& file : made.files) bytes += file.bytes.size();
        },
        [&] { samples.clear(); });
    result["formats"].push_back({{"ending", format.ending},
                                 {"make_ms", samples.median("make_ms")},
                                 {"write_ms", samples.median("write_ms")},
                                 {"bytes", bytes}});
  }
  return result;
}

}  // namespace footfall::bench
