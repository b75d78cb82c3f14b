// The vibration's frequencies: the spectrum of the stretch of time that the curves show, and below it the spectrogram,
// frequency over time, with the scale of its colours. Levels are amplitudes of a sine in m/s², linear or in
// dB re 1 m/s²; the axis ends at half the sampling rate, 500 Hz. The time axis lies below that of the curves, pixel by
// pixel: both have a column of the readouts' width at their right.
//
// Computed at most 5 times a second, separately from the curves, from at most a minute of samples.
#pragma once

#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "core/signal/spectrogram.h"
#include "widgets/curves/curve_source.h"
#include "widgets/curves/time_window.h"

class QCustomPlot;
class QCPColorMap;
class QCPItemText;

namespace fyd::widgets {

class ColourScale;
class CurvePlot;
class LevelScale;

class SpectrumView : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kLongest_s = 60.0;
  static constexpr int kSegment = 512;  ///< samples: 0.5 s, a bin every 2 Hz

  explicit SpectrumView(QWidget* parent = nullptr);
  ~SpectrumView() override;

  /// Shows the end of the window's stretch, at most kLongest_s of it. @param even_soon also when the last one was
  /// drawn less than a fifth of a second ago
  void draw(const CurveSource& source, const TimeWindow& window, bool even_soon = false);
  [[nodiscard]] QComboBox* signalBox() const { return signal_; }
  [[nodiscard]] QComboBox* scaleBox() const { return scale_; }
  /// "largest 2.50 m/s² at 125 Hz"; what is missing while there is nothing to show.
  [[nodiscard]] QString words() const { return words_->text(); }
  [[nodiscard]] const signal::Spectrogram& shown() const { return shown_; }
  /// Frequency over time.
  [[nodiscard]] QCustomPlot* timePlot() const;
  [[nodiscard]] const ColourScale* colourScale() const { return colours_; }

 signals:
  void changed();  ///< another signal or scale was chosen, or a redraw was postponed: draw, `even_soon`

 private:
  void build();
  QCPItemText* addPlot(CurvePlot* plot, QWidget* beside);
  void dress();
  void drawSpectrum(const std::vector<double>& level);
  void drawSpectrogram(const TimeWindow& window);
  [[nodiscard]] bool decibels() const;
  [[nodiscard]] double levelOf(double amplitude) const;

  QComboBox* signal_ = nullptr;
  QComboBox* scale_ = nullptr;
  QLabel* words_ = nullptr;
  CurvePlot* spectrum_ = nullptr;
  CurvePlot* spectrogram_ = nullptr;
  QCPColorMap* map_ = nullptr;
  ColourScale* colours_ = nullptr;
  std::unique_ptr<LevelScale> frequency_scale_;
  std::unique_ptr<LevelScale> time_scale_;
  QCPItemText* level_title_ = nullptr;
  QCPItemText* frequency_title_ = nullptr;
  signal::Spectrogram shown_;
  QElapsedTimer since_;
  QTimer later_;
};

}  // namespace fyd::widgets
