// A Modbus TCP touchpad that keeps to the register map's page (resources/manual/modbus.md) or breaks it at random. Raw
// sockets and the page's own numbers: none of the program's codecs.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <mutex>
#include <random>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace fyd::attack {

using Words = std::array<std::uint16_t, 26>;  // registers 64 to 89
using Bytes = std::vector<std::uint8_t>;

/// What the page says of registers 64 to 89, by their address.
struct Page {
  const Words& words;
  [[nodiscard]] std::uint16_t at(int address) const { return words[static_cast<std::size_t>(address - 64)]; }
  [[nodiscard]] int number(int address) const { return static_cast<std::int16_t>(at(address)); }

  /// Empty: a master may take this block as the answer to a question with this nonce.
  [[nodiscard]] std::string problem(std::uint16_t nonce) const {
    if (at(65) != nonce) return "nonce";
    if (at(64) != at(89)) return "torn";
    const int status = at(68);
    bool state = false;
    for (const auto& [mask, bits] : {std::pair{0x4F, 0x00},
                                     {0x4F, 0x40},
                                     {0x6F, 0x21},
                                     {0x6F, 0x23},
                                     {0x6F, 0x27},
                                     {0x6F, 0x07},
                                     {0x4F, 0x0F},
                                     {0x4F, 0x08}}) {
      state = state || (status & mask) == bits;
    }
    if (!state) return "status";
    for (const int ir : {74, 75, 76}) {
      if (at(ir) > 4095) return "ir";
    }
    for (const int motor : {0, 1}) {
      if (at(79 + motor) > 4095) return "encoder";
      if (std::abs(number(81 + motor)) > 10'000) return "current";
      if (number(83 + motor) != -32768 && std::abs(number(83 + motor)) > 10'000) return "duty";
      if (number(85 + motor) < -400 || number(85 + motor) > 2000) return "temperature";
    }
    return {};
  }
  [[nodiscard]] bool obeys() const { return (at(68) & 0x0200) != 0; }
  [[nodiscard]] std::uint32_t uptime() const { return (std::uint32_t{at(66)} << 16U) | at(67); }
  [[nodiscard]] float bridge() const { return std::bit_cast<float>((std::uint32_t{at(70)} << 16U) | at(71)); }
};

enum class Verdict : std::uint8_t { take, refuse, either };

/// The last reply as it was sent.
struct Sent {
  std::string kind;
  Verdict verdict = Verdict::refuse;
  Words words{};
  std::uint16_t control_word = 0;
  std::uint64_t number = 0;
};

class Device {
 public:
  explicit Device(std::uint64_t seed) : random_(seed), listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 || ::listen(listener_, 4) != 0) {
      std::perror("hostile device");
      std::exit(1);
    }
    socklen_t size = sizeof address;
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    for (const int ir : {74, 75, 76}) word(ir) = 1700;
    word(68) = 0x0250;
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }
  ~Device() {
    thread_.request_stop();
    ::shutdown(listener_, SHUT_RDWR);
    thread_.join();
    ::close(listener_);
  }
  [[nodiscard]] std::string address() const { return fmt::format("modbus-tcp:127.0.0.1:{}", port_); }
  [[nodiscard]] Sent last() const {
    const std::scoped_lock lock(mutex_);
    return last_;
  }
  [[nodiscard]] std::map<std::string, std::uint64_t> kinds() const {
    const std::scoped_lock lock(mutex_);
    return kinds_;
  }
  std::atomic<bool> hostile{true};

 private:
  std::uint16_t& word(int address) { return state_[static_cast<std::size_t>(address - 64)]; }
  std::uint64_t upTo(std::uint64_t n) { return random_() % n; }
  template <class Integer>
  void flip(Integer& value, std::uint64_t bits) {
    value = static_cast<Integer>(value ^ (1U << upTo(bits)));
  }

