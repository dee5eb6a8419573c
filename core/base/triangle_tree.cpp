// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/triangle_tree.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/parallel.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kWidth = 4;  // children of a node
// smaller nodes are split by count, which fills the nodes below; larger ones by area
constexpr std::size_t kSlabSize = 32;
constexpr int kBins = 16;
// Below this depth every node is split by count, so that no input makes the tree, and the recursion, deep.
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

/// The centre times 2.
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

// Many items are processed in blocks of this size, by all threads.
constexpr std::size_t kBlockSize = 8192;

std::size_t blocksOf(std::size_t count) { return (count + kBlockSize - 1) / kBlockSize; }

/// Calls work(block, items) for each block of the items.
template <class Work>
void forBlocks(std::span<TreeItem> items, Poll poll, const Work& work) {
  forRanges(blocksOf(items.size()), 1, [&](std::size_t block, std::size_t) {
    poll();
    const std::size_t first = block * kBlockSize;
    work(block, items.subspan(first, std::min(kBlockSize, items.size() - first)));
  });
}

Part partOf(std::span<TreeItem> items, Poll poll) {
  if (items.size() <= kBlockSize) return Part(items);
  std::vector<Part> parts(blocksOf(items.size()));
  forBlocks(items, poll, [&](std::size_t block, std::span<TreeItem> some) { parts[block] = Part(some); });
  Part whole;
  whole.items = items;
  for (const Part& part : parts) {
    whole.box.include(part.box);
    whole.centres.include(part.centres);
  }
  return whole;
}

/// Divides the items of a node among its children by the surface-area heuristic over bins of the centres (Wald 2007,
/// "On fast construction of SAH-based bounding volume hierarchies"). One pass over the items serves all four children.
/// Each thread has its own divider, because a divider holds working memory.
class ItemDivider {
 public:
  explicit ItemDivider(Poll poll) : poll_(poll) {}

  /// Makes up to four parts, none of which is empty.
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

  struct Slabs {
    std::array<std::uint8_t, kBins> ofBin{};
    std::array<std::size_t, kWidth> sizes{};  ///< in items
  };

  /// Cuts along one axis at up to three borders of bins, into two to four slabs. Makes no slabs where the centres
  /// hardly differ.
  std::size_t divideIntoSlabs(const Part& whole, std::array<Part, kWidth>& parts) {
    const int axis = widestAxis(whole.centres);
    const float least = whole.centres.lower[axis];
    const float perBin = kBins / (whole.centres.upper[axis] - least);
    if (!std::isfinite(perBin)) return 0;
    const auto binOf = [=](const TreeItem& item) {
      return std::min(static_cast<int>((centreOf(item, axis) - least) * perBin), kBins - 1);
    };
    const std::span<TreeItem> items = whole.items;
    const bool isLarge = items.size() > kBlockSize;
    std::vector<Bins> blocks;
    if (isLarge) {
      blocks.resize(blocksOf(items.size()));
      forBlocks(items, poll_,
                [&](std::size_t block, std::span<TreeItem> some) { blocks[block] = binsOf(some, binOf); });
    }
    const Bins bins = isLarge ? sumOf(blocks) : binsOf(items, binOf);

    const int middle = cheapestBorder(bins, 0, kBins);
    const std::array<int, kWidth + 1> borders{0, cheapestBorder(bins, 0, middle), middle,
                                              cheapestBorder(bins, middle, kBins), kBins};
    Slabs slabs;
    int slab = 0;
    for (int bin = 0; bin < kBins; ++bin) {
      while (bin >= borders[slab + 1]) ++slab;
      slabs.ofBin[bin] = static_cast<std::uint8_t>(slab);
      slabs.sizes[slab] += bins[bin].count;
    }
    if (isLarge)
      moveBlocksToSlabs(items, slabs, blocks, binOf);
    else
      moveToSlabs(items, slabs, binOf);
    std::size_t count = 0, first = 0;
    for (const std::size_t size : slabs.sizes) {
      if (size > 0) parts[count++] = partOf(items.subspan(first, size), poll_);
      first += size;
    }
    return count;
  }

  template <class BinOf>
  static Bins binsOf(std::span<const TreeItem> items, const BinOf& binOf) {
    // Neighbours tend to fall into one bin; two sets of bins let the processor add them without waiting.
    std::array<Bins, 2> bins;
    for (std::size_t i = 0; i < items.size(); ++i) {
      Bin& bin = bins[i & 1][binOf(items[i])];
      bin.box.include(lowerOf(items[i]), upperOf(items[i]));
      ++bin.count;
    }
    for (int bin = 0; bin < kBins; ++bin) bins[0][bin].include(bins[1][bin]);
    return bins[0];
  }

  static Bins sumOf(const std::vector<Bins>& blocks) {
    Bins sum;
    for (const Bins& bins : blocks)
      for (int bin = 0; bin < kBins; ++bin) sum[bin].include(bins[bin]);
    return sum;
  }

