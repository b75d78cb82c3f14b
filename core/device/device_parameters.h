// Parameters of the communication with a real touchpad, its motor board and its camera.
#pragma once

#include <string_view>

#include "core/base/parameter.h"

namespace fyd::device {

struct DeviceParameters {
  // Modbus
  double cycle_rate_Hz = 250.0;
  double response_timeout_ms = 100.0;
  double quiet_ms = 30.0;
  double watchdog_ms = 100.0;
  double thermal_limit_degC = 85.0;

  // the original motor board
  int qbmove_baud = 2'000'000;
  int qbmove_id = 1;
  double qbmove_timeout_ms = 4.0;
  double qbmove_watchdog_ms = 100.0;
  double qbmove_ticks_per_degree = 4200.0 / 90.0;
  int qbmove_encoder_sign = 1;
  int qbmove_vibration_opcode = 0;
  bool qbmove_vibration_swapped = false;

  // cameras; percent of the driver's range, -1: left as it is
  double camera_brightness_percent = -1.0;
  double camera_contrast_percent = -1.0;
  double camera_exposure_percent = -1.0;
  double camera_freeze_ms = 500.0;
  bool camera_flat_cloth = false;

  // plausibility of readings
  double stuck_sensor_s = 2.0;
  double frozen_reading_ms = 500.0;

  // Folders of the stable device names; not in the profile: tests set their own. Empty: those of stable_name.h.
  // The text they point to outlives these parameters.
  std::string_view serial_by_id;
  std::string_view cameras_by_id;

  template <class Visitor>
  void describe(Visitor& v) {
    v.real("device.cycle_rate_Hz", cycle_rate_Hz,
           {.unit = "Hz",
            .minimum = 10,
            .maximum = 1000,
            .help = "Modbus transactions a second; a slow line gives fewer."});
    v.real("device.response_timeout_ms", response_timeout_ms,
           {.unit = "ms", .minimum = 5, .maximum = 2000, .help = "Longest wait for the answer to a Modbus request."});
    v.real("device.quiet_ms", quiet_ms,
           {.unit = "ms",
            .minimum = 2,
            .maximum = 2000,
            .help = "Silence that a serial line must keep after a lost answer before the next request goes out."});
    v.real("device.watchdog_ms", watchdog_ms,
           {.unit = "ms",
            .minimum = 20,
            .maximum = 1000,
            .help = "Standstill of the heartbeat after which the touchpad switches its motors off by itself."});
    v.real("device.thermal_limit_degC", thermal_limit_degC,
           {.unit = "°C",
            .minimum = 40,
            .maximum = 125,
            .help = "Estimated motor temperature from which the touchpad switches its motors off by itself."});
    v.integer("device.qbmove_baud", qbmove_baud,
              {.unit = "Bd",
               .minimum = 9600,
               .maximum = 4'000'000,
               .help = "Speed of the motor board's line: 460800 in 2014, 2000000 since."});
    v.integer("device.qbmove_id", qbmove_id,
              {.minimum = 1, .maximum = 255, .help = "Number of the motor board on its line."});
    v.real("device.qbmove_timeout_ms", qbmove_timeout_ms,
           {.unit = "ms", .minimum = 1, .maximum = 200, .help = "Longest wait for the motor board's reply."});
    v.real("device.qbmove_watchdog_ms", qbmove_watchdog_ms,
           {.unit = "ms",
            .minimum = 20,
            .maximum = 5000,
            .help = "Silence after which the motor board switches its motors off by itself, in steps of 20 ms."});
    v.real("device.qbmove_ticks_per_degree", qbmove_ticks_per_degree,
           {.unit = "tick/°",
            .minimum = 1,
            .maximum = 1000,
            .help = "Ticks of the motor board's measured positions in a degree."});
    v.integer("device.qbmove_encoder_sign", qbmove_encoder_sign,
              {.minimum = -1,
               .maximum = 1,
               .help = "1, or -1 for firmware that counts its measured positions the other way round."});
    v.integer("device.qbmove_vibration_opcode", qbmove_vibration_opcode,
              {.minimum = 0,
               .maximum = 255,
               .help = "Command that carries the two vibration duties to the motor board; 0: it has none."});
    v.boolean("device.qbmove_vibration_swapped", qbmove_vibration_swapped,
              {.help = "The vibration command wants the second motor's duty first."});
    v.real("device.camera_brightness_percent", camera_brightness_percent,
           {.unit = "%",
            .minimum = -1,
            .maximum = 100,
            .help = "Brightness control of the camera in percent of its range; -1: left as it is."});
    v.real("device.camera_contrast_percent", camera_contrast_percent,
           {.unit = "%",
            .minimum = -1,
            .maximum = 100,
            .help = "Contrast control of the camera in percent of its range; -1: left as it is."});
    v.real(
        "device.camera_exposure_percent", camera_exposure_percent,
        {.unit = "%",
         .minimum = -1,
         .maximum = 100,
         .help = "Exposure time of the camera in percent of its range, which ends its automatic; -1: left as it is."});
    v.real("device.camera_freeze_ms", camera_freeze_ms,
           {.unit = "ms",
            .minimum = 0,
            .maximum = 10'000,
            .help = "Equal pictures of a camera or stream for longer than this count as frozen; 0: never."});
    v.boolean(
        "device.camera_flat_cloth", camera_flat_cloth,
        {.help = "The untouched cloth gives a picture of one grey, such as white at the camera's highest contrast; "
                 "off: such a picture is a fault of light or camera."});
    v.real(
        "device.stuck_sensor_s", stuck_sensor_s,
        {.unit = "s",
         .minimum = 0,
         .maximum = 60,
         .help = "A distance sensor that repeats one code for longer than this while the others change is reported as "
                 "stuck; 0: never."});
    v.real("device.frozen_reading_ms", frozen_reading_ms,
           {.unit = "ms",
            .minimum = 0,
            .maximum = 10'000,
            .help = "Equal readings of all distance sensors, or of the load cell, for longer than this count as frozen "
                    "and are no longer believed; 0: never, for sensors without noise."});
  }
};

}  // namespace fyd::device
