#include "core/sim/server/qbmove_server.h"

#include <array>

#include <unistd.h>

namespace fyd::sim {
Result<std::unique_ptr<QbmoveServer>> QbmoveServer::start(const std::string& path, int baud,
                                                          std::shared_ptr<TouchpadElectronics> electronics) {
  auto line = SerialEnd::open(path, baud);
  if (!line) return tl::unexpected(line.error());
  return std::unique_ptr<QbmoveServer>(new QbmoveServer(std::move(*line), std::move(electronics)));
}

QbmoveServer::QbmoveServer(SerialEnd line, std::shared_ptr<TouchpadElectronics> electronics)
    : line_(std::move(line)), electronics_(std::move(electronics)) {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void QbmoveServer::send(std::span<const std::uint8_t> bytes) {
  // Bytes that the line does not accept are lost, as on a real line.
  [[maybe_unused]] const ssize_t ignored = ::write(line_.file(), bytes.data(), bytes.size());
}

void QbmoveServer::answer(const protocol::QbmoveFrame& frame) {
  const Instant now = electronics_->clock();
  const FaultPlan& faults = electronics_->faults();
  electronics_->advanceTo(now);
  if (!electronics_->powered(now) || faults.active(TouchpadFault::silence, now)) return;
  const auto reply = electronics_->handle(frame, now);
  if (!reply) return;
  if (electronics_->answersLate(now)) std::this_thread::sleep_for(kLateBy);
  if (!faults.active(TouchpadFault::garbage, now)) {
    const protocol::QbmoveBytes bytes = protocol::encode(*reply);
    send(bytes.view());
    return;
  }
  std::array<std::uint8_t, 16> waste{};
  for (std::uint8_t& byte : waste) byte = static_cast<std::uint8_t>(random_());
  send(waste);
}

void QbmoveServer::run(const std::stop_token& stop) {
  protocol::QbmoveParser parser;
  std::array<std::uint8_t, 256> buffer{};
  while (!stop.stop_requested()) {
    if (!line_.waitForBytes()) continue;
    const ssize_t got = ::read(line_.file(), buffer.data(), buffer.size());
    for (ssize_t i = 0; i < got; ++i) {
      if (const auto frame = parser.push(buffer[static_cast<std::size_t>(i)])) answer(*frame);
    }
  }
}

}  // namespace fyd::sim
