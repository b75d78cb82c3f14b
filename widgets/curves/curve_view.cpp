#include "widgets/curves/curve_view.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/basics/icon.h"
#include "widgets/basics/number_text.h"
#include "widgets/curves/curve_catalogue.h"

namespace fyd::widgets {
namespace {

constexpr std::size_t kCapacity = 262144;  // 4 min at 1 kHz
constexpr int kRedraw_ms = 33;
constexpr int kNumerals_ms = 125;
constexpr double kSpans_s[] = {5, 10, 30, 60};
/// A little above each sensor's sampling interval.
constexpr double kUsualBridgeAge_ms = 50, kUsualIrAge_ms = 50, kUsualRobotAge_ms = 60;
constexpr qint64 kSilence_ms = 300;
constexpr double kGone_ms = 300;  // a reading that old is drawn no more

QString agedNote(double age_ms, double usual_ms) {
  return std::isfinite(age_ms) && age_ms > usual_ms ? CurveView::tr("%1 old").arg(ageText(age_ms)) : QString();
}

}  // namespace

CurveView::CurveView(QWidget* parent)
    : QWidget(parent),
      buffer_(kCurveChannels, kCapacity),
      stack_(new CurveStack(TimeWindow{}, this)),
      recent_(kCurveChannels) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid / 2, kGrid, kGrid / 2);
  layout->setSpacing(0);
  buildBar(layout);
  layout->addWidget(stack_, 1);
  addStrips();
  connect(stack_, &CurveStack::moved, this, [this] {
    dirty_ = true;
    if (following() != was_following_) sayFollowing();
  });
  connect(stack_, &CurveStack::clicked, stack_, &CurveStack::setCursor_s);
  connect(stack_, &CurveStack::followAsked, this, &CurveView::follow);
  connect(&redraw_timer_, &QTimer::timeout, this, &CurveView::redrawWhenMoved);
  connect(&numeral_timer_, &QTimer::timeout, this, &CurveView::refreshNumerals);
  redraw_timer_.start(kRedraw_ms);
  numeral_timer_.start(kNumerals_ms);
  sayFollowing();
}

void CurveView::addStrips() {
  for (const StripPlan& plan : stripPlans()) {
    StripSetup setup = setupOf(plan);
    // The first is drawn last and so on top: the measured value covers its target.
    for (auto channel = plan.channels.rbegin(); channel != plan.channels.rend(); ++channel) {
      const CurveQuantity& q = curveQuantities()[*channel];
      setup.traces.push_back({.channel = *channel,
                              .quantity = q.quantity,
                              .stroke = q.stroke,
                              .lane = {},
                              .word = wordOf(q),
                              .decimals = q.decimals});
    }
    if (plan.lanes) {
      std::ranges::reverse(setup.traces);  // the first lane on top
      for (Trace& trace : setup.traces) trace.lane = wordOf(curveQuantities()[trace.channel]);
    }
    if (plan.peak) {
      for (const std::size_t channel : plan.channels) recent_[channel] = RecentValue(RecentValue::Kind::peak);
    }
    stack_->add(std::move(setup));
  }
}

void CurveView::addButton(QToolButton* button) { bar_->insertWidget(2, button); }

void CurveView::buildBar(QVBoxLayout* layout) {
  auto* bar = bar_ = new QHBoxLayout;
  bar->setSpacing(kGrid / 2);
  follow_button_ = new QToolButton(this);
  follow_button_->setObjectName(QStringLiteral("follow_button"));
  follow_button_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(follow_button_, &QToolButton::clicked, this, &CurveView::togglePause);
  follow_label_ = new QLabel(this);
  follow_label_->setFont(textFont(TextSize::small));
  follow_label_->setContentsMargins(kGrid / 2, 0, 0, 0);
  follow_label_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a narrow window cuts it first
  bar->addWidget(follow_button_);
  bar->addWidget(follow_label_, 1);
  time_field_ = new TimeField(this);
  time_field_->setSpan([this] { return std::pair(buffer_.firstTime_s(), buffer_.lastTime_s()); });
  connect(time_field_, &TimeField::asked, this, &CurveView::goTo);
  bar->addWidget(time_field_);
  spans_ = new QButtonGroup(this);
  for (const double span_s : kSpans_s) {
    auto* button = new QToolButton(this);
    button->setText(tr("%1 s").arg(span_s));
    button->setCheckable(true);
    button->setAccessibleName(tr("Show %1 seconds").arg(span_s));
    button->setToolTip(tr("Show the last %1 s").arg(span_s));
    button->setChecked(span_s == stack_->window().chosenSpan_s());
    spans_->addButton(button);
    bar->addWidget(button);
    connect(button, &QToolButton::clicked, this, [this, span_s] { chooseSpan(span_s); });
  }
  layout->addLayout(bar);
  layout->addSpacing(kGrid / 2);
}

