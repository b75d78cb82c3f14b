// The simulated touchpad as a runnable: one world, served over Modbus TCP, Modbus RTU, the motor board's protocol and
// MJPEG at once. `fyd sim touchpad` runs it as its own process, tests run it within theirs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/sim/finger_path.h"
#include "core/sim/server/mjpeg_server.h"
#include "core/sim/server/modbus_server.h"
#include "core/sim/server/qbmove_server.h"

namespace fyd::sim {

struct TouchpadProcessOptions {
  SimParameters parameters;
  FingerPath finger = FingerPath::demonstration();
  std::optional<protocol::Endpoint> modbus_tcp;  ///< port 0: any
  std::string modbus_rtu;                        ///< path; empty: not served
  int modbus_baud = 115'200;                     ///< a pseudo-terminal has none
  std::string qbmove;                            ///< path; empty: not served
  int qbmove_baud = 2'000'000;
  MotorBoardOptions board;
  std::optional<protocol::Endpoint> camera_mjpeg;  ///< port 0: any
  std::vector<TimedFault> faults;                  ///< seconds count from `start`
  RegisterBank registers;                          ///< as they are when it is switched on
};

class TouchpadProcess {
 public:
  /// @return an error when nothing is to be served, or an address or path is not available
  [[nodiscard]] static Result<std::unique_ptr<TouchpadProcess>> start(TouchpadProcessOptions options);

  [[nodiscard]] const TouchpadElectronics& electronics() const { return *electronics_; }
  [[nodiscard]] TouchpadWorld& world() { return *world_; }
  /// Begins a fault now.
  void inject(TouchpadFault fault, double for_s) { electronics_->faults().add(fault, Clock::now(), for_s); }
  /// Where it listens, with the ports the system chose.
  [[nodiscard]] std::vector<std::string> addresses() const;
  [[nodiscard]] std::uint16_t modbusPort() const { return modbus_tcp_ ? modbus_tcp_->local().port : 0; }
  [[nodiscard]] std::uint16_t cameraPort() const { return camera_ ? camera_->local().port : 0; }
  [[nodiscard]] std::uint64_t pictures() const { return camera_ ? camera_->pictures() : 0; }

 private:
  TouchpadProcess() = default;
  [[nodiscard]] Result<void> serve(const TouchpadProcessOptions& options, const FaultPlan& faults);

  std::shared_ptr<TouchpadWorld> world_;
  std::shared_ptr<TouchpadElectronics> electronics_;
  std::unique_ptr<ModbusTcpServer> modbus_tcp_;
  std::unique_ptr<ModbusRtuServer> modbus_rtu_;
  std::unique_ptr<QbmoveServer> qbmove_;
  std::unique_ptr<MjpegServer> camera_;
  std::vector<std::string> addresses_;
  std::jthread ticker_;  // advances time without requests: watchdogs, vibration
};

}  // namespace fyd::sim
