// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile.hpp"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include "core/base/byte_stream.hpp"
#include "core/base/digest.hpp"

namespace footfall::detail {
namespace {

constexpr std::string_view kMagic{"FFTILE\r\n", 8};
constexpr std::size_t kLeastFace = 74, kLeastTriangle = 4, kLeastVertex = 25, kLeastBorder = 3, kLeastOutside = 26,
                      kLeastLink = 5;
constexpr std::size_t kPolled = 1 << 15;

void encode(const Vec3& place, ByteWriter& out) {
  for (const double x : {place.x, place.y, place.z}) out.real(x);
}

Vec3 decodePlace(ByteReader& in) {
  Vec3 place;
  for (double* x : {&place.x, &place.y, &place.z})
    if (*x = in.real(); !std::isfinite(*x)) throw BadBytes("is damaged");
  return place;
}

void encode(const PlanPoint& point, ByteWriter& out) {
  const auto add = [&out](std::initializer_list<Index> numbers) {
    for (const Index number : numbers) out.signedNumber(number);
  };
  out.number(static_cast<std::uint64_t>(point.kind()));
  switch (point.kind()) {
    case PlanPoint::Source:
      return add({point.planId()});
    case PlanPoint::EdgePlane:
      return add({point.edgeBegin(), point.edgeEnd(), point.triangle(), point.level()});
    case PlanPoint::Crossing:
      for (const PlanLine& line : {point.firstLine(), point.secondLine()}) add({line.kind, line.a, line.b});
      return add({point.face()});
  }
}

void encode(const TileGeometry& geometry, ByteWriter& out, const Poll& poll) {
  std::size_t polled = 0;
  out.number(geometry.heights.size());
  for (const double height : geometry.heights) out.real(height);
  out.number(geometry.corners.size());
  for (const Vec3& corner : geometry.corners) encode(corner, out);
  out.number(geometry.triangles.size());
  for (const TileSource& triangle : geometry.triangles) {
    if (++polled % kPolled == 0) poll();
    for (const Index corner : triangle.corners) out.number(static_cast<std::uint64_t>(corner));
    out.number(triangle.number);
  }
  out.number(geometry.vertices.size());
  for (const MeshVertex& vertex : geometry.vertices) {
    if (++polled % kPolled == 0) poll();
    encode(vertex.point, out);
    out.signedNumber(vertex.face);
    out.signedNumber(vertex.source);
    for (const double x : {vertex.x, vertex.y, vertex.z, vertex.error}) out.real(x);
  }
}

std::string encodeContent(const Tile& tile, const Poll& poll) {
  std::size_t polled = 0;
  ByteWriter out;
  out.number(tile.faces.size());
  for (const TileFace& face : tile.faces) {
    if (++polled % kPolled == 0) poll();
    out.number(face.source);
    out.number(face.triangles);
    for (const Vec3& corner : face.corners) encode(corner, out);
  }
  out.number(tile.places.size());
  for (std::size_t v = 0; v < tile.places.size(); ++v) {
    if (++polled % kPolled == 0) poll();
    encode(tile.places[v], out);
    out.bytes.push_back(static_cast<char>(tile.exact[v]));
  }
  out.number(tile.triangles.size());
  for (const MeshTriangle& triangle : tile.triangles) {
    if (++polled % kPolled == 0) poll();
    for (const Index corner : triangle.corners) out.number(static_cast<std::uint64_t>(corner));
    out.number(triangle.obstacleEdges);
  }
  out.number(tile.borders.size());
  Index before = 0;
  for (const TileBorder& border : tile.borders) {
    out.number(static_cast<std::uint64_t>(border.vertex - std::exchange(before, border.vertex)));
    out.number(border.face);
    out.text(border.exact);
  }
  out.number(tile.outside.size());
  for (const TileOutside& vertex : tile.outside) {
    encode(vertex.place, out);
    out.number(vertex.face);
    out.text(vertex.exact);
  }
  out.number(tile.links.size());
  for (const TileLink& link : tile.links) {
    if (++polled % kPolled == 0) poll();
    for (const Index v : {link.from[0], link.from[1], link.to[0], link.to[1]})
      out.number(static_cast<std::uint64_t>(v));
    out.number((link.hasFrom ? 1U : 0U) | (link.hasTo ? 2U : 0U) | (link.isGap ? 4U : 0U));
  }
  out.number(tile.pieces.size());
  for (const TilePiece& piece : tile.pieces) {
    if (++polled % kPolled == 0) poll();
    out.number(piece.number);
    out.number(static_cast<std::uint64_t>(piece.plane));
  }
  out.number(tile.layers.size());
  for (const std::uint32_t layer : tile.layers) out.number(layer);
  encode(tile.geometry, out, poll);
  return std::move(out.bytes);
}

std::uint32_t decodeNumber(ByteReader& in) {
  const std::uint64_t number = in.number();
  if (number > std::numeric_limits<std::uint32_t>::max()) throw BadBytes("is damaged");
  return static_cast<std::uint32_t>(number);
}

void decodeFaces(ByteReader& in, Tile& tile, const Poll& poll) {
  std::size_t polled = 0;
  tile.faces.resize(in.count(kLeastFace));
  for (TileFace& face : tile.faces) {
    if (++polled % kPolled == 0) poll();
    face.source = decodeNumber(in);
    face.triangles = decodeNumber(in);
    for (Vec3& corner : face.corners) corner = decodePlace(in);
  }
  tile.places.resize(in.count(kLeastVertex));
  tile.exact.resize(tile.places.size());
  for (std::size_t v = 0; v < tile.places.size(); ++v) {
    if (++polled % kPolled == 0) poll();
    tile.places[v] = decodePlace(in);
    tile.exact[v] = static_cast<char>(in.below(2));
  }
}

void decodeTriangles(ByteReader& in, Tile& tile, const Poll& poll) {
  std::size_t polled = 0;
  const auto vertices = static_cast<std::int64_t>(tile.places.size());
  tile.triangles.resize(in.count(kLeastTriangle));
  std::size_t face = 0;
  std::uint64_t ofFace = 0;
  for (MeshTriangle& triangle : tile.triangles) {
    if (++polled % kPolled == 0) poll();
    while (face < tile.faces.size() && ofFace == tile.faces[face].triangles) ++face, ofFace = 0;
    if (face == tile.faces.size()) throw BadBytes("is damaged");
    ++ofFace;
    triangle.face = static_cast<Index>(face);
    for (Index& corner : triangle.corners) corner = in.below(vertices);
    triangle.obstacleEdges = static_cast<std::uint8_t>(in.below(8));
  }
  for (; face < tile.faces.size(); ++face, ofFace = 0)
    if (tile.faces[face].triangles != ofFace) throw BadBytes("is damaged");
  tile.borders.resize(in.count(kLeastBorder));
  std::int64_t vertex = 0;
  for (TileBorder& border : tile.borders) {
    const std::int64_t step = in.below(vertices - vertex);
    if (step == 0 && &border != tile.borders.data()) throw BadBytes("is damaged");  // one vertex twice
    vertex += step;
    border.vertex = static_cast<Index>(vertex);
    border.face = decodeNumber(in);
    border.exact = in.text();
  }
}

void decodeLinks(ByteReader& in, Tile& tile, const Poll& poll) {
  std::size_t polled = 0;
  tile.outside.resize(in.count(kLeastOutside));
  for (TileOutside& vertex : tile.outside) {
    if (++polled % kPolled == 0) poll();
    vertex.place = decodePlace(in);
    vertex.face = decodeNumber(in);
    vertex.exact = in.text();
  }
  const auto vertices = static_cast<std::int64_t>(tile.places.size() + tile.outside.size());
  tile.links.resize(in.count(kLeastLink));
  for (TileLink& link : tile.links) {
    if (++polled % kPolled == 0) poll();
    for (Index* v : {&link.from[0], &link.from[1], &link.to[0], &link.to[1]}) *v = in.below(vertices);
    const std::int32_t bits = in.below(8);
    link.hasFrom = (bits & 1) != 0;
    link.hasTo = (bits & 2) != 0;
    link.isGap = (bits & 4) != 0;
  }
}

/// Either none or one for each triangle.
std::size_t decodeCount(ByteReader& in, std::size_t least, std::size_t triangles) {
  const std::size_t count = in.count(least);
  if (count != 0 && count != triangles) throw BadBytes("is damaged");
  return count;
}

void decodePieces(ByteReader& in, Tile& tile, const Poll& poll) {
  std::size_t polled = 0;
  tile.pieces.resize(decodeCount(in, 2, tile.triangles.size()));
  for (TilePiece& piece : tile.pieces) {
    if (++polled % kPolled == 0) poll();
    piece.number = decodeNumber(in);
    piece.plane = in.below(static_cast<std::int64_t>(tile.faces.size()));
  }
  tile.layers.resize(decodeCount(in, 1, tile.triangles.size()));
  for (std::uint32_t& layer : tile.layers) layer = decodeNumber(in);
}

/// Reads what vertices are made of; every number is in range.
class GeometryReader {
 public:
  GeometryReader(ByteReader& in, TileGeometry& geometry) : in_(in), geometry_(geometry) {}

