// A predictor of one's own: the newest position, moved on by a speed that fades. Compared with the program's own on a
// recorded hand.
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/base/csv.h"
#include "core/teleop/prediction/motion_history.h"
#include "core/teleop/prediction/plain_predictors.h"
#include "core/teleop/prediction/prediction_trial.h"
#include "core/teleop/prediction/predictor_choice.h"

using namespace fyd;
using namespace fyd::teleop;

// With τ the fading time and a the age of the newest message:
//   position  x + v·τ·(1 − e^(−a/τ))      speed  v·e^(−a/τ)
class FadingPredictor final : public Predictor {
 public:
  void message(double date_s, const Position& position_mm) override {
    if (!history_.empty() && date_s - history_.newest().date_s > kSilence_s) endMotion();
    // The history refuses what is not finite, too far away or of a date that it has.
    if (history_.insert(date_s, position_mm) == MotionHistory::Insertion::refused) return;
    speed_mm_s_ = newestSlope(history_, kWindow_s);
  }

  Position predict(double time_s) override {
    if (history_.empty()) return {};
    Position out = history_.newest().position_mm;
    const double moved_s = kFading_s * (1.0 - std::exp(-age(time_s) / kFading_s));
    for (std::size_t axis = 0; axis < kMostAxes; ++axis) out[axis] += speed_mm_s_[axis] * moved_s;
    return out;
  }

  Position velocity(double time_s) const override {
    Position out = speed_mm_s_;
    for (double& each : out) each *= history_.empty() ? 0.0 : std::exp(-age(time_s) / kFading_s);
    return out;
  }

  void endMotion() override {
    history_.clear();
    speed_mm_s_ = {};
  }

 private:
  static constexpr double kWindow_s = 0.020, kFading_s = 0.050;
  // Never negative: a time before the newest message asks for no prediction.
  double age(double time_s) const { return std::fmax(0.0, time_s - history_.newest().date_s); }

  MotionHistory history_;
  Position speed_mm_s_{};
};

int main(int count, char** arguments) {
  const std::string path = count > 1 ? arguments[1] : "tests/data/teleop_1dof/c_free_motion.csv";
  const auto table = readCsv(path, {"t_s", "master_mm"});
  if (!table) return fmt::print(stderr, "{}\n", table.error().text()), 1;
  Trace hand{.axes = 1, .time_s = table->values[0], .position_mm = {}};
  for (const double each : table->values[1]) hand.position_mm.push_back({each, 0.0, 0.0});

  const TrialPlan plan = planTrial(hand, {.period_ms = 10.0, .delay_ms = 50.0});
  const auto judge = [&](const char* name, Predictor& predictor) {
    const TrialFigures figures = trialFigures(hand, plan, runTrial(hand, plan, predictor, 0.0));
    fmt::print("{:<8} RMS {:.2f} mm   largest {:.1f} mm\n", name, figures.rms_mm, figures.max_mm);
  };
  FadingPredictor fading;
  judge("fading", fading);
  for (const auto choice : {PredictorChoice::order0, PredictorChoice::order1, PredictorChoice::experts}) {
    judge(kPredictorNames[static_cast<std::size_t>(choice)].data(),
          *makePredictor(choice, {.axes = 1, .period_s = 0.01}));
  }
}
