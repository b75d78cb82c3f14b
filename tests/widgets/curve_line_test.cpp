// A curve's own way of drawing against QCustomPlot's: the same line at every scale, whatever its points are.
#include <QtTest>
#include <cmath>
#include <random>

#include "tests/widgets/suite.h"
#include "widgets/curves/curve_line.h"

namespace fyd::tests {
namespace {

constexpr int kWidth = 300;
constexpr int kHeight = 120;
constexpr int kMargin = 8;
const QColor kLine = Qt::red;

struct Drawing {
  const char* name;
  QVector<QCPGraphData> points;
};

QVector<QCPGraphData> noise(int count, double height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-height, height);
  QVector<QCPGraphData> out;
  for (int i = 0; i < count; ++i) out.append({-10.0 + 10.0 * i / (count - 1), value(random)});
  return out;
}

std::vector<Drawing> drawings() {
  const double nan = std::nan("");
  QVector<QCPGraphData> slow;
  for (int i = 0; i <= 600; ++i) slow.append({-10.0 + i / 60.0, 0.9 * std::sin(0.01 * i)});
  QVector<QCPGraphData> gaps = noise(300, 0.8, 7);
  for (int i = 20; i < 300; i += 23) gaps[i].value = nan;
  return {{"noise, two points a column", noise(600, 0.9, 1)},
          {"noise, one in three columns", noise(100, 0.9, 2)},
          {"noise, twenty points", noise(20, 0.9, 3)},
          {"slow", slow},
          {"level", {{-10.0, 0.3}, {0.0, 0.3}}},
          {"one step", {{-10.0, -0.5}, {-5.0, -0.5}, {-5.0, 0.5}, {0.0, 0.5}}},
          {"gaps", gaps},
          {"level from far left to far right", {{-1e6, 0.3}, {1e6, 0.3}}},
          {"from far left to far right", {{-1e6, -1.0}, {1e6, 1.0}}},
          {"far above and below", {{-8.0, 0.0}, {-6.0, 1e12}, {-4.0, 0.0}, {-3.0, -1e12}, {-1.0, 0.0}}}};
}

QImage pictureOf(QCPGraph* (*make)(QCustomPlot&), const QVector<QCPGraphData>& points, double scale, const QPen& pen) {
  QCustomPlot plot;
  plot.setPlottingHints(QCP::phFastPolylines);
  plot.setNotAntialiasedElements(QCP::aeAll);
  for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) axis->setVisible(false);
  plot.axisRect()->setAutoMargins(QCP::msNone);
  plot.axisRect()->setMargins(QMargins(kMargin, kMargin, kMargin, kMargin));
  QCPGraph* graph = make(plot);
  graph->setAdaptiveSampling(false);
  graph->setPen(pen);
  graph->data()->set(points, true);
  plot.xAxis->setRange(-10.0, 0.0);
  plot.yAxis->setRange(-1.0, 1.0);
  QImage image(QSize(kWidth, kHeight) * scale, QImage::Format_RGB32);
  image.setDevicePixelRatio(scale);
  image.fill(Qt::white);
  QCPPainter painter(&image);
  plot.toPainter(&painter, kWidth, kHeight);
  painter.end();
  return image;
}

QImage ours(const QVector<QCPGraphData>& points, double scale, const QPen& pen = QPen(kLine, 1)) {
  return pictureOf([](QCustomPlot& plot) -> QCPGraph* { return new widgets::CurveLine(plot.xAxis, plot.yAxis); },
                   points, scale, pen);
}

QImage theirs(const QVector<QCPGraphData>& points, double scale, const QPen& pen = QPen(kLine, 1)) {
  return pictureOf([](QCustomPlot& plot) { return plot.addGraph(); }, points, scale, pen);
}

bool near(const QImage& image, QPoint at, int distance) {
  for (int y = at.y() - distance; y <= at.y() + distance; ++y) {
    for (int x = at.x() - distance; x <= at.x() + distance; ++x) {
      if (image.valid(x, y) && image.pixel(x, y) == kLine.rgb()) return true;
    }
  }
  return false;
}

