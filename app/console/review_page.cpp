// What the page does; how it is built stands in review_page_build.cpp.
#include "app/console/review_page.h"

#include <QDateTime>
#include <QFileInfo>
#include <QHBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/console/views.h"
#include "core/session/recorded_profile.h"
#include "core/session/report.h"
#include "core/station/notice.h"
#include "widgets/core_text.h"
#include "widgets/number_text.h"

namespace fyd::console {
namespace {

using widgets::numberText;
using Mark = widgets::CurveStack::Mark;
using widgets::Severity;

QString wholenessWords(const session::RecordingInfo& info) {
  switch (info.wholeness) {
    case session::Wholeness::whole: break;
    case session::Wholeness::growing: return ReviewPage::tr("still being recorded");
    case session::Wholeness::crashed:
      return ReviewPage::tr("its recorder crashed: everything committed is shown; recover it with fyd session recover");
  }
  return info.gaps > 0 ? ReviewPage::tr("%n sample(s) lost", nullptr, static_cast<int>(info.gaps))
                       : ReviewPage::tr("whole");
}

QString kindWord(session::NoteKind kind) {
  switch (kind) {
    case session::NoteKind::note: return ReviewPage::tr("note");
    case session::NoteKind::bookmark: return ReviewPage::tr("bookmark");
    case session::NoteKind::trial_start: return ReviewPage::tr("trial begins");
    case session::NoteKind::trial_end: return ReviewPage::tr("trial ends");
    case session::NoteKind::alarm: return ReviewPage::tr("alarm");
  }
  return {};
}

using Touches = Result<std::vector<session::Touch>>;

Touches touchesOf(const std::string& path) {
  auto recording = session::Recording::open(path);
  if (!recording) return tl::unexpected(recording.error());
  return session::findTouches(**recording);
}

}  // namespace

ReviewPage::~ReviewPage() { close(); }

void ReviewPage::enter() {
  if (showsList()) list_->look();
  if (recording_ && recording_->info().wholeness == session::Wholeness::growing) {
    if (const auto news = recording_->refresh(); news && *news) describe();
  }
}

void ReviewPage::leave() { player_.stop(); }

void ReviewPage::showList() {
  player_.stop();
  stack_->setCurrentIndex(0);
  list_->look();
}

void ReviewPage::close() {
  touch_work_.cancel();
  figures_work_.cancel();
  compare_work_.cancel();
  player_.setRecording(nullptr);
  curves_->source() = ReviewSource();
  other_.reset();
  recording_.reset();
  touches_.clear();
  other_touches_.clear();
  review_notes_.clear();
  shown_picture_ = 0;
}

void ReviewPage::open(const QString& path) {
  auto opened = session::Recording::open(path.toStdString());
  if (!opened) {
    context_.tell(Severity::warning, widgets::coreText(opened.error().message));
    return;
  }
  close();
  recording_ = std::move(*opened);
  path_ = path;
  curve_tools_->saver().setFolder(QFileInfo(path).absolutePath());
  curve_tools_->saver().setStem(QFileInfo(path).completeBaseName() + tr(" curves"));
  auto notes = session::readReviewNotes(path.toStdString());
  notes_damaged_ = !notes;
  if (notes) {
    review_notes_ = std::move(*notes);
  } else {
    context_.tell(Severity::warning, widgets::coreText(notes.error().message));
  }
  const double duration_s = recording_->info().duration_s;
  curves_->source().setSession(recording_.get());
  curves_->setDuration(duration_s);
  curves_->stack()->clearMarks();
  if (const auto felt = session::recordedParameters(recording_->info().header)) {
    const double most = felt->texture.maximum_percent;
    curves_->strip(curves_->stack()->indexOf(QStringLiteral("vibration")))->setLimits({-most, most});
  }
  figures_table_->setFigures({});
  touch_table_->setTouches({});
  what_if_->setRecording(path);
  compare_words_->setText(tr("Name a second recording: its curves are drawn faint behind these."));
  our_touch_->clear();
  their_touch_->clear();
  describe();
  showMarks();
  stack_->setCurrentIndex(1);
  player_.setRecording(recording_.get());
  curves_->show(0.0, std::min(duration_s, 30.0));
  showEnvelope();
  findTouches();
  curves_->setFocus();
}

void ReviewPage::describe() {
  const session::RecordingInfo& info = recording_->info();
  QStringList words = {
      QFileInfo(path_).fileName(),
      QString::fromStdString(info.header.started_utc).left(19).replace(QLatin1Char('T'), QLatin1Char(' ')) + tr(" UTC"),
      widgets::durationText(info.duration_s)};
  if (!info.header.subject.empty()) words << tr("subject %1").arg(QString::fromStdString(info.header.subject));
  if (!info.header.operator_name.empty()) words << tr("by %1").arg(QString::fromStdString(info.header.operator_name));
  words << wholenessWords(info);
  title_->setText(words.join(QStringLiteral(" · ")));
  overview_->setDuration(info.duration_s);
  curves_->setDuration(info.duration_s);
}

void ReviewPage::showEnvelope() {
  if (!recording_) return;
  std::vector<widgets::CurveColumn> columns;
  curves_->source().decimate(ReviewSource::channel(ReviewLayer::session, 0), 0.0, recording_->info().duration_s,
                             static_cast<std::size_t>(overview_->plotWidth_px()), columns);
  overview_->setEnvelope(std::move(columns), widgets::Quantity::force);
}

void ReviewPage::showMarks() {
  std::vector<widgets::OverviewMark> marks;
  std::vector<NoteLine> lines;
  const session::RecordingInfo& info = recording_->info();
  pipeline::Parameters parameters;
  const auto bound = bindParameters(parameters);
  if (const auto events = recording_->events()) {
    for (const session::EventRow& row : *events) {
      const double at_s = session::secondsInto(info, row.when);
      const QString text = QString::fromStdString(station::describeEvent(row.event, bound));
      const bool held =
          row.event.kind == pipeline::EventKind::state_changed &&
          (row.event.state == pipeline::SafetyState::held || row.event.state == pipeline::SafetyState::stopped);
      marks.push_back({at_s, held ? widgets::OverviewMarkKind::alarm : widgets::OverviewMarkKind::event, text});
      lines.push_back({at_s, tr("event"), text});
    }
  }
  if (const auto notes = recording_->notes()) {
    for (const session::Note& note : *notes) {
      const double at_s = session::secondsInto(info, note.when);
      const QString text = QString::fromStdString(note.text);
      marks.push_back(
          {at_s,
           note.kind == session::NoteKind::alarm ? widgets::OverviewMarkKind::gap : widgets::OverviewMarkKind::note,
           text});
      lines.push_back({at_s, kindWord(note.kind), text});
    }
  }
  for (const session::ReviewNote& note : review_notes_) {
    marks.push_back({note.time_s, widgets::OverviewMarkKind::note, QString::fromStdString(note.text)});
    lines.push_back({note.time_s, tr("%1, in review").arg(kindWord(note.kind)), QString::fromStdString(note.text)});
  }
  std::ranges::stable_sort(lines, {}, &NoteLine::time_s);
  overview_->setMarks(std::move(marks));
  note_table_->setNotes(lines);
}

void ReviewPage::findTouches() {
  touch_table_->setEmptyText(tr("Looking for touches …"));
  touch_work_.run([this, path = path_.toStdString()](const std::stop_token&) -> Background::Finish {
    auto found = std::make_shared<Touches>(touchesOf(path));
    return [this, found] {
      touch_table_->setEmptyText(*found ? tr("The finger never pressed in this session.")
                                        : widgets::coreText(found->error().message));
      if (!*found) return;
      touches_ = **found;
      touch_table_->setTouches(touches_);
      std::vector<std::pair<double, double>> bars;
      for (const session::Touch& touch : touches_) bars.emplace_back(touch.start_s, touch.end_s);
      overview_->setTouches(std::move(bars));
      fillAlignment();
    };
  });
}

void ReviewPage::look(double time_s) {
  overview_->setCursor_s(time_s);
  curves_->setCursor_s(time_s);
  time_->setText(tr("%1 s").arg(numberText(time_s, 3)));
  if (!recording_ || recording_->info().frames == 0) {
    camera_->setPicture({});
    camera_words_->setText(tr("No pictures were recorded."));
    return;
  }
  const auto picture = recording_->pictureAt(time_s);
  if (!picture) {
    shown_picture_ = 0;
    camera_->setPicture({});
    camera_words_->setText(tr("No picture was taken before the cursor."));
    return;
  }
  if (picture->number == shown_picture_) return;
  shown_picture_ = picture->number;
  const cv::Rect& r = picture->region_px;
  camera_->setPicture({.picture = toImage(picture->whole),
                       .mask = {},
                       .region = QRect(r.x, r.y, r.width, r.height),
                       .finger = picture->finger});
  const sensing::FingerDetection& finger = picture->finger;
  camera_words_->setText(
      finger.contact ? tr("x %1 mm   y %2 mm   area %3 px")
                           .arg(numberText(finger.x_mm, 1), numberText(finger.y_mm, 1), numberText(finger.area_px, 0))
                     : QString::fromUtf8(sensing::toString(finger.reason).data()));
}

void ReviewPage::setMark(widgets::CurveStack::Mark which) {
  if (!recording_) return;
  curves_->stack()->setMark(which, player_.time_s());
  tabs_->setCurrentIndex(1);
  computeFigures();
}

void ReviewPage::computeFigures() {
  const double a_s = curves_->stack()->mark_s(Mark::a);
  const double b_s = curves_->stack()->mark_s(Mark::b);
  if (!std::isfinite(a_s) || !std::isfinite(b_s)) return;
  figures_work_.run([this, path = path_.toStdString(), a_s, b_s](const std::stop_token& stop) -> Background::Finish {
    auto opened = session::Recording::open(path);
    auto figures = std::make_shared<Result<std::vector<StretchFigures>>>(
        opened ? figuresBetween(**opened, a_s, b_s, stop) : tl::unexpected(opened.error()));
    return [this, figures, a_s, b_s] {
      if (!*figures) {
        context_.tell(Severity::warning, widgets::coreText(figures->error().message));
        return;
      }
      figures_table_->setFigures(**figures);
      figures_table_->horizontalHeaderItem(0)->setText(tr("Δt %1 s").arg(numberText(b_s - a_s, 3)));
    };
  });
}

void ReviewPage::writeNote(session::NoteKind kind, const QString& text) {
  if (!recording_) return;
  const QString what = text.trimmed();
  if (what.isEmpty()) {
    context_.tell(Severity::information, tr("A note needs words."));
    return;
  }
  if (notes_damaged_) {
    context_.tell(Severity::warning, tr("The note is not written: the file of notes is damaged. Mend or move %1.")
                                         .arg(QString::fromStdString(session::reviewNotesPath(path_.toStdString()))));
    return;
  }
  const double at_s = player_.time_s();
  auto notes = review_notes_;
  notes.push_back({.time_s = at_s,
                   .kind = kind,
                   .text = what.toStdString(),
                   .written_utc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()});
  if (auto written = session::writeReviewNotes(path_.toStdString(), notes); !written) {
    context_.tell(Severity::warning, widgets::coreText(written.error().message));
    return;
  }
  review_notes_ = std::move(notes);
  note_field_->clear();
  showMarks();
}

void ReviewPage::compare(const QString& path) {
  if (!recording_) return;
  auto opened = session::Recording::open(path.trimmed().toStdString());
  if (!opened) {
    compare_words_->setText(widgets::coreText(opened.error().message));
    return;
  }
  other_touches_.clear();
  other_ = std::move(*opened);
  curves_->source().setOther(other_.get(), 0.0);
  curves_->redrawSoon();
  compare_words_->setText(tr("Looking for its touches …"));
  compare_work_.run([this, path = path.trimmed().toStdString()](const std::stop_token&) -> Background::Finish {
    auto found = std::make_shared<Touches>(touchesOf(path));
    return [this, found] {
      compare_words_->setText(*found ? tr("Drawn faint. Choose a touch of each to lay one on the other.")
                                     : widgets::coreText(found->error().message));
      if (*found) other_touches_ = **found;
      fillAlignment();
    };
  });
}

void ReviewPage::fillAlignment() {
  const auto fill = [](QComboBox* box, const std::vector<session::Touch>& touches) {
    const QSignalBlocker quiet(box);
    box->clear();
    box->addItem(tr("from the start"));
    for (std::size_t i = 0; i < touches.size(); ++i) {
      box->addItem(tr("touch %1 at %2 s").arg(i + 1).arg(numberText(touches[i].start_s, 2)));
    }
  };
  fill(our_touch_, touches_);
  fill(their_touch_, other_touches_);
}

void ReviewPage::alignAt(int ours, int theirs) {
  const auto startOf = [](const std::vector<session::Touch>& touches, int index) {
    return index >= 0 && static_cast<std::size_t>(index) < touches.size()
               ? touches[static_cast<std::size_t>(index)].start_s
               : 0.0;
  };
  if (!other_) return;
  const double later_by_s = startOf(touches_, ours) - startOf(other_touches_, theirs);
  curves_->source().setOther(other_.get(), later_by_s);
  curves_->redrawSoon();
  compare_words_->setText(tr("The other session is drawn %1 s later than recorded.").arg(numberText(later_by_s, 3)));
}

// Read again on a thread of its own: what is shown may be hours.
void ReviewPage::saveShownValues() {
  if (!recording_) return;
  const widgets::CurveStack& stack = *curves_->stack();
  session::ExportOptions options{.from_s = curves_->window().from_s(), .to_s = curves_->window().to_s()};
  options.fields.emplace_back("t_s");
  for (std::size_t i = 0; i < stack.size(); ++i) {
    if (!stack.shown(i)) continue;
    for (const widgets::Trace& trace : stack.setup(i).traces) {
      if (trace.channel < widgets::kCurveChannels)
        options.fields.emplace_back(widgets::curveQuantities()[trace.channel].field);
    }
  }
  exportTo(curve_tools_->saver().pathFor(QStringLiteral("csv")).toStdString(), options);
}

void ReviewPage::exportAs(const QString& ending) {
  if (!recording_) return;
  const QFileInfo file(path_);
  const std::string target =
      (file.absolutePath() + QLatin1Char('/') + file.completeBaseName() + QLatin1Char('.') + ending).toStdString();
  exportTo(target, {});
}

void ReviewPage::exportTo(const std::string& target, const session::ExportOptions& options) {
  context_.tell(Severity::information, tr("Writing %1 …").arg(QString::fromStdString(target)));
  export_work_.run([this, path = path_.toStdString(), target, options](const std::stop_token&) -> Background::Finish {
    Result<void> done;
    if (auto opened = session::Recording::open(path); !opened) {
      done = tl::unexpected(opened.error());
    } else if (target.ends_with(".html") || target.ends_with(".pdf")) {
      done = session::writeReport(**opened, target, false);
    } else if (auto exported = session::exportRecording(**opened, target, options); !exported) {
      done = tl::unexpected(exported.error());
    }
    return [this, done, target] {
      context_.tell(
          done ? Severity::information : Severity::warning,
          done ? tr("%1 is written.").arg(QString::fromStdString(target)) : widgets::coreText(done.error().message));
    };
  });
}

void ReviewPage::addCommands(PlaceCommands& commands) {
  const char* review = QT_TRANSLATE_NOOP("Commands", "Review");
  const auto add = [&](const char* id, const char* text, const char* icon, const char* keys, auto run) {
    commands.add({id, review, text, icon, keys}, [run](bool) { run(); });
  };
  add("review.list", QT_TRANSLATE_NOOP("Commands", "List of sessions"), "log", "Ctrl+O", [this] { showList(); });
  add("review.play", QT_TRANSLATE_NOOP("Commands", "Play or pause"), "pause", "Space",
      [this] { player_.togglePlaying(); });
  add("review.next_sample", QT_TRANSLATE_NOOP("Commands", "Next sample"), "", "Right",
      [this] { player_.stepSamples(1); });
  add("review.previous_sample", QT_TRANSLATE_NOOP("Commands", "Previous sample"), "", "Left",
      [this] { player_.stepSamples(-1); });
  add("review.next_picture", QT_TRANSLATE_NOOP("Commands", "Next picture"), "", "Shift+Right",
      [this] { player_.stepPictures(1); });
  add("review.previous_picture", QT_TRANSLATE_NOOP("Commands", "Previous picture"), "", "Shift+Left",
      [this] { player_.stepPictures(-1); });
  add("review.mark_a", QT_TRANSLATE_NOOP("Commands", "Set A at the cursor"), "", "[", [this] { setMark(Mark::a); });
  add("review.mark_b", QT_TRANSLATE_NOOP("Commands", "Set B at the cursor"), "", "]", [this] { setMark(Mark::b); });
  add("review.clear_marks", QT_TRANSLATE_NOOP("Commands", "Take A and B away"), "", "\\",
      [this] { curves_->stack()->clearMarks(); });
  curve_tools_->addCommands(commands, "review", review, [this] { saveShownValues(); });
  for (QToolButton* button : curve_tools_->makeButtons(this)) bar_->addWidget(button);
  add("review.note", QT_TRANSLATE_NOOP("Commands", "Write a note at the cursor"), "", "N",
      [this] { note_field_->setFocus(); });
  add("review.bookmark", QT_TRANSLATE_NOOP("Commands", "Bookmark at the cursor"), "", "B",
      [this] { writeNote(session::NoteKind::bookmark, tr("bookmark")); });
  add("review.whole", QT_TRANSLATE_NOOP("Commands", "Show the whole session"), "", "Home", [this] {
    if (recording_) curves_->show(0.0, recording_->info().duration_s);
  });
  add("review.report_html", QT_TRANSLATE_NOOP("Commands", "Report as web page"), "save", "Ctrl+P",
      [this] { exportAs(QStringLiteral("html")); });
  add("review.report_pdf", QT_TRANSLATE_NOOP("Commands", "Report as PDF"), "save", "Ctrl+Shift+P",
      [this] { exportAs(QStringLiteral("pdf")); });
  for (const auto& [id, text, ending] :
       {std::tuple{"review.export_csv", QT_TRANSLATE_NOOP("Commands", "Export as CSV"), "csv"},
        std::tuple{"review.export_mat", QT_TRANSLATE_NOOP("Commands", "Export for MATLAB"), "mat"},
        std::tuple{"review.export_mcap", QT_TRANSLATE_NOOP("Commands", "Export as MCAP"), "mcap"},
        std::tuple{"review.export_mkv", QT_TRANSLATE_NOOP("Commands", "Export the camera's video"), "mkv"}}) {
    add(id, text, "save", "", [this, ending = QString::fromUtf8(ending)] { exportAs(ending); });
  }
}

}  // namespace fyd::console
