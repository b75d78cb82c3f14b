// A robot with the right key that says anything in any order, and strangers that send anything: the touchpad's end
// gives only values in range, answers only what it must, and its counters add up.
#include "tests/fuzz/link_session.h"

using namespace fyd;
using namespace fyd::fuzz;

namespace {

struct Start {
  LinkTouchpadEnd end{LinkParameters{}, fuzzKey(), countingRandom};
  Sealer sealer;
  Instant now = instantAt(100.0);
  LinkTime offset_us = 0;
};

// A session in its first millisecond, made once and copied for each input.
const Start& start() {
  static const Start made = [] {
    Start out;
    HelloNonce nonce{};
    Cookie cookie{};
    const TouchpadAnswer answer;
    const auto& challenge = out.end.handle(makeHello(fuzzKey(), nonce), fuzzPeer(), out.now, answer);
    require(readChallenge(fuzzKey(), challenge.replies[0].bytes, nonce, cookie) == LinkRefusal::none);
    Caller caller(fuzzKey(), cookie, countingRandom);
    std::array<std::uint8_t, kMaximumLinkDatagram> buffer{};
    std::array<std::uint8_t, 200> hello{};
    const std::size_t size = caller.write(Bytes(hello).first(encodeHello(RobotHello{.sent_us = 1}, hello)), buffer);
    const auto& reply = out.end.handle(Bytes(buffer).first(size), fuzzPeer(), out.now, answer);
    std::array<std::uint8_t, kMaximumLinkDatagram> plain{};
    const auto payload = caller.read(reply.replies[0].bytes, plain);
    require(payload.has_value());
    const auto touchpad = decodeTouchpadHello(*payload);
    out.sealer = Sealer(caller.keys().from_initiator, sessionOf(caller.keys()));
    std::array<std::uint8_t, 200> packet{};
    const std::size_t beat = encodeLink(LinkHeartbeat{.echo_us = touchpad.value.sent_us}, touchpad.value.sent_us,
                                        Sealer::messagePart(packet));
    const Bytes confirmation = Bytes(packet).first(out.sealer.seal(packet, beat));
    require(out.end.handle(confirmation, fuzzPeer(), out.now, answer).session_started);
    out.offset_us = touchpad.value.sent_us;
    return out;
  }();
  return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  Start s = start();
  TouchpadAnswer answer;
  answer.touch = {.position_mm = {1, 2, -3}, .in_contact = true, .force_N = 1.0};
  answer.board_text = "board";
  LinkTime now_us = s.offset_us;
  while (!input.empty()) {
    const std::uint8_t what = input.byte();
    const std::uint8_t wait_ms = input.byte();
    s.now += std::chrono::milliseconds(wait_ms);
    now_us += LinkTime{wait_ms} * 1'000;
    for (const Datagram& datagram : s.end.advance(s.now, answer)) {
      require(datagram.to == fuzzPeer() && datagram.bytes.size() <= kMaximumLinkDatagram);
    }
    const auto content = input.bytes();
    const TouchpadReception* got = nullptr;
    const auto refusedBefore = s.end.figures(s.now).refused;
    if (what % 4 != 0) {
      got = &s.end.handle(sealed(s.sealer, content, now_us), fuzzPeer(), s.now, answer);
    } else {
      got = &s.end.handle(content, fuzzPeer(static_cast<std::uint16_t>(1 + what % 3)), s.now, answer);
      require(!got->state && got->accelerations.empty() && got->command == pipeline::RobotCommand::none);
    }
    if (got->state) require(got->state->position_mm.finite() && got->state->stiffness_N_per_mm >= 0.0);
    for (const auto& sample : got->accelerations) {
      require(sample.acceleration_g.finite() && sample.taken <= s.now &&
              s.now - sample.taken < std::chrono::milliseconds(700));
    }
    require(static_cast<int>(got->command) <= 11);
    require(s.end.figures(s.now).refused <= refusedBefore + 1);
    require(s.end.lostLimit_ms() >= 20.0 && s.end.lostLimit_ms() <= 100.0);
  }
  return 0;
}
