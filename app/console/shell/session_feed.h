// Polls the session and passes its data to the widgets: telemetry about 60 times a second, pictures as they come,
// parts, readiness and notices a few times a second.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <vector>

#include "app/console/shell/session.h"
#include "widgets/devices/link_panel.h"
#include "widgets/status/part_list.h"
#include "widgets/status/readiness_list.h"

namespace fyd::console {

class SessionFeed : public QObject {
  Q_OBJECT
 public:
  explicit SessionFeed(Session& session, QObject* parent = nullptr);
  void start();
  /// One round of everything at once, without waiting for a timer.
  void pump();
  /// Whether there is no session because another is being opened.
  void setConnecting(bool connecting) { connecting_ = connecting; }
  /// To be called when the session began anew: drops the state of the former one.
  void restart();

 signals:
  void restarted();  ///< what comes next is another session's
  void telemetry(std::span<const pipeline::TelemetrySample> samples);
  void silent(bool silent);  ///< no telemetry from the haptic loop for half a second
  void picture(const fyd::station::CameraView& view);
  void parts(const std::vector<widgets::PartView>& parts);  ///< none of a closed session
  void link(const widgets::LinkView& view);
  void recorder(const recording::RecorderStatus& status);
  void cameraMissing(const QString& why);
  void readiness(const std::vector<widgets::ReadinessRow>& rows);
  void notice(const fyd::station::Notice& notice);
  void scene(const std::shared_ptr<fyd::scene::SceneStage>& stage);  ///< the scene in the robot's place; null: none

 private:
  void drainTelemetry();
  void lookAtCamera();
  void lookAtParts();
  void drainNotices();

  Session& session_;
  std::vector<pipeline::TelemetrySample> samples_;
  QTimer fast_;
  QTimer slow_;
  QElapsedTimer since_sample_;
  std::uint64_t last_picture_ = 0;
  std::uint64_t last_missed_ = 0;
  QElapsedTimer since_missed_;
  double missed_now_ = 0.0;
  bool connecting_ = false;
};

}  // namespace fyd::console
