// Numbers and names along an axis, of which only those are written that have room: nothing is cut off at the plot's
// edge, and no text lies on another.
#pragma once

#include <qcustomplot.h>
#include <QString>

namespace fyd::widgets {

class TimeWindow;

/// Takes away the labels of ticks that would lie on each other or reach beyond the plot, evenly.
/// @param before_px,after_px of a level axis: where other text stands at the plot's left and right end
void keepLabelsWithRoom(const QCPAxis& axis, const QVector<double>& ticks, QVector<QString>& labels, int before_px = 0,
                        int after_px = 0);

/// "−8" rather than "-8", with the decimals that the distance of the ticks needs and the language's decimal sign.
class NumberTicker : public QCPAxisTicker {
 public:
  /// @param axis must outlive this
  explicit NumberTicker(const QCPAxis& axis) : axis_(&axis) {}
  /// @param at_zero number written where the axis has its zero
  void setShown(double at_zero) {
    at_zero_ = at_zero;
    setTickOrigin(-at_zero);
  }
  /// After each number, such as " s".
  void setUnit(const QString& unit) { unit_ = unit; }
  void setEnds(int before_px, int after_px) {
    before_px_ = before_px;
    after_px_ = after_px;
  }
  void generate(const QCPRange& range, const QLocale& locale, QChar format, int precision, QVector<double>& ticks,
                QVector<double>* sub_ticks, QVector<QString>* labels) override;

 private:
  const QCPAxis* axis_ = nullptr;
  double at_zero_ = 0.0;
  QString unit_;
  int before_px_ = 0;
  int after_px_ = 0;
};

/// Names at an axis, such as those of lanes.
class NameTicker : public QCPAxisTickerText {
 public:
  explicit NameTicker(const QCPAxis& axis) : axis_(&axis) {}
  void generate(const QCPRange& range, const QLocale& locale, QChar format, int precision, QVector<double>& ticks,
                QVector<double>* sub_ticks, QVector<QString>* labels) override;

 private:
  const QCPAxis* axis_ = nullptr;
};

/// The level axis of a plot, with what it counts written at its left end, and a word at its right end.
class LevelScale {
 public:
  /// @param plot must outlive this; it gets the texts
  explicit LevelScale(QCustomPlot& plot);
  /// Without numbers and words the plot has that room.
  void setVisible(bool visible);
  void setTitle(const QString& title);
  /// Live: "−10 s … now". Looked back: the session's time, and that it is. The axis counts from its right end.
  void showTime(const TimeWindow& window);
  /// In the colours of the theme.
  void dress();

 private:
  void setTexts(const QString& title, const QString& end);
  /// Shows the texts, and keeps numbers away from them.
  void arrange();

  QCustomPlot* plot_ = nullptr;
  QSharedPointer<NumberTicker> numbers_;
  QCPItemText* title_ = nullptr;
  QCPItemText* end_ = nullptr;
  bool visible_ = true;
};

}  // namespace fyd::widgets
