// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/packed/packed_environment.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <list>
#include <mutex>
#include <string_view>
#include <unordered_map>

#include "core/base/byte_stream.hpp"
#include "core/base/digest.hpp"
#include "core/base/parallel.hpp"
#include "core/base/poll.hpp"
#include "core/io/file_frame.hpp"
#include "core/io/packed/packed_description.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

constexpr Pattern kPackAgain = FOOTFALL_TEXT("copy it again, or pack the original again");

std::array<double, 3> numbersOf(const Vec3& p) { return {p.x, p.y, p.z}; }

/// A box turned exactly, as places are.
Box turned(const Box& box, const Vec3& a, const Vec3& b) {
  Box result = box;
  const std::array<double, 3> p = numbersOf(a), q = numbersOf(b);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.lower[axis] = std::min(p[axis], q[axis]);
    result.upper[axis] = std::max(p[axis], q[axis]);
  }
  return result;
}

Vec3 pointOf(const std::array<double, 3>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

bool touch(const Box& a, const Box& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (a.lower[axis] > b.upper[axis] || b.lower[axis] > a.upper[axis]) return false;
  return true;
}

bool contains(const Box& box, const std::array<double, 3>& place) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(place[axis] >= box.lower[axis] && place[axis] <= box.upper[axis])) return false;
  return true;
}

bool isFinite(const Box& box) {
  const auto finite = [](double x) { return std::isfinite(x); };
  return std::all_of(box.lower.begin(), box.lower.end(), finite) &&
         std::all_of(box.upper.begin(), box.upper.end(), finite);
}

/// Returns whether this call is the first that claims the number.
bool claim(std::atomic<std::uint64_t>* bits, std::uint32_t number) {
  const std::uint64_t bit = std::uint64_t{1} << (number % 64);
  return (bits[number / 64].fetch_or(bit, std::memory_order_relaxed) & bit) == 0;
}

BlockFace faceOf(const BlockArrays& arrays, std::size_t block, std::size_t place, UpAxis up) {
  BlockFace face{block, place, arrays.faces[place], arrays.parts.empty() ? 0 : arrays.parts[place], {}};
  for (std::size_t k = 0; k < 3; ++k)
    face.corners[k] = fromFileFrame(pointOf(arrays.places[arrays.corners[place][k]]), up);
  return face;
}

CoarseFace coarseFaceOf(const PackedCoarseFace& packed, const Box& box, UpAxis up) {
  CoarseFace face;
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<double, 3> place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double share = packed[k][axis] / 65535.0;
      place[axis] = (1 - share) * box.lower[axis] + share * box.upper[axis];
    }
    face[k] = fromFileFrame(pointOf(place), up);
  }
  return face;
}

/// Collects chosen faces of several blocks.
class FaceCollector {
 public:
  void add(const BlockArrays& arrays, const BlockFace& chosen) {
    Found face{chosen.number, arrays.parts.empty() ? 0 : arrays.parts[chosen.place], {}};
    for (std::size_t k = 0; k < 3; ++k) {
      face.corners[k] = arrays.vertices[arrays.corners[chosen.place][k]];
      places_.push_back({face.corners[k], chosen.corners[k]});
    }
    faces_.push_back(face);
  }

  PackedFaces collected(bool hasParts, const Poll& poll) {
    sort(faces_, poll);
    sort(places_, poll);
    const auto isSame = [](const Place& a, const Place& b) { return a.number == b.number; };
    places_.erase(std::unique(places_.begin(), places_.end(), isSame), places_.end());
    PackedFaces result;
    std::vector<std::uint32_t>& numbers = result.vertexNumbers;
    for (const Place& place : places_) {
      numbers.push_back(place.number);
      result.soup.vertices.push_back(place.place);
    }
    for (const Found& face : faces_) {
      if (result.faceNumbers.size() % kPolled == 0) poll();
      Triangle& local = result.soup.triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        local[k] = static_cast<std::uint32_t>(std::lower_bound(numbers.begin(), numbers.end(), face.corners[k]) -
                                              numbers.begin());
      result.faceNumbers.push_back(face.number);
      if (hasParts) result.partOf.push_back(face.part);
    }
    return result;
  }

