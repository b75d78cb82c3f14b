#include "core/device/serial_port.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <utility>

#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/system_reason.h"
#include "core/device/in_use.h"

namespace fyd::device {
namespace {

struct Speed {
  int baud;
  speed_t constant;
};

constexpr std::array kSpeeds = {
    Speed{9600, B9600},       Speed{19200, B19200},     Speed{38400, B38400},     Speed{57600, B57600},
    Speed{115200, B115200},   Speed{230400, B230400},   Speed{460800, B460800},   Speed{500000, B500000},
    Speed{576000, B576000},   Speed{921600, B921600},   Speed{1000000, B1000000}, Speed{1152000, B1152000},
    Speed{1500000, B1500000}, Speed{2000000, B2000000}, Speed{2500000, B2500000}, Speed{3000000, B3000000},
    Speed{3500000, B3500000}, Speed{4000000, B4000000},
};

constexpr Duration kWriteLimit = std::chrono::milliseconds(50);

std::string groupOf(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return "dialout";
  group entry{};
  group* owner = nullptr;
  std::array<char, 4096> names{};
  ::getgrgid_r(info.st_gid, &entry, names.data(), names.size(), &owner);  // threads of several devices may ask
  return owner != nullptr ? owner->gr_name : std::to_string(info.st_gid);
}

bool waitFor(int file, short what, Instant deadline) {
  const Duration left = std::max(deadline - Clock::now(), Duration::zero());
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(left);
  const timespec wait{.tv_sec = static_cast<time_t>(seconds.count()),
                      .tv_nsec = static_cast<long>((left - seconds).count())};
  pollfd ready{.fd = file, .events = what, .revents = 0};
  return ::ppoll(&ready, 1, &wait, nullptr) > 0;
}

Result<void> configure(int file, int baud, const std::string& path) {
  termios mode{};
  if (::tcgetattr(file, &mode) != 0) return fail("{}: is no serial port", path);
  ::cfmakeraw(&mode);
  mode.c_cflag |= CLOCAL | CREAD;
  mode.c_cflag &= ~(CSTOPB | CRTSCTS);
  mode.c_cc[VMIN] = 0;
  mode.c_cc[VTIME] = 0;
  ::cfsetispeed(&mode, speedConstant(baud));
  ::cfsetospeed(&mode, speedConstant(baud));
  if (::tcsetattr(file, TCSANOW, &mode) != 0) return fail("{}: cannot be set up: {}", path, systemReason(errno));
  return checkSpeed(file, baud, path);
}

}  // namespace

speed_t speedConstant(int baud) {
  for (const Speed& speed : kSpeeds) {
    if (speed.baud == baud) return speed.constant;
  }
  return B0;
}

int baudOf(speed_t constant) {
  for (const Speed& speed : kSpeeds) {
    if (speed.constant == constant) return speed.baud;
  }
  return 0;
}

Result<void> checkSpeed(int file, int baud, const std::string& path) {
  termios mode{};
  if (::tcgetattr(file, &mode) != 0) return fail("{}: is no serial port", path);
  const int out = baudOf(::cfgetospeed(&mode));
  const int in = baudOf(::cfgetispeed(&mode));
  if (out != baud || in != baud) {
    return fail("{}: asked for {} Bd, the port runs at {} Bd; choose a speed its driver supports", path, baud, out);
  }
  return {};
}

Message explainPort(const std::string& path, int problem) {
  switch (problem) {
    case EACCES:
    case EPERM:
      return say("{}: no permission. Add yourself to its group with \"sudo usermod -aG {} $USER\" and log in again",
                 path, groupOf(path));
    case EBUSY: return portInUse(path);
    case ENOENT: return say("{}: there is no such port; is the cable plugged in?", path);
    case ENXIO:
    case ENODEV:
    case EIO: return say("{}: the device behind the port is gone; is the cable plugged in?", path);
    default: return about(path, systemReason(problem));
  }
}

Result<SerialPort> SerialPort::open(const std::string& path, int baud) {
  if (speedConstant(baud) == B0) {
    std::string known;
    for (const Speed& speed : kSpeeds) known += fmt::format("{}{}", known.empty() ? "" : ", ", speed.baud);
    return fail("{}: {} Bd is no speed of this system; expected one of {}", path, baud, known);
  }
  const int file = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return fail(explainPort(path, errno));
  SerialPort port(path, file);
  if (auto configured = configure(file, baud, path); !configured) return tl::unexpected(configured.error());
  if (auto alone = claimPort(file, path); !alone) return tl::unexpected(alone.error());
  port.flush();
  return port;
}

Result<void> claimPort(int file, const std::string& path) {
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return {};
  return fail(explainPort(path, errno == EWOULDBLOCK ? EBUSY : errno));
}

SerialPort::SerialPort(SerialPort&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

SerialPort& SerialPort::operator=(SerialPort&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(file_, other.file_);
  return *this;
}

SerialPort::~SerialPort() {
  if (file_ >= 0) ::close(file_);
}

bool SerialPort::write(std::span<const std::uint8_t> bytes) {
  const Instant deadline = Clock::now() + kWriteLimit;
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if ((errno != EAGAIN && errno != EINTR) || !waitFor(file_, POLLOUT, deadline)) {
      return false;
    }
  }
  return true;
}

int SerialPort::read(std::span<std::uint8_t> buffer, Instant deadline) {
  if (!waitFor(file_, POLLIN, deadline)) return 0;
  const ssize_t got = ::read(file_, buffer.data(), buffer.size());
  if (got > 0) return static_cast<int>(got);  // 0 bytes although poll reported data: hang-up
  return got < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : -1;
}

void SerialPort::flush() { ::tcflush(file_, TCIFLUSH); }

}  // namespace fyd::device
