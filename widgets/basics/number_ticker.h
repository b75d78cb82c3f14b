// The scale of a curve: "−8" rather than "-8", as the numbers beside the curves are typeset.
#pragma once

#include <QString>
#include <cmath>
#include <utility>

#include <qcustomplot.h>

namespace fyd::widgets {

class NumberTicker : public QCPAxisTicker {
 public:
  /// @param unit_at_zero written after the axis' zero; empty: none
  explicit NumberTicker(QString unit_at_zero = {}) : unit_at_zero_(std::move(unit_at_zero)) {}
  /// @param at_zero number written where the axis has its zero
  void setShown(double at_zero) {
    at_zero_ = at_zero;
    setTickOrigin(-at_zero);
  }

 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    const double shown = tick + at_zero_;
    // A rounding error around zero is shown as zero.
    QString text = QCPAxisTicker::getTickLabel(std::abs(shown) < 1e-9 ? 0.0 : shown, locale, format, precision);
    text.replace(QLatin1Char('-'), QChar(0x2212));
    return shown == 0.0 && !unit_at_zero_.isEmpty() ? text + QLatin1Char(' ') + unit_at_zero_ : text;
  }

 private:
  QString unit_at_zero_;
  double at_zero_ = 0.0;
};

}  // namespace fyd::widgets
