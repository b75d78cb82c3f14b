// Predictors of a hand's motion over a late network.
#include <fmt/format.h>

#include <cmath>

#include "app/python/common.h"
#include "core/teleop/prediction/prediction_trial.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::python {
namespace {

using teleop::Position;

struct Predicting {
  std::size_t axes;
  std::unique_ptr<teleop::Predictor> predictor;
};
using PredictorOwner = Shared<Predicting>;

std::size_t checkedAxes(py::ssize_t axes) {
  if (axes < 1 || axes > static_cast<py::ssize_t>(teleop::kMostAxes))
    throw Refusal{fmt::format("axes: {}; expected 1 to {}", axes, teleop::kMostAxes)};
  return static_cast<std::size_t>(axes);
}

std::unique_ptr<teleop::Predictor> made(const std::string& name, std::size_t axes, double period_s) {
  if (!std::isfinite(period_s) || period_s < 0.0)
    throw Refusal{fmt::format("period_s: {}; expected 0 (not known) or more", period_s)};
  return teleop::makePredictor(valid(teleop::predictorNamed(name)), {.axes = axes, .period_s = period_s});
}

Position positionOf(const Numbers& from, std::size_t axes) {
  if (from.ndim() != 1 || static_cast<std::size_t>(from.shape(0)) != axes)
    throw Refusal{fmt::format("position_mm: shape {}; expected ({},)", shapeOf(from), axes)};
  Position out{};
  for (std::size_t i = 0; i < axes; ++i) out[i] = from.at(static_cast<py::ssize_t>(i));
  return out;
}

py::array_t<double> arrayFrom(const Position& position, std::size_t axes) {
  return py::array_t<double>(static_cast<py::ssize_t>(axes), position.data());
}

py::dict trial(const Numbers& time_s, const Numbers& position_mm, const std::string& name, double period_ms,
               double delay_ms, double jitter_ms, double loss_percent, std::uint64_t seed, double smooth_s) {
  const auto times = vector(time_s, "time_s");
  if (position_mm.ndim() != 2 || position_mm.shape(0) != static_cast<py::ssize_t>(times.size()))
    throw Refusal{fmt::format("position_mm: shape {}; expected ({}, 1 to 3)", shapeOf(position_mm), times.size())};
  if (!std::isfinite(smooth_s) || smooth_s < 0.0)
    throw Refusal{fmt::format("smooth_s: {}; expected 0 (none) or more", smooth_s)};
  teleop::Trace trace;
  trace.axes = checkedAxes(position_mm.shape(1));
  trace.time_s.assign(times.begin(), times.end());
  trace.position_mm.resize(times.size());
  for (std::size_t row = 0; row < times.size(); ++row)
    for (std::size_t axis = 0; axis < trace.axes; ++axis)
      trace.position_mm[row][axis] = position_mm.at(static_cast<py::ssize_t>(row), static_cast<py::ssize_t>(axis));
  const teleop::TrialNetwork network{period_ms, delay_ms, jitter_ms, loss_percent, seed};
  valid(teleop::checkTrace(trace));
  valid(teleop::checkNetwork(network));
  valid(teleop::checkMessages(trace, network));
  const auto predictor = made(name, trace.axes, 1e-3 * period_ms);
  teleop::TrialPlan plan;
  std::vector<Position> predicted;
  teleop::TrialFigures figures;
  {
    const OthersGoOn others_go_on;
    plan = teleop::planTrial(trace, network);
    predicted = teleop::runTrial(trace, plan, *predictor, smooth_s);
    figures = teleop::trialFigures(trace, plan, predicted);
  }
  std::vector<std::uint64_t> rows;
  rows.reserve(plan.ticks.size());
  for (const auto& tick : plan.ticks) rows.push_back(tick.row);
  py::array_t<double> positions({static_cast<py::ssize_t>(predicted.size()), static_cast<py::ssize_t>(trace.axes)});
  for (std::size_t i = 0; i < predicted.size(); ++i)
    for (std::size_t axis = 0; axis < trace.axes; ++axis)
      positions.mutable_at(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(axis)) = predicted[i][axis];
  py::dict out;
  out["row"] = arrayOf(std::move(rows));
  out["position_mm"] = positions;
  out["rms_mm"] = figures.rms_mm;
  out["mean_mm"] = figures.mean_mm;
  out["max_mm"] = figures.max_mm;
  out["vibration_ratio"] = figures.vibration_ratio;
  out["largest_step_mm"] = figures.largest_step_mm;
  out["jerk_ratio"] = figures.jerk_ratio;
  return out;
}

}  // namespace

