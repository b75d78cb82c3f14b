#include "tests/soak/soak_session.h"

#include <algorithm>
#include <vector>

#include "tests/soak/soak_checks.h"
#include "tests/soak/soak_disk.h"
#include "tests/soak/soak_robot.h"
#include "tests/soak/soak_touchpad.h"

namespace fyd::soak {
namespace {

using pipeline::OperatorAction;
using pipeline::SafetyState;
using std::chrono::milliseconds;

constexpr double kShortest_s = 8.0;
constexpr double kLongest_s = 30.0;
constexpr double kBetweenFaults_ms = 1200.0;
// The touches under way, a prediction that ends (150 ms without a touch), and its way to rest.
constexpr Duration kArmRests = milliseconds(2500);
constexpr double kStill_mm = 0.01;
constexpr const char* kLateLoop = "loop late";

const sim::FingerPath& fingerOf(Chance& chance) {
  static const std::vector<sim::FingerPath> kFingers = [] {
    std::vector<sim::FingerPath> out = {sim::FingerPath::demonstration(), sim::FingerPath::constant(0, 0, 0),
                                        sim::FingerPath::constant(3, -5, 6)};
    for (const char* file : {"/hand_motion/index_tip.csv", "/hand_motion/thumb_tip.csv"}) {
      auto read = sim::FingerPath::fromCsv(std::string(FYD_TEST_DATA) + file);
      if (!read) broken(read.error().text());
      out.push_back(std::move(*read));
    }
    return out;
  }();
  return chance.oneOf(kFingers);
}

/// What an operator does, by chance: arms when it is time, refused or not, and now and then anything else.
class Operator {
 public:
  explicit Operator(const pipeline::Parameters& parameters) : parameters_(parameters) {
    bound_ = bindParameters(parameters_);
    for (std::size_t i = 0; i < bound_.size(); ++i) {
      const std::string_view id = bound_[i].id;
      const bool usual = id.starts_with("pipeline.motion") || id == "pipeline.hand_target_N_per_mm" ||
                         id == "pipeline.coupling" || id.starts_with("texture.k_vib") || id == "texture.method" ||
                         id == "control.kp" || id == "control.ki_per_s";
      if (usual && bound_[i].info.live) live_.push_back(i);
    }
    if (live_.size() < 6) broken("the operator has no parameters to change");
  }

