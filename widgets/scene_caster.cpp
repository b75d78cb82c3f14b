#include "widgets/scene_caster.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace fyd::widgets {
namespace {

constexpr int kTile = SceneCaster::kTile_px;
constexpr int kPacket = 4;                       // 4 × 4 rays
constexpr std::size_t kCompactFrom = 2'000'000;  // triangles of a body: a third less memory, a tenth slower
constexpr double kFarthest = 1e4;                // radii from the middle: what is beyond is not drawn
constexpr double kLeastStick_px = 1.5;           // radius
constexpr double kSquare = 1e-3;                 // how far a placement's axes may be from unit length and right angles
constexpr float kAmbient = 0.35F;                // of the light, from everywhere
constexpr float kBand = 0.6F;                    // dark bands of a stick of the far end, and of an inside
constexpr int kBands = 12;
// Towards the light, in the picture: from the left, above, behind the one who looks.
constexpr double kLightRight = -0.40, kLightUp = 0.50, kLightBack = 0.77;
constexpr float kNothing = std::numeric_limits<float>::infinity();

/// Where in its pixel each of the four samples lies, in pixels from the middle: a turned square.
constexpr float kSampleAt[4][2] = {{-0.125F, -0.375F}, {0.375F, -0.125F}, {0.125F, 0.375F}, {-0.375F, 0.125F}};

struct Float3 {
  float x = 0.0F, y = 0.0F, z = 0.0F;
};

Float3 floats(Vec3 v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }
Float3 operator*(float s, Float3 a) { return {s * a.x, s * a.y, s * a.z}; }
Float3 operator+(Float3 a, Float3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
float dot(Float3 a, Float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Float3 colourOf(const QColor& c) {
  return {static_cast<float>(c.redF()) * 255.0F, static_cast<float>(c.greenF()) * 255.0F,
          static_cast<float>(c.blueF()) * 255.0F};
}

bool stands(const ScenePlacement& p) {
  const auto off = [](double value, double wanted) { return !(std::abs(value - wanted) <= kSquare); };
  return p.origin_mm.finite() && !off(scene::squared(p.x_axis), 1.0) && !off(scene::squared(p.y_axis), 1.0) &&
         !off(scene::squared(p.z_axis), 1.0) && !off(scene::dot(p.x_axis, p.y_axis), 0.0) &&
         !off(scene::dot(p.y_axis, p.z_axis), 0.0) && !off(scene::dot(p.z_axis, p.x_axis), 0.0);
}

Vec3 turned(const ScenePlacement& p, Vec3 v) { return v.x * p.x_axis + v.y * p.y_axis + v.z * p.z_axis; }

/// Rectangles of the picture, gathered as tiles.
class Tiles {
 public:
  void resize(QSize size_px) {
    size_ = size_px;
    columns_ = (size_px.width() + kTile - 1) / kTile;
    rows_ = (size_px.height() + kTile - 1) / kTile;
    mark_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 1);
  }
  void clear() { std::ranges::fill(mark_, std::uint8_t{0}); }
  void all() { std::ranges::fill(mark_, std::uint8_t{1}); }
  [[nodiscard]] QSize size() const { return size_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] bool at(int column, int row) const {
    return mark_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  }
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(std::ranges::count(mark_, 1)); }

  void add(QPointF low, QPointF high) {
    const auto tile = [](double px, int most) {
      return static_cast<int>(std::floor(std::clamp(px / kTile, -1.0, static_cast<double>(most))));
    };
    for (int row = std::max(0, tile(low.y(), rows_)); row <= std::min(rows_ - 1, tile(high.y(), rows_)); ++row) {
      for (int c = std::max(0, tile(low.x(), columns_)); c <= std::min(columns_ - 1, tile(high.x(), columns_)); ++c) {
        mark_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c)] = 1;
      }
    }
  }

  /// A line as wide as twice `radius_px`.
  void addLine(QPointF from, QPointF to, double radius_px) {
    const QPointF way = to - from;
    const double steps = std::hypot(way.x(), way.y()) / (kTile / 2.0);
    if (!(steps < 2000.0)) return all();
    const int n = static_cast<int>(steps) + 1;
    const QPointF wide(radius_px + kTile / 4.0, radius_px + kTile / 4.0);
    for (int i = 0; i <= n; ++i) {
      const QPointF at = from + way * (static_cast<double>(i) / n);
      add(at - wide, at + wide);
    }
  }

 private:
  QSize size_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint8_t> mark_;
};

