// The content of a scene file: bodies and gestures.
//
// TOML: [scene], any number of [[body]], and the gestures: [swords] with [fencing], [ball] with [serve], [palpation]
// with [plane]. A gesture is there if its first table is. Each table is a list of parameters (core/base/parameter.h),
// so that the reader, `fyd scene keys` and the manual's table are the same list.
// Stability: stable since 0.1
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/base/parameter.h"
#include "core/scene/gesture/ball.h"
#include "core/scene/gesture/palpation.h"
#include "core/scene/gesture/swords.h"
#include "core/scene/mesh/mesh_text.h"
#include "core/scene/soft/soft_material.h"

namespace fyd::scene {

/// How a body is touched. automatic: the cheapest that meets the scene's accuracy on this mesh; vicinity without one.
enum class ContactChoice : std::uint8_t { automatic, nodes, facet, vicinity, proxy };
inline constexpr std::array<std::string_view, 5> kContactChoices = {"automatic", "nodes", "facet", "vicinity", "proxy"};

struct SceneSettings {
  std::string name;
  std::string accuracy;

  template <class Visitor>
  void describe(Visitor& v) {
    v.text("scene.name", name, {.help = "For people; the file's when left out."});
    v.text("scene.accuracy", accuracy,
           {.help = "How far a force may be off, such as \"1%\": of bodies that name no contact model, the cheapest "
                    "that meets it on their mesh is taken."});
  }
};

struct BodyDescription {
  std::string name;
  std::string mesh;
  LengthUnit unit = LengthUnit::mm;
  ParameterList position_mm;
  ParameterList turned_deg;
  ParameterList velocity_mm_per_s;
  ContactChoice contact = ContactChoice::automatic;
  double stiffness_N_per_mm = 0.5;
  double damping_Ns_per_mm = 0.0;
  double static_friction = 0.0;
  double kinetic_friction = 0.0;
  double radius_mm = 0.0;
  double depth_mm = 0.0;
  std::string texture;
  bool soft = false;
  double mass_kg = 0.01;
  double viscosity_Ns_per_mm = 0.0;
  double spread_mm = 3.0;
  double finger_mm = 2.0;

  template <class Visitor>
  void describe(Visitor& v) {
    v.text("body.name", name, {.help = "For people; the mesh's when left out."});
    v.text("body.mesh", mesh, {.help = "OBJ, STL or PLY file, relative to the scene's."});
    v.choice("body.unit", unit, kLengthUnits, {.help = "Of the mesh's coordinates."});
    v.list("body.position_mm", position_mm,
           {.unit = "mm", .minimum = -1e6, .maximum = 1e6, .help = "Where the mesh's origin is: x, y, z."});
    v.list("body.turned_deg", turned_deg,
           {.unit = "°",
            .minimum = -360,
            .maximum = 360,
            .help = "How the mesh is turned: about x, then y, then z, which stand still."});
    v.list(
        "body.velocity_mm_per_s", velocity_mm_per_s,
        {.unit = "mm/s", .minimum = -1e6, .maximum = 1e6, .help = "How the body flies from the beginning: x, y, z."});
    v.choice("body.contact", contact, kContactChoices,
             {.help = "How it is touched; automatic: the cheapest that meets scene.accuracy, vicinity without one."});
    v.real("body.stiffness_N_per_mm", stiffness_N_per_mm,
           {.unit = "N/mm", .minimum = 1e-6, .maximum = 1e4, .help = "Force by depth."});
    v.real("body.damping_Ns_per_mm", damping_Ns_per_mm,
           {.unit = "N·s/mm", .minimum = 0, .maximum = 10, .help = "Force by speed along the normal; never a pull."});
    v.real("body.static_friction", static_friction,
           {.minimum = 0, .maximum = 5, .help = "Up to which share of the normal force a proxy sticks."});
    v.real("body.kinetic_friction", kinetic_friction,
           {.minimum = 0, .maximum = 5, .help = "Share of the normal force with which a sliding proxy is held."});
    v.real("body.radius_mm", radius_mm,
           {.unit = "mm",
            .minimum = 0,
            .maximum = 1000,
            .help = "Of the fingertip: of a proxy, 0 is a point; of nodes, 0 is three mean edges, at least 2 % of the "
                    "mesh's diagonal."});
    v.real(
        "body.depth_mm", depth_mm,
        {.unit = "mm",
         .minimum = 0,
         .maximum = 1e6,
         .help = "How deep nodes, facet, vicinity and a soft body act; 0: half of the mesh's diagonal, more than any "
                 "point within has, of a soft body 1000 mm."});
    v.text("body.texture", texture,
           {.help = "Stored surface that shakes a finger sliding over it: a file, relative to the scene's."});
    v.boolean("body.soft", soft,
              {.help = "Whether it is deformed: its vertices are material points, stiffness_N_per_mm is that of a slow "
                       "press on a wide flat piece, and contact, friction and damping are its own."});
    v.real("body.mass_kg", mass_kg,
           {.unit = "kg", .minimum = 0, .maximum = 1e6, .help = "Of a soft body's whole surface, spread evenly."});
    v.real("body.viscosity_Ns_per_mm", viscosity_Ns_per_mm,
           {.unit = "N·s/mm",
            .minimum = 0,
            .maximum = 1e6,
            .help = "Of a soft body: force by speed that is added while a press moves."});
    v.real("body.spread_mm", spread_mm,
           {.unit = "mm",
            .minimum = 0,
            .maximum = 1e6,
            .help = "Of a soft body: beyond the finger, displacement falls to a third in about this length."});
    v.real("body.finger_mm", finger_mm,
           {.unit = "mm",
            .minimum = 1e-6,
            .maximum = 1e6,
            .help = "Radius of the patch with which a soft body is pressed; at least three mean edges."});
  }
};

struct SceneDescription {
  SceneSettings settings;
  std::optional<double> accuracy;  ///< a share, of settings.accuracy
  std::vector<BodyDescription> bodies;
  std::optional<SwordParameters> swords;
  FencingParameters fencing;
  std::optional<BallParameters> ball;
  ServeParameters serve;
  std::optional<PalpationParameters> palpation;
  PlaneParameters plane;  ///< felt by a probe of a scene without a body
};

/// Of a soft body.
[[nodiscard]] inline SoftMaterial materialOf(const BodyDescription& body) {
  return {.mass_kg = body.mass_kg,
          .rigidity_N_per_mm = body.stiffness_N_per_mm,
          .viscosity_Ns_per_mm = body.viscosity_Ns_per_mm,
          .spread_mm = body.spread_mm,
          .finger_mm = body.finger_mm};
}

/// @param source_name stands before the line number in messages
/// @return an error with source name and line: not TOML, an unknown table or key, a wrong type, a value out of range, a
/// scene without anything to touch
[[nodiscard]] FYD_API Result<SceneDescription> parseScene(std::string_view text, std::string_view source_name);

}  // namespace fyd::scene