  void read(std::size_t vertices, const Poll& poll) {
    std::size_t polled = 0;
    geometry_.heights.resize(in_.count(8));
    for (double& height : geometry_.heights) height = in_.real();
    geometry_.corners.resize(in_.count(24));
    for (Vec3& corner : geometry_.corners) corner = decodePlace(in_);
    geometry_.triangles.resize(in_.count(4));
    for (TileSource& triangle : geometry_.triangles) {
      if (++polled % kPolled == 0) poll();
      for (Index& c : triangle.corners) c = corner();
      triangle.number = decodeNumber(in_);
    }
    geometry_.vertices.resize(in_.count(36));
    if (!geometry_.vertices.empty() && geometry_.vertices.size() != vertices) throw BadBytes("is damaged");
    for (MeshVertex& vertex : geometry_.vertices) {
      if (++polled % kPolled == 0) poll();
      vertex.point = point();
      vertex.face = triangle();
      vertex.source = between(-1, static_cast<std::int64_t>(geometry_.corners.size()));
      for (double* x : {&vertex.x, &vertex.y, &vertex.z, &vertex.error}) *x = in_.real();
    }
  }

 private:
  Index between(std::int64_t least, std::int64_t end) {
    const std::int64_t number = in_.signedNumber();
    if (number < least || number >= end) throw BadBytes("is damaged");
    return static_cast<Index>(number);
  }
  Index corner() { return in_.below(static_cast<std::int64_t>(geometry_.corners.size())); }
  Index plan() { return between(0, static_cast<std::int64_t>(geometry_.corners.size())); }
  Index triangle() { return between(0, static_cast<std::int64_t>(geometry_.triangles.size())); }
  Index level() {
    const auto most = static_cast<std::int64_t>(geometry_.heights.size());
    return between(-most, most + 1);
  }
  PlanLine line() {
    if (between(PlanLine::Edge, PlanLine::Trace + 1) == PlanLine::Edge) {
      const Index a = plan();
      return {PlanLine::Edge, a, plan()};
    }
    const Index obstacle = triangle();
    return {PlanLine::Trace, obstacle, level()};
  }
  PlanPoint point() {
    const Index kind = in_.below(PlanPoint::Crossing + 1);
    if (kind == PlanPoint::Source) return PlanPoint::source(plan());
    if (kind == PlanPoint::EdgePlane) {
      const Index u = plan(), v = plan(), plane = triangle();
      return PlanPoint::edgePlane(u, v, plane, level());
    }
    const PlanLine first = line(), second = line();
    return PlanPoint::crossing(first, second, between(-1, static_cast<std::int64_t>(geometry_.triangles.size())));
  }

