// What is made of a recording, at its right: touches, figures between A and B, what if, comparison, exports.
#pragma once

#include <QTabWidget>
#include <QToolButton>
#include <vector>

#include "app/console/review/export_panel.h"
#include "app/console/review/review_comparison.h"
#include "app/console/review/review_exports.h"
#include "app/console/review/review_tables.h"
#include "app/console/review/shown_recording.h"
#include "app/console/review/touch_search.h"
#include "app/console/review/what_if_panel.h"
#include "app/console/shell/long_work.h"
#include "app/console/shell/page.h"

namespace fyd::console {

class ReviewTabs : public QTabWidget {
  Q_OBJECT
 public:
  /// @param exports writes the files
  ReviewTabs(const PageContext& context, widgets::ProgressBars* bars, ReviewExports* exports, QWidget* parent);

  /// Begins to look for touches.
  void open(const ShownRecording& shown);
  /// Looks for them anew: the recording has grown.
  void findTouches();
  /// Ends what is computed, and forgets the recording.
  void close();
  /// Shows the figures between two times; nothing happens before both are known.
  void showFigures(double a_s, double b_s);
  /// The marks are gone: no figures, and none to come.
  void clearFigures();
  /// A gesture card of the touch that is chosen.
  void makeCard();

  [[nodiscard]] TouchTable* touches() const { return touch_table_; }
  [[nodiscard]] QToolButton* cardButton() const { return card_; }
  [[nodiscard]] FiguresTable* figures() const { return figures_table_; }
  [[nodiscard]] WhatIfPanel* whatIf() const { return what_if_; }
  [[nodiscard]] ReviewComparison* comparison() const { return comparison_; }
  [[nodiscard]] ExportPanel* exportPanel() const { return export_panel_; }

 signals:
  /// Found, or none while they are looked for.
  void touchesChanged(const std::vector<exports::Touch>& touches);

 private:
  QWidget* buildTouches();
  void showTouches(const std::vector<exports::Touch>& touches);

  PageContext context_;
  ReviewExports* exports_ = nullptr;
  ShownRecording shown_;
  TouchTable* touch_table_ = nullptr;
  QToolButton* card_ = nullptr;
  FiguresTable* figures_table_ = nullptr;
  WhatIfPanel* what_if_ = nullptr;
  ReviewComparison* comparison_ = nullptr;
  ExportPanel* export_panel_ = nullptr;
  TouchSearch touch_search_;
  LongWork figures_work_;
};

}  // namespace fyd::console
