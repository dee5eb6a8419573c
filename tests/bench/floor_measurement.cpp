// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/floor_measurement.hpp"

#include <embree3/rtcore.h>
#include <tbb/global_control.h>

#include <memory>
#include <stdexcept>
#include <type_traits>

#include "core/base/process_usage.hpp"
#include "core/io/input_file.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

void check(RTCDevice device) {
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::runtime_error("Embree reports an error");
}

}  // namespace

Json measureFloor(const std::string& path, const Environment& environment, int threads, const Repetition& repetition) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  std::vector<std::array<float, 3>> vertices;
  for (const Vec3& v : environment.vertices)
    vertices.push_back({static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
  vertices.emplace_back();  // Embree may read a few bytes past the last vertex
  const std::unique_ptr<std::remove_pointer_t<RTCDevice>, decltype(&rtcReleaseDevice)> device(
      rtcNewDevice(("threads=" + std::to_string(threads)).c_str()), rtcReleaseDevice);
  if (!device) throw std::runtime_error("Embree gives no device");

  Samples samples;
  const auto once = [&] {
    const Stopwatch reading;
    const std::string text = readInputFile(path, nullptr);
    const double readMs = reading.wallMs();
    const Stopwatch building;
    RTCScene scene = rtcNewScene(device.get());
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices.data(), 0,
                               sizeof vertices[0], vertices.size() - 1);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, environment.triangles.data(), 0,
                               sizeof(Triangle), environment.triangles.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    const double treeMs = building.wallMs();
    check(device.get());
    rtcReleaseScene(scene);
    samples.add("read_ms", readMs);
    samples.add("tree_ms", treeMs);
    samples.add("wall_ms", readMs + treeMs);
  };
  const int runs = repeat(repetition, once, [&] { samples.clear(); });
  return {{"runs", runs},
          {"read_ms", samples.median("read_ms")},
          {"tree_ms", samples.median("tree_ms")},
          {"wall_ms", samples.median("wall_ms")}};
}

}  // namespace footfall::bench
