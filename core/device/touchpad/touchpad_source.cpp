#include "core/device/touchpad/touchpad_source.h"

#include "core/device/touchpad/combined_touchpad.h"
#include "core/device/touchpad/modbus_touchpad.h"

namespace fyd::device {
namespace {

constexpr std::string_view kQbmovePrefix = "qbmove:";

Result<ModbusAddress> addressOf(const std::string& source) {
  auto address = parseModbusAddress(source);
  if (!address) return fail("touchpad {}", address.error().message);
  return address;
}

}  // namespace

Result<void> checkMotorsName(const std::string& motors) {
  if (motors.starts_with(kQbmovePrefix) && motors.size() > kQbmovePrefix.size()) return {};
  return fail("motors '{}': expected qbmove:TTY", motors);
}

Result<void> checkTouchpadSource(const std::string& source) {
  if (const auto address = addressOf(source); !address) return tl::unexpected(address.error());
  return {};
}

Result<std::unique_ptr<Touchpad>> withMotors(std::unique_ptr<Touchpad> touchpad, const std::string& motors,
                                             const DeviceParameters& parameters) {
  if (motors.empty()) return touchpad;
  auto board = openMotorBoard(motors, parameters);
  if (!board) return tl::unexpected(board.error());
  return std::make_unique<CombinedTouchpad>(std::move(touchpad), std::move(*board), parameters);
}

Result<std::unique_ptr<QbmoveMotors>> openMotorBoard(const std::string& motors, const DeviceParameters& parameters) {
  if (auto named = checkMotorsName(motors); !named) return tl::unexpected(named.error());
  return std::make_unique<QbmoveMotors>(motors.substr(kQbmovePrefix.size()), parameters);
}

Result<std::unique_ptr<Touchpad>> openTouchpad(const std::string& source, const DeviceParameters& parameters) {
  auto address = addressOf(source);
  if (!address) return tl::unexpected(address.error());
  return std::make_unique<ModbusTouchpad>(*address, parameters);
}

Result<std::string> readSerial(const std::string& source, const DeviceParameters& parameters) {
  const auto address = addressOf(source);
  if (!address) return tl::unexpected(address.error());
  if (!address->serial.empty()) return address->serial;
  return ModbusTouchpad(*address, parameters).askSerial();
}

}  // namespace fyd::device
