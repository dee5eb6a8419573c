// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/intermediate.hpp"

#include <charconv>
#include <cmath>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/assembly/mesh_assembly.hpp"
#include "core/base/digest.hpp"
#include "core/distributed/cell_share.hpp"

namespace footfall::detail {
namespace {

constexpr std::string_view kBinaryMagic = "FFDOUBLE";
constexpr std::string_view kExactMagic = "FFEXACT\n";
constexpr std::uint64_t kVersion = 1;
constexpr std::uint32_t kPollEvery = 4096;

void addNumber(std::string& text, double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof(digits), value, std::chars_format::general, 17).ptr;
  text += ' ';
  text.append(digits, end);
}

void addNumber(std::string& text, std::uint32_t value) {
  char digits[16];
  text += ' ';
  text.append(digits, std::to_chars(digits, digits + sizeof(digits), value).ptr);
}

class TextReader {
 public:
  explicit TextReader(std::string_view text) : text_(text) {}

  [[nodiscard]] bool isAtEnd() const { return text_.empty(); }
  char character() {
    if (text_.empty()) throw BadBytes("the text ends too early");
    const char c = text_.front();
    text_.remove_prefix(1);
    return c;
  }
  void expect(char wanted) {
    if (character() != wanted) throw BadBytes("a line is neither a vertex nor a triangle");
  }
  template <class Number>
  Number number() {
    expect(' ');
    Number value{};
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
    if (error != std::errc()) throw BadBytes("a number cannot be read");
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return value;
  }

 private:
  std::string_view text_;
};

void requireFinite(const Vec3& v) {
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) throw BadBytes("a coordinate is not finite");
}

void requireVertices(const TriangleSoup& soup) {
  for (const Triangle& triangle : soup.triangles)
    for (const std::uint32_t v : triangle)
      if (v >= soup.vertices.size()) throw BadBytes("a triangle has a vertex that is not there");
}

Digest::Value digestOf(const SourceMesh& mesh) {
  return Digest()
      .add(std::span<const Vec3>(mesh.vertices))
      .add(std::span<const std::array<Index, 3>>(mesh.triangles))
      .value();
}

void writeFlags(ByteWriter& out, const std::vector<char>& flags) {
  for (std::size_t i = 0; i < flags.size(); i += 8) {
    unsigned byte = 0;
    for (std::size_t k = i; k < std::min(i + 8, flags.size()); ++k) byte |= (flags[k] != 0 ? 1U : 0U) << (k - i);
    out.bytes.push_back(static_cast<char>(byte));
  }
}

std::vector<char> readFlags(ByteReader& in, std::size_t count) {
  const std::string_view bytes = in.take((count + 7) / 8);
  std::vector<char> flags(count);
  for (std::size_t i = 0; i < count; ++i) flags[i] = static_cast<char>(bytes[i / 8] >> (i % 8) & 1);
  return flags;
}

double readHeight(ByteReader& in, bool mayBeZero) {
  const double height = in.real();
  if (!std::isfinite(height) || height < 0 || (height == 0 && !mayBeZero)) throw BadBytes("a height is out of range");
  return height;
}

}  // namespace

RoundedState roundState(const WalkableState& state, RunContext& context) {
  RoundedState rounded;
  std::uint32_t polls = 0;
  for (const MeshVertex& vertex : state.mesh->vertices) {
    if (++polls % kPollEvery == 0) context.checkCancelled();
    bool isExact = true;
    rounded.triangles.vertices.push_back(state.kernel->roundedPosition(vertex.point, vertex.face, &isExact));
    if (!isExact) ++rounded.inexact;
  }
  for (const MeshTriangle& triangle : state.mesh->triangles)
    rounded.triangles.triangles.push_back({static_cast<std::uint32_t>(triangle.corners[0]),
                                           static_cast<std::uint32_t>(triangle.corners[1]),
                                           static_cast<std::uint32_t>(triangle.corners[2])});
  return rounded;
}

std::string writeAscii(const TriangleSoup& soup) {
  std::string text;
  for (const Vec3& v : soup.vertices) {
    text += 'v';
    for (const double c : {v.x, v.y, v.z}) addNumber(text, c);
    text += '\n';
  }
  for (const Triangle& triangle : soup.triangles) {
    text += 'f';
    for (const std::uint32_t v : triangle) addNumber(text, v + 1);
    text += '\n';
  }
  return text;
}

TriangleSoup readAscii(std::string_view text) {
  TriangleSoup soup;
  for (TextReader in(text); !in.isAtEnd(); in.expect('\n')) {
    if (const char kind = in.character(); kind == 'v') {
      Vec3& v = soup.vertices.emplace_back();
      for (double* c : {&v.x, &v.y, &v.z}) *c = in.number<double>();
      requireFinite(v);
    } else if (kind == 'f') {
      for (std::uint32_t& v : soup.triangles.emplace_back()) v = in.number<std::uint32_t>() - 1;
    } else {
      throw BadBytes("a line is neither a vertex nor a triangle");
    }
  }
  requireVertices(soup);
  return soup;
}

