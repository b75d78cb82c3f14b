// The place "Tune": every live parameter, what differs from the saved profile, presets, the step response beside the
// gains, auto-tune.
#pragma once

#include <QLabel>
#include <QTabWidget>

#include "app/console/shell/page.h"
#include "app/console/tune/gain_study.h"
#include "widgets/tuning/tuning_differences.h"
#include "widgets/tuning/tuning_foot.h"
#include "widgets/tuning/tuning_list.h"
#include "widgets/tuning/tuning_preset_list.h"
#include "widgets/tuning/tuning_readback.h"

namespace fyd::console {

class TunePage : public Page {
  Q_OBJECT
 public:
  explicit TunePage(const PageContext& context, QWidget* parent = nullptr);
  void addCommands(PlaceCommands& commands) override;
  void enter() override;
  void leave() override;

  [[nodiscard]] widgets::TuningList* list() const { return list_; }
  [[nodiscard]] widgets::TuningCompare* compare() const { return foot_->compare(); }
  [[nodiscard]] widgets::TuningFoot* foot() const { return foot_; }
  [[nodiscard]] widgets::TuningResponse* response() const { return response_; }
  [[nodiscard]] widgets::TuningDifferences* differences() const { return differences_; }
  [[nodiscard]] widgets::TuningPresetList* presets() const { return presets_; }
  [[nodiscard]] widgets::TuningProposal* proposal() const { return proposal_; }
  [[nodiscard]] widgets::TuningReadback* readback() const { return readback_; }
  [[nodiscard]] QTabWidget* tabs() const { return tabs_; }
  [[nodiscard]] LoopStudy& study() { return gains_->study(); }
  [[nodiscard]] widgets::TuningModel& model() { return model_; }

 private:
  void build();
  void connectModel();
  void connectPresets();
  void showTaken(const Result<void>& taken);
  void findParameter();
  void readBack();
  void showLive(std::span<const pipeline::TelemetrySample> samples);

  PageContext context_;
  widgets::TuningModel& model_;
  widgets::TuningList* list_ = nullptr;
  widgets::TuningResponse* response_ = nullptr;
  widgets::TuningDifferences* differences_ = nullptr;
  widgets::TuningPresetList* presets_ = nullptr;
  widgets::TuningProposal* proposal_ = nullptr;
  widgets::TuningReadback* readback_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  QLabel* live_ = nullptr;
  widgets::TuningFoot* foot_ = nullptr;
  GainStudy* gains_ = nullptr;
  QTimer reading_;
  pipeline::TelemetrySample newest_;
  bool shown_ = false;
};

}  // namespace fyd::console
