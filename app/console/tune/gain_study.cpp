#include "app/console/tune/gain_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"

namespace fyd::console {
namespace {

/// A gain that a proposal replaces: parameter id and member.
struct TunedGain {
  const char* id;
  double control::ControlParameters::*field;
};
constexpr std::array kTunedGains = {
    TunedGain{"control.kp", &control::ControlParameters::kp},
    TunedGain{"control.ki", &control::ControlParameters::ki_per_s},
    TunedGain{"control.kd", &control::ControlParameters::kd_s},
    TunedGain{"control.measurement_lag_s", &control::ControlParameters::measurement_lag_s},
    TunedGain{"control.measurement_delay_s", &control::ControlParameters::measurement_delay_s},
    TunedGain{"control.noise_correlation_s", &control::ControlParameters::noise_correlation_s},
};

/// The control parameters with the model's values, saved or current.
control::ControlParameters withValues(control::ControlParameters parameters, const widgets::TuningModel& model,
                                      double widgets::TunedParameter::*which) {
  for (const Parameter& parameter : bindParameters(parameters)) {
    if (const widgets::TunedParameter* tuned = model.find(parameter.id)) parameter.set(tuned->*which);
  }
  return parameters;
}

}  // namespace

GainStudy::GainStudy(const PageContext& context, widgets::TuningResponse* response, widgets::TuningProposal* proposal,
                     QObject* parent)
    : QObject(parent), context_(context), model_(context.tuning.model()), response_(response), proposal_(proposal) {
  using widgets::TuningResponse;
  offerSources();
  connect(&context_.feed, &SessionFeed::restarted, this, &GainStudy::beginAnew);
  connect(&study_, &LoopStudy::respondingChanged, response_, &TuningResponse::setBusy);
  connect(&study_, &LoopStudy::responses, this,
          [this](const widgets::ResponseView& current, const widgets::ResponseView& saved) {
            response_->setResponse(TuningResponse::current, current);
            response_->setResponse(TuningResponse::saved, saved);
          });
  connectProposal();
}

void GainStudy::offerSources() {
  sources_.clear();
  if (context_.session.simulated()) sources_.push_back(TuneSource::simulation);
  sources_.push_back(TuneSource::session);
  QStringList names;
  for (const TuneSource source : sources_) {
    names << (source == TuneSource::simulation ? tr("From the simulated touchpad, 12 s of virtual time")
                                               : tr("From the last minute of this session"));
  }
  proposal_->setSources(names);
}

/// What was found in the former session is not proposed for another: its touchpad or its calibration is another one.
void GainStudy::beginAnew() {
  const bool was_tuning = study_.tuning();
  study_.cancel();
  study_.forget();
  context_.tuning.judge().forget();
  offerSources();
  discardProposal(was_tuning ? tr("Cancelled; nothing was changed.") : widgets::TuningProposal::purpose());
}

void GainStudy::connectProposal() {
  using widgets::TuningResponse;
  connect(&study_, &LoopStudy::tuningChanged, proposal_, &widgets::TuningProposal::showRunning);
  connect(&study_, &LoopStudy::progressed, proposal_, &widgets::TuningProposal::showProgress);
  connect(&study_, &LoopStudy::proposed, this, &GainStudy::showProposal);
  connect(&study_, &LoopStudy::failed, proposal_, &widgets::TuningProposal::clear);
  connect(proposal_, &widgets::TuningProposal::startAsked, this, [this](int source) {
    withdrawQuestion();
    response_->clearResponse(TuningResponse::proposed);
    study_.autoTune(sources_.at(static_cast<std::size_t>(source)), context_.session.currentProfile());
  });
  connect(proposal_, &widgets::TuningProposal::cancelAsked, this, [this] {
    study_.cancel();
    proposal_->clear(tr("Cancelled; nothing was changed."));
  });
  connect(proposal_, &widgets::TuningProposal::acceptAsked, this, &GainStudy::acceptProposal);
  // Queued: the model drops its question before it applies what was asked about.
  connect(&model_, &widgets::TuningModel::questionChanged, this, &GainStudy::hearAnswer, Qt::QueuedConnection);
  connect(proposal_, &widgets::TuningProposal::discardAsked, this,
          [this] { discardProposal(tr("Discarded; nothing was changed.")); });
}

void GainStudy::studyValues() {
  const control::ControlParameters base = context_.session.currentProfile().step.control;
  LoopJudge& judge = context_.tuning.judge();
  judge.setCloth(study_.proposal() ? std::optional(study_.proposal()->cloth) : std::nullopt);
  const std::optional<control::LoopTiming> timing = judge.timing();
  studied_with_ = timing;
  study_.setValues(withValues(base, model_, &widgets::TunedParameter::value),
                   withValues(base, model_, &widgets::TunedParameter::saved), timing.value_or(control::LoopTiming{}));
  QString words = study_.proposal() ? tr("On the cloth that auto-tune identified, 30 % softer than its law says.")
                                    : tr("On a cloth 30 % softer than its law says, with the sensors that the profile "
                                         "describes. Auto-tune finds out more.");
  words += QLatin1Char(' ') + (timing ? tr("The motors' angle is %1 old when it is used.")
                                            .arg(widgets::quantityText(1000 * timing->motors_age_s, 1, tr("ms")))
                                      : tr("The motors have not answered yet: their angle is taken to be 2 ms old, and "
                                           "only what no touchpad bears is asked about."));
  response_->setPlotBackground(words);
}

void GainStudy::followTouchpad() {
  constexpr double kNews_s = 0.2e-3;  // below it neither words nor courses change visibly
  const std::optional<control::LoopTiming> timing = context_.tuning.judge().timing();
  const bool same = timing && studied_with_ ? std::abs(timing->motors_age_s - studied_with_->motors_age_s) < kNews_s
                                            : timing.has_value() == studied_with_.has_value();
  if (!same) studyValues();
}

void GainStudy::showProposal(const widgets::ResponseView& response) {
  const control::TuneProposal& found = *study_.proposal();
  std::vector<widgets::ProposalLine> lines;
  for (const TunedGain& gain : kTunedGains) {
    const widgets::TunedParameter* tuned = std::as_const(model_).find(gain.id);
    if (tuned == nullptr) continue;
    const std::string_view unit = tuned->info.info.unit;
    lines.push_back({.id = QLatin1String(gain.id),
                     .unit = unit == "1" ? QString() : QString::fromStdString(std::string(unit)),
                     .present = tuned->value,
                     .proposed = found.proposed.*gain.field});
  }
  const control::IdentifiedCloth& cloth = found.cloth;
  proposal_->showProposal(
      lines,
      tr("Cloth %1 times its law's stiffness; sensors %2 s late with a lag of %3 s, noise %4 %. The courses above "
         "show what the proposal would do. Nothing is changed yet.")
          .arg(widgets::numberText(cloth.scale, 2), widgets::numberText(cloth.delay_s, 2),
               widgets::numberText(cloth.lag_s, 2), widgets::numberText(100 * cloth.residual_rms_relative, 1)));
  response_->setResponse(widgets::TuningResponse::proposed, response);
  studyValues();
}

void GainStudy::acceptProposal() {
  if (!study_.proposal()) return;
  std::vector<widgets::Setting> settings;
  settings.reserve(kTunedGains.size());
  for (const TunedGain& gain : kTunedGains) {
    settings.push_back({.id = gain.id, .value = study_.proposal()->proposed.*gain.field});
  }
  const int before = question();
  if (const auto ok = model_.changeAll(tr("auto-tune"), settings); !ok) {
    context_.tell(widgets::Severity::warning,
                  tr("The proposal was not taken: %1").arg(widgets::coreText(ok.error().message)));
    return;
  }
  asked_ = question() == before ? 0 : question();
  if (asked_ == 0) finishAccepted();  // otherwise the proposal stays until it is answered
}

int GainStudy::question() const { return model_.question() ? model_.question()->number : 0; }

void GainStudy::hearAnswer() {
  if (asked_ == 0 || question() == asked_) return;
  asked_ = 0;
  const bool applied = study_.proposal() && std::ranges::all_of(kTunedGains, [this](const TunedGain& gain) {
                         const widgets::TunedParameter* tuned = std::as_const(model_).find(gain.id);
                         return tuned != nullptr && tuned->value == study_.proposal()->proposed.*gain.field;
                       });
  if (applied) finishAccepted();
}

void GainStudy::finishAccepted() {
  response_->clearResponse(widgets::TuningResponse::proposed);
  proposal_->clear(tr("Accepted: the proposed values are in use. Undo takes them back, Save profile keeps them."));
  studyValues();
}

void GainStudy::withdrawQuestion() {
  const int asked = std::exchange(asked_, 0);
  if (asked != 0 && question() == asked) model_.leaveAsItIs();
}

void GainStudy::discardProposal(const QString& words) {
  withdrawQuestion();
  study_.discard();
  response_->clearResponse(widgets::TuningResponse::proposed);
  proposal_->clear(words);
  studyValues();
}

}  // namespace fyd::console
