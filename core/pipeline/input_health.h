// Which of the things the present mode needs are missing, judged from the inputs' ages and validity.
#pragma once

#include <bitset>

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
};

class InputHealth {
 public:
  /// Validity (not only age), once it was there, may fail for up to the input's maximum age before it counts.
  [[nodiscard]] Lacks judge(const Inputs& inputs, const HealthContext& context, const StepParameters& limits);

  /// Any sensor of the touchpad answers.
  [[nodiscard]] static bool devicesLive(const Lacks& lacks);
  /// The most urgent lack; none when complete.
  [[nodiscard]] static Lack first(const Lacks& lacks);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(camera_blind_, ir_invalid_, bridge_invalid_);
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
  Grace camera_blind_;
  Grace ir_invalid_;
  Grace bridge_invalid_;
};

}  // namespace fyd::pipeline
