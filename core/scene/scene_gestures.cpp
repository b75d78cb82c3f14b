#include "core/scene/scene_gestures.h"

#include "core/base/portable_math.h"
#include "core/scene/mesh/vector.h"

namespace fyd::scene {
namespace {

/// Adds a force. Proxy, normal, depth and stiffness become those of the larger force.
void add(SceneTouch& touch, const Vec3& force_N, const Vec3& proxy_mm, const Vec3& normal, double depth_mm,
         double stiffness_N_per_mm) {
  const bool larger = !touch.touching || length(force_N) > length(touch.force_N);
  touch.force_N = touch.force_N + force_N;
  if (!larger) return;
  touch = {.touching = true,
           .force_N = touch.force_N,
           .proxy_mm = proxy_mm,
           .normal = normal,
           .depth_mm = depth_mm,
           .stiffness_N_per_mm = stiffness_N_per_mm,
           .body = kNoBody};
}

}  // namespace

SceneGestures::SceneGestures(const SceneDescription& description)
    : fencing_(description.fencing), plane_(description.plane) {
  if (description.swords) {
    sword_ = *description.swords;
    swords_.emplace();
  }
  if (description.ball) {
    ball_game_ = *description.ball;
    const ServeParameters& serve = description.serve;
    served_ = {.position_mm = {serve.x_mm, serve.y_mm, serve.z_mm},
               .velocity_mm_per_s = {serve.x_mm_per_s, serve.y_mm_per_s, serve.z_mm_per_s},
               .spin_rad_per_s = {}};
    ball_.emplace().ball = served_;
  }
  if (description.palpation) {
    palpation_ = *description.palpation;
    palpating_.emplace();
  }
}

void SceneGestures::step(const Vec3& probe_mm, double dt_s, bool with_bodies, SceneTouch& touch) {
  if (swords_) fence(probe_mm, dt_s, touch);
  if (ball_) play(probe_mm, dt_s, touch);
  if (palpating_) palpate(probe_mm, dt_s, with_bodies, touch);
}

void SceneGestures::fence(const Vec3& probe_mm, double dt_s, SceneTouch& touch) {
  const Vec3 along_mm = sword_.length_mm * Vec3{math::cos(kBladesRise_rad), 0.0, math::sin(kBladesRise_rad)};
  const auto sword = [&](const Vec3& device_mm) {
    const Vec3 grip = fencing_.scale * device_mm;
    return Blade{grip, grip + along_mm};
  };
  const Blade other = seenByTheOther(fencing_, sword({}));
  const SwordTouch felt = stepSwords(sword_, *swords_, sword(probe_mm), other, dt_s);
  if (!felt.touching) return;
  // The swords move `scale` times as far as the haptic point, which is what feels the force.
  const double depth_mm = felt.depth_mm / fencing_.scale;
  add(touch, felt.force_N, probe_mm + depth_mm * felt.normal, felt.normal, depth_mm,
      fencing_.scale * sword_.stiffness_N_per_mm);
}

void SceneGestures::play(const Vec3& probe_mm, double dt_s, SceneTouch& touch) {
  RacketPose racket;
  racket.centre_mm = probe_mm;
  const BallStep felt = stepBall(ball_game_, *ball_, racket, dt_s);
  if (felt.rest == BallRest::on_court) {
    ball_->ball = served_;
    ball_->rest = BallRest::flies;
  }
  // A ball gives an impulse, no depth: depth and stiffness are reported as 0.
  if (length(felt.force_N) > 0.0) add(touch, felt.force_N, felt.point_mm, unit(felt.force_N), 0.0, 0.0);
}

void SceneGestures::palpate(const Vec3& probe_mm, double dt_s, bool with_bodies, SceneTouch& touch) {
  PalpationInputs inputs{.probe_mm = probe_mm, .touch = {}, .measured_N = {}};
  if (!with_bodies) {
    inputs.touch = touchPlane(palpation_, plane_, probe_mm);
  } else if (touch.touching) {
    inputs.touch = {.normal = touch.normal, .depth_mm = touch.depth_mm, .stiffness_N_per_mm = touch.stiffness_N_per_mm};
    inputs.measured_N = dot(touch.force_N, touch.normal);
  }
  palpated_ = stepPalpation(palpation_, *palpating_, inputs, dt_s);
  if (with_bodies) {  // the bodies' normal force is already in touch.force_N: what is beyond the limit goes
    const double beyond_N = inputs.measured_N.value_or(0.0) - palpation_.most_force_N;
    if (beyond_N > 0.0) touch.force_N = touch.force_N - beyond_N * touch.normal;
    touch.force_N = touch.force_N + palpated_->tangential_N;
  } else if (palpated_->touching) {
    const Vec3 normal = unit(inputs.touch.normal);
    add(touch, palpated_->force_N, probe_mm + inputs.touch.depth_mm * normal, normal, inputs.touch.depth_mm,
        inputs.touch.stiffness_N_per_mm);
  }
}

}  // namespace fyd::scene
