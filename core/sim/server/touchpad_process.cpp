#include "core/sim/server/touchpad_process.h"

#include "core/sim/touchpad/simulated_camera.h"

namespace fyd::sim {
namespace {

constexpr Duration kTick = std::chrono::milliseconds(2);

}  // namespace

Result<std::unique_ptr<TouchpadProcess>> TouchpadProcess::start(TouchpadProcessOptions options) {
  std::unique_ptr<TouchpadProcess> made(new TouchpadProcess());
  const Instant now = Clock::now();
  const FaultPlan faults(options.faults, now);
  made->world_ = std::make_shared<TouchpadWorld>(options.parameters, std::move(options.finger), now);
  made->electronics_ = std::make_shared<TouchpadElectronics>(made->world_, faults, options.board, now,
                                                             options.registers);
  if (auto served = made->serve(options, faults); !served) return tl::unexpected(served.error());
  if (made->addresses_.empty()) return fail("simulated touchpad: nothing to serve it through");
  made->ticker_ = std::jthread([electronics = made->electronics_](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      electronics->advanceTo(Clock::now());
      std::this_thread::sleep_for(kTick);
    }
  });
  return made;
}

Result<void> TouchpadProcess::serve(const TouchpadProcessOptions& options, const FaultPlan& faults) {
  if (options.modbus_tcp) {
    auto server = ModbusTcpServer::start(*options.modbus_tcp, electronics_);
    if (!server) return tl::unexpected(server.error());
    modbus_tcp_ = std::move(*server);
    addresses_.push_back("modbus-tcp:" + protocol::toString(modbus_tcp_->local()));
  }
  if (!options.modbus_rtu.empty()) {
    auto server = ModbusRtuServer::start(options.modbus_rtu, options.modbus_baud, electronics_);
    if (!server) return tl::unexpected(server.error());
    modbus_rtu_ = std::move(*server);
    addresses_.push_back("modbus-rtu:" + options.modbus_rtu);
  }
  if (!options.qbmove.empty()) {
    auto server = QbmoveServer::start(options.qbmove, options.qbmove_baud, electronics_);
    if (!server) return tl::unexpected(server.error());
    qbmove_ = std::move(*server);
    addresses_.push_back("qbmove:" + options.qbmove);
  }
  if (options.camera_mjpeg) {
    auto server = MjpegServer::start(*options.camera_mjpeg, std::make_unique<SimulatedCamera>(world_), faults);
    if (!server) return tl::unexpected(server.error());
    camera_ = std::move(*server);
    addresses_.push_back("http://" + protocol::toString(camera_->local()) + "/");
  }
  return {};
}

std::vector<std::string> TouchpadProcess::addresses() const { return addresses_; }

}  // namespace fyd::sim
