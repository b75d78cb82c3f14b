#include "app/console/shell/session_feed.h"

#include "app/console/shell/views.h"
#include "widgets/basics/core_text.h"

namespace fyd::console {
namespace {

constexpr int kFast_ms = 16;
constexpr int kSlow_ms = 200;
constexpr std::size_t kMostAtOnce = 4096;  // 4 s of backlog; the rest comes the next time
constexpr qint64 kSilence_ms = 500;

}  // namespace

SessionFeed::SessionFeed(Session& session, QObject* parent)
    : QObject(parent), session_(session), samples_(kMostAtOnce) {
  fast_.setTimerType(Qt::PreciseTimer);
  connect(&fast_, &QTimer::timeout, this, [this] {
    session_.windowAlive();
    drainTelemetry();
    lookAtCamera();
    emit scene(session_.scene());
  });
  connect(&slow_, &QTimer::timeout, this, [this] {
    drainNotices();
    lookAtParts();
  });
}

void SessionFeed::start() {
  since_sample_.start();
  since_missed_.start();
  fast_.start(kFast_ms);
  slow_.start(kSlow_ms);
}

void SessionFeed::pump() {
  drainTelemetry();
  lookAtCamera();
  emit scene(session_.scene());
  drainNotices();
  lookAtParts();
}

void SessionFeed::restart() {
  since_sample_.start();
  since_missed_.start();
  last_picture_ = 0;
  last_missed_ = 0;
  missed_now_ = 0.0;
  emit restarted();
}

void SessionFeed::drainTelemetry() {
  const std::size_t taken = session_.takeTelemetry(samples_);
  if (taken > 0) {
    since_sample_.start();
    emit telemetry(std::span(samples_).first(taken));
  }
  emit silent(since_sample_.isValid() && since_sample_.elapsed() > kSilence_ms);
}

void SessionFeed::lookAtCamera() {
  const station::CameraView view = session_.cameraView();
  if (view.number == last_picture_) return;
  last_picture_ = view.number;
  emit picture(view);
}

void SessionFeed::lookAtParts() {
  const station::StationStatus status = session_.status();
  constexpr qint64 kSecond_ms = 1000;
  if (since_missed_.isValid() && since_missed_.elapsed() >= kSecond_ms) {
    const std::uint64_t missed = status.loop.missed_cycles;  // fewer than before: another session, or a closed one
    missed_now_ = missed > last_missed_ ? static_cast<double>(missed - last_missed_) : 0.0;
    last_missed_ = missed;
    since_missed_.start();
  }
  const bool open = session_.isOpen();
  emit parts(open ? toParts(status, missed_now_, session_.telemetryLost()) : std::vector<widgets::PartView>{});
  emit link(toLink(status));
  emit recorder(session_.recorderStatus());
  emit readiness(toReadiness(session_.readiness(), session_.devices(), session_.connection()));
  if (!open) emit cameraMissing(closedText(connecting_));
  for (const device::DeviceReport& part : status.parts) {
    if (part.part != device::Part::camera || part.ok) continue;
    emit cameraMissing(tr("Looked for: %1\n%2\n\nIt is tried again by itself. Another camera is chosen in Devices.")
                           .arg(widgets::coreText(part.description), widgets::coreText(part.problem)));
  }
}

void SessionFeed::drainNotices() {
  for (const station::Notice& each : session_.takeNotices()) emit notice(each);
}

}  // namespace fyd::console