 private:
  struct Found {
    std::uint32_t number, part;
    Triangle corners;
  };
  struct Place {
    std::uint32_t number;
    Vec3 place;
  };
  static constexpr std::size_t kPolled = 1 << 16;

  // Sorts on all threads, because there may be millions of items.
  template <class Item>
  static void sort(std::vector<Item>& items, const Poll& poll) {
    std::size_t compared = 0;
    std::sort(items.begin(), items.end(), [&](const Item& a, const Item& b) {
      if (++compared % kPolled == 0) poll();
      return a.number < b.number;
    });
  }

  std::vector<Found> faces_;
  std::vector<Place> places_;
};

}  // namespace

Box boxOf(const BlockFace& face) {
  Box box{numbersOf(face.corners[0]), numbersOf(face.corners[0])};
  for (const Vec3& corner : face.corners) {
    const std::array<double, 3> p = numbersOf(corner);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lower[axis] = std::min(box.lower[axis], p[axis]);
      box.upper[axis] = std::max(box.upper[axis], p[axis]);
    }
  }
  return box;
}

/// A cache of the blocks that were read last, which are often needed again.
class PackedEnvironment::RecentBlocks {
 public:
  /// Returns null where the block is not cached.
  Bytes find(std::size_t block) {
    const std::lock_guard lock(mutex_);
    const auto found = places_.find(block);
    if (found == places_.end()) return nullptr;
    kept_.splice(kept_.end(), kept_, found->second);
    return found->second->bytes;
  }
  void keep(std::size_t block, const Bytes& bytes, std::uint64_t size) {
    const std::lock_guard lock(mutex_);
    if (places_.contains(block)) return;
    kept_.push_back({block, size, bytes});
    places_[block] = std::prev(kept_.end());
    held_ += size;
    release();
  }
  void limit(std::uint64_t most) {
    const std::lock_guard lock(mutex_);
    most_ = most;
    release();
  }
  void clear() {
    const std::lock_guard lock(mutex_);
    kept_.clear();
    places_.clear();
    held_ = 0;
  }

 private:
  struct Kept {
    std::size_t block = 0;
    std::uint64_t size = 0;
    Bytes bytes;
  };

  // Keeps the last block.
  void release() {
    while (held_ > most_ && kept_.size() > 1) {
      held_ -= kept_.front().size;
      places_.erase(kept_.front().block);
      kept_.pop_front();
    }
  }

  std::mutex mutex_;
  std::list<Kept> kept_;  ///< the most recently used block is last
  std::unordered_map<std::size_t, std::list<Kept>::iterator> places_;
  std::uint64_t held_ = 0, most_ = kKeptBlocks;
};

PackedEnvironment::PackedEnvironment(const std::string& path, const ImportOptions& options)
    : path_(path), file_(path), recent_(std::make_unique<RecentBlocks>()) {
  readHeader();
  readDescription(options);
  readTable();
}

PackedEnvironment::~PackedEnvironment() = default;

void PackedEnvironment::failDamaged() const { failInput(path_, 0, FOOTFALL_TEXT("it is damaged"), kPackAgain); }

void PackedEnvironment::read(std::uint64_t offset, char* bytes, std::size_t size) const {
  if (file_.read(offset, bytes, size) != size)
    failInput(path_, 0, FOOTFALL_TEXT("it was cut off while it was open"), kPackAgain);
  bytesRead_.fetch_add(size, std::memory_order_relaxed);
}

std::string PackedEnvironment::bytesAt(std::uint64_t offset, std::uint64_t size) const {
  std::string bytes(static_cast<std::size_t>(size), '\0');
  read(offset, bytes.data(), bytes.size());
  return bytes;
}

