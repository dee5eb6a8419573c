// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/distributed/cell_share.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace footfall::detail {
namespace {

constexpr std::uint8_t kAllEdges = 7;
// More regions than that above one point have more sides than a source can have triangles.
constexpr std::int64_t kMostWinding = std::int64_t{1} << 31;

class ShareWriter {
 public:
  explicit ShareWriter(ByteWriter& out) : out_(out) {}

  void write(const CellShare& share) {
    out_.number(share.faces.size());
    for (const FaceResult& result : share.faces) {
      index(result.face);
      cuts(*result.cuts);
      if (!result.cuts->removed && !result.cuts->segments.empty()) mesh(*result.mesh);
    }
    out_.number(share.parts.size());
    for (const FacePart& part : share.parts) {
      index(part.face);
      this->part(part.share);
    }
    times(share.times);
  }
  void cuts(const FaceCuts& cuts) { common(cuts); }

 private:
  void index(Index i) { out_.number(static_cast<std::uint64_t>(i)); }
  void orNone(Index i) { out_.number(static_cast<std::uint64_t>(i + 1)); }
  void flags(bool removed, bool dependsOnFloors, std::uint8_t edgeWalls) {
    out_.number(static_cast<std::uint64_t>(edgeWalls) << 2 | (dependsOnFloors ? 2U : 0U) | (removed ? 1U : 0U));
  }

  void line(const PlanLine& line) {
    index(line.kind);
    index(line.a);
    out_.signedNumber(line.b);
  }
  template <class Lines>
  void lines(const Lines& lines) {
    out_.number(lines.size());
    for (const PlanLine& l : lines) line(l);
  }

  void point(const PlanPoint& point) {
    index(point.kind());
    switch (point.kind()) {
      case PlanPoint::Source:
        index(point.planId());
        break;
      case PlanPoint::EdgePlane:
        index(point.edgeBegin());
        index(point.edgeEnd());
        index(point.triangle());
        out_.signedNumber(point.level());
        break;
      case PlanPoint::Crossing:
        line(point.firstLine());
        line(point.secondLine());
        orNone(point.face());
        break;
    }
  }

  void segment(const CutSegment& segment) {
    orNone(segment.from);
    orNone(segment.to);
    index(segment.line);
    out_.number((segment.wall ? 2U : 0U) | (segment.direction > 0 ? 1U : 0U));
    out_.signedNumber(segment.winding);
  }

  // The members that cuts and their parts have in common.
  template <class Cuts>
  void common(const Cuts& cuts) {
    flags(cuts.removed, cuts.dependsOnFloors, cuts.edgeWalls);
    out_.signedNumber(cuts.startWinding);
    lines(cuts.lines);
    out_.number(cuts.points.size());
    for (std::size_t i = 0; i < cuts.points.size(); ++i) {
      point(cuts.points[i]);
      out_.number(cuts.borders[i]);
    }
    out_.number(cuts.segments.size());
    for (const CutSegment& s : cuts.segments) segment(s);
  }
  void part(const FaceShare& share) {
    common(share);
    out_.number(share.pieces.size());
    for (const FaceShare::Piece& piece : share.pieces) {
      index(piece.obstacle);
      segment(piece.segment);
    }
  }

  void mesh(const FaceMesh& mesh) {
    lines(mesh.lines);
    out_.number(mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      point(mesh.points[i]);
      out_.real(mesh.approximate[i].x);
      out_.real(mesh.approximate[i].y);
      out_.real(mesh.approximate[i].error);
    }
    out_.number(mesh.facets.size());
    for (const FaceMesh::Facet& facet : mesh.facets) {
      out_.number(static_cast<std::uint64_t>(facet.obstacleEdges) << 3 | facet.outlineEdges);
      for (int k = 0; k < 3; ++k) {
        index(facet.corners[k]);
        out_.number(static_cast<std::uint64_t>(facet.faceEdges[k] + 1));
        orNone(facet.lines[k]);
      }
    }
  }

  void times(const ShareTimes& times) {
    index(times.thread);
    out_.real(times.startMs);
    out_.real(times.endMs);
    out_.number(times.spans.size());
    for (const ShareTimes::Span& span : times.spans) {
      out_.number(span.filter);
      index(span.thread);
      out_.real(span.startMs);
      out_.real(span.endMs);
    }
  }

