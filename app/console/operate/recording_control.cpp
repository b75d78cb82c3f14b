#include "app/console/operate/recording_control.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include "core/catalogue/catalogue.h"
#include "core/catalogue/catalogue_delivery.h"
#include "widgets/basics/core_text.h"
#include "widgets/devices/device_text.h"

namespace fyd::console {

using recording::RecorderState;
using widgets::RecordingView;
using widgets::Severity;

namespace {

// Causes of notices. What is recorded, and what is said of its marks, is over when the file is closed.
const QString kRecording = QStringLiteral("recording");
const QString kMark = QStringLiteral("recording mark");

QString text(const std::string& words) { return QString::fromStdString(words); }

RecordingView toView(const recording::RecorderStatus& status) {
  RecordingView view{.file = text(status.path),
                     .problem = widgets::deviceWord(status.problem),
                     .seconds = status.seconds,
                     .bytes = status.bytes,
                     .minutes_left = status.minutes_left,
                     .lost = status.lost};
  if (status.state == RecorderState::recording) view.state = RecordingView::State::recording;
  if (status.state == RecorderState::failed) view.state = RecordingView::State::failed;
  return view;
}

}  // namespace

RecordingControl::RecordingControl(const PageContext& context, QString memory, QWidget* window)
    : QObject(window),
      context_(context),
      memory_(std::move(memory)),
      form_(new widgets::RecordingForm),
      dock_(new SideDock(tr("Recording"), QStringLiteral("recording_close"), tr("Close the recording's panel"),
                         std::vector<QWidget*>{form_}, window)) {
  const QSettings kept(memory_, QSettings::IniFormat);
  form_->setSuggestion(&RecordingControl::suggestedFile);
  form_->setEntries({.operator_name = kept.value(QStringLiteral("recording/operator")).toString(),
                     .subject = kept.value(QStringLiteral("recording/subject")).toString(),
                     .notes = {},
                     .tags = kept.value(QStringLiteral("recording/tags")).toStringList(),
                     .file = {}});
  connect(form_, &widgets::RecordingForm::startAsked, this, &RecordingControl::start);
  connect(form_, &widgets::RecordingForm::stopAsked, this, &RecordingControl::stop);
  connect(form_, &widgets::RecordingForm::noteAsked, this, &RecordingControl::note);
  connect(&context_.feed, &SessionFeed::recorder, this, &RecordingControl::take);
  connect(&disk_work_, &Background::runningChanged, form_, &widgets::RecordingForm::setWaiting);
  connect(&disk_work_, &Background::runningChanged, &context_.connection, &ConnectionChange::waitForRecorder);
  connect(&disk_work_, &Background::failed, this, [this](const QString& why) {
    context_.tell_about(kRecording, Severity::error, tr("Recording failed. %1").arg(why));
  });
}

QString sessionsFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QStringLiteral("/FYD sessions");
}

QString RecordingControl::suggestedFile(const QString& subject) {
  QString name = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH-mm-ss"));
  if (!subject.isEmpty()) name += QLatin1Char(' ') + subject;
  return sessionsFolder() + QLatin1Char('/') + name + QStringLiteral(".h5");
}

void RecordingControl::connectButton(widgets::RecordButton* button) {
  button_ = button;
  connect(button_, &QPushButton::clicked, this, &RecordingControl::open);
}

void RecordingControl::addCommands(CommandRegistry& commands) {
  commands.add({"session.record", "Session", QT_TRANSLATE_NOOP("Commands", "Record…"), "record", "Ctrl+R"},
               [this](bool) { open(); });
  commands.add(
      {"session.marker", "Session", QT_TRANSLATE_NOOP("Commands", "Marker into the recording"), "marker", "Ctrl+M"},
      [this](bool) { mark(); });
}

void RecordingControl::open() {
  if (!dock_->isVisible() && !recording() && form_->fileIsSuggested()) form_->suggest();  // with the present time
  dock_->show();
  dock_->raise();
  form_->focusNext();
}

void RecordingControl::start(const widgets::RecordingEntries& entries) {
  if (disk_work_.running()) return;
  recording::RecordingRequest request{.path = entries.file.toStdString(),
                                      .operator_name = entries.operator_name.toStdString(),
                                      .subject = entries.subject.toStdString(),
                                      .notes = entries.notes.toStdString(),
                                      .tags = {}};
  for (const QString& tag : entries.tags) request.tags.push_back(tag.toStdString());
  disk_work_.run([this, entries, request, session = &context_.session](const std::stop_token&) -> Background::Finish {
    const QString folder = QFileInfo(entries.file).absolutePath();
    if (!QDir().mkpath(folder)) {
      return [this, folder] {
        context_.tell_about(kRecording, Severity::error,
                            tr("Not recording. Folder %1 cannot be made: choose another file.").arg(folder));
      };
    }
    return [this, entries, outcome = session->startRecording(request)] { started(entries, outcome); };
  });
}

