#include "core/sim/server/serial_end.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include "core/base/system_reason.h"
#include "core/device/in_use.h"

namespace fyd::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kWake{10};  // until the next check for a stop

Result<int> openMaster(const std::string& link) {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (master < 0) return fail("{}: no pseudo-terminal to be had: {}", link, systemReason(errno));
  if (::grantpt(master) == 0 && ::unlockpt(master) == 0) return master;
  const int problem = errno;
  ::close(master);
  return fail("{}: pseudo-terminal: {}", link, systemReason(problem));
}

/// Marks a simulator's own end of a pseudo-terminal: open as long as the simulator runs. Not by flock(), with which the
/// program at the other end claims the port for itself.
struct flock simulatorsMark() {
  struct flock mark {};
  mark.l_type = F_WRLCK;
  mark.l_whence = SEEK_SET;
  return mark;
}

/// A pseudo-terminal of anything else, such as socat's, is a port like any other.
bool isAnotherSimulators(const std::string& path) {
  std::error_code problem;
  if (!fs::canonical(path, problem).string().starts_with("/dev/pts/")) return false;
  const int file = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return false;
  struct flock mark = simulatorsMark();
  const bool marked = ::fcntl(file, F_OFD_GETLK, &mark) == 0 && mark.l_type != F_UNLCK;
  ::close(file);
  return marked;
}

int openRaw(const char* name) {
  const int slave = ::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios mode{};
  if (slave >= 0 && ::tcgetattr(slave, &mode) == 0) {
    ::cfmakeraw(&mode);
    ::tcsetattr(slave, TCSANOW, &mode);
  }
  struct flock mark = simulatorsMark();
  if (slave >= 0) ::fcntl(slave, F_OFD_SETLK, &mark);
  return slave;
}

}  // namespace

Result<PseudoTerminal> PseudoTerminal::open(const std::string& link) {
  std::error_code problem;
  // One that a killed simulator left leads nowhere, until the new terminal gets its number.
  if (fs::is_symlink(link, problem) && !fs::exists(link, problem)) fs::remove(link, problem);
  auto master = openMaster(link);
  if (!master) return tl::unexpected(master.error());
  std::array<char, 64> name{};
  if (::ptsname_r(*master, name.data(), name.size()) != 0) {
    ::close(*master);
    return fail("{}: the pseudo-terminal has no name", link);
  }
  fs::create_symlink(name.data(), link, problem);
  if (problem) {
    ::close(*master);
    return fail("{}: cannot be made a link to {}: {}", link, name.data(), systemReason(problem));
  }
  return PseudoTerminal(link, *master, openRaw(name.data()));
}

PseudoTerminal::PseudoTerminal(PseudoTerminal&& other) noexcept
    : link_(std::exchange(other.link_, {})),
      master_(std::exchange(other.master_, -1)),
      slave_(std::exchange(other.slave_, -1)) {}

PseudoTerminal& PseudoTerminal::operator=(PseudoTerminal&& other) noexcept {
  std::swap(link_, other.link_);
  std::swap(master_, other.master_);
  std::swap(slave_, other.slave_);
  return *this;
}

PseudoTerminal::~PseudoTerminal() {
  if (slave_ >= 0) ::close(slave_);
  if (master_ >= 0) ::close(master_);
  if (!link_.empty()) ::unlink(link_.c_str());
}

Result<SerialEnd> SerialEnd::open(const std::string& path, int baud) {
  SerialEnd out;
  std::error_code problem;
  if (fs::exists(path, problem)) {
    if (isAnotherSimulators(path)) return fail(device::portInUse(path));
    auto port = device::SerialPort::open(path, baud);
    if (!port) return tl::unexpected(port.error());
    out.port_ = std::move(*port);
    return out;
  }
  auto terminal = PseudoTerminal::open(path);
  if (!terminal) return tl::unexpected(terminal.error());
  out.terminal_ = std::move(*terminal);
  return out;
}

bool SerialEnd::waitForBytes() const {
  pollfd ready{.fd = file(), .events = POLLIN, .revents = 0};
  if (::poll(&ready, 1, static_cast<int>(kWake.count())) <= 0) return false;
  // Unplugged, or closed by the other end: poll no longer waits, but what was sent before is still there to be read.
  if ((ready.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) std::this_thread::sleep_for(kWake);
  return (ready.revents & POLLIN) != 0;
}

}  // namespace fyd::sim