std::vector<QPoint> pixelsOf(const QImage& image) {
  std::vector<QPoint> out;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.pixel(x, y) == kLine.rgb()) out.emplace_back(x, y);
    }
  }
  return out;
}

/// How many pixels of `image` have no pixel of `other` near them. What is cut off at the sides is not looked at.
std::size_t strays(const QImage& image, const QImage& other, int distance) {
  const double side = image.devicePixelRatio() * kMargin + distance;
  std::size_t out = 0;
  for (const QPoint& at : pixelsOf(image)) {
    if (at.x() < side || at.x() > image.width() - side) continue;
    out += near(other, at, distance) ? 0 : 1;
  }
  return out;
}

}  // namespace

class CurveLineTest : public QObject {
  Q_OBJECT
 private slots:
  void theLineIsWhereQCustomPlotDrawsIt_data() {
    QTest::addColumn<double>("scale");
    for (const double scale : {1.0, 1.25, 1.5, 2.0, 3.0}) {
      QTest::newRow(qPrintable(QString::number(100 * scale) + QStringLiteral(" %"))) << scale;
    }
  }
  void theLineIsWhereQCustomPlotDrawsIt() {
    QFETCH(double, scale);
    for (const Drawing& each : drawings()) {
      const QImage a = ours(each.points, scale);
      const QImage b = theirs(each.points, scale);
      QVERIFY2(!pixelsOf(a).empty(), each.name);
      // QCustomPlot rounds a line's ends before it draws it, which shifts a steep line by up to a pixel of the layout.
      const int distance = static_cast<int>(std::ceil(scale)) + 1;
      QVERIFY2(strays(a, b, distance) == 0, each.name);
      QVERIFY2(strays(b, a, distance) == 0, each.name);
    }
  }

  void aSampleBetweenTwoGapsIsADot() {
    const double nan = std::nan("");
    const QImage image = ours({{-8.0, 0.5}, {-7.0, nan}, {-5.0, 0.0}, {-3.0, nan}, {-2.0, 0.5}}, 1.0);
    QCOMPARE(pixelsOf(image).size(), 3U);
    QVERIFY(near(image, {kWidth / 2, kHeight / 2}, 1));
  }

  void aSpikeOfOneSampleHasItsFullHeight() {
    for (const double scale : {1.0, 2.0}) {
      QVector<QCPGraphData> points;
      for (int i = 0; i <= 3000; ++i) points.append({-10.0 + i / 300.0, i == 1700 ? 1.0 : 0.0});
      int highest = kHeight;
      for (const QPoint& at : pixelsOf(ours(points, scale))) highest = std::min(highest, at.y());
      QVERIFY(std::abs(highest - kMargin * scale) <= scale);
    }
  }

  void dashedAndTranslucentLinesAreQCustomPlots() {
    const QVector<QCPGraphData> points = noise(100, 0.9, 5);
    QColor faint = kLine;
    faint.setAlphaF(0.5F);
    for (const QPen& pen : {QPen(kLine, 1, Qt::DashLine), QPen(kLine, 1, Qt::DotLine), QPen(faint, 1)}) {
      QCOMPARE(ours(points, 1.0, pen), theirs(points, 1.0, pen));
    }
  }

  void nothingToDrawIsNothingDrawn() {
    const double nan = std::nan("");
    const double infinite = std::numeric_limits<double>::infinity();
    QVERIFY(pixelsOf(ours({}, 1.0)).empty());
    QVERIFY(pixelsOf(ours({{-5.0, nan}, {-4.0, nan}}, 1.0)).empty());
    QVERIFY(pixelsOf(ours({{-5.0, infinite}, {-4.0, -infinite}}, 2.0)).empty());
  }
};

std::unique_ptr<QObject> makeCurveLineTest() { return std::make_unique<CurveLineTest>(); }

}  // namespace fyd::tests

#include "curve_line_test.moc"
