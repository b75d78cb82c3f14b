#include "widgets/scene/scene_caster.h"

#include <algorithm>
#include <cmath>

#include "widgets/scene/scene_rays.h"
#include "widgets/scene/scene_tiles.h"

namespace fyd::widgets {
namespace {

constexpr std::size_t kCompactFrom = 2'000'000;  // triangles of a body: a third less memory, a tenth slower
constexpr double kFarthest = 1e4;                // radii from the middle: parts beyond are not drawn
constexpr double kLeastStick_px = 1.5;           // radius
constexpr double kSquare = 1e-3;                 // tolerance of a placement's axes: unit length and right angles

bool stands(const ScenePlacement& p) {
  const auto off = [](double value, double wanted) { return !(std::abs(value - wanted) <= kSquare); };
  return p.origin_mm.finite() && !off(scene::squared(p.x_axis), 1.0) && !off(scene::squared(p.y_axis), 1.0) &&
         !off(scene::squared(p.z_axis), 1.0) && !off(scene::dot(p.x_axis, p.y_axis), 0.0) &&
         !off(scene::dot(p.y_axis, p.z_axis), 0.0) && !off(scene::dot(p.z_axis, p.x_axis), 0.0);
}

Vec3 turned(const ScenePlacement& p, Vec3 v) { return v.x * p.x_axis + v.y * p.y_axis + v.z * p.z_axis; }

}  // namespace

struct SceneCaster::Impl {
  RTCDevice device = nullptr;
  RTCScene top = nullptr;  ///< of the bodies
  RTCScene parts =
      nullptr;  ///< the parts of SceneParts that are not bodies: cast only in the tiles in which there are some
  std::vector<RTCScene> bodies;  ///< null: nothing in it
  std::vector<RTCGeometry> instances;
  std::vector<ScenePlacement> placed;
  std::vector<bool> shown;
  std::vector<SceneShape> shapes;
  SceneParts drawn;  ///< without placements, and without non-finite or too distant parts
  double stick_least_mm = 0.0;
  std::array<bool, kScenePartKinds> attached{};
  SceneTiles tiles;
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
    drawn = {};
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
  void attachKind(ScenePartKind kind, RTCGeometryType type, std::size_t count,
                  const std::function<void(RTCGeometry)>& make) {
    const unsigned id = kind;
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

  static void markRound(SceneTiles& into, Vec3 centre_mm, double radius_mm, const SceneShot& shot) {
    const QPointF at = inDevice(shot, centre_mm);
    const double radius = radius_mm / shot.camera.mmPerPixel() * shot.pixel_ratio + 2.0;
    into.add(at - QPointF(radius, radius), at + QPointF(radius, radius));
  }

  void markParts(SceneTiles& into, const SceneShot& shot) const {
    for (const SceneStick& each : drawn.sticks) {
      into.addLine(inDevice(shot, each.from_mm), inDevice(shot, each.to_mm),
                   each.radius_mm / shot.camera.mmPerPixel() * shot.pixel_ratio + 4.0);
    }
    for (const SceneBall& each : drawn.balls) markRound(into, each.centre_mm, each.radius_mm, shot);
    for (const SceneDisc& each : drawn.discs) markRound(into, each.centre_mm, each.radius_mm, shot);
    for (const SceneSheet& each : drawn.sheets) markRound(into, each.centre_mm, each.radius_mm(), shot);
  }

  static QPointF inDevice(const SceneShot& shot, Vec3 at_mm) {
    return shot.pixel_ratio * shot.camera.project(at_mm, QSizeF(shot.size_px) / shot.pixel_ratio);
  }

  bool moveBody(std::size_t b, const SceneMeshes& meshes, const ScenePlacement& to, const SceneShape& shape,
                const SceneShot& shot);
  bool moveParts(const SceneMeshes& meshes, const SceneParts& given, const SceneShot& shot);
};

SceneCaster::SceneCaster() : impl_(std::make_unique<Impl>()), meshes_(SceneMeshes::of({})) {
  // No threads of Embree's own: the caller's thread casts, and the caller chooses its priority.
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
    rtcSetSceneBuildQuality(bodies[b], RTC_BUILD_QUALITY_LOW);  // replaced soon, so it is built fast
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
  SceneParts next;
  for (SceneStick each : given.sticks) {
    if (next.sticks.size() == kMostSceneParts) break;
    each.radius_mm = std::max(each.radius_mm, least_mm);
    if (!near(each.from_mm, each.radius_mm) || !near(each.to_mm, each.radius_mm)) continue;
    // A stick of length 0 would have no direction.
    if (scene::length(each.to_mm - each.from_mm) < 1e-3 * each.radius_mm) each.to_mm.x += 1e-3 * each.radius_mm;
    next.sticks.push_back(each);
  }
  for (const SceneBall& each : given.balls) {
    if (next.balls.size() == kMostSceneParts) break;
    if (near(each.centre_mm, each.radius_mm) && each.radius_mm > 0.0) next.balls.push_back(each);
  }
  for (SceneDisc each : given.discs) {
    if (next.discs.size() == kMostSceneParts) break;
    each.normal = scene::unit(each.normal);
    if (near(each.centre_mm, each.radius_mm) && each.radius_mm > 0.0 && scene::squared(each.normal) > 0.5) {
      next.discs.push_back(each);
    }
  }
  for (const SceneSheet& each : given.sheets) {
    if (next.sheets.size() == kMostSceneParts) break;
    // A sheet of area 0 would have no normal.
    const double area_mm2 = scene::length(scene::cross(each.half_width_mm, each.half_height_mm));
    if (near(each.centre_mm, each.radius_mm()) && area_mm2 > 0.0) next.sheets.push_back(each);
  }
  if (next == drawn) return false;
  markParts(tiles, shot);
  drawn = std::move(next);
  markParts(tiles, shot);
  struct Round {
    Float3 at;
    float radius = 0.0F;
  };
  const auto round = [&](Vec3 at_mm, double radius_mm) {
    return Round{floats(meshes.unitOf(at_mm)), static_cast<float>(radius_mm / meshes.radius_mm)};
  };
  attachKind(kSticks, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE, drawn.sticks.size(), [&](RTCGeometry geometry) {
    auto* ends = buffer<Round>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 2 * drawn.sticks.size());
    auto* first = buffer<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, drawn.sticks.size());
    if (ends == nullptr || first == nullptr) return;
    for (std::size_t i = 0; i < drawn.sticks.size(); ++i) {
      ends[2 * i] = round(drawn.sticks[i].from_mm, drawn.sticks[i].radius_mm);
      ends[2 * i + 1] = round(drawn.sticks[i].to_mm, drawn.sticks[i].radius_mm);
      first[i] = static_cast<std::uint32_t>(2 * i);
    }
  });
  attachKind(kBalls, RTC_GEOMETRY_TYPE_SPHERE_POINT, drawn.balls.size(), [&](RTCGeometry geometry) {
    auto* at = buffer<Round>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, drawn.balls.size());
    if (at == nullptr) return;
    for (std::size_t i = 0; i < drawn.balls.size(); ++i)
      at[i] = round(drawn.balls[i].centre_mm, drawn.balls[i].radius_mm);
  });
  attachKind(kDiscs, RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT, drawn.discs.size(), [&](RTCGeometry geometry) {
    auto* at = buffer<Round>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, drawn.discs.size());
    auto* normal = buffer<Float3>(geometry, RTC_BUFFER_TYPE_NORMAL, RTC_FORMAT_FLOAT3, drawn.discs.size());
    if (at == nullptr || normal == nullptr) return;
    for (std::size_t i = 0; i < drawn.discs.size(); ++i) {
      at[i] = round(drawn.discs[i].centre_mm, drawn.discs[i].radius_mm);
      normal[i] = floats(drawn.discs[i].normal);
    }
  });
  attachKind(kSheets, RTC_GEOMETRY_TYPE_QUAD, drawn.sheets.size(), [&](RTCGeometry geometry) {
    auto* corners = buffer<Float3>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 4 * drawn.sheets.size());
    auto* quads =
        buffer<std::array<std::uint32_t, 4>>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT4, drawn.sheets.size());
    if (corners == nullptr || quads == nullptr) return;
    for (std::size_t i = 0; i < drawn.sheets.size(); ++i) {
      const SceneSheet& sheet = drawn.sheets[i];
      const std::pair<double, double> at[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
      for (std::uint32_t c = 0; c < 4; ++c) {
        const auto& [across, along] = at[c];
        corners[4 * i + c] =
            floats(meshes.unitOf(sheet.centre_mm + across * sheet.half_width_mm + along * sheet.half_height_mm));
        quads[i][c] = static_cast<std::uint32_t>(4 * i) + c;
      }
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
  return all ? pixels : std::min(pixels, impl_->tiles.count() * SceneTiles::kTile_px * SceneTiles::kTile_px);
}

bool SceneCaster::cast(const SceneShot& shot, SceneFineness fineness, const std::function<bool()>& go_on) {
  Impl& d = *impl_;
  if (d.top == nullptr || shot.size_px.isEmpty()) return false;
  if (d.tiles.size() != shot.size_px) d.tiles.resize(shot.size_px);
  ScenePicture& p = picture_;
  if (!(shot == p.shot) || fineness != p.fineness) d.tiles.all();
  if (p.image.size() != shot.size_px) {
    p.image = QImage(shot.size_px, QImage::Format_RGB32);
    p.depth_mm.assign(static_cast<std::size_t>(shot.size_px.width()) * static_cast<std::size_t>(shot.size_px.height()),
                      kNoDepth);
  }
  p.shot = shot;
  p.fineness = fineness;
  p.rays = 0;
  SceneTiles with_parts;
  with_parts.resize(shot.size_px);
  with_parts.clear();
  d.markParts(with_parts, shot);
  const SceneRays rays(d.top, d.parts, *meshes_, d.placed, d.drawn, shot);
  const SceneCanvas canvas{reinterpret_cast<QRgb*>(p.image.bits()), p.depth_mm.data(), shot.size_px.width(),
                           shot.size_px.height()};
  constexpr int kTile = SceneTiles::kTile_px;
  for (int row = 0; row < d.tiles.rows(); ++row) {
    for (int column = 0; column < d.tiles.columns(); ++column) {
      if (!d.tiles.at(column, row)) continue;
      rays.castTile(canvas, fineness, column * kTile, row * kTile, with_parts.at(column, row));
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

double ScenePicture::depthAt(QPointF device_px) const {
  constexpr double kNothing = std::numeric_limits<double>::infinity();
  const int width = image.width();
  if (!(device_px.x() >= 0 && device_px.y() >= 0 && device_px.x() < width && device_px.y() < image.height())) {
    return kNothing;
  }
  const auto at = static_cast<std::size_t>(device_px.y()) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(device_px.x());
  return at < depth_mm.size() ? depth_mm[at] : kNothing;
}

}  // namespace fyd::widgets
