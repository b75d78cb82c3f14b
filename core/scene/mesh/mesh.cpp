#include "core/scene/mesh/mesh.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "core/base/portable_math.h"
#include "core/scene/mesh/vector.h"

namespace fyd::scene {
namespace {

/// A triangle whose height is less than this share of its longest edge has no normal that means anything.
constexpr double kFlattest = 1e-12;

/// Stands for a neighbour across an edge of more than two triangles until the mesh is built: no rim, and no way across.
constexpr std::uint32_t kShared = kNoTriangle - 1;

bool before(const Vec3& a, const Vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

struct HalfEdge {
  std::uint32_t low, high;  // vertices
  std::uint32_t triangle;
  std::uint8_t side;  // 0: edge 01, 1: 12, 2: 20
  bool up;            // from low to high
};

std::vector<HalfEdge> halfEdges(std::span<const Triangle> triangles) {
  std::vector<HalfEdge> out;
  out.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint8_t side = 0; side < 3; ++side) {
      const std::uint32_t from = triangles[t][side], to = triangles[t][(side + 1) % 3];
      out.push_back({std::min(from, to), std::max(from, to), t, side, from < to});
    }
  }
  std::sort(out.begin(), out.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return out;
}

template <class Each>
void forEachEdge(const std::vector<HalfEdge>& edges, Each each) {
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i + 1;
    while (j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high) ++j;
    each(std::span(edges).subspan(i, j - i));
    i = j;
  }
}

/// Equal places become one vertex. @return how many were merged
std::size_t mergeVertices(TriangleSoup& soup) {
  std::vector<std::uint32_t> order(soup.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return before(soup.vertices[a], soup.vertices[b]) || (!before(soup.vertices[b], soup.vertices[a]) && a < b);
  });
  std::vector<std::uint32_t> first(soup.vertices.size());
  std::size_t merged = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && soup.vertices[order[i]] == soup.vertices[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
    merged += same ? 1 : 0;
  }
  for (Triangle& triangle : soup.triangles) {
    for (std::uint32_t& vertex : triangle) vertex = first[vertex];
  }
  return merged;
}

bool degenerate(const TriangleSoup& soup, const Triangle& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  const Vec3 a = soup.vertices[t[1]] - soup.vertices[t[0]], b = soup.vertices[t[2]] - soup.vertices[t[0]];
  const double longest = std::max({squared(a), squared(b), squared(b - a)});
  return !(length(cross(a, b)) > kFlattest * longest);
}

std::size_t dropDuplicates(std::vector<Triangle>& triangles) {
  const auto key = [&](std::uint32_t t) {
    Triangle sorted = triangles[t];
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<bool> drop(triangles.size());
  for (std::size_t i = 1; i < order.size(); ++i) drop[order[i]] = key(order[i]) == key(order[i - 1]);
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!drop[t]) triangles[kept++] = triangles[t];
  }
  const std::size_t dropped = triangles.size() - kept;
  triangles.resize(kept);
  return dropped;
}

/// The lowest 21 bits of a number with two zeros between each two (Morton code).
std::uint64_t spreadBits(std::uint64_t bits) {
  bits &= 0x1fffff;
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

/// Sorts triangles along Morton's curve and vertices in the order of their triangles: neighbours in space become
/// neighbours in memory, which spares cache misses. Vertices that no triangle has are removed.
void sortInSpace(TriangleSoup& soup) {
  const std::vector<Vec3>& v = soup.vertices;
  const auto middle = [&](const Triangle& t) { return v[t[0]] + v[t[1]] + v[t[2]]; };
  Vec3 low = middle(soup.triangles.front()), high = low;
  for (const Triangle& t : soup.triangles) {
    const Vec3 m = middle(t);
    low = {std::min(low.x, m.x), std::min(low.y, m.y), std::min(low.z, m.z)};
    high = {std::max(high.x, m.x), std::max(high.y, m.y), std::max(high.z, m.z)};
  }
  const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const double cells = size > 0.0 ? 0x1fffff / size : 0.0;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  order.reserve(soup.triangles.size());
  for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
    const Vec3 m = cells * (middle(soup.triangles[t]) - low);
    const auto cell = [](double at) { return spreadBits(static_cast<std::uint64_t>(at)); };
    order.emplace_back(cell(m.x) | cell(m.y) << 1 | cell(m.z) << 2, t);
  }
  std::sort(order.begin(), order.end());
  TriangleSoup sorted;
  sorted.triangles.reserve(order.size());
  std::vector<std::uint32_t> place(v.size(), kNoTriangle);
  for (const auto& [key, t] : order) {
    Triangle triangle = soup.triangles[t];
    for (std::uint32_t& vertex : triangle) {
      if (place[vertex] == kNoTriangle) {
        place[vertex] = static_cast<std::uint32_t>(sorted.vertices.size());
        sorted.vertices.push_back(v[vertex]);
      }
      vertex = place[vertex];
    }
    sorted.triangles.push_back(triangle);
  }
  sorted.vertices.shrink_to_fit();
  soup = std::move(sorted);
}

}  // namespace

