// FYD Link and the classic codec: time of one message beside a copy of its bytes and libsodium alone, and what each
// protocol needs on the line for the same content.
#include <cstring>

#include <sodium/crypto_aead_chacha20poly1305.h>

#include "app/bench/parts/allocation_count.h"
#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/table.h"
#include "core/protocol/classic/classic_codec.h"
#include "core/protocol/link/link_codec.h"
#include "core/protocol/link/link_keys.h"
#include "core/protocol/link/secure_channel.h"

namespace fyd::bench {
namespace {

using namespace protocol;

int timings() { return wholeOrQuick(4'000, 200); }
constexpr int kCallsPerSample = 16;
constexpr std::size_t kRobotSamples = 10;
constexpr std::size_t kHeaders = 28;  // IPv4 and UDP

using Packet = std::array<std::uint8_t, kMaximumLinkDatagram>;

struct Row {
  std::string message;
  std::string name;
  std::size_t bytes = 0;
  double p50_ns = 0.0;
  double p99_ns = 0.0;
  std::uint64_t allocations = 0;
};

template <class T>
void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// Times `call(i)` with i increasing; several calls between two readings of the clock.
template <class Call>
Row measure(const std::string& message, const std::string& name, std::size_t bytes, Call&& call) {
  std::size_t i = 0;
  const auto several = [&] {
    for (int n = 0; n < kCallsPerSample; ++n) call(i++);
  };
  const AllocationCount allocations;
  several();
  const std::uint64_t allocated = allocations.count();  // before the row, which allocates too
  Row row{.message = message, .name = name, .bytes = bytes, .allocations = allocated};
  std::vector<double> times = timeEach(timings(), several);
  for (double& time : times) time /= kCallsPerSample;
  const Quantiles q = quantiles(times);
  row.p50_ns = q.p50;
  row.p99_ns = q.p99;
  return row;
}

LinkTouch touch() {
  return {.sequence = 7,
          .age_s = 500e-6,
          .position_mm = {10, -5, -2.5},
          .in_contact = true,
          .force_N = 1.0,
          .indentation_mm = 2.5};
}
LinkState state(std::size_t samples) {
  LinkState out{.sequence = 9, .robot = {.stiffness_N_per_mm = 0.62, .position_mm = {1, 2, -3}, .force_N = 1.5}};
  for (std::size_t i = 0; i < samples; ++i) {
    (void)out.accelerations.push({.age_s = 1e-3 * static_cast<double>(i), .acceleration_g = {0.4, -1.2, 0.03}});
  }
  return out;
}

/// Encode + seal, open + decode, and what they are compared with, of one kind of message.
template <class Message, class Decode>
void linkRows(std::vector<Row>& rows, const std::string& name, const Message& message, const PositionCode& code,
              Decode&& decode) {
  const SecretBytes<32> key = LinkKey::generate().handshakeKey();
  Sealer sealer(key, 1);
  Packet packet{};
  const std::size_t plain = encodeLink(message, code, 1, Sealer::messagePart(packet));
  const std::size_t size = sealer.seal(packet, plain);
  Packet copy{};
  rows.push_back(measure(name, "copy of its bytes", size, [&](std::size_t) {
    std::memcpy(copy.data(), packet.data(), size);
    keep(copy);
  }));
  const std::array<std::uint8_t, 12> nonce{};
  rows.push_back(measure(name, "libsodium's seal alone (baseline)", size, [&](std::size_t) {
    crypto_aead_chacha20poly1305_ietf_encrypt(copy.data() + kSealHeader, nullptr, copy.data() + kSealHeader, plain,
                                              copy.data(), kSealHeader, nullptr, nonce.data(), key.data());
    keep(copy);
  }));
  rows.push_back(measure(name, "encode + seal", size, [&](std::size_t) {
    (void)sealer.seal(packet, encodeLink(message, code, 1, Sealer::messagePart(packet)));
    keep(packet);
  }));
  // An opener refuses what it has opened, so each message is sealed anew; it lies where only it does, as a received one.
  std::vector<Packet> sent((static_cast<std::size_t>(timings()) + 1) * kCallsPerSample);
  Sealer fresh(key, 1);
  for (Packet& out : sent) (void)fresh.seal(out, encodeLink(message, code, 1, Sealer::messagePart(out)));
  Opener opener(key, 1);
  std::size_t next = 0;
  std::uint64_t good = 0;
  rows.push_back(measure(name, "open + decode", size, [&](std::size_t) {
    const Opened opened = opener.open(Bytes(sent[next++]).first(size), copy);
    good += decode(decodeEnvelope(opened.message).value).ok() ? 1 : 0;
  }));
  if (good != sent.size()) rows.back().name += " (FAILED)";
}

void classicRows(std::vector<Row>& rows) {
  const ClassicState robot{.acceleration_g = {0.4, -1.2, 0.03}, .robot = {.stiffness_N_per_mm = 0.612}};
  const pipeline::TouchMessage finger{.position_mm = {12.3, -7.9, -3.1}, .in_contact = true, .force_N = 1.2345};
  auto state_bytes = encodeState(robot);
  auto touch_bytes = encodeTouch(finger);
  const auto copies = [&rows](const char* message, const auto& bytes) {
    auto copy = bytes;
    rows.push_back(measure(message, "copy of its bytes (baseline)", bytes.size(), [&](std::size_t) {
      std::memcpy(copy.data(), bytes.data(), bytes.size());
      keep(copy);
    }));
  };
  copies("classic state", state_bytes);
  rows.push_back(measure("classic state", "encode", kClassicStateSize, [&](std::size_t) {
    state_bytes = encodeState(robot);
    keep(state_bytes);
  }));
  rows.push_back(measure("classic state", "decode", kClassicStateSize, [&](std::size_t) {
    keep(state_bytes);
    keep(decodeState(state_bytes));
  }));
  copies("classic touch", touch_bytes);
  rows.push_back(measure("classic touch", "encode", kClassicTouchSize, [&](std::size_t) {
    touch_bytes = encodeTouch(finger);
    keep(touch_bytes);
  }));
  rows.push_back(measure("classic touch", "decode", kClassicTouchSize, [&](std::size_t) {
    keep(touch_bytes);
    keep(decodeTouch(touch_bytes));
  }));
}

std::string flow(double bytes, double per_s) {
  return fmt::format("{:.1f} kB/s", 1e-3 * per_s * (bytes + static_cast<double>(kHeaders)));
}

}  // namespace

Table bench_link() {
  const PositionCode touch_code = *PositionCode::make(asOnTheWire(TouchpadHello{}.workspace));
  const PositionCode robot_code = *PositionCode::make(asOnTheWire(RobotHello{}.workspace));
  std::vector<Row> rows;
  linkRows(rows, "link touch", touch(), touch_code,
           [&](const LinkEnvelope& message) { return decodeTouch(message, touch_code); });
  linkRows(rows, "link state of 10 samples", state(kRobotSamples), robot_code,
           [&](const LinkEnvelope& message) { return decodeState(message, robot_code); });
  classicRows(rows);

  Table table{.subject = "link",
              .title = "FYD Link and the classic codec",
              .columns = {{"message", Role::group},
                          {"operation", Role::method},
                          "bytes",
                          {"p50", "ns", Role::cost},
                          {"p99", "ns"},
                          "allocations"}};
  for (const Row& row : rows) {
    table.rows.push_back({row.message, row.name, fmt::format("{}", row.bytes), number(row.p50_ns), number(row.p99_ns),
                          fmt::format("{}", row.allocations)});
  }
  Packet packet{};
  const auto sealed = [&](std::size_t plain) { return static_cast<double>(plain + kSealOverhead); };
  const double touch_bytes = sealed(encodeLink(touch(), touch_code, 1, packet));
  const double beat_bytes = sealed(encodeLink(LinkHeartbeat{}, 1, packet));
  const double state1 = sealed(encodeLink(state(1), robot_code, 1, packet));
  const double state10 = sealed(encodeLink(state(kRobotSamples), robot_code, 1, packet));
  table.notes = {
      fmt::format("Robot to touchpad, 1000 accelerations a second, IPv4 and UDP headers counted: classic {}; FYD Link "
                  "at 1 kHz {}, at 100 states {}, and {} of heartbeats at 100 a second.",
                  flow(kClassicStateSize, 1e3), flow(state1, 1e3), flow(state10, 100.0), flow(beat_bytes, 100.0)),
      fmt::format("Touchpad to robot: classic {} (1 kHz, whole mm); FYD Link at 1 kHz {}, at 100 Hz {} (0.02 mm, "
                  "indentation and times besides), and as many heartbeats.",
                  flow(kClassicTouchSize, 1e3), flow(touch_bytes, 1e3), flow(touch_bytes, 100.0)),
      fmt::format("{} calls between two looks at the clock. What is encoded is the same message again and again, in "
                  "warm caches; "
                  "what is opened is another each time, from memory.",
                  kCallsPerSample)};
  return table;
}

}  // namespace fyd::bench
