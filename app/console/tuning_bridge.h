// Between the tuning panel and the session: applies the operator's changes, shows those that come from elsewhere,
// saves the profile.
#pragma once

#include <QHash>
#include <QObject>
#include <QString>

#include "app/console/session.h"
#include "widgets/notice_stack.h"
#include "widgets/tuning_model.h"

namespace fyd::console {

class TuningBridge : public QObject {
  Q_OBJECT
 public:
  TuningBridge(Session& session, QString profile_path, QObject* parent = nullptr);
  [[nodiscard]] widgets::TuningModel& model() { return model_; }
  /// Where "Save profile" writes.
  [[nodiscard]] const QString& profilePath() const { return profile_path_; }

  /// A parameter event of the step.
  void hear(const pipeline::Event& event);
  void targetByHand();
  void targetFromRobot();
  /// The session itself starts with this source of the target: shown, not asked for.
  void startWithTarget(bool by_hand);
  [[nodiscard]] bool targetIsByHand() const { return by_hand_; }
  void save();
  /// The session began anew: no echo of the former one comes any more, and its values are shown.
  void restart();

 signals:
  void targetShown(bool by_hand);
  void told(fyd::widgets::Severity severity, const QString& text);

 private:
  void apply(const QString& id, double value);

  Session& session_;
  QString profile_path_;
  widgets::TuningModel model_;
  bool by_hand_ = false;
  QHash<QString, int> under_way_;  ///< own changes whose echo has not come back
  std::vector<QString> names_;     ///< by the step's index
};

}  // namespace fyd::console
