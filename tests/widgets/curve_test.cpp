// The curves: nothing is lost by decimation, gaps stay gaps, following and panning, what the numerals say.
#include <QSignalSpy>
#include <cmath>
#include <random>

#include <qcustomplot.h>

#include "tests/widgets/suite.h"
#include "tests/widgets/wait.h"
#include "widgets/basics/number_text.h"
#include "widgets/curves/axis_scale.h"
#include "widgets/curves/curve_buffer.h"
#include "widgets/curves/curve_view.h"
#include "widgets/curves/recent_value.h"
#include "widgets/curves/value_range.h"

namespace fyd::tests {
namespace {

using widgets::CurveBuffer;
using widgets::CurveColumn;

constexpr int kDrawn_ms = 100;  // several times as long as a redraw waits

/// What the pyramid must give, by looking at every sample.
CurveColumn bruteForce(const std::vector<double>& times, const std::vector<float>& values, double left_s,
                       double right_s) {
  CurveColumn out;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] < left_s || times[i] >= right_s) continue;
    out.empty = false;
    if (std::isnan(values[i])) {
      out.gap = true;
      continue;
    }
    out.minimum = std::isnan(out.minimum) ? values[i] : std::min(out.minimum, values[i]);
    out.maximum = std::isnan(out.maximum) ? values[i] : std::max(out.maximum, values[i]);
  }
  return out;
}

bool same(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

std::vector<pipeline::TelemetrySample> ramp(int count, double from_s = 0.0) {
  std::vector<pipeline::TelemetrySample> out(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].now = instantAt(1.0 + from_s + 0.001 * static_cast<double>(i));
    out[i].force_N = 1.5;
    out[i].indentation_mm = 2.0;
  }
  return out;
}

}  // namespace

class CurveTest : public QObject {
  Q_OBJECT
 private slots:
  void oneSampleSpikeIsSeenAtEveryZoom() {
    CurveBuffer buffer(1, 65536);
    const std::size_t samples = 200000;  // three times round the ring
    const std::size_t spikes[] = {150001, 163839, 163840, 180000, 199999};
    for (std::size_t i = 0; i < samples; ++i) {
      const bool spike = std::find(std::begin(spikes), std::end(spikes), i) != std::end(spikes);
      const float value[] = {spike ? 5.0F : 0.0F};
      QVERIFY(buffer.append(0.001 * static_cast<double>(i), value));
    }
    std::vector<CurveColumn> columns;
    for (const std::size_t spike : spikes) {
      const double at_s = 0.001 * static_cast<double>(spike);
      for (const double span_s : {0.005, 0.1, 1.0, 10.0, 60.0}) {
        for (const std::size_t width : {1U, 7U, 300U, 1000U}) {
          for (const double share : {0.01, 0.5, 0.93}) {
            buffer.decimate(0, at_s - share * span_s, at_s + (1.0 - share) * span_s, width, columns);
            const bool seen =
                std::any_of(columns.begin(), columns.end(), [](const auto& c) { return c.maximum == 5.0F; });
            QVERIFY2(seen,
                     qPrintable(QStringLiteral("spike %1, span %2 s, %3 columns").arg(spike).arg(span_s).arg(width)));
          }
        }
      }
    }
  }

