// The result of a fit: its plot, its error against the limit, the verdict, and each value before and after.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

#include "app/console/calibrate/calibrate_records.h"
#include "app/console/calibrate/calibrate_step.h"
#include "widgets/curves/fit_plot.h"

namespace fyd::console {

class CalibrationFitPanel : public QFrame {
  Q_OBJECT
 public:
  explicit CalibrationFitPanel(QWidget* parent = nullptr);
  /// @param points taken so far; none: there is no verdict yet
  /// @param error_limit as CalibrationStep::errorLimit()
  /// @param profile with the values in force
  void setFit(const CalibrationFit& fit, std::size_t points, std::string_view error_limit, station::Profile profile);
  [[nodiscard]] AcceptedWords words() const;
  /// Offers the name of the last calibration while the field is empty; it is taken only by a click. Empty: none.
  void offerName(const QString& name);
  /// Points to the field of who measured.
  void askWho();

  [[nodiscard]] QString verdict() const { return verdict_->text(); }
  [[nodiscard]] QString figures() const { return figures_->text(); }
  [[nodiscard]] QTableWidget* changes() const { return changes_; }
  /// What was fitted, each with its standard uncertainty.
  [[nodiscard]] QTableWidget* coefficients() const { return coefficients_; }
  [[nodiscard]] widgets::FitPlot* plot() const { return plot_; }
  [[nodiscard]] QLineEdit* who() const { return who_; }
  [[nodiscard]] QPushButton* offeredName() const { return offered_; }
  [[nodiscard]] QLineEdit* conditions() const { return conditions_; }

 private:
  void refreshOffer();
  QTableWidget* buildTable(const QString& name, const QString& words, const QStringList& headings);
  void setCoefficients(const std::vector<calibration::Coefficient>& coefficients);
  void setChanges(const calibration::CalibrationResult& result, station::Profile& profile);

  widgets::FitPlot* plot_ = nullptr;
  QLabel* legend_ = nullptr;
  QLabel* verdict_ = nullptr;
  QLabel* figures_ = nullptr;
  QTableWidget* changes_ = nullptr;
  QTableWidget* coefficients_ = nullptr;
  QLineEdit* who_ = nullptr;
  QPushButton* offered_ = nullptr;  ///< takes the name of the last calibration
  QLineEdit* conditions_ = nullptr;
  QString last_name_;
};

}  // namespace fyd::console
