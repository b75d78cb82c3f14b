// The simulator's end of a serial line: a real port, or a pseudo-terminal that it creates if the path does not exist.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/device/serial_port.h"

namespace fyd::sim {

/// A pseudo-terminal whose other end appears as a symbolic link.
class PseudoTerminal {
 public:
  /// @param link does not exist yet, or is a link whose target is gone
  [[nodiscard]] static Result<PseudoTerminal> open(const std::string& link);

  PseudoTerminal(PseudoTerminal&& other) noexcept;
  PseudoTerminal& operator=(PseudoTerminal&& other) noexcept;
  ~PseudoTerminal();  ///< removes the link

  [[nodiscard]] int file() const { return master_; }

 private:
  PseudoTerminal(std::string link, int master, int slave) : link_(std::move(link)), master_(master), slave_(slave) {}
  std::string link_;
  int master_ = -1;
  int slave_ = -1;  // held open, so that the line outlives its clients
};

class SerialEnd {
 public:
  /// @param path of a serial port; if there is none, a pseudo-terminal is created there. One that another simulator
  /// made is its own.
  [[nodiscard]] static Result<SerialEnd> open(const std::string& path, int baud);
  /// Non-blocking; open as long as this object.
  [[nodiscard]] int file() const { return port_ ? port_->file() : terminal_->file(); }
  /// Waits 10 ms at most. @return whether something may be read; a port that is gone is asked no more often than that
  [[nodiscard]] bool waitForBytes() const;

 private:
  std::optional<device::SerialPort> port_;
  std::optional<PseudoTerminal> terminal_;
};

}  // namespace fyd::sim
