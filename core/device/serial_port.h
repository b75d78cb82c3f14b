// A serial port in raw 8N1 mode. Its speed is read back after it was set, because a driver that does not support a
// speed keeps another one without an error.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <termios.h>

#include "core/base/error.h"
#include "core/base/time.h"

namespace fyd::device {

/// The termios constant of a speed, B0 when the system has none.
[[nodiscard]] speed_t speedConstant(int baud);
/// Speed of a constant, Bd; 0 for a constant that is no speed.
[[nodiscard]] int baudOf(speed_t constant);
/// @return an error when the port runs at another speed than `baud`
[[nodiscard]] Result<void> checkSpeed(int file, int baud, const std::string& path);
/// Locks the port against other processes of this program until the file is closed or the process ends.
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
  /// @return false when the port is gone or accepted no byte for 50 ms
  [[nodiscard]] bool write(std::span<const std::uint8_t> bytes);
  /// Waits until something came or `deadline` has passed. @return bytes read; 0 when none came; −1 when the port is
  /// gone
  [[nodiscard]] int read(std::span<std::uint8_t> buffer, Instant deadline);
  /// Discards received bytes; pending output is still sent.
  void flush();

 private:
  SerialPort(std::string path, int file) : path_(std::move(path)), file_(file) {}
  std::string path_;
  int file_ = -1;
};

}  // namespace fyd::device
