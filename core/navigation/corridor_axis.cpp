// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/navigation/corridor_axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/base/parallel.hpp"
#include "core/exact/source_predicates.hpp"
#include "core/navigation/axis_labels.hpp"
#include "core/navigation/axis_vertex.hpp"

namespace footfall::detail {
namespace {

constexpr double kFarAway = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNoFeature = FieldEdge::kNone;

/// A parabola about a corner, along an edge's line: at x along the line it is (x x + h h) / (2 h) away from it.
struct AxisParabola {
  double height = 0, from = 0, to = 0;
};
AxisParabola parabolaOf(const FieldFeature& edge, const FieldFeature& corner, FieldVector from, FieldVector to) {
  return {dot(corner.place - edge.place, edge.inward), dot(from - corner.place, edge.along),
          dot(to - corner.place, edge.along)};
}

/// The middle of a piece of axis between two features.
FieldVector middleOf(const FieldFeature& a, const FieldFeature& b, FieldVector from, FieldVector to) {
  const FieldVector middle = (from + to) * 0.5;
  if (a.isCorner() == b.isCorner()) return middle;
  const FieldFeature &edge = a.isCorner() ? b : a, &corner = a.isCorner() ? a : b;
  const AxisParabola p = parabolaOf(edge, corner, from, to);
  const double x = (p.from + p.to) / 2;
  // A corner of the edge, up to roundings: no parabola, but the edge's normal.
  if (p.height <= 1e-9 * (lengthOf(to - from) + std::fabs(x))) return middle;
  return corner.place + edge.along * x + edge.inward * ((x * x / p.height - p.height) / 2);
}

double distanceTo(const FieldFeature& feature, FieldVector p) { return lengthOf(feature.nearestTo(p) - p); }

/// The pieces of axis of one face. Numbers from `kOwn` on are nodes of its own.
struct FaceAxis {
  static constexpr std::uint32_t kOwn = 0x80000000;
  std::vector<AxisNode> nodes;
  std::vector<AxisArc> arcs;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;  ///< stretches of one region, by number
};

/// A stretch of the border of what is left of a face, the feature nearest there, and the node at its end.
struct AxisRegion {
  std::uint32_t feature = 0, node = 0;
  std::uint32_t stretch = 0;  ///< the number of the label of a mesh edge, or of the corner of the border
  FieldVector place;          ///< of the node
};

/// Takes out the regions of a face one by one.
class FaceForest {
 public:
  FaceForest(const ClearanceField& field, std::uint32_t face, std::vector<AxisRegion> regions, Poll poll)
      : field_(field), surface_(field.surface()), face_(face), regions_(std::move(regions)), poll_(poll) {
    for (const AxisRegion& region : regions_) features_.push_back(region.feature);
    std::sort(features_.begin(), features_.end());
    features_.erase(std::unique(features_.begin(), features_.end()), features_.end());
  }

  FaceAxis make() {
    ends_.resize(regions_.size());
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      if (i % 16 == 15) poll_();
      ends_[i] = endOf(i);
    }
    while (regions_.size() > 2) {
      if (regions_.size() % 16 == 15) poll_();
      std::size_t best = 0;
      for (std::size_t i = 1; i < ends_.size(); ++i)
        if (ends_[i].fault < ends_[best].fault) best = i;
      takeOutRegion(best);
    }
    if (regions_.size() == 2 && regions_[0].feature != regions_[1].feature)
      addArc(regions_[0].node, regions_[1].node, regions_[0], regions_[1]);
    return std::move(axis_);
  }

 private:
  /// The place where a region ends between its neighbours.
  struct End {
    FieldVector place;
    double fault = kFarAway;  ///< by how much it is not where three regions meet
  };

  [[nodiscard]] const FieldFeature& feature(std::uint32_t number) const { return field_.features()[number]; }
  [[nodiscard]] std::size_t before(std::size_t i) const { return i == 0 ? regions_.size() - 1 : i - 1; }
  [[nodiscard]] std::size_t behind(std::size_t i) const { return i + 1 == regions_.size() ? 0 : i + 1; }

