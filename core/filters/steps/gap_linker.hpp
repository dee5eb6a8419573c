// Finding where an agent steps across a gap between two borders, and giving both vertices there.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/filters/steps/border_splits.hpp"
#include "core/filters/steps/gap_conditions.hpp"
#include "core/filters/steps/gap_ways.hpp"

namespace footfall::detail {

/// Two borders, the second one to the right of the first, and the piece of the gap between them that is free.
struct GapStretch {
  Index first = -1, second = -1;
  GapPiece piece;
  std::array<bool, 2> isDrawnIn{};  ///< its ends, from where an obstacle touched them
  bool isDropped = false;
};

/// Borders that were asked for last, one for each remainder; for one thread.
struct GapLines {
  static constexpr Index kCount = 64;
  std::array<Index, kCount> numbers;
  std::array<GapBorder, kCount> lines;
  GapLines() { numbers.fill(-1); }
};

/// Splits the borders beside gaps so that a link is a pair of whole edges: the place across from a vertex is where a
/// line at a right angle to the bisector of both borders meets the other one; such lines lead through places of the
/// plan, which the kernel gets. What the cuts made of a gap is then proven: the area between its ends is free.
class GapLinker {
 public:
  /// `gap`: the widest, in environment units. `splits` must outlive this.
  GapLinker(BorderSplits& splits, double gap, RunContext& context);

  /// The free pieces between two borders that are not on one line in the plan, in their order. Changes nothing: may be
  /// called by several threads, with conditions and lines of their own.
  std::vector<GapStretch> find(Index first, Index second, GapConditions& conditions, GapLines& lines) const;
  /// The same of a gap that was stepped over between two edges, and between what is left of their borders: the stretch
  /// along which all four lie. Nothing but obstacles is asked about, and they only where there are conditions.
  std::vector<GapStretch> findAgain(Index first, Index second, const std::array<GapBorder, 2>& edges,
                                    GapConditions* conditions);
  /// An edge with its ends as exact as they are needed.
  [[nodiscard]] GapBorder lineOf(const MeshVertex& from, const MeshVertex& to, Index face) const;
  [[nodiscard]] const GapBorder& lineOf(Index border);

  /// What to link; before split().
  void add(std::vector<GapStretch> stretches);
  [[nodiscard]] bool isEmpty() const { return gaps_.empty(); }
  /// Called with the edges that got vertices.
  using Spread = std::function<void(const std::vector<Index>& changed)>;
  /// Puts vertices on the borders until those of each gap lie across from each other. After more gaps were added, it
  /// goes on with these, and with what their vertices change.
  void split(const Spread& spread);
  /// Where split() led to links, in the order of the gaps.
  [[nodiscard]] std::vector<GapWay> ways();
  /// Both sides of the parts of gaps that were added and led to no link.
  [[nodiscard]] std::vector<PlanSegment> lostParts();
  /// The links, by the vertices of the mesh that `splits` made.
  [[nodiscard]] std::vector<MeshLink> links();

  /// Pieces of gaps of which it is not known where the link ends: they are not linked.
  [[nodiscard]] std::size_t undecided() const { return undecided_; }
  [[nodiscard]] const ExactFallbacks& fallbacks() const { return fallbacks_; }

 private:
  /// A place at which an edge is to be split, and the line across it that says where.
  struct Cut {
    Index border = -1;
    std::array<Vec3, 2> line;
  };
  struct Cuts {
    std::size_t most = 0;
    std::vector<Cut> list;
    std::unordered_map<Index, std::multimap<double, Vec3>> places;  ///< of each edge, by its longer coordinate
  };
  /// Vertices of a border, of its first one (of `from`) and up: those that lie along a part of a frame.
  struct ChainPart {
    std::size_t begin = 0, end = 0;
  };
  /// Of a gap on one of its borders, low and high.
  using Corners = std::array<const MeshVertex*, 2>;
  /// What is wrong with a gap, and at which of its ends.
  enum class Fault { None, Unknown, Overlaps, Meets, IsTouched, IsTooWide };
  struct Proof {
    Fault fault = Fault::None;
    int end = -1;
  };

  [[nodiscard]] Vec3 placeOf(const MeshVertex& v) const;
  [[nodiscard]] GapBorder computeLine(Index border) const;
  /// Whether two borders may face each other near enough, by rounded vertices. False is certain.
  [[nodiscard]] bool mayFace(const MeshBorder& e, const MeshBorder& f) const;
  /// A border's vertices, from its first one to its last, by their places; until an edge gets more of them.
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
  /// The number of the vertex at a place along a frame; nothing when there is none.
  [[nodiscard]] static std::optional<std::size_t> findAt(const Chain& chain, const GapFrame& frame, double along);
  /// The vertex of a border at a place along a frame; null when there is none.
  [[nodiscard]] const MeshVertex* vertexAt(Index border, const GapFrame& frame, double along);
  /// False when they would be more than allowed.
  [[nodiscard]] bool planCuts(Cuts& cuts);
  void planCut(GapStretch& stretch, Index border, const Chain& chain, double along, Cuts& cuts);
  void makeCuts(const std::vector<Cut>& cuts, const Spread& spread);
  /// Proves of all gaps what the cuts made of them; draws ends in. False when none was.
  bool proveAll();
  [[nodiscard]] Proof prove(const GapStretch& stretch);
  /// Draws in the end at which a gap failed. False when nothing is left.
  [[nodiscard]] bool drawIn(GapStretch& stretch, const Proof& proof);
  [[nodiscard]] bool isWider(const MeshVertex& a, const MeshVertex& b) const;
  [[nodiscard]] bool isOutside(Index obstacle, const Corners& p, const Corners& q, int end);
  /// Calls visit(i, j) for each link of a gap: from vertex i - 1 of the first border to i, and from j to j + 1 of the
  /// second one. Returns how many pairs of vertices that lie across from each other have unpaired ones between them.
  template <class Visit>
  std::size_t visitLinks(const GapStretch& stretch, const Visit& visit);
  /// The parts of a gap that have links, along its frame, ascending.
  [[nodiscard]] std::vector<std::array<double, 2>> linkedParts(const GapStretch& stretch);
  void addLinks(const GapStretch& stretch, std::vector<MeshLink>& links);
  [[nodiscard]] std::array<std::size_t, 2> chainLengths(const GapStretch& stretch) const;
  /// True where nothing about a gap has changed since split() ended.
  [[nodiscard]] bool isSettled(std::size_t gap) const { return chainLengths(gaps_[gap]) == known_[gap].chains; }

  BorderSplits& splits_;
  RunContext& context_;
  double gap_ = 0;
  std::unordered_map<Index, GapBorder> lines_;           ///< of borders that were asked for
  std::unordered_map<Index, std::vector<Vec3>> places_;  ///< of the new vertices of edges
  struct Known {
    std::array<double, 2> ends;           ///< where the gap ended when it was added
    std::array<std::size_t, 2> chains{};  ///< vertices of its borders when split() ended
  };
  std::vector<GapStretch> gaps_;
  std::vector<Known> known_;  ///< of gaps_
  ExactFallbacks fallbacks_;
  std::size_t undecided_ = 0;
};

}  // namespace footfall::detail
