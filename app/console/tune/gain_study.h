// The gains of the place "Tune": the step response of the present and the saved ones, and auto-tune's proposal.
#pragma once

#include <QObject>
#include <vector>

#include "app/console/shell/page.h"
#include "app/console/tune/loop_study.h"
#include "widgets/tuning/tuning_proposal.h"
#include "widgets/tuning/tuning_response.h"

namespace fyd::console {

class GainStudy : public QObject {
  Q_OBJECT
 public:
  /// @param response, proposal what shows it; they outlive it
  GainStudy(const PageContext& context, widgets::TuningResponse* response, widgets::TuningProposal* proposal,
            QObject* parent);

  /// Computes the responses of the values as they are now.
  void studyValues();
  /// The same when the touchpad's lateness has become known, or another one. To be called now and then while shown.
  void followTouchpad();
  void listen(std::span<const pipeline::TelemetrySample> samples) { study_.listen(samples); }
  [[nodiscard]] LoopStudy& study() { return study_; }

 private:
  void connectProposal();
  void offerSources();
  void beginAnew();
  void showProposal(const widgets::ResponseView& response);
  void acceptProposal();
  /// The number of the model's question; 0: none stands.
  [[nodiscard]] int question() const;
  /// The question about the proposal may be answered.
  void hearAnswer();
  /// What was asked about a proposal that is no more cannot be applied.
  void withdrawQuestion();
  void finishAccepted();
  void discardProposal(const QString& words);

  PageContext context_;
  widgets::TuningModel& model_;
  widgets::TuningResponse* response_ = nullptr;
  widgets::TuningProposal* proposal_ = nullptr;
  LoopStudy study_;
  std::vector<TuneSource> sources_;
  int asked_ = 0;  ///< number of the model's question whether the accepted proposal is to be applied; 0: none
  std::optional<control::LoopTiming> studied_with_;  ///< none: the motors had not answered
};

}  // namespace fyd::console
