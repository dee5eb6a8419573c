// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/packed/block_writer.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/digest.hpp"
#include "core/io/packed/coarse_faces.hpp"

namespace footfall::detail {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;
constexpr std::size_t kKeptCoarse = std::size_t{4} << 20;  // bytes in memory
constexpr int kSlotBits = 17;
constexpr std::uint32_t kSlots = 1U << kSlotBits;  // more than twice kBlockVertices
static_assert(kSlots > 2 * kBlockVertices && kBlockVertices <= 65536);

template <class Item>
void append(std::string& bytes, const std::vector<Item>& items) {
  bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item));
}

template <class Item>
std::string_view bytesOf(const Item& item) {
  return {reinterpret_cast<const char*>(&item), sizeof(Item)};
}

void pad(GrowingFile& file, const Poll& poll) {
  file.append(std::string(alignedOffset(file.size()) - file.size(), '\0'), poll);
}

Box boxOf(const std::vector<Vec3>& places) {
  const Vec3& first = places.front();
  Box box{{first.x, first.y, first.z}, {first.x, first.y, first.z}};
  for (const Vec3& p : places) {
    const std::array<double, 3> place{p.x, p.y, p.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lower[axis] = std::min(box.lower[axis], place[axis]);
      box.upper[axis] = std::max(box.upper[axis], place[axis]);
    }
  }
  return box;
}

}  // namespace

BlockWriter::BlockWriter(const std::string& target, std::uint64_t vertices, std::uint64_t faces, bool hasParts,
                         Poll poll)
    : file_(target),
      coarse_(target, kKeptCoarse),
      vertexCount_(vertices),
      faceCount_(faces),
      mostCoarse_(coarseFacesOf((faces + kBlockFaces - 1) / kBlockFaces)),
      hasParts_(hasParts),
      poll_(poll),
      isWritten_((vertices + 63) / 64),
      slots_(kSlots, kNone) {
  file_.append(std::string(sizeof(PackedHeader), '\0'), poll_);
}

void BlockWriter::add(const PackedFace& face) {
  std::array<std::uint16_t, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = static_cast<std::uint16_t>(localOf(face.corners[k], face.places[k]));
  corners_.push_back(corners);
  faces_.push_back(face.number);
  if (hasParts_) parts_.push_back(face.part);
  if (faces_.size() == kBlockFaces) flush();
}

std::uint32_t BlockWriter::localOf(std::uint32_t vertex, const Vec3& place) {
  for (std::uint32_t at = (vertex * 0x9e3779b1U) >> (32 - kSlotBits);; at = (at + 1) % kSlots) {
    if (slots_[at] != kNone && vertices_[slots_[at]] != vertex) continue;
    if (slots_[at] == kNone) {
      slots_[at] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(vertex);
      places_.push_back(place);
    }
    return slots_[at];
  }
}

void BlockWriter::flush() {
  if (vertices_.empty()) return;
  orderOwnFirst();
  writeBlock();
  std::fill(slots_.begin(), slots_.end(), kNone);
  places_.clear();
  vertices_.clear();
  faces_.clear();
  parts_.clear();
  corners_.clear();
  poll_();
}

void BlockWriter::orderOwnFirst() {
  const auto isOwn = [&](std::uint32_t vertex) { return (isWritten_[vertex / 64] >> (vertex % 64) & 1U) == 0; };
  own_ = static_cast<std::uint32_t>(std::count_if(vertices_.begin(), vertices_.end(), isOwn));
  std::vector<std::uint16_t> moved(vertices_.size());
  std::vector<std::uint32_t> vertices(vertices_.size());
  std::vector<Vec3> places(vertices_.size());
  std::uint32_t nextOwn = 0, nextOther = own_;
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const std::uint32_t to = isOwn(vertices_[v]) ? nextOwn++ : nextOther++;
    moved[v] = static_cast<std::uint16_t>(to);
    vertices[to] = vertices_[v];
    places[to] = places_[v];
  }
  for (auto& corners : corners_)
    for (std::uint16_t& corner : corners) corner = moved[corner];
  for (std::uint32_t v = 0; v < own_; ++v) isWritten_[vertices[v] / 64] |= std::uint64_t{1} << (vertices[v] % 64);
  vertices_.swap(vertices);
  places_.swap(places);
}