  /// The bin between `first` and `last` that begins the second half; `last` where either half would be empty.
  static int cheapestBorder(const Bins& bins, int first, int last) {
    std::array<float, kBins> costs{};  // cost of the items in this bin and the later ones
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

  /// Moves the items into the order of their slabs.
  template <class BinOf>
  void moveToSlabs(std::span<TreeItem> items, const Slabs& slabs, const BinOf& binOf) {
    if (!scratch_) scratch_ = std::make_unique_for_overwrite<TreeItem[]>(kBlockSize);
    const auto& sizes = slabs.sizes;
    std::array<std::size_t, kWidth> places{0, sizes[0], sizes[0] + sizes[1], sizes[0] + sizes[1] + sizes[2]};
    for (const TreeItem& item : items) scratch_[places[slabs.ofBin[binOf(item)]]++] = item;
    std::copy_n(scratch_.get(), items.size(), items.begin());
  }

  /// Moves the items on all threads, when the bins of each block are known.
  template <class BinOf>
  void moveBlocksToSlabs(std::span<TreeItem> items, const Slabs& slabs, const std::vector<Bins>& blocks,
                         const BinOf& binOf) const {
    std::vector<std::array<std::size_t, kWidth>> places(blocks.size());
    std::size_t place = 0;
    for (std::size_t slab = 0; slab < kWidth; ++slab)
      for (std::size_t block = 0; block < blocks.size(); ++block) {
        places[block][slab] = place;
        for (int bin = 0; bin < kBins; ++bin)
          if (slabs.ofBin[bin] == slab) place += blocks[block][bin].count;
      }
    const auto scratch = std::make_unique_for_overwrite<TreeItem[]>(items.size());
    forBlocks(items, poll_, [&](std::size_t block, std::span<TreeItem> some) {
      for (const TreeItem& item : some) scratch[places[block][slabs.ofBin[binOf(item)]]++] = item;
    });
    forBlocks(items, poll_, [&](std::size_t block, std::span<TreeItem> some) {
      std::copy_n(scratch.get() + block * kBlockSize, some.size(), some.begin());
    });
  }

  /// Moves the items that fill whole nodes to the front, and returns their number.
  static std::size_t split(const Part& part) {
    const int axis = widestAxis(part.centres);
    const std::size_t count = part.items.size();
    const std::size_t middle = (count / 2 + kWidth - 1) / kWidth * kWidth;
    std::nth_element(part.items.begin(), part.items.begin() + static_cast<std::ptrdiff_t>(middle), part.items.end(),
                     [axis](const TreeItem& a, const TreeItem& b) { return centreOf(a, axis) < centreOf(b, axis); });
    return middle;
  }

  Poll poll_;
  std::unique_ptr<TreeItem[]> scratch_;
};

}  // namespace

class TriangleTreeBuilder {
 public:
  using Node = TriangleTree::Node;

  TriangleTreeBuilder(Poll poll, UnfilledArray<Node>& nodes) : poll_(poll), nodes_(nodes) {}

  void build(std::span<TreeItem> items) {
    if (items.empty()) return;
    Subtree root;
    grow(root, partOf(items, poll_), 0);
    nodes_ = UnfilledArray<Node>(root.size);
    std::vector<Placed> subtrees;
    placeAll(root, 0, subtrees);
    forRanges(subtrees.size(), 1, [&](std::size_t i, std::size_t) { fill(subtrees[i]); });
  }

 private:
  /// Part of the tree that one thread made, or a node and the parts below it that other threads made.
  struct Subtree {
    std::vector<Node> nodes;  ///< children count from the first
    std::unique_ptr<std::array<Subtree, kWidth>> below;
    std::size_t size = 0;  ///< number of nodes, including those below
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
    parallelFor(count, [&](std::size_t i) {
      if (parts[i].items.size() > 1) grow((*tree.below)[i], parts[i], depth + 1);
    });
    tree.size = 1;
    for (const Subtree& below : *tree.below) tree.size += below.size;
  }

  struct Placed {
    Subtree* tree;
    std::size_t first;  ///< place of its nodes among all nodes
  };

  /// Lists each subtree's own nodes, then those of the parts below it.
  static void placeAll(Subtree& tree, std::size_t first, std::vector<Placed>& result) {
    result.push_back({&tree, first});
    if (!tree.below) return;
    std::size_t place = first + tree.nodes.size();
    for (std::size_t i = 0; i < kWidth; ++i) {
      Subtree& below = (*tree.below)[i];
      if (below.size == 0) continue;
      tree.nodes[0].children[i] = static_cast<std::int32_t>(place - first);
      placeAll(below, place, result);
      place += below.size;
    }
  }

  void fill(const Placed& placed) const {
    poll_();
    for (std::size_t i = 0; i < placed.tree->nodes.size(); ++i) {
      Node node = placed.tree->nodes[i];
      for (std::int32_t& child : node.children)
        if (child > 0) child += static_cast<std::int32_t>(placed.first);
      nodes_.fill(placed.first + i, node);
    }
    placed.tree->nodes = {};
  }

  Poll poll_;
  UnfilledArray<Node>& nodes_;
};

void TriangleTree::build(std::span<const Box> boxes, std::span<const std::int32_t> ids, Poll poll) {
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
  std::frexp(half, &exponent_);
  exponent_ = std::max(exponent_, -1000);
  scale_ = std::ldexp(1.0, -exponent_);
}

void TriangleTree::grow(std::span<TreeItem> items, Poll poll) {
  nodes_ = {};
  TriangleTreeBuilder(poll, nodes_).build(items);
}

}  // namespace footfall::detail
