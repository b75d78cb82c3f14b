// Classic codec: encode and decode of the two packets of every cycle, beside a copy of the same bytes.
#include <benchmark/benchmark.h>

#include <cstring>

#include "core/protocol/classic/classic_touchpad_end.h"

namespace fyd::protocol {
namespace {

const ClassicState kState{.command = pipeline::RobotCommand::vibration_up,
                          .acceleration_g = {0.4, -1.2, 0.03},
                          .robot = {.stiffness_N_per_mm = 0.612, .position_mm = {12.3, -7.9, -31.0}, .button = true}};
const pipeline::TouchMessage kTouch{.position_mm = {12.3, -7.9, -3.1}, .in_contact = true, .force_N = 1.2345};

template <std::size_t Size>
void copy(benchmark::State& state) {
  std::array<std::uint8_t, Size> from{};
  std::array<std::uint8_t, Size> to{};
  for ([[maybe_unused]] auto unused : state) {
    benchmark::DoNotOptimize(from);
    std::memcpy(to.data(), from.data(), Size);
    benchmark::DoNotOptimize(to);
  }
}
BENCHMARK(copy<kClassicStateSize>)->Name("classic/baseline_copy_62_bytes");
BENCHMARK(copy<kClassicTouchSize>)->Name("classic/baseline_copy_34_bytes");

template <class Call>
void measure(benchmark::State& state, Call&& call) {
  for ([[maybe_unused]] auto unused : state) benchmark::DoNotOptimize(call());
}

void encodeStateBench(benchmark::State& state) {
  ClassicState message = kState;
  measure(state, [&] {
    benchmark::DoNotOptimize(message);
    return encodeState(message);
  });
}
BENCHMARK(encodeStateBench)->Name("classic/encode_state");

void decodeStateBench(benchmark::State& state) {
  auto packet = encodeState(kState);
  measure(state, [&] {
    benchmark::DoNotOptimize(packet);
    return decodeState(packet);
  });
}
BENCHMARK(decodeStateBench)->Name("classic/decode_state");

void encodeTouchBench(benchmark::State& state) {
  pipeline::TouchMessage message = kTouch;
  measure(state, [&] {
    benchmark::DoNotOptimize(message);
    return encodeTouch(message);
  });
}
BENCHMARK(encodeTouchBench)->Name("classic/encode_touch");

void decodeTouchBench(benchmark::State& state) {
  auto packet = encodeTouch(kTouch);
  measure(state, [&] {
    benchmark::DoNotOptimize(packet);
    return decodeTouch(packet);
  });
}
BENCHMARK(decodeTouchBench)->Name("classic/decode_touch");

// The touchpad's whole answer to one state: session, decode, encode.
void touchpadCycle(benchmark::State& state) {
  ClassicTouchpadEnd end{LinkParameters{}};
  Endpoint robot;
  robot.port = kClassicPort;
  TouchpadAnswer answer;
  answer.touch = kTouch;
  Instant now = instantAt(1.0);
  static_cast<void>(end.handle(encodeAck(), robot, now, answer));
  const auto packet = encodeState(kState);
  for ([[maybe_unused]] auto unused : state) {
    now += std::chrono::milliseconds(1);
    benchmark::DoNotOptimize(&end.handle(packet, robot, now, answer));
  }
}
BENCHMARK(touchpadCycle)->Name("classic/touchpad_cycle");

}  // namespace
}  // namespace fyd::protocol
