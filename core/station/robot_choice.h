// Which robot a station uses, parsed from the operator's --robot option.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/protocol/endpoint.h"
#include "core/protocol/link/link_keys.h"

namespace fyd::station {

struct RobotChoice {
  bool in_process = false;                   ///< the simulated one, in a thread of this process
  std::string predictor = "default";         ///< how that one leads its arm; a name that device::followingNamed knows
  std::string scene;                         ///< file of the scene that is touched instead of a robot; empty: none
  std::optional<protocol::Endpoint> listen;  ///< where the link listens; nothing: no robot
  std::optional<protocol::LinkKey> key;      ///< of FYD Link; nothing: the classic protocol
};

/// @param robot, key_file as in StationOptions. Reads the key file and opens nothing else.
/// @return an error that says what is wrong and what was expected
[[nodiscard]] Result<RobotChoice> readRobotChoice(std::string_view robot, const std::string& key_file);
/// The same without the key, from the words alone.
[[nodiscard]] Result<RobotChoice> parseRobotChoice(std::string_view robot, const std::string& key_file);

}  // namespace fyd::station