std::string writeBinary(const TriangleSoup& soup) {
  ByteWriter out;
  out.bytes.reserve(32 + 24 * soup.vertices.size() + 12 * soup.triangles.size());
  out.bytes = kBinaryMagic;
  out.fixed(kVersion);
  out.fixed(soup.vertices.size());
  out.fixed(soup.triangles.size());
  for (const Vec3& v : soup.vertices)
    for (const double c : {v.x, v.y, v.z}) out.real(c);
  for (const Triangle& triangle : soup.triangles)
    for (const std::uint32_t v : triangle)
      for (int shift = 0; shift < 32; shift += 8) out.bytes.push_back(static_cast<char>(v >> shift));
  return std::move(out.bytes);
}

TriangleSoup readBinary(std::string_view bytes) {
  ByteReader in(bytes);
  if (in.take(kBinaryMagic.size()) != kBinaryMagic) throw BadBytes("is no binary environment");
  if (in.fixed() != kVersion) throw BadBytes("is of another version");
  const std::uint64_t vertices = in.fixed(), triangles = in.fixed();
  if (vertices > in.rest().size() / 24 || triangles > in.rest().size() / 12)
    throw BadBytes("a list is longer than the bytes");
  TriangleSoup soup;
  soup.vertices.resize(vertices);
  for (Vec3& v : soup.vertices) {
    for (double* c : {&v.x, &v.y, &v.z}) *c = in.real();
    requireFinite(v);
  }
  soup.triangles.resize(triangles);
  for (Triangle& triangle : soup.triangles)
    for (std::uint32_t& v : triangle) {
      const std::string_view four = in.take(4);
      for (std::size_t i = 0; i < 4; ++i) v |= std::uint32_t{static_cast<unsigned char>(four[i])} << (8 * i);
    }
  in.expectEnd();
  requireVertices(soup);
  return soup;
}

std::string writeExact(const WalkableState& state) {
  if (!state.cuts || state.simplified || state.dropped || state.step > 0)
    throw std::logic_error("only what lies directly behind a clearance filter is known by its cuts");
  ByteWriter out;
  out.number(state.kernel->heights().size());
  for (const double height : state.kernel->heights()) out.real(height);
  out.real(state.clearance);
  out.real(state.agentHeight);
  writeFlags(out, state.walkable);
  writeFlags(out, state.removed);
  std::vector<Index> faces;
  for (std::size_t t = 0; t < state.walkable.size(); ++t)
    if (state.cuts->shared(t)) faces.push_back(static_cast<Index>(t));
  out.number(faces.size());
  for (const Index face : faces) {
    out.number(static_cast<std::uint64_t>(face));
    writeCuts(out, (*state.cuts)[face]);
  }
  ByteWriter head;
  head.bytes = kExactMagic;
  head.fixed(kVersion);
  for (const std::uint64_t word : digestOf(state.kernel->mesh())) head.fixed(word);
  for (const std::uint64_t word : Digest().add(head.bytes).add(out.bytes).value()) head.fixed(word);
  return std::move(head.bytes) + out.bytes;
}

std::shared_ptr<const WalkableState> readExact(std::string_view bytes, const WalkableState& source,
                                               RunContext& context) {
  ByteReader in(bytes);
  if (in.take(kExactMagic.size()) != kExactMagic) throw BadBytes("is no exact environment");
  if (in.fixed() != kVersion) throw BadBytes("is of another version");
  Digest::Value mesh, sum;
  for (std::uint64_t& word : mesh) word = in.fixed();
  const std::string_view head = bytes.substr(0, bytes.size() - in.rest().size());
  for (std::uint64_t& word : sum) word = in.fixed();
  if (Digest().add(head).add(in.rest()).value() != sum) throw BadBytes("is damaged");
  if (mesh != digestOf(source.kernel->mesh())) throw BadBytes("is of another environment");

  auto state = std::make_shared<WalkableState>();
  state->environment = source.environment;
  std::vector<double> heights(in.count(8));
  for (double& height : heights) height = readHeight(in, false);
  state->clearance = readHeight(in, true);
  state->agentHeight = readHeight(in, true);
  state->kernel = std::make_shared<PlanKernel>(source.kernel->sharedMesh(), heights);
  const std::size_t count = source.kernel->mesh().triangles.size();
  state->walkable = readFlags(in, count);
  state->removed = readFlags(in, count);
  const ShareRange range{static_cast<Index>(source.kernel->mesh().scaled.size()), static_cast<Index>(count),
                         static_cast<Index>(heights.size()), 0};
  auto cuts = std::make_shared<CutTable>(count);
  const std::size_t faces = in.count(2);
  for (std::size_t i = 0; i < faces; ++i) {
    if (i % kPollEvery == 0) context.checkCancelled();
    const Index face = in.below(range.triangles);
    cuts->set(static_cast<std::size_t>(face), readCuts(in, range));
  }
  in.expectEnd();
  state->cuts = std::move(cuts);
  ExactFallbacks ignored;
  state->mesh = assembleMesh(*state, context, ignored);
  return state;
}

}  // namespace footfall::detail
