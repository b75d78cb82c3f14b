// Addresses as people write them, the device clock's wrap, ports that do not open, and the list of connected devices.
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/device/device_list.h"
#include "core/device/touchpad/modbus_touchpad.h"
#include "core/device/touchpad/qbmove_motors.h"
#include "core/device/touchpad/touchpad_source.h"
#include "tests/temporary_folder.h"

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
  EXPECT_THAT(parseModbusAddress("modbus-tcp:nowhere").error().text(), HasSubstr("nowhere"));
  EXPECT_THAT(parseModbusAddress("modbus-rtu:").error().text(), HasSubstr("modbus-rtu:TTY[:BAUD]"));
  EXPECT_THAT(openTouchpad("touchpad", {}).error().text(), HasSubstr("'touchpad'"));
  EXPECT_THAT(withMotors(nullptr, "maxon:/dev/x", {}).error().text(), HasSubstr("qbmove:TTY"));
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
  for (std::uint64_t cycle = 0; cycle < 86'400; ++cycle) {
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
  EXPECT_THAT(explainPort("/dev/null", EACCES).text(), HasSubstr("usermod -aG root"));
  EXPECT_THAT(explainPort("/dev/x", EBUSY).text(), HasSubstr("fuser"));
  EXPECT_THAT(SerialPort::open("/dev/there-is-none", 115'200).error().text(), HasSubstr("plugged in"));
  EXPECT_THAT(SerialPort::open("/dev/null", 115'200).error().text(), HasSubstr("no serial port"));
  EXPECT_THAT(SerialPort::open("/dev/null", 123'456).error().text(), HasSubstr("123456 Bd is no speed"));
}

TEST(SerialPort, WithoutPermissionTheGroupAndTheRemedyAreNamed) {
  const std::string path = fmt::format("{}fyd-forbidden-{}", testing::TempDir(), ::getpid());
  std::ofstream(path).put('x');
  std::filesystem::permissions(path, std::filesystem::perms::none);
  const auto refused = [&path] {  // in a process of its own, which is nobody in particular
    if (::geteuid() == 0 && ::setuid(65534) != 0) return false;
    const auto port = SerialPort::open(path, 115'200);
    ModbusLink link(*parseModbusAddress("modbus-rtu:" + path), std::chrono::milliseconds(50),
                    std::chrono::milliseconds(5));
    const auto opened = link.open();
    return !port && port.error().text().find("usermod -aG") != std::string::npos && !opened &&
           opened.error().text().find("no permission") != std::string::npos;
  };
  EXPECT_EXIT(::_exit(refused() ? 0 : 1), testing::ExitedWithCode(0), "");
  std::filesystem::remove(path);
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
  EXPECT_THAT(checkSpeed(slave, 115'200, "port").error().text(),
              HasSubstr("asked for 115200 Bd, the port runs at 9600"));
  ::close(slave);
  ::close(master);
}

TEST(ModbusAddress, MayNameTheAdapterAndTheTouchpad) {
  const auto rtu = parseModbusAddress("modbus-rtu:id=A600CL0G:1000000,serial=FYD-0042");
  ASSERT_TRUE(rtu);
  EXPECT_EQ(rtu->port, "id=A600CL0G");
  EXPECT_EQ(rtu->baud, 1'000'000);
  EXPECT_EQ(rtu->serial, "FYD-0042");
  EXPECT_EQ(parseModbusAddress("modbus-tcp:127.0.0.1:502,serial=7")->serial, "7");
  EXPECT_THAT(parseModbusAddress("modbus-tcp:127.0.0.1:502,serial=").error().text(), HasSubstr("1 to 16"));
  EXPECT_FALSE(parseModbusAddress("modbus-tcp:127.0.0.1:502,serial=12345678901234567"));
}

class ById : public testing::Test {
 protected:
  ById() : folder_(std::filesystem::path(testing::TempDir()) / fmt::format("fyd-by-id-{}", ::getpid())) {
    std::filesystem::create_directories(folder_);
  }
  ~ById() override { std::filesystem::remove_all(folder_); }
  void plugIn(const std::string& name) { std::filesystem::create_symlink("/dev/null", folder_ / name); }
  std::string resolve(const std::string& text) {
    const auto found = resolveDevice(text, folder_.string());
    return found ? std::filesystem::path(*found).filename().string() : "error: " + found.error().text();
  }
  std::filesystem::path folder_;
};

TEST_F(ById, FindsTheOneDeviceWithThatSerialNumber) {
  plugIn("usb-FTDI_FT232R_USB_UART_A600CL0G-if00-port0");
  plugIn("usb-FTDI_FT232R_USB_UART_A600CL0H-if00-port0");
  EXPECT_EQ(resolve("id=A600CL0H"), "usb-FTDI_FT232R_USB_UART_A600CL0H-if00-port0");
  EXPECT_EQ(resolve("id=usb-FTDI_FT232R_USB_UART_A600CL0G-if00-port0"), "usb-FTDI_FT232R_USB_UART_A600CL0G-if00-port0");
  EXPECT_EQ(*resolveDevice("/dev/ttyUSB0", folder_.string()), "/dev/ttyUSB0");
}

TEST_F(ById, NoneAndSeveralAreNamed) {
  EXPECT_THAT(resolve("id=7"), HasSubstr("holds nothing"));
  plugIn("usb-Maker_Board_42-if00");
  plugIn("usb-Maker_Board_42-if01");
  plugIn("usb-Maker_Board_142-if00");
  EXPECT_THAT(resolve("id=7"), HasSubstr("none is plugged in"));
  EXPECT_THAT(resolve("id=7"), HasSubstr("usb-Maker_Board_142-if00"));
  EXPECT_THAT(resolve("id=42"), HasSubstr("2 fit"));
  EXPECT_EQ(resolve("id=42-if01"), "usb-Maker_Board_42-if01");
  EXPECT_EQ(resolve("id=142"), "usb-Maker_Board_142-if00");
  EXPECT_THAT(resolve("id="), HasSubstr("expected id=SERIAL"));
  EXPECT_THAT(resolveDevice("id=7", "/there/is/none").error().text(), HasSubstr("nothing"));
}

TEST_F(ById, ACamerasPicturesComeFromItsFirstNode) {
  plugIn("usb-Maker_Cam_99-video-index0");
  plugIn("usb-Maker_Cam_99-video-index1");
  EXPECT_EQ(resolve("id=99"), "usb-Maker_Cam_99-video-index0");
  EXPECT_EQ(resolve("id=99-video-index1"), "usb-Maker_Cam_99-video-index1");
}

TEST(DeviceList, StableNamesComeFirstAndOnlyOnce) {
  namespace fs = std::filesystem;
  const Folder folder;
  const fs::path dev = folder.path();
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
  EXPECT_EQ(found[1].problem.text(), "");
  EXPECT_TRUE(findCaptureDevices(dev.string()).empty());
}

}  // namespace
}  // namespace fyd::device
