// What the page does with a recording: opens and closes it, says what it is, shows what stands at the cursor. How the
// page is built stands in review_page_build.cpp, its commands in review_page_commands.cpp.
#include "app/console/review_page.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "app/console/curve_limits.h"
#include "core/session/recorded_profile.h"
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
    case session::Wholeness::crashed: return ReviewPage::tr("recorder crashed");
    case session::Wholeness::damaged: return ReviewPage::tr("damaged");
  }
  if (info.gaps > 0) return ReviewPage::tr("%n sample(s) lost", nullptr, static_cast<int>(info.gaps));
  return info.header.missing.empty() ? ReviewPage::tr("whole") : ReviewPage::tr("parts missing");
}

bool canBeRecovered(const session::RecordingInfo& info) {
  return info.wholeness == session::Wholeness::crashed || info.wholeness == session::Wholeness::damaged;
}

}  // namespace

ReviewPage::~ReviewPage() {
  // All are asked before the first is waited for.
  exports_->drop();
  recovery_->drop();
  close();
}

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

void ReviewPage::showNews() {
  if (isVisible() && showsList()) list_->look();
}

void ReviewPage::close() {
  touch_search_.drop();
  figures_work_.drop();
  what_if_->setRecording({});
  comparison_->clear();
  player_.setRecording(nullptr);
  exports_->setRecording({});
  curves_->source() = ReviewSource();
  recording_.reset();
  camera_->forget();
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
  exports_->setRecording(path);
  curve_tools_->saver().setFolder(QFileInfo(path).absolutePath());
  curve_tools_->saver().setStem(QFileInfo(path).completeBaseName() + tr(" curves"));
  const double duration_s = recording_->info().duration_s;
  curves_->source().setSession(recording_.get());
  curves_->setDuration(duration_s);
  curves_->stack()->clearMarks();
  if (const auto felt = session::recordedParameters(recording_->info().header)) drawLimits(*curves_->stack(), *felt);
  figures_table_->setFigures({});
  showTouches({});
  what_if_->setRecording(path);
  marks_.open(path);
  describe();
  marks_.show(*recording_);
  stack_->setCurrentIndex(1);
  player_.setRecording(recording_.get());
  curves_->show(0.0, std::min(duration_s, 30.0));
  showEnvelope();
  findTouches();
  curves_->setFocus();
}

void ReviewPage::describe() {
  const session::RecordingInfo& info = recording_->info();
  // What matters most comes first: a narrow window shows no more.
  QStringList words = {
      QFileInfo(path_).fileName(), wholenessWords(info),
      QString::fromStdString(info.header.started_utc).left(19).replace(QLatin1Char('T'), QLatin1Char(' ')) + tr(" UTC"),
      widgets::durationText(info.duration_s)};
  if (!info.header.subject.empty()) words << tr("subject %1").arg(QString::fromStdString(info.header.subject));
  if (!info.header.operator_name.empty()) words << tr("by %1").arg(QString::fromStdString(info.header.operator_name));
  recover_->setVisible(canBeRecovered(info));
  title_->setText(words.join(QStringLiteral(" · ")));
  title_->setToolTip(title_->text());
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

void ReviewPage::findTouches() {
  touch_table_->setEmptyText(tr("Looking for touches …"));
  touch_search_.look(path_, [this](const auto& found) {
    touch_table_->setEmptyText(found ? tr("The finger never pressed in this session.")
                               : touch_search_.cancelled()
                                   ? tr("The search was cancelled. Open the session again to look for touches.")
                                   : widgets::coreText(found.error().message));
    if (found) showTouches(*found);
  });
}

void ReviewPage::makeCard() {
  if (const session::Touch* touch = touch_table_->chosen()) {
    exports_->exportCard(*touch, touch_table_->currentRow() + 1);
  } else {
    context_.tell(Severity::information, tr("Choose a touch in the list first."));
  }
}

void ReviewPage::showTouches(const std::vector<session::Touch>& touches) {
  touch_table_->setTouches(touches);
  std::vector<std::pair<double, double>> bars;
  for (const session::Touch& touch : touches) bars.emplace_back(touch.start_s, touch.end_s);
  overview_->setTouches(std::move(bars));
  comparison_->setTouches(touches);
}

void ReviewPage::look(double time_s) {
  overview_->setCursor_s(time_s);
  curves_->setCursor_s(time_s);
  time_->setText(tr("%1 s").arg(numberText(time_s, 3)));
  camera_->showAt(recording_.get(), time_s);
}

void ReviewPage::setMark(Mark which) {
  if (!recording_) return;
  curves_->stack()->setMark(which, player_.time_s());
  tabs_->setCurrentWidget(figures_table_);
  computeFigures();
}

void ReviewPage::computeFigures() {
  const double a_s = curves_->stack()->mark_s(Mark::a);
  const double b_s = curves_->stack()->mark_s(Mark::b);
  if (!std::isfinite(a_s) || !std::isfinite(b_s)) return;
  using Figures = Result<std::vector<StretchFigures>>;
  const auto work = [this, path = path_.toStdString(), a_s, b_s](const session::Progress& progress) {
    auto opened = session::Recording::open(path);
    auto figures = std::make_shared<Figures>(opened ? figuresBetween(**opened, a_s, b_s, progress)
                                                    : Figures(tl::unexpected(opened.error())));
    return [this, figures, a_s, b_s] {
      if (*figures) {
        figures_table_->setFigures(**figures);
        figures_table_->horizontalHeaderItem(0)->setText(tr("Δt %1 s").arg(numberText(b_s - a_s, 3)));
      } else if (figures_work_.cancelled()) {
        figures_table_->setFigures({});  // those shown are of other marks
      } else {
        context_.tell(Severity::warning, widgets::coreText(figures->error().message));
      }
    };
  };
  figures_work_.run(tr("Reckoning between A and B"), work);
}

void ReviewPage::writeNote(session::NoteKind kind, const QString& text) {
  if (!recording_ || !marks_.write(kind, text, player_.time_s())) return;
  note_field_->clear();
  marks_.show(*recording_);
}

}  // namespace fyd::console