Result<Mesh> Mesh::build(TriangleSoup soup) {
  if (soup.triangles.size() > kMostTriangles) {
    return fail("{} triangles; at most {} can be touched", soup.triangles.size(), kMostTriangles);
  }
  Mesh mesh;
  MeshReport& report = mesh.report_;
  const auto isPlace = [](const Vec3& v) {  // false for NaN
    return std::abs(v.x) < kFarthest_mm && std::abs(v.y) < kFarthest_mm && std::abs(v.z) < kFarthest_mm;
  };
  for (const Vec3& vertex : soup.vertices) report.not_finite += isPlace(vertex) ? 0 : 1;
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    return std::ranges::any_of(
        t, [&](std::uint32_t v) { return v >= soup.vertices.size() || !isPlace(soup.vertices[v]); });
  });
  report.duplicate_vertices = mergeVertices(soup);
  report.degenerate_triangles = std::erase_if(soup.triangles, [&](const Triangle& t) { return degenerate(soup, t); });
  report.duplicate_triangles = dropDuplicates(soup.triangles);
  if (soup.triangles.empty()) return fail("the mesh has no triangle that has an area");
  const auto sort = [&mesh, &soup] {
    sortInSpace(soup);
    mesh.vertices_ = std::move(soup.vertices);
    mesh.triangles_ = std::move(soup.triangles);
    mesh.findNeighbours();
  };
  sort();
  if (mesh.orientConsistently(); report.flipped_triangles > 0) {
    // The sort numbers vertices in the order in which triangles name them, so it belongs after the last turn: a mesh
    // built again from its own vertices and triangles, as replay does, must be the same to the bit.
    soup = {.vertices = std::move(mesh.vertices_), .triangles = std::move(mesh.triangles_)};
    sort();
    mesh.orientConsistently();
  }
  for (auto& across : mesh.neighbours_) std::ranges::replace(across, kShared, kNoTriangle);
  mesh.measure();
  return mesh;
}

void Mesh::findNeighbours() {
  neighbours_.assign(triangles_.size(), {kNoTriangle, kNoTriangle, kNoTriangle});
  report_.non_manifold_edges = report_.rim_edges = 0;
  forEachEdge(halfEdges(triangles_), [this](std::span<const HalfEdge> edge) {
    if (edge.size() > 2) {
      ++report_.non_manifold_edges;
      for (const HalfEdge& half : edge) neighbours_[half.triangle][half.side] = kShared;
    }
    if (edge.size() == 1) ++report_.rim_edges;
    if (edge.size() != 2) return;
    neighbours_[edge[0].triangle][edge[0].side] = edge[1].triangle;
    neighbours_[edge[1].triangle][edge[1].side] = edge[0].triangle;
  });
}

