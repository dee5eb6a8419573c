// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/foreign/gltf_decoders.hpp"

#include "core/io/gltf/gltf_scene.hpp"

#ifdef FOOTFALL_HAS_MESHOPT
#include <meshoptimizer.h>
#endif
#ifdef FOOTFALL_HAS_DRACO
#include <draco/compression/decode.h>
#endif

namespace footfall::detail {
namespace {

[[maybe_unused]] [[noreturn]] void failDecoding(const char* extension) {
  failGltf(Text(FOOTFALL_TEXT("the data packed by %1 is invalid"), extension));
}

[[maybe_unused]] [[noreturn]] void failWithoutDecoder(const char* extension) {
  failGltf(Text(FOOTFALL_TEXT("it is packed by %1, which this build of Footfall does not read"), extension));
}

constexpr const char* kMeshopt = "EXT_meshopt_compression";
constexpr const char* kDraco = "KHR_draco_mesh_compression";

}  // namespace

#ifdef FOOTFALL_HAS_MESHOPT
std::string decodeMeshopt(std::string_view bytes, const MeshoptView& view) {
  constexpr std::uint64_t kLongest = std::uint64_t{1} << 34, kWidest = 256;
  if (view.stride == 0 || view.stride > kWidest || view.count > kLongest / view.stride) failDecoding(kMeshopt);
  const bool isAttribute = view.mode == "ATTRIBUTES", isList = view.mode == "TRIANGLES";
  if (!isAttribute && !isList && view.mode != "INDICES") failDecoding(kMeshopt);
  const bool isIndexSize = view.stride == 2 || view.stride == 4;
  if (isAttribute ? view.stride % 4 != 0 : !isIndexSize || (isList && view.count % 3 != 0)) failDecoding(kMeshopt);
  std::string result(static_cast<std::size_t>(view.count * view.stride), '\0');
  const auto* packed = reinterpret_cast<const unsigned char*>(bytes.data());
  const int failed =
      isAttribute ? meshopt_decodeVertexBuffer(result.data(), view.count, view.stride, packed, bytes.size())
      : isList    ? meshopt_decodeIndexBuffer(result.data(), view.count, view.stride, packed, bytes.size())
                  : meshopt_decodeIndexSequence(result.data(), view.count, view.stride, packed, bytes.size());
  if (failed != 0) failDecoding(kMeshopt);
  if (view.filter.empty() || view.filter == "NONE") return result;
  if (view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8))
    meshopt_decodeFilterOct(result.data(), view.count, view.stride);
  else if (view.filter == "QUATERNION" && view.stride == 8)
    meshopt_decodeFilterQuat(result.data(), view.count, view.stride);
  else if (view.filter == "EXPONENTIAL" && view.stride % 4 == 0)
    meshopt_decodeFilterExp(result.data(), view.count, view.stride);
  else
    failDecoding(kMeshopt);
  return result;
}
#else
std::string decodeMeshopt(std::string_view /*bytes*/, const MeshoptView& /*view*/) { failWithoutDecoder(kMeshopt); }
#endif

#ifdef FOOTFALL_HAS_DRACO
DracoMesh decodeDraco(std::string_view bytes, const std::vector<std::uint32_t>& attributes) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) failDecoding(kDraco);
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
  DracoMesh result;
  result.corners.reserve(std::size_t{3} * mesh->num_faces());
  for (draco::FaceIndex face(0); face < mesh->num_faces(); ++face)
    for (const draco::PointIndex& corner : mesh->face(face)) {
      if (corner.value() >= mesh->num_points()) failDecoding(kDraco);
      result.corners.push_back(corner.value());
    }
  for (const std::uint32_t number : attributes) {
    const draco::PointAttribute* attribute = mesh->GetAttributeByUniqueId(number);
    if (attribute == nullptr) failDecoding(kDraco);
    std::vector<std::array<double, 4>>& values = result.attributes.emplace_back();
    values.resize(mesh->num_points());
    for (draco::PointIndex point(0); point < mesh->num_points(); ++point) {
      const draco::AttributeValueIndex at = attribute->mapped_index(point);
      if (at.value() >= attribute->size() || !attribute->ConvertValue<double, 4>(at, values[point.value()].data()))
        failDecoding(kDraco);
    }
  }
  return result;
}
#else
DracoMesh decodeDraco(std::string_view /*bytes*/, const std::vector<std::uint32_t>& /*attributes*/) {
  failWithoutDecoder(kDraco);
}
#endif

}  // namespace footfall::detail