/// Of what stands in it; none when it is empty.
std::vector<Vec3> cornersOf(RTCScene scene) {
  RTCBounds box;
  rtcGetSceneBounds(scene, &box);
  std::vector<Vec3> out;
  for (int corner = 0; corner < 8 && box.lower_x <= box.upper_x; ++corner) {
    out.push_back({(corner & 1) != 0 ? box.upper_x : box.lower_x, (corner & 2) != 0 ? box.upper_y : box.lower_y,
                   (corner & 4) != 0 ? box.upper_z : box.lower_z});
  }
  return out;
}

constexpr std::size_t kKinds = 3;  // sticks, balls, discs: a geometry of each kind

}  // namespace

struct SceneCaster::Impl {
  RTCDevice device = nullptr;
  RTCScene top = nullptr;        ///< of the bodies
  RTCScene parts = nullptr;      ///< sticks, balls, discs: asked only in the tiles in which there are some
  std::vector<RTCScene> bodies;  ///< null: nothing in it
  std::vector<RTCGeometry> instances;
  std::vector<ScenePlacement> placed;
  std::vector<bool> shown;
  std::vector<SceneShape> shapes;
  std::vector<SceneStick> sticks;
  std::vector<SceneBall> balls;
  std::vector<SceneDisc> discs;
  double stick_least_mm = 0.0;
  std::array<bool, kKinds> attached{};
  Tiles tiles;
  bool changed = true;

  ~Impl() {
    clear();
    if (device != nullptr) rtcReleaseDevice(device);
  }

  void clear() {
    for (RTCGeometry each : instances) {
      if (each != nullptr) rtcReleaseGeometry(each);
    }
    if (top != nullptr) rtcReleaseScene(top);
    if (parts != nullptr) rtcReleaseScene(parts);
    for (RTCScene each : bodies) {
      if (each != nullptr) rtcReleaseScene(each);
    }
    top = parts = nullptr;
    instances.clear();
    bodies.clear();
    placed.clear();
    shown.clear();
    shapes.clear();
    sticks.clear();
    balls.clear();
    discs.clear();
    attached = {};
  }

  QString error() const {
    switch (rtcGetDeviceError(device)) {
      case RTC_ERROR_NONE: return {};
      case RTC_ERROR_CANCELLED: return QStringLiteral("cancelled");
      case RTC_ERROR_OUT_OF_MEMORY: return QStringLiteral("Embree: out of memory");
      case RTC_ERROR_UNSUPPORTED_CPU: return QStringLiteral("Embree: unsupported processor");
      default: return QStringLiteral("Embree: error");
    }
  }

