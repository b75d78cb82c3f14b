#include "widgets/curves/spectrum_view.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include <qcustomplot.h>

#include "core/base/units.h"
#include "widgets/basics/number_text.h"
#include "widgets/curves/curve_catalogue.h"
#include "widgets/curves/plot_style.h"

namespace fyd::widgets {
namespace {

constexpr qint64 kRest_ms = 200;
constexpr double kFloor_dB = -80.0;   // far below what an accelerometer resolves
constexpr double kLeastLinear = 0.1;  // m/s²
constexpr std::size_t kSignals[] = {kTextureSignal, kAccelerationX, kAccelerationY, kAccelerationZ};

}  // namespace

SpectrumView::SpectrumView(QWidget* parent)
    : QWidget(parent),
      signal_(new QComboBox(this)),
      scale_(new QComboBox(this)),
      words_(new QLabel(this)),
      spectrum_(new QCustomPlot(this)),
      spectrogram_(new QCustomPlot(this)),
      map_(new QCPColorMap(spectrogram_->xAxis, spectrogram_->yAxis)) {
  setAccessibleName(tr("Spectrum of the vibration"));
  build();
  later_.setSingleShot(true);
  connect(&later_, &QTimer::timeout, this, &SpectrumView::changed);
  connect(&Look::instance(), &Look::changed, this, &SpectrumView::dress);
  dress();
}

void SpectrumView::build() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid / 2, kGrid, kGrid / 2);
  layout->setSpacing(kGrid / 2);
  auto* bar = new QHBoxLayout;
  bar->setSpacing(kGrid / 2);
  signal_->setObjectName(QStringLiteral("spectrum_signal"));
  signal_->setAccessibleName(tr("Signal of the spectrum"));
  signal_->addItem(tr("Texture signal"));
  for (const char* axis : {"x", "y", "z"}) signal_->addItem(tr("Acceleration %1").arg(QLatin1String(axis)));
  scale_->setObjectName(QStringLiteral("spectrum_scale"));
  scale_->setAccessibleName(tr("Scale of the spectrum"));
  scale_->addItems({tr("dB re 1 m/s²"), tr("m/s²")});
  words_->setObjectName(QStringLiteral("spectrum_words"));
  words_->setFont(textFont(TextSize::small));
  words_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  for (QComboBox* box : {signal_, scale_}) {
    bar->addWidget(box);
    connect(box, &QComboBox::currentIndexChanged, this, &SpectrumView::changed);
  }
  bar->addWidget(words_, 1);
  layout->addLayout(bar);
  for (QCustomPlot* plot : {spectrum_, spectrogram_}) {
    plot->setMinimumHeight(6 * kGrid);
    plot->setFocusPolicy(Qt::NoFocus);
    plot->setPlottingHints(QCP::phFastPolylines);
    plot->setNotAntialiasedElements(QCP::aeAll);
    plot->axisRect()->setAutoMargins(QCP::msNone);
    plot->axisRect()->setMargins(QMargins(kCurveLeft_px, 4, kCurveRight_px, kTimeScale_px));
    plot->yAxis->ticker()->setTickCount(3);
    layout->addWidget(plot, 1);
  }
  spectrum_->setAccessibleName(tr("Amplitude over frequency, Hz"));
  spectrogram_->setAccessibleName(tr("Frequency over time, Hz over s"));
  spectrum_->addGraph();
  map_->setInterpolate(false);
}

void SpectrumView::dress() {
  const Theme& t = theme();
  for (QCustomPlot* plot : {spectrum_, spectrogram_}) {
    plot->setBackground(QBrush(t.panel));
    styleAxes({plot->xAxis, plot->yAxis});
  }
  spectrum_->graph()->setPen(QPen(t.of(Quantity::vibration), 1));
  QCPColorGradient gradient;
  gradient.clearColorStops();
  gradient.setColorStopAt(0.0, t.panel);
  gradient.setColorStopAt(0.7, t.of(Quantity::vibration));
  gradient.setColorStopAt(1.0, t.text);
  gradient.setNanHandling(QCPColorGradient::nhNanColor);
  gradient.setNanColor(t.line);
  map_->setGradient(gradient);
  words_->setProperty("role", "muted");
}

