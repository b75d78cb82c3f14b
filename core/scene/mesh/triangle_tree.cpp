#include "core/scene/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/scene/mesh/four_floats.h"

namespace fyd::scene {
namespace {

constexpr float kFar = std::numeric_limits<float>::max();
constexpr int kDeepestLevel = 40;       // levels; below, ranges are halved, which bounds the depth and the open list
constexpr double kTreeRounding = 1e-6;  // of a distance and of the mesh's size: more than floats lose
constexpr float kTreeRoundingOfSquares = 1e-6F;  // of a squared distance: more than cancellation loses
constexpr int kBins = 16;

/// Lower bounds of the squared distances of four discs from a point.
template <class Node>
Floats squaredDistances(const Node& node, const std::array<float, 3>& point) {
  const Floats x = point[0] - load(node.middle[0]), y = point[1] - load(node.middle[1]),
               z = point[2] - load(node.middle[2]);
  const Floats across = x * load(node.normal[0]) + y * load(node.normal[1]) + z * load(node.normal[2]);
  const Floats all = x * x + y * y + z * z;
  const Floats along = root(larger(all - across * across, Floats{})) - load(node.radius);
  const Floats above = larger(across, -across) - load(node.height);
  const Floats out = larger(along, Floats{}), up = larger(above, Floats{});
  return larger(out * out + up * up - kTreeRoundingOfSquares * all, Floats{});
}

}  // namespace

struct TriangleTree::Box {
  std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  void hold(const Box& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
  [[nodiscard]] double surface() const {
    const double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x * y + y * z + z * x;
  }
  [[nodiscard]] double middle(std::size_t axis) const { return 0.5 * (low[axis] + high[axis]); }
};

/// Binned surface-area splits, two levels at a time.
struct TriangleTree::Builder {
  const Mesh& mesh;
  Vec3 middle;
  double grow;
  std::vector<Node>& nodes;
  std::vector<Box> boxes;
  std::vector<std::uint32_t> order;

  struct Range {
    std::size_t from, to;
    [[nodiscard]] std::size_t size() const { return to - from; }
  };

  /// Into a place of a node: the disc that holds a range, across its mean normal.
  void place(Range range, Node& node, std::size_t at) const {
    const auto corners = [&](auto each) {
      for (std::size_t i = range.from; i < range.to; ++i) {
        for (const std::uint32_t corner : mesh.triangles()[order[i]]) each(mesh.vertices()[corner] - middle);
      }
    };
    Vec3 normal;
    for (std::size_t i = range.from; i < range.to; ++i) {
      const Triangle& t = mesh.triangles()[order[i]];
      const auto v = mesh.vertices();
      normal = normal + cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]);
    }
    normal = unit(normal);
    if (squared(normal) == 0.0) normal = {0.0, 0.0, 1.0};
    Box box;
    double low = 1e300, high = -1e300;
    corners([&](const Vec3& c) {
      box.hold({{c.x, c.y, c.z}, {c.x, c.y, c.z}});
      low = std::min(low, dot(c, normal));
      high = std::max(high, dot(c, normal));
    });
    Vec3 centre = {box.middle(0), box.middle(1), box.middle(2)};
    centre = centre + (0.5 * (low + high) - dot(centre, normal)) * normal;
    // The radius and height below are measured from these rounded values.
    const std::array<float, 3> c = {static_cast<float>(centre.x), static_cast<float>(centre.y),
                                    static_cast<float>(centre.z)};
    const std::array<float, 3> n = {static_cast<float>(normal.x), static_cast<float>(normal.y),
                                    static_cast<float>(normal.z)};
    double radius = 0.0, height = 0.0;
    corners([&](const Vec3& corner) {
      const Vec3 way = corner - Vec3{c[0], c[1], c[2]};
      const double up = dot(way, Vec3{n[0], n[1], n[2]});
      radius = std::max(radius, std::sqrt(std::max(0.0, squared(way) - up * up)));
      height = std::max(height, std::abs(up));
    });
    for (std::size_t k = 0; k < 3; ++k) {
      node.middle[k][at] = c[k];
      node.normal[k][at] = n[k];
    }
    node.radius[at] = static_cast<float>(radius * (1.0 + 1e-6) + grow);
    node.height[at] = static_cast<float>(height * (1.0 + 1e-6) + grow);
  }