  template <class T>
  T* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count) const {
    return static_cast<T*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), count));
  }

  /// @param make fills the geometry; null geometry type: nothing of this kind
  void attachKind(std::size_t kind, RTCGeometryType type, std::size_t count,
                  const std::function<void(RTCGeometry)>& make) {
    const auto id = static_cast<unsigned>(kind);
    if (attached[kind]) rtcDetachGeometry(parts, id);
    attached[kind] = count > 0;
    if (count == 0) return;
    RTCGeometry geometry = rtcNewGeometry(device, type);
    make(geometry);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(parts, geometry, id);
    rtcReleaseGeometry(geometry);
  }

  void markBody(std::size_t b, const SceneMeshes& meshes, const SceneShot& shot) {
    if (bodies[b] == nullptr || !shown[b]) return;
    constexpr double kFar = std::numeric_limits<double>::infinity();
    QPointF low(kFar, kFar), high(-kFar, -kFar);
    for (const Vec3& unit : cornersOf(bodies[b])) {
      const Vec3 at_mm = turned(placed[b], meshes.radius_mm * unit + meshes.middle_mm) + placed[b].origin_mm;
      const QPointF at = inDevice(shot, at_mm);
      low = {std::min(low.x(), at.x()), std::min(low.y(), at.y())};
      high = {std::max(high.x(), at.x()), std::max(high.y(), at.y())};
    }
    tiles.add(low - QPointF(2, 2), high + QPointF(2, 2));
  }

  static void markRound(Tiles& into, Vec3 centre_mm, double radius_mm, const SceneShot& shot) {
    const QPointF at = inDevice(shot, centre_mm);
    const double radius = radius_mm / shot.camera.mmPerPixel() * shot.pixel_ratio + 2.0;
    into.add(at - QPointF(radius, radius), at + QPointF(radius, radius));
  }

  void markParts(Tiles& into, const SceneShot& shot) const {
    for (const SceneStick& each : sticks) {
      into.addLine(inDevice(shot, each.from_mm), inDevice(shot, each.to_mm),
                   each.radius_mm / shot.camera.mmPerPixel() * shot.pixel_ratio + 4.0);
    }
    for (const SceneBall& each : balls) markRound(into, each.centre_mm, each.radius_mm, shot);
    for (const SceneDisc& each : discs) markRound(into, each.centre_mm, each.radius_mm, shot);
  }

  static QPointF inDevice(const SceneShot& shot, Vec3 at_mm) {
    return shot.pixel_ratio * shot.camera.project(at_mm, QSizeF(shot.size_px) / shot.pixel_ratio);
  }

  bool moveBody(std::size_t b, const SceneMeshes& meshes, const ScenePlacement& to, const SceneShape& shape,
                const SceneShot& shot);
  bool moveParts(const SceneMeshes& meshes, const SceneParts& given, const SceneShot& shot);
};

SceneCaster::SceneCaster() : impl_(std::make_unique<Impl>()), meshes_(SceneMeshes::of({})) {
  // One thread: the one that calls, whose low priority is this class' user's to choose.
  impl_->device = rtcNewDevice("threads=1,set_affinity=0");
  if (impl_->device == nullptr) {
    problem_ = QStringLiteral("Embree: no device");
    return;
  }
  (void)build(meshes_, [] { return true; });
}

SceneCaster::~SceneCaster() = default;

bool SceneCaster::build(std::shared_ptr<const SceneMeshes> meshes, const std::function<bool()>& go_on) {
  Impl& d = *impl_;
  if (d.device == nullptr) return false;
  d.clear();
  meshes_ = SceneMeshes::of({});
  problem_.clear();
  (void)rtcGetDeviceError(d.device);
  d.changed = true;
  d.tiles.all();
  for (RTCScene* each : {&d.top, &d.parts}) {
    *each = rtcNewScene(d.device);
    rtcSetSceneFlags(*each, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(*each, RTC_BUILD_QUALITY_LOW);
  }
  for (const SceneMeshes::Body& body : meshes->bodies) {
    d.bodies.push_back(nullptr);
    d.instances.push_back(nullptr);
    if (body.triangles.empty()) continue;
    RTCScene scene = rtcNewScene(d.device);
    d.bodies.back() = scene;
    if (body.triangles.size() / 3 > kCompactFrom) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_COMPACT);
    rtcSetSceneProgressMonitorFunction(
        scene, [](void* ask, double) { return (*static_cast<const std::function<bool()>*>(ask))(); },
        const_cast<std::function<bool()>*>(&go_on));
    RTCGeometry geometry = rtcNewGeometry(d.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, body.vertices.data(), 0,
                               3 * sizeof(float), body.vertices.size() / 3 - 1);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, body.triangles.data(), 0,
                               3 * sizeof(std::uint32_t), body.triangles.size() / 3);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, 0);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
    problem_ = d.error();
    if (!problem_.isEmpty()) {
      d.clear();
      return false;
    }
    d.instances.back() = rtcNewGeometry(d.device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(d.instances.back(), scene);
  }
  d.placed.resize(d.bodies.size());
  d.shown.assign(d.bodies.size(), false);
  d.shapes.resize(d.bodies.size());
  meshes_ = std::move(meshes);
  return true;
}

