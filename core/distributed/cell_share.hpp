// The result of a process for one cell, as bytes: which lines of which triangles cut which floor, and the triangles of
// what is left, by provenance. No coordinate is computed, and no large number is written (thesis 4.2 had to send graphs
// of expressions).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/assembly/face_mesh.hpp"
#include "core/assembly/face_share.hpp"
#include "core/base/byte_stream.hpp"
#include "core/base/digest.hpp"

namespace footfall::detail {

/// A floor that lies in one cell, or that the cell has as a whole.
struct FaceResult {
  Index face = -1;
  std::shared_ptr<const FaceCuts> cuts;  ///< never null
  std::shared_ptr<const FaceMesh> mesh;  ///< mesh of the cuts that have segments and leave anything
};

/// The part of a floor that cells share.
struct FacePart {
  Index face = -1;
  FaceShare share;
};

/// Milliseconds since the run of the process began.
struct ShareTimes {
  struct Span {
    std::size_t filter = 0;  ///< number of the filter in the pass
    int thread = 0;
    double startMs = 0, endMs = 0;
  };
  int thread = 0;
  double startMs = 0, endMs = 0;
  std::vector<Span> spans;
};

/// Floors that nothing cuts are not in it.
struct CellShare {
  std::vector<FaceResult> faces;
  std::vector<FacePart> parts;
  ShareTimes times;
};

/// The ranges of the numbers in a share.
struct ShareRange {
  Index vertices = 0;   ///< vertices of the source
  Index triangles = 0;  ///< triangles of the source
  Index levels = 0;     ///< heights of the kernel
  std::size_t filters = 0;
};

/// The format is that of kShareVersion (share_file.hpp).
std::string encodeCellShare(const CellShare& share);
/// Checks every number: any bytes give a usable share or BadBytes. The position of points relative to the geometry is
/// not checked.
CellShare decodeCellShare(std::string_view bytes, const ShareRange& range);

/// The cuts of one floor, as in a share.
void writeCuts(ByteWriter& out, const FaceCuts& cuts);
std::shared_ptr<const FaceCuts> readCuts(ByteReader& in, const ShareRange& range);

}  // namespace footfall::detail