  std::size_t halve(Range range, std::size_t axis) {
    const std::size_t at = range.from + range.size() / 2;
    const auto place = [this](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(place(range.from), place(at), place(range.to),
                     [&](std::uint32_t a, std::uint32_t b) { return boxes[a].middle(axis) < boxes[b].middle(axis); });
    return at;
  }

  /// Where to part a range of two and more; never leaves a side empty.
  std::size_t split(Range range, int depth) {
    Box middles;
    for (std::size_t i = range.from; i < range.to; ++i) {
      const Box& b = boxes[order[i]];
      const std::array<double, 3> m = {b.middle(0), b.middle(1), b.middle(2)};
      middles.hold({m, m});
    }
    if (depth > kDeepestLevel) return halve(range, 0);
    double best_cost = 1e300, best_at = 0.0;
    std::size_t best_axis = 3;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double width = middles.high[axis] - middles.low[axis];
      if (!(width > 0.0)) continue;
      std::array<Box, kBins> bin{};
      std::array<std::size_t, kBins> count{};
      for (std::size_t i = range.from; i < range.to; ++i) {
        const double share = (boxes[order[i]].middle(axis) - middles.low[axis]) / width;
        const auto b = static_cast<std::size_t>(std::min(kBins - 1, static_cast<int>(share * kBins)));
        bin[b].hold(boxes[order[i]]);
        ++count[b];
      }
      std::array<double, kBins> right{};
      Box sum;
      std::size_t n = 0;
      for (std::size_t b = kBins - 1; b > 0; --b) {
        if (count[b] > 0) sum.hold(bin[b]);
        n += count[b];
        right[b] = n == 0 ? 0.0 : static_cast<double>(n) * sum.surface();
      }
      sum = {};
      n = 0;
      for (std::size_t b = 0; b + 1 < kBins; ++b) {
        if (count[b] > 0) sum.hold(bin[b]);
        n += count[b];
        if (n == 0 || n == range.size()) continue;
        const double cost = static_cast<double>(n) * sum.surface() + right[b + 1];
        if (cost < best_cost) {
          best_cost = cost;
          best_axis = axis;
          best_at = middles.low[axis] + width * static_cast<double>(b + 1) / kBins;
        }
      }
    }
    const auto begin = order.begin() + static_cast<std::ptrdiff_t>(range.from);
    const auto end = order.begin() + static_cast<std::ptrdiff_t>(range.to);
    if (best_axis < 3) {
      const auto at = std::partition(begin, end, [&](std::uint32_t t) { return boxes[t].middle(best_axis) < best_at; });
      if (at != begin && at != end) return static_cast<std::size_t>(at - order.begin());
    }
    return halve(range, 0);  // all in one place
  }

  void build() {
    struct Task {
      Range range;
      std::size_t node;
      int depth;
    };
    nodes.emplace_back();
    std::vector<Task> open{{{0, order.size()}, 0, 0}};
    while (!open.empty()) {
      const Task now = open.back();
      open.pop_back();
      std::array<Range, 4> part{now.range};
      std::size_t parts = 1;
      while (parts < 4) {  // the largest part is split
        std::size_t largest = 0;
        for (std::size_t i = 1; i < parts; ++i) largest = part[i].size() > part[largest].size() ? i : largest;
        if (part[largest].size() < 2) break;
        const std::size_t at = split(part[largest], now.depth);
        part[parts++] = {at, part[largest].to};
        part[largest].to = at;
      }
      Node node{};
      for (std::size_t i = 0; i < 4; ++i) {
        if (i >= parts) {
          node.child[i] = kNothing;
          continue;
        }
        place(part[i], node, i);
        if (part[i].size() == 1) {
          node.child[i] = ~static_cast<std::int32_t>(order[part[i].from]);
        } else {
          node.child[i] = static_cast<std::int32_t>(nodes.size());
          nodes.emplace_back();
          open.push_back({part[i], nodes.size() - 1, now.depth + 1});
        }
      }
      nodes[now.node] = node;
    }
  }
};

TriangleTree::TriangleTree(const Mesh& mesh) : mesh_(&mesh) {
  const MeshReport& r = mesh.report();
  middle_mm_ = 0.5 * (r.lowest_mm + r.highest_mm);
  const Vec3 half = 0.5 * (r.highest_mm - r.lowest_mm);
  size_mm_ = std::max({half.x, half.y, half.z});
  Builder builder{mesh, middle_mm_, 1e-7 * size_mm_, nodes_, {}, {}};
  for (const Triangle& t : mesh.triangles()) {
    Box box;
    for (const std::uint32_t v : t) {
      const Vec3& p = mesh.vertices()[v];
      box.hold({{p.x, p.y, p.z}, {p.x, p.y, p.z}});
    }
    builder.boxes.push_back(box);
  }
  builder.order.resize(builder.boxes.size());
  std::iota(builder.order.begin(), builder.order.end(), 0U);
  nodes_.reserve(builder.boxes.size() / 2 + 1);
  builder.build();
  nodes_.shrink_to_fit();
}

struct TriangleTree::Search {
  Vec3 probe_mm;
  std::array<float, 3> point{};  // the probe from the mesh's middle
  double size_mm = 0.0;
  Nearest best;
  float squared_bound = kFar;  // nothing beyond can be the nearest

  void take(const Nearest& candidate) {
    if (!nearer(candidate, best)) return;
    const bool closer = candidate.squared_mm2 < best.squared_mm2;
    best = candidate;
    if (!closer) return;
    const double distance_mm = std::sqrt(best.squared_mm2);
    // A disc at a larger float distance cannot hold a nearer triangle.
    const auto bound = static_cast<float>(distance_mm * (1.0 + kTreeRounding) + kTreeRounding * size_mm);
    squared_bound = std::min(kFar, bound * bound);
  }
};

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): of `place` only the first `count` are read
struct TriangleTree::OpenList {
  struct Place {
    float squared;
    std::int32_t child;
  };
  std::array<Place, 256> place;  // three are added for a level, and there are no more than kDeepestLevel + 13
  std::size_t count = 0;
};