void RecordingControl::started(const widgets::RecordingEntries& entries, const Result<void>& outcome) {
  if (!outcome) {
    context_.tell_about(kRecording, Severity::error,
                        tr("Not recording. %1.").arg(widgets::coreText(outcome.error().message)));
    return;
  }
  const recording::RecorderStatus now = context_.session.recorderStatus();
  if (now.state != RecorderState::recording) {  // it has ended again before this came here
    const QString why = now.problem.empty() ? tr("The session has ended meanwhile") : widgets::coreText(now.problem);
    context_.tell_about(kRecording, Severity::error, tr("Not recording. %1.").arg(why));
    return;
  }
  markers_ = 0;
  remember(entries);
  form_->notesField()->clear();  // they are this recording's, not the next one's
  context_.over(kMark);          // also that nothing was recorded
  context_.tell_about(kRecording, Severity::information,
                      tr("Recording into %1.").arg(QDir::toNativeSeparators(entries.file)));
  context_.feed.pump();
}

void RecordingControl::stop() {
  if (disk_work_.running()) return;
  disk_work_.run(
      [this, file = text(last_.path), session = &context_.session](const std::stop_token&) -> Background::Finish {
        return [this, file, outcome = session->stopRecording()] { stopped(file, outcome); };
      });
}

void RecordingControl::stopped(const QString& file, const Result<void>& outcome) {
  if (outcome) {
    last_.state = RecorderState::idle;
    context_.over(kMark);
    context_.tell_about(kRecording, Severity::information,
                        tr("Recording closed: %1.").arg(QDir::toNativeSeparators(file)));
    enterIntoCatalogue(file);
  } else {
    context_.tell_about(
        kRecording, Severity::error,
        tr("The recording did not close as it should. %1. What was written before is safe: Recover in Review makes "
           "it whole.")
            .arg(widgets::coreText(outcome.error().message)));
  }
  form_->suggest();
  context_.feed.pump();
}

void RecordingControl::finish() {
  waitForDisk();  // a recording that is beginning is closed as well
  if (!recording()) return;
  stop();
  waitForDisk();
}

// On another thread, because the catalogue may be a server that does not answer.
void RecordingControl::enterIntoCatalogue(const QString& file) {
  if (!QFileInfo::exists(file)) return;
  catalogue_work_.run([this, catalogue = context_.catalogue.toStdString(),
                       path = file.toStdString()](const std::stop_token&) -> Background::Finish {
    const auto entered = catalogue::catalogueRecording(catalogue, path);
    return [this, entered] {
      if (!entered) {
        context_.tell(Severity::warning, widgets::coreText(entered.error().message));
        return;
      }
      emit catalogued();
    };
  });
}

void RecordingControl::mark() {
  if (!recording()) {
    context_.tell_about(kMark, Severity::warning, tr("No marker: nothing is being recorded. Ctrl+R starts."));
    return;
  }
  const QString name = tr("Marker %1").arg(markers_ + 1);
  if (const auto kept = context_.session.note(recording::NoteKind::bookmark, name.toStdString()); !kept) {
    context_.tell(Severity::warning, widgets::coreText(kept.error().message));
    return;
  }
  ++markers_;
  context_.tell_about(kMark, Severity::information,
                      tr("Marker %1 at %2.").arg(markers_).arg(widgets::clockText(last_.seconds)));
}

void RecordingControl::note(const QString& words) {
  if (const auto kept = context_.session.note(recording::NoteKind::note, words.toStdString()); !kept) {
    context_.tell(Severity::warning, widgets::coreText(kept.error().message));
    return;
  }
  form_->noteField()->clear();
  context_.tell_about(kMark, Severity::information, tr("Note in the recording: %1").arg(words));
}

void RecordingControl::take(const recording::RecorderStatus& status) {
  const recording::RecorderStatus former = std::exchange(last_, status);
  const RecordingView view = toView(status);
  if (button_ != nullptr) button_->setRecording(view);
  form_->setRecording(view);
  if (status.state == RecorderState::failed && former.state != RecorderState::failed) {
    context_.over(kMark);
    context_.tell_about(kRecording, Severity::error, tr("Recording failed. %1").arg(view.problem));
    form_->suggest();
    enterIntoCatalogue(text(status.path));  // on a disk that gets full the file is closed whole
  }
  if (status.lost > 0 && former.lost == 0) {
    context_.tell(
        Severity::error,
        tr("The recording loses samples: the computer is too busy. What is written is safe; the gap is marked "
           "in the file. Close other programs."));
  }
  if (status.differences > 0 && former.differences == 0) {
    context_.tell(Severity::error,
                  tr("The recording cannot be replayed exactly: the step gave another result the second time. The "
                     "measured values are safe. Please report this fault with the file."));
  }
}

void RecordingControl::remember(const widgets::RecordingEntries& entries) const {
  QSettings kept(memory_, QSettings::IniFormat);
  kept.setValue(QStringLiteral("recording/operator"), entries.operator_name);
  kept.setValue(QStringLiteral("recording/subject"), entries.subject);
  kept.setValue(QStringLiteral("recording/tags"), entries.tags);
}

}  // namespace fyd::console
