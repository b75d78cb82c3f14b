// One direction of a network path: when, whether and how often a datagram handed in comes out. Pure and seeded: the
// same datagrams at the same times with the same seed give the same result.
//
//   queue     the line takes bits / rate for a datagram (IP and UDP headers, 28 bytes, included); a datagram that would
//             wait longer than `queue_ms` for the line is dropped
//   delay     d = delay + jitter · g, g normal, cut at ±3 and at d ≥ 0; with a trace, delay is the trace's: one row
//             after another for the datagrams, or by time where the rows have times; the trace repeats; NaN: lost
//   order     nothing overtakes: d grows until the datagram before is out. A reordered one is held `reorder_by_ms`
//             longer and does not hold those behind it
//   loss, reorder, duplicate   independent, each with its share; a copy comes out right behind its original
//
// The order of the random draws is fixed (loss, jitter, reorder, duplicate; all drawn for each datagram), so that one
// share can be changed without changing the results of the others.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/batch.h"
#include "core/base/error.h"
#include "core/base/time.h"

namespace fyd::sim {

struct DelayTrace {
  std::vector<double> t_s;  ///< empty: one row for each datagram; else from 0, rising
  std::vector<double> delay_ms;
};

struct NetworkSettings {
  double delay_ms = 0.0;      ///< 0…60 000
  double jitter_ms = 0.0;     ///< standard deviation, 0…10 000
  double loss_percent = 0.0;  ///< 0…100, as the following
  double reorder_percent = 0.0;
  double duplicate_percent = 0.0;
  double rate_bit_per_s = 0.0;  ///< 0: without limit
  double queue_ms = 500.0;      ///< 0…60 000
  double reorder_by_ms = 10.0;  ///< 0…10 000
  std::uint64_t seed = 1;
  DelayTrace trace;
};

/// @return an error that names the setting, its value and its range
[[nodiscard]] Result<void> checkNetwork(const NetworkSettings& settings);

/// Both directions of a path; the forward one leads from the caller to the called side.
struct NetworkProfile {
  NetworkSettings forward;
  NetworkSettings backward;
};

inline constexpr std::array<std::string_view, 3> kNetworkProfiles = {"isdn", "adsl", "lan"};

/// isdn: 64 kbit/s, 15 ms each way. adsl: 1 and 8 Mbit/s, 75 ms. lan: 100 Mbit/s, 5 ms. Round trips as the tele-gesture
/// paper reports them (30, 100–200 and about 10 ms); jitter, loss and ADSL's rates are assumptions.
/// @return an error for another name
[[nodiscard]] Result<NetworkProfile> networkProfile(std::string_view name);

/// Reads columns `t_s, delay_ms`, or `delay_ms` alone, of a CSV file.
/// @return an error with file and line: no rows, a delay below 0, times that do not rise from 0
[[nodiscard]] Result<DelayTrace> readDelayTrace(const std::string& path);
/// The same of such a file's text. @param source_name the file's, for messages
[[nodiscard]] Result<DelayTrace> parseDelayTrace(std::string_view text, const std::string& source_name);

enum class DatagramFate : std::uint8_t { passed, lost, queue_full };

struct Passage {
  DatagramFate fate = DatagramFate::passed;
  bool reordered = false;
  Batch<Instant, 2> out;  ///< when it comes out; a second time: its copy
};

class NetworkEmulator {
 public:
  /// @param settings as checkNetwork accepts them
  explicit NetworkEmulator(NetworkSettings settings);

  /// @param now not before the last call's (earlier ones count as that)
  [[nodiscard]] Passage pass(std::size_t bytes, Instant now);

 private:
  [[nodiscard]] double baseDelay_ms(Instant now);

  NetworkSettings settings_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::size_t next_row_ = 0;
  bool started_ = false;
  Instant began_{};
  Instant last_{};
  Instant line_free_{};
  Instant last_out_{};
};

}  // namespace fyd::sim
