#include "app/console/calibrate/calibrate_records.h"

#include <QBuffer>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "app/console/shell/calibration_ages.h"
#include "core/station/profile/calibrated_values.h"
#include "core/station/profile/calibration_file.h"
#include "core/station/profile/calibration_report.h"
#include "core/station/profile/replace_file.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {

using widgets::Severity;

namespace {

using widgets::tr;
QString words(const std::string& text) { return QString::fromStdString(text); }

/// What the files hold for the session's touchpad; the session's profile, when there is none yet.
Result<station::Profile> profileToWrite(const std::string& path, const station::Profile& session, bool exists) {
  if (!exists) return session;
  auto loaded = station::loadProfileFor(path, session.calibrated_on);
  if (!loaded) return tl::unexpected(loaded.error());
  return std::move(loaded->profile);
}

/// The sensor's offset in force may be a tare that is not saved yet. The file gets it, so that the record notes what
/// the session goes on with.
void keepOffsetInForce(station::Profile& file, const station::Profile& session, int sensor) {
  ParameterList& to = file.step.sensing.indentation.ir_offset_mm;
  const ParameterList& from = session.step.sensing.indentation.ir_offset_mm;
  const auto place = static_cast<std::size_t>(sensor - 1);
  if (sensor > 0 && place < to.size() && place < from.size()) to[place] = from[place];
}

/// "lab.ir-2.2026-11-21T201500Z.pdf": a file about one calibration, beside the profile.
QString fileBeside(const QString& profile, const std::string& procedure, int sensor, const std::string& when,
                   const char* ending) {
  const QFileInfo info(profile);
  QString part = words(procedure);
  if (sensor > 0) part += QStringLiteral("-%1").arg(sensor);
  return info.dir().filePath(
      QStringLiteral("%1.%2.%3.%4")
          .arg(info.completeBaseName(), part, words(when).remove(QLatin1Char(':')), QLatin1String(ending)));
}

const QString kAccepting = QStringLiteral("accepting a calibration");  // cause of notices: the newest outcome counts

/// @return an error when the file cannot be written; then there is none
Result<void> writePicture(const QImage& picture, const QString& path) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG")) {
    return fail("{}: no picture can be made", path.toStdString());
  }
  return station::replaceFile(path.toStdString(), bytes.toStdString());
}

}  // namespace

Acceptance acceptCalibration(const PageContext& context, const calibration::CalibrationResult& result, int sensor,
                             const AcceptedWords& said) {
  const QString path = context.tuning.profilePath();
  const bool exists = QFileInfo::exists(path);
  QDir().mkpath(QFileInfo(path).absolutePath());
  if (const QString why = context.tuning.claim().whyNot(); !why.isEmpty()) {
    context.tell_about(kAccepting, Severity::error,
                       tr("Not accepted, the old values stay. %1").arg(why + QLatin1Char('.')));
    return Acceptance::refused;
  }
  const station::Profile in_force = context.session.currentProfile();
  auto profile = profileToWrite(path.toStdString(), in_force, exists);
  if (!profile) {
    context.tell_about(kAccepting, Severity::error,
                       tr("Not accepted, the old values stay. %1").arg(widgets::coreText(profile.error().message)));
    return Acceptance::refused;
  }
  keepOffsetInForce(*profile, in_force, sensor);
  const std::string when = nowUtc();
  const QString picture = said.picture.isNull() ? QString() : fileBeside(path, result.procedure, sensor, when, "png");
  if (!picture.isEmpty()) {
    if (const auto drawn = writePicture(said.picture, picture); !drawn) {
      context.tell_about(kAccepting, Severity::error,
                         tr("Not accepted, the old values stay. %1").arg(widgets::coreText(drawn.error().message)));
      return Acceptance::refused;
    }
  }
  const auto record = station::saveCalibration(result,
                                               {.sensor = sensor,
                                                .who = said.who,
                                                .when = when,
                                                .conditions = said.conditions,
                                                .simulated = said.simulated,
                                                .picture = QFileInfo(picture).fileName().toStdString()},
                                               *profile, path.toStdString());
  if (!record) {
    if (!picture.isEmpty()) QFile::remove(picture);
    context.tell_about(kAccepting, Severity::error,
                       tr("Not accepted, the old values stay. %1").arg(widgets::coreText(record.error().message)));
    return Acceptance::refused;
  }

  context.tuning.claim().written();
  const QString file = QDir::toNativeSeparators(path);
  if (result.changes.empty()) {
    context.tell_about(kAccepting, Severity::information,
                       tr("Accepted and noted beside %1. It changes no value.").arg(file));
    return Acceptance::in_force;
  }

  // The running step cannot change these values, so a new session is begun with them.
  context.feed.pump();
  Session& session = context.session;
  station::Profile current = session.currentProfile();
  const bool changed = calibration::applyChanges(bindParameters(current), result.changes).has_value();
  const auto begun = changed ? session.beginAnew(current) : Result<void>(fail("the values do not fit this session"));
  context.feed.restart();
  context.tuning.restart(current.calibrated_on);
  if (!exists) context.tuning.model().markSaved();
  for (const calibration::ParameterChange& change : result.changes) context.tuning.model().markSaved(change.id);
  if (context.tuning.targetIsByHand()) context.tuning.targetByHand();
  if (begun) {
    context.tell_about(kAccepting, Severity::information,
                       tr("Accepted and written to %1. The session has begun anew with it; motors "
                          "stay off until you arm.")
                           .arg(file));
  } else if (!session.isOpen()) {  // nor could the former one be had again
    context.tell_about(kAccepting, Severity::error,
                       tr("Accepted and written to %1, but the session is closed: %2. Choose devices under Devices.")
                           .arg(file, widgets::coreText(begun.error().message)));
  } else {
    context.tell_about(kAccepting, Severity::error,
                       tr("Accepted and written to %1, but the session goes on without it: %2. Start the "
                          "window again to use it.")
                           .arg(file, widgets::coreText(begun.error().message)));
  }
  return begun ? Acceptance::in_force : Acceptance::written;
}

QString lastWhoCalibrated(const PageContext& context) {
  const auto records = station::loadCalibrationRecords(context.tuning.profilePath().toStdString());
  return records && !records->empty() ? words(records->back().who) : QString();
}

QString writeCalibrationReport(const PageContext& context, const std::string& procedure, int sensor) {
  const QString profile = context.tuning.profilePath();
  const auto records = station::loadCalibrationRecords(profile.toStdString());
  if (!records) return widgets::coreText(records.error().message);
  const auto own = station::recordsFor(*records, context.session.currentProfile().calibrated_on);
  const auto pair = station::newestOf(own, procedure, sensor);
  if (pair.newest == nullptr) return tr("this part was never calibrated: accept a calibration first");
  const QString path = fileBeside(profile, procedure, sensor, pair.newest->when, "pdf");
  // The same record gives the same file: writing it again replaces it.
  const auto written = station::writeCalibrationReport({.record = *pair.newest, .accepted = true, .outliers = {}},
                                                       pair.former, profile.toStdString(), path.toStdString(), true);
  if (!written) return widgets::coreText(written.error().message);
  context.written(tr("Report written to %1.").arg(QDir::toNativeSeparators(path)), path);
  return {};
}

}  // namespace fyd::console