  /// The larger of two faults: how much farther a feature is from a place than the nearest one, and how far the place
  /// lies outside of the face.
  [[nodiscard]] double faultAt(FieldVector p, std::uint32_t of) const {
    double least = kFarAway;
    for (const std::uint32_t f : features_) least = std::min(least, distanceTo(feature(f), p));
    double outside = 0;
    for (int side = 0; side < 3; ++side) {
      const std::uint32_t half = surface_.halves[face_][side];
      const FieldEdge& edge = surface_.edges[half >> 1];
      const double in = cross(edge.along, p - edge.begin);
      outside = std::max(outside, (half & 1) != 0 ? in : -in);
    }
    return distanceTo(feature(of), p) - least + outside;
  }

  [[nodiscard]] End endOf(std::size_t i) const {
    const AxisRegion &last = regions_[before(i)], &own = regions_[i], &next = regions_[behind(i)];
    const FieldVector middle = (last.place + own.place) * 0.5;
    if (last.feature == next.feature) {
      const FieldVector p = middleOf(feature(own.feature), feature(last.feature), last.place, own.place);
      return {p, faultAt(p, own.feature)};
    }
    // The region of a corner begins at the corner, between its own edges. Elsewhere, a stretch between them has no
    // width.
    if (feature(own.feature).isCorner() && (isAtFeature(own, last.place) || isAtFeature(own, own.place)) &&
        pairOf(field_, own.feature, last.feature) == AxisPair::Joined &&
        pairOf(field_, own.feature, next.feature) == AxisPair::Joined)
      return {own.place, kFarAway};
    std::array<FieldVector, 2> places;
    const int count = equallyFar(
        {axisFeature(field_, last.feature), axisFeature(field_, own.feature), axisFeature(field_, next.feature)},
        places);
    End end{middle, kFarAway};
    for (int k = 0; k < count; ++k) {
      double fault = 0;
      for (const std::uint32_t f : {last.feature, own.feature, next.feature})
        fault = std::max(fault, faultAt(places[k], f));
      // A feature may have several regions: the ways to where three meet must lie between these ones.
      for (const auto& [other, from] : {std::pair{last.feature, last.place}, std::pair{next.feature, own.place}})
        fault = std::max(fault, faultAt(middleOf(feature(own.feature), feature(other), from, places[k]), own.feature));
      if (fault < end.fault) end = {places[k], fault};
    }
    // Formulas that say nothing, or too little: the region ends where its nodes are, as far as that is worse.
    const double fault =
        std::max(faultAt(middle, last.feature), faultAt(middle, next.feature)) + lengthOf(last.place - own.place);
    return end.fault <= fault ? end : End{middle, fault};
  }

  /// Returns whether a place is the corner that a region belongs to.
  [[nodiscard]] bool isAtFeature(const AxisRegion& region, FieldVector p) const {
    const FieldVector corner = feature(region.feature).place;
    return p.x == corner.x && p.y == corner.y;
  }

  /// The sides follow from the order of the regions around the face, however places are rounded.
  void addArc(std::uint32_t from, std::uint32_t to, const AxisRegion& left, const AxisRegion& right) {
    if (from == to) return;
    const bool isFirstLeft = left.feature < right.feature;
    const AxisRegion &first = isFirstLeft ? left : right, &second = isFirstLeft ? right : left;
    axis_.arcs.push_back(
        {from, to, {first.feature, second.feature}, {first.stretch, second.stretch}, isFirstLeft, face_});
  }

