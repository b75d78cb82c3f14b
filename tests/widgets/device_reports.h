// What a touchpad reports of itself that is well.
#pragma once

#include "core/device/device_report.h"

namespace fyd::tests {

inline device::DeviceReport touchpad() {
  device::DeviceReport out{.part = device::Part::touchpad,
                           .kind = verbatim("Modbus TCP"),
                           .description = verbatim("10.0.0.7:502, firmware 1.2")};
  out.ok = true;
  out.rate_hz = 249.7;
  out.age_ms = 3.6;
  out.values = {{.name = say("IR sensor {}", 1), .number = 2048.0, .unit = "counts"},
                {.name = say("load cell"), .number = 0.12345, .unit = "mV/V"},
                {.name = say("motors"), .text = say("switched off")},
                {.name = say("current {}", 1), .unit = "mA"}};
  return out;
}

}  // namespace fyd::tests
