// Which of the things the present mode needs are missing, judged from the inputs' ages and validity.
// Stability: may change
#pragma once

#include <array>
#include <bitset>

#include "core/base/api.h"
#include "core/base/state.h"
#include "core/pipeline/inputs.h"
#include "core/pipeline/safety.h"

namespace fyd::pipeline {

struct StepParameters;
using FaultSet = std::bitset<kFaultCount>;  ///< indexed by the number of a Fault

/// Conditions of this moment that the step computes and the inputs alone do not tell.
struct HealthContext {
  bool bridge_valid = true;        ///< the load cell's value lies in its span
  bool indentation_usable = true;  ///< false while too few distance sensors are valid
  bool needs_robot = true;         ///< the target comes from the robot
  bool target_known = true;
  bool step_gap = false;      ///< more than 20 ms without a step
  bool steps_missed = false;  ///< more than 5 % of the cycles of one second
};

struct Judgement {
  FaultSet faults;         ///< what is missing for Active
  FaultSet interruptions;  ///< what ends rendering although no input is missing (Need::rendering)
};

class FYD_API InputHealth {
 public:
  /// A fresh input that was valid once may be invalid for up to its maximum age before that counts.
  [[nodiscard]] Judgement judge(const Inputs& inputs, const HealthContext& context, const StepParameters& limits);

  /// Any sensor of the touchpad answers.
  [[nodiscard]] static bool devicesLive(const FaultSet& faults);
  /// The most urgent fault; none when nothing is missing.
  [[nodiscard]] static Fault first(const FaultSet& faults);

  static constexpr std::uint16_t kStateVersion = 2;
  template <class Archive>
  void serialize(Archive& archive) {
    auto count = static_cast<std::uint8_t>(graces_.size());
    archive(within(count, kFaultCount));
    for (std::uint8_t i = 0; i < count; ++i) archive(graces_[i]);
  }
  /// Version 1 stored three grace timers, without their numbers.
  template <class Archive>
  void restore(Archive& archive, std::uint16_t /*version*/) {
    archive(graceOf(Fault::camera_blind), graceOf(Fault::ir_invalid), graceOf(Fault::bridge_invalid));
  }

 private:
  /// expired(): true once the input has been bad for longer than `grace_ms`, and always before it was good for the
  /// first time.
  struct Grace {
    Instant since{};
    bool bad = false;
    bool ever_good = false;
    bool expired(bool now_bad, Instant now, double grace_ms);

    template <class Archive>
    void serialize(Archive& archive) {
      archive(since, bad, ever_good);
    }
  };
  [[nodiscard]] Grace& graceOf(Fault fault) { return graces_[static_cast<std::size_t>(fault)]; }
  std::array<Grace, kFaultCount> graces_;  ///< indexed by the number of a Fault; only some have a grace time
};

}  // namespace fyd::pipeline