bool SceneCaster::Impl::moveBody(std::size_t b, const SceneMeshes& meshes, const ScenePlacement& to,
                                 const SceneShape& shape, const SceneShot& shot) {
  if (bodies[b] == nullptr) return false;
  const std::vector<float>& given = meshes.bodies[b].vertices;
  const bool reshaped = shape != shapes[b] && (!shape || shape->size() == given.size());
  const Vec3 unit = (1.0 / meshes.radius_mm) * (turned(to, meshes.middle_mm) + to.origin_mm - meshes.middle_mm);
  const bool show = stands(to) && scene::length(unit) <= kFarthest;
  if (!reshaped && show == shown[b] && (!show || to == placed[b])) return false;
  markBody(b, meshes, shot);
  if (reshaped) {
    shapes[b] = shape;
    RTCGeometry geometry = rtcGetGeometry(bodies[b], 0);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               shape ? shape->data() : given.data(), 0, 3 * sizeof(float), given.size() / 3 - 1);
    rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry);
    rtcSetSceneFlags(bodies[b], RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(bodies[b], RTC_BUILD_QUALITY_LOW);  // will not live long
    rtcCommitScene(bodies[b]);
  }
  if (show) {
    const Float3 x = floats(to.x_axis), y = floats(to.y_axis), z = floats(to.z_axis), o = floats(unit);
    const float columns[12] = {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z, o.x, o.y, o.z};
    rtcSetGeometryTransform(instances[b], 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
    rtcCommitGeometry(instances[b]);
    if (!shown[b]) rtcAttachGeometryByID(top, instances[b], static_cast<unsigned>(b));
  } else if (shown[b]) {
    rtcDetachGeometry(top, static_cast<unsigned>(b));
  }
  shown[b] = show;
  placed[b] = to;
  markBody(b, meshes, shot);
  return true;
}

bool SceneCaster::Impl::moveParts(const SceneMeshes& meshes, const SceneParts& given, const SceneShot& shot) {
  const auto near = [&](Vec3 at_mm, double radius_mm) {
    return at_mm.finite() && scene::length(meshes.unitOf(at_mm)) <= kFarthest && radius_mm >= 0.0 &&
           radius_mm <= kFarthest * meshes.radius_mm;
  };
  const double least_mm = kLeastStick_px * shot.camera.mmPerPixel();
  std::vector<SceneStick> new_sticks;
  std::vector<SceneBall> new_balls;
  std::vector<SceneDisc> new_discs;
  for (SceneStick each : given.sticks) {
    if (new_sticks.size() == kMostSceneParts) break;
    each.radius_mm = std::max(each.radius_mm, least_mm);
    if (!near(each.from_mm, each.radius_mm) || !near(each.to_mm, each.radius_mm)) continue;
    // Without a length it would have no direction.
    if (scene::length(each.to_mm - each.from_mm) < 1e-3 * each.radius_mm) each.to_mm.x += 1e-3 * each.radius_mm;
    new_sticks.push_back(each);
  }
  for (const SceneBall& each : given.balls) {
    if (new_balls.size() == kMostSceneParts) break;
    if (near(each.centre_mm, each.radius_mm) && each.radius_mm > 0.0) new_balls.push_back(each);
  }
  for (SceneDisc each : given.discs) {
    if (new_discs.size() == kMostSceneParts) break;
    each.normal = scene::unit(each.normal);
    if (near(each.centre_mm, each.radius_mm) && each.radius_mm > 0.0 && scene::squared(each.normal) > 0.5) {
      new_discs.push_back(each);
    }
  }
  if (new_sticks == sticks && new_balls == balls && new_discs == discs) return false;
  markParts(tiles, shot);
  sticks = std::move(new_sticks);
  balls = std::move(new_balls);
  discs = std::move(new_discs);
  markParts(tiles, shot);
  struct Round {
    Float3 at;
    float radius;
  };
  const auto round = [&](Vec3 at_mm, double radius_mm) {
    return Round{floats(meshes.unitOf(at_mm)), static_cast<float>(radius_mm / meshes.radius_mm)};
  };
  attachKind(0, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE, sticks.size(), [&](RTCGeometry geometry) {
    auto* ends = buffer<Round>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 2 * sticks.size());
    auto* first = buffer<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, sticks.size());
    if (ends == nullptr || first == nullptr) return;
    for (std::size_t i = 0; i < sticks.size(); ++i) {
      ends[2 * i] = round(sticks[i].from_mm, sticks[i].radius_mm);
      ends[2 * i + 1] = round(sticks[i].to_mm, sticks[i].radius_mm);
      first[i] = static_cast<std::uint32_t>(2 * i);
    }
  });
  attachKind(1, RTC_GEOMETRY_TYPE_SPHERE_POINT, balls.size(), [&](RTCGeometry geometry) {
    auto* at = buffer<Round>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, balls.size());
    if (at == nullptr) return;
    for (std::size_t i = 0; i < balls.size(); ++i) at[i] = round(balls[i].centre_mm, balls[i].radius_mm);
  });
  attachKind(2, RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT, discs.size(), [&](RTCGeometry geometry) {
    auto* at = buffer<Round>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, discs.size());
    auto* normal = buffer<Float3>(geometry, RTC_BUFFER_TYPE_NORMAL, RTC_FORMAT_FLOAT3, discs.size());
    if (at == nullptr || normal == nullptr) return;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      at[i] = round(discs[i].centre_mm, discs[i].radius_mm);
      normal[i] = floats(discs[i].normal);
    }
  });
  return true;
}

