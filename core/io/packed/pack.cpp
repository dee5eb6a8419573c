// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/packed/pack.hpp"

#include <filesystem>
#include <memory>
#include <system_error>

#include "core/io/file_frame.hpp"
#include "core/io/import.hpp"
#include "core/io/input_file.hpp"
#include "core/io/packed/streams.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

bool streamFile(const std::string& path, const std::string& extension, Environment& head, EnvironmentPacker& packer,
                RunContext* context) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return false;
  if (extension == "obj") return streamObj(path, head, packer, context);
  if (extension == "ply") return streamPly(path, head, packer, context);
  if (extension == "stl") return streamStl(path, head, packer, context);
  return extension == "glb" && streamGlb(path, head, packer, context);
}

void addAll(const Environment& environment, EnvironmentPacker& packer, RunContext* context) {
  constexpr std::size_t kPollEach = 1 << 14;
  std::size_t done = 0;
  const auto poll = [&] {
    if (context != nullptr && ++done % kPollEach == 0) context->checkCancelled();
  };
  for (const Vec3& p : environment.vertices) {
    poll();
    packer.addVertex(inFileFrame(p, environment.up));
  }
  for (std::size_t t = 0; t < environment.triangles.size(); ++t) {
    poll();
    packer.addFace(environment.triangles[t], environment.partOf.empty() ? 0 : environment.partOf[t]);
  }
}

}  // namespace

PackResult packEnvironment(const std::string& path, const std::string& target, const ImportOptions& options,
                           RunContext* context, const PackingMemory& memory) {
  checkScale(options);
  EnvironmentPacker packer(path, target, context, memory);
  const std::string extension = lowerExtension(path);
  Environment head;
  head.source = path;
  PackResult result;
  result.isStreamed = streamFile(path, extension, head, packer, context);
  if (result.isStreamed) {
    if (packer.faceCount() == 0) failWithoutTriangles(path, head.skipped);
    FileFrame frame;
    if (extension == "glb") frame = gltfFrame();
    setFrame(head, frame, options, usualFrame(extension));
    head.grid = packer.putOnGrid(options, head.up, head.metresPerUnit);
  } else {
    packer.restart();
    head = {};
    std::shared_ptr<const Environment> whole = importEnvironment(path, options, context);
    addAll(*whole, packer, context);
    head = *whole;
    whole = nullptr;
    head.vertices = {};
    head.triangles = {};
    head.partOf = {};
  }
  result.notes = head.notes;
  result.counts = packer.finish(head);
  return result;
}

}  // namespace footfall::detail