  ByteWriter& out_;
};

class ShareReader {
 public:
  ShareReader(ByteReader& in, const ShareRange& range) : in_(in), range_(range) {}

  CellShare read() {
    CellShare share;
    const std::size_t faces = in_.count(2);
    for (std::size_t i = 0; i < faces; ++i) {
      FaceResult& result = share.faces.emplace_back();
      result.face = in_.below(range_.triangles);
      result.cuts = cuts();
      if (!result.cuts->removed && !result.cuts->segments.empty()) result.mesh = mesh();
    }
    const std::size_t parts = in_.count(2);
    for (std::size_t i = 0; i < parts; ++i) {
      FacePart& part = share.parts.emplace_back();
      part.face = in_.below(range_.triangles);
      common(part.share);
      pieces(part.share);
    }
    share.times = times();
    in_.expectEnd();
    expectEachFloorOnce(share);
    return share;
  }
  std::shared_ptr<const FaceCuts> cuts() {
    auto cuts = std::make_shared<FaceCuts>();
    common(*cuts);
    // A floor that regions cover from border to border is removed.
    if (cuts->segments.empty() && cuts->startWinding != 0) throw BadBytes("a winding number has no segments");
    return cuts;
  }

 private:
  static void expectEachFloorOnce(const CellShare& share) {
    std::vector<Index> floors;
    for (const FaceResult& result : share.faces) floors.push_back(result.face);
    for (const FacePart& part : share.parts) floors.push_back(part.face);
    std::sort(floors.begin(), floors.end());
    if (std::adjacent_find(floors.begin(), floors.end()) != floors.end()) throw BadBytes("a floor is there twice");
  }
  Index orNone(std::size_t end) { return in_.below(static_cast<std::int64_t>(end) + 1) - 1; }

  Index level() {
    const std::int64_t level = in_.signedNumber();
    if (level < -range_.levels || level > range_.levels) throw BadBytes("a level is out of range");
    return static_cast<Index>(level);
  }

  // Borders between cells are never part of what cells find.
  PlanLine line() {
    PlanLine line;
    line.kind = in_.below(PlanLine::Border);
    if (line.kind == PlanLine::Trace) {
      line.a = in_.below(range_.triangles);
      line.b = level();
      return line;
    }
    line.a = in_.below(range_.vertices);
    const std::int64_t b = in_.signedNumber();
    if (b <= line.a || b >= range_.vertices) throw BadBytes("an edge has no second end");
    line.b = static_cast<Index>(b);
    return line;
  }
  template <class Lines>
  void lines(Lines& lines) {
    lines.resize(in_.count(3));
    for (PlanLine& l : lines) l = line();
  }

  PlanPoint point() {
    const Index kind = in_.below(PlanPoint::Crossing + 1);
    if (kind == PlanPoint::Source) return PlanPoint::source(in_.below(range_.vertices));
    if (kind == PlanPoint::EdgePlane) {
      const Index u = in_.below(range_.vertices), v = in_.below(range_.vertices);
      if (u == v) throw BadBytes("an edge has one end");
      const Index triangle = in_.below(range_.triangles);
      return PlanPoint::edgePlane(u, v, triangle, level());
    }
    const PlanLine first = line(), second = line();
    const Index face = orNone(static_cast<std::size_t>(range_.triangles));
    if (first == second) throw BadBytes("a line crosses itself");
    if (face < 0 && (first.kind == PlanLine::Trace || second.kind == PlanLine::Trace))
      throw BadBytes("a trace has no face");
    return PlanPoint::crossing(first, second, face);
  }

  int winding() {
    const std::int64_t winding = in_.signedNumber();
    if (winding <= -kMostWinding || winding >= kMostWinding) throw BadBytes("a winding number is out of range");
    return static_cast<int>(winding);
  }

  CutSegment segment(std::size_t points, std::size_t lines, bool needsEnds) {
    CutSegment segment;
    segment.from = orNone(points);
    segment.to = orNone(points);
    if (needsEnds && (segment.from < 0 || segment.to < 0)) throw BadBytes("a segment has no end");
    segment.line = in_.below(static_cast<std::int64_t>(lines));
    const Index bits = in_.below(4);
    segment.wall = (bits & 2) != 0;
    segment.direction = (bits & 1) != 0 ? 1 : -1;
    segment.winding = winding();
    return segment;
  }

