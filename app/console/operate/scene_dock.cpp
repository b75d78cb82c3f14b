#include "app/console/operate/scene_dock.h"

#include "core/pipeline/touch_motion.h"
#include "core/scene/scene_stage.h"
#include "core/sim/finger_path.h"

namespace fyd::console {
namespace {

using widgets::SceneRole;

constexpr double kFloor_mm = 150.0;  ///< radius drawn of a court or a plane, which is infinite
constexpr double kRim_mm = 6.0;      ///< margin at the cloth's rim, where the camera sees only a part of the finger

std::vector<widgets::SceneBody> bodiesOf(const scene::LoadedScene& file) {
  std::vector<widgets::SceneBody> out;
  for (std::size_t i = 0; i < file.meshes.size(); ++i) {
    const scene::BodyDescription& body = file.description.bodies[i];
    const scene::Mesh& mesh = file.meshes[i]->mesh;
    out.push_back({.name = QString::fromStdString(body.name.empty() ? body.mesh : body.name),
                   .vertices_mm = mesh.vertices(),
                   .triangles = mesh.triangles(),
                   .role = body.soft ? SceneRole::soft : SceneRole::rigid});
  }
  return out;
}

widgets::ScenePlacement placementAt(const scene::Placement& body, double time_s) {
  return {.origin_mm = body.toScene({}, time_s),
          .x_axis = body.turned({1.0, 0.0, 0.0}),
          .y_axis = body.turned({0.0, 1.0, 0.0}),
          .z_axis = body.turned({0.0, 0.0, 1.0})};
}

void addDisc(std::vector<widgets::SceneDisc>& to, const Vec3& centre_mm, const Vec3& normal, double radius_mm,
             SceneRole role) {
  widgets::SceneDisc& disc = to.emplace_back();
  disc.centre_mm = centre_mm;
  disc.normal = normal;
  disc.radius_mm = radius_mm;
  disc.role = role;
}

widgets::SceneParts partsOf(const scene::SceneStage& stage, const scene::SceneMoment& now) {
  const scene::SceneDescription& described = stage.scene().description;
  widgets::SceneParts out;
  for (const scene::Placement& body : stage.placements()) out.placements.push_back(placementAt(body, now.time_s));
  if (now.swords && now.swords->known) {
    const double radius_mm = described.swords->radius_mm;
    const auto stick = [&](const scene::Blade& blade, SceneRole role) {
      out.sticks.push_back({blade.grip_mm, blade.tip_mm, radius_mm, role});
    };
    stick(now.swords->local, SceneRole::own);
    stick(now.swords->distant, SceneRole::other);
  }
  if (now.ball) {
    const scene::BallParameters& game = *described.ball;
    out.balls.push_back({now.ball->ball.position_mm, game.radius_mm});
    if (now.ball->racket_known) {
      const scene::RacketPose& racket = now.ball->racket;
      const double half_width_mm = game.racket_width_mm / 2.0;
      if (game.racket_shape == scene::RacketShape::disc) {
        addDisc(out.discs, racket.centre_mm, racket.normal, half_width_mm, SceneRole::own);
      } else {
        out.sheets.push_back(
            {.centre_mm = racket.centre_mm,
             .half_width_mm = half_width_mm * racket.along,
             .half_height_mm = (game.racket_height_mm / 2.0) * scene::cross(racket.normal, racket.along)});
      }
    }
    if (game.court) {
      addDisc(out.discs, {described.serve.x_mm, described.serve.y_mm, game.court_z_mm}, {0.0, 0.0, 1.0}, kFloor_mm,
              SceneRole::rigid);
    }
  }
  if (described.palpation && described.bodies.empty()) {
    const scene::PlaneParameters& plane = described.plane;
    addDisc(out.discs, {plane.x_mm, plane.y_mm, plane.z_mm}, {plane.normal_x, plane.normal_y, plane.normal_z},
            kFloor_mm, SceneRole::rigid);
  }
  return out;
}

widgets::SceneState stateOf(const scene::SceneStage& stage, const scene::SceneMoment& now) {
  widgets::SceneState out;
  out.parts = partsOf(stage, now);
  if (!now.stepped) return out;
  out.point_mm = now.point_mm;
  if (!now.touch.touching) return out;
  out.proxy_mm = now.touch.proxy_mm;
  out.force_N = now.touch.force_N;
  return out;
}

/// The finger position that puts the haptic point there: inverse of the mapping with pipeline::kRobotTravelForDepth.
sim::FingerState fingerFor(const Vec3& point_mm) {
  return {.x_mm = point_mm.x, .y_mm = point_mm.y, .indentation_mm = -point_mm.z / pipeline::kRobotTravelForDepth};
}

/// The region of the haptic point that the simulated finger can reach.
widgets::SceneBox reachOfFinger() {
  const double x_mm = sim::kUsableHalfWidth_mm - kRim_mm, y_mm = sim::kUsableHalfDepth_mm - kRim_mm;
  widgets::SceneBox out;
  out.add(Vec3{-x_mm, -y_mm, -pipeline::kRobotTravelForDepth * sim::kDeepestPress_mm});
  out.add(Vec3{x_mm, y_mm, 0.0});
  return out;
}

}  // namespace

SceneDock::SceneDock(QWidget* parent) : SceneDock(new widgets::SceneView, parent) {}

SceneDock::SceneDock(widgets::SceneView* view, QWidget* parent)
    : SideDock(tr("Scene"), QStringLiteral("scene_close"), tr("Close the scene's panel"), view, parent), view_(view) {
  connect(view_, &widgets::SceneView::pointDriven, this, [this](const Vec3& point_mm) {
    const sim::FingerState finger = fingerFor(point_mm);
    emit fingerMoved(finger.x_mm, finger.y_mm, finger.indentation_mm);
  });
  connect(view_, &widgets::SceneView::pointReleased, this, &SceneDock::fingerReleased);
  connect(&preparing_, &Background::failed, view_, &widgets::SceneView::setEmptyText);
  prepare();
}

void SceneDock::prepare() {
  view_->setBodies({});
  if (!stage_) {
    preparing_.cancel();
    view_->setEmptyText(
        tr("No scene stands where the robot stands. Choose a scene file as the robot, in the link's panel, or start "
           "with --robot scene:FILE."));
    return;
  }
  view_->setEmptyText(tr("The scene is being prepared."));
  preparing_.run([this, stage = stage_](const std::stop_token&) -> Background::Finish {
    return [this, meshes = widgets::SceneMeshes::of(bodiesOf(stage->scene()))] { view_->setMeshes(meshes); };
  });
}

void SceneDock::setTouchable(bool on) {
  touchable_ = on;
  view_->setDrivable(touchable_ && stage_ != nullptr, reachOfFinger());
}

void SceneDock::showScene(const std::shared_ptr<scene::SceneStage>& stage) {
  if (!looked_ || stage != stage_) {
    looked_ = true;
    stage_ = stage;
    view_->setState({});
    prepare();
    view_->setDrivable(touchable_ && stage != nullptr, reachOfFinger());
    setVisible(stage != nullptr);
  }
  if (!stage || !view_->isVisible()) return;
  const scene::SceneMoment& now = stage->newest();
  // The view fits the first state that it is shown: swords and ball are there from the second step on.
  const scene::SceneDescription& described = stage->scene().description;
  if ((described.swords || described.ball) && !(now.time_s > 0.0)) return;
  for (std::size_t i = 0; i < now.shapes_mm.size(); ++i) {
    if (!now.shapes_mm[i].empty()) view_->setShape(i, now.shapes_mm[i]);
  }
  view_->setState(stateOf(*stage, now));
}

}  // namespace fyd::console
