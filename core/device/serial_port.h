// A serial port in raw 8N1 mode whose speed is read back after it was set: a driver that cannot do a speed keeps
// another one and says nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <termios.h>

#include "core/base/error.h"
#include "core/base/time.h"

namespace fyd::device {

/// The constant of a speed, B0 when the system knows none.
[[nodiscard]] speed_t speedConstant(int baud);
/// 0 for a constant that stands for none.
[[nodiscard]] int baudOf(speed_t constant);
/// @return an error when the port runs at another speed than `baud`
[[nodiscard]] Result<void> checkSpeed(int file, int baud, const std::string& path);
/// Keeps other programs of this kind out until the file is closed, also by the process's death.
/// @return an error when one of them holds the port
[[nodiscard]] Result<void> claimPort(int file, const std::string& path);
/// Why opening `path` failed with `problem` (an errno), and what to do about it.
[[nodiscard]] Message explainPort(const std::string& path, int problem);

/// Used by one thread at a time.
class SerialPort {
 public:
  /// Opens exclusively. @return an error that names the port, the reason and the remedy (group, busy, absent, speed)
  [[nodiscard]] static Result<SerialPort> open(const std::string& path, int baud);

  SerialPort(SerialPort&& other) noexcept;
  SerialPort& operator=(SerialPort&& other) noexcept;
  ~SerialPort();

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] int file() const { return file_; }
  /// @return false when the port is gone or took nothing for 50 ms
  [[nodiscard]] bool write(std::span<const std::uint8_t> bytes);
  /// Waits until something came or `deadline` has passed. @return bytes read; 0 when none came; −1 when the port is
  /// gone
  [[nodiscard]] int read(std::span<std::uint8_t> buffer, Instant deadline);
  /// Forgets what has arrived; what is being sent goes on.
  void flush();

 private:
  SerialPort(std::string path, int file) : path_(std::move(path)), file_(file) {}
  std::string path_;
  int file_ = -1;
};

}  // namespace fyd::device