void PackedEnvironment::readHeader() {
  constexpr Pattern kTruncated = FOOTFALL_TEXT("the packed environment is cut off");
  if (file_.size() < sizeof(PackedHeader)) {
    failInput(path_, 0, FOOTFALL_TEXT("is no packed environment, or is cut off"), kPackAgain);
  }
  const std::string bytes = bytesAt(0, sizeof(PackedHeader));
  std::memcpy(&header_, bytes.data(), sizeof(PackedHeader));
  if (!bytes.starts_with(kPackedMagic))
    failInput(path_, 0, FOOTFALL_TEXT("is no packed environment"),
              FOOTFALL_TEXT("give the file the extension of its real format"));
  if (header_.version == 0 || header_.version > kPackedVersion)
    failInput(path_, 0,
              Text(FOOTFALL_TEXT("is a packed environment of version %1, and this program reads versions up to %2"),
                   header_.version, kPackedVersion),
              FOOTFALL_TEXT("pack the original again with this program, or use the one that packed it"));
  if (header_.ownSum != Digest().add(std::string_view(bytes).substr(0, kSummedHeader)).value()) failDamaged();
  if (header_.fileSize > file_.size()) failInput(path_, 0, kTruncated, kPackAgain);
  const auto fits = [&](std::uint64_t offset, std::uint64_t size) {
    return offset >= sizeof(PackedHeader) && offset <= file_.size() && size <= file_.size() - offset;
  };
  constexpr std::uint64_t kMost = 0xffffffffU;
  if (header_.fileSize != file_.size() || header_.vertices > kMost || header_.faces > kMost || header_.faces == 0 ||
      header_.blocks > file_.size() / sizeof(PackedBlock) ||
      !fits(header_.tableOffset, tableSize(header_.blocks, header_.version)) ||
      !fits(header_.descriptionOffset, header_.descriptionSize))
    failDamaged();
}

void PackedEnvironment::readDescription(const ImportOptions& options) {
  const std::string bytes = bytesAt(header_.descriptionOffset, header_.descriptionSize);
  if (Digest().add(bytes).value() != header_.descriptionSum) failDamaged();
  try {
    head_ = decodeDescription(bytes, header_.version);
  } catch (const BadBytes&) {
    failDamaged();
  }
  head_.source = path_;
  // The packed frame is the one that its source declared, or that was guessed.
  FileFrame frame;
  if (!head_.upGuessed) frame.up = head_.up;
  if (!head_.scaleGuessed) frame.metresPerUnit = head_.metresPerUnit;
  const bool bothSides = head_.bothSides;
  setFrame(head_, frame, options, {head_.up, head_.metresPerUnit});
  head_.bothSides = head_.bothSides || bothSides;
}

void PackedEnvironment::readTable() {
  const std::string bytes = bytesAt(header_.tableOffset, tableSize(header_.blocks, header_.version));
  if (Digest().add(bytes).value() != header_.tableSum) failDamaged();
  blocks_.resize(static_cast<std::size_t>(header_.blocks));
  const std::size_t size = blocks_.size() * sizeof(PackedBlock);
  if (!blocks_.empty()) std::memcpy(blocks_.data(), bytes.data(), size);
  if (header_.version > 1) std::memcpy(&coarse_, bytes.data() + size, sizeof coarse_);
  std::uint64_t vertices = 0, faces = 0, coarse = 0, end = sizeof(PackedHeader);
  for (PackedBlock& block : blocks_) {
    if (header_.version == 1) block.coarse = 0;
    const bool isWithin = block.offset % kBlockAlignment == 0 && block.offset >= end && block.offset <= file_.size() &&
                          block.size <= file_.size() - block.offset;
    if (!isWithin || block.vertices > kBlockVertices || block.faces > kBlockFaces || block.coarse > kMostCoarseFaces ||
        block.ownVertices > block.vertices || !isFinite(block.box) ||
        block.size != blockSize(block.vertices, block.faces, !head_.parts.empty()))
      failDamaged();
    vertices += block.ownVertices;
    faces += block.faces;
    coarse += block.coarse;
    end = block.offset + block.size;
  }
  if (vertices != header_.vertices || faces != header_.faces || coarse_.size != coarse * sizeof(PackedCoarseFace) ||
      coarse_.offset > file_.size() || coarse_.size > file_.size() - coarse_.offset)
    failDamaged();
}

