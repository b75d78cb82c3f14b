// Brings a session's news to the widgets: telemetry about 60 times a second, pictures as they come,
// parts, readiness and notices a few times a second.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <vector>

#include "app/console/session.h"
#include "widgets/link_panel.h"
#include "widgets/part_list.h"
#include "widgets/readiness_list.h"

namespace fyd::console {

class SessionFeed : public QObject {
  Q_OBJECT
 public:
  explicit SessionFeed(Session& session, QObject* parent = nullptr);
  void start();
  /// One round of everything at once, without waiting for a timer.
  void pump();
  /// The session began anew: nothing of the former one is compared with it.
  void restart();

 signals:
  void telemetry(std::span<const pipeline::TelemetrySample> samples);
  void silent(bool silent);  ///< the haptic loop has said nothing for half a second
  void picture(const fyd::station::CameraView& view);
  void parts(const std::vector<widgets::PartView>& parts);
  void link(const widgets::LinkView& view);
  void recorder(const fyd::session::RecorderStatus& status);
  void cameraMissing(const QString& why);
  void readiness(const std::vector<widgets::ReadinessRow>& rows);
  void notice(const fyd::station::Notice& notice);
  void scene(const std::shared_ptr<fyd::scene::SceneStage>& stage);  ///< where the robot stands; null: there is none

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
};

}  // namespace fyd::console