  void columnsEqualThoseOfEverySampleLookedAt() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(-3.0F, 3.0F);
    std::uniform_real_distribution<double> step_s(0.0002, 0.003);
    CurveBuffer buffer(2, 65536);
    std::vector<double> times;
    std::vector<float> values;
    double t = 0.0;
    for (int i = 0; i < 90000; ++i) {
      t += step_s(random);
      const float v = random() % 97 == 0 ? std::numeric_limits<float>::quiet_NaN() : value(random);
      const float row[] = {v, -v};
      QVERIFY(buffer.append(t, row));
      times.push_back(t);
      values.push_back(v);
    }
    times.erase(times.begin(), times.end() - 65536);
    values.erase(values.begin(), values.end() - 65536);
    QCOMPARE(buffer.size(), std::size_t{65536});
    QCOMPARE(buffer.firstTime_s(), times.front());
    std::vector<CurveColumn> columns;
    for (const auto& [span_s, width] : {std::pair{100.0, 50U}, std::pair{3.0, 40U}, std::pair{0.01, 30U}}) {
      buffer.decimate(0, t - span_s, t, width, columns);
      QVERIFY(columns.size() >= width);
      const double half = 0.5 * span_s / width;
      for (const CurveColumn& column : columns) {
        // The edges are multiples of the width, computed as the buffer states it.
        const double index = std::floor(column.time_s / (2.0 * half));
        const CurveColumn wanted = bruteForce(times, values, index * 2.0 * half, index * 2.0 * half + 2.0 * half);
        QVERIFY(same(column.minimum, wanted.minimum) && same(column.maximum, wanted.maximum));
        QCOMPARE(column.gap, wanted.gap);
        QCOMPARE(column.empty, wanted.empty);
      }
    }
  }

  void gapsAndHolesBreakTheLineAndAreNeverAveraged() {
    CurveBuffer buffer(1, 1000, 0.05);
    for (int i = 0; i < 1000; ++i) {
      const float row[] = {i == 500 ? std::numeric_limits<float>::infinity() : 1.0F};
      buffer.append(0.001 * i, row);
    }
    const float late[] = {1.0F};
    QVERIFY(buffer.append(2.0, late));  // 1 s without a sample
    QVERIFY(!buffer.append(2.0, late));
    QVERIFY(!buffer.append(1.5, late));
    QVERIFY(!buffer.append(std::nan(""), late));
    std::vector<CurveColumn> columns;
    buffer.decimate(0, 0.0, 2.1, 21, columns);
    int gaps = 0;
    for (const CurveColumn& column : columns) {
      gaps += column.gap ? 1 : 0;
      if (!std::isnan(column.minimum)) QCOMPARE(column.minimum, 1.0F);
      if (!std::isnan(column.maximum)) QCOMPARE(column.maximum, 1.0F);
    }
    QCOMPARE(gaps, 2);
  }

  void oddRequestsGiveNothing() {
    CurveBuffer buffer(1, 10);
    std::vector<CurveColumn> columns(3);
    buffer.decimate(0, 0.0, 1.0, 10, columns);
    QVERIFY(std::all_of(columns.begin(), columns.end(), [](const auto& c) { return c.empty; }));
    const float row[] = {1.0F};
    buffer.append(0.0, row);
    for (const auto& [from, to, width] :
         {std::tuple{1.0, 0.0, 10U}, std::tuple{0.0, std::nan(""), 10U}, std::tuple{0.0, 1.0, 0U}}) {
      buffer.decimate(0, from, to, width, columns);
      QVERIFY(columns.empty());
    }
    QVERIFY(std::isnan(CurveBuffer(1, 1).lastTime_s()));
  }

  void rangeGrowsAtOnceAndShrinksOnlyWhenMostlyEmpty() {
    widgets::ValueRange range({0, 2});
    QCOMPARE(range.fit(0.1, 1.9), (widgets::Range{0, 2}));
    const widgets::Range grown = range.fit(0.0, 7.3);
    QVERIFY(grown.upper >= 7.3 && grown.upper <= 8.0);
    QCOMPARE(range.fit(0.0, 5.0), grown);
    QCOMPARE(range.fit(std::nan(""), 1.0), grown);
    QCOMPARE(range.fit(0.0, 1.0), (widgets::Range{0, 2}));
  }

  void numbersReadAsAnOperatorReadsThem() {
    QCOMPARE(widgets::numberText(std::nan(""), 2), QStringLiteral("—"));
    QCOMPARE(widgets::numberText(-0.001, 2), QStringLiteral("0.00"));
    QCOMPARE(widgets::numberText(-1.5, 1), QStringLiteral("−1.5"));
    QCOMPARE(widgets::quantityText(std::nan(""), 2, QStringLiteral("N")), QStringLiteral("—"));
    QCOMPARE(widgets::ageText(4.2), QStringLiteral("4 ms"));
    QCOMPARE(widgets::ageText(1240.0), QStringLiteral("1.2 s"));
    QCOMPARE(widgets::durationText(185.0), QStringLiteral("3 min 05 s"));
    QCOMPARE(widgets::readNumber(QStringLiteral(" −1,5 ")), -1.5);
    QVERIFY(std::isnan(widgets::readNumber(QStringLiteral("1.2.3"))));
    QVERIFY(std::isnan(widgets::readNumber(QString())));
  }

  void numeralIsMeanOrPeakAndNoneWhenTheNewestIsNone() {
    widgets::RecentValue mean;
    mean.add(1.0);
    mean.add(3.0);
    QCOMPARE(mean.take(), 2.0);
    QVERIFY(std::isnan(mean.take()));
    mean.add(1.0);
    mean.add(std::nan(""));
    QVERIFY(std::isnan(mean.take()));
    widgets::RecentValue peak(widgets::RecentValue::Kind::peak);
    peak.add(-40.0);
    peak.add(10.0);
    QCOMPARE(peak.take(), 40.0);
  }

  void panningStopsFollowingSaysSoAndOneCallFollowsAgain() {
    widgets::CurveView view;
    view.resize(800, 500);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view, kPatience_ms));
    view.append(ramp(4000));
    passTimers(kDrawn_ms);
    QVERIFY(view.following());
    QWidget* plot = view.strip(0)->findChild<QWidget*>();
    const QPoint middle = plot->rect().center();
    QTest::mousePress(plot, Qt::LeftButton, {}, middle);
    QTest::mouseMove(plot, middle + QPoint(60, 0));
    QTest::mouseRelease(plot, Qt::LeftButton, {}, middle + QPoint(60, 0));
    QVERIFY(!view.following());
    QVERIFY(view.followText().contains(QStringLiteral("press F")));
    const double held_s = view.timeWindow().to_s();
    QVERIFY(held_s < view.buffer().lastTime_s());
    view.append(ramp(500, 4.0));
    QCOMPARE(view.timeWindow().to_s(), held_s);
    QTest::mouseDClick(plot, Qt::LeftButton, {}, middle);
    QVERIFY(view.following());
    QCOMPARE(view.timeWindow().to_s(), view.buffer().lastTime_s());
  }

  void theTimesOfASessionOfWeeksAreTheSessions() {
    QCustomPlot plot;
    plot.setViewport(QRect(0, 0, 900, 200));  // it is never shown
    plot.xAxis->setRange(-10.0, 0.0);
    plot.replot();
    widgets::NumberTicker ticker(*plot.xAxis);
    constexpr double kNow_s = 1'200'012.0;
    ticker.setShown(kNow_s);
    QVector<double> ticks;
    QVector<QString> labels;
    ticker.generate(plot.xAxis->range(), QLocale::c(), u'g', 6, ticks, nullptr, &labels);
    int written = 0;
    for (qsizetype i = 0; i < ticks.size(); ++i) {
      if (labels[i].isEmpty()) continue;
      QCOMPARE(widgets::readNumber(labels[i]), kNow_s + ticks[i]);
      ++written;
    }
    QVERIFY(written >= 2);
  }

  void aClickOfAnUnsteadyHandDoesNotStopTheCurvesAndADoubleClickIsNoClick() {
    widgets::CurveView view;
    view.resize(800, 500);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view, kPatience_ms));
    view.append(ramp(4000));
    passTimers(kDrawn_ms);
    QWidget* plot = view.strip(0)->findChild<QWidget*>();
    const QPoint middle = plot->rect().center();
    QSignalSpy clicked(view.strip(0), &widgets::CurveStrip::clicked);
    QTest::mousePress(plot, Qt::LeftButton, {}, middle);
    QTest::mouseMove(plot, middle + QPoint(1, 1));
    QTest::mouseRelease(plot, Qt::LeftButton, {}, middle + QPoint(1, 1));
    QVERIFY(view.following());
    QCOMPARE(clicked.size(), 1);
    QTest::mouseRelease(plot, Qt::LeftButton, {}, middle);  // the second of a double click: nothing was pressed
    QCOMPARE(clicked.size(), 1);
  }

  void wheelZoomsAndBoxShowsWhatItEncloses() {
    widgets::CurveView view;
    view.resize(800, 500);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view, kPatience_ms));
    view.append(ramp(12000));
    passTimers(kDrawn_ms);
    QWidget* plot = view.strip(0)->findChild<QWidget*>();
    const QPointF middle = plot->rect().center();
    QWheelEvent wheel(middle, plot->mapToGlobal(middle), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(plot, &wheel);
    QVERIFY(view.following());  // a closer look at the newest still follows
    QVERIFY(view.timeWindow().span_s() < 10.0);
    const widgets::Range before = view.strip(0)->shownRange();
    QWheelEvent stretch(middle, plot->mapToGlobal(middle), {}, QPoint(0, 120), Qt::NoButton, Qt::ControlModifier,
                        Qt::NoScrollPhase, false);
    QApplication::sendEvent(plot, &stretch);
    const widgets::Range once = view.strip(0)->shownRange();
    QApplication::sendEvent(plot, &stretch);  // before the next picture
    const widgets::Range twice = view.strip(0)->shownRange();
    QVERIFY(view.following());
    QVERIFY(once.upper - once.lower < before.upper - before.lower);
    QVERIFY(twice.upper - twice.lower < 0.9 * (once.upper - once.lower));
    QTest::mousePress(plot, Qt::RightButton, {}, QPoint(200, 10));
    QTest::mouseMove(plot, QPoint(300, 50));
    QTest::mouseRelease(plot, Qt::RightButton, {}, QPoint(300, 50));
    QVERIFY(!view.following());
    QVERIFY(view.timeWindow().span_s() < 2.5);
    const widgets::Range boxed = view.strip(0)->shownRange();
    view.follow();
    QCOMPARE(view.timeWindow().span_s(), 10.0);
    QVERIFY(view.strip(0)->shownRange() != boxed);
  }

  void spikeReachesThePicture() {
    widgets::CurveView view;
    view.resize(700, 400);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view, kPatience_ms));
    view.chooseSpan(60);
    std::vector<pipeline::TelemetrySample> samples = ramp(60000);
    samples[31234].force_N = 9.0;
    view.append(samples);
    WAIT_EQUAL(view.strip(0)->drawnExtent().upper, 9.0);
  }

  void silenceShowsNoOldNumbers() {
    widgets::CurveView view;
    view.show();
    double time_s = 0.0;
    const auto fed = [&] {  // until it is seen: half a second of silence, of a busy machine too, takes it away again
      view.append(ramp(100, time_s));
      time_s += 0.1;
      return view.readout(0)->valueText(0);
    };
    WAIT_EQUAL(fed(), QStringLiteral("1.50"));
    WAIT_EQUAL(view.readout(0)->valueText(0), QStringLiteral("—"));
    WAIT_EQUAL(view.readout(0)->note(), QStringLiteral("no data"));
  }

  void aForceWhoseReadingIsGoneIsNoneWhileTheSamplesGoOn() {
    widgets::CurveView view;
    view.show();
    double time_s = 0.0;
    const auto fed = [&](double age_ms) {
      auto samples = ramp(100, time_s);
      time_s += 0.1;
      for (pipeline::TelemetrySample& sample : samples) {
        sample.bridge_age_ms = age_ms;
        sample.stiffness_N_per_mm = 0.5;
        sample.target_clamped = true;
      }
      view.append(samples);
      return view.readout(0)->valueText(0);
    };
    WAIT_EQUAL(fed(10.0), QStringLiteral("1.50"));
    WAIT_EQUAL(fed(301.0), QStringLiteral("—"));
    QCOMPARE(view.readout(0)->note(), QStringLiteral("301 ms old"));
    QCOMPARE(view.readout(2)->note(), QStringLiteral("last touch, target limited"));
    WAIT_EQUAL(fed(10.0), QStringLiteral("1.50"));
  }
};

std::unique_ptr<QObject> makeCurveTest() { return std::make_unique<CurveTest>(); }

}  // namespace fyd::tests

#include "curve_test.moc"
