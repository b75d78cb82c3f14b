// The simulator's servers with masters, lines and readers that do not behave, over real sockets and pseudo-terminals.
#include <array>
#include <cstdlib>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "core/device/camera/camera_source.h"
#include "core/device/touchpad/modbus_touchpad.h"
#include "core/sim/server/modbus_server.h"
#include "core/sim/server/qbmove_server.h"
#include "core/sim/server/touchpad_process.h"
#include "tests/no_free_file.h"
#include "tests/wait.h"

namespace fyd::sim {
namespace {

std::shared_ptr<TouchpadElectronics> electronics() {
  const Instant now = Clock::now();
  return std::make_shared<TouchpadElectronics>(
      std::make_shared<TouchpadWorld>(SimParameters{}, FingerPath::demonstration(), now), FaultPlan({}, now),
      MotorBoardOptions{}, now);
}

/// A socket that has been connected to a port of this machine, and says nothing.
class Caller {
 public:
  Caller() : file_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {}
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;
  ~Caller() { ::close(file_); }
  [[nodiscard]] bool connect(std::uint16_t port) const {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return ::connect(file_, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0;
  }
  [[nodiscard]] int file() const { return file_; }

 private:
  int file_;
};

/// Processor time of all threads while this one sleeps for a second.
double processorTimeOfASecond_s() {
  const auto now_s = [] {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double before_s = now_s();
  std::this_thread::sleep_for(std::chrono::seconds(1));
  return now_s() - before_s;
}

TEST(ModbusTcpServer, AnswersItsOwnUnitAndThoseThatMeanAnyAndNoOther) {
  const auto server = ModbusTcpServer::start(*protocol::parseEndpoint("127.0.0.1:0"), electronics());
  ASSERT_TRUE(server) << server.error().text();
  device::ModbusAddress address = *device::parseModbusAddress("modbus-tcp:" + protocol::toString((*server)->local()));
  device::DeviceParameters parameters;
  parameters.response_timeout_ms = 1500.0;
  for (const int unit : {1, 0, 255}) {
    address.unit = unit;
    device::ModbusTouchpad touchpad(address, parameters);
    EXPECT_TRUE(comesTrue("an answer", [&] { return touchpad.exchange({}, Clock::now()).has_value(); })) << unit;
  }
  parameters.response_timeout_ms = 200.0;
  for (const int unit : {7, 2, 247}) {
    address.unit = unit;
    device::ModbusTouchpad touchpad(address, parameters);
    const auto answer = touchpad.exchange({}, Clock::now());
    ASSERT_FALSE(answer) << unit;
    EXPECT_THAT(answer.error().text(), testing::HasSubstr("no answer")) << unit;
  }
}

TEST(ModbusTcpServer, WithoutAFreeFileItWaitsForOneWithoutTakingTheProcessor) {
  if (kSanitizerNeedsAFile) GTEST_SKIP() << "the sanitizer needs a file itself";
  const auto server = ModbusTcpServer::start(*protocol::parseEndpoint("127.0.0.1:0"), electronics());
  ASSERT_TRUE(server) << server.error().text();
  const Caller caller;
  {
    const NoFreeFile none;
    ASSERT_TRUE(caller.connect((*server)->local().port));
    EXPECT_LT(processorTimeOfASecond_s(), 0.3);
  }
  // Reads register 0: transaction 1, protocol 0, 6 bytes, unit 1, function 3.
  constexpr std::array<std::uint8_t, 12> kRequest{0, 1, 0, 0, 0, 6, 1, 3, 0, 0, 0, 1};
  ASSERT_EQ(::send(caller.file(), kRequest.data(), kRequest.size(), MSG_NOSIGNAL), 12);
  std::array<std::uint8_t, 64> answer{};
  timeval patience{.tv_sec = kPatience.count(), .tv_usec = 0};
  ::setsockopt(caller.file(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  ASSERT_EQ(::recv(caller.file(), answer.data(), answer.size(), 0), 11);
  EXPECT_EQ(answer[9], 0x46);  // "FY", of the identity
  EXPECT_EQ(answer[10], 0x59);
}

TEST(SimulatedServers, WithoutAFreeFileTheySayThatTheyCannotListen) {
  if (kSanitizerNeedsAFile) GTEST_SKIP() << "the sanitizer needs a file itself";
  TouchpadProcessOptions modbus, camera;
  modbus.modbus_tcp = camera.camera_mjpeg = *protocol::parseEndpoint("127.0.0.1:0");
  ASSERT_TRUE(TouchpadProcess::start(camera)) << "with one; its coders stay loaded";
  for (const TouchpadProcessOptions& options : {modbus, camera}) {
    const NoFreeFile none;
    const auto started = TouchpadProcess::start(options);
    ASSERT_FALSE(started);
    EXPECT_THAT(started.error().text(), testing::HasSubstr("cannot listen: Too many open files"));
  }
}

/// A serial port whose other end is unplugged by its destructor.
struct Port {
  Port() : master(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    EXPECT_EQ(::grantpt(master), 0);
    EXPECT_EQ(::unlockpt(master), 0);
    EXPECT_EQ(::ptsname_r(master, name.data(), name.size()), 0);
  }
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;
  ~Port() { ::close(master); }
  int master;
  std::array<char, 64> name{};
};

TEST(SerialServers, APortThatIsUnpluggedTakesNoProcessor) {
  auto modbus_port = std::make_unique<Port>(), qbmove_port = std::make_unique<Port>();
  const auto modbus = ModbusRtuServer::start(modbus_port->name.data(), 115'200, electronics());
  ASSERT_TRUE(modbus) << modbus.error().text();
  const auto qbmove = QbmoveServer::start(qbmove_port->name.data(), 115'200, electronics());
  ASSERT_TRUE(qbmove) << qbmove.error().text();
  modbus_port.reset();
  qbmove_port.reset();
  EXPECT_LT(processorTimeOfASecond_s(), 0.3);
}

TEST(MjpegServer, ThoseThatAskForNothingDoNotKeepAReaderOut) {
  TouchpadProcessOptions options;
  options.camera_mjpeg = *protocol::parseEndpoint("127.0.0.1:0");
  const auto process = *TouchpadProcess::start(options);
  const std::array<Caller, 8> silent{};
  for (const Caller& each : silent) ASSERT_TRUE(each.connect(process->cameraPort()));
  EXPECT_TRUE(comesTrue("a picture", [&] {
    auto camera = device::openCamera(process->addresses().front());
    return camera && (*camera)->next();
  }));
}

}  // namespace
}  // namespace fyd::sim
