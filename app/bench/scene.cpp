// The nearest point of a mesh beside Embree's: a probe 1 mm under a bumpy plane.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <embree3/rtcore.h>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/scene_bumpy_plane.h"
#include "app/bench/parts/table.h"
#include "app/cli/parts/command.h"
#include "app/cli/parts/probe_path.h"
#include "core/scene/mesh/nearest_point.h"
#include "core/scene/mesh/vector.h"
#include "core/sim/scene_file.h"

namespace fyd::bench {
namespace scene_rows {
namespace {

using namespace scene;

int steps() { return wholeOrQuick(60'000, 2'000); }
constexpr double kDepth_mm = 1.0;
constexpr std::size_t kDisturbed_bytes = 4 << 20;

/// The square of the distance to a triangle: to its plane where the probe is above it, else to the nearest of its sides.
/// Another formula than the core's, which asks in which region the probe lies.
double squaredTo(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto toSide = [&p](const Vec3& from, const Vec3& to) {
    const Vec3 side = to - from;
    const double share = squared(side) > 0.0 ? std::clamp(dot(p - from, side) / squared(side), 0.0, 1.0) : 0.0;
    return squared(p - from - share * side);
  };
  const Vec3 normal = cross(b - a, c - a);
  const auto inside = [&](const Vec3& from, const Vec3& to) { return dot(cross(to - from, p - from), normal) >= 0.0; };
  if (squared(normal) > 0.0 && inside(a, b) && inside(b, c) && inside(c, a)) {
    const double height = dot(p - a, normal);
    return height * height / squared(normal);
  }
  return std::min({toSide(a, b), toSide(b, c), toSide(c, a)});
}

/// The distance to every single triangle, mm.
double distanceToAll(const Mesh& mesh, const Vec3& at) {
  const auto v = mesh.vertices();
  double squared_mm2 = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles())
    squared_mm2 = std::min(squared_mm2, squaredTo(at, v[t[0]], v[t[1]], v[t[2]]));
  return std::sqrt(squared_mm2);
}

/// Embree 3 in one thread, of high quality and robust; its callback in float.
class Embree {
 public:
  explicit Embree(const Mesh& mesh) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<Point*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 sizeof(Point), mesh.vertices().size()));
    for (const Vec3& v : mesh.vertices()) *vertices++ = pointOf(v);
    vertices_.assign(vertices - mesh.vertices().size(), vertices);
    auto* triangles = static_cast<Triangle*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), mesh.triangles().size()));
    std::copy(mesh.triangles().begin(), mesh.triangles().end(), triangles);
    triangles_.assign(mesh.triangles().begin(), mesh.triangles().end());
    rtcSetGeometryPointQueryFunction(geometry, &Embree::meet);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~Embree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  /// @return the distance, mm
  double ask(const Vec3& at, double radius_mm) {
    RTCPointQuery query{.x = static_cast<float>(at.x),
                        .y = static_cast<float>(at.y),
                        .z = static_cast<float>(at.z),
                        .time = 0.0F,
                        .radius = static_cast<float>(radius_mm)};
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): what Embree reads is written below
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_, &query, &context, nullptr, this);
    return query.radius;
  }

 private:
  struct Point {
    float x, y, z;
    friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Point operator*(float s, Point a) { return {s * a.x, s * a.y, s * a.z}; }
    friend float operator*(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  };
  static Point pointOf(const Vec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  }
  static Point nearest(Point p, Point a, Point b, Point c) {  // as in Ericson's book
    const Point ab = b - a, ac = c - a, ap = p - a;
    const float d1 = ab * ap, d2 = ac * ap;
    if (d1 <= 0 && d2 <= 0) return a;
    const Point bp = p - b;
    const float d3 = ab * bp, d4 = ac * bp;
    if (d3 >= 0 && d4 <= d3) return b;
    const float vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
    const Point cp = p - c;
    const float d5 = ab * cp, d6 = ac * cp;
    if (d6 >= 0 && d5 <= d6) return c;
    const float vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
    const float va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    const float share = 1.0F / (va + vb + vc);
    return a + vb * share * ab + vc * share * ac;
  }
  static bool meet(RTCPointQueryFunctionArguments* arguments) {
    const auto& own = *static_cast<const Embree*>(arguments->userPtr);
    const Triangle& t = own.triangles_[arguments->primID];
    const Point p = {arguments->query->x, arguments->query->y, arguments->query->z};
    const Point way = p - nearest(p, own.vertices_[t[0]], own.vertices_[t[1]], own.vertices_[t[2]]);
    const float distance = std::sqrt(way * way);
    if (!(distance < arguments->query->radius)) return false;
    arguments->query->radius = distance;
    return true;
  }

  RTCDevice device_;
  RTCScene scene_;
  std::vector<Point> vertices_;
  std::vector<Triangle> triangles_;
};

