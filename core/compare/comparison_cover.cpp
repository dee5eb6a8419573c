// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/comparison_cover.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/base/sorted_list.hpp"
#include "core/base/triangle_tree.hpp"

namespace footfall::detail::comparison {
namespace {

/// The growth of the winding numbers of the two sets from the right of an edge to its left.
using Jump = std::array<int, 2>;

Jump operator+(const Jump& a, const Jump& b) { return {a[0] + b[0], a[1] + b[1]}; }
Jump operator-(const Jump& a, const Jump& b) { return {a[0] - b[0], a[1] - b[1]}; }

/// Runs from the lower end (by x, then y) to the upper one.
struct Segment {
  std::uint32_t from, to;
  Jump jump;
};

/// A place on a segment: from + (to - from) * numerator / denominator, where the denominator is positive.
struct Place {
  mpz_class numerator, denominator;
};

bool operator<(const Place& a, const Place& b) { return a.numerator * b.denominator < b.numerator * a.denominator; }
bool operator==(const Place& a, const Place& b) { return a.numerator * b.denominator == b.numerator * a.denominator; }

bool isIn(CoverPart part, const Jump& windings) {
  const bool first = windings[0] > 0, second = windings[1] > 0;
  return part == kOnlyFirst ? first && !second : part == kOnlySecond ? second && !first : first && second;
}

class Arrangement {
 public:
  Arrangement(const std::vector<CoverPoint>& points, Poll poll, bool withBorders)
      : poll_(poll), given_(points), withBorders_(withBorders) {
    // Moved to the corner of what is there, so that all numbers are as small as they can be.
    points_.reserve(points.size());
    mpz_class lowX = points.empty() ? mpz_class(0) : points[0].x, lowY = points.empty() ? mpz_class(0) : points[0].y;
    for (const CoverPoint& p : points) {
      if (p.x < lowX) lowX = p.x;
      if (p.y < lowY) lowY = p.y;
    }
    for (const CoverPoint& p : points) {
      points_.push_back({p.x - lowX, p.y - lowY});
      for (const mpz_class* n : {&points_.back().x, &points_.back().y})
        if (*n != 0) width_ = std::max(width_, static_cast<int>(mpz_sizeinbase(n->get_mpz_t(), 2)));
    }
    rounded_.reserve(points.size());
    for (const CoverPoint& p : points_) rounded_.push_back({fraction(p.x), fraction(p.y)});
  }

  CoverResult areas(const std::vector<CoverEdge>& edges, std::vector<CoverPiece>* borders) {
    joinLines(cancelled(edges));
    cut();
    return measure(borders);
  }

 private:
  /// Rounded coordinates are between 0 and 1 and off by at most 2^-52, places on segments by 2^-49. Then a computed
  /// orientation is off by less than 2^-46, and a difference of coordinates by less than 2^-48.
  static constexpr double kUnclear = 0x1p-44;
  static constexpr std::size_t kTreeSize = 48;  ///< fewer segments are faster looked through one by one
  static constexpr std::size_t kRange = 256;

  [[nodiscard]] double fraction(const mpz_class& n) const {
    signed long exponent = 0;
    const double digits = mpz_get_d_2exp(&exponent, n.get_mpz_t());
    return std::ldexp(digits, static_cast<int>(exponent) - width_);
  }

  [[nodiscard]] int compare(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return 0;
    if (const double d = rounded_[a][0] - rounded_[b][0]; std::fabs(d) > kUnclear) return d < 0 ? -1 : 1;
    if (const int order = cmp(points_[a].x, points_[b].x); order != 0) return order;
    return cmp(points_[a].y, points_[b].y);
  }

  /// Twice the area of the triangle a, b, c, exactly.
  [[nodiscard]] mpz_class exactTurn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const CoverPoint &p = points_[a], &q = points_[b], &r = points_[c];
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }

  /// Its sign: 1 when c is left of the line from a to b.
  [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (a == c || b == c) return 0;
    const auto &p = rounded_[a], &q = rounded_[b], &r = rounded_[c];
    const double d = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    return std::fabs(d) > kUnclear ? (d > 0 ? 1 : -1) : sgn(exactTurn(a, b, c));
  }

