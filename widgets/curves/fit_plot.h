// A calibration's fit: the points, the new curve and the one in force, and below them the residuals.
//
// Outliers differ by their shape, not by colour alone.
#pragma once

#include <QLabel>
#include <QPointF>
#include <QString>
#include <QWidget>
#include <vector>

class QCPAxisRect;
class QCPErrorBars;
class QCPGraph;
class QCustomPlot;

namespace fyd::widgets {

/// A level with its interval, such as the stiffness at one angle.
struct FitBar {
  double x = 0.0;
  double low = 0.0;
  double high = 0.0;
};

struct FitView {
  QString x_title;  ///< with its unit
  QString y_title;
  QString residual_title;
  std::vector<QPointF> points;
  std::vector<QPointF> curve;         ///< rising x; empty before there is a fit
  std::vector<QPointF> former_curve;  ///< of the values in force
  std::vector<double> residuals;      ///< one for each point; empty before there is a fit
  std::vector<std::size_t> outliers;  ///< rows of the points
  std::vector<FitBar> bars;
  QString empty_text;  ///< instruction shown in place of the plot while there is nothing to draw
};

class FitPlot : public QWidget {
  Q_OBJECT
 public:
  explicit FitPlot(QWidget* parent = nullptr);
  void setFit(const FitView& view);
  [[nodiscard]] const FitView& fit() const { return view_; }
  [[nodiscard]] QCustomPlot* plot() const { return plot_; }
  [[nodiscard]] bool empty() const { return !empty_->isHidden(); }

 private:
  void dress();
  QCPGraph* addGraph(QCPAxisRect* rect);

  FitView view_;
  QCustomPlot* plot_ = nullptr;
  QLabel* empty_ = nullptr;
  QCPAxisRect* above_ = nullptr;  ///< points and curves
  QCPAxisRect* below_ = nullptr;  ///< residuals
  QCPGraph* former_ = nullptr;
  QCPGraph* curve_ = nullptr;
  QCPGraph* points_ = nullptr;
  QCPGraph* outliers_ = nullptr;
  QCPGraph* residuals_ = nullptr;
  QCPGraph* outlier_residuals_ = nullptr;
  QCPGraph* levels_ = nullptr;  ///< of the bars
  QCPErrorBars* intervals_ = nullptr;
};

}  // namespace fyd::widgets
