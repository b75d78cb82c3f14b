// A touchpad of one's own: a board on a serial port that speaks lines of text (a made-up protocol). The same program
// plays the board at the other end of a pseudo-terminal, and then unplugs it.
//
//   to the board     "7 2100 -2100 0.0 0.0 1\n"          number, two references in ticks, two duties in %, active
//   from the board   "7 1203 1188 1190 0.231 2048 2050\n"  the same number, three distances, bridge, two encoders
#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/device/serial_port.h"
#include "core/device/touchpad/touchpad.h"

using namespace fyd;
using namespace fyd::device;

class TextTouchpad final : public Touchpad {
 public:
  explicit TextTouchpad(std::string path) : path_(std::move(path)) {}

  Message description() const override { return verbatim("text board at " + path_); }

  // One exchange. What came late from an earlier one has another number and is passed over: a reading is never older
  // than the command it answers.
  Result<TouchpadReadings> exchange(const control::MotorCommand& command, Instant now) override {
    if (!port_) {
      auto opened = SerialPort::open(path_, 115'200);
      if (!opened) return tl::unexpected(opened.error());
      port_ = std::move(*opened);
    }
    ++number_;
    const std::string asked =
        fmt::format("{} {} {} {:.1f} {:.1f} {:d}\n", number_, command.reference_ticks[0], command.reference_ticks[1],
                    command.vibration_duty_percent[0], command.vibration_duty_percent[1], command.active);
    if (!port_->write({reinterpret_cast<const std::uint8_t*>(asked.data()), asked.size()})) return lost();
    const Instant deadline = now + std::chrono::milliseconds(20);
    std::string line;
    std::uint8_t byte = 0;
    while (true) {
      const int count = port_->read({&byte, 1}, deadline);
      if (count < 0) return lost();
      if (count == 0) return fail("{}: no answer within 20 ms; is it switched on?", path_);
      if (byte != '\n') {
        if (line.size() < kLongestLine) line += static_cast<char>(byte);
        continue;
      }
      const auto taken = take(line, now);
      if (!taken) return tl::unexpected(taken.error());
      if (*taken) return readings_;
      line.clear();
    }
  }

  Duration period() const override { return std::chrono::milliseconds(5); }

 private:
  static constexpr std::size_t kLongestLine = 200;

  // Only a whole answer to the newest question is believed: false for any other. What cannot be in it is an error.
  Result<bool> take(const std::string& line, Instant now) {
    unsigned number = 0;
    std::array<int, 3> distance{};
    std::array<int, 2> encoder{};
    double bridge = 0.0;
    if (std::sscanf(line.c_str(), "%u %d %d %d %lf %d %d", &number, &distance[0], &distance[1], &distance[2], &bridge,
                    &encoder[0], &encoder[1]) != 7 ||
        number != number_) {
      return false;
    }
    sensing::IrCounts counts;
    for (const int each : distance) {
      if (each < 0 || each > 4095) return fail("{}: distance code {}; expected 0 to 4095", path_, each);
      (void)counts.push(static_cast<std::uint16_t>(each));
    }
    control::MotorFeedback motors;
    for (std::size_t i = 0; i < encoder.size(); ++i) {
      if (encoder[i] < 0 || encoder[i] >= control::kEncoderCountsPerTurn) {
        return fail("{}: encoder {} reads {}; expected 0 to {}", path_, i + 1, encoder[i],
                    control::kEncoderCountsPerTurn - 1);
      }
      motors.encoder_counts[i] = static_cast<std::uint16_t>(encoder[i]);
    }
    readings_.ir.set(counts, now);
    readings_.bridge.set({bridge}, now);
    readings_.motors.set(motors, now);
    return true;
  }

  // Opened anew by the next exchange.
  tl::unexpected<Error> lost() {
    port_.reset();
    return fail("{}: the port is gone; is it plugged in?", path_);
  }

  std::string path_;
  std::optional<SerialPort> port_;
  TouchpadReadings readings_;
  unsigned number_ = 0;
};

int main() {
  const int board = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (board < 0 || ::grantpt(board) != 0 || ::unlockpt(board) != 0) return 1;
  std::jthread plays([board] {  // answers three times, then falls silent
    std::string line;
    char byte = 0;
    for (int answers = 0; answers < 3 && ::read(board, &byte, 1) == 1;) {
      line += byte;
      if (byte != '\n') continue;
      const std::string answer = line.substr(0, line.find(' ')) + " 1203 1188 1190 0.231 2048 2050\n";
      (void)!::write(board, answer.data(), answer.size());
      line.clear();
      ++answers;
    }
  });
  TextTouchpad touchpad(::ptsname(board));
  for (int i = 0; i < 4; ++i) {
    const auto readings = touchpad.exchange({.reference_ticks = {2100, -2100}}, Clock::now());
    if (!readings) {
      const std::string problem = readings.error().text();
      fmt::print("problem: {}\n", problem.substr(problem.find(": ") + 2));
      continue;
    }
    fmt::print("reading {}: distances {}, bridge {} mV/V, encoder {}\n", readings->ir.count,
               fmt::join(readings->ir.value, " "), readings->bridge.value.value_mV_per_V,
               readings->motors.value.encoder_counts[0]);
  }
  plays.join();
  ::close(board);
}
