#include "widgets/scene/scene_rays.h"

#include <algorithm>
#include <cmath>

namespace fyd::widgets {
namespace {

constexpr int kPacket = 4;         // 4 × 4 rays
constexpr float kAmbient = 0.35F;  // of the light, from everywhere
constexpr float kBand = 0.6F;      // dark bands of a stick of the far end, and of an inside
constexpr int kBands = 12;
// Direction to the light in picture coordinates: from the left, above and behind the viewer.
constexpr double kLightRight = -0.40, kLightUp = 0.50, kLightBack = 0.77;

/// Where in its pixel each of the four samples lies, in pixels from the middle: a turned square.
constexpr float kSampleAt[4][2] = {{-0.125F, -0.375F}, {0.375F, -0.125F}, {0.125F, 0.375F}, {-0.375F, 0.125F}};

Float3 operator*(float s, Float3 a) { return {s * a.x, s * a.y, s * a.z}; }
Float3 operator+(Float3 a, Float3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
float dot(Float3 a, Float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Float3 colourOf(const QColor& c) {
  return {static_cast<float>(c.redF()) * 255.0F, static_cast<float>(c.greenF()) * 255.0F,
          static_cast<float>(c.blueF()) * 255.0F};
}

/// Brightness of a surface: ambient plus Lambert's cosine law.
float bright(Float3 normal, Float3 light, bool from_behind) {
  const float lit = dot(normal, light) / std::sqrt(dot(normal, normal));
  return kAmbient + (1.0F - kAmbient) * std::max(0.0F, from_behind ? -lit : lit);  // 0 for no number
}

QRgb rgb(Float3 c) {
  const auto byte = [](float v) { return static_cast<int>(std::clamp(v + 0.5F, 0.0F, 255.0F)); };
  return qRgb(byte(c.x), byte(c.y), byte(c.z));
}

}  // namespace

std::vector<Vec3> cornersOf(RTCScene scene) {
  RTCBounds box{};
  rtcGetSceneBounds(scene, &box);
  std::vector<Vec3> out;
  for (int corner = 0; corner < 8 && box.lower_x <= box.upper_x; ++corner) {
    out.push_back({(corner & 1) != 0 ? box.upper_x : box.lower_x, (corner & 2) != 0 ? box.upper_y : box.lower_y,
                   (corner & 4) != 0 ? box.upper_z : box.lower_z});
  }
  return out;
}

SceneRays::SceneRays(RTCScene top, RTCScene parts_scene, const SceneMeshes& meshes,
                     const std::vector<ScenePlacement>& placed, const SceneParts& parts, const SceneShot& shot)
    : top_(top), parts_scene_(parts_scene), parts_(parts), radius_mm_(meshes.radius_mm) {
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
  // Rays begin in front of the nearest corner of the scene.
  const Vec3 target = meshes.unitOf(camera.target_mm());
  double nearest = 0.0;
  for (RTCScene each : {top, parts_scene}) {
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

void SceneRays::packet(float x, float y, float step, bool with_parts, std::array<Float3, 16>& colour,
                       std::array<float, 16>& depth_mm) const {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): what Embree reads is written below
  alignas(64) RTCRayHit16 rays;
  alignas(64) int valid[16];
  for (int i = 0; i < 16; ++i) {
    const int column = i % kPacket, row = i / kPacket;
    const float a = x + step * static_cast<float>(column), b = y + step * static_cast<float>(row);
    valid[i] = -1;
    rays.ray.org_x[i] = corner_.x + a * across_.x + b * down_.x;
    rays.ray.org_y[i] = corner_.y + a * across_.y + b * down_.y;
    rays.ray.org_z[i] = corner_.z + a * across_.z + b * down_.z;
    rays.ray.dir_x[i] = forward_.x;
    rays.ray.dir_y[i] = forward_.y;
    rays.ray.dir_z[i] = forward_.z;
    rays.ray.tnear[i] = 0.0F;
    rays.ray.tfar[i] = kNoDepth;
    rays.ray.time[i] = 0.0F;
    rays.ray.mask[i] = 0xffffffff;
    rays.ray.flags[i] = 0;
    rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, top_, &context, &rays);
  if (with_parts) rtcIntersect16(valid, parts_scene_, &context, &rays);  // hits parts that are nearer than the bodies
  for (int i = 0; i < 16; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) {
      colour[k] = ground_;
      depth_mm[k] = kNoDepth;
      continue;
    }
    depth_mm[k] = static_cast<float>((near_ + static_cast<double>(rays.ray.tfar[i])) * radius_mm_);
    const int column = i % kPacket, row = i / kPacket;
    const float a = x + step * static_cast<float>(column), b = y + step * static_cast<float>(row);
    colour[k] = shade(rays.hit, i, (static_cast<int>(a + b) / 3) % 2 == 0);
  }
}

SceneRole SceneRays::roleOf(unsigned kind, std::size_t which) const {
  switch (kind) {
    case kSticks: return parts_.sticks[which].role;
    case kBalls: return parts_.balls[which].role;
    case kDiscs: return parts_.discs[which].role;
    default: return parts_.sheets[which].role;
  }
}

Float3 SceneRays::shade(const RTCHit16& hit, int i, bool hatch) const {
  const Float3 normal{hit.Ng_x[i], hit.Ng_y[i], hit.Ng_z[i]};
  if (const unsigned body = hit.instID[0][i]; body != RTC_INVALID_GEOMETRY_ID) {
    const Look& look = looks_[body];
    const bool from_inside = dot(normal, look.forward) > 0.0F;
    const float share = bright(normal, look.light, from_inside) * (from_inside && hatch ? kBand : 1.0F);
    return share * (from_inside ? inside_ : outside_)[look.role];
  }
  const unsigned kind = hit.geomID[i], which = hit.primID[i];
  const SceneRole role = roleOf(kind, which);
  const bool dark = kind == kSticks && role == SceneRole::other && static_cast<int>(hit.u[i] * kBands) % 2 == 1;
  const float share = bright(normal, light_, dot(normal, forward_) > 0.0F) * (dark ? kBand : 1.0F);
  return share * outside_[static_cast<std::size_t>(role)];
}

void SceneRays::castTile(const SceneCanvas& canvas, SceneFineness fineness, int left, int top, bool with_parts) const {
  const int block = fineness.block;
  const auto step = static_cast<float>(block);
  std::array<Float3, 16> colour, sum;
  std::array<float, 16> depth{}, nearest{};
  for (int y0 = top; y0 < std::min(canvas.height, top + SceneTiles::kTile_px); y0 += kPacket * block) {
    for (int x0 = left; x0 < std::min(canvas.width, left + SceneTiles::kTile_px); x0 += kPacket * block) {
      const auto x = static_cast<float>(x0), y = static_cast<float>(y0);
      if (fineness.samples == 1) {
        packet(x + 0.5F * step, y + 0.5F * step, step, with_parts, sum, nearest);
      } else {
        sum.fill({});
        nearest.fill(kNoDepth);
        for (const auto& at : kSampleAt) {
          packet(x + 0.5F + at[0], y + 0.5F + at[1], step, with_parts, colour, depth);
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

}  // namespace fyd::widgets
