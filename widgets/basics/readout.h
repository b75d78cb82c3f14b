// Large tabular numerals beside a curve: name, value, unit, and a word when the value is old or missing.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "widgets/basics/theme.h"

namespace fyd::widgets {

class Readout : public QWidget {
  Q_OBJECT
 public:
  struct Entry {
    QString label;  ///< before the value; empty for the quantity itself
    Quantity quantity = Quantity::none;
    bool dashed = false;  ///< drawn like its curve
    int decimals = 2;
  };
  /// The first entry is large when `large`, the others small.
  Readout(QString title, QString unit, std::vector<Entry> entries, bool large, QWidget* parent = nullptr);

  void setValue(std::size_t entry, double value);
  /// @param note why there is no value, or how old it is; empty: it is current
  void setNote(const QString& note);

  /// @param when to which time the values belong: "live", "at 83.500 s"; empty: it is not said
  void setWhen(const QString& when);

  [[nodiscard]] QString valueText(std::size_t entry) const { return texts_[entry]; }
  [[nodiscard]] QString note() const { return note_; }
  [[nodiscard]] QString when() const { return when_; }
  /// The width of every readout, px.
  [[nodiscard]] static int columnWidth();
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void describe();
  [[nodiscard]] int contentHeight() const;
  /// The name and what is said of it at the right, in one line of `width`.
  void paintHead(QPainter& painter, int width, int y, const QString& aside, const QColor& colour) const;
  void paintEntry(QPainter& painter, std::size_t entry, int y, const QFont& number_font) const;
  void paintLow(QPainter& painter) const;
  /// The entries from `first` on, side by side in lines of the small font, as many as there is room for.
  void paintFlowing(QPainter& painter, std::size_t first, QRect room) const;

  QString title_;
  QString unit_;
  std::vector<Entry> entries_;
  std::vector<QString> texts_;
  QString note_;
  QString when_;
  bool large_;
};

}  // namespace fyd::widgets
