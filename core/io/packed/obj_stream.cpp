// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <string_view>

#include "core/io/obj_parser.hpp"
#include "core/io/packed/packer_polygons.hpp"
#include "core/io/packed/streams.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{4} << 20;
constexpr std::size_t kLongestPiece = std::size_t{64} << 20;  ///< a file with longer lines is read as a whole

/// Whole statements of a file, piece by piece.
class ObjPieces {
 public:
  explicit ObjPieces(const std::string& path) : file_(path) {}

  /// The next piece, up to a line end without a backslash; empty at the end.
  std::string_view next() {
    text_.erase(0, used_);
    used_ = 0;
    for (;;) {
      const std::size_t kept = text_.size(), wanted = std::min(kPieceBytes, kLongestPiece - kept);
      text_.resize(kept + wanted);
      const std::size_t count = file_.read(offset_, text_.data() + kept, wanted);
      text_.resize(kept + count);
      offset_ += count;
      if (count < wanted) return take(text_.size());
      if (const std::size_t end = lastStatementEnd(); end > 0) return take(end);
      if (text_.size() >= kLongestPiece) {
        isTooLong_ = true;
        return {};
      }
    }
  }
  [[nodiscard]] bool isTooLong() const { return isTooLong_; }
  [[nodiscard]] double done() const {
    return static_cast<double>(offset_) / static_cast<double>(std::max<std::uint64_t>(file_.size(), 1));
  }

 private:
  // The parser needs a NUL behind its text.
  std::string_view take(std::size_t end) {
    piece_.assign(text_, 0, end);
    used_ = end;
    return piece_;
  }
  [[nodiscard]] std::size_t lastStatementEnd() const {
    for (std::size_t end = text_.rfind('\n'); end != std::string::npos && end > 0; end = text_.rfind('\n', end - 1)) {
      const std::size_t last = text_[end - 1] == '\r' && end > 1 ? end - 2 : end - 1;
      if (text_[last] != '\\') return end + 1;
    }
    return 0;
  }

  InputFile file_;
  std::uint64_t offset_ = 0;
  std::string text_, piece_;
  std::size_t used_ = 0;
  bool isTooLong_ = false;
};

class ObjStream {
 public:
  ObjStream(const std::string& path, Environment& head, EnvironmentPacker& packer, RunContext* context)
      : path_(path), head_(head), packer_(packer), context_(context) {}

  bool read() {
    switch (pass(Want::Everything)) {
      case Outcome::Done:
        return true;
      case Outcome::TooLong:
        return false;
      case Outcome::NeedsVertices:
        break;
    }
    packer_.restart();
    head_.skipped = {};
    head_.parts.clear();
    return pass(Want::Vertices) == Outcome::Done && pass(Want::Faces) == Outcome::Done;
  }

 private:
  enum class Want { Everything, Vertices, Faces };
  enum class Outcome { Done, TooLong, NeedsVertices };

  Outcome pass(Want want) {
    ObjPieces pieces(path_);
    ObjPartAssigner parts(head_, 0);
    ObjBefore before;
    ObjForwardReference largest;
    bool isFirst = true;
    for (std::string_view text = pieces.next(); !text.empty(); text = pieces.next()) {
      if (context_ != nullptr) {
        context_->checkCancelled();
        context_->progress((want == Want::Faces ? 0.25 : 0) + pieces.done() * (want == Want::Everything ? 0.5 : 0.25));
      }
      rejectBinary(path_, text, before.lines);
      if (isFirst && text.find('\n') == std::string_view::npos) return Outcome::TooLong;  // lone carriage returns
      if (isFirst && text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
      isFirst = false;
      Environment found;
      ObjParser parser(path_, text, ObjParser::Extent::Ordered, found, context_, nullptr, before);
      parser.parseStatements();
      before = {before.vertices + found.vertices.size(), parser.lineCount()};
      if (parser.largestForward() > largest.index) largest = {parser.largestForward(), parser.largestForwardLine()};
      if (want != Want::Faces)
        for (const Vec3& place : found.vertices) packer_.addVertex(place);
      if (want == Want::Vertices) continue;
      if (parser.hasPolygons() && parser.largestForward() > packer_.vertexCount()) return Outcome::NeedsVertices;
      addFaces(parser, found, parts);
    }
    if (pieces.isTooLong()) return Outcome::TooLong;
    checkForwardReference(path_, largest, before.vertices);
    if (want != Want::Vertices) parts.finish();
    return Outcome::Done;
  }

  void addFaces(ObjParser& parser, Environment& found, ObjPartAssigner& parts) {
    parser.splitPolygons(PackerVertices{packer_});
    parts.add(parser.parts(), found.triangles.size());
    for (std::size_t t = 0; t < found.triangles.size(); ++t) packer_.addFace(found.triangles[t], head_.partOf[t]);
    head_.partOf.clear();
    head_.skipped.points += found.skipped.points;
    head_.skipped.lines += found.skipped.lines;
    appendSkippedPolygons(head_.skipped, found.skipped, 0);
  }

  const std::string& path_;
  Environment& head_;
  EnvironmentPacker& packer_;
  RunContext* context_;
};

}  // namespace

bool streamObj(const std::string& path, Environment& head, EnvironmentPacker& packer, RunContext* context) {
  return ObjStream(path, head, packer, context).read();
}

}  // namespace footfall::detail
