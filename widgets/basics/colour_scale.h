// Which colour stands for which value: an upright bar with numbers and a unit, beside a picture whose colours are values.
#pragma once

#include <QGradient>
#include <QWidget>

namespace fyd::widgets {

class ColourScale : public QWidget {
  Q_OBJECT
 public:
  explicit ColourScale(QWidget* parent = nullptr);
  /// @param stops from the least value, 0, to the largest, 1
  void setColours(const QGradientStops& stops);
  void setScale(double least, double largest, const QString& unit);
  /// Above and below the bar, px, so that it stands beside the picture.
  void setMargins(int above_px, int below_px);
  [[nodiscard]] double least() const { return least_; }
  [[nodiscard]] double largest() const { return largest_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QGradientStops stops_;
  double least_ = 0.0;
  double largest_ = 1.0;
  QString unit_;
  int above_px_ = 0;
  int below_px_ = 0;
};

}  // namespace fyd::widgets
