// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/triangle_tree.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace footfall {
namespace {

constexpr std::size_t kWidth = 4;       // children of a node
constexpr std::size_t kSmallSize = 16;  // split by count, to fill the nodes; larger ones by area
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
/// "On fast construction of SAH-based bounding volume hierarchies"). One for each thread: it holds working memory.
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
    parts[0] = whole;
    std::size_t count = 1;
    while (count < kWidth) {
      std::size_t next = kWidth;
      for (std::size_t i = 0; i < count; ++i)
        if (parts[i].items.size() > kWidth && (next == kWidth || parts[i].box.halfArea() > parts[next].box.halfArea()))
          next = i;
      if (next == kWidth) break;
      const std::span<TreeItem> items = parts[next].items;
      const std::size_t middle = split(parts[next], depth);
      if (items.size() > kPolledSize) poll_();
      parts[next] = Part(items.first(middle));
      parts[count++] = Part(items.subspan(middle));
    }
    return count;
  }

 private:
  static constexpr std::size_t kPolledSize = 16384;
  static constexpr std::size_t kScratchSize = 8192;

  /// How many of the items come first; they are moved there.
  std::size_t split(const Part& part, int depth) {
    const int axis = widestAxis(part.centres);
    const std::size_t count = part.items.size();
    if (count > kSmallSize && depth < kAreaDepth) {
      const float least = part.centres.lower[axis];
      const float perBin = kBins / (part.centres.upper[axis] - least);
      if (std::isfinite(perBin)) return splitByArea(part.items, axis, least, perBin);
    }
    const std::size_t middle = count > kSmallSize ? count / 2 : (count / 2 + kWidth - 1) / kWidth * kWidth;
    std::nth_element(part.items.begin(), part.items.begin() + static_cast<std::ptrdiff_t>(middle), part.items.end(),
                     [axis](const TreeItem& a, const TreeItem& b) { return centreOf(a, axis) < centreOf(b, axis); });
    return middle;
  }

  std::size_t splitByArea(std::span<TreeItem> items, int axis, float least, float perBin) {
    const auto binOf = [=](const TreeItem& item) {
      return std::min(static_cast<int>((centreOf(item, axis) - least) * perBin), kBins - 1);
    };
    // Neighbours tend to fall into one bin: with two sets of them they need not wait for each other.
    std::array<std::array<Bounds, kBins>, 2> boxes;
    std::array<std::array<std::size_t, kBins>, 2> counts{};
    for (std::size_t i = 0; i < items.size(); ++i) {
      const int bin = binOf(items[i]);
      boxes[i & 1][bin].include(lowerOf(items[i]), upperOf(items[i]));
      ++counts[i & 1][bin];
    }
    if (items.size() > kPolledSize) poll_();
    for (int bin = 0; bin < kBins; ++bin) {
      boxes[0][bin].include(boxes[1][bin]);
      counts[0][bin] += counts[1][bin];
    }
    const int second = cheapestSplit(boxes[0], counts[0]);
    return moveForward(items, [=](const TreeItem& item) { return binOf(item) < second; });
  }

  /// The bin with which the second part begins.
  static int cheapestSplit(const std::array<Bounds, kBins>& boxes, const std::array<std::size_t, kBins>& counts) {
    std::array<float, kBins> costs{};  // of what lies at and after the bin
    Bounds after;
    std::size_t count = 0;
    for (int bin = kBins - 1; bin > 0; --bin) {
      after.include(boxes[bin]);
      count += counts[bin];
      costs[bin] = after.halfArea() * static_cast<float>(count);
    }
    // The first and the last bin are never empty, so neither side is.
    Bounds before;
    count = 0;
    int best = 1;
    float lowest = std::numeric_limits<float>::infinity();
    for (int bin = 1; bin < kBins; ++bin) {
      before.include(boxes[bin - 1]);
      count += counts[bin - 1];
      const float cost = before.halfArea() * static_cast<float>(count) + costs[bin];
      if (cost < lowest) {
        lowest = cost;
        best = bin;
      }
    }
    return best;
  }

  /// Moves the items that are `first` before the others; how many they are.
  template <class IsFirst>
  std::size_t moveForward(std::span<TreeItem> items, const IsFirst& isFirst) {
    if (items.size() > kScratchSize)
      return static_cast<std::size_t>(std::partition(items.begin(), items.end(), isFirst) - items.begin());
    // Without branches, which could not be predicted: each item is written to both sides, and one of them keeps it.
    if (!scratch_) scratch_ = std::make_unique_for_overwrite<TreeItem[]>(kScratchSize);
    std::size_t first = 0, second = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const TreeItem item = items[i];
      const bool forward = isFirst(item);
      items[first] = item;
      scratch_[second] = item;
      first += static_cast<std::size_t>(forward);
      second += static_cast<std::size_t>(!forward);
    }
    std::copy_n(scratch_.get(), second, items.begin() + static_cast<std::ptrdiff_t>(first));
    return first;
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
    nodes_.resize(root.size);
    place(root, 0);
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

  /// Copies the nodes of a subtree to their places from `offset` on.
  void place(const Subtree& tree, std::size_t offset) const {
    if (!tree.below) {
      for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        Node node = tree.nodes[i];
        for (std::int32_t& child : node.children)
          if (child > 0) child += static_cast<std::int32_t>(offset);
        nodes_[offset + i] = node;
      }
      return;
    }
    std::array<std::size_t, kWidth> offsets{};
    std::size_t next = offset + 1;
    Node node = tree.nodes[0];
    for (std::size_t i = 0; i < kWidth; ++i) {
      offsets[i] = next;
      if ((*tree.below)[i].size > 0) node.children[i] = static_cast<std::int32_t>(next);
      next += (*tree.below)[i].size;
    }
    nodes_[offset] = node;
    tbb::parallel_for(std::size_t{0}, kWidth, [&](std::size_t i) { place((*tree.below)[i], offsets[i]); });
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
