// The place "Review" with a recording made here, whose numbers are known, and its hands.
#pragma once

#include <QCryptographicHash>

#include "app/console/review/review_page.h"
#include "core/recording/writer/recording_writer.h"
#include "core/sensing/tare.h"
#include "tests/widgets/scripted_session.h"

namespace fyd::tests {

inline constexpr std::uint64_t kRows = 6000;
inline constexpr std::uint64_t kPress = 2000, kRelease = 4000, kSpike = 5321;

inline recording::StepRecord row(std::uint64_t i, std::uint64_t press) {
  recording::StepRecord record;
  const Instant now = Instant(std::chrono::seconds(100)) + std::chrono::milliseconds(i);
  record.inputs.now = record.telemetry.now = now;
  record.telemetry.step = i + 1;
  const bool contact = i >= press && i < press + (kRelease - kPress);
  record.telemetry.contact = contact;
  record.telemetry.force_N = contact ? 2.0 : 0.001 * static_cast<double>(i);  // a slope of 1 N/s before and after
  if (i == kSpike) record.telemetry.force_N = 7.0;
  if (contact) {  // a picture each 33 ms, the finger goes right at 10 mm/s
    record.telemetry.finger_age_ms = static_cast<double>(i % 33);
    record.telemetry.finger_x_mm = 0.01 * (static_cast<double>(i - i % 33) - static_cast<double>(press)) - 10.0;
    record.telemetry.finger_y_mm = 5.0;
  }
  record.telemetry.indentation_mm = contact ? 4.0 : 0.0;
  record.telemetry.stiffness_observable = contact;
  record.telemetry.stiffness_N_per_mm = contact ? 0.5 : pipeline::kNone;
  record.telemetry.target_N_per_mm = record.telemetry.reachable_target_N_per_mm = 0.5;
  return record;
}

/// What a recorder leaves: `name`, or `name`.partial when it was killed.
inline QString makeRecording(const QTemporaryDir& folder, const QString& name, std::uint64_t press = kPress,
                             bool killed = false, bool tared = false) {
  QString path = folder.filePath(name);
  recording::RecordingHeader header{
      .id = QCryptographicHash::hash(name.toUtf8(), QCryptographicHash::Md5).toHex().toStdString(),
      .started_utc = "2026-11-21T10:00:00.000Z",
      .started = Instant(std::chrono::seconds(100)),
      .operator_name = "M. Muster",
      .subject = "S07"};
  auto writer = recording::RecordingWriter::create(path.toStdString(), header);
  if (!writer) qFatal("%s", writer.error().text().c_str());
  bool good = true;
  for (std::uint64_t i = 0; i < kRows; ++i) {
    recording::StepRecord record = row(i, press);
    const pipeline::Event touched{.kind = pipeline::EventKind::tare_failed,
                                  .value = static_cast<double>(sensing::TareState::touched)};
    if (tared && i == kSpike) good = good && record.events.push(touched);
    good = good && (*writer)->append(record).has_value();
  }
  if (!killed) good = good && (*writer)->close().has_value();
  if (!good) qFatal("the recording could not be written");
  return killed ? path + QStringLiteral(".partial") : path;
}

struct ReviewFixture : Fixture {
  ReviewFixture() {
    qputenv("XDG_DATA_HOME", folder.filePath(QStringLiteral("data")).toUtf8());
    path = makeRecording(folder, QStringLiteral("session.h5"));
    QTest::keyClick(window.get(), Qt::Key_3, Qt::ControlModifier);
    page = qobject_cast<console::ReviewPage*>(window->frame()->page(QStringLiteral("review")));
  }
  /// As an operator does it.
  void openByPath() { openByPath(path); }
  void openByPath(const QString& file) {
    page->list()->path()->setFocus();
    page->list()->path()->setText(file);
    QTest::keyClick(page->list()->path(), Qt::Key_Return);
  }
  void key(Qt::Key key, Qt::KeyboardModifiers with = {}) {
    page->curves()->setFocus();
    QTest::keyClick(window.get(), key, with);
  }
  [[nodiscard]] QString told() const {
    const int count = window->notices()->count();
    return count == 0 ? QString() : window->notices()->text(count - 1);
  }
  QString path;
  console::ReviewPage* page = nullptr;
};

}  // namespace fyd::tests
