// A still or live picture in which a place is clicked or a rectangle is dragged; arrow keys move the place by a pixel.
#pragma once

#include <QImage>
#include <QPointF>
#include <QRect>
#include <QWidget>
#include <optional>
#include <vector>

namespace fyd::widgets {

enum class PickKind { place, rectangle };

class PicturePick : public QWidget {
  Q_OBJECT
 public:
  explicit PicturePick(QWidget* parent = nullptr);

  void setPicture(const QImage& picture);
  /// Words in place of a picture.
  void setEmptyText(const QString& text);
  /// No picture comes: what was shown is no longer so, and a place in it is none.
  void showMissing(const QString& text);
  void setKind(PickKind kind);
  /// What is marked beside the pick: places already taken, px of the picture.
  void setMarks(std::vector<QPointF> marks);
  void setPlace(std::optional<QPointF> place_px);
  void setRectangle(const QRect& rectangle_px);
  [[nodiscard]] const QString& emptyText() const { return empty_text_; }
  [[nodiscard]] const QImage& picture() const { return picture_; }
  [[nodiscard]] std::optional<QPointF> place() const { return place_; }
  [[nodiscard]] const QRect& rectangle() const { return rectangle_; }
  /// Where a pixel of the picture is drawn, in the widget.
  [[nodiscard]] QPointF drawnAt(QPointF picture_px) const;
  [[nodiscard]] QSize sizeHint() const override { return {320, 240}; }

 signals:
  void placePicked(QPointF picture_px);
  void rectanglePicked(QRect picture_px);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] QRectF target() const;
  [[nodiscard]] QPointF pictureAt(QPointF widget_px) const;
  void pick(QPointF picture_px);

  QImage picture_;
  QString empty_text_;
  PickKind kind_ = PickKind::place;
  std::vector<QPointF> marks_;
  std::optional<QPointF> place_;
  QRect rectangle_;
  std::optional<QPointF> pressed_;  ///< where a drag began, px of the picture
};

}  // namespace fyd::widgets
