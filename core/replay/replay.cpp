#include "core/replay/replay.h"

#include <algorithm>
#include <cmath>

#include "core/pipeline/pipeline.h"
#include "core/recording/format/recording_format.h"
#include "core/recording/format/step_compare.h"
#include "core/recording/reader/recorded_profile.h"
#include "core/recording/reader/recording_health.h"
#include "core/replay/replay_plant.h"

namespace fyd::replay {
namespace {

/// The parameters of --set, and how they differ from the recorded ones.
struct Wanted {
  pipeline::Parameters parameters;
  std::vector<pipeline::ParameterChange> changes;  // live ones: they go in with the first step
  std::vector<std::uint16_t> indices;              // recorded changes of these are ignored
  bool from_rest = false;
};

Result<Wanted> wantedOf(const pipeline::Parameters& recorded, const std::vector<std::string>& settings) {
  Wanted out{.parameters = recorded};
  const std::vector<Parameter> bound = bindParameters(out.parameters);
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) return fail("'{}': expected id=value", setting);
    const std::string id = setting.substr(0, equals);
    const Parameter* parameter = findParameter(bound, id);
    if (parameter == nullptr) return fail("unknown parameter '{}'; a replay changes the step's only", id);
    if (auto set = assignParameter(*parameter, setting.substr(equals + 1), Ranges::mark); !set) {
      return tl::unexpected(set.error());
    }
    const auto index = static_cast<std::uint16_t>(parameter - bound.data());
    out.indices.push_back(index);
    if (parameter->info.live && parameter->isNumber()) {
      out.changes.push_back({.index = index, .value = parameter->value()});
    } else {
      out.from_rest = true;
    }
  }
  return out;
}

constexpr std::string_view kForceZero = "sensing.force_zero_N";  // a tare sets it

/// RMS of the measured stiffness' distance from its target, while it is observable.
struct StiffnessError {
  double squares = 0.0;
  std::uint64_t count = 0;
  void add(const pipeline::TelemetrySample& sample) {
    const double error = sample.stiffness_N_per_mm / sample.target_N_per_mm - 1.0;
    if (!sample.stiffness_observable || sample.state != pipeline::SafetyState::active || !std::isfinite(error)) return;
    squares += error * error;
    ++count;
  }
  [[nodiscard]] double percent() const {
    return count == 0 ? pipeline::kNone : 100.0 * std::sqrt(squares / static_cast<double>(count));
  }
};

void noteOutOfRange(ReplayResult& out, const Parameter& parameter) {
  if (std::ranges::find(out.out_of_range, parameter.id) == out.out_of_range.end()) {
    out.out_of_range.emplace_back(parameter.id);
  }
}

class Run {
 public:
  Run(const recording::Recording& recording, const Wanted& wanted, const pipeline::LocalModel& local,
      const ReplayObserver& observer)
      : recording_(recording), wanted_(wanted), pipeline_(wanted.parameters, local), observer_(observer) {
    pipeline_.takeRecordedValues();
  }

  Result<void> restore(const std::string& state) { return pipeline_.restoreState(state); }
  void closeLoop(const control::IdentifiedCloth& cloth, const control::ControlParameters& recorded) {
    plant_.emplace(cloth, recorded);
  }

  Result<void> all(ReplayResult& out) {
    const std::uint64_t rows = recording_.info().committed_samples;
    Instant before{};
    for (std::uint64_t row = 0; row < rows; ++row) {
      auto record = recording_.step(row);
      if (!record) return tl::unexpected(record.error());
      if (row > 0 && record->telemetry.step != last_step_ + 1) break;
      const double elapsed_s = row == 0 ? 0.0 : std::clamp(toSeconds(record->inputs.now - before), 0.0, 0.02);
      before = record->inputs.now;
      last_step_ = record->telemetry.step;
      if (record->missing != 0) hold(*record);
      before_ = record->inputs;
      if (auto stepped = step(*record, row == 0, elapsed_s, out); !stepped) return stepped;
      out.duration_s = secondsInto(recording_.info(), record->inputs.now);
    }
    out.stiffness_error_recorded_percent = recorded_error_.percent();
    out.stiffness_error_replayed_percent = replayed_error_.percent();
    return {};
  }

 private:
  [[nodiscard]] Result<void> step(recording::StepRecord& record, bool first, double elapsed_s, ReplayResult& out) {
    inputs_ = record.inputs;
    repeatOutcomes(record);
    if (first || !wanted_.indices.empty()) {
      if (auto changed = change(first, record); !changed) return changed;
    }
    mark(out);
    if (plant_) plant_->answer(inputs_, pipeline_.parameters());
    const pipeline::Outputs& outputs = pipeline_.step(inputs_);
    takeMissingColumns(recording_.info().missing_columns, outputs, record);
    ++out.samples;
    recorded_error_.add(record.telemetry);
    replayed_error_.add(outputs.telemetry);
    const bool motors_lost = (record.missing & bitOf(recording::Table::motors)) != 0;
    const control::MotorCommand& motors = motors_lost ? outputs.motors : record.motors;
    if (plant_) plant_->follow(motors, outputs.motors, elapsed_s);
    if (!recording::sameStep(record.telemetry, motors, outputs.telemetry, outputs.motors))
      note(record, motors, outputs, out);
    state_ = outputs.telemetry.state;
    tared_ = tared_ || std::ranges::any_of(outputs.events, [](const pipeline::Event& event) {
               return event.kind == pipeline::EventKind::tare_done;
             });
    if (observer_) observer_(outputs.telemetry, record.telemetry);
    return {};
  }