void addPrediction(py::module_& module) {
  py::tuple names(teleop::kPredictorNames.size());
  for (std::size_t i = 0; i < teleop::kPredictorNames.size(); ++i) names[i] = std::string(teleop::kPredictorNames[i]);
  module.attr("PREDICTORS") = names;

  py::class_<PredictorOwner>(module, "Predictor",
                             "Where a hand is now, from messages of where it was. A message comes late, irregularly, "
                             "twice, out of order or not at all.")
      .def(py::init([](const std::string& name, py::ssize_t axes, double period_s) {
             const std::size_t checked = checkedAxes(axes);
             return std::make_unique<PredictorOwner>(Predicting{checked, made(name, checked, period_s)});
           }),
           py::arg("name") = "default", py::arg("axes") = 1, py::arg("period_s") = 0.0,
           "One of PREDICTORS, for 1 to 3 axes; period_s [s] of the sender's messages, 0: not known.")
      .def(
          "message",
          [](PredictorOwner& owner, double date_s, const Numbers& position_mm) {
            const std::size_t axes = owner.run([](Predicting& each) { return each.axes; });
            const Position position = positionOf(position_mm, axes);
            owner.run([&](Predicting& each) { each.predictor->message(date_s, position); });
          },
          py::arg("date_s"), py::arg("position_mm"),
          "A message has arrived: at date_s [s] the hand was at position_mm [mm]. What is not finite is ignored.")
      .def(
          "predict",
          [](PredictorOwner& owner, double time_s) {
            const auto [at, axes] =
                owner.run([&](Predicting& each) { return std::pair(each.predictor->predict(time_s), each.axes); });
            return arrayFrom(at, axes);
          },
          py::arg("time_s"), "The position [mm] at time_s [s]; always finite, zeros before the first message.")
      .def(
          "velocity",
          [](PredictorOwner& owner, double time_s) {
            const auto [at, axes] =
                owner.run([&](Predicting& each) { return std::pair(each.predictor->velocity(time_s), each.axes); });
            return arrayFrom(at, axes);
          },
          py::arg("time_s"), "The prediction's rate of change [mm/s] at time_s [s].")
      .def(
          "end_motion", [](PredictorOwner& owner) { owner.run([](Predicting& each) { each.predictor->endMotion(); }); },
          "The hand was lifted; the next message begins another motion. Units: none.");

  module.def(
      "predict_trial", &trial, py::arg("time_s"), py::arg("position_mm"), py::arg("name") = "default",
      py::arg("period_ms") = 10.0, py::arg("delay_ms") = 50.0, py::arg("jitter_ms") = 0.0,
      py::arg("loss_percent") = 0.0, py::arg("seed") = 1, py::arg("smooth_s") = 0.0,
      "Sends a recorded motion, time_s [s] and position_mm [mm] of shape (n, axes), over a simulated network (a "
      "message every period_ms [ms], delay_ms [ms], up to jitter_ms [ms] more, loss_percent [%]) and predicts it. "
      "Returns `row` of the motion at each tick, the predicted `position_mm` [mm] there, and the figures `rms_mm`, "
      "`mean_mm`, `max_mm`, `largest_step_mm` [mm], `vibration_ratio` and `jerk_ratio` [1], of the predicted motion's "
      "over the true one's. A ratio is NaN where the true motion has none of it, that of vibration below 1000 rows a "
      "second as well; where no message arrives `row` is empty and every figure NaN. smooth_s [s]: time constant of "
      "the output's smoothing. Other threads go on meanwhile.");
}

}  // namespace fyd::python