Box PackedEnvironment::boxOf(std::size_t block) const {
  const Box& box = blocks_[block].box;
  return turned(box, fromFileFrame(pointOf(box.lower), head_.up), fromFileFrame(pointOf(box.upper), head_.up));
}

std::vector<std::size_t> PackedEnvironment::blocksTouching(const Box& box) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (blocks_[i].faces > 0 && touch(boxOf(i), box)) found.push_back(i);
  return found;
}

void PackedEnvironment::forCoarseFaces(const std::function<void(std::size_t, const CoarseFace&)>& visit) const {
  const std::string bytes = bytesAt(coarse_.offset, coarse_.size);
  const char* at = bytes.data();
  Digest sum;
  for (const PackedBlock& block : blocks_) {
    const std::size_t size = block.coarse * sizeof(PackedCoarseFace);
    sum.add(std::string_view(at, size));
    at += size;
  }
  if (header_.version > 1 && sum.value() != coarse_.sum) failDamaged();
  at = bytes.data();
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    for (std::uint32_t i = 0; i < blocks_[b].coarse; ++i) {
      PackedCoarseFace packed;
      std::memcpy(&packed, at, sizeof packed);
      at += sizeof packed;
      visit(b, coarseFaceOf(packed, blocks_[b].box, head_.up));
    }
  }
}

BlockArrays PackedEnvironment::arraysOf(const PackedBlock& block, const Bytes& bytes) const {
  // The pointers refer to the bytes directly: offsets are multiples of the items' alignments.
  const char* at = reinterpret_cast<const char*>(bytes.get());
  const auto take = [&at]<class Item>(std::span<const Item>& items, std::size_t count) {
    items = {reinterpret_cast<const Item*>(at), count};
    at += count * sizeof(Item);
  };
  BlockArrays arrays;
  arrays.owner = bytes;
  take(arrays.places, block.vertices);
  take(arrays.vertices, block.vertices);
  take(arrays.faces, block.faces);
  take(arrays.parts, head_.parts.empty() ? 0 : block.faces);
  take(arrays.corners, block.faces);
  return arrays;
}

BlockArrays PackedEnvironment::readBlock(std::size_t number) const {
  const PackedBlock& block = blocks_[number];
  const auto size = static_cast<std::size_t>(block.size);
  const std::shared_ptr<std::uint64_t[]> bytes(new std::uint64_t[size / sizeof(std::uint64_t) + 1]);
  auto* const begin = reinterpret_cast<char*>(bytes.get());
  read(block.offset, begin, size);
  if (Digest().add(std::string_view(begin, size)).value() != block.sum) failDamaged();
  BlockArrays arrays = arraysOf(block, bytes);
  const auto areBelow = [](const auto& numbers, std::uint64_t end) {
    return std::all_of(numbers.begin(), numbers.end(), [end](std::uint32_t number) { return number < end; });
  };
  const auto isIn = [&](const std::array<double, 3>& place) { return contains(block.box, place); };
  bool isGood = areBelow(arrays.vertices, header_.vertices) && areBelow(arrays.faces, header_.faces) &&
                areBelow(arrays.parts, head_.parts.size()) &&
                std::all_of(arrays.places.begin(), arrays.places.end(), isIn);
  for (const auto& corners : arrays.corners) isGood = isGood && areBelow(corners, block.vertices);
  if (!isGood) failDamaged();
  return arrays;
}

BlockArrays PackedEnvironment::block(std::size_t number) const {
  if (const Bytes known = recent_->find(number)) return arraysOf(blocks_[number], known);
  BlockArrays arrays = readBlock(number);
  recent_->keep(number, arrays.owner, blocks_[number].size);
  return arrays;
}

