// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/triangle_tree.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace footfall {
namespace {

constexpr std::size_t kWidth = 4;      // children of a node
constexpr std::size_t kSlabSize = 16;  // smaller nodes are split by count, to fill those below; larger ones by area
constexpr int kBins = 16;
// Below this depth everything is split by count, so that no input makes the tree, and the recursion, deep.
constexpr int kAreaDepth = 24;

Float4 smaller(Float4 a, Float4 b) { return a < b ? a : b; }
Float4 larger(Float4 a, Float4 b) { return a > b ? a : b; }

struct Bounds {
  Float4 lower = Float4{} + std::numeric_limits<float>::infinity();
  Float4 upper = Float4{} - std::numeric_limits<float>::infinity();

  void include(Float4 l, Float4 u) {
    lower = smaller(lower, l);
    upper = larger(upper, u);
  }
  void include(const Bounds& b) { include(b.lower, b.upper); }
  [[nodiscard]] float halfArea() const {
    const Float4 size = upper - lower;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

Float4 lowerOf(const TreeItem& item) {
  Float4 lower;
  std::memcpy(&lower, &item, sizeof lower);
  return lower;
}

Float4 upperOf(const TreeItem& item) {
  Float4 upper;
  std::memcpy(&upper, reinterpret_cast<const char*>(&item) + sizeof upper, sizeof upper);
  return upper;
}

/// Times 2.
float centreOf(const TreeItem& item, int axis) { return item.lower[axis] + item.upper[axis]; }

int widestAxis(const Bounds& b) {
  const Float4 size = b.upper - b.lower;
  if (size[0] >= size[1]) return size[0] >= size[2] ? 0 : 2;
  return size[1] >= size[2] ? 1 : 2;
}

/// Items that will be a child of a node.
struct Part {
  std::span<TreeItem> items;
  Bounds box;
  Bounds centres;  ///< times 2

  Part() = default;
  explicit Part(std::span<TreeItem> given) : items(given) {
    for (const TreeItem& item : items) {
      const Float4 lower = lowerOf(item), upper = upperOf(item), centre = lower + upper;
      box.include(lower, upper);
      centres.include(centre, centre);
    }
  }
};

/// Divides the items of a node among its children by the surface-area heuristic over bins of the centres (Wald 2007,
/// "On fast construction of SAH-based bounding volume hierarchies"), here with one look at the items for all four
/// children. One for each thread: it holds working memory.
class ItemDivider {
 public:
  explicit ItemDivider(const std::function<void()>& poll) : poll_(poll) {}

  /// Makes up to four parts, of which none is empty.
  std::size_t divide(const Part& whole, int depth, std::array<Part, kWidth>& parts) {
    const std::size_t total = whole.items.size();
    if (total <= kWidth) {
      for (std::size_t i = 0; i < total; ++i) parts[i] = Part(whole.items.subspan(i, 1));
      return total;
    }
    if (total > kSlabSize && depth < kAreaDepth) {
      const std::size_t count = divideIntoSlabs(whole, parts);
      if (count != 0) return count;
    }
    parts[0] = whole;
    std::size_t count = 1;
    while (count < kWidth) {
      std::size_t next = kWidth;
      for (std::size_t i = 0; i < count; ++i)
        if (parts[i].items.size() > kWidth && (next == kWidth || parts[i].box.halfArea() > parts[next].box.halfArea()))
          next = i;
      if (next == kWidth) break;
      const std::span<TreeItem> items = parts[next].items;
      const std::size_t middle = split(parts[next]);
      if (items.size() > kPolledSize) poll_();
      parts[next] = Part(items.first(middle));
      parts[count++] = Part(items.subspan(middle));
    }
    return count;
  }

 private:
  static constexpr std::size_t kPolledSize = 16384;
  static constexpr std::size_t kScratchSize = 8192;

  struct Bin {
    Bounds box;
    std::size_t count = 0;

    void include(const Bin& other) {
      box.include(other.box);
      count += other.count;
    }
    [[nodiscard]] float cost() const { return box.halfArea() * static_cast<float>(count); }
  };
  using Bins = std::array<Bin, kBins>;

  /// Cuts along one axis at up to three borders of bins, into two to four slabs; none where the centres hardly differ.
  std::size_t divideIntoSlabs(const Part& whole, std::array<Part, kWidth>& parts) {
    const int axis = widestAxis(whole.centres);
    const float least = whole.centres.lower[axis];
    const float perBin = kBins / (whole.centres.upper[axis] - least);
    if (!std::isfinite(perBin)) return 0;
    const auto binOf = [=](const TreeItem& item) {
      return std::min(static_cast<int>((centreOf(item, axis) - least) * perBin), kBins - 1);
    };
    // Neighbours tend to fall into one bin: with two sets of bins they need not wait for each other.
    std::array<Bins, 2> bins;
    const std::span<TreeItem> items = whole.items;
    for (std::size_t i = 0; i < items.size(); ++i) {
      Bin& bin = bins[i & 1][binOf(items[i])];
      bin.box.include(lowerOf(items[i]), upperOf(items[i]));
      ++bin.count;
    }
    if (items.size() > kPolledSize) poll_();
    for (int bin = 0; bin < kBins; ++bin) bins[0][bin].include(bins[1][bin]);

    const int middle = cheapestBorder(bins[0], 0, kBins);
    const std::array<int, kWidth + 1> borders{0, cheapestBorder(bins[0], 0, middle), middle,
                                              cheapestBorder(bins[0], middle, kBins), kBins};
    std::array<std::uint8_t, kBins> slabs{};
    std::array<std::size_t, kWidth> sizes{};
    for (int bin = 0; bin < kBins; ++bin) {
      while (bin >= borders[slabs[bin] + 1]) ++slabs[bin];
      sizes[slabs[bin]] += bins[0][bin].count;
    }
    moveToSlabs(items, sizes, [&](const TreeItem& item) { return slabs[binOf(item)]; });
    std::size_t count = 0, first = 0;
    for (const std::size_t size : sizes) {
      if (size > 0) parts[count++] = Part(items.subspan(first, size));
      first += size;
    }
    return count;
  }

  /// The bin between `first` and `last` with which the second half begins; `last` where either half would be empty.
  static int cheapestBorder(const Bins& bins, int first, int last) {
    std::array<float, kBins> costs{};  // of what lies at and after the bin
    Bin after;
    for (int bin = last - 1; bin > first; --bin) {
      after.include(bins[bin]);
      costs[bin] = after.count == 0 ? std::numeric_limits<float>::infinity() : after.cost();
    }
    Bin before;
    int best = last;
    float lowest = std::numeric_limits<float>::infinity();
    for (int bin = first + 1; bin < last; ++bin) {
      before.include(bins[bin - 1]);
      if (before.count == 0) continue;
      const float cost = before.cost() + costs[bin];
      if (cost < lowest) {
        lowest = cost;
        best = bin;
      }
    }
    return best;
  }

  /// Moves the items to the order of their slabs, of which the sizes are known.
  template <class SlabOf>
  void moveToSlabs(std::span<TreeItem> items, const std::array<std::size_t, kWidth>& sizes, const SlabOf& slabOf) {
    if (items.size() > kScratchSize) {
      const auto middle =
          std::partition(items.begin(), items.end(), [&](const TreeItem& item) { return slabOf(item) < 2; });
      poll_();
      std::partition(items.begin(), middle, [&](const TreeItem& item) { return slabOf(item) < 1; });
      std::partition(middle, items.end(), [&](const TreeItem& item) { return slabOf(item) < 3; });
      return;
    }
    if (!scratch_) scratch_ = std::make_unique_for_overwrite<TreeItem[]>(kScratchSize);
    std::array<std::size_t, kWidth> places{0, sizes[0], sizes[0] + sizes[1], sizes[0] + sizes[1] + sizes[2]};
    for (const TreeItem& item : items) scratch_[places[slabOf(item)]++] = item;
    std::copy_n(scratch_.get(), items.size(), items.begin());
  }

  /// How many of the items come first, to fill nodes; they are moved there.
  static std::size_t split(const Part& part) {
    const int axis = widestAxis(part.centres);
    const std::size_t count = part.items.size();
    const std::size_t middle = (count / 2 + kWidth - 1) / kWidth * kWidth;
    std::nth_element(part.items.begin(), part.items.begin() + static_cast<std::ptrdiff_t>(middle), part.items.end(),
                     [axis](const TreeItem& a, const TreeItem& b) { return centreOf(a, axis) < centreOf(b, axis); });
    return middle;
  }

  const std::function<void()>& poll_;
  std::unique_ptr<TreeItem[]> scratch_;
};

}  // namespace

class TriangleTreeBuilder {
 public:
  using Node = TriangleTree::Node;

