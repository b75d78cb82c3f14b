// A whole recording in one strip: one quantity's min/max envelope, touches as bars, events, gaps and notes as marks, an
// outline around the time that the curves show, the cursor.
#pragma once

#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "widgets/basics/theme.h"
#include "widgets/curves/curve_source.h"

namespace fyd::widgets {

enum class OverviewMarkKind { event, alarm, gap, note };

struct OverviewMark {
  double time_s = 0.0;
  OverviewMarkKind kind = OverviewMarkKind::event;
  QString text;
};

class SessionOverview : public QWidget {
  Q_OBJECT
 public:
  explicit SessionOverview(QWidget* parent = nullptr);

  void setDuration(double duration_s);
  void setTouches(std::vector<std::pair<double, double>> touches_s);
  void setMarks(std::vector<OverviewMark> marks);
  void setWindow(double from_s, double to_s);
  void setCursor_s(double time_s);
  /// Columns of one quantity over the whole recording, as many as the strip is wide.
  void setEnvelope(std::vector<CurveColumn> columns, Quantity quantity);
  [[nodiscard]] int plotWidth_px() const;
  [[nodiscard]] const std::vector<OverviewMark>& marks() const { return marks_; }
  [[nodiscard]] QSize sizeHint() const override { return {400, 9 * kGrid}; }
  [[nodiscard]] double timeAt(double x_px) const;
  [[nodiscard]] double xOf(double time_s) const;

 signals:
  void cursorAsked(double time_s);
  void windowAsked(double from_s, double to_s);  ///< dragged with the right button
  void resized();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void paintEnvelope(QPainter& painter, const QRectF& plot) const;
  void paintMarks(QPainter& painter, const QRectF& plot) const;
  [[nodiscard]] QRectF plotRect() const;

  double duration_s_ = 0.0;
  std::vector<std::pair<double, double>> touches_s_;
  std::vector<OverviewMark> marks_;
  std::vector<CurveColumn> envelope_;
  Quantity quantity_ = Quantity::force;
  double from_s_ = 0.0;
  double to_s_ = 0.0;
  double cursor_s_ = 0.0;
  std::optional<double> box_from_s_;
  double box_to_s_ = 0.0;
};

}  // namespace fyd::widgets
