#include "app/console/review_curves.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/number_text.h"

namespace fyd::console {
namespace {

using widgets::Stroke;

constexpr int kRedraw_ms = 15;

Stroke strokeOf(ReviewLayer layer, bool target) {
  if (layer == ReviewLayer::other) return Stroke::faint;
  if (layer == ReviewLayer::what_if) return Stroke::dotted;
  return target ? Stroke::dashed : Stroke::solid;
}

}  // namespace

ReviewCurves::ReviewCurves(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(widgets::kGrid, widgets::kGrid / 2, widgets::kGrid, widgets::kGrid / 2);
  layout->setSpacing(0);
  addStrip(tr("Force"), tr("N"), {0, 2}, {0}, false);
  addStrip(tr("Indentation"), tr("mm"), {0, 5}, {1}, false);
  addStrip(tr("Stiffness"), tr("N/mm"), {0, 1}, {2, 3}, false);
  addStrip(tr("Vibration"), tr("%"), {-100, 100}, {4}, true);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &ReviewCurves::redraw);
}

void ReviewCurves::addStrip(const QString& title, const QString& unit, widgets::Range least,
                            std::vector<std::size_t> quantities, bool last) {
  std::vector<widgets::Trace> traces;
  for (const ReviewLayer layer : {ReviewLayer::other, ReviewLayer::session, ReviewLayer::what_if}) {
    for (const std::size_t quantity : quantities) {
      const ReviewQuantity& q = kReviewQuantities[quantity];
      traces.push_back({.channel = ReviewSource::channel(layer, quantity),
                        .quantity = q.quantity,
                        .stroke = strokeOf(layer, quantity == 3)});
    }
  }
  std::vector<widgets::Readout::Entry> entries;
  for (const std::size_t quantity : quantities) {
    const ReviewQuantity& q = kReviewQuantities[quantity];
    entries.push_back({.label = quantity == 3 ? tr("target") : QString(),
                       .quantity = q.quantity,
                       .dashed = quantity == 3,
                       .decimals = q.decimals});
  }
  auto* row = new QHBoxLayout;
  row->setSpacing(widgets::kGrid);
  auto* strip = new widgets::CurveStrip(title, unit, least, std::move(traces), last, this);
  strip->showTimeItself();
  auto* readout = new widgets::Readout(title, unit, std::move(entries), true, this);
  row->addWidget(strip, 1);
  row->addWidget(readout);
  static_cast<QVBoxLayout*>(layout())->addLayout(row, last ? 5 : 4);
  connect(strip, &widgets::CurveStrip::panned, this, [this](double by_s) {
    window_.pan(by_s);
    moveInto();
  });
  connect(strip, &widgets::CurveStrip::zoomed, this, [this](double factor, double about_s) {
    window_.pause();
    window_.zoom(factor, window_.to_s() + about_s);
    moveInto();
  });
  connect(strip, &widgets::CurveStrip::boxed, this,
          [this](double from_s, double to_s) { show(window_.to_s() + from_s, window_.to_s() + to_s); });
  connect(strip, &widgets::CurveStrip::clicked, this, [this](double at_s) { emit cursorAsked(window_.to_s() + at_s); });
  connect(strip, &widgets::CurveStrip::followAsked, this, [this] {
    for (widgets::CurveStrip* each : strips_) each->freeRange();
    show(0.0, duration_s_);
  });
  strips_.push_back(strip);
  readouts_.push_back(readout);
  quantities_.push_back(std::move(quantities));
}

void ReviewCurves::show(double from_s, double to_s) {
  window_.show(from_s, to_s);
  moveInto();
}

// The window stays within the recording, as far as it is not longer than that.
void ReviewCurves::moveInto() {
  const double span_s = std::clamp(window_.span_s(), widgets::TimeWindow::kShortest_s,
                                   std::max(duration_s_, widgets::TimeWindow::kShortest_s));
  const double to_s = std::clamp(window_.to_s(), span_s, std::max(duration_s_, span_s));
  window_.show(to_s - span_s, to_s);
  redrawSoon();
  emit windowShown(window_.from_s(), window_.to_s());
}

void ReviewCurves::setCursor_s(double time_s) {
  cursor_s_ = std::clamp(std::isfinite(time_s) ? time_s : 0.0, 0.0, duration_s_);
  if (cursor_s_ < window_.from_s() || cursor_s_ > window_.to_s()) {
    const double span_s = window_.span_s();
    show(cursor_s_ - 0.1 * span_s, cursor_s_ + 0.9 * span_s);
  }
  redrawSoon();
}

void ReviewCurves::setMark(int which, double time_s) {
  marks_s_[which] = time_s;
  redrawSoon();
}

void ReviewCurves::redrawSoon() {
  if (!timer_.isActive()) timer_.start(kRedraw_ms);
}

void ReviewCurves::redraw() {
  timer_.stop();
  std::vector<widgets::TimeMark> marks = {{.time_s = cursor_s_, .name = {}, .strong = true}};
  if (std::isfinite(marks_s_[0])) marks.push_back({.time_s = marks_s_[0], .name = tr("A")});
  if (std::isfinite(marks_s_[1])) marks.push_back({.time_s = marks_s_[1], .name = tr("B")});
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    strips_[i]->setMarks(marks);
    strips_[i]->draw(source_, window_);
    for (std::size_t entry = 0; entry < quantities_[i].size(); ++entry) {
      readouts_[i]->setValue(
          entry, source_.valueAt(ReviewSource::channel(ReviewLayer::session, quantities_[i][entry]), cursor_s_));
    }
  }
  if (const std::string what = source_.takeProblem(); !what.empty()) emit problem(QString::fromStdString(what));
}

}  // namespace fyd::console
