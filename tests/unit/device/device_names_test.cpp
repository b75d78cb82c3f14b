// Addresses as people write them, the device clock's wrap, ports that do not open, and the list of what is plugged in.
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/device/device_list.h"
#include "core/device/modbus_touchpad.h"
#include "core/device/qbmove_motors.h"
#include "core/device/touchpad_source.h"

namespace fyd::device {
namespace {

using testing::HasSubstr;

TEST(ModbusAddress, ReadsBothForms) {
  const auto tcp = parseModbusAddress("modbus-tcp:127.0.0.1:1502");
  ASSERT_TRUE(tcp);
  EXPECT_TRUE(tcp->tcp);
  EXPECT_EQ(tcp->host.port, 1502);
  const auto rtu = parseModbusAddress("modbus-rtu:/dev/ttyUSB0:1000000");
  ASSERT_TRUE(rtu);
  EXPECT_EQ(rtu->port, "/dev/ttyUSB0");
  EXPECT_EQ(rtu->baud, 1'000'000);
  EXPECT_EQ(toString(*rtu), "modbus-rtu:/dev/ttyUSB0:1000000");
}

TEST(ModbusAddress, AColonInAPortsNameIsNoSpeed) {
  const auto rtu = parseModbusAddress("modbus-rtu:/dev/serial/by-path/pci-0:14.0-usb-0:2:1.0-port0");
  ASSERT_TRUE(rtu);
  EXPECT_EQ(rtu->port, "/dev/serial/by-path/pci-0:14.0-usb-0:2:1.0-port0");
  EXPECT_EQ(rtu->baud, 115'200);
}

TEST(ModbusAddress, SaysWhatItExpected) {
  EXPECT_THAT(parseModbusAddress("modbus-tcp:nowhere").error().message, HasSubstr("nowhere"));
  EXPECT_THAT(parseModbusAddress("modbus-rtu:").error().message, HasSubstr("modbus-rtu:TTY[:BAUD]"));
  EXPECT_THAT(openTouchpad("touchpad", {}).error().message, HasSubstr("'touchpad'"));
  EXPECT_THAT(withMotors(nullptr, "maxon:/dev/x", {}).error().message, HasSubstr("qbmove:TTY"));
}

TEST(DeviceClock, AWrapIsNoRestartAndARestartIsSeen) {
  const auto ms = [](int n) { return std::chrono::milliseconds(n); };
  EXPECT_FALSE(deviceRestarted(4'294'965'000U, 1'704U, ms(4)));
  EXPECT_TRUE(deviceRestarted(4'294'965'000U, 900'000U, ms(4)) == false) << "a second of slack";
  EXPECT_TRUE(deviceRestarted(60'000'000U, 500'000U, ms(600)));
  EXPECT_TRUE(deviceRestarted(60'000'000U, 100U, ms(4)));
  EXPECT_FALSE(deviceRestarted(60'000'000U, 70'500'000U, ms(10'000)));
}

TEST(DeviceClock, ADayOfCyclesHasNoRestart) {
  std::uint64_t us = 0;
  for (int cycle = 0; cycle < 86'400; ++cycle) {
    const std::uint64_t next = us + 1'000'000 + cycle % 3;
    ASSERT_FALSE(
        deviceRestarted(static_cast<std::uint32_t>(us), static_cast<std::uint32_t>(next), std::chrono::seconds(1)));
    us = next;
  }
}

TEST(EncoderCounts, FollowSignAndScaleOfTheProfile) {
  DeviceParameters parameters;
  EXPECT_EQ(encoderCountsOf(4200, parameters), 1024);  // 90° of 4096 counts a turn
  EXPECT_EQ(encoderCountsOf(-4200, parameters), 3072);
  parameters.qbmove_encoder_sign = -1;
  EXPECT_EQ(encoderCountsOf(4200, parameters), 3072);
  parameters.qbmove_ticks_per_degree = 65536.0 / 360.0;
  EXPECT_EQ(encoderCountsOf(-16384, parameters), 1024);
}

TEST(SerialPort, ReasonsComeWithTheirRemedy) {
  EXPECT_THAT(explainPort("/dev/null", EACCES), HasSubstr("usermod -aG root"));
  EXPECT_THAT(explainPort("/dev/x", EBUSY), HasSubstr("fuser"));
  EXPECT_THAT(SerialPort::open("/dev/there-is-none", 115'200).error().message, HasSubstr("plugged in"));
  EXPECT_THAT(SerialPort::open("/dev/null", 115'200).error().message, HasSubstr("no serial port"));
  EXPECT_THAT(SerialPort::open("/dev/null", 123'456).error().message, HasSubstr("123456 Bd is no speed"));
}

TEST(SerialPort, ASpeedThatWasSilentlyReplacedIsFoundOut) {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(master, 0);
  ASSERT_EQ(::grantpt(master), 0);
  ASSERT_EQ(::unlockpt(master), 0);
  const int slave = ::open(::ptsname(master), O_RDWR | O_NOCTTY);
  termios mode{};
  ASSERT_EQ(::tcgetattr(slave, &mode), 0);
  ::cfsetspeed(&mode, B9600);
  ASSERT_EQ(::tcsetattr(slave, TCSANOW, &mode), 0);
  EXPECT_TRUE(checkSpeed(slave, 9600, "port"));
  EXPECT_THAT(checkSpeed(slave, 115'200, "port").error().message,
              HasSubstr("asked for 115200 Bd, the port runs at 9600"));
  ::close(slave);
  ::close(master);
}

TEST(DeviceList, StableNamesComeFirstAndOnlyOnce) {
  namespace fs = std::filesystem;
  const fs::path dev = fs::path(testing::TempDir()) / "fyd-devices-test";
  fs::remove_all(dev);
  fs::create_directories(dev / "serial/by-id");
  std::ofstream(dev / "ttyUSB0").put('x');
  std::ofstream(dev / "ttyUSB1").put('x');
  std::ofstream(dev / "tty1").put('x');
  fs::create_symlink("../../ttyUSB1", dev / "serial/by-id/usb-Maker_Board_42-if00");
  fs::create_symlink("../../ttyUSB9", dev / "serial/by-id/usb-gone");
  const auto found = findSerialPorts(dev.string());
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found[0].path, HasSubstr("usb-Maker_Board_42-if00"));
  EXPECT_THAT(found[0].node, HasSubstr("ttyUSB1"));
  EXPECT_THAT(found[1].path, HasSubstr("ttyUSB0"));
  EXPECT_EQ(found[1].problem, "");
  EXPECT_TRUE(findCaptureDevices(dev.string()).empty());
  fs::remove_all(dev);
}

}  // namespace
}  // namespace fyd::device
