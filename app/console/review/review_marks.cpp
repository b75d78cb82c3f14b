#include "app/console/review/review_marks.h"

#include <QDateTime>
#include <algorithm>
#include <iterator>
#include <set>

#include "core/catalogue/catalogue_text.h"
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

ReviewMarks::ReviewMarks(widgets::SessionOverview* overview, NoteTable* table, QString catalogue, Tell tell)
    : overview_(overview), table_(table), tell_(std::move(tell)), catalogue_(std::move(catalogue)) {}

void ReviewMarks::open(const ShownRecording& shown) {
  shown_ = shown;
  auto review = recording::readReviewNotes(shown_.path.toStdString(), shown_.id);
  review_ = review ? std::move(*review) : recording::ReviewNotes{};
  if (!review) tell_(Severity::warning, widgets::coreText(review.error().message));
}

void ReviewMarks::show(const recording::Recording& recording) {
  std::vector<widgets::OverviewMark> marks;
  std::vector<NoteLine> lines;
  const auto add = [&](double at_s, OverviewMarkKind mark, const QString& kind, const QString& text) {
    marks.push_back({at_s, mark, text});
    lines.push_back({at_s, kind, text});
  };
  const recording::RecordingInfo& info = recording.info();
  own_tags_ = info.header.tags;
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
  for (const recording::ReviewNote& note : review_.notes) {
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
  const recording::ReviewNote note{.time_s = at_s,
                                   .kind = kind,
                                   .text = what.toStdString(),
                                   .written_utc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()};
  return save({.note = note, .tags_added = {}, .tags_removed = {}});
}

QStringList ReviewMarks::tags() const {
  QStringList out;
  for (const std::string& tag : review_.tags.value_or(own_tags_)) out << QString::fromStdString(tag);
  return out;
}

bool ReviewMarks::writeTags(const QString& text) {
  std::set<std::string> wanted;
  for (const QString& tag : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    if (const QString word = tag.simplified(); !word.isEmpty()) wanted.insert(word.toStdString());
  }
  if (auto good = catalogue::checkTags({wanted.begin(), wanted.end()}); !good) {
    tell_(Severity::warning, widgets::coreText(good.error().message));
    return false;
  }
  const auto& list = review_.tags.value_or(own_tags_);
  const std::set<std::string> former(list.begin(), list.end());
  catalogue::ReviewChange change;
  std::ranges::set_difference(wanted, former, std::back_inserter(change.tags_added));
  std::ranges::set_difference(former, wanted, std::back_inserter(change.tags_removed));
  if (change.tags_added.empty() && change.tags_removed.empty()) return true;
  return save(std::move(change));
}

bool ReviewMarks::save(catalogue::ReviewChange change) {
  const std::string path = shown_.path.toStdString();
  if (const auto still = shown_.open(); !still) {  // notes would stand beside nothing, or beside another recording
    tell_(Severity::warning, widgets::coreText(still.error().message));
    return false;
  }
  auto review = recording::readReviewNotes(path, shown_.id);
  if (!review) {
    tell_(Severity::warning,
          tr("Nothing is written. %1. Mend or move that file.").arg(widgets::coreText(review.error().message)));
    return false;
  }
  if (change.note) review->notes.push_back(*change.note);
  if (!change.tags_added.empty() || !change.tags_removed.empty()) {
    const auto& now = review->tags.value_or(own_tags_);
    std::set<std::string> tags(now.begin(), now.end());
    tags.insert(change.tags_added.begin(), change.tags_added.end());
    for (const std::string& each : change.tags_removed) tags.erase(each);
    review->tags = std::vector<std::string>(tags.begin(), tags.end());
  }
  if (auto written = recording::writeReviewNotes(path, shown_.id, *review); !written) {
    tell_(Severity::warning, widgets::coreText(written.error().message));
    return false;
  }
  review_ = std::move(*review);
  deliver({shown_.id, std::move(change)});
  return true;
}

// One after the other, each on the work's thread: a catalogue's server may answer slowly.
void ReviewMarks::deliver(Change change) {
  waiting_.push_back(std::move(change));
  if (!work_.running()) deliverNext();
}

void ReviewMarks::deliverNext() {
  if (waiting_.empty()) return;
  work_.run([this, next = waiting_.front(),
             catalogue = catalogue_.toStdString()](const std::stop_token&) -> Background::Finish {
    const auto done = guarded([&] { return catalogue::catalogueReview(catalogue, next.id, next.change); });
    return [this, done] {
      if (!done) tell_(Severity::warning, widgets::coreText(done.error().message));
      waiting_.erase(waiting_.begin());
      deliverNext();
    };
  });
}

}  // namespace fyd::console