  /// Edges with the same two ends added up; those that come to nothing are dropped.
  [[nodiscard]] std::vector<Segment> cancelled(const std::vector<CoverEdge>& edges) const {
    std::vector<Segment> all;
    all.reserve(edges.size());
    for (const CoverEdge& edge : edges) {
      const int order = compare(edge.from, edge.to);
      if (order == 0) continue;
      Jump jump{};
      jump[edge.set] = order < 0 ? 1 : -1;
      all.push_back({order < 0 ? edge.from : edge.to, order < 0 ? edge.to : edge.from, jump});
    }
    std::sort(all.begin(), all.end(),
              [](const Segment& a, const Segment& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
    std::vector<Segment> kept;
    for (std::size_t i = 0; i < all.size();) {
      Segment sum = all[i];
      for (++i; i < all.size() && all[i].from == sum.from && all[i].to == sum.to; ++i)
        sum.jump = sum.jump + all[i].jump;
      if (sum.jump != Jump{}) kept.push_back(sum);
    }
    return kept;
  }

  /// a x + b y = c with whole numbers without a common divisor.
  struct Line {
    std::array<mpz_class, 3> numbers;
    std::uint32_t segment;
  };

  [[nodiscard]] Line lineOf(const Segment& segment, std::uint32_t number) const {
    const CoverPoint &p = points_[segment.from], &q = points_[segment.to];
    mpz_class a = p.y - q.y, b = q.x - p.x;
    const mpz_class divisor = gcd(a, b);
    a /= divisor;
    b /= divisor;
    return {{a, b, a * p.x + b * p.y}, number};
  }

  /// Segments of one line added up: afterwards no two of them overlap, and none is without a jump.
  void joinLines(const std::vector<Segment>& all) {
    std::vector<Line> lines(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i % kRange == 0) poll_();
      lines[i] = lineOf(all[i], static_cast<std::uint32_t>(i));
    }
    std::sort(lines.begin(), lines.end(), [this, count = 0U](const Line& a, const Line& b) mutable {
      if (++count % 4096 == 0) poll_();
      return a.numbers < b.numbers;
    });
    for (std::size_t i = 0, next = 0; i < lines.size(); i = next) {
      for (next = i + 1; next < lines.size() && lines[next].numbers == lines[i].numbers;) ++next;
      if (next - i == 1) {
        segments_.push_back(all[lines[i].segment]);
      } else {
        std::vector<std::pair<std::uint32_t, Jump>> ends;
        for (std::size_t k = i; k < next; ++k) {
          const Segment& segment = all[lines[k].segment];
          ends.push_back({segment.from, segment.jump});
          ends.push_back({segment.to, Jump{} - segment.jump});
        }
        joinLine(ends);
      }
    }
  }

  void joinLine(std::vector<std::pair<std::uint32_t, Jump>>& ends) {
    std::sort(ends.begin(), ends.end(), [this](const auto& a, const auto& b) { return compare(a.first, b.first) < 0; });
    Jump jump{};
    std::uint32_t from = 0;
    for (std::size_t i = 0; i < ends.size();) {
      const std::uint32_t here = ends[i].first;
      Jump changed = jump;
      for (; i < ends.size() && compare(ends[i].first, here) == 0; ++i) changed = changed + ends[i].second;
      if (changed == jump) continue;
      if (jump != Jump{}) segments_.push_back({from, here, jump});
      from = here;
      jump = changed;
    }
  }

  [[nodiscard]] Box boxOf(const Segment& s) const {
    const auto &p = rounded_[s.from], &q = rounded_[s.to];
    constexpr double kSlack = 0x1p-48;
    return {{p[0] - kSlack, std::min(p[1], q[1]) - kSlack, 0}, {q[0] + kSlack, std::max(p[1], q[1]) + kSlack, 0}};
  }

  /// Calls visit(number) for every segment that may meet the box.
  template <class Visit>
  void visitNear(const Box& box, std::vector<std::int32_t>& stack, const Visit& visit) const {
    if (!tree_.empty()) {
      tree_.visitOverlapping(box, stack, [&](std::int32_t i) {
        visit(static_cast<std::size_t>(i));
        return true;
      });
      return;
    }
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const Box& b = boxes_[i];
      if (b.lower[0] <= box.upper[0] && b.upper[0] >= box.lower[0] && b.lower[1] <= box.upper[1] &&
          b.upper[1] >= box.lower[1])
        visit(i);
    }
  }

  void cut() {
    boxes_.resize(segments_.size());
    for (std::size_t i = 0; i < segments_.size(); ++i) boxes_[i] = boxOf(segments_[i]);
    if (segments_.size() > kTreeSize) {
      std::vector<std::int32_t> ids(segments_.size());
      for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::int32_t>(i);
      tree_.build(boxes_, ids, poll_);
    }
    cuts_.resize(segments_.size());
    forRanges(segments_.size(), kRange, [&](std::size_t first, std::size_t last) {
      std::vector<std::int32_t> stack;
      for (std::size_t i = first; i < last; ++i) {
        if (i % 64 == 0) poll_();
        visitNear(boxes_[i], stack, [&](std::size_t j) { cutBy(i, j); });
        sortOnce(cuts_[i]);
      }
    });
  }

