// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/radius/border_chains.hpp"

#include <algorithm>
#include <cmath>

namespace footfall::detail {
namespace {

constexpr double kShort = MarginSurface::kShort;
constexpr double kSlack = MarginSurface::kSlack;
constexpr double kStraight = 8 * MarginSurface::kUnit;  // borders that turn less go on
constexpr std::size_t kLongestChain = 64;

bool isStraightOver(const std::vector<PlanVector>& places) {
  const PlanVector chord = places.back() - places.front();
  const double size = length(chord);
  if (size < kShort) return false;
  double furthest = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const PlanVector& p = places[i];
    if (length(p - places[i - 1]) < kShort) return false;
    const double at = dot(p - places.front(), chord) / size;
    if (std::fabs(cross(chord, p - places.front())) > kStraight * size || at < furthest - kStraight) return false;
    furthest = std::max(furthest, at);
  }
  return true;
}

void finishChain(BorderChain& chain, const MarginSurface& surface) {
  const PlanVector whole = chain.end - chain.begin;
  const double size = length(whole);
  chain.isShort = size < kShort;
  chain.along = chain.isShort ? PlanVector{1, 0} : (1 / size) * whole;
  for (const Index side : chain.sides)
    chain.slack = std::max({chain.slack, kSlack + 2 * surface.error(surface.beginVertex(side)),
                            kSlack + 2 * surface.error(surface.endVertex(side))});
}

/// The order of pieces along the border.
class PieceOrder {
 public:
  PieceOrder(const MarginSurface& surface, const std::vector<BorderPiece>& pieces)
      : behind_(pieces.size()), before_(pieces.size(), -1), isStraight_(pieces.size(), 0) {
    std::vector<Index> firstOf(static_cast<std::size_t>(surface.sideCount()), -1), fan;
    for (std::size_t p = pieces.size(); p-- > 0;) firstOf[pieces[p].side] = static_cast<Index>(p);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const BorderPiece& piece = pieces[p];
      if (p + 1 < pieces.size() && pieces[p + 1].side == piece.side) {
        behind_[p] = static_cast<Index>(p) + 1;
        before_[p + 1] = static_cast<Index>(p);
        continue;
      }
      if (surface.fanBehind(piece.side, fan)) {
        behind_[p] = -1;
        branches_.push_back(static_cast<Index>(p));
        continue;
      }
      const Index next = behind_[p] = firstOf[fan.back()];
      if (next < 0) continue;
      before_[next] = static_cast<Index>(p);
      const Index vertex = surface.endVertex(piece.side);
      const bool isOnePlace =
          std::all_of(fan.begin(), fan.end(), [&](Index side) { return surface.beginVertex(side) == vertex; });
      isStraight_[p] = static_cast<char>(isOnePlace && pieces[next].isLedge == piece.isLedge &&
                                         isStraightOver({piece.begin, piece.end, pieces[next].end}));
    }
  }

  [[nodiscard]] Index behind(Index piece) const { return behind_[piece]; }
  [[nodiscard]] Index before(Index piece) const { return before_[piece]; }
  /// Pieces behind which there are several ways on.
  [[nodiscard]] const std::vector<Index>& branches() const { return branches_; }
  /// True when the piece behind is of the same kind, and goes straight on.
  [[nodiscard]] bool isStraight(Index piece) const { return isStraight_[piece] != 0; }

 private:
  std::vector<Index> behind_, before_, branches_;
  std::vector<char> isStraight_;
};

}  // namespace

std::vector<BorderChain> findBorderChains(const MarginSurface& surface, const std::vector<BorderPiece>& pieces) {
  const PieceOrder order(surface, pieces);
  const auto count = static_cast<Index>(pieces.size());
  std::vector<BorderChain> chains;
  std::vector<Index> chainOf(pieces.size(), -1), firsts, lasts;
  const auto addChain = [&](Index first) {
    while (first >= 0 && chainOf[first] < 0) {
      BorderChain chain;
      chain.begin = pieces[first].begin;
      chain.isLedge = pieces[first].isLedge;
      std::vector<PlanVector> places{chain.begin};
      Index last = -1;
      for (Index p = first; p >= 0 && chainOf[p] < 0; p = order.behind(p)) {
        places.push_back(pieces[p].end);
        if (last >= 0 && (!order.isStraight(last) || places.size() > kLongestChain || !isStraightOver(places))) break;
        chainOf[p] = static_cast<Index>(chains.size());
        chain.sides.push_back(pieces[p].side);
        chain.slack = std::max(chain.slack, kSlack + 2 * pieces[p].error);
        last = p;
      }
      chain.end = pieces[last].end;
      chain.endsInside = last + 1 < count && pieces[last + 1].side == pieces[last].side;
      finishChain(chain, surface);
      chains.push_back(std::move(chain));
      firsts.push_back(first);
      lasts.push_back(last);
      first = order.isStraight(last) ? order.behind(last) : -1;
    }
  };
  for (Index p = 0; p < count; ++p)
    if (order.before(p) < 0 || !order.isStraight(order.before(p))) addChain(p);
  for (Index p = 0; p < count; ++p) addChain(p);  // loops as small as doubles
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const Index after = order.behind(lasts[c]), ahead = order.before(firsts[c]);
    chains[c].behind = after < 0 ? -1 : chainOf[after];
    chains[c].before = ahead < 0 ? -1 : chainOf[ahead];
  }
  for (const Index p : order.branches()) {
    BorderChain place;
    place.begin = place.end = pieces[p].end;
    place.sides = {pieces[p].side};
    place.isLedge = pieces[p].isLedge;
    place.slack = kSlack + 2 * pieces[p].error;
    finishChain(place, surface);
    chains.push_back(std::move(place));
  }
  return chains;
}

void fanBehind(const MarginSurface& surface, const BorderChain& chain, std::vector<Index>& fan) {
  if (chain.endsInside)
    fan = {chain.sides.back()};
  else
    surface.fanBehind(chain.sides.back(), fan);
}

}  // namespace footfall::detail