  void takeOutRegion(std::size_t i) {
    const std::size_t last = before(i), next = behind(i);
    if (regions_[last].feature == regions_[next].feature) {
      addArc(regions_[last].node, regions_[i].node, regions_[last], regions_[i]);
      // Both neighbours are one region, whose end is that of the second one.
      axis_.joined.emplace_back(regions_[last].stretch, regions_[next].stretch);
      regions_[next].feature = regions_[last].feature;
      erase({i, last});
      return;
    }
    const FieldVector place = ends_[i].place;
    double distance = kFarAway;
    for (const std::size_t k : {last, i, next})
      distance = std::min(distance, distanceTo(feature(regions_[k].feature), place));
    const auto node = static_cast<std::uint32_t>(FaceAxis::kOwn + axis_.nodes.size());
    axis_.nodes.push_back({place, distance, face_});
    addArc(regions_[last].node, node, regions_[last], regions_[i]);
    addArc(regions_[i].node, node, regions_[i], regions_[next]);
    regions_[last].node = node;
    regions_[last].place = place;
    erase({i});
  }

  void erase(std::vector<std::size_t> which) {
    std::sort(which.rbegin(), which.rend());
    std::size_t near = which.back();
    for (const std::size_t i : which) {
      regions_.erase(regions_.begin() + static_cast<std::ptrdiff_t>(i));
      ends_.erase(ends_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    if (regions_.size() <= 2) return;
    near = near >= regions_.size() ? 0 : near;
    for (const std::size_t i : {before(before(near)), before(near), near, behind(near)}) ends_[i] = endOf(i);
  }

  const ClearanceField& field_;
  const FieldSurface& surface_;
  std::uint32_t face_;
  std::vector<AxisRegion> regions_;
  std::vector<End> ends_;
  std::vector<std::uint32_t> features_;
  Poll poll_;
  FaceAxis axis_;
};

/// Nodes on edges and at corners of the mesh.
class AxisMaker {
 public:
  AxisMaker(const ClearanceField& field, Poll poll) : field_(field), surface_(field.surface()), poll_(poll) {}

  CorridorAxis make() {
    makeLabels();
    std::vector<FaceAxis> pieces(surface_.faces.size());
    forRanges(pieces.size(), 256, [this, &pieces](std::size_t begin, std::size_t end) {
      poll_();
      for (std::size_t f = begin; f < end; ++f) {
        const auto face = static_cast<std::uint32_t>(f);
        if (!surface_.takesPart(face)) continue;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;
        std::vector<AxisRegion> regions = regionsOf(face, joined);
        if (regions.size() >= 2) pieces[f] = FaceForest(field_, face, std::move(regions), poll_).make();
        pieces[f].joined.insert(pieces[f].joined.end(), joined.begin(), joined.end());
      }
    });
    DisjointSets regions(firstStretch_.back() + surface_.topology.fanVertices.size());
    for (const FaceAxis& piece : pieces) {
      for (const auto& [a, b] : piece.joined) regions.unite(static_cast<Index>(a), static_cast<Index>(b));
      const auto first = static_cast<std::uint32_t>(axis_.nodes.size());
      const auto number = [&](std::uint32_t node) {
        return node >= FaceAxis::kOwn ? first + (node - FaceAxis::kOwn) : node;
      };
      axis_.nodes.insert(axis_.nodes.end(), piece.nodes.begin(), piece.nodes.end());
      for (AxisArc arc : piece.arcs) {
        arc.from = number(arc.from);
        arc.to = number(arc.to);
        axis_.arcs.push_back(arc);
      }
    }
    joinNear(regions);
    numberRegions(regions);
    return std::move(axis_);
  }

 private:
  /// Makes one node of those that very short arcs join. Where features are equally near along a whole stretch, regions
  /// without area may lie between them, with an arc on either side: such pairs go, and their regions become one.
  void joinNear(DisjointSets& regions) {
    const double least = 4 * field_.margin();
    DisjointSets sets(axis_.nodes.size());
    for (const AxisArc& arc : axis_.arcs)
      if (lengthOf(axis_.nodes[arc.to].place - axis_.nodes[arc.from].place) <= least)
        sets.unite(static_cast<Index>(arc.from), static_cast<Index>(arc.to));
    // Nodes within faces, which come last, have formulas; the others may be off by the margin.
    for (std::uint32_t n = cornerNodes_ + static_cast<std::uint32_t>(surface_.topology.fanVertices.size());
         n < axis_.nodes.size(); ++n)
      axis_.nodes[sets.find(static_cast<Index>(n))] = axis_.nodes[n];
    std::vector<AxisArc> arcs;
    for (AxisArc arc : axis_.arcs) {
      arc.from = static_cast<std::uint32_t>(sets.find(static_cast<Index>(arc.from)));
      arc.to = static_cast<std::uint32_t>(sets.find(static_cast<Index>(arc.to)));
      if (arc.from > arc.to) {
        std::swap(arc.from, arc.to);
        arc.isFirstLeft = !arc.isFirstLeft;
      }
      if (arc.from != arc.to) arcs.push_back(arc);
    }
    const auto key = [](const AxisArc& arc) { return std::tie(arc.from, arc.to, arc.features); };
    std::stable_sort(arcs.begin(), arcs.end(), [&](const AxisArc& a, const AxisArc& b) { return key(a) < key(b); });
    axis_.arcs.clear();
    for (std::size_t i = 0, end = 0; i < arcs.size(); i = end) {
      while (end < arcs.size() && key(arcs[end]) == key(arcs[i])) ++end;
      std::size_t leftCount = 0;
      for (const AxisArc& same : std::span(arcs).subspan(i, end - i)) {
        leftCount += same.isFirstLeft ? 1 : 0;
        for (const int side : {0, 1})
          regions.unite(static_cast<Index>(arcs[i].regions[side]), static_cast<Index>(same.regions[side]));
      }
      if ((end - i) % 2 == 0) continue;
      axis_.arcs.push_back(arcs[i]);
      axis_.arcs.back().isFirstLeft = 2 * leftCount > end - i;
    }
  }

  void numberRegions(DisjointSets& regions) {
    Index count = 0;
    const std::vector<Index> numbers = regions.numbers(count);
    axis_.reachesBorder.assign(static_cast<std::size_t>(count), 0);
    for (std::uint32_t e = 0; e < labels_.size(); ++e)
      if (surface_.edges[e].isBorder() && !labels_[e].empty()) axis_.reachesBorder[numbers[firstStretch_[e]]] = 1;
    for (std::uint32_t fan = 0; fan < surface_.topology.fanVertices.size(); ++fan)
      axis_.reachesBorder[numbers[firstStretch_.back() + fan]] = 1;
    for (AxisArc& arc : axis_.arcs)
      for (std::uint32_t& region : arc.regions) region = static_cast<std::uint32_t>(numbers[region]);
  }

  void addNode(FieldVector place, std::uint32_t a, std::uint32_t b, std::uint32_t face) {
    const auto& features = field_.features();
    axis_.nodes.push_back({place, std::min(distanceTo(features[a], place), distanceTo(features[b], place)), face});
  }

  void makeLabels() {
    labels_.resize(surface_.edges.size());
    forRanges(labels_.size(), 256, [this](std::size_t begin, std::size_t end) {
      poll_();
      for (std::size_t e = begin; e < end; ++e) {
        const auto edge = static_cast<std::uint32_t>(e);
        if (!surface_.edges[e].isBorder())
          labels_[e] = labelsOf(field_, edge);
        else if (field_.featureOfEdge(edge) != kNoFeature)
          labels_[e] = {{field_.featureOfEdge(edge), surface_.edges[e].length}};
      }
    });
    firstStretch_.assign(1, 0);
    for (const auto& labels : labels_)
      firstStretch_.push_back(firstStretch_.back() + static_cast<std::uint32_t>(labels.size()));
    nodes_.resize(labels_.size());
    for (std::size_t e = 0; e < labels_.size(); ++e) {
      nodes_[e] = static_cast<std::uint32_t>(axis_.nodes.size());
      for (std::size_t i = 0; i + 1 < labels_[e].size(); ++i)
        addNode(surface_.edges[e].at(labels_[e][i].end), labels_[e][i].feature, labels_[e][i + 1].feature,
                surface_.edges[e].faces[0]);
    }
    // A node for each corner of the mesh; most have no arcs.
    cornerNodes_ = static_cast<std::uint32_t>(axis_.nodes.size());
    axis_.nodes.resize(axis_.nodes.size() + surface_.topology.fanVertices.size());
    for (std::uint32_t f = 0; f < surface_.faces.size(); ++f)
      for (int i = 0; i < 3 && surface_.takesPart(f); ++i) {
        AxisNode& node = axis_.nodes[cornerNodes_ + surface_.topology.fans[f][i]];
        const FieldVector p = surface_.corner(f, i);
        double distance = kFarAway;
        for (const int side : {i, (i + 2) % 3})
          for (const AxisLabel& label : labels_[surface_.halves[f][side] >> 1])
            distance = std::min(distance, distanceTo(field_.features()[label.feature], p));
        node = {p, distance, f};
      }
  }

  /// The stretches around a face, in order. Neighbours that are one region are one stretch, and in `joined`.
  [[nodiscard]] std::vector<AxisRegion> regionsOf(std::uint32_t face,
                                                  std::vector<std::pair<std::uint32_t, std::uint32_t>>& joined) const {
    std::vector<AxisRegion> regions;
    const auto add = [&](const AxisRegion& region) {
      if (!regions.empty() && regions.back().feature == region.feature) {
        joined.emplace_back(regions.back().stretch, region.stretch);
        regions.pop_back();
      }
      regions.push_back(region);
    };
    for (int side = 0; side < 3; ++side) {
      const std::uint32_t fan = surface_.topology.fans[face][side], own = field_.featureOfFan(fan);
      // The region of a corner of the border may touch the border of the face nowhere else.
      if (own != kNoFeature) add({own, cornerNodes_ + fan, firstStretch_.back() + fan, surface_.corner(face, side)});
      const std::uint32_t half = surface_.halves[face][side], edge = half >> 1;
      const auto& labels = labels_[edge];
      const std::size_t count = labels.size();
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = (half & 1) != 0 ? count - 1 - i : i;
        const std::size_t node = nodes_[edge] + ((half & 1) != 0 ? at - 1 : at);
        const bool isLast = i + 1 == count;
        const std::uint32_t corner = cornerNodes_ + surface_.topology.fans[face][(side + 1) % 3];
        const std::uint32_t end = isLast ? corner : static_cast<std::uint32_t>(node);
        add({labels[at].feature, end, firstStretch_[edge] + static_cast<std::uint32_t>(at), axis_.nodes[end].place});
      }
    }
    while (regions.size() > 1 && regions.front().feature == regions.back().feature) {
      joined.emplace_back(regions.front().stretch, regions.back().stretch);
      regions.pop_back();
    }
    if (regions.size() == 1) regions.clear();
    return regions;
  }

  const ClearanceField& field_;
  const FieldSurface& surface_;
  Poll poll_;
  std::vector<std::vector<AxisLabel>> labels_;  ///< of each edge
  std::vector<std::uint32_t> nodes_;            ///< the first node of each edge
  std::vector<std::uint32_t> firstStretch_;     ///< of each edge, the number of its first label; and of all labels
  std::uint32_t cornerNodes_ = 0;
  CorridorAxis axis_;
};

}  // namespace

CorridorAxis makeCorridorAxis(const ClearanceField& field, Poll poll) { return AxisMaker(field, poll).make(); }

AxisPair pairOf(const ClearanceField& field, std::uint32_t a, std::uint32_t b) {
  const AxisFeature f = axisFeature(field, a), g = axisFeature(field, b);
  const bool isBefore = f.endFan == g.beginFan, isBehind = g.endFan == f.beginFan;
  if (!isBefore && !isBehind) return AxisPair::Apart;
  if (f.feature->isCorner() && g.feature->isCorner()) return AxisPair::Apart;
  if (f.feature->isCorner() || g.feature->isCorner()) return AxisPair::Joined;
  const FieldFeature &first = *(isBefore ? f : g).feature, &second = *(isBefore ? g : f).feature;
  const FieldSurface& surface = field.surface();
  const FieldVector p = surface.corner(first.face, first.side), q = surface.corner(second.face, second.side),
                    r = surface.corner(second.face, second.side + 1);
  return facing({p.x, p.y, 0}, {q.x, q.y, 0}, {r.x, r.y, 0}) > 0 ? AxisPair::Convex : AxisPair::Joined;
}

double areaBeside(const FieldFeature& feature, const FieldFeature& other, FieldVector from, FieldVector to) {
  if (feature.isCorner()) {
    const double straight = std::fabs(cross(from - feature.place, to - feature.place)) / 2;
    if (other.isCorner()) return straight;
    const AxisParabola p = parabolaOf(other, feature, from, to);
    if (!(p.height > 0)) return straight;
    // The rays from the focus to a parabola sweep half of what its distances to the directrix do.
    return std::fabs((p.to * p.to * p.to - p.from * p.from * p.from) / 3 + p.height * p.height * (p.to - p.from)) /
           (4 * p.height);
  }
  const double width = dot(to - from, feature.along);
  const double a = dot(from - feature.place, feature.inward), b = dot(to - feature.place, feature.inward);
  if (!other.isCorner()) return std::fabs(width) * (a + b) / 2;
  const AxisParabola p = parabolaOf(feature, other, from, to);
  if (!(p.height > 0)) return std::fabs(width) * (a + b) / 2;
  return std::fabs((p.to * p.to * p.to - p.from * p.from * p.from) / 3 + p.height * p.height * (p.to - p.from)) /
         (2 * p.height);
}

double areaOf(const ClearanceField& field, const CorridorAxis& axis, const AxisArc& arc) {
  const FieldFeature &f = field.features()[arc.features[0]], &g = field.features()[arc.features[1]];
  const FieldVector from = axis.nodes[arc.from].place, to = axis.nodes[arc.to].place;
  return areaBeside(f, g, from, to) + areaBeside(g, f, from, to);
}

double axisLength(const FieldFeature& a, const FieldFeature& b, FieldVector from, FieldVector to) {
  const double chord = lengthOf(to - from);
  if (a.isCorner() == b.isCorner()) return chord;
  const AxisParabola p = parabolaOf(a.isCorner() ? b : a, a.isCorner() ? a : b, from, to);
  if (!(p.height > 0)) return chord;
  const auto primitive = [](double s) { return (s * std::sqrt(1 + s * s) + std::asinh(s)) / 2; };
  return std::max(chord, p.height * std::fabs(primitive(p.to / p.height) - primitive(p.from / p.height)));
}

std::optional<FieldVector> narrowPlaceOf(const FieldFeature& a, const FieldFeature& b, FieldVector from,
                                         FieldVector to) {
  if (!a.isCorner() && !b.isCorner()) return std::nullopt;
  FieldVector place = (a.place + b.place) * 0.5, along = to - from;
  if (a.isCorner() != b.isCorner()) {
    const FieldFeature &edge = a.isCorner() ? b : a, &corner = a.isCorner() ? a : b;
    const double foot = dot(corner.place - edge.place, edge.along);
    if (foot < 0 || foot > edge.length) return std::nullopt;
    place = (corner.place + edge.place + edge.along * foot) * 0.5;
    along = edge.along * (dot(edge.along, along) >= 0 ? 1 : -1);
  }
  if (dot(place - from, along) <= 0 || dot(to - place, along) <= 0) return std::nullopt;
  return place;
}

}  // namespace footfall::detail
