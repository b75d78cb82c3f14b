// Which robot a station is to have, read from the words an operator gives.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/protocol/endpoint.h"
#include "core/protocol/link_keys.h"

namespace fyd::station {

struct RobotChoice {
  bool in_process = false;                   ///< the simulated one, in a thread of this process
  std::string predictor = "default";         ///< how that one leads its arm, as device::followingNamed takes it
  std::string scene;                         ///< file of the scene that is felt in a robot's place; empty: none
  std::optional<protocol::Endpoint> listen;  ///< where the link listens; nothing: no robot
  std::optional<protocol::LinkKey> key;      ///< of FYD Link; nothing: the classic protocol
};

/// @param robot, key_file as in StationOptions. Reads the key file and opens nothing else.
/// @return an error that says what is wrong and what was expected
[[nodiscard]] Result<RobotChoice> readRobotChoice(std::string_view robot, const std::string& key_file);

}  // namespace fyd::station