  /// Fills in the lost parts of a step: inputs as if nothing new came, commands as the replay computes them.
  void hold(recording::StepRecord& record) const {
    const auto lost = [&](recording::Table table) { return (record.missing & bitOf(table)) != 0; };
    if (lost(recording::Table::steps)) record.inputs.missed_cycles = before_.missed_cycles;
    forEachOf(recording::kInputTables, [&](auto, const auto& input) {
      auto& value = input.of(record.inputs);
      if constexpr (!recording::kIsList<std::remove_cvref_t<decltype(value)>>)
        if (lost(static_cast<recording::Table>(input.number))) value = input.of(before_);
    });
  }

  /// Gives changes of the step's parameters their recorded outcome, even if the ranges have changed since: a refused
  /// change is refused again, and a robot's key gives the same value.
  void repeatOutcomes(const recording::StepRecord& record) {
    using enum pipeline::EventKind;
    const auto outcome = [&record](pipeline::EventKind kind, std::uint16_t index) {
      const pipeline::Event* last = nullptr;
      for (const pipeline::Event& event : record.events) {
        if (event.kind == kind && event.index == index) last = &event;
      }
      return last;
    };
    const auto changes = inputs_.changes;
    inputs_.changes.clear();
    for (const pipeline::ParameterChange& change : changes) {
      if (outcome(parameter_refused, change.index) == nullptr) (void)inputs_.changes.push(change);
    }
    for (pipeline::OperatorCommand& command : inputs_.commands.view()) {
      if (command.action != pipeline::OperatorAction::target_by_hand) continue;
      if (outcome(parameter_refused, indexOf(pipeline::Pipeline::kHandTarget)) != nullptr) {
        command.value = pipeline::kNone;
      } else if (isWanted(indexOf(pipeline::Pipeline::kHandTarget))) {
        command.value = wanted_.parameters.step.hand_target_N_per_mm;  // it still switches to "by hand"
      }
    }
    const auto keys = inputs_.robot.commands;
    inputs_.robot.commands.clear();
    for (const pipeline::RobotCommand key : keys) {
      const std::string_view id = pipeline::Pipeline::parameterOf(key);
      const std::uint16_t index = id.empty() ? recording::RecordedIndices::kUnknown : indexOf(id);
      if (isWanted(index)) continue;
      const pipeline::Event* changed = id.empty() ? nullptr : outcome(parameter_changed, index);
      if (changed == nullptr || !inputs_.changes.push({.index = index, .value = changed->value})) {
        (void)inputs_.robot.commands.push(key);
      }
    }
  }

  [[nodiscard]] std::uint16_t indexOf(std::string_view id) const {
    return static_cast<std::uint16_t>(findParameter(names_, id) - names_.data());
  }
  [[nodiscard]] bool isWanted(std::uint16_t index) const {
    return std::ranges::find(wanted_.indices, index) != wanted_.indices.end();
  }

  void mark(ReplayResult& out) const {
    for (const pipeline::ParameterChange& change : inputs_.changes) mark(change, out);
    for (const pipeline::OperatorCommand& command : inputs_.commands) {
      if (command.action != pipeline::OperatorAction::target_by_hand || !std::isfinite(command.value)) continue;
      mark({.index = indexOf(pipeline::Pipeline::kHandTarget), .value = command.value}, out);
    }
  }

  void mark(const pipeline::ParameterChange& change, ReplayResult& out) const {
    if (change.index >= names_.size()) {
      ++out.unknown_changes;
    } else if (!mayTake(names_[change.index], change.value)) {
      noteOutOfRange(out, names_[change.index]);
    }
  }

  [[nodiscard]] Result<void> change(bool first, const recording::StepRecord& record) {
    const auto recorded = inputs_.changes;
    inputs_.changes.clear();
    std::size_t more = 0;
    const auto push = [&](const pipeline::ParameterChange& change) {
      if (!inputs_.changes.push(change)) ++more;
    };
    if (first && !wanted_.from_rest) std::ranges::for_each(wanted_.changes, push);  // else the step was made with them
    for (const pipeline::ParameterChange& change : recorded) {
      if (!isWanted(change.index)) push(change);
    }
    if (tared_ && putZeroBack()) tared_ = false;
    if (more > 0) {
      return fail(
          "{} parameters change with the first step, those of the recording included; a step takes at most {}: set "
          "fewer at once",
          inputs_.changes.size() + more, decltype(inputs_.changes)::capacity());
    }
    if (!wanted_.from_rest) return {};
    // Repeats the operator's actions from before the first row.
    if (first && inputs_.robot.phase == pipeline::LinkPhase::none && pipeline_.scene() == nullptr) {
      (void)inputs_.commands.push(
          {.action = pipeline::OperatorAction::target_by_hand, .value = wanted_.parameters.step.hand_target_N_per_mm});
    }
    if (record.telemetry.state == pipeline::SafetyState::active && state_ == pipeline::SafetyState::ready) {
      (void)inputs_.commands.push({.action = pipeline::OperatorAction::arm});
    }
    return {};
  }

