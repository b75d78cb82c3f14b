// Words beside points of a plot, such as the values at a cursor; none lies on another, nor on any text that the plot
// holds. One for which there is no room is left out.
#pragma once

#include <QColor>
#include <QString>
#include <vector>

#include <qcustomplot.h>

namespace fyd::widgets {

/// A label that wants to stand beside a point; without a size it wants no place.
struct LabelWish {
  QPoint at;
  QSize size;
};

/// @param taken where nothing may lie
/// @return one for each wish, as near to its point as there is room; empty where there is none
[[nodiscard]] std::vector<QRect> placeLabels(const QRect& inside, std::vector<QRect> taken,
                                             const std::vector<LabelWish>& wishes);

struct PlotLabel {
  double at = 0.0;      ///< on the level axis; outside of its range it is not shown
  double height = 0.0;  ///< on the upright axis; outside of its range it stands at the edge
  QString text;
  QColor colour;
};

/// Owned by the plot; placed anew with each drawing.
class PlotLabels : public QCPLayerable {
 public:
  explicit PlotLabels(QCustomPlot& plot);
  /// The first have the choice.
  void show(std::vector<PlotLabel> labels) { labels_ = std::move(labels); }
  [[nodiscard]] const std::vector<PlotLabel>& labels() const { return labels_; }
  /// Where each stands; empty: it has no room.
  [[nodiscard]] std::vector<QRect> places() const;

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  std::vector<PlotLabel> labels_;
};

}  // namespace fyd::widgets
