// FYD Link: encode and seal, open and decode, beside a copy of the same bytes and libsodium alone.
#include <benchmark/benchmark.h>

#include <cstring>

#include <sodium/crypto_aead_chacha20poly1305.h>

#include "core/protocol/link/link_codec.h"
#include "core/protocol/link/link_handshake.h"

namespace fyd::protocol {
namespace {

using Packet = std::array<std::uint8_t, kMaximumLinkDatagram>;

const PositionCode kTouchCode = *PositionCode::make(asOnTheWire(TouchpadHello{}.workspace));
const PositionCode kRobotCode = *PositionCode::make(asOnTheWire(RobotHello{}.workspace));
const SecretBytes<32> kKey = LinkKey::fromCode(SecretBytes<16>{}).handshakeKey();

std::size_t writeTouch(Packet& packet) {
  return encodeLink(
      LinkTouch{
          .sequence = 7, .position_mm = {10, -5, -2.5}, .in_contact = true, .force_N = 1.0, .indentation_mm = 2.5},
      kTouchCode, 1, Sealer::messagePart(packet));
}
std::size_t writeState(Packet& packet) {
  static const LinkState kState = [] {
    LinkState state{.robot = {.stiffness_N_per_mm = 0.62, .position_mm = {1, 2, -3}}};
    for (int i = 0; i < 10; ++i) {
      static_cast<void>(state.accelerations.push({.age_s = 1e-3 * i, .acceleration_g = {0.4, -1.2, 0.03}}));
    }
    return state;
  }();
  return encodeLink(kState, kRobotCode, 1, Sealer::messagePart(packet));
}
using Write = std::size_t (*)(Packet&);

template <Write write>
void copy(benchmark::State& state) {
  Packet from{};
  Packet to{};
  const std::size_t size = write(from) + kSealOverhead;
  for ([[maybe_unused]] auto unused : state) {
    benchmark::DoNotOptimize(from);
    std::memcpy(to.data(), from.data(), size);
    benchmark::DoNotOptimize(to);
  }
}
BENCHMARK(copy<writeTouch>)->Name("link/baseline_copy_touch");
BENCHMARK(copy<writeState>)->Name("link/baseline_copy_state");

template <Write write>
void sodiumAlone(benchmark::State& state) {
  Packet packet{};
  const std::size_t size = write(packet);
  const std::array<std::uint8_t, 12> nonce{};
  std::uint8_t* message = packet.data() + kSealHeader;
  for ([[maybe_unused]] auto unused : state) {
    crypto_aead_chacha20poly1305_ietf_encrypt(message, nullptr, message, size, packet.data(), kSealHeader, nullptr,
                                              nonce.data(), kKey.data());
    benchmark::DoNotOptimize(packet);
  }
}
BENCHMARK(sodiumAlone<writeTouch>)->Name("link/baseline_libsodium_touch");
BENCHMARK(sodiumAlone<writeState>)->Name("link/baseline_libsodium_state");

template <Write write>
void encodeAndSeal(benchmark::State& state) {
  Packet packet{};
  Sealer sealer(kKey, 1);
  for ([[maybe_unused]] auto unused : state) {
    benchmark::DoNotOptimize(sealer.seal(packet, write(packet)));
    benchmark::DoNotOptimize(packet);
  }
}
BENCHMARK(encodeAndSeal<writeTouch>)->Name("link/encode_and_seal_touch");
BENCHMARK(encodeAndSeal<writeState>)->Name("link/encode_and_seal_state");

template <Write write, auto decode>
void openAndDecode(benchmark::State& state, const PositionCode& code) {
  std::vector<Packet> sent(4'096);
  Packet plain{};
  Sealer sealer(kKey, 1);
  std::size_t size = 0;
  for (Packet& packet : sent) size = sealer.seal(packet, write(packet));
  Opener opener(kKey, 1);
  std::size_t next = 0;
  for ([[maybe_unused]] auto unused : state) {
    if (next == sent.size()) {  // each is taken once only
      opener = Opener(kKey, 1);
      next = 0;
    }
    const Opened opened = opener.open(Bytes(sent[next++]).first(size), plain);
    benchmark::DoNotOptimize(decode(decodeEnvelope(opened.message).value, code));
  }
}
using DecodeTouch = LinkDecoded<LinkTouch> (*)(const LinkEnvelope&, const PositionCode&);
using DecodeState = LinkDecoded<LinkState> (*)(const LinkEnvelope&, const PositionCode&);
void openTouch(benchmark::State& state) {
  openAndDecode<writeTouch, static_cast<DecodeTouch>(&decodeTouch)>(state, kTouchCode);
}
void openState(benchmark::State& state) {
  openAndDecode<writeState, static_cast<DecodeState>(&decodeState)>(state, kRobotCode);
}
BENCHMARK(openTouch)->Name("link/open_and_decode_touch");
BENCHMARK(openState)->Name("link/open_and_decode_state");

void wholeHandshake(benchmark::State& state) {
  const LinkKey key = LinkKey::fromCode(SecretBytes<16>{});
  Packet call{};
  Packet answer{};
  Packet plain{};
  for ([[maybe_unused]] auto unused : state) {
    Caller caller(key, {}, systemRandom);
    const std::size_t call_size = caller.write({}, call);
    Callee callee(key, Bytes(call).first(call_size));
    benchmark::DoNotOptimize(callee.read(Bytes(call).first(call_size), plain));
    const std::size_t answer_size = callee.write({}, systemRandom, answer);
    benchmark::DoNotOptimize(caller.read(Bytes(answer).first(answer_size), plain));
  }
}
BENCHMARK(wholeHandshake)->Name("link/handshake_both_ends");

void forgedCall(benchmark::State& state) {
  const LinkKey key = LinkKey::fromCode(SecretBytes<16>{});
  Packet call{};
  Packet plain{};
  call[1] = versionAndKind(LinkKind::call);
  for ([[maybe_unused]] auto unused : state)
    benchmark::DoNotOptimize(Callee(key, call).read(Bytes(call).first(150), plain));
}
BENCHMARK(forgedCall)->Name("link/refuse_forged_call");

void forgedHello(benchmark::State& state) {
  const LinkKey key = LinkKey::fromCode(SecretBytes<16>{});
  const HelloBytes hello{};
  HelloNonce nonce{};
  for ([[maybe_unused]] auto unused : state) benchmark::DoNotOptimize(readHello(key, hello, nonce));
}
BENCHMARK(forgedHello)->Name("link/refuse_forged_hello");

}  // namespace
}  // namespace fyd::protocol
