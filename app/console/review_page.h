// The place "Review": what happened. A list of sessions, or one of them: overview on top, curves below it, the camera
// at the cursor on the left, touches, figures, what-if and comparison on the right.
#pragma once

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolButton>
#include <memory>

#include "app/console/curve_tools.h"
#include "app/console/page.h"
#include "app/console/review_camera.h"
#include "app/console/review_comparison.h"
#include "app/console/review_curves.h"
#include "app/console/review_exports.h"
#include "app/console/review_marks.h"
#include "app/console/review_player.h"
#include "app/console/review_recovery.h"
#include "app/console/session_list.h"
#include "app/console/what_if_panel.h"

namespace fyd::console {

class ReviewPage : public Page {
  Q_OBJECT
 public:
  static constexpr const char* kCancelWorkKeys = "Ctrl+Shift+X";

  explicit ReviewPage(const PageContext& context, QWidget* parent = nullptr);
  ~ReviewPage() override;
  void addCommands(PlaceCommands& commands) override;
  void enter() override;
  void leave() override;

  /// Shows a recording; what is wrong with it is told, and the list stays.
  void open(const QString& path);
  void showList();
  /// A session was added to the catalogue: a list that is looked at shows it, too.
  void showNews();
  /// At the cursor.
  void writeNote(session::NoteKind kind, const QString& text);
  void setMark(widgets::CurveStack::Mark which);
  /// A gesture card of the touch that is chosen.
  void makeCard();

  [[nodiscard]] const session::Recording* recording() const { return recording_.get(); }
  [[nodiscard]] ReviewPlayer* player() { return &player_; }
  [[nodiscard]] CurveTools* curveTools() const { return curve_tools_; }
  [[nodiscard]] ReviewCurves* curves() const { return curves_; }
  [[nodiscard]] widgets::SessionOverview* overview() const { return overview_; }
  [[nodiscard]] SessionList* list() const { return list_; }
  [[nodiscard]] TouchTable* touches() const { return touch_table_; }
  [[nodiscard]] QToolButton* cardButton() const { return card_; }
  [[nodiscard]] FiguresTable* figures() const { return figures_table_; }
  [[nodiscard]] NoteTable* notes() const { return note_table_; }
  [[nodiscard]] WhatIfPanel* whatIf() const { return what_if_; }
  [[nodiscard]] ReviewComparison* comparison() const { return comparison_; }
  [[nodiscard]] ReviewExports* exports() const { return exports_; }
  [[nodiscard]] widgets::WorkBars* work() const { return work_; }
  [[nodiscard]] QToolButton* recoverButton() const { return recover_; }
  [[nodiscard]] QLineEdit* noteField() const { return note_field_; }
  [[nodiscard]] QTabWidget* tabs() const { return tabs_; }
  [[nodiscard]] bool showsList() const { return stack_->currentIndex() == 0; }
  [[nodiscard]] QString title() const { return title_->text(); }

 private:
  QWidget* buildReview();
  QWidget* buildBar();
  QWidget* buildLeft();
  QWidget* buildRight();
  void connectCursor();
  void connectTabs();
  void connectRecovery();
  void addExportCommands(PlaceCommands& commands);
  void close();
  void describe();
  void look(double time_s);
  void findTouches();
  void showTouches(const std::vector<session::Touch>& touches);
  void showEnvelope();
  void computeFigures();

  PageContext context_;
  QString path_;
  std::unique_ptr<session::Recording> recording_;
  ReviewPlayer player_;

  QStackedWidget* stack_;
  widgets::WorkBars* work_;
  SessionList* list_;
  widgets::SessionOverview* overview_;
  ReviewCurves* curves_;
  CurveTools* curve_tools_;
  ReviewExports* exports_;
  ReviewRecovery* recovery_;
  NoteTable* note_table_;
  ReviewMarks marks_;
  QLabel* title_ = nullptr;
  QLabel* time_ = nullptr;
  QHBoxLayout* bar_ = nullptr;
  QToolButton* recover_ = nullptr;
  ReviewCamera* camera_ = nullptr;
  QLineEdit* note_field_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  TouchTable* touch_table_ = nullptr;
  QToolButton* card_ = nullptr;
  FiguresTable* figures_table_ = nullptr;
  WhatIfPanel* what_if_ = nullptr;
  ReviewComparison* comparison_ = nullptr;

  TouchSearch touch_search_;
  LongWork figures_work_;
};

}  // namespace fyd::console
