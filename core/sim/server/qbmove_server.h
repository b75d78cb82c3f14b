// Serves the simulated motor board over its serial protocol. One thread.
#pragma once

#include <memory>
#include <random>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "core/sim/server/serial_end.h"
#include "core/sim/server/touchpad_electronics.h"

namespace fyd::sim {

class QbmoveServer {
 public:
  [[nodiscard]] static Result<std::unique_ptr<QbmoveServer>> start(const std::string& path, int baud,
                                                                   std::shared_ptr<TouchpadElectronics> electronics);

 private:
  QbmoveServer(SerialEnd line, std::shared_ptr<TouchpadElectronics> electronics);
  void run(const std::stop_token& stop);
  void answer(const protocol::QbmoveFrame& frame);
  void send(std::span<const std::uint8_t> bytes);

  SerialEnd line_;
  std::shared_ptr<TouchpadElectronics> electronics_;
  std::mt19937 random_{1};
  std::jthread thread_;
};

}  // namespace fyd::sim
