// Finds the gaps that an agent steps across between two borders, and gives both borders vertices there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/base/disjoint_sets.hpp"
#include "core/filters/steps/border_splits.hpp"
#include "core/filters/steps/gap_conditions.hpp"
#include "core/filters/steps/gap_ways.hpp"

namespace footfall::detail {

/// Two borders, the second one to the right of the first, and the free piece of the gap between them.
struct GapStretch {
  Index first = -1, second = -1;
  GapPiece piece;
  std::array<bool, 2> isDrawnIn{};  ///< ends that were drawn in from an obstacle that touched them
  bool isDropped = false;
};

/// A cache of borders for one thread; each remainder of the index has one entry.
struct GapLines {
  static constexpr Index kCount = 64;
  std::array<Index, kCount> numbers;
  std::array<GapBorder, kCount> lines;
  GapLines() { numbers.fill(-1); }
};

/// Splits the borders beside gaps so that each link is a pair of whole edges. The place across from a vertex is where a
/// line at a right angle to the bisector of both borders meets the other border. Such lines lead through places of the
/// plan, which the kernel gets. Each gap between the new vertices is then proven free.
class GapLinker {
 public:
  /// `gap` is the widest gap, in environment units. `splits` must outlive this object.
  GapLinker(BorderSplits& splits, double gap, RunContext& context);

  /// The free pieces between two borders that are not on one line in the plan, in their order. Changes nothing; several
  /// threads may call it with conditions and lines of their own.
  std::vector<GapStretch> find(Index first, Index second, GapConditions& conditions, GapLines& lines) const;
  /// The free pieces of an earlier gap between two edges, on the remainders of their borders: the stretch along which
  /// all four lie. Only obstacles are tested, and only where there are conditions.
  std::vector<GapStretch> findAgain(Index first, Index second, const std::array<GapBorder, 2>& edges,
                                    GapConditions* conditions);
  /// An edge with its ends as exact as this class needs them.
  [[nodiscard]] GapBorder lineOf(const MeshVertex& from, const MeshVertex& to, Index face) const;
  [[nodiscard]] const GapBorder& lineOf(Index border);

  /// Adds gaps to link; called before split().
  void add(std::vector<GapStretch> stretches);
  [[nodiscard]] bool isEmpty() const { return gaps_.empty(); }
  /// A callback that gets the edges with new vertices.
  using Spread = std::function<void(const std::vector<Index>& changed)>;
  /// Puts vertices on the borders until those of each gap lie across from each other. After more gaps were added, it
  /// goes on with these, and with what their vertices change. `rows` has the edges that spread() joins as one set; gaps
  /// are added to it. Gaps of different sets decide nothing about each other.
  void split(DisjointSets& rows, const Spread& spread);
  /// Where split() led to links, in the order of the gaps.
  [[nodiscard]] std::vector<GapWay> ways();
  /// Both sides of the parts of added gaps that got no link.
  [[nodiscard]] std::vector<PlanSegment> lostParts();
  /// The links, as vertices of the mesh that `splits` made.
  [[nodiscard]] std::vector<MeshLink> links();

  /// The number of pieces of gaps whose links have no provable end; they are not linked.
  [[nodiscard]] std::size_t undecided() const { return undecided_; }
  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }

 private:
  /// A place at which an edge is to be split, and the line across the edge that defines it.
  struct Cut {
    Index border = -1;
    std::array<Vec3, 2> line;
  };
  struct Cuts {
    std::size_t most = 0;
    std::vector<Cut> list;
    std::unordered_map<Index, std::multimap<double, Vec3>> places;  ///< by edge, sorted by its longer coordinate
  };
  /// The vertices of a border, starting at its first (its `from`), that lie along a part of a frame.
  struct ChainPart {
    std::size_t begin = 0, end = 0;
  };
  /// The corners of a gap on one of its borders, low and high.
  using Corners = std::array<const MeshVertex*, 2>;
  /// The fault of a gap, and the end that has it.
  enum class Fault { None, Unknown, Overlaps, Meets, IsTouched, IsTooWide };
  struct Proof {
    Fault fault = Fault::None;
    int end = -1;
  };