  /// @return false when the step takes no more changes: with the next one
  [[nodiscard]] bool putZeroBack() {
    const std::uint16_t zero = indexOf(kForceZero);
    return !isWanted(zero) ||
           inputs_.changes.push({.index = zero, .value = wanted_.parameters.sensing.load_cell.zero_N});
  }

  void note(const recording::StepRecord& record, const control::MotorCommand& motors, const pipeline::Outputs& outputs,
            ReplayResult& out) const {
    const auto difference = recording::compareSteps(record.telemetry, motors, outputs.telemetry, outputs.motors);
    if (!difference) return;
    if (out.tolerance &&
        !recording::withinTolerance(*out.tolerance, record.telemetry, motors, outputs.telemetry, outputs.motors)) {
      ++out.beyond_tolerance;
    }
    if (out.different++ == 0) {
      out.first_difference_s = secondsInto(recording_.info(), record.inputs.now);
      out.first_difference_field = difference->field;
    }
    if (out.max_difference_field.empty() || difference->absolute > out.max_abs_difference) {
      out.max_abs_difference = difference->absolute;
      out.max_difference_field = difference->field;
    }
  }

  const recording::Recording& recording_;
  const Wanted& wanted_;
  pipeline::Parameters described_;
  std::vector<Parameter> names_ = bindParameters(described_);
  pipeline::Pipeline pipeline_;
  const ReplayObserver& observer_;
  std::optional<ReplayPlant> plant_;
  pipeline::Inputs inputs_;
  pipeline::Inputs before_;  // as recorded, of the step before
  bool tared_ = false;       // a recorded tare took a zero; one that is wanted is put back before the next reading
  pipeline::SafetyState state_ = pipeline::SafetyState::disconnected;
  std::uint64_t last_step_ = 0;
  StiffnessError recorded_error_;
  StiffnessError replayed_error_;
};

}  // namespace

Result<void> checkSettings(const std::vector<std::string>& settings) {
  if (const auto wanted = wantedOf({}, settings); !wanted) return tl::unexpected(wanted.error());
  return {};
}

Result<ReplayResult> replay(const recording::Recording& recording, const ReplayOptions& options,
                            const ReplayObserver& observer) {
  const recording::RecordingInfo& info = recording.info();
  if (info.committed_samples == 0) return fail("the recording holds no step");
  const auto recorded = recordedParameters(info.header);
  if (!recorded) return tl::unexpected(recorded.error());
  const auto local = recordedLocalModel(info.header);
  if (!local) return tl::unexpected(local.error());
  const auto wanted = wantedOf(*recorded, options.settings);
  if (!wanted) return tl::unexpected(wanted.error());
  if (auto whole = control::checkControlParameters(wanted->parameters.control); !whole) {
    return tl::unexpected(whole.error());
  }

  ReplayResult out{
      .what_if = !options.settings.empty(),
      .closed_loop = options.closed_loop,
      .from_rest = wanted->from_rest,
      .of = info.gaps + (info.wholeness == recording::Wholeness::damaged ? info.samples : info.committed_samples),
      .gaps = info.gaps,
      .why_not_exact = whyNoExactReplay(info),
      .arithmetic_recorded = info.header.arithmetic,
      .tolerance = pipeline::arithmeticTolerance(info.header.arithmetic)};
  pipeline::Parameters checked = wanted->parameters;
  for (const Parameter& parameter : bindParameters(checked)) {
    if (!insideRange(parameter)) noteOutOfRange(out, parameter);
  }
  Run run(recording, *wanted, *local, observer);
  if (!wanted->from_rest) {
    if (info.header.step_state.empty()) {
      return fail(
          "the recording holds no state of the step to start from: steps had been lost before it began; it can be "
          "looked at, not replayed");
    }
    const auto state = recordedState(info.header);
    if (!state) return tl::unexpected(state.error());
    if (auto restored = run.restore(*state); !restored) return tl::unexpected(restored.error());
  }
  if (options.closed_loop) {
    const auto cloth = identifyRecordedCloth(recording, recorded->control);
    if (!cloth) return tl::unexpected(cloth.error());
    out.cloth = *cloth;
    run.closeLoop(*cloth, recorded->control);
  }
  const Instant start = Clock::now();
  if (auto ran = run.all(out); !ran) return tl::unexpected(ran.error());
  out.speed_x = out.duration_s / std::max(1e-9, toSeconds(Clock::now() - start));
  const bool all = out.samples == out.of && out.why_not_exact.empty();
  out.identical = out.different == 0 && all && out.gaps == 0;
  out.explained = out.tolerance && out.beyond_tolerance == 0 && all;
  return out;
}

}  // namespace fyd::replay
