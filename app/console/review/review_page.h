// The place "Review": recorded sessions. A list of them, or one of them: overview on top, curves below it, the camera
// at the cursor on the left, touches, figures, what-if and comparison on the right.
#pragma once

#include <QLineEdit>
#include <QStackedWidget>
#include <memory>

#include "app/console/review/recording_files.h"
#include "app/console/review/review_bar.h"
#include "app/console/review/review_camera.h"
#include "app/console/review/review_curves.h"
#include "app/console/review/review_exports.h"
#include "app/console/review/review_marks.h"
#include "app/console/review/review_player.h"
#include "app/console/review/review_recovery.h"
#include "app/console/review/review_tabs.h"
#include "app/console/review/session_list.h"
#include "app/console/review/shown_recording.h"
#include "app/console/shell/curve_tools.h"
#include "app/console/shell/page.h"

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
  [[nodiscard]] QString unfinished() const override;

  /// Shows a recording. @return whether it could; if not, the list says why, or a notice while another one is shown
  bool open(const QString& path);
  /// Shows the first, and the second faint behind it.
  void compare(const QString& first, const QString& second);
  void showList();
  /// To be called when a session was added to the catalogue: refreshes the list if it is shown.
  void showNews();
  /// At the cursor.
  void writeNote(recording::NoteKind kind, const QString& text);
  void setMark(widgets::CurveStack::Mark which);
  void writeTags();

  /// Those opened lately, on this page or from elsewhere.
  [[nodiscard]] RecentRecordings& recent() { return recent_; }
  [[nodiscard]] const recording::Recording* recording() const { return recording_.get(); }
  [[nodiscard]] ReviewPlayer* player() { return &player_; }
  [[nodiscard]] CurveTools* curveTools() const { return curve_tools_; }
  [[nodiscard]] ReviewCurves* curves() const { return curves_; }
  [[nodiscard]] widgets::SessionOverview* overview() const { return overview_; }
  [[nodiscard]] SessionList* list() const { return list_; }
  [[nodiscard]] TouchTable* touches() const { return tabs_->touches(); }
  [[nodiscard]] QToolButton* cardButton() const { return tabs_->cardButton(); }
  [[nodiscard]] FiguresTable* figures() const { return tabs_->figures(); }
  [[nodiscard]] NoteTable* notes() const { return note_table_; }
  [[nodiscard]] WhatIfPanel* whatIf() const { return tabs_->whatIf(); }
  [[nodiscard]] ReviewComparison* comparison() const { return tabs_->comparison(); }
  [[nodiscard]] ReviewExports* exports() const { return exports_; }
  [[nodiscard]] widgets::ProgressBars* work() const { return work_; }
  [[nodiscard]] QToolButton* recoverButton() const { return bar_->recoverButton(); }
  [[nodiscard]] QLineEdit* noteField() const { return note_field_; }
  [[nodiscard]] QLineEdit* tagsField() const { return tags_field_; }
  [[nodiscard]] widgets::TimeField* timeField() const { return bar_->timeField(); }
  [[nodiscard]] ReviewTabs* tabs() const { return tabs_; }
  [[nodiscard]] bool showsList() const { return stack_->currentIndex() == 0; }
  [[nodiscard]] QString title() const { return bar_->title(); }

 private:
  QWidget* buildReview();
  QWidget* buildLeft();
  void showPart(int index);
  /// Those that act on the recording are offered only while it is shown.
  void offerCommands();
  void connectCursor();
  void connectTabs();
  void connectRecovery();
  void addExportCommands(PlaceCommands& commands);
  void close();
  void describe();
  /// What was recorded since it was shown last.
  void showGrowth();
  /// As the operator asked.
  void goTo(double time_s);
  /// At what is there.
  void look(double time_s);
  void showEnvelope();
  void showTags();
  /// In the panel that exports from A to B.
  void showMarks();

  PageContext context_;
  ShownRecording shown_;
  std::unique_ptr<recording::Recording> recording_;
  RecentRecordings recent_;
  ReviewPlayer player_;

  QStackedWidget* stack_ = nullptr;
  widgets::ProgressBars* work_ = nullptr;
  SessionList* list_ = nullptr;
  widgets::SessionOverview* overview_ = nullptr;
  ReviewCurves* curves_ = nullptr;
  CurveTools* curve_tools_ = nullptr;
  ReviewExports* exports_ = nullptr;
  ReviewRecovery* recovery_ = nullptr;
  NoteTable* note_table_ = nullptr;
  ReviewMarks marks_;
  ReviewBar* bar_ = nullptr;
  ReviewCamera* camera_ = nullptr;
  QLineEdit* note_field_ = nullptr;
  QLineEdit* tags_field_ = nullptr;
  ReviewTabs* tabs_ = nullptr;
  std::vector<QAction*> recording_commands_;
};

}  // namespace fyd::console