  void run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      const int client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      if (client < 0) return;
      const int yes = 1;
      ::setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
      Bytes request;
      while (!stop.stop_requested() && receive(client, request) && answer(client, request)) {
      }
      ::close(client);
    }
  }

  static bool receive(int client, Bytes& request) {
    request.assign(6, 0);
    const auto whole = [client](std::uint8_t* at, std::size_t size) {
      while (size > 0) {
        pollfd ready{.fd = client, .events = POLLIN, .revents = 0};
        if (::poll(&ready, 1, 5000) <= 0) return false;
        const ssize_t got = ::recv(client, at, size, 0);
        if (got <= 0) return false;
        at += got;
        size -= static_cast<std::size_t>(got);
      }
      return true;
    };
    if (!whole(request.data(), 6)) return false;
    const std::size_t rest = static_cast<std::size_t>((request[4] << 8) | request[5]);
    request.resize(6 + rest);
    return whole(request.data() + 6, rest);
  }

  static void send(int client, const Bytes& bytes) {
    if (!bytes.empty()) (void)!::send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }
  /// MBAP header, unit, function, then the rest.
  static Bytes frame(const Bytes& request, std::uint8_t function, const Bytes& rest) {
    Bytes out = {request[0], request[1], 0, 0, 0, static_cast<std::uint8_t>(2 + rest.size()), request[6], function};
    out.insert(out.end(), rest.begin(), rest.end());
    return out;
  }
  static Bytes registers(std::span<const std::uint16_t> words) {
    Bytes out = {static_cast<std::uint8_t>(2 * words.size())};
    for (const std::uint16_t value : words) {
      out.push_back(static_cast<std::uint8_t>(value >> 8U));
      out.push_back(static_cast<std::uint8_t>(value & 0xFFU));
    }
    return out;
  }

  /// @return false to end the connection
  bool answer(int client, const Bytes& request) {
    if (request[7] == 0x03) {
      std::array<std::uint16_t, 15> identity = {0x4659, 0x4454, 0x0100, 0x0100, 0x4153, 0, 0, 0, 0, 0, 0, 0, 3, 2, 32};
      if (hostile && upTo(20) == 0) flip(identity.at(upTo(15)), 16);
      send(client, frame(request, 0x03, registers(identity)));
      return true;
    }
    if (request[7] == 0x10) {
      send(client, frame(request, 0x10, {request[8], request[9], request[10], request[11]}));
      return true;
    }
    const auto written = [&](int address) {
      const auto at = 17 + 2 * static_cast<std::size_t>(address - 128);
      return static_cast<std::uint16_t>((request[at] << 8) | request[at + 1]);
    };
    live(written(128), written(130));
    const std::uint64_t dice = hostile ? upTo(100) : 0;
    if (dice < 35) return reply(client, request, written, "healthy", state_, Verdict::take);
    if (dice < 85) return replyWithStrangeValues(client, request, written);
    return replyWithStrangeFrame(client, request, written);
  }

  /// A healthy device's next set of values, 4 ms later.
  void live(std::uint16_t control_word, std::uint16_t nonce) {
    word(89) = ++word(64);
    word(65) = nonce;
    const std::uint32_t uptime = ((std::uint32_t{word(66)} << 16U) | word(67)) + 4000U;
    word(66) = static_cast<std::uint16_t>(uptime >> 16U);
    word(67) = static_cast<std::uint16_t>(uptime);
    const int base = control_word == 0x0F ? 0x27 : control_word == 0x07 ? 0x23 : control_word == 0x06 ? 0x21 : 0x40;
    word(68) = static_cast<std::uint16_t>(0x0210 | base);
    word(69) = 0;
    const auto bridge = std::bit_cast<std::uint32_t>(0.1F + 1e-4F * static_cast<float>(upTo(100)));
    word(70) = static_cast<std::uint16_t>(bridge >> 16U);
    word(71) = static_cast<std::uint16_t>(bridge);
    word(72) = static_cast<std::uint16_t>(upTo(80));
    ++word(73);
    for (const int ir : {74, 75, 76}) word(ir) = static_cast<std::uint16_t>(1700 + upTo(30));
    word(77) = static_cast<std::uint16_t>(upTo(160));
    ++word(78);
    for (const int motor : {0, 1}) {
      word(79 + motor) = static_cast<std::uint16_t>(200 + upTo(3));
      word(81 + motor) = static_cast<std::uint16_t>(upTo(300));
      word(83 + motor) = 0x8000;
      word(85 + motor) = 250;
    }
  }

  template <class Written>
  bool reply(int client, const Bytes& request, const Written& written, const std::string& kind, const Words& words,
             Verdict verdict) {
    note(kind, words, verdict, written(128));
    send(client, frame(request, 0x17, registers(words)));
    return true;
  }

  void note(const std::string& kind, const Words& words, Verdict verdict, std::uint16_t control_word) {
    const std::scoped_lock lock(mutex_);
    last_ = {
        .kind = kind, .verdict = verdict, .words = words, .control_word = control_word, .number = last_.number + 1};
    ++kinds_[kind];
  }

  template <class Written>
  bool replyWithStrangeValues(int client, const Bytes& request, const Written& written) {
    Words words = state_;
    std::string kind = "values";
    const auto put = [&](int address, std::uint64_t value) {
      words[static_cast<std::size_t>(address - 64)] = static_cast<std::uint16_t>(value);
    };
    const auto putFloat = [&](float value) {
      const auto bits = std::bit_cast<std::uint32_t>(value);
      put(70, bits >> 16U);
      put(71, bits);
    };
    constexpr std::array<std::uint16_t, 8> kExtremes = {0, 1, 0x7FFF, 0x8000, 0xFFFF, 4095, 4096, 10'001};
    switch (upTo(9)) {
      case 0:  // any register, any extreme
        put(64 + static_cast<int>(upTo(26)), kExtremes.at(upTo(8)));
        break;
      case 1: {  // flipped bits
        for (std::uint64_t flips = 1 + upTo(4); flips > 0; --flips) flip(words.at(upTo(26)), 16);
        kind = "flipped bits";
        break;
      }
      case 2:
        for (std::uint16_t& value : words) value = static_cast<std::uint16_t>(random_());
        put(65, written(130));  // the worst: it echoes the nonce
        put(89, words[0]);
        kind = "noise that echoes the nonce";
        break;
      case 3: {
        constexpr std::array kBridges = {7.77F, -7.77F, 1e30F, -1e30F, 1e-40F};
        putFloat(upTo(3) == 0   ? std::numeric_limits<float>::quiet_NaN()
                 : upTo(2) == 0 ? std::numeric_limits<float>::infinity()
                                : kBridges.at(upTo(5)));
        kind = "bridge";
        break;
      }
      case 4:
        put(85 + static_cast<int>(upTo(2)), upTo(2) == 0 ? 0x7FFF : 0x8000);
        kind = "temperature";
        break;
      case 5:
        put(68, words[4] & ~0x0200U);
        kind = "does not obey";
        break;
      case 6:  // a device whose values stand still; the nonce lives
        if (frozen_left_ == 0) {
          frozen_left_ = 1 + upTo(upTo(10) == 0 ? 150 : 6);
          frozen_ = state_;
        }
        break;
      case 7:
        put(65, written(130) - 1 - upTo(3));
        kind = "old nonce";
        break;
      default:
        put(64, random_());
        kind = "sequence";
        break;
    }
    if (frozen_left_ > 0) {
      --frozen_left_;
      words = frozen_;
      put(65, written(130));
      kind = "values stand still";
    }
    const Verdict verdict = Page{words}.problem(written(130)).empty() ? Verdict::take : Verdict::refuse;
    return reply(client, request, written, kind, words, verdict);
  }

  template <class Written>
  bool replyWithStrangeFrame(int client, const Bytes& request, const Written& written) {
    const Bytes good = frame(request, 0x17, registers(state_));
    Bytes bytes = good;
    const auto say = [&](const char* kind, Verdict verdict = Verdict::refuse) {
      note(kind, state_, verdict, written(128));
    };
    switch (upTo(14)) {
      case 0:
        flip(bytes[0], 8);
        say("another transaction");
        break;
      case 1:
        flip(bytes[2 + upTo(2)], 8);
        say("another protocol", Verdict::either);  // libmodbus looks at both bytes only together; the nonce proves
        break;
      case 2:
        flip(bytes[4 + upTo(2)], 8);
        say("wrong length in the header", Verdict::either);
        break;
      case 3:
        flip(bytes[6], 8);
        say("another unit", Verdict::either);  // over TCP the connection tells who answers
        break;
      case 4:
        bytes[7] = static_cast<std::uint8_t>(random_());
        say("another function", bytes[7] == 0x17 ? Verdict::either : Verdict::refuse);
        break;
      case 5:
        flip(bytes[8], 8);
        say("wrong count of bytes");
        break;
      case 6:
        bytes = frame(request, 0x97, {static_cast<std::uint8_t>(upTo(2) == 0 ? 1 + upTo(11) : upTo(256))});
        say("exception");
        break;
      case 7:
        bytes.resize(upTo(bytes.size()));
        say("cut short");
        break;
      case 8:
        bytes.insert(bytes.end(), 1 + upTo(300), static_cast<std::uint8_t>(random_()));
        say("bytes behind it", Verdict::either);
        break;
      case 9:
        bytes.insert(bytes.end(), good.begin(), good.end());
        say("twice", Verdict::either);
        break;
      case 10:
        bytes.assign(1 + upTo(400), 0);
        for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random_());
        say("noise");
        break;
      case 11: say("connection closed"); return false;
      case 12:
        send(client, {bytes.begin(), bytes.begin() + 20});
        say("closed within it");
        return false;
      default:
        note("in pieces", state_, Verdict::take, written(128));
        for (std::size_t at = 0; at < bytes.size(); at += 7) {
          send(client, {bytes.begin() + static_cast<std::ptrdiff_t>(at),
                        bytes.begin() + static_cast<std::ptrdiff_t>(std::min(at + 7, bytes.size()))});
        }
        return true;
    }
    send(client, bytes);
    return true;
  }

  std::mt19937_64 random_;
  int listener_;
  std::uint16_t port_ = 0;
  Words state_{};
  Words frozen_{};
  std::uint64_t frozen_left_ = 0;
  mutable std::mutex mutex_;
  Sent last_;
  std::map<std::string, std::uint64_t> kinds_;
  std::jthread thread_;
};

}  // namespace fyd::attack