  /// Cuts segment i where segment j meets its inside.
  void cutBy(std::size_t i, std::size_t j) {
    if (i == j) return;
    const Segment &s = segments_[i], &t = segments_[j];
    const int fromSide = turn(s.from, s.to, t.from), toSide = turn(s.from, s.to, t.to);
    if (fromSide * toSide > 0 || (fromSide == 0 && toSide == 0)) return;  // those of one line do not overlap
    const int before = turn(t.from, t.to, s.from), after = turn(t.from, t.to, s.to);
    if (before * after >= 0) return;
    mpz_class numerator = exactTurn(t.from, t.to, s.from);
    mpz_class denominator = numerator - exactTurn(t.from, t.to, s.to);
    if (denominator < 0) {
      numerator = -numerator;
      denominator = -denominator;
    }
    cuts_[i].push_back({std::move(numerator), std::move(denominator)});
  }

  /// A point inside a piece of a segment.
  struct Probe {
    std::size_t segment;
    Place place;
    double x, y;
  };

  [[nodiscard]] Probe probeBetween(std::size_t segment, const Place& a, const Place& b) const {
    Probe probe{
        segment, {a.numerator * b.denominator + b.numerator * a.denominator, a.denominator * b.denominator * 2}, 0, 0};
    signed long up = 0, down = 0;
    const double n = mpz_get_d_2exp(&up, probe.place.numerator.get_mpz_t());
    const double d = mpz_get_d_2exp(&down, probe.place.denominator.get_mpz_t());
    const double t = std::ldexp(n / d, static_cast<int>(up - down));
    const auto &p = rounded_[segments_[segment].from], &q = rounded_[segments_[segment].to];
    probe.x = p[0] + t * (q[0] - p[0]);
    probe.y = p[1] + t * (q[1] - p[1]);
    return probe;
  }

  /// True when the point is at x or to the right of it.
  [[nodiscard]] bool isAtOrAfter(const Probe& probe, std::uint32_t point) const {
    if (const double d = probe.x - rounded_[point][0]; std::fabs(d) > kUnclear) return d > 0;
    const CoverPoint &p = points_[segments_[probe.segment].from], &q = points_[segments_[probe.segment].to];
    return (p.x - points_[point].x) * probe.place.denominator + (q.x - p.x) * probe.place.numerator >= 0;
  }

  [[nodiscard]] bool isBelow(const Probe& probe, const Segment& t) const {
    const auto &a = rounded_[t.from], &b = rounded_[t.to];
    const double d = (b[0] - a[0]) * (probe.y - a[1]) - (b[1] - a[1]) * (probe.x - a[0]);
    if (std::fabs(d) > kUnclear) return d < 0;
    const Segment& s = segments_[probe.segment];
    const mpz_class start = exactTurn(t.from, t.to, s.from);
    const mpz_class change = exactTurn(t.from, t.to, s.to) - start;
    return start * probe.place.denominator + change * probe.place.numerator < 0;
  }

  /// Windings just above the point or, on a vertical segment, to the right of it: those of a ray that goes up a hair
  /// to the right, so that it meets no vertical segment and each end belongs to one of two neighbours.
  [[nodiscard]] Jump windingsAt(const Probe& probe, std::vector<std::int32_t>& stack) const {
    constexpr double kSlack = 0x1p-44;
    const Box ray{{probe.x - kSlack, probe.y - kSlack, 0}, {probe.x + kSlack, 2, 0}};
    Jump windings{};
    visitNear(ray, stack, [&](std::size_t j) {
      const Segment& t = segments_[j];
      if (j == probe.segment || !isAtOrAfter(probe, t.from) || isAtOrAfter(probe, t.to) || !isBelow(probe, t)) return;
      windings = windings - t.jump;
    });
    return windings;
  }

  struct Sums {
    std::array<bool, 3> hasArea{};
    std::array<mpz_class, 3> whole;       ///< areas of uncut segments
    std::array<mpf_class, 3> fractional;  ///< areas of pieces
    std::vector<CoverPiece> borders;
  };

