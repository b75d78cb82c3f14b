#include "widgets/curve_view.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/icon.h"
#include "widgets/number_text.h"

namespace fyd::widgets {
namespace {

enum Channel : std::size_t {
  kForce,
  kIndentation,
  kStiffness,
  kTarget,
  kVibration,
  kAccelerationX,
  kAccelerationY,
  kAccelerationZ,
  kChannelCount
};

constexpr std::size_t kCapacity = 262144;  // 4 min at 1 kHz
constexpr int kRedraw_ms = 33;
constexpr int kNumerals_ms = 125;
constexpr double kSpans_s[] = {5, 10, 30, 60};
/// A little above what each sensor needs between two values.
constexpr double kUsualBridgeAge_ms = 50, kUsualIrAge_ms = 50, kUsualRobotAge_ms = 60;
constexpr qint64 kSilence_ms = 300;

QString agedNote(double age_ms, double usual_ms) {
  return std::isfinite(age_ms) && age_ms > usual_ms ? CurveView::tr("%1 old").arg(ageText(age_ms)) : QString();
}

}  // namespace

CurveView::CurveView(QWidget* parent) : QWidget(parent), buffer_(kChannelCount, kCapacity), recent_(kChannelCount) {
  for (const std::size_t c : {kVibration, kAccelerationX, kAccelerationY, kAccelerationZ}) {
    recent_[c] = RecentValue(RecentValue::Kind::peak);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid / 2, kGrid, kGrid / 2);
  layout->setSpacing(0);
  buildBar(layout);
  addStrip(tr("Force"), tr("N"), {0, 2}, {{kForce, Quantity::force}}, {{{}, Quantity::force, false, 2}}, true, false);
  addStrip(tr("Indentation"), tr("mm"), {0, 5}, {{kIndentation, Quantity::indentation}},
           {{{}, Quantity::indentation, false, 2}}, true, false);
  addStrip(tr("Stiffness"), tr("N/mm"), {0, 1},
           {{kTarget, Quantity::stiffness, Stroke::dashed}, {kStiffness, Quantity::stiffness}},
           {{{}, Quantity::stiffness, false, 2}, {tr("target"), Quantity::stiffness, true, 2}}, true, false);
  addStrip(tr("Vibration, peak"), tr("%"), {-100, 100}, {{kVibration, Quantity::vibration}},
           {{{}, Quantity::vibration, false, 0}}, true, false);
  addStrip(tr("Acceleration, peak"), tr("g"), {-1, 1},
           {{kAccelerationX, Quantity::acceleration_x, Stroke::solid, tr("x")},
            {kAccelerationY, Quantity::acceleration_y, Stroke::solid, tr("y")},
            {kAccelerationZ, Quantity::acceleration_z, Stroke::solid, tr("z")}},
           {{tr("x"), Quantity::acceleration_x, false, 2},
            {tr("y"), Quantity::acceleration_y, false, 2},
            {tr("z"), Quantity::acceleration_z, false, 2}},
           false, true);
  connect(&redraw_timer_, &QTimer::timeout, this, &CurveView::redraw);
  connect(&numeral_timer_, &QTimer::timeout, this, &CurveView::refreshNumerals);
  redraw_timer_.start(kRedraw_ms);
  numeral_timer_.start(kNumerals_ms);
  sayFollowing();
}

void CurveView::buildBar(QVBoxLayout* layout) {
  auto* bar = new QHBoxLayout;
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
  spans_ = new QButtonGroup(this);
  for (const double span_s : kSpans_s) {
    auto* button = new QToolButton(this);
    button->setText(tr("%1 s").arg(span_s));
    button->setCheckable(true);
    button->setAccessibleName(tr("Show %1 seconds").arg(span_s));
    button->setToolTip(tr("Show the last %1 s").arg(span_s));
    button->setChecked(span_s == window_.chosenSpan_s());
    spans_->addButton(button);
    bar->addWidget(button);
    connect(button, &QToolButton::clicked, this, [this, span_s] { chooseSpan(span_s); });
  }
  layout->addLayout(bar);
  layout->addSpacing(kGrid / 2);
}

void CurveView::addStrip(const QString& title, const QString& unit, Range least, std::vector<Trace> traces,
                         std::vector<Readout::Entry> entries, bool large, bool last) {
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid);
  auto* strip = new CurveStrip(title, unit, least, std::move(traces), last, this);
  auto* readout = new Readout(title, unit, std::move(entries), large, this);
  row->addWidget(strip, 1);
  row->addWidget(readout);
  static_cast<QVBoxLayout*>(layout())->addLayout(row, last ? 5 : 4);  // the last one also carries the time scale
  connect(strip, &CurveStrip::panned, this, [this](double by_s) {
    window_.pan(by_s);
    sayFollowing();
  });
  connect(strip, &CurveStrip::zoomed, this, [this](double factor, double about_s) {
    window_.zoom(factor, window_.to_s() + about_s);
    sayFollowing();
  });
  connect(strip, &CurveStrip::boxed, this, [this](double from_s, double to_s) {
    window_.show(window_.to_s() + from_s, window_.to_s() + to_s);
    sayFollowing();
  });
  connect(strip, &CurveStrip::followAsked, this, &CurveView::follow);
  strips_.push_back(strip);
  readouts_.push_back(readout);
}