void SceneCaster::move(const SceneParts& parts, const std::vector<SceneShape>& shapes, const SceneShot& shot) {
  Impl& d = *impl_;
  if (d.top == nullptr) return;
  if (d.tiles.size() != shot.size_px) d.tiles.resize(shot.size_px);
  bool changed = d.changed;
  for (std::size_t b = 0; b < d.bodies.size(); ++b) {
    changed |= d.moveBody(b, *meshes_, b < parts.placements.size() ? parts.placements[b] : ScenePlacement{},
                          b < shapes.size() ? shapes[b] : nullptr, shot);
  }
  if (changed) rtcCommitScene(d.top);
  if (d.moveParts(*meshes_, parts, shot) || d.changed) rtcCommitScene(d.parts);
  d.changed = false;
}

std::size_t SceneCaster::pixelsToCast(const SceneShot& shot, SceneFineness fineness) const {
  const auto pixels = static_cast<std::size_t>(shot.size_px.width()) * static_cast<std::size_t>(shot.size_px.height());
  const bool all = !(shot == picture_.shot) || impl_->tiles.size() != shot.size_px || fineness != picture_.fineness;
  return all ? pixels : std::min(pixels, impl_->tiles.count() * kTile * kTile);
}

namespace {

/// All that the rays of one picture share.
class Casting {
 public:
  Casting(RTCScene top, RTCScene parts, const SceneMeshes& meshes, const std::vector<ScenePlacement>& placed,
          const SceneShot& shot, const std::vector<SceneStick>& sticks, const std::vector<SceneBall>& balls,
          const std::vector<SceneDisc>& discs)
      : top_(top), parts_(parts), sticks_(sticks), balls_(balls), discs_(discs), radius_mm_(meshes.radius_mm) {
    const SceneCamera& camera = shot.camera;
    const Vec3 light = kLightRight * camera.right() + kLightUp * camera.up() - kLightBack * camera.forward();
    forward_ = floats(camera.forward());
    light_ = floats(light);
    for (std::size_t b = 0; b < placed.size(); ++b) {
      const auto turnedBack = [&](Vec3 v) {
        const ScenePlacement& p = placed[b];
        return floats({scene::dot(v, p.x_axis), scene::dot(v, p.y_axis), scene::dot(v, p.z_axis)});
      };
      looks_.push_back(
          {static_cast<std::size_t>(meshes.bodies[b].role), turnedBack(camera.forward()), turnedBack(light)});
    }
    // Rays begin in front of everything.
    const Vec3 target = meshes.unitOf(camera.target_mm());
    double nearest = 0.0;
    for (RTCScene each : {top, parts}) {
      for (const Vec3& corner : cornersOf(each)) {
        nearest = std::min(nearest, scene::dot(corner - target, camera.forward()));
      }
    }
    near_ = nearest - 0.01 - 1e-3 * std::abs(nearest);
    const double pixel = camera.mmPerPixel() / shot.pixel_ratio / meshes.radius_mm;
    across_ = floats(pixel * camera.right());
    down_ = floats(-pixel * camera.up());
    const Vec3 corner = target + near_ * camera.forward() - (0.5 * pixel * shot.size_px.width()) * camera.right() +
                        (0.5 * pixel * shot.size_px.height()) * camera.up();
    corner_ = floats(corner);
    ground_ = colourOf(shot.colours.ground);
    for (std::size_t role = 0; role < kSceneRoles; ++role) {
      outside_[role] = colourOf(shot.colours.outside[role]);
      inside_[role] = colourOf(shot.colours.inside[role]);
    }
  }

