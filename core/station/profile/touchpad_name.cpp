#include "core/station/profile/touchpad_name.h"

#include "core/device/touchpad/modbus_link.h"
#include "core/device/touchpad/touchpad_source.h"

namespace fyd::station {
namespace {

constexpr std::string_view kWith = " with ";

std::string_view withoutMotors(std::string_view name) { return name.substr(0, name.find(kWith)); }

}  // namespace

std::string touchpadName(std::string_view touchpad, std::string_view motors) {
  std::string out(touchpad);
  if (!out.empty() && !motors.empty()) out.append(kWith).append(motors);
  return out;
}

Result<void> checkTouchpadName(const std::string& name) {
  const std::string touchpad(withoutMotors(name));
  if (touchpad.size() < name.size()) {
    if (auto motors = device::checkMotorsName(name.substr(touchpad.size() + kWith.size())); !motors) return motors;
  }
  if (touchpad == kSimulatedTouchpad) return {};
  if (touchpad.starts_with(kSerialTouchpad)) {
    const std::size_t length = serialIn(touchpad).size();
    if (length >= 1 && length <= device::kLongestSerial) return {};
  } else if (touchpad.find(device::kSerialDemand) == std::string::npos && device::checkTouchpadSource(touchpad)) {
    return {};
  }
  return fail("touchpad '{}': expected simulated, serial:NUMBER of 1 to {} characters, or its address", name,
              device::kLongestSerial);
}

bool isSimulated(std::string_view name) { return withoutMotors(name) == kSimulatedTouchpad; }

bool isPlayed(std::string_view name) { return withoutMotors(name) == kPlayedTouchpad; }

std::string serialIn(std::string_view name) {
  if (!name.starts_with(kSerialTouchpad)) return {};
  return std::string(withoutMotors(name).substr(kSerialTouchpad.size()));
}

Message describeTouchpad(std::string_view name) {
  if (name.empty()) return say("a touchpad that is not known");
  if (name == kSimulatedTouchpad) return say("the simulated touchpad");
  if (name == kPlayedTouchpad) return say("a recording");
  if (const std::string serial = serialIn(name); !serial.empty() && withoutMotors(name) == name) {
    return say("the touchpad with serial number {}", serial);
  }
  return say("the touchpad {}", std::string(name));
}

}  // namespace fyd::station
