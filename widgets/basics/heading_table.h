// A table for a narrow place: its columns share its width, none is narrower than its heading; where they do not fit, it
// scrolls horizontally.
#pragma once

#include <QHeaderView>
#include <QScrollBar>
#include <QTableWidget>
#include <numeric>
#include <vector>

namespace fyd::widgets {

class HeadingTable : public QTableWidget {
 public:
  explicit HeadingTable(QWidget* parent) : HeadingTable(0, 0, parent) {}
  HeadingTable(int rows, int columns, QWidget* parent) : QTableWidget(rows, columns, parent) {
    setTabKeyNavigation(false);  // Tab leaves it; the arrow keys go through its cells
  }

  /// Width that needs no horizontal scrolling, px.
  [[nodiscard]] int wholeWidth() const {
    int out_px = 2 * frameWidth() + verticalScrollBar()->sizeHint().width();
    if (!verticalHeader()->isHidden()) out_px += verticalHeader()->sizeHint().width();
    for (int i = 0; i < columnCount(); ++i) out_px += horizontalHeader()->sectionSizeHint(i);
    return out_px;
  }

  /// Called automatically after a change of size; to be called after a change of the headings.
  void shareWidth() {
    std::vector<int> widths_px;
    widths_px.reserve(static_cast<std::size_t>(columnCount()));
    for (int i = 0; i < columnCount(); ++i) widths_px.push_back(horizontalHeader()->sectionSizeHint(i));
    const int left_px = viewport()->width() - std::accumulate(widths_px.begin(), widths_px.end(), 0);
    for (int i = 0; i < columnCount(); ++i) {
      setColumnWidth(i, widths_px[static_cast<std::size_t>(i)] + std::max(0, left_px) / columnCount());
    }
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QTableWidget::resizeEvent(event);
    shareWidth();
  }
};

}  // namespace fyd::widgets