  /// 4 × 4 rays, the first at pixel (x, y), `step` pixels apart.
  void packet(float x, float y, float step, bool with_parts, std::array<Float3, 16>& colour,
              std::array<float, 16>& depth_mm) const {
    alignas(64) RTCRayHit16 rays;
    alignas(64) int valid[16];
    for (int i = 0; i < 16; ++i) {
      const float a = x + step * static_cast<float>(i % kPacket), b = y + step * static_cast<float>(i / kPacket);
      valid[i] = -1;
      rays.ray.org_x[i] = corner_.x + a * across_.x + b * down_.x;
      rays.ray.org_y[i] = corner_.y + a * across_.y + b * down_.y;
      rays.ray.org_z[i] = corner_.z + a * across_.z + b * down_.z;
      rays.ray.dir_x[i] = forward_.x;
      rays.ray.dir_y[i] = forward_.y;
      rays.ray.dir_z[i] = forward_.z;
      rays.ray.tnear[i] = 0.0F;
      rays.ray.tfar[i] = kNothing;
      rays.ray.time[i] = 0.0F;
      rays.ray.mask[i] = 0xffffffff;
      rays.ray.flags[i] = 0;
      rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, top_, &context, &rays);
    if (with_parts) rtcIntersect16(valid, parts_, &context, &rays);  // what is nearer than the bodies
    for (int i = 0; i < 16; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) {
        colour[k] = ground_;
        depth_mm[k] = kNothing;
        continue;
      }
      depth_mm[k] = static_cast<float>((near_ + static_cast<double>(rays.ray.tfar[i])) * radius_mm_);
      const float a = x + step * static_cast<float>(i % kPacket), b = y + step * static_cast<float>(i / kPacket);
      colour[k] = shade(rays.hit, i, (static_cast<int>(a + b) / 3) % 2 == 0);
    }
  }

 private:
  /// What a ray needs to know of the body it hit.
  struct Look {
    std::size_t role;
    Float3 forward, light;  ///< in the body's own frame, as the normals are
  };

  /// The light that comes back to the eye.
  static float bright(Float3 normal, Float3 light, bool from_behind) {
    const float lit = dot(normal, light) / std::sqrt(dot(normal, normal));
    return kAmbient + (1.0F - kAmbient) * std::max(0.0F, from_behind ? -lit : lit);  // 0 for no number
  }

  Float3 shade(const RTCHit16& hit, int i, bool hatch) const {
    const Float3 normal{hit.Ng_x[i], hit.Ng_y[i], hit.Ng_z[i]};
    if (const unsigned body = hit.instID[0][i]; body != RTC_INVALID_GEOMETRY_ID) {
      const Look& look = looks_[body];
      const bool from_inside = dot(normal, look.forward) > 0.0F;
      const float share = bright(normal, look.light, from_inside) * (from_inside && hatch ? kBand : 1.0F);
      return share * (from_inside ? inside_ : outside_)[look.role];
    }
    const unsigned kind = hit.geomID[i], which = hit.primID[i];
    const SceneRole role = kind == 0 ? sticks_[which].role : kind == 1 ? balls_[which].role : discs_[which].role;
    const bool dark = kind == 0 && role == SceneRole::other && static_cast<int>(hit.u[i] * kBands) % 2 == 1;
    const float share = bright(normal, light_, dot(normal, forward_) > 0.0F) * (dark ? kBand : 1.0F);
    return share * outside_[static_cast<std::size_t>(role)];
  }

  RTCScene top_;
  RTCScene parts_;
  std::vector<Look> looks_;
  const std::vector<SceneStick>& sticks_;
  const std::vector<SceneBall>& balls_;
  const std::vector<SceneDisc>& discs_;
  double radius_mm_;
  double near_ = 0.0;
  Float3 forward_, light_, across_, down_, corner_, ground_;
  std::array<Float3, kSceneRoles> outside_, inside_;
};

