// fyd sim touchpad: the touchpad as its own process, behind the protocols of a real one.
#include <filesystem>
#include <iostream>
#include <thread>

#include "app/cli/parts/command.h"
#include "app/cli/sim/sim_touchpad.h"
#include "core/base/end_signals.h"
#include "core/device/serial_port.h"
#include "core/device/touchpad/modbus_link.h"
#include "core/protocol/registers/register_map.h"
#include "core/sim/gesture_card.h"
#include "core/sim/server/touchpad_process.h"

namespace fyd::cli {
namespace {

struct SimTouchpadOptions {
  std::string modbus_tcp;
  std::string camera_mjpeg;
  std::string serial;  ///< empty: its usual one
  std::string finger;
  std::vector<std::string> faults;
  sim::TouchpadProcessOptions process;
  double duration_s = 0.0;
  bool print_map = false;
  bool json = false;
};

std::optional<protocol::Endpoint> endpoint(const char* option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  auto parsed = protocol::parseEndpoint(text);
  if (!parsed) throw UsageError(about(option, parsed.error().message));
  return *parsed;
}

/// Check of an option.
std::string speedOfAPort(const std::string& text) {
  int baud = 0;
  if (CLI::detail::lexical_cast(text, baud) && device::speedConstant(baud) != B0) return {};
  return fmt::format("{}: no speed in baud that a serial port of this system has, such as 115200", text);
}

void reportSimTouchpad(const SimTouchpadOptions& options, const sim::TouchpadProcess& process, double seconds) {
  const auto figures = process.electronics().figures();
  const nlohmann::ordered_json json = {{"served", process.addresses()},
                                       {"seconds", seconds},
                                       {"modbus_requests", figures.modbus_requests},
                                       {"refused_writes", figures.refused_writes},
                                       {"motor_board_frames", figures.motor_board_frames},
                                       {"pictures", process.pictures()},
                                       {"restarts", figures.restarts},
                                       {"drive_state", protocol::toString(figures.drive)},
                                       {"drive_fault", protocol::toString(figures.fault)},
                                       {"motors_on", figures.motors_on},
                                       {"motors_on_s", figures.motors_on_s},
                                       {"vibration_peak_percent", figures.vibration_peak_percent},
                                       {"motor_temperature_degC", figures.temperature_degC}};
  printValues(json, options.json);
}

void runSimTouchpad(SimTouchpadOptions& options) {
  if (options.print_map) {
    std::cout << protocol::registerMapMarkdown();
    return;
  }
  if (!options.serial.empty()) options.process.registers = sim::RegisterBank(options.serial);
  options.process.modbus_tcp = endpoint("--modbus-tcp", options.modbus_tcp);
  options.process.camera_mjpeg = endpoint("--camera-mjpeg", options.camera_mjpeg);
  const bool served = options.process.modbus_tcp || options.process.camera_mjpeg ||
                      !options.process.modbus_rtu.empty() || !options.process.qbmove.empty();
  if (!served)
    throw UsageError(say("sim touchpad: expected one of --modbus-tcp, --modbus-rtu, --qbmove, --camera-mjpeg"));
  const auto place = [](const std::string& link) { return std::filesystem::absolute(link).lexically_normal(); };
  if (!options.process.qbmove.empty() && !options.process.modbus_rtu.empty() &&
      place(options.process.qbmove) == place(options.process.modbus_rtu)) {
    throw UsageError(say("--modbus-rtu, --qbmove: {} both; expected two ports", options.process.qbmove));
  }
  for (const std::string& text : options.faults) {
    auto fault = sim::parseTimedFault(text);
    if (!fault) throw UsageError(say("--fault: {}", fault.error().message));
    options.process.faults.push_back(*fault);
  }
  if (!options.finger.empty()) options.process.finger = valueOrFail(sim::readFingerFile(options.finger));

  watchForEnd();
  const auto process = valueOrFail(sim::TouchpadProcess::start(options.process));
  for (const std::string& address : process->addresses()) std::cerr << "serving " << address << '\n';
  const Instant start = Clock::now();
  const auto seconds = [&] { return toSeconds(Clock::now() - start); };
  while (endSignal() == 0 && (options.duration_s <= 0.0 || seconds() < options.duration_s)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  reportSimTouchpad(options, *process, seconds());
}

}  // namespace

void addSimTouchpad(CLI::App& sim) {
  auto options = std::make_shared<SimTouchpadOptions>();
  sim::TouchpadProcessOptions& process = options->process;
  CLI::App* command = sim.add_subcommand("touchpad", "The touchpad behind Modbus, its motor board and a camera stream");
  command->add_option("--modbus-tcp", options->modbus_tcp, "Serve the registers there, HOST:PORT; port 0: any");
  command->add_option("--modbus-rtu", process.modbus_rtu,
                      "Serve the registers on this serial port; a path that does not exist becomes a pseudo-terminal");
  command->add_option("--baud", process.modbus_baud, "Speed of a real port of --modbus-rtu")
      ->check(speedOfAPort)
      ->capture_default_str();
  command->add_option(
      "--qbmove", process.qbmove,
      "Serve the motor board's protocol on this serial port; a path that does not exist becomes a pseudo-terminal");
  command->add_option("--qbmove-baud", process.qbmove_baud, "Speed of a real port of --qbmove")
      ->check(speedOfAPort)
      ->capture_default_str();
  command
      ->add_option("--qbmove-vibration", process.board.vibration_opcode,
                   "Number of the motor board's vibration command; 0: it has none")
      ->transform(wholeNumberFrom(0, 255));
  command->add_option("--camera-mjpeg", options->camera_mjpeg, "Serve the camera there as MJPEG at /, HOST:PORT");
  command->add_option("--serial", options->serial, "Serial number that it tells; default: FYD-SIM-0001")
      ->check([](const std::string& text) {
        const bool fits = text.size() <= device::kLongestSerial;
        return fits ? std::string() : fmt::format("expected at most {} characters", device::kLongestSerial);
      });
  command->add_option("--finger", options->finger, "Recording the finger follows (columns t_s,x_mm,y_mm,z_mm)");
  command->add_option("--seed", process.parameters.seed, "Seed of its noise")
      ->transform(wholeNumberFrom(0, 1'000'000'000));
  command->add_option("--fault", options->faults,
                      fmt::format("NAME@SECONDS or NAME@SECONDS+DURATION; repeatable. Names: {}",
                                  fmt::join(sim::kTouchpadFaultNames, ", ")));
  command->add_option("--duration", options->duration_s, "Seconds to run; 0: until Ctrl-C")
      ->check(numberFrom(0.0, 1e9));
  auto* map = command->add_flag("--print-map", options->print_map, "Print the register map as Markdown and end");
  command->add_flag("--json", options->json, "Summary as JSON")->excludes(map);
  command->callback([options] { runSimTouchpad(*options); });
}

}  // namespace fyd::cli
