// Between the tuning panels and the session: applies the operator's changes, marks them confirmed when the step says
// that it uses them, shows those that come from elsewhere, saves the profile.
#pragma once

#include <QElapsedTimer>
#include <QHash>
#include <QObject>
#include <QString>
#include <QTimer>

#include "app/console/shell/loop_judge.h"
#include "app/console/shell/session.h"
#include "app/console/shell/tuning_presets.h"
#include "widgets/basics/file_claim.h"
#include "widgets/status/notice_stack.h"
#include "widgets/tuning/tuning_model.h"

namespace fyd::console {

inline constexpr const char* kHandTarget = "pipeline.hand_target_N_per_mm";  ///< the target while it is set by hand

class TuningBridge : public QObject {
  Q_OBJECT
 public:
  TuningBridge(Session& session, QString profile_path, QObject* parent = nullptr);
  [[nodiscard]] widgets::TuningModel& model() { return model_; }
  [[nodiscard]] TuningPresets& presets() { return presets_; }
  [[nodiscard]] LoopJudge& judge() { return judge_; }
  /// Where "Save profile" writes.
  [[nodiscard]] const QString& profilePath() const { return profile_path_; }
  /// Asked before, and told after, each writing of the profile.
  [[nodiscard]] widgets::FileClaim& claim() { return claim_; }

  /// Handles a parameter event of the step.
  void hear(const pipeline::Event& event);
  void targetByHand();
  void targetFromRobot();
  /// Whether there is no session because another is being opened.
  void setConnecting(bool connecting) { connecting_ = connecting; }
  /// Shows the source of the target with which the session starts; requests nothing.
  void startWithTarget(bool by_hand);
  [[nodiscard]] bool targetIsByHand() const { return by_hand_; }
  /// The current values; when the saved ones are felt, it goes back to the current ones first. While a question about
  /// that waits, nothing is saved.
  void save();
  /// This window itself has moved the profile's file away: the next save finds none, and need not ask.
  void profileSetAside() { claim_.written(); }
  /// Which parameters differ from the profile, as a phrase; empty: none.
  [[nodiscard]] QString unsaved() const;
  /// To be called when the session began anew: pending answers of the former one are dropped, and its values are shown.
  /// Another touchpad's calibrated values are those of its own file: none of the former one's is gone back to.
  /// @param former the touchpad of the session before, as in touchpad_name.h
  void restart(std::string_view former);

  /// A change that the step has not answered for this long is called silent.
  static constexpr int kAnswer_ms = 2000;

 signals:
  void targetShown(bool by_hand);
  void told(fyd::widgets::Severity severity, const QString& text);
  void refused(const QString& why, const QString& parameter);

 private:
  struct UnderWay {
    std::vector<double> values;  ///< asked for and not answered, oldest first
    QElapsedTimer since;         ///< the newest was asked for
  };

  void apply(const QString& id, double value);
  void ask(const pipeline::OperatorCommand& command);
  /// Whether `value` answers a change made here; that change and earlier ones are then settled.
  bool settle(const QString& id, double value);
  void lookForSilence();

  Session& session_;
  QString profile_path_;
  widgets::FileClaim claim_;
  widgets::TuningModel model_;
  TuningPresets presets_;
  LoopJudge judge_;
  bool by_hand_ = false;
  bool connecting_ = false;
  QHash<QString, UnderWay> under_way_;
  QTimer silence_;
  std::vector<QString> names_;  ///< by the step's index
};

}  // namespace fyd::console
