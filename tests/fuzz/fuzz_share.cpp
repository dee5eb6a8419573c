// Any bytes as the share of a cell: numbers in range that are written and read as the same, or refused. With 's' in
// front as a sealed share, with 'a' and 'b' as an environment between two filters, as text and as doubles.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "core/distributed/cell_share.hpp"
#include "core/distributed/share_file.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/support/intermediate.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::fuzz;

namespace {

const ShareRange kRange{1 << 20, 1 << 20, 4, 4};

void requireInRange(const FaceMesh::Facet& facet, const FaceMesh& mesh) {
  for (std::size_t k = 0; k < 3; ++k) {
    require(facet.corners[k] >= 0 && static_cast<std::size_t>(facet.corners[k]) < mesh.points.size(),
            "a corner is out of range");
    require(facet.lines[k] >= -1 && facet.lines[k] < static_cast<Index>(mesh.lines.size()), "a line is out of range");
    if ((facet.outlineEdges >> k & 1) != 0) require(facet.lines[k] >= 0, "an outline has no line");
  }
}

void requireInRange(const CellShare& share) {
  for (const FaceResult& result : share.faces) {
    require(result.cuts != nullptr, "a floor has no cuts");
    require(result.cuts->points.size() == result.cuts->borders.size(), "a point has no border");
    require((result.mesh != nullptr) == (!result.cuts->removed && !result.cuts->segments.empty()), "a mesh is missing");
    for (const CutSegment& s : result.cuts->segments)
      require(s.from >= 0 && static_cast<std::size_t>(s.from) < result.cuts->points.size() && s.to >= 0 &&
                  static_cast<std::size_t>(s.to) < result.cuts->points.size() &&
                  static_cast<std::size_t>(s.line) < result.cuts->lines.size(),
              "a segment is out of range");
    if (!result.mesh) continue;
    for (const FaceMesh::Facet& facet : result.mesh->facets) requireInRange(facet, *result.mesh);
  }
  for (std::size_t i = 0; i < share.faces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) require(share.faces[i].face != share.faces[j].face, "a floor is there twice");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = textOf(data, size);
  try {
    if (!bytes.empty() && bytes[0] == 's') {
      const OpenedShare opened = openShare(bytes.substr(1));
      require(sealShare(opened.name, opened.bytes) == bytes.substr(1), "a share changes when it is sealed again");
      return 0;
    }
    if (!bytes.empty() && bytes[0] == 'a') {
      const TriangleSoup soup = readAscii(bytes.substr(1));
      require(readAscii(writeAscii(soup)).vertices == soup.vertices, "text changes when it is written and read");
      return 0;
    }
    if (!bytes.empty() && bytes[0] == 'b') {
      require(writeBinary(readBinary(bytes.substr(1))) == bytes.substr(1), "doubles change when they are written");
      return 0;
    }
    const CellShare share = decodeCellShare(bytes, kRange);
    requireInRange(share);
    const std::string once = encodeCellShare(share);
    require(encodeCellShare(decodeCellShare(once, kRange)) == once, "a share changes when it is written and read");
  } catch (const BadBytes&) {
    return 0;
  }
  return 0;
}