void Mesh::orientConsistently() {
  const auto goesFrom = [this](std::uint32_t t, std::uint32_t from, std::uint32_t to) {
    const Triangle& v = triangles_[t];
    return (v[0] == from && v[1] == to) || (v[1] == from && v[2] == to) || (v[2] == from && v[0] == to);
  };
  report_.pieces = report_.inside_out = report_.holes = 0;
  report_.volume_mm3 = 0.0;
  std::vector<std::int8_t> turn(triangles_.size(), 0);  // 1: as the first of its piece, −1: against it
  std::vector<std::uint32_t> piece;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> against_it;  // neighbours of different orientation
  std::size_t rim_edges = 0;
  for (std::uint32_t first = 0; first < triangles_.size(); ++first) {
    if (turn[first] != 0) continue;
    piece.clear();
    against_it.assign(1, {first, first});
    std::size_t against = 0, rims = 0;
    // Edges between triangles of the same orientation go first, so that in a piece that has no consistent orientation
    // (a Möbius strip) as few as possible are turned, and none the next time.
    for (std::size_t i = 0, k = 0; k < against_it.size(); ++k) {
      const auto [from, to] = against_it[k];
      if (turn[to] != 0) continue;
      turn[to] = static_cast<std::int8_t>(to == first ? 1 : -turn[from]);
      piece.push_back(to);
      for (; i < piece.size(); ++i) {
        const std::uint32_t t = piece[i];
        against += turn[t] < 0 ? 1 : 0;
        for (std::size_t side = 0; side < 3; ++side) {
          const std::uint32_t other = neighbours_[t][side];
          if (other == kNoTriangle) ++rims;
          if (other == kNoTriangle || other == kShared || turn[other] != 0) continue;
          // Two triangles of the same orientation go along their common edge in opposite directions.
          if (goesFrom(other, triangles_[t][side], triangles_[t][(side + 1) % 3])) {
            against_it.emplace_back(t, other);
          } else {
            turn[other] = turn[t];
            piece.push_back(other);
          }
        }
      }
    }
    const std::int8_t wrong = 2 * against > piece.size() ? 1 : -1;
    double volume_mm3 = 0.0;
    for (const std::uint32_t t : piece) {
      if (turn[t] == wrong) {
        std::swap(triangles_[t][1], triangles_[t][2]);
        std::swap(neighbours_[t][0], neighbours_[t][2]);
        ++report_.flipped_triangles;
      }
      const Triangle& v = triangles_[t];
      volume_mm3 += dot(vertices_[v[0]], cross(vertices_[v[1]], vertices_[v[2]])) / 6.0;
    }
    ++report_.pieces;
    rim_edges += rims;
    if (rims == 0 && closes(piece)) {
      report_.volume_mm3 += volume_mm3;
      report_.inside_out += volume_mm3 < 0.0 ? 1 : 0;
    }
  }
  if (rim_edges == 0) return;
  // Loops of the rim, by union-find: every rim edge joins its two vertices.
  std::vector<std::uint32_t> root(vertices_.size());
  std::iota(root.begin(), root.end(), 0U);
  const auto rootOf = [&root](std::uint32_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  std::vector<bool> at_rim(vertices_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    for (std::size_t side = 0; side < 3; ++side) {
      if (neighbours_[t][side] != kNoTriangle) continue;
      const std::uint32_t a = triangles_[t][side], b = triangles_[t][(side + 1) % 3];
      at_rim[a] = at_rim[b] = true;
      root[rootOf(a)] = rootOf(b);
    }
  }
  for (std::uint32_t v = 0; v < root.size(); ++v) report_.holes += at_rim[v] && rootOf(v) == v ? 1 : 0;
}

/// Whether a piece without a rim is closed: at edges of more than two triangles it meets itself, as often in one
/// direction as in the other. A wall within a body has such edges only, and encloses nothing.
bool Mesh::closes(std::span<const std::uint32_t> piece) const {
  if (report_.non_manifold_edges == 0) return true;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> surplus;  // of one direction
  for (const std::uint32_t t : piece) {
    for (std::size_t side = 0; side < 3; ++side) {
      if (neighbours_[t][side] != kShared) continue;
      const std::uint32_t from = triangles_[t][side], to = triangles_[t][(side + 1) % 3];
      surplus[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  }
  return std::ranges::all_of(surplus, [](const auto& edge) { return edge.second == 0; });
}

void Mesh::measure() {
  report_.vertices = vertices_.size();
  report_.triangles = triangles_.size();
  vertex_normals_.assign(vertices_.size(), {});
  report_.shortest_edge_mm = std::numeric_limits<double>::infinity();
  double edges_mm = 0.0;
  for (const Triangle& t : triangles_) {
    const std::array<Vec3, 3> p = {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
    const Vec3 across = cross(p[1] - p[0], p[2] - p[0]);
    report_.area_mm2 += 0.5 * length(across);
    const Vec3 normal = unit(across);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
      const double edge_mm = length(a);
      edges_mm += edge_mm;
      report_.shortest_edge_mm = std::min(report_.shortest_edge_mm, edge_mm);
      report_.longest_edge_mm = std::max(report_.longest_edge_mm, edge_mm);
      const double angle = math::atan2(length(cross(a, b)), dot(a, b));
      vertex_normals_[t[i]] = vertex_normals_[t[i]] + angle * normal;
    }
  }
  report_.mean_edge_mm = edges_mm / (3.0 * static_cast<double>(triangles_.size()));
  for (Vec3& normal : vertex_normals_) normal = unit(normal);
  report_.lowest_mm = report_.highest_mm = vertices_.front();
  for (const Vec3& v : vertices_) {
    report_.lowest_mm = {std::min(report_.lowest_mm.x, v.x), std::min(report_.lowest_mm.y, v.y),
                         std::min(report_.lowest_mm.z, v.z)};
    report_.highest_mm = {std::max(report_.highest_mm.x, v.x), std::max(report_.highest_mm.y, v.y),
                          std::max(report_.highest_mm.z, v.z)};
  }
}

Vec3 Mesh::triangleNormal(std::uint32_t triangle) const {
  const Triangle& t = triangles_[triangle];
  return unit(cross(vertices_[t[1]] - vertices_[t[0]], vertices_[t[2]] - vertices_[t[0]]));
}

Vec3 Mesh::normalOf(std::uint32_t triangle, Feature feature) const {
  const auto which = static_cast<std::size_t>(feature);
  if (which < 3) return vertex_normals_[triangles_[triangle][which]];
  const Vec3 own = triangleNormal(triangle);
  if (feature == Feature::inside) return own;
  const std::uint32_t other = neighbours_[triangle][which - 3];
  return other == kNoTriangle ? own : unit(own + triangleNormal(other));
}

std::size_t Mesh::bytes() const {
  return vertices_.size() * (sizeof(Vec3) * 2) + triangles_.size() * (sizeof(Triangle) + sizeof(neighbours_[0]));
}

}  // namespace fyd::scene
