// State of the system's parts in one line: "Touchpad 250 Hz · 4 ms".
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

namespace fyd::widgets {

struct PartView {
  enum class Health { well, doubtful, missing };
  QString icon;     ///< name of an icon
  QString name;     ///< "Camera"
  QString figures;  ///< "30 Hz · 12 ms"; or what is wrong
  QString detail;   ///< tool tip: which device it is, what to do
  Health health = Health::missing;
  bool opens = false;  ///< a click shows more about it
  enum class Origin { none, real, simulated };
  Origin origin = Origin::none;  ///< of a device's values; none: it is no device
  friend bool operator==(const PartView&, const PartView&) = default;
};

class PartList : public QWidget {
  Q_OBJECT
 public:
  explicit PartList(QWidget* parent = nullptr);
  void setParts(const std::vector<PartView>& parts);
  [[nodiscard]] const std::vector<PartView>& parts() const { return parts_; }
  [[nodiscard]] QSize sizeHint() const override;
  /// Where a part is drawn; empty when there is none of that name.
  [[nodiscard]] QRect place(const QString& name) const;
  /// Where not all fits, a part that is well shows the first of its figures; the others stand in its tool tip.
  [[nodiscard]] QString shownFigures(const PartView& part) const;

 signals:
  void opened(const QString& name);  ///< a part that opens was clicked

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] std::vector<QRect> places() const;
  [[nodiscard]] int openingPartAt(const QPoint& where) const;  ///< -1: none
  void hover(int part);
  [[nodiscard]] bool brief() const;
  std::vector<PartView> parts_;
  std::vector<int> needs_;        ///< largest width of each so far, px
  std::vector<int> brief_needs_;  ///< the same with the first figure alone
  int hovered_ = -1;
};

/// "30 Hz · 12 ms" from a rate and an age; a rate below 0.5 Hz, as in the first second, and a NaN age are left out.
[[nodiscard]] QString rateAndAge(double rate_hz, double age_ms);

}  // namespace fyd::widgets
