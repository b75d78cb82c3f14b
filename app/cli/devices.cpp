// fyd devices: what is plugged in, what answers, and why something does not.
#include <algorithm>
#include <iostream>
#include <thread>

#include "app/cli/parts/command.h"
#include "app/cli/parts/profile_options.h"
#include "core/device/camera/camera_source.h"
#include "core/device/device_list.h"
#include "core/device/touchpad/modbus_touchpad.h"
#include "core/device/touchpad/qbmove_motors.h"
#include "core/device/touchpad/touchpad_source.h"
#include "core/protocol/registers/register_map.h"

namespace fyd::cli {
namespace {

struct DevicesOptions {
  std::vector<std::string> touchpads;
  std::vector<std::string> motors;
  std::vector<std::string> cameras;
  ProfileOptions profile;
  bool map = false;
  bool json = false;
};

struct Answer {
  std::string address;
  Message description;
  bool answers = true;
  Message problem;  ///< why it does not answer, or what it complains of; may be empty
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
};

device::ModbusAddress addressOrUsageError(const std::string& text) {
  auto address = device::parseModbusAddress(text);
  if (!address) throw UsageError(say("--touchpad {}", address.error().message));
  return std::move(*address);
}

/// One exchange with the motors off.
Answer askTouchpad(const std::string& text, const device::ModbusAddress& address,
                   const device::DeviceParameters& parameters) {
  device::ModbusTouchpad touchpad(address, parameters);
  Answer out{.address = text};
  const auto readings = touchpad.exchange({}, Clock::now());
  out.description = touchpad.description();
  if (!readings) {
    out.answers = false;
    out.problem = readings.error().message;
    return out;
  }
  const protocol::DeviceState& state = touchpad.state();
  out.problem = touchpad.complaint();
  out.values["ir_counts"] = state.ir;
  out.values["bridge_mV_per_V"] = jsonNumber(state.bridge_mV_per_V);
  out.values["encoder_counts"] = state.motors.encoder_counts;
  out.values["motor_temperature_degC"] = state.temperature_degC;
  const auto drive = protocol::driveStateOf(state.status_word);
  out.values["motors"] = drive ? toString(*drive) : "?";
  out.values["status_word"] = protocol::statusInWords(state.status_word);
  return out;
}

Answer askMotors(const std::string& text, const device::DeviceParameters& parameters) {
  const auto motors = valueOrFail(device::openMotorBoard(text, parameters));
  Answer out{.address = text, .description = motors->description()};
  const auto feedback = motors->exchange({});
  if (!feedback) {
    out.answers = false;
    out.problem = feedback.error().message;
    return out;
  }
  out.values["encoder_counts"] = feedback->encoder_counts;
  out.values["current_mA"] = feedback->current_mA;
  return out;
}

/// Takes one picture, and tells whether the profile's camera controls were set.
Answer askCamera(const std::string& source, const device::DeviceParameters& parameters) {
  Answer out{.address = source};
  const auto camera = device::openCamera(source, parameters);
  const auto frame = camera ? (*camera)->next() : fail(camera.error().message);
  if (camera) out.description = (*camera)->description();
  if (!frame) {
    out.answers = false;
    out.problem = frame.error().message;
    return out;
  }
  out.values["picture"] = fmt::format("{} × {}", frame->picture.cols, frame->picture.rows);
  for (const device::CameraControl& control : (*camera)->controls()) out.values[control.name.text()] = control.words;
  return out;
}

nlohmann::ordered_json foundJson(const std::vector<device::FoundDevice>& found) {
  auto out = nlohmann::ordered_json::array();
  for (const device::FoundDevice& device : found) {
    out.push_back({{"path", device.path}, {"node", device.node}, {"name", device.name}, {"problem", device.problem}});
  }
  return out;
}

void printFound(const char* what, const std::vector<device::FoundDevice>& found) {
  if (found.empty()) std::cout << fmt::format("{:<16} none\n", what);
  for (const device::FoundDevice& device : found) {
    std::cout << fmt::format("{:<16} {}{}{}\n", what, device.path, device.name.empty() ? "" : "  " + device.name,
                             device.problem.empty() ? "" : "\n                 " + device.problem.text());
  }
}

void runDevices(DevicesOptions& options) {
  if (options.map) {
    std::cout << protocol::registerMapMarkdown();
    return;
  }
  const device::DeviceParameters parameters = options.profile.load().device;
  // All words are judged before the first device is asked.
  std::vector<device::ModbusAddress> addresses;
  for (const std::string& text : options.touchpads) addresses.push_back(addressOrUsageError(text));
  for (const std::string& text : options.motors) {
    if (const auto good = device::checkMotorsName(text); !good)
      throw UsageError(about("--motors", good.error().message));
  }
  const auto ports = device::findSerialPorts();
  const auto cameras = device::findCaptureDevices();
  std::vector<Answer> answers;
  answers.reserve(addresses.size() + options.motors.size() + options.cameras.size());
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    answers.push_back(askTouchpad(options.touchpads[i], addresses[i], parameters));
  }
  for (const std::string& text : options.motors) answers.push_back(askMotors(text, parameters));
  for (const std::string& source : options.cameras) answers.push_back(askCamera(source, parameters));

  nlohmann::ordered_json json = {
      {"serial_ports", foundJson(ports)}, {"cameras", foundJson(cameras)}, {"asked", nlohmann::ordered_json::array()}};
  for (const Answer& answer : answers) {
    json["asked"].push_back({{"address", answer.address},
                             {"answers", answer.answers},
                             {"description", answer.description},
                             {"problem", answer.problem},
                             {"values", answer.values}});
  }
  if (options.json) {
    printJson(json);
  } else {
    printFound("serial port", ports);
    printFound("camera", cameras);
    for (const Answer& answer : answers) {
      std::cout << fmt::format("{:<16} {}  {}\n", "asked", answer.address,
                               answer.answers ? answer.description : say("no: {}", answer.problem));
      if (answer.answers && !answer.problem.empty()) {
        std::cout << fmt::format("                 {:<24} {}\n", "complains", answer.problem);
      }
      for (const auto& [key, value] : answer.values.items()) {
        std::cout << fmt::format("                 {:<24} {}\n", key, textOf(value));
      }
    }
  }
  if (!std::ranges::all_of(answers, &Answer::answers)) throw Failure(say("not every device that was asked answers"));
  if (!std::ranges::all_of(answers, [](const Answer& each) { return each.problem.empty(); })) {
    throw Failure(say("a device that was asked answers with a complaint"));
  }
}

}  // namespace

void add_devices(CLI::App& app) {
  auto options = std::make_shared<DevicesOptions>();
  CLI::App* command = app.add_subcommand("devices", "Serial ports, cameras and touchpads: what answers and what not");
  command->add_option("--touchpad", options->touchpads,
                      "Ask this one, modbus-tcp:HOST:PORT or modbus-rtu:TTY[:BAUD]; its motors stay off; repeatable");
  command->add_option("--motors", options->motors, "Ask this motor board, qbmove:TTY; its motors stay off; repeatable");
  command->add_option("--camera", options->cameras, "Ask this camera for one picture; repeatable");
  auto* map = command->add_flag("--map", options->map, "Print the touchpad's register map as Markdown and end");
  options->profile.addTo(*command);
  command->add_flag("--json", options->json, "Result as JSON")->excludes(map);
  command->callback([options] { runDevices(*options); });
}

}  // namespace fyd::cli
