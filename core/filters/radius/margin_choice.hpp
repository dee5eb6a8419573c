// Chooses the margins that a face needs, and finds whether they leave anything of it.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The choice uses doubles with bounds; in doubt a margin stays and a face is not covered. Convex sets cover a region R
// when they cover its outline, and when the parts of their own outlines inside R are in the inside of others: else the
// remainder of R would end at a place of one outline that is inside no other one. So the only question is which
// stretches of straight edges lie in convex polygons.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/filters/radius/margins.hpp"

namespace footfall::detail {

/// Threads cannot share it.
class MarginChoice {
 public:
  /// Must outlive it.
  explicit MarginChoice(const std::vector<Margin>& margins) : margins_(margins) {}

  struct Result {
    bool isCovered = false;           ///< the margins certainly leave nothing of the face
    std::span<const Index> needed{};  ///< if not: cutting out the others as well would change nothing; ascending
  };
  /// `numbers`: ascending, of margins; `corners`: the face's, scaled, counter-clockwise. Good until the next call.
  Result chooseOn(const std::array<PlanVector, 3>& corners, std::span<const Index> numbers);

 private:
  /// A part of an edge; its ends are 0 and 1.
  struct Stretch {
    double begin = 0, end = 1;
    [[nodiscard]] bool isEmpty() const { return !(begin < end); }
    [[nodiscard]] bool isWhole() const { return begin <= 0 && end >= 1; }
  };
  using Outline = std::span<const PlanVector>;  ///< outline of a convex polygon, counter-clockwise
  struct Bounds {
    PlanVector low, high;
    explicit Bounds(Outline places);
    /// True when nothing is in both.
    [[nodiscard]] bool isApartFrom(const Bounds& other) const {
      return high.x < other.low.x || other.high.x < low.x || high.y < other.low.y || other.high.y < low.y;
    }
  };
  struct Candidate {
    Index margin = -1;
    Outline outline;
    Bounds bounds;
    bool isNeeded = true;
    std::array<Stretch, 3> onEdges, maybeOnEdges;  ///< stretches of the face's edges that are inside for certain, or
                                                   ///< may be
  };
  /// An edge of a candidate, and the part of it that may be inside the face.
  struct Edge {
    const Candidate* candidate = nullptr;
    PlanVector from, to;
    Stretch inFace;
    Bounds bounds;  ///< of that part, and a little more than its places can be off
  };
  bool add(Index margin, const Bounds& face);
  void addEdges(const Candidate& candidate);
  /// A convex polygon holds a triangle when it holds its outline.
  static bool holdsFace(const Candidate& c) {
    return c.onEdges[0].isWhole() && c.onEdges[1].isWhole() && c.onEdges[2].isWhole();
  }
  /// The part of an edge that is inside for certain (`doubt` -1), or that may be (1).
  static Stretch part(Outline outline, const PlanVector& from, const PlanVector& to, int doubt);
  static Stretch insideOf(Outline o, const PlanVector& from, const PlanVector& to) { return part(o, from, to, -1); }
  static Stretch maybeInsideOf(Outline o, const PlanVector& from, const PlanVector& to) { return part(o, from, to, 1); }
  /// True when needed candidates but `except` (may be null) and its own cover a stretch of an edge.
  [[nodiscard]] bool isEdgeCovered(const Edge& edge, const Stretch& stretch, const Candidate* except) const;
  [[nodiscard]] bool isFaceEdgeCovered(int k, const Stretch& stretch, const Candidate* except) const;
  /// True when needed candidates but `except` (may be null) cover the face, or the part of it in `except`.
  [[nodiscard]] bool isCovered(const Candidate* except) const;

  const std::vector<Margin>& margins_;
  std::array<PlanVector, 3> face_;
  std::vector<Candidate> candidates_;
  std::vector<Edge> edges_;  ///< those with a part that may be inside the face, by candidate
  std::vector<Index> needed_;
  mutable std::vector<Stretch> stretches_;  ///< stretches of one edge
};

}  // namespace footfall::detail
