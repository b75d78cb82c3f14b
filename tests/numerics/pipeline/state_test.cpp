// A restored pipeline continues bit for bit, and bytes that are no state are refused without harm.
#include <bit>
#include <cstring>
#include <memory>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sodium/crypto_generichash.h>

#include "core/pipeline/pipeline.h"
#include "tests/numerics/pipeline/random_scene.h"

namespace fyd::pipeline {
namespace {

texture::SurfaceModel denim() {
  texture::SurfaceModel model;
  model.name = "denim";
  model.bands = {{.wavelength_mm = 0.8, .quality = 2.0, .rms_g = 0.4},
                 {.frequency_Hz = 180, .quality = 1, .rms_g = 0.2}};
  return model;
}

LocalModel surfaceOf(unsigned seed) {
  if (seed % 3 == 0) return {};
  return {denim()};
}

/// Everything a step gives, as bits: NaN equals NaN, 0 differs from −0.
std::vector<std::uint64_t> bitsOf(const Outputs& out) {
  std::vector<std::uint64_t> bits;
  const auto add = [&bits](double value) { bits.push_back(std::bit_cast<std::uint64_t>(value)); };
  for (const TelemetryField& field : telemetryFields()) add(field.read(out.telemetry));
  for (const double duty : out.motors.vibration_duty_percent) add(duty);
  for (const std::int16_t ticks : out.motors.reference_ticks) add(ticks);
  add(out.motors.active);
  for (const double value : {out.touch.position_mm.x, out.touch.position_mm.y, out.touch.position_mm.z,
                             out.touch.force_N, static_cast<double>(out.touch.in_contact)}) {
    add(value);
  }
  bits.push_back(out.faults.to_ullong());
  for (const Event& event : out.events) {
    for (const double value : {static_cast<double>(event.kind), static_cast<double>(event.state),
                               static_cast<double>(event.fault), static_cast<double>(event.index), event.value}) {
      add(value);
    }
  }
  for (const double offset : out.tare.ir_offset_mm.view()) add(offset);
  add(out.tare.force_zero_N);
  return bits;
}

/// Bytes 8 + 2·16 + 8 in front: mark, digests of surface and content, length of the content.
constexpr std::size_t kSealBytes = 48;

/// The state with other content under a seal that fits it, as a forger would make it.
std::string resealed(std::string_view seal, std::string_view content) {
  std::string state(seal.substr(0, kSealBytes));
  crypto_generichash(reinterpret_cast<unsigned char*>(state.data()) + 24, 16,
                     reinterpret_cast<const unsigned char*>(content.data()), content.size(), nullptr, 0);
  const std::uint64_t bytes = content.size();
  std::memcpy(state.data() + 40, &bytes, sizeof bytes);
  return state.append(content);
}

class RestoredState : public ::testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Seeds, RestoredState, ::testing::Range(1U, 13U));

TEST_P(RestoredState, ContinuesBitForBitFromAnyStep) {
  const unsigned seed = GetParam();
  const auto surface = surfaceOf(seed);
  Parameters parameters;
  if (seed % 4 == 0) parameters.step.absolute_motion = true;
  if (seed % 5 == 0) parameters.sensing.indentation.mode = sensing::IndentationMode::thesis;
  if (seed % 4 == 1) parameters.control.mode = control::ControlMode::thesis;
  std::mt19937 random(seed);
  RandomScene scene(seed);
  Pipeline original(parameters, surface);
  auto restored = std::make_unique<Pipeline>(parameters, surface);
  control::MotorCommand motors;
  std::set<SafetyState> states;
  int until_next = 500;
  int restores = 0;
  for (int step = 0; step < 30'000; ++step) {
    if (--until_next == 0) {
      const std::string state = original.saveState();
      restored = std::make_unique<Pipeline>(parameters, surface);
      const auto done = restored->restoreState(state);
      ASSERT_TRUE(done) << done.error().text() << " at step " << step;
      ASSERT_EQ(restored->saveState(), state);
      until_next = 500 + static_cast<int>(random() % 3000);
      ++restores;
    }
    const Inputs& inputs = scene.next(motors);
    const Outputs& expected = original.step(inputs);
    motors = expected.motors;
    states.insert(expected.telemetry.state);
    const Outputs& given = restored->step(inputs);
    ASSERT_EQ(bitsOf(given), bitsOf(expected)) << "at step " << step << ", restore " << restores;
  }
  EXPECT_EQ(restored->saveState(), original.saveState());
  EXPECT_GE(restores, 8);
  EXPECT_GE(states.size(), 4U);
}

/// A pipeline some way into a scene.
struct Advanced {
  explicit Advanced(unsigned seed, int steps = 5000)
      : scene(seed), pipeline(std::make_unique<Pipeline>(Parameters{}, surfaceOf(seed))) {
    for (int i = 0; i < steps; ++i) motors = pipeline->step(scene.next(motors)).motors;
  }
  RandomScene scene;
  std::unique_ptr<Pipeline> pipeline;
  control::MotorCommand motors;
};

/// What the comparison above stands on.
TEST(RandomScene, HoldsEveryStateTaresAndTouches) {
  std::set<SafetyState> states;
  int tares = 0;
  int observable = 0;
  for (const unsigned seed : {1U, 2U, 3U}) {
    RandomScene scene(seed);
    Pipeline pipeline(Parameters{});
    control::MotorCommand motors;
    for (int step = 0; step < 30'000; ++step) {
      const Outputs& out = pipeline.step(scene.next(motors));
      motors = out.motors;
      states.insert(out.telemetry.state);
      observable += out.telemetry.stiffness_observable ? 1 : 0;
      for (const Event& event : out.events) tares += event.kind == EventKind::tare_done ? 1 : 0;
    }
  }
  EXPECT_EQ(states.size(), kSafetyStateCount);
  EXPECT_GE(tares, 2);
  EXPECT_GE(observable, 3000);
}

TEST(RestoredParameters, OfThatMomentComeToo) {
  const Advanced advanced(2, 20'000);
  Pipeline restored(Parameters{}, surfaceOf(2));
  ASSERT_TRUE(restored.restoreState(advanced.pipeline->saveState()));
  Parameters expected = advanced.pipeline->parameters();
  Parameters given = restored.parameters();
  const auto a = bindParameters(expected);
  const auto b = bindParameters(given);
  Parameters defaults;
  const auto c = bindParameters(defaults);
  int changed = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(formatParameter(a[i]), formatParameter(b[i])) << a[i].id;
    changed += formatParameter(a[i]) != formatParameter(c[i]) ? 1 : 0;
  }
  EXPECT_GT(changed, 10);
}

/// Every refusal leaves the pipeline as it was.
void expectRefused(Pipeline& pipeline, std::string_view state, std::string_view why) {
  const std::string before = pipeline.saveState();
  const auto done = pipeline.restoreState(state);
  ASSERT_FALSE(done) << "expected: " << why;
  EXPECT_THAT(done.error().text(), ::testing::HasSubstr(std::string(why)));
  ASSERT_EQ(pipeline.saveState(), before);
}

TEST(RefusedState, CutShortAtAnyByteTooLongAndEmpty) {
  const Advanced advanced(4);
  const std::string state = advanced.pipeline->saveState();
  Advanced other(4, 700);
  const std::string before = other.pipeline->saveState();
  for (std::size_t length = 0; length < state.size(); ++length) {
    ASSERT_FALSE(other.pipeline->restoreState(std::string_view(state).substr(0, length))) << length;
  }
  EXPECT_EQ(other.pipeline->saveState(), before);
  expectRefused(*other.pipeline, "", "0 bytes");
  expectRefused(*other.pipeline, state + '\0', "content: expected");
  expectRefused(*other.pipeline, state + state, "content: expected");
  expectRefused(*other.pipeline, std::string(10'000, '\0'), "not the state");
  EXPECT_TRUE(other.pipeline->restoreState(state));
}

TEST(RefusedState, AnySingleFlippedBit) {
  const Advanced advanced(5);
  std::string state = advanced.pipeline->saveState();
  Advanced other(5, 700);
  const std::string before = other.pipeline->saveState();
  for (std::size_t i = 0; i < state.size(); i += i < kSealBytes ? 1 : 7) {
    const char kept = state[i];
    state[i] = static_cast<char>(kept ^ (1 << (i % 8)));
    ASSERT_FALSE(other.pipeline->restoreState(state)) << "byte " << i;
    state[i] = kept;
  }
  EXPECT_EQ(other.pipeline->saveState(), before);
}

/// The content with `from` replaced by `to`, once.
std::string changed(std::string_view state, std::string_view from, std::string_view to) {
  std::string content(state.substr(kSealBytes));
  const std::size_t at = content.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  content.replace(at, from.size(), to);
  return resealed(state, content);
}

/// As a program would have saved it that had neither this parameter nor a list as long as today's.
std::string withoutParameter(std::string_view state, std::string_view id) {
  std::string content(state.substr(kSealBytes));
  const std::size_t at = content.find(std::string(1, static_cast<char>(id.size())) + std::string(id));
  EXPECT_NE(at, std::string::npos) << id;
  content.erase(at, 1 + id.size() + 1 + sizeof(double));
  std::uint16_t count = 0;
  std::memcpy(&count, content.data(), sizeof count);
  --count;
  std::memcpy(content.data(), &count, sizeof count);
  return resealed(state, content);
}

TEST(OlderState, WithoutAParameterInTheMiddleLeavesItsValueAndTakesTheRest) {
  Advanced advanced(2);
  Parameters defaults;
  const auto bound = bindParameters(defaults);
  Inputs inputs = advanced.scene.next(advanced.motors);
  const auto index = static_cast<std::uint16_t>(findParameter(bound, "control.kp") - bound.data());
  ASSERT_TRUE(inputs.changes.push({.index = index, .value = 0.7}));
  (void)advanced.pipeline->step(inputs);
  Pipeline pipeline(Parameters{}, surfaceOf(2));
  const double before = Parameters{}.control.kp;
  ASSERT_NE(advanced.pipeline->parameters().control.kp, before);
  ASSERT_TRUE(pipeline.restoreState(withoutParameter(advanced.pipeline->saveState(), "control.kp")));
  EXPECT_EQ(pipeline.parameters().control.kp, before);
  EXPECT_EQ(pipeline.parameters().texture.dead_zone_percent, advanced.pipeline->parameters().texture.dead_zone_percent);
  EXPECT_EQ(pipeline.parameters().texture.k_vib, advanced.pipeline->parameters().texture.k_vib);
}

TEST(OlderState, WithMinusZeroWhereTheProfileSaysZero) {
  Parameters written;
  written.sensing.indentation.ir_x_mm = {{-22.0, -0.0, 22.0}, 3};
  const std::string state = Pipeline(written).saveState();
  Pipeline pipeline{Parameters{}};
  ASSERT_EQ(pipeline.parameters().sensing.indentation.ir_x_mm[1], 0.0);
  ASSERT_NE(pipeline.saveState(), state);
  const auto restored = pipeline.restoreState(state);
  ASSERT_TRUE(restored) << restored.error().text();
  EXPECT_EQ(pipeline.saveState(), state) << "with the bits it was recorded with";
}

TEST(NewerState, IsRefusedByTheNameOfWhatIsNotKnown) {
  const Advanced advanced(1);
  const std::string state = advanced.pipeline->saveState();
  Pipeline pipeline(Parameters{}, {denim()});
  expectRefused(pipeline, changed(state, "control.kp", "control.kq"), "'control.kq' is no parameter");
  expectRefused(pipeline, changed(state, "interpolated", "interpolatex"), "control.law = 'interpolatex'");
  expectRefused(pipeline, changed(state, "controller", "controllex"), "'controllex' is no module");
  const std::string second{"\6safety\2\0", 9};
  expectRefused(pipeline, changed(state, std::string_view("\6safety\1\0", 9), second),
                "version 2 of the module 'safety'");
  expectRefused(pipeline, changed(state, "\6motion", "\6safety"), "the module 'safety' twice");
}

TEST(RefusedState, OfAnotherSurfaceOrParameter) {
  const Advanced advanced(1);
  const std::string state = advanced.pipeline->saveState();
  Pipeline same(Parameters{}, {denim()});
  Pipeline without_surface{Parameters{}};
  expectRefused(without_surface, state, "another surface");
  Parameters moved;
  moved.sensing.indentation.frame_half_width_mm = 51;
  Pipeline with_frame(moved, {denim()});
  expectRefused(with_frame, state, "sensing.frame_half_width_mm was 50");
  Parameters sensors;
  (void)sensors.sensing.indentation.ir_lowest_code.push(524);
  Pipeline with_sensors(sensors, {denim()});
  expectRefused(with_sensors, state, "sensing.ir_lowest_code had 3 values");

  const std::string_view whole = state;
  expectRefused(same, resealed(whole, whole.substr(kSealBytes, 900)), "");
  expectRefused(same, resealed(whole, std::string(whole.substr(kSealBytes)) + "x"), "more content");
}

/// What a seal cannot tell: content that was made up. Indices, choices and instants in it are checked, so that it is
/// refused or runs, whatever it says.
TEST(ForgedState, IsRefusedOrRunsButNeverBreaks) {
  for (const unsigned seed : {6U, 7U, 8U}) {
    Advanced advanced(seed, 8000);
    const std::string state = advanced.pipeline->saveState();
    const std::string_view whole = state;
    std::mt19937 random(seed);
    Pipeline pipeline(Parameters{}, surfaceOf(seed));
    int refused = 0;
    int run = 0;
    for (int trial = 0; trial < 400; ++trial) {
      std::string content(whole.substr(kSealBytes));
      for (int flip = 0; flip < 1 + trial % 20; ++flip) {
        content[random() % content.size()] = static_cast<char>(trial % 3 == 0 ? 0xFF : random());
      }
      const std::string before = pipeline.saveState();
      if (!pipeline.restoreState(resealed(whole, content))) {
        ASSERT_EQ(pipeline.saveState(), before);
        ++refused;
        continue;
      }
      ++run;
      for (int i = 0; i < 100; ++i) {
        const Outputs& out = pipeline.step(advanced.scene.next(advanced.motors));
        for (const double duty : out.motors.vibration_duty_percent) ASSERT_LE(std::abs(duty), 100.0);
      }
    }
    EXPECT_GT(refused, 20);
    EXPECT_GT(run, 20);
  }
}

}  // namespace
}  // namespace fyd::pipeline
