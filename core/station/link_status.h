// What the operator sees of the link to the robot.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/message.h"
#include "core/base/vec3.h"
#include "core/pipeline/inputs.h"
#include "core/protocol/link/described_scene.h"
#include "core/protocol/touchpad_end.h"

namespace fyd::station {

/// How a robot end leads its arm.
struct PredictedArm {
  std::string predictor;
  Vec3 arrived_mm;          ///< target from the newest touch alone, without prediction
  Vec3 target_mm;           ///< where the arm is led
  double error_mm = 0.0;    ///< RMS over about a second: predicted against later measured finger
  double horizon_ms = 0.0;  ///< predicted, from the newest picture
};

struct LinkStatus {
  Message protocol;      ///< "FYD Link, sealed", "classic, not secured", "scene NAME", "none"
  bool secured = false;  ///< authenticated and encrypted
  std::string local;     ///< address this end listens on
  std::string peer;      ///< empty before the first
  std::uint64_t states_received = 0;
  std::uint64_t touches_sent = 0;
  std::uint64_t refused = 0;        ///< datagrams counted and ignored
  std::uint64_t send_failures = 0;  ///< replies that could not be sent
  std::uint64_t samples_lost = 0;   ///< accelerations and commands the loop did not take in time
  pipeline::LinkPhase phase = pipeline::LinkPhase::none;
  protocol::SceneCopies scenes = protocol::SceneCopies::none;  ///< this end's beside the robot's
  protocol::LinkFigures figures;                               ///< round trip, jitter, loss, refusals by reason
  std::optional<PredictedArm> led;  ///< of the simulated robot in this process; others do not report it
};

}  // namespace fyd::station