/// Of each call on the path; `disturb`: 4 MB are written in between, which evicts caches as other code does.
template <class Find>
Quantiles measure(const std::vector<Vec3>& path, bool disturb, Find&& find) {
  static std::vector<char> other(kDisturbed_bytes);
  std::vector<double> ns;
  ns.reserve(path.size());
  for (const Vec3& at : path) {
    if (disturb) {
      for (std::size_t i = 0; i < other.size(); i += 64) ++other[i];
    }
    const auto start = std::chrono::steady_clock::now();
    find(at);
    ns.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
  return quantiles(ns);
}

struct Way {
  std::string name;
  std::vector<Vec3> probe_mm;
  bool disturbed = false;
};

/// So many triangles are asked for the truth of a path; all of a path's steps would take hours.
constexpr std::size_t kAsked = 20'000'000;
constexpr std::size_t kLeastJudged = 50;

/// One step of so many is judged.
std::size_t judgedEvery(const Mesh& mesh, const std::vector<Vec3>& path) {
  const std::size_t judged = std::max(kLeastJudged, kAsked / mesh.triangles().size());
  return std::max<std::size_t>(1, path.size() / judged);
}

void measureOn(Table& table, const Mesh& mesh, const std::vector<Way>& ways) {
  const auto start = std::chrono::steady_clock::now();
  const TriangleTree tree(mesh);
  const WalkableMesh walkable(tree);
  const double built_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Embree embree(mesh);
  for (const Way& way : ways) {
    const std::vector<Vec3>& path = way.probe_mm;
    const std::size_t every = judgedEvery(mesh, path);
    std::vector<double> truth;
    for (std::size_t i = 0; i < path.size(); i += every) truth.push_back(distanceToAll(mesh, path[i]));
    const Quantiles clock = measure(path, way.disturbed, [](const Vec3&) {});
    const auto without = [&clock](Quantiles q) {
      q.p50 -= clock.p50;
      q.p99 -= clock.p50;
      return q;
    };
    double worst_mm = 0.0, last_mm = 0.0;
    std::size_t i = 0;
    Vec3 before;
    const auto compare = [&](double distance_mm) {
      if (i % every == 0) worst_mm = std::max(worst_mm, std::abs(distance_mm - truth[i / every]));
      ++i;
    };
    const auto bounded = [&](const Vec3& at) {
      const double radius_mm = i == 0 ? 1e30 : (last_mm + length(at - before)) * 1.00001 + 1e-5;
      before = at;
      last_mm = embree.ask(at, radius_mm);
      compare(last_mm);
    };
    const Quantiles base = without(measure(path, way.disturbed, bounded));
    const auto row = [&](const char* engine, const Quantiles& q, const std::string& built, const std::string& memory) {
      table.rows.push_back({std::to_string(mesh.triangles().size()), way.name, engine, number(q.p50), number(q.p99),
                            number(base.p50 / q.p50), number(base.p99 / q.p99), number(worst_mm, 2), built, memory});
      worst_mm = 0.0;
      i = 0;
    };
    row("Embree 3, radius = last distance + motion (baseline)", base, "—", "—");
    row("Embree 3, infinite radius",
        without(measure(path, way.disturbed, [&](const Vec3& at) { compare(embree.ask(at, 1e30)); })), "—", "—");
    row("tree alone",
        without(
            measure(path, way.disturbed, [&](const Vec3& at) { compare(std::sqrt(tree.nearest(at).squared_mm2)); })),
        "—", number(static_cast<double>(tree.bytes()) / 1e6));
    NearestPoint probe(walkable);
    row("walk with certificate",
        without(measure(path, way.disturbed, [&](const Vec3& at) { compare(std::sqrt(probe.find(at).squared_mm2)); })),
        number(built_s), number(static_cast<double>(tree.bytes() + walkable.bytes()) / 1e6));
  }
}

std::vector<Way> bumpyWays() {
  constexpr double kSlow_mm_s = 110.0, kFast_mm_s = 500.0;
  return {{"110 mm/s", underBumpyPlane(steps(), kSlow_mm_s, kDepth_mm)},
          {"110 mm/s, 4 MB between", underBumpyPlane(steps() / 10, kSlow_mm_s, kDepth_mm), true},
          {"500 mm/s", underBumpyPlane(steps(), kFast_mm_s, kDepth_mm)}};
}

}  // namespace
}  // namespace scene_rows

Table bench_scene() {
  using namespace scene_rows;
  Table table{.subject = "scene",
              .title = "Nearest point of a mesh, probe 1 mm under a bumpy plane",
              .columns = {{"triangles", Role::group},
                          {"path", Role::group},
                          {"engine", Role::method},
                          {"median", "ns", Role::cost},
                          {"p99", "ns"},
                          "median against bounded Embree",
                          "p99 against it",
                          {"largest error", "mm", Role::error},
                          {"built in", "s"},
                          {"memory", "MB"}},
              .rows = {},
              .notes = {}};
  const std::string judged =
      "Error: of the distance, against every single triangle, by another formula than the walk's and the tree's, in "
      "double precision (Embree's is single), at as many steps as take 20 million triangles a path, 50 at least.";
  if (const BenchOptions& given = benchOptions(); !given.mesh.empty()) {
    const Mesh mesh = cli::valueOrFail(sim::openMesh(given.mesh, LengthUnit::mm));
    const std::vector<Vec3> path = cli::readProbePath(given.path).probe_mm;
    const std::vector<Vec3> part(path.begin(), path.begin() + static_cast<std::ptrdiff_t>((path.size() + 9) / 10));
    measureOn(table, mesh, {{"as given", path}, {"its first tenth, 4 MB between", part, true}});
    table.title = "Nearest point of " + given.mesh + ", path " + given.path;
    table.notes = {judged};
    return table;
  }
  for (const int n : wholeOrFirst(std::vector<int>{71, 224, 707}, 1))
    measureOn(table, *Mesh::build(bumpyPlane(n)), bumpyWays());
  table.notes = {
      "z = 2 mm · sin(2πx/20 mm) · sin(2πy/20 mm), 100 × 100 mm; " + std::to_string(steps()) +
          " steps of 1 ms (a tenth with 4 MB written between them), one thread, the clock's own time taken off.",
      judged};
  return table;
}

}  // namespace fyd::bench
