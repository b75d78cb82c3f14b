// A simulated session in virtual time and a temporary folder to record it: input of the benches of recorder and replay.
#pragma once

#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/recording/writer/recorder.h"
#include "core/sim/touchpad/lockstep.h"

namespace fyd::bench {

/// A folder that the destructor removes.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static int number = 0;
    path_ = std::filesystem::temp_directory_path() / fmt::format("fyd-bench-{}-{}", ::getpid(), number++);
    std::filesystem::create_directories(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

enum class SessionKind : std::uint8_t {
  gesture,  ///< the demonstration gesture
  /// A finger that stays, on a cloth whose target goes up and down: says how the cloth answers, as a replay in closed
  /// loop needs to know.
  staircase,
};

/// Armed after 0.3 s, one acceleration a step. `each` gets the inputs and outputs of each step.
inline void simulateSession(SessionKind kind, double seconds,
                            const std::function<void(const recording::StepView&)>& each) {
  constexpr std::size_t kStair = 1'200;                  // steps
  constexpr std::array kStairs_N_per_mm = {0.62, 0.80};  // what 6 mm in the middle can do
  sim::LockstepOptions options;
  options.finger =
      kind == SessionKind::gesture ? sim::FingerPath::demonstration() : sim::FingerPath::constant(0.0, 0.0, 6.0);
  options.draw_pictures = false;
  sim::Lockstep lockstep(options);
  pipeline::Inputs inputs;
  std::size_t steps = 0;
  lockstep.spoil = [&](pipeline::Inputs& in) {
    const double phase = 0.7 * static_cast<double>(steps++);
    (void)in.robot.accelerations.push(
        {.taken = in.now, .acceleration_g = {std::sin(phase), 0.5 * std::cos(1.3 * phase), 0.2}});
    if (steps == 300) (void)in.commands.push({.action = pipeline::OperatorAction::arm});
    if (kind == SessionKind::staircase && steps % kStair == 0) {
      (void)in.commands.push({.action = pipeline::OperatorAction::target_by_hand,
                              .value = kStairs_N_per_mm[steps / kStair % kStairs_N_per_mm.size()]});
    }
    inputs = in;
  };
  lockstep.run(seconds, [&](const pipeline::Outputs& outputs) {
    each(recording::StepView{.inputs = inputs, .outputs = outputs});
  });
}

}  // namespace fyd::bench
