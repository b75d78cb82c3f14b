// A seeded stream of inputs through everything a session can hold: touches, tares, robots that come, pause and vanish,
// surfaces, batches of accelerations, live changes, dead and lying sensors, NaN, clocks that jump. The motors follow
// the commands, so the loop is closed.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/pipeline/pipeline.h"
#include "core/sensing/membrane.h"

namespace fyd::pipeline {

class RandomScene {
 public:
  explicit RandomScene(unsigned seed) : random_(seed), bound_(bindParameters(defaults_)) {
    for (std::size_t i = 0; i < bound_.size(); ++i) {
      if (bound_[i].info.live && bound_[i].kind != ParameterKind::list) live_.push_back(i);
    }
  }

  /// The next millisecond, after these outputs.
  const Inputs& next(const control::MotorCommand& motors) {
    ++step_;
    if (--left_ <= 0) begin();
    advanceTime();
    touch();
    feelMotors(motors);
    hearRobot();
    operate();
    if (chance(poison_)) poison();
    return inputs_;
  }

 private:
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double normal(double sigma) { return std::normal_distribution<double>(0.0, sigma)(random_); }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  /// A new situation for a while.
  void begin() {
    touching_ = chance(0.7);
    left_ = 100 + below(touching_ ? 900 : 2500);  // a tare takes a second
    depth_goal_mm_ = uniform(1, 12);
    pace_x_ = normal(40.0);
    pace_y_ = normal(30.0);
    stiffness_ = chance(0.1) ? uniform(-1, 3) : uniform(0.4, 0.8);
    cloth_scale_ = uniform(0.7, 1.5);
    stuck_ = chance(0.15);
    dead_cell_ = chance(0.1);
    blind_ = chance(0.1);
    poison_ = chance(0.2) ? 0.05 : 0.0;
    batch_ = chance(0.3) ? 1 + below(12) : 1;
    moved_by_robot_ = chance(0.3);
    if (chance(0.6)) {
      phase_ = LinkPhase::running;
    } else {
      phase_ = static_cast<LinkPhase>(below(6));
    }
  }

  void advanceTime() {
    inputs_.commands.clear();
    inputs_.changes.clear();
    inputs_.robot.commands.clear();
    inputs_.robot.accelerations.clear();
    time_s_ += 0.001 + normal(2e-5);
    if (chance(2e-4)) time_s_ += uniform(-0.3, 0.3);
    if (chance(5e-3)) inputs_.missed_cycles += static_cast<std::uint64_t>(below(12));
    inputs_.now = instantAt(time_s_);
  }

  void touch() {
    const double goal = touching_ ? depth_goal_mm_ : 0.0;
    depth_mm_ += std::clamp(goal - depth_mm_, -0.05, 0.05) + (touching_ ? normal(0.01) : 0.0);
    depth_mm_ = std::max(depth_mm_, 0.0);
    x_mm_ = std::clamp(x_mm_ + 1e-3 * pace_x_, -45.0, 45.0);
    y_mm_ = std::clamp(y_mm_ + 1e-3 * pace_y_, -30.0, 30.0);
    if (step_ % 33 == 0 && !(blind_ && chance(0.5))) seeFinger();
    if (step_ % 16 == 0) readDistances();
    if (step_ % 8 == 0) {
      const double force_N = cloth_scale_ * 0.6 * depth_mm_ + normal(0.01);
      const double grams = 1000.0 * force_N / 9.80665;
      inputs_.bridge.set({.value_mV_per_V = dead_cell_ ? 9.0 : (grams + 20.2512) / 1004.8805}, inputs_.now);
    }
  }

  void seeFinger() {
    sensing::FingerDetection finger;
    finger.contact = depth_mm_ > 0.3;
    finger.area_px = finger.contact ? 400 + normal(10) : 0;
    finger.x_mm = x_mm_ + normal(0.05);
    finger.y_mm = y_mm_ + normal(0.05);
    finger.quality = 1;
    finger.reason = blind_           ? sensing::FingerReason::black_picture
                    : finger.contact ? sensing::FingerReason::found
                                     : sensing::FingerReason::no_finger;
    inputs_.finger.set(finger, inputs_.now - std::chrono::milliseconds(below(12)));
  }

  void readDistances() {
    const sensing::IndentationParameters& p = defaults_.sensing.indentation;
    sensing::IrCounts counts;
    for (std::size_t i = 0; i < p.ir_x_mm.size(); ++i) {
      const double share = membrane_.shape(p.ir_x_mm[i], p.ir_y_mm[i], x_mm_, y_mm_);
      const double volts = curve_.voltsAt(p.ir_offset_mm[i] + 3.0 - share * depth_mm_) + normal(0.008);
      const auto code = static_cast<std::uint16_t>(std::clamp(volts / sensing::kAdcReference_V * 4096.0, 0.0, 4095.0));
      (void)counts.push(stuck_ && i == 0 ? std::uint16_t{1500} : code);
    }
    inputs_.ir.set(counts, inputs_.now - std::chrono::milliseconds(below(8)));
  }

