// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/packed/environment_packer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "core/base/hilbert_curve.hpp"
#include "core/base/parallel_sort.hpp"
#include "core/base/sorted_list.hpp"
#include "core/io/input_file.hpp"
#include "core/io/packed/block_writer.hpp"
#include "core/io/packed/packed_description.hpp"
#include "footfall/up_axis.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kPageVertices = 2048;
constexpr std::uint64_t kPollFaces = 1 << 14;

struct KeptFace {
  Triangle corners{};
  std::uint32_t part = 0;
};

template <class Item>
std::string_view bytesOf(const Item& item) {
  return {reinterpret_cast<const char*>(&item), sizeof(Item)};
}

/// The step of a coordinate among 2^kHilbertBits3 over the extent. Halves are used, because extents may overflow.
std::uint32_t stepOf(double x, double lower, double halfExtent) {
  constexpr double kSteps = 1U << kHilbertBits3;
  const double place = halfExtent > 0 ? (x / 2 - lower / 2) / halfExtent * kSteps : 0;
  return static_cast<std::uint32_t>(std::clamp(std::isfinite(place) ? place : 0.0, 0.0, kSteps - 1));
}

}  // namespace

/// A face as sorted runs on the disk store it.
struct EnvironmentPacker::Face {
  std::uint64_t key = 0;  ///< place along the curve
  PackedFace face;

  bool operator<(const Face& other) const {
    return key != other.key ? key < other.key : face.number < other.face.number;
  }
};

/// A range of bytes in `sorted_`.
struct EnvironmentPacker::Run {
  std::uint64_t first = 0, last = 0;
};

/// A cache of vertex pages for vertices that are looked up again.
class EnvironmentPacker::VertexPages {
 public:
  explicit VertexPages(std::size_t count) : pages_(std::max<std::size_t>(count, 1)) {}

  void clear() {
    for (Page& page : pages_) page.places.clear();
  }
  Vec3 at(const ScratchFile& file, std::uint32_t vertex) {
    const std::uint64_t number = vertex / kPageVertices;
    Page& page = pages_[number % pages_.size()];
    const std::size_t within = vertex % kPageVertices;
    if (page.number != number || within >= page.places.size()) {
      const std::uint64_t first = number * kPageVertices;
      page.number = number;
      page.places.resize(
          static_cast<std::size_t>(std::min<std::uint64_t>(kPageVertices, file.size() / sizeof(Vec3) - first)));
      file.read(first * sizeof(Vec3), page.places.data(), page.places.size() * sizeof(Vec3));
    }
    return page.places[within];
  }

 private:
  struct Page {
    std::uint64_t number = 0;
    std::vector<Vec3> places;
  };
  std::vector<Page> pages_;
};

EnvironmentPacker::EnvironmentPacker(const std::string& input, const std::string& target, RunContext* context,
                                     const PackingMemory& memory)
    : input_(input),
      target_(target),
      context_(context),
      memory_(memory),
      vertices_(target, memory.scratch),
      faces_(target, memory.scratch),
      sorted_(target, 0),
      pages_(std::make_unique<VertexPages>(memory.cachedPages)) {}

EnvironmentPacker::~EnvironmentPacker() = default;

void EnvironmentPacker::poll() const {
  if (context_ != nullptr) context_->checkCancelled();
}

void EnvironmentPacker::progress(double done) const {
  if (context_ != nullptr) context_->progress(done);
}

void EnvironmentPacker::restart() {
  vertices_.clear();
  faces_.clear();
  pages_->clear();
  vertexCount_ = faceCount_ = 0;
  rounding_.reset();
  areFloats = false;
}

void EnvironmentPacker::addVertex(const Vec3& place) {
  if (vertexCount_ == std::numeric_limits<std::uint32_t>::max())
    failInput(input_, 0, FOOTFALL_TEXT("more than 4294967295 vertices"), FOOTFALL_TEXT("split the file"));
  if (vertexCount_ == 0) lower_ = upper_ = place;
  lower_ = {std::min(lower_.x, place.x), std::min(lower_.y, place.y), std::min(lower_.z, place.z)};
  upper_ = {std::max(upper_.x, place.x), std::max(upper_.y, place.y), std::max(upper_.z, place.z)};
  ++vertexCount_;
  vertices_.append(bytesOf(place));
}

Vec3 EnvironmentPacker::vertex(std::uint32_t number) const {
  const Vec3 place = pages_->at(vertices_, number);
  return rounding_ ? inFileFrame(rounding_->placed(fromFileFrame(place, up_)), up_) : place;
}

void EnvironmentPacker::addFace(const Triangle& corners, std::uint32_t part) {
  if (faceCount_ == std::numeric_limits<std::uint32_t>::max())
    failInput(input_, 0, FOOTFALL_TEXT("more than 4294967295 triangles"), FOOTFALL_TEXT("split the file"));
  ++faceCount_;
  faces_.append(bytesOf(KeptFace{corners, part}));
}