  void act(Chance& chance, SafetyState state, Instant now, pipeline::Inputs& inputs) {
    const auto give = [&](OperatorAction action, double value = 0.0) {
      (void)inputs.commands.push({.action = action, .value = value});
    };
    if (state == SafetyState::active) {
      arm_at_ = now + milliseconds(50 + chance.below(600));
      arms_ = 0;
    } else if (now >= arm_at_) {
      // A device that switched its motors off is armed again, with a stop before it now and then.
      give(++arms_ % 4 == 0 ? OperatorAction::stop : OperatorAction::arm);
      arm_at_ = now + milliseconds(50 + chance.below(600));
    }
    if (chance.once(12'000)) give(OperatorAction::stop);
    if (chance.once(20'000)) give(OperatorAction::fell_silent);
    if (chance.once(20'000)) give(OperatorAction::tare);
    if (chance.once(8'000)) give(OperatorAction::target_by_hand, chance.between(-0.5, 3.0));
    if (chance.once(4'000)) give(OperatorAction::target_from_robot);
    if (!chance.once(700)) return;
    const std::size_t index = chance.oneOf(live_);
    const ParameterInfo& info = bound_[index].info;
    double value = chance.between(info.minimum, std::min(info.maximum, 1e6));
    if (bound_[index].kind == ParameterKind::choice) {
      value = static_cast<double>(chance.below(static_cast<int>(bound_[index].choices.size())));
    }
    if (chance.once(10)) value = info.maximum * 10.0 + 1.0;  // refused
    (void)inputs.changes.push({.index = static_cast<std::uint16_t>(index), .value = value});
  }

 private:
  pipeline::Parameters parameters_;
  std::vector<Parameter> bound_;
  std::vector<std::size_t> live_;
  Instant arm_at_{};
  int arms_ = 0;  // in vain, and the stops between them
};

/// Faults whose time to end Active is running.
class Deadlines {
 public:
  void add(std::optional<Deadline> deadline) {
    if (deadline && deadline->alone && deadline->ends > deadline->until) running_.push_back(std::move(*deadline));
  }
  void look(Instant now, const Checks& checks, Figures& figures) {
    std::erase_if(running_, [&](const Deadline& deadline) {
      if (deadline.of_robot && checks.byHand()) return true;
      if (now < deadline.until) return false;
      if (now >= deadline.ends) return true;
      if (checks.state() == SafetyState::active) {
        broken(fmt::format("Active {:.0f} ms after the time by which {} had to end it",
                           toMilliseconds(now - deadline.until), deadline.name));
      }
      figures.checked_deadlines += now < deadline.until + milliseconds(1) ? 1 : 0;
      return false;
    });
  }

 private:
  std::vector<Deadline> running_;
};

}  // namespace

void runSession(std::uint64_t number, Chance& chance, const std::string& folder, Figures& figures) {
  const Instant start = instantAt(1000.0);
  const int seed = static_cast<int>(1 + number % 1'000'000);
  const auto protocol = static_cast<Protocol>(chance.below(3));
  pipeline::Parameters parameters;
  pipeline::Pipeline step{parameters};
  SoakTouchpad touchpad(parameters, fingerOf(chance), chance.once(3), folder, seed, start);
  SoakRobot robot(protocol, seed);
  SoakDisk disk(parameters, folder, figures);
  Operator hands(parameters);
  Checks checks(step.parameters(), figures);
  Deadlines deadlines;
  pipeline::Inputs inputs;
  if (protocol == Protocol::none) {
    (void)inputs.commands.push({.action = OperatorAction::target_by_hand, .value = 0.6});
  }
  pipeline::Outputs outputs;
  Vec3 arm_mm;
  bool arm_rests = false;
  Instant misled = start;  // last
  int arm_starts = 0;
  std::uint64_t pictures = 0;
  Instant now = start;
  Instant next_fault = start + milliseconds(2000);
  const Instant end = start + fromSeconds(chance.between(kShortest_s, kLongest_s));
  while (now < end) {
    now += milliseconds(1);
    at(number, toSeconds(now - start));
    if (now >= next_fault) {
      next_fault = now + fromSeconds(1e-3 * kBetweenFaults_ms * chance.between(0.05, 2.0));
      switch (chance.below(6)) {
        case 0:
        case 1: deadlines.add(touchpad.disturb(chance, now, figures)); break;
        case 2: deadlines.add(touchpad.disturbCamera(chance, now, figures)); break;
        case 3: deadlines.add(robot.disturb(chance, now, figures)); break;
        case 4: disk.act(chance); break;
        default:
          ++figures.faults[kLateLoop];
          if (chance.once(2)) {
            now += milliseconds(21 + chance.below(80));
          } else {
            inputs.missed_cycles += static_cast<std::uint64_t>(chance.below(100));
          }
          break;
      }
    }
    inputs.now = now;
    touchpad.advance(now, outputs.motors, inputs);
    robot.advance(now, outputs, inputs);
    hands.act(chance, checks.state(), now, inputs);
    outputs = step.step(inputs);
    checks.look(inputs, outputs);
    deadlines.look(now, checks, figures);
    disk.push(inputs, outputs);
    if (touchpad.pictures() != pictures) {
      pictures = touchpad.pictures();
      disk.offer(touchpad.picture(), inputs.finger.value, inputs.finger.taken, pictures);
    }
    inputs.commands.clear();
    inputs.changes.clear();
    inputs.robot.commands.clear();
    inputs.robot.accelerations.clear();
    if (protocol == Protocol::none) continue;
    // Whatever the network still brings: an arm is not moved by a touchpad that is not Active.
    if (robot.misled()) misled = now;
    if (checks.quiet(now) < kArmRests || now - misled < kArmRests || robot.starts() != arm_starts) {
      arm_rests = false;
      arm_starts = robot.starts();
    } else if (!arm_rests) {
      arm_rests = true;
      arm_mm = robot.commanded_mm();
    } else {
      const double crept_mm = (robot.commanded_mm() - arm_mm).norm();
      figures.largest_creep_mm = std::max(figures.largest_creep_mm, crept_mm);
      if (crept_mm > kStill_mm) {
        broken(fmt::format("the arm was moved {:.3f} mm, {:.1f} s after the end of Active", crept_mm,
                           toSeconds(checks.quiet(now))));
      }
    }
  }
  disk.finish();
  ++figures.sessions;
}

void nameFaults(Figures& figures) {
  SoakTouchpad::nameFaults(figures);
  SoakRobot::nameFaults(figures);
  SoakDisk::nameFaults(figures);
  figures.faults[kLateLoop];
}

}  // namespace fyd::soak
