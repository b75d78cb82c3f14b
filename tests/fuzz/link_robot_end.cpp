// A touchpad with the right key that says anything, and strangers that send anything: the robot's end gives only
// touches in range and whole pictures, and sends only to its touchpad.
#include "tests/fuzz/link_session.h"

using namespace fyd;
using namespace fyd::fuzz;

namespace {

struct Start {
  LinkRobotEnd end{{}, fuzzKey(), fuzzPeer(), countingRandom};
  Sealer sealer;
  Instant now = instantAt(100.0);
};

constexpr LinkTime kSent_us = 9'000'000;

// A session in its first millisecond, made once and copied for each input.
const Start& start() {
  static const Start made = [] {
    Start out;
    const auto sent = [&] {
      const auto datagrams = out.end.tick(out.now, {});
      require(datagrams.size() == 1);
      return std::vector<std::uint8_t>(datagrams[0].bytes.begin(), datagrams[0].bytes.end());
    };
    HelloNonce nonce{};
    require(readHello(fuzzKey(), sent(), nonce) == LinkRefusal::none);
    static_cast<void>(out.end.handle(makeChallenge(fuzzKey(), nonce, {}), fuzzPeer(), out.now));
    const auto call = sent();
    Callee callee(fuzzKey(), call);
    std::array<std::uint8_t, kMaximumLinkDatagram> buffer{};
    const auto hello = decodeRobotHello(callee.read(call, buffer).value_or(Bytes{}));
    require(hello.ok());
    const TouchpadHello own{.sent_us = kSent_us, .echo_us = hello.value.sent_us, .board_text = "board"};
    std::array<std::uint8_t, 200> payload{};
    const std::size_t size = callee.write(Bytes(payload).first(encodeHello(own, payload)), countingRandom, buffer);
    require(out.end.handle(Bytes(buffer).first(size), fuzzPeer(), out.now).connected);
    out.sealer = Sealer(callee.keys().from_responder, sessionOf(callee.keys()));
    return out;
  }();
  return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  Start s = start();
  LinkTime now_us = kSent_us;
  while (!input.empty()) {
    const std::uint8_t what = input.byte();
    const std::uint8_t wait_ms = input.byte();
    s.now += std::chrono::milliseconds(wait_ms);
    now_us += LinkTime{wait_ms} * 1'000;
    if (what % 8 == 7) static_cast<void>(s.end.command(static_cast<pipeline::RobotCommand>(what / 8 % 12)));
    for (const Datagram& datagram : s.end.tick(s.now, {})) {
      require(datagram.to == fuzzPeer() && sortDatagram(datagram.bytes).refusal == LinkRefusal::none);
    }
    const auto content = input.bytes();
    RobotReception got;
    if (what % 4 != 0) {
      got = s.end.handle(sealed(s.sealer, content, now_us), fuzzPeer(), s.now);
    } else {
      got = s.end.handle(content, fuzzPeer(static_cast<std::uint16_t>(1 + what % 3)), s.now);
      require(!got.touch && !got.image && !got.connected);
    }
    if (got.touch) require(got.touch->position_mm.finite() && got.touch->force_N >= 0.0);
    if (got.image) require(!s.end.image().empty() && s.end.image().size() <= kMaximumLinkImage);
    require(s.end.boardText().size() <= kMaximumBoardText);
  }
  return 0;
}
