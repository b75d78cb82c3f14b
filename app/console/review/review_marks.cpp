#include "app/console/review/review_marks.h"

#include <QDateTime>
#include <algorithm>

#include "core/pipeline/parameters.h"
#include "core/station/notice.h"
#include "widgets/basics/core_text.h"

namespace fyd::console {
namespace {

using widgets::OverviewMarkKind;
using widgets::Severity;

QString kindWord(recording::NoteKind kind) {
  switch (kind) {
    case recording::NoteKind::note: return ReviewMarks::tr("note");
    case recording::NoteKind::bookmark: return ReviewMarks::tr("bookmark");
    case recording::NoteKind::trial_start: return ReviewMarks::tr("trial begins");
    case recording::NoteKind::trial_end: return ReviewMarks::tr("trial ends");
    case recording::NoteKind::alarm: return ReviewMarks::tr("alarm");
  }
  return {};
}

bool movesNothingMore(const pipeline::Event& event) {
  return event.kind == pipeline::EventKind::state_changed &&
         (event.state == pipeline::SafetyState::held || event.state == pipeline::SafetyState::stopped);
}

}  // namespace

ReviewMarks::ReviewMarks(widgets::SessionOverview* overview, NoteTable* table, Tell tell)
    : overview_(overview), table_(table), tell_(std::move(tell)) {}

void ReviewMarks::open(const QString& path) {
  path_ = path.toStdString();
  auto notes = recording::readReviewNotes(path_);
  damaged_ = !notes;
  notes_ = notes ? std::move(*notes) : std::vector<recording::ReviewNote>{};
  if (!notes) tell_(Severity::warning, widgets::coreText(notes.error().message));
}

void ReviewMarks::show(const recording::Recording& recording) {
  std::vector<widgets::OverviewMark> marks;
  std::vector<NoteLine> lines;
  const auto add = [&](double at_s, OverviewMarkKind mark, const QString& kind, const QString& text) {
    marks.push_back({at_s, mark, text});
    lines.push_back({at_s, kind, text});
  };
  const recording::RecordingInfo& info = recording.info();
  pipeline::Parameters parameters;
  const auto bound = bindParameters(parameters);
  if (const auto events = recording.events()) {
    for (const recording::EventRow& row : *events) {
      add(recording::secondsInto(info, row.when),
          movesNothingMore(row.event) ? OverviewMarkKind::alarm : OverviewMarkKind::event, tr("event"),
          widgets::coreText(station::describeEvent(row.event, bound)));
    }
  }
  if (const auto notes = recording.notes()) {
    for (const recording::Note& note : *notes) {
      add(recording::secondsInto(info, note.when),
          note.kind == recording::NoteKind::alarm ? OverviewMarkKind::gap : OverviewMarkKind::note, kindWord(note.kind),
          QString::fromStdString(note.text));
    }
  }
  for (const recording::ReviewNote& note : notes_) {
    add(note.time_s, OverviewMarkKind::note, tr("%1, in review").arg(kindWord(note.kind)),
        QString::fromStdString(note.text));
  }
  std::ranges::stable_sort(lines, {}, &NoteLine::time_s);
  overview_->setMarks(std::move(marks));
  table_->setNotes(lines);
}

bool ReviewMarks::write(recording::NoteKind kind, const QString& text, double at_s) {
  const QString what = text.trimmed();
  if (what.isEmpty()) {
    tell_(Severity::information, tr("A note needs words."));
    return false;
  }
  if (damaged_) {
    tell_(Severity::warning, tr("The note is not written: the file of notes is damaged. Mend or move %1.")
                                 .arg(QString::fromStdString(recording::reviewNotesPath(path_))));
    return false;
  }
  auto notes = notes_;
  notes.push_back({.time_s = at_s,
                   .kind = kind,
                   .text = what.toStdString(),
                   .written_utc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()});
  if (auto written = recording::writeReviewNotes(path_, notes); !written) {
    tell_(Severity::warning, widgets::coreText(written.error().message));
    return false;
  }
  notes_ = std::move(notes);
  return true;
}

}  // namespace fyd::console
