// Between the tuning panels and the session: applies the operator's changes, marks them confirmed when the step says
// that it uses them, shows those that come from elsewhere, saves the profile.
#pragma once

#include <QElapsedTimer>
#include <QHash>
#include <QObject>
#include <QString>
#include <QTimer>

#include "app/console/session.h"
#include "app/console/tuning_presets.h"
#include "widgets/notice_stack.h"
#include "widgets/tuning_model.h"

namespace fyd::console {

class TuningBridge : public QObject {
  Q_OBJECT
 public:
  TuningBridge(Session& session, QString profile_path, QObject* parent = nullptr);
  [[nodiscard]] widgets::TuningModel& model() { return model_; }
  [[nodiscard]] TuningPresets& presets() { return presets_; }
  /// Where "Save profile" writes.
  [[nodiscard]] const QString& profilePath() const { return profile_path_; }

  /// A parameter event of the step.
  void hear(const pipeline::Event& event);
  void targetByHand();
  void targetFromRobot();
  /// The session itself starts with this source of the target: shown, not asked for.
  void startWithTarget(bool by_hand);
  [[nodiscard]] bool targetIsByHand() const { return by_hand_; }
  /// The current values; when the saved ones are felt, it goes back to the current ones first.
  void save();
  /// The session began anew: no echo of the former one comes any more, and its values are shown.
  void restart();

  /// A change that the step has not answered for this long is called silent.
  static constexpr int kAnswer_ms = 2000;

 signals:
  void targetShown(bool by_hand);
  void told(fyd::widgets::Severity severity, const QString& text);

 private:
  struct UnderWay {
    std::vector<double> values;  ///< asked for and not answered, oldest first
    QElapsedTimer since;         ///< the newest was asked for
  };

  void apply(const QString& id, double value);
  /// Whether `value` answers an own change; that one and what was asked before it are settled.
  bool settle(const QString& id, double value);
  void lookForSilence();

  Session& session_;
  QString profile_path_;
  widgets::TuningModel model_;
  TuningPresets presets_;
  bool by_hand_ = false;
  QHash<QString, UnderWay> under_way_;
  QTimer silence_;
  std::vector<QString> names_;  ///< by the step's index
};

}  // namespace fyd::console