void BlockWriter::writeBlock() {
  bytes_.clear();
  append(bytes_, places_);
  append(bytes_, vertices_);
  append(bytes_, faces_);
  append(bytes_, parts_);
  append(bytes_, corners_);
  pad(file_, poll_);
  PackedBlock& block = table_.emplace_back();
  block.box = boxOf(places_);
  block.offset = file_.size();
  block.size = bytes_.size();
  block.vertices = static_cast<std::uint32_t>(vertices_.size());
  block.ownVertices = own_;
  block.faces = static_cast<std::uint32_t>(faces_.size());
  block.sum = Digest().add(bytes_).value();
  file_.append(bytes_, poll_);
  addCoarse(block);
}

void BlockWriter::addCoarse(PackedBlock& block) {
  const std::vector<CoarseFace> faces = coarseFaces(places_, corners_, mostCoarse_);
  block.coarse = static_cast<std::uint32_t>(faces.size());
  const auto& [lower, upper] = block.box;
  bytes_.clear();
  for (const CoarseFace& face : faces) {
    PackedCoarseFace packed;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<double, 3> place{face[k].x, face[k].y, face[k].z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        // Halves are subtracted, because a box may be longer than any double.
        const double side = upper[axis] / 2 - lower[axis] / 2;
        const double share = side > 0 ? (place[axis] / 2 - lower[axis] / 2) / side : 0;
        packed[k][axis] = static_cast<std::uint16_t>(std::lround(65535 * std::clamp(share, 0.0, 1.0)));
      }
    }
    bytes_ += bytesOf(packed);
  }
  coarseSum_.add(bytes_);
  coarse_.append(bytes_);
}

PackedCoarse BlockWriter::writeCoarse() {
  constexpr std::uint64_t kAtOnce = std::uint64_t{1} << 20;
  pad(file_, poll_);
  PackedCoarse coarse;
  coarse.offset = file_.size();
  coarse.size = coarse_.size();
  coarse.sum = coarseSum_.value();
  std::string bytes;
  for (std::uint64_t at = 0; at < coarse.size; at += kAtOnce) {
    bytes.resize(static_cast<std::size_t>(std::min(kAtOnce, coarse.size - at)));
    coarse_.read(at, bytes.data(), bytes.size());
    file_.append(bytes, poll_);
  }
  return coarse;
}

void BlockWriter::addLoneVertices(const std::function<Vec3(std::uint32_t)>& vertexAt) {
  for (std::uint64_t word = 0; word < isWritten_.size(); ++word) {
    if (isWritten_[word] == ~std::uint64_t{0}) continue;
    for (std::uint64_t v = 64 * word; v < std::min(64 * word + 64, vertexCount_); ++v) {
      if ((isWritten_[word] >> (v % 64) & 1U) != 0) continue;
      vertices_.push_back(static_cast<std::uint32_t>(v));
      places_.push_back(vertexAt(static_cast<std::uint32_t>(v)));
    }
    if (vertices_.size() + 64 > kBlockVertices) flush();
  }
  flush();
}

PackedHeader BlockWriter::finish(const std::string& description, const std::function<Vec3(std::uint32_t)>& vertexAt) {
  flush();
  addLoneVertices(vertexAt);
  const PackedCoarse coarse = writeCoarse();
  PackedHeader header;
  std::copy(kPackedMagic.begin(), kPackedMagic.end(), header.magic.begin());
  header.vertices = vertexCount_;
  header.faces = faceCount_;
  header.blocks = table_.size();
  header.descriptionOffset = file_.size();
  header.descriptionSize = description.size();
  header.descriptionSum = Digest().add(description).value();
  file_.append(description, poll_);
  pad(file_, poll_);
  header.tableOffset = file_.size();
  std::string table(reinterpret_cast<const char*>(table_.data()), table_.size() * sizeof(PackedBlock));
  table += bytesOf(coarse);
  header.tableSum = Digest().add(table).value();
  file_.append(table, poll_);
  header.fileSize = file_.size();
  header.ownSum = Digest().add(bytesOf(header).substr(0, kSummedHeader)).value();
  file_.writeAt(0, bytesOf(header));
  file_.finish(poll_);
  return header;
}

}  // namespace footfall::detail
