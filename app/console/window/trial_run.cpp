#include "app/console/window/trial_run.h"

#include "widgets/basics/core_text.h"

namespace fyd::console {

using widgets::Severity;

namespace {

const QString kTrial = QStringLiteral("trial");  // cause of notices: each stands in the place of the former one

}  // namespace

TrialRun::TrialRun(const PageContext& context, QObject* parent) : QObject(parent), context_(context) {}

void TrialRun::addCommands(CommandRegistry& commands) {
  commands.on(QStringLiteral("session.next_trial"), [this](bool) { next(); });
}

Result<void> TrialRun::plan(const TrialWords& words) {
  std::vector<std::string> conditions;
  for (const QString& each : words.conditions) conditions.push_back(each.trimmed().toStdString());
  auto ordered =
      experiment::orderTrials(conditions, static_cast<std::size_t>(std::max(0, words.repetitions)), words.seed);
  if (!ordered) return tl::unexpected(ordered.error());
  trials_ = std::move(*ordered);
  begun_ = 0;
  under_way_ = false;
  return {};
}

bool TrialRun::mark(recording::NoteKind kind, const experiment::Trial& trial) {
  const auto kept = context_.session.note(kind, experiment::markerText(trial));
  if (!kept) context_.tell_about(kTrial, Severity::warning, widgets::coreText(kept.error().message));
  return kept.has_value();
}

void TrialRun::next() {
  if (trials_.empty()) {
    context_.tell_about(kTrial, Severity::information, tr("No trials are planned: start with --trials soft,hard,…"));
    return;
  }
  const recording::RecorderStatus recorder = context_.session.recorderStatus();
  if (recorder.state != recording::RecorderState::recording) {
    context_.tell_about(kTrial, Severity::warning, tr("No trial was begun: nothing is being recorded. Ctrl+R starts."));
    return;
  }
  if (under_way_ && recorder.path != recording_) under_way_ = false;  // it ended with its recording
  if (under_way_) {
    if (!mark(recording::NoteKind::trial_end, trials_[begun_ - 1])) return;
    under_way_ = false;
  }
  if (begun_ == trials_.size()) {
    context_.tell_about(kTrial, Severity::information, tr("All %1 trials are done.").arg(trials_.size()));
    return;
  }
  const experiment::Trial& trial = trials_[begun_];
  if (!mark(recording::NoteKind::trial_start, trial)) return;
  ++begun_;
  under_way_ = true;
  recording_ = recorder.path;
  context_.tell_about(
      kTrial, Severity::information,
      tr("Trial %1 of %2: %3.").arg(trial.number).arg(trials_.size()).arg(QString::fromStdString(trial.condition)));
}

}  // namespace fyd::console