void CurveView::append(std::span<const pipeline::TelemetrySample> samples) {
  for (const pipeline::TelemetrySample& s : samples) {
    if (!any_) origin_ = s.now;
    any_ = true;
    const std::array<double, kChannelCount> values = {
        s.force_N,          s.indentation_mm,   s.stiffness_N_per_mm, s.target_N_per_mm, s.vibration_duty_percent,
        s.acceleration_x_g, s.acceleration_y_g, s.acceleration_z_g};
    std::array<float, kChannelCount> stored{};
    for (std::size_t c = 0; c < kChannelCount; ++c) {
      stored[c] = static_cast<float>(values[c]);
      recent_[c].add(values[c]);
    }
    buffer_.append(toSeconds(s.now - origin_), stored);
  }
  if (samples.empty()) return;
  newest_ = samples.back();
  since_sample_.start();
  window_.advance(buffer_.lastTime_s());
  dirty_ = true;
}

void CurveView::redraw() {
  if (!isVisible() || !dirty_) return;
  dirty_ = false;
  for (CurveStrip* strip : strips_) strip->draw(buffer_, window_);
}

void CurveView::refreshNumerals() {
  const bool silent = !since_sample_.isValid() || since_sample_.elapsed() > kSilence_ms;
  std::array<double, kChannelCount> v{};
  for (std::size_t c = 0; c < kChannelCount; ++c) v[c] = recent_[c].take();
  readouts_[0]->setValue(0, v[kForce]);
  readouts_[1]->setValue(0, v[kIndentation]);
  readouts_[2]->setValue(0, v[kStiffness]);
  readouts_[2]->setValue(1, v[kTarget]);
  readouts_[3]->setValue(0, v[kVibration]);
  for (std::size_t axis = 0; axis < 3; ++axis) readouts_[4]->setValue(axis, v[kAccelerationX + axis]);
  if (silent) {
    for (Readout* readout : readouts_) readout->setNote(tr("no data"));
    return;
  }
  readouts_[0]->setNote(agedNote(newest_.bridge_age_ms, kUsualBridgeAge_ms));
  readouts_[1]->setNote(agedNote(newest_.ir_age_ms, kUsualIrAge_ms));
  const bool held_value = std::isfinite(newest_.stiffness_N_per_mm) && !newest_.stiffness_observable;
  readouts_[2]->setNote(newest_.target_clamped ? tr("target limited") : held_value ? tr("last touch") : QString());
  readouts_[3]->setNote({});
  readouts_[4]->setNote(agedNote(newest_.robot_age_ms, kUsualRobotAge_ms));
}

void CurveView::follow() {
  for (CurveStrip* strip : strips_) strip->freeRange();
  window_.follow();
  sayFollowing();
}

void CurveView::pause() {
  window_.pause();
  sayFollowing();
}

void CurveView::togglePause() { window_.following() ? pause() : follow(); }

void CurveView::chooseSpan(double span_s) {
  window_.chooseSpan(span_s);
  for (QAbstractButton* button : spans_->buttons()) button->setChecked(button->text() == tr("%1 s").arg(span_s));
  sayFollowing();
}

void CurveView::sayFollowing() {
  dirty_ = true;
  const bool now = window_.following();
  follow_label_->setText(now ? tr("Following") : tr("Not following: press F to follow again"));
  follow_label_->setProperty("role", now ? "muted" : "warning");
  restyle(*follow_label_);
  follow_label_->setToolTip(follow_label_->text());
  follow_button_->setProperty("role", now ? "" : "warning");  // says it also where the words have no room
  restyle(*follow_button_);
  follow_button_->setText(now ? tr("Pause") : tr("Follow"));
  follow_button_->setIcon(icon(now ? QStringLiteral("pause") : QStringLiteral("follow")));
  follow_button_->setToolTip(now ? tr("Hold the picture still; measuring goes on (Space)")
                                 : tr("Follow the newest values (F)"));
  if (now != was_following_) emit followingChanged(now);
  was_following_ = now;
}

}  // namespace fyd::widgets