  template <class Cuts>
  void common(Cuts& cuts) {
    const Index flags = in_.below(32);
    cuts.removed = (flags & 1) != 0;
    cuts.dependsOnFloors = (flags & 2) != 0;
    cuts.edgeWalls = static_cast<std::uint8_t>(flags >> 2);
    cuts.startWinding = winding();
    lines(cuts.lines);
    const std::size_t points = in_.count(3);
    cuts.points.resize(points);
    cuts.borders.resize(points);
    for (std::size_t i = 0; i < points; ++i) {
      cuts.points[i] = point();
      cuts.borders[i] = static_cast<std::uint8_t>(in_.below(kAllEdges + 1));
    }
    cuts.segments.resize(in_.count(5));
    for (CutSegment& s : cuts.segments) s = segment(points, cuts.lines.size(), true);
  }

  void pieces(FaceShare& share) {
    share.pieces.resize(in_.count(6));
    for (FaceShare::Piece& piece : share.pieces) {
      piece.obstacle = in_.below(range_.triangles);
      piece.segment = segment(share.points.size(), share.lines.size(), false);
    }
  }

  double finite() {
    const double value = in_.real();
    if (!std::isfinite(value)) throw BadBytes("a number is not finite");
    return value;
  }

  std::shared_ptr<const FaceMesh> mesh() {
    auto mesh = std::make_shared<FaceMesh>();
    lines(mesh->lines);
    const std::size_t points = in_.count(26);
    if (points < 3) throw BadBytes("a face has no corners");
    mesh->points.resize(points);
    mesh->approximate.resize(points);
    for (std::size_t i = 0; i < points; ++i) {
      mesh->points[i] = point();
      // These bounds can be infinite in tiny and in huge environments; they are of no use then.
      ApproximatePoint& place = mesh->approximate[i];
      place.x = in_.real();
      place.y = in_.real();
      place.error = in_.real();
    }
    mesh->facets.resize(in_.count(10));
    for (FaceMesh::Facet& facet : mesh->facets) {
      const Index edges = in_.below(64);
      facet.obstacleEdges = static_cast<std::uint8_t>(edges >> 3);
      facet.outlineEdges = static_cast<std::uint8_t>(edges & kAllEdges);
      for (int k = 0; k < 3; ++k) {
        facet.corners[k] = in_.below(static_cast<std::int64_t>(points));
        facet.faceEdges[k] = static_cast<std::int8_t>(in_.below(4) - 1);
        facet.lines[k] = orNone(mesh->lines.size());
        if ((facet.outlineEdges >> k & 1) != 0 && facet.lines[k] < 0) throw BadBytes("an outline has no line");
      }
    }
    return mesh;
  }

  ShareTimes times() {
    constexpr std::int64_t kMostThreads = 1 << 16;
    ShareTimes times;
    times.thread = in_.below(kMostThreads);
    times.startMs = finite();
    times.endMs = finite();
    times.spans.resize(in_.count(18));
    for (ShareTimes::Span& span : times.spans) {
      span.filter = static_cast<std::size_t>(in_.below(static_cast<std::int64_t>(range_.filters)));
      span.thread = in_.below(kMostThreads);
      span.startMs = finite();
      span.endMs = finite();
    }
    return times;
  }

  ByteReader& in_;
  const ShareRange& range_;
};

}  // namespace

std::string encodeCellShare(const CellShare& share) {
  ByteWriter out;
  ShareWriter(out).write(share);
  return std::move(out.bytes);
}

CellShare decodeCellShare(std::string_view bytes, const ShareRange& range) {
  ByteReader in(bytes);
  return ShareReader(in, range).read();
}

void writeCuts(ByteWriter& out, const FaceCuts& cuts) { ShareWriter(out).cuts(cuts); }

std::shared_ptr<const FaceCuts> readCuts(ByteReader& in, const ShareRange& range) {
  return ShareReader(in, range).cuts();
}

}  // namespace footfall::detail