template <class Take>
void EnvironmentPacker::forEachVertex(const Take& take) const {
  constexpr std::uint64_t kAtOnce = 8192;
  std::vector<Vec3> read(kAtOnce);
  for (std::uint64_t first = 0; first < vertexCount_; first += kAtOnce) {
    poll();
    const auto count = static_cast<std::size_t>(std::min(kAtOnce, vertexCount_ - first));
    vertices_.read(first * sizeof(Vec3), read.data(), count * sizeof(Vec3));
    for (std::size_t i = 0; i < count; ++i) take(fromFileFrame(read[i], up_));
  }
}

template <class Take>
void EnvironmentPacker::forEachFace(const Take& take) const {
  constexpr std::uint64_t kAtOnce = 4096;
  std::vector<KeptFace> read(kAtOnce);
  for (std::uint64_t first = 0; first < faceCount_; first += kAtOnce) {
    poll();
    const auto count = static_cast<std::size_t>(std::min(kAtOnce, faceCount_ - first));
    faces_.read(first * sizeof(KeptFace), read.data(), count * sizeof(KeptFace));
    for (std::size_t i = 0; i < count; ++i) {
      std::array<Vec3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = fromFileFrame(pages_->at(vertices_, read[i].corners[k]), up_);
      take(corners);
    }
  }
}

/// Processes the places in slabs of x that fit into memory; a slab border never divides places of one x.
WeldedPlaces EnvironmentPacker::findWelds(double step) const {
  constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();
  GridWelder welder;
  std::vector<GridPlace> places;
  std::int64_t first = std::numeric_limits<std::int64_t>::min();
  while (first < kLast) {
    places.clear();
    std::int64_t end = kLast;  // the places from `first` to `end` are kept; places beyond were left out
    std::size_t most = 2 * memory_.weldedVertices;
    forEachVertex([&](const Vec3& p) {
      const GridPlace place = gridPlace(p, step);
      if (place[0] < first || place[0] > end) return;
      places.push_back(place);
      if (places.size() < most) return;
      sortOnce(places);
      if (places.size() > memory_.weldedVertices) {
        const std::int64_t last = std::max(places[memory_.weldedVertices][0], places.front()[0] + 1);
        end = std::min(end, last);
        std::erase_if(places, [&](const GridPlace& other) { return other[0] > end; });
      }
      most = std::max(most, 2 * places.size());
    });
    sortOnce(places);
    welder.addSlab(places, end, Poll(context_));
    first = end;
  }
  return welder.finish();
}

CoordinateGrid EnvironmentPacker::putOnGrid(const ImportOptions& options, UpAxis up, double metresPerUnit) {
  up_ = up;
  GridExtent extent;
  forEachVertex([&](const Vec3& p) { extent.includeVertex(p); });
  forEachFace([&](const std::array<Vec3, 3>& corners) {
    for (const Vec3& corner : corners) extent.include(corner);
  });
  const double step = chosenGridStep(options, areFloats, extent, metresPerUnit);
  if (step == 0) return {};
  if (faceCount_ <= memory_.facesOnGrid && vertexCount_ <= kMostSplitVertices) return putOnGridInMemory(step);
  GridRounding rounding(step, findWelds(step));
  forEachVertex([&](const Vec3& p) { rounding.countVertex(p, rounding.placed(p)); });
  forEachFace([&](const std::array<Vec3, 3>& corners) {
    rounding.countTriangle(corners,
                           {rounding.placed(corners[0]), rounding.placed(corners[1]), rounding.placed(corners[2])});
  });
  rounding_.emplace(std::move(rounding));
  return rounding_->grid();
}

CoordinateGrid EnvironmentPacker::putOnGridInMemory(double step) {
  Environment whole;
  forEachVertex([&](const Vec3& p) { whole.vertices.push_back(p); });
  std::vector<KeptFace> read(static_cast<std::size_t>(faceCount_));
  faces_.read(0, read.data(), read.size() * sizeof(KeptFace));
  for (const KeptFace& face : read) {
    whole.triangles.push_back(face.corners);
    whole.partOf.push_back(face.part);
  }
  read = {};
  detail::putOnGrid(whole, step, Poll(context_));
  restart();
  for (const Vec3& p : whole.vertices) addVertex(inFileFrame(p, up_));
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) addFace(whole.triangles[t], whole.partOf[t]);
  return whole.grid;
}

