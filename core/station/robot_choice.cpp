#include "core/station/robot_choice.h"

#include "core/device/robot/touch_reference.h"
#include "core/protocol/link/link_key_file.h"

namespace fyd::station {
namespace {

constexpr std::string_view kSimulatedRobot = "simulated";
constexpr std::string_view kSimulatedPrefix = "simulated:";
constexpr std::string_view kScenePrefix = "scene:";
constexpr std::string_view kClassicPrefix = "classic:";
constexpr std::string_view kLinkPrefix = "link:";
constexpr std::string_view kSimulatedRobotEndpoint = "127.0.0.1:0";

}  // namespace

Result<RobotChoice> parseRobotChoice(std::string_view robot, const std::string& key_file) {
  const bool scene = robot.starts_with(kScenePrefix);
  const bool in_process = robot == kSimulatedRobot || robot.starts_with(kSimulatedPrefix);
  const bool classic = robot.starts_with(kClassicPrefix);
  const bool secured = robot.starts_with(kLinkPrefix);
  if (!in_process && !scene && !classic && !secured && robot != "none") {
    return fail("robot '{}': expected simulated, scene:FILE, none, link:HOST:PORT or classic:HOST:PORT", robot);
  }
  if (secured != !key_file.empty()) {
    return secured ? fail("robot '{}': FYD Link needs a key file; fyd link keygen makes one", robot)
                   : fail("robot '{}': takes no key file; only link:HOST:PORT does", robot);
  }
  RobotChoice choice{.in_process = in_process};
  if (scene) choice.scene = robot.substr(kScenePrefix.size());
  if (robot.starts_with(kSimulatedPrefix)) choice.predictor = robot.substr(kSimulatedPrefix.size());
  if (auto known = device::followingNamed(choice.predictor); !known) return tl::unexpected(known.error());
  if (scene || robot == "none") return choice;
  std::string_view address = kSimulatedRobotEndpoint;
  if (classic) address = robot.substr(kClassicPrefix.size());
  if (secured) address = robot.substr(kLinkPrefix.size());
  auto endpoint = protocol::parseEndpoint(address);
  if (!endpoint) return tl::unexpected(endpoint.error());
  choice.listen = *endpoint;
  return choice;
}

Result<RobotChoice> readRobotChoice(std::string_view robot, const std::string& key_file) {
  auto choice = parseRobotChoice(robot, key_file);
  if (!choice || key_file.empty()) return choice;
  auto key = protocol::readKeyFile(key_file);
  if (!key) return tl::unexpected(key.error());
  choice->key = *key;
  return choice;
}

}  // namespace fyd::station
