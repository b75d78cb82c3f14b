// The raw reading of what is being calibrated, over the last half minute, with the points taken marked: as dots where
// they were taken, and as short lines at the right edge for every point there is, so that gaps in the coverage show.
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

class QCPGraph;
class QCustomPlot;

namespace fyd::widgets {

class LiveTrace : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kPublishPeriod_s = 30.0;
  static constexpr std::size_t kMostSignals = 4;

  explicit LiveTrace(QWidget* parent = nullptr);
  /// Clears everything. @param signals_shown names, at most kMostSignals; all in one unit
  void restart(const QStringList& signals_shown, const QString& unit);
  /// One reading of all signals. @param time_s rising; NaN values are gaps
  void add(double time_s, const std::vector<double>& values);
  /// A point was taken at the first signal's newest value.
  void mark();
  /// The first signal's reading at every point there is.
  void setLevels(const std::vector<double>& readings);

  [[nodiscard]] int shown() const;   ///< readings that are drawn
  [[nodiscard]] int marked() const;  ///< dots that are drawn
  [[nodiscard]] QSize sizeHint() const override { return {300, 120}; }

 private:
  void dress();
  void draw();

  QCustomPlot* plot_ = nullptr;
  std::vector<QCPGraph*> traces_;
  QCPGraph* marks_ = nullptr;
  QCPGraph* levels_ = nullptr;
  std::vector<double> level_readings_;
  double now_s_ = 0.0;
  double newest_ = 0.0;
};

}  // namespace fyd::widgets