void PackedEnvironment::forFaces(std::size_t number, const std::function<void(const BlockFace&)>& visit) const {
  const BlockArrays arrays = block(number);
  for (std::size_t f = 0; f < arrays.faces.size(); ++f) visit(faceOf(arrays, number, f, head_.up));
}

PackedFaces PackedEnvironment::facesOf(std::span<const std::size_t> blocks,
                                       const std::function<bool(const BlockFace&)>& isWanted,
                                       RunContext* context) const {
  FaceCollector collector;
  for (const std::size_t number : blocks) {
    if (context != nullptr) context->checkCancelled();
    const BlockArrays arrays = block(number);
    for (std::size_t f = 0; f < arrays.faces.size(); ++f)
      if (const BlockFace face = faceOf(arrays, number, f, head_.up); isWanted(face)) collector.add(arrays, face);
  }
  return collector.collected(!head_.parts.empty(), Poll(context));
}

PackedFaces PackedEnvironment::facesTouching(const Box& box, RunContext* context) const {
  return facesOf(
      blocksTouching(box), [&](const BlockFace& face) { return touch(detail::boxOf(face), box); }, context);
}

void PackedEnvironment::keepBlocks(std::uint64_t bytes) const { recent_->limit(bytes); }
void PackedEnvironment::forgetBlocks() const { recent_->clear(); }

std::vector<PackedEnvironment::Copy> PackedEnvironment::fill(std::size_t number, Environment& environment,
                                                             std::atomic<std::uint64_t>* vertices,
                                                             std::atomic<std::uint64_t>* faces) const {
  const BlockArrays arrays = readBlock(number);
  std::vector<Copy> copies;
  for (std::size_t v = 0; v < arrays.vertices.size(); ++v) {
    const Vec3 place = fromFileFrame(pointOf(arrays.places[v]), head_.up);
    if (v >= blocks_[number].ownVertices) {
      copies.push_back({arrays.vertices[v], place});
      continue;
    }
    if (!claim(vertices, arrays.vertices[v])) failDamaged();
    environment.vertices[arrays.vertices[v]] = place;
  }
  for (std::size_t f = 0; f < arrays.faces.size(); ++f) {
    if (!claim(faces, arrays.faces[f])) failDamaged();
    Triangle& triangle = environment.triangles[arrays.faces[f]];
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = arrays.vertices[arrays.corners[f][k]];
    if (!arrays.parts.empty()) environment.partOf[arrays.faces[f]] = arrays.parts[f];
  }
  return copies;
}

Environment PackedEnvironment::readAll(RunContext* context) const {
  Environment environment = head_;
  environment.vertices.resize(static_cast<std::size_t>(header_.vertices));
  environment.triangles.resize(static_cast<std::size_t>(header_.faces));
  if (!head_.parts.empty()) environment.partOf.resize(environment.triangles.size());
  const auto vertices = std::make_unique<std::atomic<std::uint64_t>[]>(environment.vertices.size() / 64 + 1);
  const auto faces = std::make_unique<std::atomic<std::uint64_t>[]>(environment.triangles.size() / 64 + 1);
  std::vector<std::vector<Copy>> copies(blocks_.size());
  std::atomic<std::size_t> done{0};
  forRanges(blocks_.size(), 1, [&](std::size_t i, std::size_t) {
    copies[i] = fill(i, environment, vertices.get(), faces.get());
    if (context == nullptr) return;
    context->checkCancelled();
    context->progress(static_cast<double>(done.fetch_add(1) + 1) / static_cast<double>(blocks_.size()));
  });
  forRanges(blocks_.size(), 1, [&](std::size_t i, std::size_t) {
    if (context != nullptr) context->checkCancelled();
    for (const auto& [vertex, place] : copies[i])
      if (environment.vertices[vertex] != place) failDamaged();
  });
  return environment;
}

Environment readPacked(const std::string& path, const ImportOptions& options, RunContext* context) {
  return PackedEnvironment(path, options).readAll(context);
}

}  // namespace footfall::detail
