#include "core/scene/contact/fitted_surface.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/portable_math.h"
#include "core/scene/mesh/vertex_fans.h"

namespace fyd::scene {
namespace {

constexpr std::size_t kMostNeighbours = 128;  // vertices in a fit: bounds the time at a vertex with very many triangles
constexpr double kLeastNormalCosine = 0.5;    // cosine: a fitted normal more inclined to the mean normal is rejected
constexpr double kMostCurvature = 1.0;  // curvature times the mean distance of the neighbours; a larger one is rejected

/// Solves the normal equations of n unknowns in place (Cholesky); column 9 is the right side, then the solution.
/// @return false if they have no solution
bool solve(std::array<std::array<double, 10>, 9>& m, std::size_t n) {
  for (std::size_t j = 0; j < n; ++j) {
    const double whole = m[j][j];
    for (std::size_t k = 0; k < j; ++k) m[j][j] -= m[j][k] * m[j][k];
    if (!(m[j][j] > 1e-10 * whole)) return false;
    m[j][j] = std::sqrt(m[j][j]);
    for (std::size_t i = j + 1; i < n; ++i) {
      for (std::size_t k = 0; k < j; ++k) m[i][j] -= m[i][k] * m[j][k];
      m[i][j] /= m[j][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) m[i][9] -= m[i][k] * m[k][9];
    m[i][9] /= m[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) m[i][9] -= m[k][i] * m[k][9];
    m[i][9] /= m[i][i];
  }
  return true;
}

struct Frame {
  Vec3 x, y, normal;
  explicit Frame(const Vec3& n) : normal(n) {
    const Vec3 away = std::abs(n.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    x = unit(cross(away, n));
    y = cross(n, x);
  }
};

/// z = a x + b y + (c x² + 2 d xy + e y²)/2 + terms of third order
struct Polynomial {
  double a, b, c, d, e;
};

/// @param size unit of length for scaling, mm
/// @param unknowns 9: third order; 5: second order
std::optional<Polynomial> fitPolynomial(const Vec3& middle, const std::vector<Vec3>& neighbours, const Frame& frame,
                                        double size, std::size_t unknowns) {
  if (neighbours.size() < unknowns + (unknowns == 9 ? 3 : 0)) return std::nullopt;
  std::array<std::array<double, 10>, 9> m{};
  for (const Vec3& p : neighbours) {
    const Vec3 from = (1.0 / size) * (p - middle);
    const double x = dot(from, frame.x), y = dot(from, frame.y), z = dot(from, frame.normal);
    const double weight = 1.0 / (x * x + y * y + 1e-3);
    const std::array<double, 9> term = {x,         y,         0.5 * x * x, x * y,    0.5 * y * y,
                                        x * x * x, x * x * y, x * y * y,   y * y * y};
    for (std::size_t i = 0; i < unknowns; ++i) {
      for (std::size_t k = 0; k <= i; ++k) m[i][k] += weight * term[i] * term[k];
      m[i][9] += weight * term[i] * z;
    }
  }
  if (!solve(m, unknowns)) return std::nullopt;
  return Polynomial{m[0][9], m[1][9], m[2][9] / size, m[3][9] / size, m[4][9] / size};
}

}  // namespace

struct FittedSurface::Fitter {
  FittedSurface& surface;
  const Mesh& mesh;
  std::vector<Vec3> normals;  // of the triangles
  VertexFans fans;
  std::vector<std::uint32_t> triangle_seen, vertex_seen;
  std::uint32_t stamp = 0;             // number of the present fit; marks what it has seen
  std::vector<std::uint32_t> reached;  // triangles of the present fit
  std::vector<Vec3> neighbours;        // vertices that are fitted

  explicit Fitter(FittedSurface& s, const Mesh& m) : surface(s), mesh(m), fans(m) {
    const auto triangles = mesh.triangles();
    normals.reserve(triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) normals.push_back(mesh.triangleNormal(t));
    triangle_seen.assign(triangles.size(), 0);
    vertex_seen.assign(mesh.vertices().size(), 0);
  }

  /// kNoTriangle at a rim and at a crease.
  [[nodiscard]] std::uint32_t acrossUncreased(std::uint32_t t, std::size_t side) const {
    return surface.edges_.creaseEdge(t, side) ? kNoTriangle : mesh.neighbours(t)[side];
  }

  void fitAll() {
    for (std::uint32_t v = 0; v < mesh.vertices().size(); ++v) {
      for (const std::uint32_t t : fans[v]) {
        const Triangle& corners = mesh.triangles()[t];
        const auto at = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
        if (surface.triangles_[t][at] == kNoTriangle) fitSide(v, t);
      }
    }
  }

  /// Fits a vertex on the side of its creases where the triangle `first` is.
  void fitSide(std::uint32_t vertex, std::uint32_t first) {
    const auto index = static_cast<std::uint32_t>(surface.corners_.size());
    const auto vertices = mesh.vertices();
    const auto triangles = mesh.triangles();
    const Vec3 middle = vertices[vertex];
    ++stamp;
    reached.assign(1, first);
    triangle_seen[first] = stamp;
    Vec3 mean;
    std::size_t side_end = 0;
    // First the triangles at the vertex, then those at their other vertices.
    const auto spread = [&](std::size_t most, auto&& wanted) {
      for (std::size_t i = 0; i < reached.size() && reached.size() < most; ++i) {
        for (std::size_t side = 0; side < 3; ++side) {
          const std::uint32_t other = acrossUncreased(reached[i], side);
          if (other == kNoTriangle || triangle_seen[other] == stamp || !wanted(triangles[other])) continue;
          triangle_seen[other] = stamp;
          reached.push_back(other);
        }
      }
    };
    neighbours.clear();
    spread(triangles.size() + 1, [&](const Triangle& t) { return std::find(t.begin(), t.end(), vertex) != t.end(); });
    side_end = reached.size();
    vertex_seen[vertex] = stamp;
    const auto collect = [&](std::size_t from) {
      const std::size_t every = 1 + (reached.size() - from) / (2 * kMostNeighbours);
      for (std::size_t i = from; i < reached.size(); i += every) {
        for (const std::uint32_t v : triangles[reached[i]]) {
          if (vertex_seen[v] == stamp || neighbours.size() >= kMostNeighbours) continue;
          vertex_seen[v] = stamp;
          neighbours.push_back(vertices[v]);
        }
      }
    };
    for (std::size_t i = 0; i < side_end; ++i) {
      const Triangle& t = triangles[reached[i]];
      const auto at = static_cast<std::size_t>(std::find(t.begin(), t.end(), vertex) - t.begin());
      surface.triangles_[reached[i]][at] = index;
      const Vec3 a = vertices[t[(at + 1) % 3]] - middle, b = vertices[t[(at + 2) % 3]] - middle;
      mean = mean + math::atan2(length(cross(a, b)), dot(a, b)) * normals[reached[i]];
    }
    collect(0);
    const std::size_t first_ring = neighbours.size();
    const std::uint32_t ring = stamp;
    spread(side_end + 2 * kMostNeighbours, [&](const Triangle& t) {
      return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return vertex_seen[v] == ring; });
    });
    collect(side_end);
    mean = unit(mean);
    if (squared(mean) == 0.0) mean = normals[first];
    surface.corners_.push_back(fit(middle, mean, first_ring));
  }

