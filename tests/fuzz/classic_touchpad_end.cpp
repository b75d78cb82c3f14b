// Sequences of datagrams from several senders with time passing between them: one touch for each state, none else.
#include "core/protocol/classic/classic_touchpad_end.h"

#include "tests/fuzz/fuzz.h"

using namespace fyd;
using namespace fyd::protocol;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  LinkParameters parameters;
  parameters.classic_images = input.byte() % 2 == 1;
  ClassicTouchpadEnd end(parameters);
  static const std::array<std::uint8_t, 3'000> kImage{};
  TouchpadAnswer answer;
  answer.touch = {.position_mm = {1, 2, -3}, .in_contact = true, .force_N = 1.0};
  answer.board_text = "board";
  answer.image = kImage;

  Instant now = instantAt(1.0);
  std::uint64_t datagrams = 0;
  while (!input.empty()) {
    Endpoint from;
    from.port = static_cast<std::uint16_t>(1 + input.byte() % 3);
    now += std::chrono::milliseconds(input.byte());
    const Bytes datagram = input.bytes();
    const bool peer = end.peer() == from;
    const std::uint64_t touches = end.counters().touches;
    const std::uint64_t farewells = end.counters().farewell_states;
    const auto& got = end.handle(datagram, from, now, answer);
    ++datagrams;

    const bool state = looksLikeState(datagram) || decodeState(datagram).ok();
    const std::uint64_t due = (peer && state ? 1U : 0U) + (end.counters().farewell_states - farewells);
    fuzz::require(end.counters().touches - touches == due);
    for (const Datagram& reply : got.replies) fuzz::require(reply.to == from);
    if (due == 1) fuzz::require(!got.replies.empty() && got.replies[0].bytes.size() == kClassicTouchSize);
    if (due == 0) fuzz::require(got.replies.empty() || got.session_started);
    if (got.state) fuzz::require(got.state->position_mm.finite() && got.state->stiffness_N_per_mm >= 0.0);
    fuzz::require(end.lostLimit() >= std::chrono::milliseconds(20) &&
                  end.lostLimit() <= std::chrono::milliseconds(100));
  }
  const TouchpadCounters& c = end.counters();
  fuzz::require(c.acks + c.states + c.farewell_states + c.motor_references + c.wrong_peer + c.second_robot +
                    c.before_handshake + c.out_of_turn + c.unrecognised ==
                datagrams);
  return 0;
}