EnvironmentPacker::Face EnvironmentPacker::placed(std::uint32_t number, const std::uint32_t* kept) const {
  Face result;
  PackedFace& face = result.face;
  face.number = number;
  face.corners = {kept[0], kept[1], kept[2]};
  face.part = kept[3];
  for (std::size_t k = 0; k < 3; ++k) face.places[k] = vertex(face.corners[k]);
  const auto& [a, b, c] = face.places;
  const double half = std::max({upper_.x / 2 - lower_.x / 2, upper_.y / 2 - lower_.y / 2, upper_.z / 2 - lower_.z / 2});
  result.key = hilbertIndex3({stepOf(a.x / 3 + b.x / 3 + c.x / 3, lower_.x, half),
                              stepOf(a.y / 3 + b.y / 3 + c.y / 3, lower_.y, half),
                              stepOf(a.z / 3 + b.z / 3 + c.z / 3, lower_.z, half)});
  return result;
}

void EnvironmentPacker::sortChunk(std::vector<Face>& chunk) {
  parallelSort(chunk.begin(), chunk.end());
  poll();
}

/// Returns the runs on the disk. Faces that fill no chunk stay in `last`, which is the only run of a small environment.
std::vector<EnvironmentPacker::Run> EnvironmentPacker::sortRuns(std::vector<Face>& last) {
  constexpr std::uint64_t kAtOnce = 4096;
  std::vector<Run> runs;
  std::vector<KeptFace> read(kAtOnce);
  last.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(faceCount_, memory_.sortedFaces)));
  for (std::uint64_t first = 0; first < faceCount_; first += kAtOnce) {
    const auto count = static_cast<std::size_t>(std::min(kAtOnce, faceCount_ - first));
    faces_.read(first * sizeof(KeptFace), read.data(), count * sizeof(KeptFace));
    poll();
    progress(0.5 + 0.25 * static_cast<double>(first) / static_cast<double>(faceCount_));
    for (std::size_t i = 0; i < count; ++i) {
      if (last.size() == memory_.sortedFaces) {
        sortChunk(last);
        const std::uint64_t start = sorted_.size();
        sorted_.append({reinterpret_cast<const char*>(last.data()), last.size() * sizeof(Face)});
        runs.push_back({start, sorted_.size()});
        last.clear();
      }
      const auto& [a, b, c] = read[i].corners;
      const std::uint32_t kept[] = {a, b, c, read[i].part};
      last.push_back(placed(static_cast<std::uint32_t>(first + i), kept));
    }
  }
  sortChunk(last);
  return runs;
}

template <class Take>
void EnvironmentPacker::mergeRuns(const std::vector<Run>& runs, const Take& take) {
  struct Ahead {
    Run rest;
    std::vector<Face> faces;
    std::size_t next = 0;
  };
  const std::size_t readAhead = std::max<std::size_t>(memory_.merged / sizeof(Face) / runs.size(), 16);
  std::vector<Ahead> ahead;
  for (const Run& run : runs) ahead.push_back({run, {}});
  const auto isLater = [&](std::size_t a, std::size_t b) {
    return ahead[b].faces[ahead[b].next] < ahead[a].faces[ahead[a].next];
  };
  std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(isLater)> firsts(isLater);
  const auto refill = [&](std::size_t r) {
    Ahead& run = ahead[r];
    const auto left = static_cast<std::size_t>((run.rest.last - run.rest.first) / sizeof(Face));
    run.faces.resize(std::min(readAhead, left));
    run.next = 0;
    sorted_.read(run.rest.first, run.faces.data(), run.faces.size() * sizeof(Face));
    run.rest.first += run.faces.size() * sizeof(Face);
    return !run.faces.empty();
  };
  for (std::size_t r = 0; r < ahead.size(); ++r)
    if (refill(r)) firsts.push(r);
  while (!firsts.empty()) {
    const std::size_t r = firsts.top();
    firsts.pop();
    take(ahead[r].faces[ahead[r].next].face);
    if (++ahead[r].next < ahead[r].faces.size() || refill(r)) firsts.push(r);
  }
}

PackedCounts EnvironmentPacker::finish(const Environment& head) {
  std::vector<Face> chunk;
  std::vector<Run> runs = sortRuns(chunk);
  faces_.clear();
  const Poll poll(context_);
  BlockWriter writer(target_, vertexCount_, faceCount_, !head.parts.empty(), poll);
  std::uint64_t done = 0;
  const auto take = [&](const PackedFace& face) {
    writer.add(face);
    if (++done % kPollFaces != 0) return;
    poll();
    progress(0.75 + 0.25 * static_cast<double>(done) / static_cast<double>(faceCount_));
  };
  if (runs.empty()) {
    for (const Face& face : chunk) take(face.face);
  } else {
    runs.push_back({sorted_.size(), sorted_.size() + chunk.size() * sizeof(Face)});
    sorted_.append({reinterpret_cast<const char*>(chunk.data()), chunk.size() * sizeof(Face)});
    chunk = {};
    mergeRuns(runs, take);
  }
  const PackedHeader header = writer.finish(encodeDescription(head), [this](std::uint32_t v) { return vertex(v); });
  restart();
  sorted_.clear();
  return {header.vertices, header.faces, header.blocks, header.fileSize};
}

}  // namespace footfall::detail
