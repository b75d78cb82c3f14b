// The tables of a review: its touches, the figures between A and B, its notes.
#pragma once

#include <QTableWidget>
#include <vector>

#include "app/console/review/review_figures.h"
#include "core/export/touches.h"

namespace fyd::console {

/// A read-only table, of which single rows are selected.
class ReviewTable : public QTableWidget {
  Q_OBJECT
 public:
  /// @param words columns that hold words, not numbers
  ReviewTable(const QStringList& columns, const QList<int>& words, const QString& name, QWidget* parent = nullptr);
  /// Text shown while there are no rows.
  void setEmptyText(const QString& text);

 protected:
  void setRow(int row, const QStringList& cells, const QString& spoken);
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] Qt::Alignment alignment(int column) const;

  QList<int> words_;
  QString empty_text_;
};

class TouchTable : public ReviewTable {
  Q_OBJECT
 public:
  explicit TouchTable(QWidget* parent = nullptr);
  void setTouches(const std::vector<exports::Touch>& touches);
  /// The row that is chosen; null: none.
  [[nodiscard]] const exports::Touch* chosen() const;

 signals:
  void touchChosen(double start_s, double end_s);

 private:
  std::vector<exports::Touch> touches_;
};

class FiguresTable : public ReviewTable {
  Q_OBJECT
 public:
  explicit FiguresTable(QWidget* parent = nullptr);
  /// One row for each of kReviewQuantities. @param b_after_a_s < 0 when B lies before A
  void setFigures(const std::vector<StretchFigures>& figures, double b_after_a_s);
  void clearFigures();
};

struct NoteLine {
  double time_s = 0.0;
  QString kind;
  QString text;
};

class NoteTable : public ReviewTable {
  Q_OBJECT
 public:
  explicit NoteTable(QWidget* parent = nullptr);
  void setNotes(const std::vector<NoteLine>& notes);
  /// Scrolls to the note with these words at that time, and selects it without choosing its time.
  void showAt(double time_s, const QString& text);

 signals:
  void noteChosen(double time_s);

 private:
  std::vector<NoteLine> notes_;
};

}  // namespace fyd::console