  TriangleTreeBuilder(const std::function<void()>& poll, std::vector<Node>& nodes) : poll_(poll), nodes_(nodes) {}

  void build(std::span<TreeItem> items) {
    if (items.empty()) return;
    Subtree root;
    grow(root, Part(items), 0);
    if (!root.below) {
      nodes_ = std::move(root.nodes);
      return;
    }
    nodes_.reserve(root.size);
    append(root);
  }

 private:
  /// Part of the tree that one thread made, or a node and the parts below it that others made.
  struct Subtree {
    std::vector<Node> nodes;  ///< children count from the first
    std::unique_ptr<std::array<Subtree, kWidth>> below;
    std::size_t size = 0;  ///< nodes, those below included
  };

  static Node nodeOf(std::span<const Part> parts) {
    Node node;
    for (int k = 0; k < 3; ++k) {
      node.lower[k] = Float4{} + std::numeric_limits<float>::infinity();
      node.upper[k] = Float4{} - std::numeric_limits<float>::infinity();
      for (std::size_t i = 0; i < parts.size(); ++i) {
        node.lower[k][i] = parts[i].box.lower[k];
        node.upper[k][i] = parts[i].box.upper[k];
      }
    }
    node.children.fill(0);
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].items.size() == 1) node.children[i] = ~parts[i].items[0].id;
    return node;
  }