  [[nodiscard]] Vec3 placeOf(const MeshVertex& v) const;
  [[nodiscard]] GapBorder computeLine(Index border) const;
  /// Returns whether two borders may face each other within the gap, by rounded vertices. False is certain.
  [[nodiscard]] bool mayFace(const MeshBorder& e, const MeshBorder& f) const;
  /// The vertices of a border from its first one to its last, sorted by place, until an edge gets more vertices.
  struct Chain {
    const GapBorder& line;
    const std::vector<Vec3>& inside;
    bool isForward = true;  ///< `inside` is in the border's direction
    [[nodiscard]] std::size_t length() const { return inside.size() + 2; }
    [[nodiscard]] const Vec3& place(std::size_t i) const {
      if (i == 0) return line.from;
      if (i == inside.size() + 1) return line.to;
      return inside[isForward ? i - 1 : inside.size() - i];
    }
    [[nodiscard]] double along(const GapFrame& frame, std::size_t i) const {
      const Vec3& p = place(i);
      return frame.along(p.x, p.y);
    }
  };
  [[nodiscard]] Chain chainOf(Index border);
  [[nodiscard]] static ChainPart partOf(const Chain& chain, const GapFrame& frame, double low, double high);
  /// The number of the vertex at a place along a frame; empty when there is none.
  [[nodiscard]] static std::optional<std::size_t> findAt(const Chain& chain, const GapFrame& frame, double along);
  /// The vertex of a border at a place along a frame; null when there is none.
  [[nodiscard]] const MeshVertex* vertexAt(Index border, const GapFrame& frame, double along);
  /// Gaps whose borders get vertices together.
  struct Group {
    std::vector<std::size_t> gaps;
    std::size_t open = 0;             ///< number of gaps that are not settled
    std::size_t mostCuts = SIZE_MAX;  ///< in one round
    bool isOpen = true;               ///< rounds go on
    bool isDone = false;              ///< all vertices are there
  };
  /// The groups with gaps that are not settled.
  [[nodiscard]] std::vector<Group> openGroups(DisjointSets& rows) const;
  /// Plans a round of a group.
  void goOn(Group& group, Cuts& cuts);
  /// False when they would be more than allowed.
  [[nodiscard]] bool planCuts(const Group& group, Cuts& cuts);
  /// `own` is the number of the border in the stretch: 0 or 1.
  void planCut(GapStretch& stretch, std::size_t own, const Chain& chain, double along, Cuts& cuts);
  void makeCuts(const std::vector<Cut>& cuts, const Spread& spread);
  /// Proves of the gaps of a group what the cuts made of them; draws ends in. False when none was.
  bool prove(const Group& group);
  [[nodiscard]] Proof prove(const GapStretch& stretch);
  /// Draws in the end at which the proof of a gap failed. Returns false when nothing of the gap is left.
  [[nodiscard]] bool drawIn(GapStretch& stretch, const Proof& proof);
  [[nodiscard]] bool isWider(const MeshVertex& a, const MeshVertex& b) const;
  [[nodiscard]] bool isOutside(Index obstacle, const Corners& p, const Corners& q, int end);
  /// Calls visit(i, j) for each link of a gap: from vertex i - 1 of the first border to i, and from j to j + 1 of the
  /// second one. Returns the number of pairs of opposite vertices that have unpaired vertices between them.
  template <class Visit>
  std::size_t visitLinks(const GapStretch& stretch, const Visit& visit);
  /// The parts of a gap that have links, along its frame, ascending.
  [[nodiscard]] std::vector<std::array<double, 2>> linkedParts(const GapStretch& stretch);
  void addLinks(const GapStretch& stretch, std::vector<MeshLink>& links);
  [[nodiscard]] std::array<std::size_t, 2> chainLengths(const GapStretch& stretch) const;
  /// Returns whether nothing of a gap has changed since split() ended.
  [[nodiscard]] bool isSettled(std::size_t gap) const { return chainLengths(gaps_[gap]) == known_[gap].chains; }

  BorderSplits& splits_;
  RunContext& context_;
  double gap_ = 0;
  std::unordered_map<Index, GapBorder> lines_;           ///< lines of borders that were computed
  std::unordered_map<Index, std::vector<Vec3>> places_;  ///< new vertices of edges
  struct Known {
    std::array<double, 2> ends;           ///< ends of the gap when it was added
    std::array<std::size_t, 2> chains{};  ///< number of vertices of its borders when split() ended
  };
  std::vector<GapStretch> gaps_;
  std::vector<Known> known_;  ///< entries for gaps_
  ExactFallbacks fallbacks_;
  std::size_t undecided_ = 0;
};

}  // namespace footfall::detail
