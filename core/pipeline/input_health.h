// Which of the things the present mode needs are missing, judged from the inputs' ages and validity.
#pragma once

#include <array>
#include <bitset>

#include "core/base/state.h"
#include "core/pipeline/inputs.h"
#include "core/pipeline/safety.h"

namespace fyd::pipeline {

struct StepParameters;
using Lacks = std::bitset<kLackCount>;  ///< indexed by the number of a Lack

/// What only the step knows of this moment.
struct HealthContext {
  bool bridge_valid = true;        ///< the load cell's value lies in its span
  bool indentation_usable = true;  ///< false only while a finger presses and its indentation cannot be told
  bool needs_robot = true;         ///< the target comes from the robot
  bool target_known = true;
  bool step_gap = false;      ///< more than 20 ms without a step
  bool steps_missed = false;  ///< more than 5 % of the cycles of one second
};

struct Judgement {
  Lacks lacks;   ///< missing for Active
  Lacks faults;  ///< what ends rendering, though nothing is missing
};

class InputHealth {
 public:
  /// Validity (not only age), once it was there, may fail for up to the input's maximum age before it counts.
  [[nodiscard]] Judgement judge(const Inputs& inputs, const HealthContext& context, const StepParameters& limits);

  /// Any sensor of the touchpad answers.
  [[nodiscard]] static bool devicesLive(const Lacks& lacks);
  /// The most urgent lack; none when complete.
  [[nodiscard]] static Lack first(const Lacks& lacks);

  static constexpr std::uint16_t kStateVersion = 2;
  template <class Archive>
  void serialize(Archive& archive) {
    auto count = static_cast<std::uint8_t>(graces_.size());
    archive(within(count, kLackCount));
    for (std::uint8_t i = 0; i < count; ++i) archive(graces_[i]);
  }
  /// Version 1 had three graces, without their numbers.
  template <class Archive>
  void restore(Archive& archive, std::uint16_t /*version*/) {
    archive(graceOf(Lack::camera_blind), graceOf(Lack::ir_invalid), graceOf(Lack::bridge_invalid));
  }

 private:
  /// True once `bad` has held longer than `grace`; without grace until it was good for the first time.
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
  [[nodiscard]] Grace& graceOf(Lack lack) { return graces_[static_cast<std::size_t>(lack)]; }
  std::array<Grace, kLackCount> graces_;  ///< of those that have one
};

}  // namespace fyd::pipeline
