#include "app/console/review/review_curves.h"

#include <qcustomplot.h>

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/basics/core_text.h"

namespace fyd::console {
namespace {

using widgets::Stroke;
using widgets::TimeWindow;

constexpr int kRedraw_ms = 15;
constexpr int kLeastWidth = 56 * widgets::kGrid;  // beside axis and numerals a curve is still read

Stroke strokeOf(ReviewLayer layer, Stroke own) {
  if (layer == ReviewLayer::other) return Stroke::faint;
  return layer == ReviewLayer::what_if ? Stroke::dotted : own;
}

QString wordOf(ReviewLayer layer, const widgets::CurveQuantity& quantity) {
  QString own = widgets::wordOf(quantity);
  if (layer == ReviewLayer::session) return own;
  QString whose = layer == ReviewLayer::other ? ReviewCurves::tr("other") : ReviewCurves::tr("what if");
  return own.isEmpty() ? whose : whose + QLatin1Char(' ') + own;
}

}  // namespace

ReviewCurves::ReviewCurves(QWidget* parent)
    : QWidget(parent), stack_(new widgets::CurveStack(TimeWindow(std::numeric_limits<double>::max()), this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(widgets::kGrid, widgets::kGrid / 2, widgets::kGrid, widgets::kGrid / 2);
  layout->addWidget(stack_);
  setMinimumWidth(kLeastWidth);
  addStrips();
  // The window stays within the recording, as far as it is not longer than that.
  stack_->setBounds([this](TimeWindow& window) {
    const double span_s =
        std::clamp(window.span_s(), TimeWindow::kShortest_s, std::max(duration_s_, TimeWindow::kShortest_s));
    const double to_s = std::clamp(window.to_s(), span_s, std::max(duration_s_, span_s));
    window.show(to_s - span_s, to_s);
  });
  connect(stack_, &widgets::CurveStack::moved, this, [this] {
    redrawSoon();
    emit windowShown(window().from_s(), window().to_s());
  });
  connect(stack_, &widgets::CurveStack::clicked, this, &ReviewCurves::cursorAsked);
  connect(stack_, &widgets::CurveStack::followAsked, this, [this] {
    stack_->freeRanges();
    show(0.0, duration_s_);
  });
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &ReviewCurves::redraw);
}

void ReviewCurves::addStrips() {
  const QString acceleration = QStringLiteral("acceleration");  // hidden by default in a review
  for (const widgets::StripPlan& plan : widgets::stripPlans()) {
    widgets::StripSetup setup = widgets::setupOf(plan);
    if (setup.id == acceleration) setup.shown = false;
    for (const ReviewLayer layer : {ReviewLayer::other, ReviewLayer::session, ReviewLayer::what_if}) {
      // Lanes show only this session: three layers in one lane would hide each other.
      if (plan.lanes && layer != ReviewLayer::session) continue;
      for (const std::size_t channel : plan.channels) {
        const widgets::CurveQuantity& q = widgets::curveQuantities()[channel];
        setup.traces.push_back({.channel = ReviewSource::channel(layer, channel),
                                .quantity = q.quantity,
                                .stroke = strokeOf(layer, q.stroke),
                                .lane = plan.lanes ? widgets::wordOf(q) : QString(),
                                .word = wordOf(layer, q),
                                .decimals = q.decimals});
      }
    }
    for (std::size_t& channel : setup.channels) channel = ReviewSource::channel(ReviewLayer::session, channel);
    stack_->add(std::move(setup));
    stack_->strip(stack_->size() - 1)
        ->plot()
        ->setToolTip(tr("Drag to look elsewhere, wheel to zoom, drag with the right button to zoom into a box,\n"
                        "Ctrl and wheel to stretch this curve, double-click for the whole session."));
  }
}

void ReviewCurves::show(double from_s, double to_s) {
  stack_->forEachWindow([=](TimeWindow& window) { window.show(from_s, to_s); });
}

void ReviewCurves::setCursor_s(double time_s) {
  const double cursor_s = std::clamp(std::isfinite(time_s) ? time_s : 0.0, 0.0, duration_s_);
  stack_->setCursor_s(cursor_s);
  if (cursor_s < window().from_s() || cursor_s > window().to_s()) {
    const double span_s = window().span_s();
    show(cursor_s - 0.1 * span_s, cursor_s + 0.9 * span_s);
  }
}

void ReviewCurves::redrawSoon() {
  if (!timer_.isActive()) timer_.start(kRedraw_ms);
}

void ReviewCurves::redraw() {
  timer_.stop();
  stack_->draw(source_);
  emit drawn();
  if (const Message what = source_.takeProblem(); !what.empty()) emit problem(widgets::coreText(what));
}

}  // namespace fyd::console