void CurveView::append(std::span<const pipeline::TelemetrySample> samples) {
  const auto fields = pipeline::telemetryFields();
  for (const pipeline::TelemetrySample& s : samples) {
    if (!any_) origin_ = s.now;
    any_ = true;
    std::array<float, kCurveChannels> stored{};
    for (std::size_t c = 0; c < kCurveChannels; ++c) {
      const auto age = curveQuantities()[c].age;
      const bool gone = age != nullptr && s.*age > kGone_ms;
      const double value = gone ? std::numeric_limits<double>::quiet_NaN() : fields[curveFields()[c]].read(s);
      stored[c] = static_cast<float>(value);
      recent_[c].add(value);
    }
    buffer_.append(toSeconds(s.now - origin_), stored);
  }
  if (samples.empty()) return;
  newest_ = samples.back();
  since_sample_.start();
  stack_->advance(buffer_.lastTime_s());
}

void CurveView::restart() {
  buffer_.clear();
  any_ = false;
  newest_ = {};
  for (RecentValue& each : recent_) (void)each.take();
  since_sample_.invalidate();
  clearMarks();
  stack_->advance(0.0);
  stack_->forEachWindow([](TimeWindow& window) { window.follow(); });
}

void CurveView::redrawWhenMoved() {
  const bool column_more = !(buffer_.lastTime_s() - drawn_s_ < stack_->column_s());  // also for the first samples
  if (dirty_ || (!buffer_.empty() && column_more)) redraw();
}

void CurveView::redraw() {
  if (!isVisible()) return;
  dirty_ = false;
  drawn_s_ = buffer_.lastTime_s();
  stack_->draw(buffer_);
  emit drawn();
}

QString CurveView::noteOf(const QString& strip) const {
  if (!since_sample_.isValid() || since_sample_.elapsed() > kSilence_ms) return tr("no data");
  if (strip == QLatin1String("force")) return agedNote(newest_.bridge_age_ms, kUsualBridgeAge_ms);
  if (strip == QLatin1String("indentation")) return agedNote(newest_.ir_age_ms, kUsualIrAge_ms);
  if (strip == QLatin1String("acceleration")) return agedNote(newest_.robot_age_ms, kUsualRobotAge_ms);
  if (strip != QLatin1String("stiffness")) return {};
  QStringList words;
  if (std::isfinite(newest_.stiffness_N_per_mm) && !newest_.stiffness_observable) words << tr("last touch");
  if (newest_.target_clamped) words << tr("target limited");
  return words.join(QStringLiteral(", "));
}

void CurveView::refreshNumerals() {
  std::array<double, kCurveChannels> v{};
  for (std::size_t c = 0; c < kCurveChannels; ++c) v[c] = recent_[c].take();
  for (std::size_t i = 0; i < stack_->size(); ++i) {
    if (!stack_->shown(i) || stack_->readsCursor(i)) continue;
    const StripSetup& setup = stack_->setup(i);
    for (std::size_t entry = 0; entry < setup.channels.size(); ++entry) {
      readout(i)->setValue(entry, v[setup.channels[entry]]);
    }
    readout(i)->setWhen(setup.peak ? tr("live, peak") : tr("live"));
    readout(i)->setNote(noteOf(setup.id));
  }
}

void CurveView::follow() {
  stack_->freeRanges();
  stack_->forEachWindow([](TimeWindow& window) { window.follow(); });
}

void CurveView::pause() {
  stack_->forEachWindow([](TimeWindow& window) { window.pause(); });
}

void CurveView::togglePause() { following() ? pause() : follow(); }

void CurveView::chooseSpan(double span_s) {
  for (QAbstractButton* button : spans_->buttons()) button->setChecked(button->text() == tr("%1 s").arg(span_s));
  stack_->forEachWindow([span_s](TimeWindow& window) { window.chooseSpan(span_s); });
}

void CurveView::setMark(CurveStack::Mark which) {
  stack_->setMark(which, std::isfinite(stack_->cursor_s()) ? stack_->cursor_s() : buffer_.lastTime_s());
}

void CurveView::clearMarks() {
  stack_->clearMarks();
  stack_->setCursor_s(std::numeric_limits<double>::quiet_NaN());
}

void CurveView::moveCursor(double by_s) {
  if (buffer_.empty()) return;
  const double from_s = std::isfinite(stack_->cursor_s()) ? stack_->cursor_s() : buffer_.lastTime_s();
  stack_->setCursor_s(std::clamp(from_s + by_s, buffer_.firstTime_s(), buffer_.lastTime_s()));
}

void CurveView::goTo(double time_s) {
  stack_->setCursor_s(time_s);
  stack_->forEachWindow([=](TimeWindow& window) {
    const double half_s = 0.5 * window.span_s();
    window.show(time_s - half_s, time_s + half_s);
  });
}

void CurveView::sayFollowing() {
  const bool now = following();
  follow_label_->setText(now ? tr("Following") : tr("Not following: press F"));
  follow_label_->setProperty("role", now ? "muted" : "warning");
  restyle(*follow_label_);
  follow_label_->setToolTip(follow_label_->text());
  follow_button_->setProperty("role", now ? "" : "warning");  // visible also where the text does not fit
  restyle(*follow_button_);
  follow_button_->setText(now ? tr("Pause") : tr("Follow"));
  follow_button_->setIcon(icon(now ? QStringLiteral("pause") : QStringLiteral("follow")));
  follow_button_->setToolTip(now ? tr("Hold the picture still; measuring goes on (Space)")
                                 : tr("Follow the newest values (F)"));
  if (now != was_following_) emit followingChanged(now);
  was_following_ = now;
}

}  // namespace fyd::widgets