QRgb rgb(Float3 c) {
  const auto byte = [](float v) { return static_cast<int>(std::clamp(v + 0.5F, 0.0F, 255.0F)); };
  return qRgb(byte(c.x), byte(c.y), byte(c.z));
}

struct Canvas {
  QRgb* pixels;
  float* depth_mm;
  int width, height;
};

void castTile(const Casting& casting, const Canvas& canvas, SceneFineness fineness, int left, int top,
              bool with_parts) {
  const int block = fineness.block;
  const auto step = static_cast<float>(block);
  std::array<Float3, 16> colour, sum;
  std::array<float, 16> depth, nearest;
  for (int y0 = top; y0 < std::min(canvas.height, top + kTile); y0 += kPacket * block) {
    for (int x0 = left; x0 < std::min(canvas.width, left + kTile); x0 += kPacket * block) {
      const auto x = static_cast<float>(x0), y = static_cast<float>(y0);
      if (fineness.samples == 1) {
        casting.packet(x + 0.5F * step, y + 0.5F * step, step, with_parts, sum, nearest);
      } else {
        sum.fill({});
        nearest.fill(kNothing);
        for (const auto& at : kSampleAt) {
          casting.packet(x + 0.5F + at[0], y + 0.5F + at[1], step, with_parts, colour, depth);
          for (std::size_t k = 0; k < 16; ++k) {
            sum[k] = sum[k] + 0.25F * colour[k];
            nearest[k] = std::min(nearest[k], depth[k]);
          }
        }
      }
      for (int k = 0; k < 16; ++k) {
        const QRgb pixel = rgb(sum[static_cast<std::size_t>(k)]);
        const float far = nearest[static_cast<std::size_t>(k)];
        const int x1 = x0 + (k % kPacket) * block, y1 = y0 + (k / kPacket) * block;
        for (int line = y1; line < std::min(canvas.height, y1 + block); ++line) {
          const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(line) * canvas.width;
          for (int column = x1; column < std::min(canvas.width, x1 + block); ++column) {
            canvas.pixels[row + column] = pixel;
            canvas.depth_mm[row + column] = far;
          }
        }
      }
    }
  }
}

}  // namespace

bool SceneCaster::cast(const SceneShot& shot, SceneFineness fineness, const std::function<bool()>& go_on) {
  Impl& d = *impl_;
  if (d.top == nullptr || shot.size_px.isEmpty()) return false;
  if (d.tiles.size() != shot.size_px) d.tiles.resize(shot.size_px);
  ScenePicture& p = picture_;
  if (!(shot == p.shot) || fineness != p.fineness) d.tiles.all();
  if (p.image.size() != shot.size_px) {
    p.image = QImage(shot.size_px, QImage::Format_RGB32);
    p.depth_mm.assign(static_cast<std::size_t>(shot.size_px.width()) * static_cast<std::size_t>(shot.size_px.height()),
                      kNothing);
  }
  p.shot = shot;
  p.fineness = fineness;
  p.rays = 0;
  Tiles with_parts;
  with_parts.resize(shot.size_px);
  with_parts.clear();
  d.markParts(with_parts, shot);
  const Casting casting(d.top, d.parts, *meshes_, d.placed, shot, d.sticks, d.balls, d.discs);
  const Canvas canvas{reinterpret_cast<QRgb*>(p.image.bits()), p.depth_mm.data(), shot.size_px.width(),
                      shot.size_px.height()};
  for (int row = 0; row < d.tiles.rows(); ++row) {
    for (int column = 0; column < d.tiles.columns(); ++column) {
      if (!d.tiles.at(column, row)) continue;
      castTile(casting, canvas, fineness, column * kTile, row * kTile, with_parts.at(column, row));
      p.rays += static_cast<std::size_t>(kTile / fineness.block * (kTile / fineness.block) * fineness.samples);
    }
    if (!go_on()) {
      d.tiles.all();
      return false;
    }
  }
  d.tiles.clear();
  return true;
}

}  // namespace fyd::widgets
