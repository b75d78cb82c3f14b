#include "widgets/curves/spectrum_view.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include <qcustomplot.h>

#include "core/base/units.h"
#include "widgets/basics/colour_scale.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/readout.h"
#include "widgets/curves/axis_scale.h"
#include "widgets/curves/curve_catalogue.h"
#include "widgets/curves/curve_plot.h"
#include "widgets/curves/plot_style.h"

namespace fyd::widgets {
namespace {

constexpr qint64 kRest_ms = 200;
constexpr double kFloor_dB = -80.0;    // far below what an accelerometer resolves
constexpr double kLeastLinear = 0.1;   // m/s²
constexpr double kMiddleColour = 0.7;  // share of the scale at which the curve's own colour stands
constexpr int kTitle_px = 16;          // above the picture: what its upright axis counts
constexpr int kLeastPicture_px = 20;
constexpr std::size_t kSignals[] = {kTextureSignal, kAccelerationX, kAccelerationY, kAccelerationZ};

}  // namespace

SpectrumView::SpectrumView(QWidget* parent)
    : QWidget(parent),
      signal_(new QComboBox(this)),
      scale_(new QComboBox(this)),
      words_(new QLabel(this)),
      spectrum_(new CurvePlot(this)),
      spectrogram_(new CurvePlot(this)),
      map_(new QCPColorMap(spectrogram_->xAxis, spectrogram_->yAxis)),
      colours_(new ColourScale(this)),
      frequency_scale_(std::make_unique<LevelScale>(*spectrum_)),
      time_scale_(std::make_unique<LevelScale>(*spectrogram_)) {
  setAccessibleName(tr("Spectrum of the vibration"));
  build();
  later_.setSingleShot(true);
  connect(&later_, &QTimer::timeout, this, &SpectrumView::changed);
  connect(&Look::instance(), &Look::changed, this, &SpectrumView::dress);
  dress();
}

SpectrumView::~SpectrumView() = default;

QCustomPlot* SpectrumView::timePlot() const { return spectrogram_; }

/// @param beside in the column of the readouts. @return what its upright axis counts, written above it
QCPItemText* SpectrumView::addPlot(CurvePlot* plot, QWidget* beside) {
  plot->setMinimumHeight(kTitle_px + kTimeScale_px + kLeastPicture_px);
  plot->setFocusPolicy(Qt::NoFocus);
  plot->setPlottingHints(QCP::phFastPolylines);
  plot->setNotAntialiasedElements(QCP::aeAll);
  plot->axisRect()->setAutoMargins(QCP::msNone);
  plot->axisRect()->setMargins(QMargins(kCurveLeft_px, kTitle_px, kCurveRight_px, kTimeScale_px));
  plot->yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(*plot->yAxis)));
  plot->yAxis->ticker()->setTickCount(3);
  auto* title = new QCPItemText(plot);
  title->setClipToAxisRect(false);
  title->position->setType(QCPItemPosition::ptViewportRatio);
  title->position->setCoords(0.0, 0.0);
  title->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
  title->setPadding({4, 0, 0, 0});
  beside->setFixedWidth(Readout::columnWidth());
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid);
  row->addWidget(plot, 1);
  row->addWidget(beside);
  static_cast<QVBoxLayout*>(layout())->addLayout(row, 1);
  return title;
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
  level_title_ = addPlot(spectrum_, new QWidget(this));
  frequency_title_ = addPlot(spectrogram_, colours_);
  frequency_title_->setText(tr("Frequency, Hz"));
  frequency_scale_->setTitle(tr("Frequency, Hz"));
  colours_->setMargins(kTitle_px, kTimeScale_px);
  spectrum_->setAccessibleName(tr("Amplitude over frequency, Hz"));
  spectrogram_->setAccessibleName(tr("Frequency over time, Hz over s"));
  spectrum_->addGraph();
  map_->setInterpolate(false);
}

void SpectrumView::dress() {
  const Theme& t = theme();
  for (CurvePlot* plot : {spectrum_, spectrogram_}) {
    plot->setPlotBackground(t.panel);
    styleAxes({plot->xAxis, plot->yAxis});
  }
  for (QCPItemText* title : {level_title_, frequency_title_}) {
    title->setFont(textFont(TextSize::small));
    title->setColor(t.muted);
  }
  frequency_scale_->dress();
  time_scale_->dress();
  spectrum_->graph()->setPen(QPen(t.of(Quantity::vibration), 1));
  QCPColorGradient gradient;
  gradient.clearColorStops();
  gradient.setColorStopAt(0.0, t.panel);
  gradient.setColorStopAt(kMiddleColour, t.of(Quantity::vibration));
  gradient.setColorStopAt(1.0, t.text);
  gradient.setNanHandling(QCPColorGradient::nhNanColor);
  gradient.setNanColor(t.line);
  map_->setGradient(gradient);
  colours_->setColours({{0.0, t.panel}, {kMiddleColour, t.of(Quantity::vibration)}, {1.0, t.text}});
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
  const QString unit = scale_->currentText();
  level_title_->setText(tr("Amplitude, %1").arg(unit));
  colours_->setScale(spectrum_->yAxis->range().lower, spectrum_->yAxis->range().upper, unit);
  spectrum_->update();
}

void SpectrumView::drawSpectrogram(const TimeWindow& window) {
  time_scale_->showTime(window);
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
  spectrogram_->update();
}

}  // namespace fyd::widgets