  void feelMotors(const control::MotorCommand& command) {
    if (step_ % 2 != 0) return;
    control::MotorFeedback motors;
    for (std::size_t i = 0; i < control::kMotorCount; ++i) {
      const double goal_deg = command.reference_ticks[i] / control::kTicksPerDegree;
      if (command.active) angle_deg_[i] += std::clamp(goal_deg - angle_deg_[i], -0.3, 0.3);
      const int counts = static_cast<int>(std::lround(angle_deg_[i] * control::kEncoderCountsPerDegree));
      motors.encoder_counts[i] = static_cast<std::uint16_t>((counts + 4096) % 4096);
      motors.position_duty_percent[i] = normal(20);
    }
    motors.position_duty_known = batch_ % 2 == 1;
    inputs_.motors.set(motors, inputs_.now);
  }

  void hearRobot() {
    RobotInputs& robot = inputs_.robot;
    robot.phase = phase_;
    if (phase_ != LinkPhase::running) return;
    if (step_ % 5 == 0) {
      robot.state.set({.stiffness_N_per_mm = chance(0.02) ? 0.0 : stiffness_ + normal(0.01),
                       .position_mm = {x_mm_, y_mm_, normal(3.0) - depth_mm_},
                       .force_N = batch_ % 2 == 0 ? kNaN : depth_mm_ * stiffness_},
                      inputs_.now);
    }
    if (moved_by_robot_) robot.motor_reference.set({uniform(500, 4000), -uniform(500, 4000)}, inputs_.now);
    if (step_ % batch_ == 0) {
      for (int i = batch_ - 1; i >= 0; --i) {
        const double t = time_s_ - 1e-3 * i;
        const double strength = touching_ ? 1.0 + depth_mm_ / 6.0 : 0.05;
        (void)robot.accelerations.push(
            {.taken = instantAt(t + normal(1e-4)),
             .acceleration_g = {strength * std::sin(900 * t) + normal(0.2), strength * std::cos(1400 * t) + normal(0.2),
                                1.0 + normal(0.3)}});
      }
    }
    if (chance(2e-3)) (void)robot.commands.push(static_cast<RobotCommand>(below(12)));
    if (moved_by_robot_ && chance(5e-3)) (void)robot.commands.push(RobotCommand::motor_reference_on);
  }

  void operate() {
    const auto order = [this](OperatorAction action, double value = 0.0) {
      (void)inputs_.commands.push({.action = action, .value = value});
    };
    if (chance(0.01)) order(OperatorAction::arm);
    if (chance(2e-4)) order(OperatorAction::stop);
    if (chance(1e-4) || (!touching_ && chance(1e-3))) order(OperatorAction::tare);
    if (chance(1e-3)) order(OperatorAction::target_by_hand, uniform(0.3, 1.0));
    if (chance(1e-3)) order(OperatorAction::target_from_robot);
    if (!chance(3e-3)) return;
    const std::size_t index = live_[static_cast<std::size_t>(below(static_cast<int>(live_.size())))];
    const Parameter& p = bound_[index];
    double value = p.kind == ParameterKind::real && chance(0.9)
                       ? std::clamp(p.value() * uniform(0.6, 1.6), p.info.minimum, p.info.maximum)
                       : std::floor(uniform(p.info.minimum, std::min(p.info.maximum, 1e3) + 1));
    if (chance(0.05)) value = kNaN;
    (void)inputs_.changes.push({.index = static_cast<std::uint16_t>(index), .value = value});
  }

  void poison() {
    switch (below(6)) {
      case 0: inputs_.bridge.set({.value_mV_per_V = kNaN}, inputs_.now); break;
      case 1: inputs_.finger.value.x_mm = kNaN; break;
      case 2: inputs_.robot.state.value.stiffness_N_per_mm = kNaN; break;
      case 3: inputs_.motors.value.encoder_counts[0] = 5000; break;
      case 4: inputs_.ir.value[static_cast<std::size_t>(below(3))] = static_cast<std::uint16_t>(below(4096)); break;
      default: (void)inputs_.robot.accelerations.push({.taken = inputs_.now, .acceleration_g = {kNaN, 1e9, -kNaN}});
    }
  }

  std::mt19937 random_;
  Parameters defaults_;
  std::vector<Parameter> bound_;
  std::vector<std::size_t> live_;
  sensing::IrDistance curve_;
  sensing::Membrane membrane_;
  Inputs inputs_;
  double time_s_ = 100.0;
  int step_ = 0;
  int left_ = 0;

  bool touching_ = false;
  bool stuck_ = false;
  bool dead_cell_ = false;
  bool blind_ = false;
  bool moved_by_robot_ = false;
  LinkPhase phase_ = LinkPhase::none;
  int batch_ = 1;
  double poison_ = 0.0;  // probability per step
  double depth_goal_mm_ = 0.0;
  double depth_mm_ = 0.0;
  double x_mm_ = 0.0;
  double y_mm_ = 0.0;
  double pace_x_ = 0.0;  // mm/s
  double pace_y_ = 0.0;
  double stiffness_ = 0.6;
  double cloth_scale_ = 1.0;
  std::array<double, control::kMotorCount> angle_deg_{20.0, -20.0};
};

}  // namespace fyd::pipeline
