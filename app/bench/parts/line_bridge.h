// Joins two serial lines with the delay of a real baud rate; a pseudo-terminal alone has no transmission time.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <thread>

#include <poll.h>
#include <unistd.h>

#include "core/device/serial_port.h"
#include "core/sim/server/serial_end.h"

namespace fyd::bench {

class LineBridge {
 public:
  /// @param device serial port of the device  @param path where the client's end appears
  [[nodiscard]] static Result<std::unique_ptr<LineBridge>> start(const std::string& device, const std::string& path,
                                                                 int baud) {
    auto port = device::SerialPort::open(device, 115'200);
    if (!port) return tl::unexpected(port.error());
    auto end = sim::SerialEnd::open(path, 115'200);
    if (!end) return tl::unexpected(end.error());
    return std::unique_ptr<LineBridge>(new LineBridge(std::move(*port), std::move(*end), baud));
  }

 private:
  LineBridge(device::SerialPort port, sim::SerialEnd end, int baud)
      : port_(std::move(port)), end_(std::move(end)), byte_time_(fromSeconds(10.0 / baud)) {
    there_ = std::jthread([this](const std::stop_token& stop) { carry(stop, end_.file(), port_.file()); });
    back_ = std::jthread([this](const std::stop_token& stop) { carry(stop, port_.file(), end_.file()); });
  }

  void carry(const std::stop_token& stop, int from, int to) const {
    std::array<std::uint8_t, 256> bytes{};
    Instant wire_free{};
    while (!stop.stop_requested()) {
      pollfd ready{.fd = from, .events = POLLIN, .revents = 0};
      if (::poll(&ready, 1, 20) <= 0) continue;
      const ssize_t got = ::read(from, bytes.data(), bytes.size());
      if (got <= 0) continue;
      wire_free = std::max(wire_free, Clock::now()) + got * byte_time_;
      std::this_thread::sleep_until(wire_free);
      if (::write(to, bytes.data(), static_cast<std::size_t>(got)) < 0) continue;  // no reader: lost
    }
  }

  device::SerialPort port_;
  sim::SerialEnd end_;
  Duration byte_time_;
  std::jthread there_;
  std::jthread back_;
};

}  // namespace fyd::bench