bool SpectrumView::decibels() const { return scale_->currentIndex() == 0; }

double SpectrumView::levelOf(double amplitude) const {
  if (!decibels() || !std::isfinite(amplitude)) return amplitude;
  return std::max(kFloor_dB, 20.0 * std::log10(std::max(amplitude, 1e-12)));
}

void SpectrumView::draw(const CurveSource& source, const TimeWindow& window, bool even_soon) {
  if (!isVisible()) return;
  if (!even_soon && since_.isValid() && since_.elapsed() < kRest_ms) {
    if (!later_.isActive()) later_.start(static_cast<int>(kRest_ms - since_.elapsed()));
    return;
  }
  later_.stop();
  since_.start();
  const std::size_t channel[] = {kSignals[static_cast<std::size_t>(std::max(0, signal_->currentIndex()))]};
  CurveRows rows = source.rows(channel, std::max(window.from_s(), window.to_s() - kLongest_s), window.to_s());
  for (float& value : rows.values.front()) value *= static_cast<float>(kStandardGravity);
  constexpr double kRate_Hz = 1000.0;  // of the step
  shown_ = signal::spectrogram(rows.time_s, rows.values.front(), kRate_Hz, kSegment);
  const std::vector<double> mean = shown_.mean();
  const auto largest = std::max_element(mean.begin(), mean.end());
  if (mean.empty() || !std::isfinite(*largest)) {
    words_->setText(tr("Half a second without a hole is needed."));
  } else {
    const double at_Hz = shown_.resolution_Hz * static_cast<double>(largest - mean.begin());
    words_->setText(
        tr("largest %1 at %2").arg(quantityText(*largest, 3, tr("m/s²")), quantityText(at_Hz, 0, tr("Hz"))));
  }
  words_->setToolTip(words_->text());
  drawSpectrum(mean);
  drawSpectrogram(window);
}

void SpectrumView::drawSpectrum(const std::vector<double>& mean) {
  QVector<QCPGraphData> points;
  double top = decibels() ? 0.0 : kLeastLinear;
  for (std::size_t k = 0; k < mean.size(); ++k) {
    points.append(QCPGraphData(shown_.resolution_Hz * static_cast<double>(k), levelOf(mean[k])));
    if (std::isfinite(mean[k])) top = std::max(top, levelOf(mean[k]));
  }
  spectrum_->graph()->data()->set(points, true);
  const double half_rate_Hz = shown_.bins == 0 ? 500.0 : shown_.resolution_Hz * static_cast<double>(shown_.bins - 1);
  spectrum_->xAxis->setRange(0.0, half_rate_Hz);
  spectrum_->yAxis->setRange(decibels() ? kFloor_dB : 0.0, decibels() ? 10.0 * std::ceil(top / 10.0 + 0.5) : 1.1 * top);
  spectrum_->replot(QCustomPlot::rpQueuedRefresh);
}

void SpectrumView::drawSpectrogram(const TimeWindow& window) {
  spectrogram_->xAxis->setRange(-window.span_s(), 0.0);
  const auto segments = static_cast<int>(shown_.segments());
  map_->setVisible(segments > 0);
  if (segments > 0) {
    const auto bins = static_cast<int>(shown_.bins);
    QCPColorMapData* cells = map_->data();
    if (cells->keySize() != segments || cells->valueSize() != bins) cells->setSize(segments, bins);
    const double first_s = shown_.first_time_s - window.to_s();
    const double half_rate_Hz = shown_.resolution_Hz * (bins - 1);
    cells->setRange({first_s, first_s + shown_.step_s * std::max(1, segments - 1)}, {0.0, half_rate_Hz});
    for (int s = 0; s < segments; ++s) {
      const auto levels = shown_.segment(static_cast<std::size_t>(s));
      for (int k = 0; k < bins; ++k) cells->setCell(s, k, levelOf(levels[static_cast<std::size_t>(k)]));
    }
    map_->setDataRange(spectrum_->yAxis->range());
    spectrogram_->yAxis->setRange(0.0, half_rate_Hz);
  }
  spectrogram_->replot(QCustomPlot::rpQueuedRefresh);
}

}  // namespace fyd::widgets