  static std::int32_t growAlone(std::vector<Node>& nodes, const Part& whole, int depth, ItemDivider& divider) {
    std::array<Part, kWidth> parts;
    const std::size_t count = divider.divide(whole, depth, parts);
    const std::size_t self = nodes.size();
    nodes.push_back(nodeOf({parts.data(), count}));
    for (std::size_t i = 0; i < count; ++i)
      if (parts[i].items.size() > 1) {
        const std::int32_t child = growAlone(nodes, parts[i], depth + 1, divider);
        nodes[self].children[i] = child;
      }
    return static_cast<std::int32_t>(self);
  }

  void grow(Subtree& tree, const Part& whole, int depth) const {
    poll_();
    ItemDivider divider(poll_);
    if (whole.items.size() <= TriangleTree::kParallelSize) {
      tree.nodes.reserve(whole.items.size() / 2 + 1);
      growAlone(tree.nodes, whole, depth, divider);
      tree.size = tree.nodes.size();
      return;
    }
    std::array<Part, kWidth> parts;
    const std::size_t count = divider.divide(whole, depth, parts);
    tree.nodes.push_back(nodeOf({parts.data(), count}));
    tree.below = std::make_unique<std::array<Subtree, kWidth>>();
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      if (parts[i].items.size() > 1) grow((*tree.below)[i], parts[i], depth + 1);
    });
    tree.size = 1;
    for (const Subtree& below : *tree.below) tree.size += below.size;
  }

  /// Moves the nodes of a subtree to the end of all.
  void append(Subtree& tree) const {
    poll_();
    const auto self = nodes_.size();
    for (Node node : tree.nodes) {
      for (std::int32_t& child : node.children)
        if (child > 0) child += static_cast<std::int32_t>(self);
      nodes_.push_back(node);
    }
    tree.nodes = {};
    if (!tree.below) return;
    for (std::size_t i = 0; i < kWidth; ++i) {
      if ((*tree.below)[i].size == 0) continue;
      nodes_[self].children[i] = static_cast<std::int32_t>(nodes_.size());
      append((*tree.below)[i]);
    }
  }

  const std::function<void()>& poll_;
  std::vector<Node>& nodes_;
};

void TriangleTree::build(std::span<const Box> boxes, std::span<const std::int32_t> ids,
                         const std::function<void()>& poll) {
  Box bounds;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  bounds.lower.fill(kInfinity);
  bounds.upper.fill(-kInfinity);
  for (const Box& box : boxes) {
    for (int k = 0; k < 3; ++k) {
      bounds.lower[k] = std::min(bounds.lower[k], box.lower[k]);
      bounds.upper[k] = std::max(bounds.upper[k], box.upper[k]);
    }
  }
  build(
      bounds, ids, [boxes](std::size_t i) -> const Box& { return boxes[i]; }, poll);
}

void TriangleTree::setFrame(const Box& bounds) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  double half = 0;
  for (int k = 0; k < 3; ++k) {
    const double lower = std::clamp(bounds.lower[k], -kLargest, kLargest) * 0.5;
    const double upper = std::clamp(bounds.upper[k], -kLargest, kLargest) * 0.5;
    origin_[k] = lower + upper;
    half = std::max(half, upper - lower);
  }
  // Differences are at most a rounding above half < 2^exponent. The scale must not become infinite.
  int exponent = 0;
  std::frexp(half, &exponent);
  scale_ = std::ldexp(1.0, -std::max(exponent, -1000));
}

void TriangleTree::grow(std::span<TreeItem> items, const std::function<void()>& poll) {
  nodes_.clear();
  TriangleTreeBuilder(poll, nodes_).build(items);
}

}  // namespace footfall