  /// The end of a piece; `place` is null where it is the end of the segment itself.
  [[nodiscard]] CoverCorner cornerAt(std::uint32_t point, const Segment& s, const Place* place) const {
    if (place == nullptr) return {given_[point].x.get_d(), given_[point].y.get_d(), point};
    const CoverPoint &p = given_[s.from], &q = given_[s.to];
    const auto between = [&](const mpz_class& a, const mpz_class& b) {
      return mpq_class(a * place->denominator + (b - a) * place->numerator, place->denominator).get_d();
    };
    return {between(p.x, q.x), between(p.y, q.y), CoverCorner::kNoPoint};
  }

  /// Enough digits for the smallest face of the arrangement: it contains a triangle of three of its corners, each a
  /// crossing with a denominator below 2^(2 w + 4), so that its area is above 2^-(6 w + 14).
  [[nodiscard]] unsigned precision() const { return static_cast<unsigned>(8 * width_ + 256); }

  void addPiece(std::size_t number, const Place* start, const Place* end, std::vector<std::int32_t>& stack,
                Sums& sums) const {
    static const Place kStart{0, 1}, kEnd{1, 1};
    const Segment& s = segments_[number];
    const Jump at = windingsAt(probeBetween(number, start ? *start : kStart, end ? *end : kEnd), stack);
    const bool vertical = points_[s.from].x == points_[s.to].x;
    const Jump left = vertical ? at + s.jump : at, right = vertical ? at : at - s.jump;
    std::optional<mpz_class> whole;
    std::optional<mpf_class> part;
    for (const CoverPart k : {kOnlyFirst, kOnlySecond, kBoth}) {
      const int side = static_cast<int>(isIn(k, left)) - static_cast<int>(isIn(k, right));
      if (side == 0) continue;
      sums.hasArea[k] = true;
      if (withBorders_ && k != kBoth)
        sums.borders.push_back({k, side > 0, cornerAt(s.from, s, start), cornerAt(s.to, s, end)});
      if (!whole) {
        const CoverPoint &p = points_[s.from], &q = points_[s.to];
        whole = p.x * q.y - p.y * q.x;
      }
      if (start == nullptr && end == nullptr) {
        sums.whole[k] += side * *whole;
        continue;
      }
      if (!part) {
        const Place &a = start ? *start : kStart, &b = end ? *end : kEnd;
        part = mpf_class(0, precision());
        *part = mpf_class(*whole * (b.numerator * a.denominator - a.numerator * b.denominator), precision()) /
                mpf_class(a.denominator * b.denominator, precision());
      }
      sums.fractional[k] += side * *part;
    }
  }

  [[nodiscard]] CoverResult measure(std::vector<CoverPiece>* borders) const {
    const std::size_t ranges = (segments_.size() + kRange - 1) / kRange;
    std::vector<Sums> sums(ranges);
    forRanges(ranges, 1, [&](std::size_t firstRange, std::size_t lastRange) {
      std::vector<std::int32_t> stack;
      for (std::size_t r = firstRange; r < lastRange; ++r) {
        for (mpf_class& sum : sums[r].fractional) sum.set_prec(precision());
        for (std::size_t i = r * kRange; i < std::min((r + 1) * kRange, segments_.size()); ++i) {
          if (i % 16 == 0) poll_();
          const std::vector<Place>& cuts = cuts_[i];
          for (std::size_t c = 0; c <= cuts.size(); ++c)
            addPiece(i, c == 0 ? nullptr : &cuts[c - 1], c == cuts.size() ? nullptr : &cuts[c], stack, sums[r]);
        }
      }
    });
    CoverResult result;
    for (std::size_t k = 0; k < 3; ++k) {
      mpf_class total(0, precision());
      for (const Sums& sum : sums) {
        result.hasArea[k] = result.hasArea[k] || sum.hasArea[k];
        total += mpf_class(sum.whole[k], precision()) + sum.fractional[k];
      }
      result.twiceArea[k] = total;
    }
    if (borders != nullptr)
      for (const Sums& sum : sums) borders->insert(borders->end(), sum.borders.begin(), sum.borders.end());
    return result;
  }

  Poll poll_;
  const std::vector<CoverPoint>& given_;
  bool withBorders_;
  std::vector<CoverPoint> points_;  ///< the given ones, moved
  std::vector<std::array<double, 2>> rounded_;
  int width_ = 0;
  std::vector<Segment> segments_;
  std::vector<Box> boxes_;
  TriangleTree tree_;
  std::vector<std::vector<Place>> cuts_;  ///< cuts of each segment, rising
};

}  // namespace

CoverResult coverAreas(const std::vector<CoverPoint>& points, const std::vector<CoverEdge>& edges, Poll poll,
                       std::vector<CoverPiece>* borders) {
  return Arrangement(points, poll, borders != nullptr).areas(edges, borders);
}

}  // namespace footfall::detail::comparison