bool TriangleTree::begin(const Vec3& probe_mm, std::uint32_t hint, Search& search) const {
  const Vec3 from_middle = probe_mm - middle_mm_;
  if (!(length(from_middle) < kFarthest_mm)) return false;
  search.probe_mm = probe_mm;
  search.point = {static_cast<float>(from_middle.x), static_cast<float>(from_middle.y),
                  static_cast<float>(from_middle.z)};
  search.size_mm = size_mm_;
  if (hint < mesh_->triangles().size()) search.take(nearestOnTriangle(*mesh_, probe_mm, hint));
  return true;
}

void TriangleTree::pushNearChildren(Search& search, std::int32_t from, OpenList& open) const {
  const Node& node = nodes_[static_cast<std::size_t>(from)];
  const Floats squared = squaredDistances(node, search.point);
  for (std::size_t i = 0; i < 4; ++i) {
    open.place[open.count] = {squared[i], node.child[i]};
    open.count += squared[i] <= search.squared_bound && node.child[i] != kNothing ? 1 : 0;
  }
}

void TriangleTree::searchOpen(Search& search, OpenList& open) const {
  while (open.count > 0) {
    // The nearest of the last four entries first: its triangles may exclude the others.
    const std::size_t last = open.count - 1;
    std::size_t nearest = last;
    for (std::size_t i = last > 3 ? last - 3 : 0; i < last; ++i) {
      nearest = open.place[i].squared < open.place[nearest].squared ? i : nearest;
    }
    const auto [squared, child] = open.place[nearest];
    open.place[nearest] = open.place[last];
    open.count = last;
    if (!(squared <= search.squared_bound)) continue;
    if (child < 0) {
      search.take(nearestOnTriangle(*mesh_, search.probe_mm, static_cast<std::uint32_t>(~child)));
    } else {
      pushNearChildren(search, child, open);
    }
  }
}

Nearest TriangleTree::nearest(const Vec3& probe_mm, std::uint32_t hint) const {
  Search search;
  if (!begin(probe_mm, hint, search)) return {};
  OpenList open;
  pushNearChildren(search, 0, open);
  searchOpen(search, open);
  return search.best;
}

void TriangleTree::visitNear(const Vec3& from_mm, const Vec3& to_mm, double distance_mm,
                             void (*visit)(void*, std::uint32_t), void* with) const {
  const Vec3 a = from_mm - middle_mm_, b = to_mm - middle_mm_, half = 0.5 * (b - a);
  const double reach_mm = std::sqrt(half.x * half.x + half.y * half.y + half.z * half.z);
  const double far_mm = length(a) + length(b);
  if (!(far_mm + distance_mm < kFarthest_mm)) return;
  const double rounding_mm = 2.0 * kTreeRounding * (far_mm + size_mm_ + distance_mm);
  const auto floats = [](const Vec3& v) {
    return std::array<float, 3>{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  };
  const std::array<float, 3> middle = floats(a + half), ways = floats(half);
  const auto bound = static_cast<float>((distance_mm + reach_mm + rounding_mm) * (1.0 + kTreeRounding));
  const auto beside = static_cast<float>((distance_mm + rounding_mm) * (1.0 + kTreeRounding));
  const auto way_squared = static_cast<float>(squared(half));
  const float by_way = way_squared > 0.0F ? 1.0F / way_squared : 0.0F;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): as OpenList's
  std::array<std::int32_t, 256> open;
  std::size_t count = 0;
  open[count++] = 0;
  while (count > 0) {
    const std::int32_t child = open[--count];
    if (child < 0) {
      visit(with, static_cast<std::uint32_t>(~child));
      continue;
    }
    const Node& node = nodes_[static_cast<std::size_t>(child)];
    const Floats discs = squaredDistances(node, middle);
    // Distances of the discs' bounding spheres from the segment.
    const Floats x = load(node.middle[0]) - middle[0], y = load(node.middle[1]) - middle[1],
                 z = load(node.middle[2]) - middle[2];
    Floats along = (x * ways[0] + y * ways[1] + z * ways[2]) * by_way;
    along = larger(along, Floats{} - 1.0F);
    along = -larger(-along, Floats{} - 1.0F);
    const Floats dx = x - along * ways[0], dy = y - along * ways[1], dz = z - along * ways[2];
    const Floats radius = load(node.radius), height = load(node.height);
    const Floats sphere = root(radius * radius + height * height) + beside;
    const Floats from_way = dx * dx + dy * dy + dz * dz;
    for (std::size_t i = 0; i < 4; ++i) {
      open[count] = node.child[i];
      count += node.child[i] != kNothing && discs[i] <= bound * bound && from_way[i] <= sphere[i] * sphere[i] ? 1 : 0;
    }
  }
}

}  // namespace fyd::scene
