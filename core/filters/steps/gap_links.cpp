// Links over gaps between pairs of opposite vertices, and the parts without a link.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/filters/steps/gap_linker.hpp"

namespace footfall::detail {
namespace {

constexpr double kAcross = GapConditions::kAcross;

}  // namespace

// Pairs those vertices within the gap that lie across from each other. There is a link between two such pairs without
// another vertex between them.
template <class Visit>
std::size_t GapLinker::visitLinks(const GapStretch& stretch, const Visit& visit) {
  struct Place {
    std::size_t vertex = 0;
    double along = 0;
  };
  const auto placesOf = [&](Index number, std::size_t border) {
    const GapPiece& piece = stretch.piece;
    const GapFrame& frame = piece.frameOf(border);
    const Chain chain = chainOf(number);
    const ChainPart part = partOf(chain, frame, piece.ends[0] - kAcross, piece.ends[1] + kAcross);
    std::vector<Place> places;
    places.reserve(part.end - part.begin);
    for (std::size_t i = part.begin; i < part.end; ++i) places.push_back({i, chain.along(frame, i)});
    return places;
  };
  const std::vector<Place> first = placesOf(stretch.first, 0);
  std::vector<Place> second = placesOf(stretch.second, 1);
  std::reverse(second.begin(), second.end());
  std::size_t i = 0, j = 0, unpaired = 0;
  std::optional<std::array<std::size_t, 2>> last;
  while (i < first.size() && j < second.size()) {
    const double distance = first[i].along - second[j].along;
    if (std::fabs(distance) > 2 * kAcross) {
      ++(distance < 0 ? i : j);
      continue;
    }
    if (last && (*last)[0] + 1 == i && (*last)[1] + 1 == j)
      visit(first[i].vertex, second[j].vertex);
    else if (last)
      ++unpaired;
    last = {i++, j++};
  }
  return unpaired;
}

std::vector<std::array<double, 2>> GapLinker::linkedParts(const GapStretch& stretch) {
  std::vector<std::array<double, 2>> parts;
  if (stretch.isDropped) return parts;
  std::size_t last = SIZE_MAX;
  visitLinks(stretch, [&](std::size_t i, std::size_t) {
    const Chain chain = chainOf(stretch.first);
    const double low = chain.along(stretch.piece.frame, i - 1), high = chain.along(stretch.piece.frame, i);
    if (last == i - 1)
      parts.back()[1] = high;
    else
      parts.push_back({low, high});
    last = i;
  });
  return parts;
}

std::vector<GapWay> GapLinker::ways() {
  std::vector<GapWay> ways;
  for (const GapStretch& gap : gaps_) {
    context_.checkCancelled();
    for (const auto& part : linkedParts(gap)) ways.push_back(gapWay(splits_, gap.first, gap.second, gap.piece, part));
  }
  return ways;
}

std::vector<PlanSegment> GapLinker::lostParts() {
  std::vector<PlanSegment> lost;
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    context_.checkCancelled();
    const GapStretch& gap = gaps_[i];
    const auto [begin, end] = known_[i].ends;
    const auto lose = [&](double low, double high) {
      if (!(high - low > GapConditions::kShort)) return;
      const GapWay way = gapWay(splits_, gap.first, gap.second, gap.piece, {low, high});
      lost.insert(lost.end(), way.parts.begin(), way.parts.end());
    };
    double reached = begin;
    for (const auto& [low, high] : linkedParts(gap)) {
      lose(reached, low);
      reached = high;
    }
    lose(reached, end);
  }
  return lost;
}

// Both borders are in their own directions.
void GapLinker::addLinks(const GapStretch& stretch, std::vector<MeshLink>& links) {
  const MeshBorder &first = splits_.border(stretch.first), &second = splits_.border(stretch.second);
  undecided_ += visitLinks(stretch, [&](std::size_t i, std::size_t j) {
    MeshLink link{{splits_.chainNumber(first, i - 1), splits_.chainNumber(first, i)},
                  {splits_.chainNumber(second, j), splits_.chainNumber(second, j + 1)},
                  true};
    if (link.to < link.from) std::swap(link.from, link.to);
    links.push_back(link);
  });
}

std::vector<MeshLink> GapLinker::links() {
  std::vector<MeshLink> links;
  for (const GapStretch& gap : gaps_) {
    context_.checkCancelled();
    if (!gap.isDropped) addLinks(gap, links);
  }
  return links;
}

}  // namespace footfall::detail
