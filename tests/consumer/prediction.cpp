// Where a hand is now, from messages 50 ms old. Truth: the hand's own motion, which the predictor does not see.
#include <core/teleop/prediction/predictor_choice.h>

#include "expect.h"

namespace {

/// Root mean square, mm, over the second half of ten seconds.
template <class Motion>
double errorOf(fyd::teleop::PredictorChoice choice, Motion hand_mm) {
  constexpr int kPeriod_ms = 10, kDelay_ms = 50;
  const auto predictor = fyd::teleop::makePredictor(choice, {.axes = 1, .period_s = 1e-3 * kPeriod_ms});
  double squares = 0.0;
  for (int now_ms = 0; now_ms < 10'000; ++now_ms) {
    const int sent_ms = now_ms - kDelay_ms;
    if (sent_ms >= 0 && sent_ms % kPeriod_ms == 0) predictor->message(1e-3 * sent_ms, {hand_mm(1e-3 * sent_ms)});
    const double off_mm = predictor->predict(1e-3 * now_ms)[0] - hand_mm(1e-3 * now_ms);
    if (now_ms >= 5'000) squares += off_mm * off_mm;
  }
  return std::sqrt(squares / 5'000);
}

}  // namespace

int main() {
  using enum fyd::teleop::PredictorChoice;
  const auto even = [](double t_s) { return 40.0 * t_s - 7.0; };
  // An even motion of 40 mm/s: order 0 is late by the age of its newest message, 50 to 59 ms; order 1 is exact.
  expectNear("order 0, mm", errorOf(order0, even), 40.0 * 0.0546, 40.0 * 0.001);
  expectNear("order 1, mm", errorOf(order1, even), 0.0, 1e-6);
  const auto stroke = [](double t_s) { return 30.0 * std::sin(6.0 * t_s); };
  const double last = errorOf(order0, stroke), predicted = errorOf(experts, stroke);
  expect("the default predictor gains on a stroke", predicted < 0.5 * last);
  expect("no predictor of that name", !fyd::teleop::predictorNamed("crystal ball"));
}