  Corner fit(const Vec3& middle, const Vec3& mean, std::size_t first_ring) {
    Corner corner{middle, mean, {}};
    double size = 0.0;
    for (std::size_t i = 0; i < first_ring; ++i) size += length(neighbours[i] - middle);
    size /= static_cast<double>(first_ring);
    std::size_t order = 0;
    for (const std::size_t unknowns : {std::size_t{9}, std::size_t{5}}) {
      Frame frame(mean);
      std::optional<Polynomial> polynomial;
      for (int pass = 0; pass < 2; ++pass) {
        polynomial = fitPolynomial(middle, neighbours, frame, size, unknowns);
        if (!polynomial) break;
        const Vec3 fitted_normal = unit(frame.normal - polynomial->a * frame.x - polynomial->b * frame.y);
        if (!(dot(fitted_normal, mean) > kLeastNormalCosine)) {
          polynomial.reset();
          break;
        }
        if (pass == 0) frame = Frame(fitted_normal);
        corner.normal = fitted_normal;
      }
      if (polynomial && std::max({std::abs(polynomial->c), std::abs(polynomial->d), std::abs(polynomial->e)}) * size <
                            kMostCurvature) {
        const Vec3 x = frame.x, y = frame.y;
        const auto of = [&](double xa, double xb, double ya, double yb) {
          return polynomial->c * xa * xb + polynomial->d * (xa * yb + xb * ya) + polynomial->e * ya * yb;
        };
        corner.curvature = {of(x.x, x.x, y.x, y.x), of(x.x, x.y, y.x, y.y), of(x.x, x.z, y.x, y.z),
                            of(x.y, x.y, y.y, y.y), of(x.y, x.z, y.y, y.z), of(x.z, x.z, y.z, y.z)};
        break;
      }
      corner.normal = mean;
      ++order;
    }
    ++surface.fitted_[order];
    return corner;
  }
};

FittedSurface::FittedSurface(const Mesh& mesh) : mesh_(&mesh), edges_(mesh) {
  triangles_.assign(mesh.triangles().size(), {kNoTriangle, kNoTriangle, kNoTriangle});
  corners_.reserve(mesh.vertices().size());
  Fitter fitter(*this, mesh);
  fitter.fitAll();
  corners_.shrink_to_fit();
}

std::size_t FittedSurface::bytes() const {
  return corners_.size() * sizeof(Corner) + triangles_.size() * sizeof(Triangle) + edges_.bytes();
}

}  // namespace fyd::scene
