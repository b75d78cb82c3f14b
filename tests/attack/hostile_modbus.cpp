// Hostile Modbus replies: a server that keeps to the register map's page or breaks it at random, and the program's own
// client, watches and step behind it. Each reply is judged twice: by the client, and by rules written from the page
// (resources/manual/modbus.md) with none of the program's codecs. Seeded; time is virtual but for lost answers.
//
//   attack_hostile_modbus [REPLIES] [SEED]      full length: attack_hostile_modbus 100000
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>

#include "core/device/touchpad/frozen_readings.h"
#include "core/device/touchpad/modbus_touchpad.h"
#include "core/device/touchpad/plausibility.h"
#include "core/pipeline/pipeline.h"
#include "tests/attack/hostile_device.h"

namespace {

using namespace fyd;
using attack::Page;
using attack::Sent;
using attack::Verdict;
using attack::Words;

[[noreturn]] void violated(const Sent& sent, const std::string& what) {
  std::printf("violated at reply %llu (%s): %s\n", static_cast<unsigned long long>(sent.number), sent.kind.c_str(),
              what.c_str());
  std::fflush(stdout);
  std::_Exit(1);
}

/// What may be believed of the readings, from the replies alone.
class Judge {
 public:
  void exchanged(const Sent& sent, bool fresh, const Result<device::TouchpadReadings>& result, Instant now) {
    if (!result) {
      if (fresh && sent.verdict == Verdict::take) ++good_lost;
      return;
    }
    ++taken;
    const Page page{sent.words};
    if (!fresh) violated(sent, "a reading without a reply");
    if (sent.verdict == Verdict::refuse) violated(sent, "taken: " + page.problem(page.at(65)));
    const bool motors_new = result->motors.count != before_.motors.count;
    if (motors_new && !page.obeys()) violated(sent, "motors of a device that does not obey");
    if (motors_new && last_ && (page.at(64) == Page{*last_}.at(64) || page.uptime() == Page{*last_}.uptime())) {
      violated(sent, "new motors' readings from an old set of values");
    }
    if (motors_new && result->motors.value.encoder_counts[0] != page.at(79)) violated(sent, "another encoder count");
    if (result->ir.count != before_.ir.count) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (result->ir.value[i] != page.at(74 + static_cast<int>(i))) violated(sent, "another IR code");
      }
      if (result->ir.taken > now - fromSeconds(page.at(77) * 1e-4)) violated(sent, "IR codes too young");
    }
    if (result->bridge.count != before_.bridge.count) {
      if (!std::isfinite(page.bridge())) violated(sent, "a bridge that is not a number");
      if (result->bridge.taken > now - fromSeconds(page.at(72) * 1e-4)) violated(sent, "a bridge too young");
    }
    before_ = *result;
    last_ = sent.words;
  }
  std::uint64_t taken = 0;
  std::uint64_t good_lost = 0;

 private:
  device::TouchpadReadings before_;
  std::optional<Words> last_;
};

void checkOutputs(const Sent& sent, const pipeline::Outputs& outputs) {
  using pipeline::SafetyState;
  const SafetyState state = outputs.telemetry.state;
  const bool may_move = state == SafetyState::active || state == SafetyState::held;
  if (outputs.motors.active && !may_move) violated(sent, "motors on outside Active and Held");
  for (const double duty : outputs.motors.vibration_duty_percent) {
    if (!(std::abs(duty) <= 100.0)) violated(sent, "a duty beyond its limits");
    if (duty != 0.0 && state != SafetyState::active) violated(sent, "vibration outside Active");
  }
  const Vec3& touch = outputs.touch.position_mm;
  if (!std::isfinite(touch.x + touch.y + touch.z + outputs.touch.force_N)) violated(sent, "a touch that is no number");
  if (!(std::abs(outputs.touch.force_N) < 30.0)) violated(sent, "a force that no cell of this kind measures");
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t replies = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  attack::Device device(seed);
  device::DeviceParameters parameters;
  parameters.response_timeout_ms = 30.0;
  device::ModbusTouchpad touchpad(*device::parseModbusAddress(device.address()), parameters);
  device::FrozenReadings frozen(parameters);
  device::Plausibility plausibility(parameters);
  pipeline::Pipeline step{pipeline::Parameters{}};
  pipeline::Inputs inputs;
  (void)inputs.commands.push({.action = pipeline::OperatorAction::target_by_hand, .value = 0.6});

  std::mt19937_64 random(seed + 1);
  Instant now = instantAt(1000.0);
  control::MotorCommand command;
  Judge judge;
  std::map<std::string, std::uint64_t> states;
  std::uint64_t seen = 0;
  bool attacking = true;
  std::uint64_t calm = 0;
  for (std::uint64_t i = 0; attacking || calm < 2000; ++i) {
    attacking = device.last().number < replies;
    device.hostile = attacking;
    if (!attacking) ++calm;
    now += std::chrono::milliseconds(4);
    const auto result = touchpad.exchange(command, now);
    const Sent sent = device.last();
    judge.exchanged(sent, sent.number != seen, result, now);
    if (sent.number != seen && !command.active && sent.control_word != 0) violated(sent, "driven without a command");
    seen = sent.number;
    if (result) {
      const auto believed = plausibility.check(frozen.check(*result), command, now);
      inputs.ir = believed.ir;
      inputs.bridge = believed.bridge;
      inputs.motors = believed.motors;
    }
    inputs.now = now;
    if (i % 8 == 0) {
      inputs.finger.set({.contact = random() % 100 != 0,
                         .area_px = 400.0,
                         .x_mm = 0.1 * static_cast<double>(random() % 10),
                         .quality = 1.0,
                         .reason = sensing::FingerReason::found},
                        now);
    }
    if (i % 60 == 20) (void)inputs.commands.push({.action = pipeline::OperatorAction::arm});
    if (attacking ? i % 60 == 0 : calm == 1) (void)inputs.commands.push({.action = pipeline::OperatorAction::stop});
    const pipeline::Outputs& outputs = step.step(inputs);
    inputs.commands.clear();
    checkOutputs(sent, outputs);
    command = outputs.motors;
    ++states[std::string(toString(outputs.telemetry.state))];
    if (!attacking && calm == 2000 && outputs.telemetry.state != pipeline::SafetyState::active) {
      violated(sent, fmt::format("a healthy device again, and the session is not Active: {}; {}; {}",
                                 toString(outputs.telemetry.fault), touchpad.complaint().text(),
                                 plausibility.complaint().text()));
    }
  }
  std::printf("%llu replies, seed %llu: %llu taken, %llu good ones lost to what came before\n",
              static_cast<unsigned long long>(seen), static_cast<unsigned long long>(seed),
              static_cast<unsigned long long>(judge.taken), static_cast<unsigned long long>(judge.good_lost));
  for (const auto& [kind, count] : device.kinds()) {
    std::printf("  %-28s %llu\n", kind.c_str(), static_cast<unsigned long long>(count));
  }
  for (const auto& [state, count] : states) {
    std::printf("  steps %-22s %llu\n", state.c_str(), static_cast<unsigned long long>(count));
  }
  return 0;
}