  ByteReader& in_;
  TileGeometry& geometry_;
};

}  // namespace

std::string encodeTile(const Tile& tile, const Poll& poll) {
  const std::string content = encodeContent(tile, poll);
  ByteWriter out;
  out.bytes.reserve(content.size() + 64);
  out.bytes = kMagic;
  out.fixed(kTileVersion);
  out.fixed(content.size());
  for (const std::uint64_t word : Digest().add(content).value()) out.fixed(word);
  out.bytes += content;
  return std::move(out.bytes);
}

Tile decodeTile(std::string_view bytes, const Poll& poll) {
  if (bytes.substr(0, kMagic.size()) != kMagic) throw BadBytes("is no tile");
  ByteReader head(bytes.substr(kMagic.size()));
  std::string_view content;
  try {
    if (head.fixed() != kTileVersion) throw BadBytes("is a tile of another version");
    const std::uint64_t size = head.fixed();
    Digest::Value sum;
    for (std::uint64_t& word : sum) word = head.fixed();
    content = head.rest();
    if (content.size() < size) throw BadBytes("is cut off");
    if (content.size() > size || Digest().add(content).value() != sum) throw BadBytes("is damaged");
  } catch (const BadBytes& error) {
    throw std::string_view(error.what()).substr(0, 3) == "is " ? error : BadBytes("is cut off");
  }
  Tile tile;
  try {
    ByteReader in(content);
    decodeFaces(in, tile, poll);
    decodeTriangles(in, tile, poll);
    decodeLinks(in, tile, poll);
    decodePieces(in, tile, poll);
    GeometryReader(in, tile.geometry).read(tile.places.size(), poll);
    in.expectEnd();
  } catch (const BadBytes&) {
    throw BadBytes("is damaged");
  }
  return tile;
}

}  // namespace footfall::detail
