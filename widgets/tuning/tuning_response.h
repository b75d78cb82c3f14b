// Simulated step responses of the stiffness loop for sets of gains, with their figures side by side.
#pragma once

#include <QLabel>
#include <QPointF>
#include <QProgressBar>
#include <QWidget>
#include <array>
#include <vector>

#include "core/control/loop_prediction.h"

class QCPGraph;
class QCustomPlot;
class QGridLayout;

namespace fyd::widgets {

/// NaN where there is no such figure.
struct ResponseView {
  std::vector<QPointF> course;  ///< step response: x in s, y in % of the target
  double rise_s = 0.0;
  double settling_s = 0.0;
  double overshoot_percent = 0.0;
  double steady_error_percent = 0.0;
  double gain_margin = 0.0;  ///< infinite: no gain at all
  double phase_margin_deg = 0.0;
  control::LoopVerdict verdict = control::LoopVerdict::does_not_settle;
};

class TuningResponse : public QWidget {
  Q_OBJECT
 public:
  enum Which { current, saved, proposed };
  static constexpr int kCount = 3;

  explicit TuningResponse(QWidget* parent = nullptr);
  void setResponse(Which which, const ResponseView& view);
  void clearResponse(Which which);
  /// The model on which the responses are computed, as a sentence.
  void setPlotBackground(const QString& words);
  void setBusy(bool busy);

  /// The focus rests on the plot, where no key changes anything.
  void takeFocus();
  [[nodiscard]] QCustomPlot* plot() const { return plot_; }
  [[nodiscard]] bool has(Which which) const { return !views_[which].course.empty(); }
  [[nodiscard]] const ResponseView& response(Which which) const { return views_[which]; }
  /// As shown; "—" without one.
  [[nodiscard]] QString figure(Which which, int line) const {
    return cells_[which][static_cast<std::size_t>(line)]->text();
  }
  [[nodiscard]] QString ground() const { return ground_->text(); }

 private:
  static constexpr std::size_t kFigures = 7;
  void buildFigures(QGridLayout* grid);
  void dress();
  void display(Which which);
  void displayVerdict(Which which);

  QCustomPlot* plot_ = nullptr;
  std::array<QCPGraph*, kCount> graphs_{};
  QCPGraph* target_ = nullptr;
  QCPGraph* upper_ = nullptr;
  QCPGraph* lower_ = nullptr;
  std::array<std::array<QLabel*, kFigures>, kCount> cells_{};
  std::array<QLabel*, kCount> heads_{};
  std::array<ResponseView, kCount> views_;
  QLabel* ground_ = nullptr;
  QProgressBar* busy_ = nullptr;
};

}  // namespace fyd::widgets
