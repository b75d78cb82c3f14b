// The place "Review": what happened. A list of sessions, or one of them: overview on top, curves below it, the camera
// at the cursor on the left, touches, figures, what-if and comparison on the right.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolButton>
#include <memory>

#include "app/console/curve_tools.h"
#include "app/console/page.h"
#include "app/console/review_curves.h"
#include "app/console/review_player.h"
#include "app/console/review_tables.h"
#include "app/console/session_list.h"
#include "app/console/what_if_panel.h"
#include "core/session/export_recording.h"
#include "core/session/review_notes.h"
#include "widgets/camera_image.h"
#include "widgets/session_overview.h"

namespace fyd::console {

class ReviewPage : public Page {
  Q_OBJECT
 public:
  explicit ReviewPage(const PageContext& context, QWidget* parent = nullptr);
  ~ReviewPage() override;
  void addCommands(PlaceCommands& commands) override;
  void enter() override;
  void leave() override;

  /// Shows a recording; what is wrong with it is told, and the list stays.
  void open(const QString& path);
  void showList();
  /// A second session beside this one; its touch `theirs` stands where this one's `ours` stands, both from 0.
  void compare(const QString& path);
  void alignAt(int ours, int theirs);
  void writeNote(session::NoteKind kind, const QString& text);
  void setMark(widgets::CurveStack::Mark which);
  /// Beside the recording, in the format of the ending: report.html, report.pdf, csv, mat, mcap, mkv.
  void exportAs(const QString& ending);
  void saveShownValues();

  [[nodiscard]] const session::Recording* recording() const { return recording_.get(); }
  [[nodiscard]] ReviewPlayer* player() { return &player_; }
  [[nodiscard]] CurveTools* curveTools() const { return curve_tools_; }
  [[nodiscard]] ReviewCurves* curves() const { return curves_; }
  [[nodiscard]] widgets::SessionOverview* overview() const { return overview_; }
  [[nodiscard]] SessionList* list() const { return list_; }
  [[nodiscard]] TouchTable* touches() const { return touch_table_; }
  [[nodiscard]] FiguresTable* figures() const { return figures_table_; }
  [[nodiscard]] NoteTable* notes() const { return note_table_; }
  [[nodiscard]] WhatIfPanel* whatIf() const { return what_if_; }
  [[nodiscard]] QLineEdit* noteField() const { return note_field_; }
  [[nodiscard]] QTabWidget* tabs() const { return tabs_; }
  [[nodiscard]] bool showsList() const { return stack_->currentIndex() == 0; }
  [[nodiscard]] QString title() const { return title_->text(); }

 private:
  void exportTo(const std::string& target, const session::ExportOptions& options);
  QWidget* buildReview();
  QWidget* buildBar();
  QWidget* buildLeft();
  QWidget* buildRight();
  QWidget* buildCompare();
  void connectCursor();
  void close();
  void describe();
  void look(double time_s);
  void findTouches();
  void showMarks();
  void showEnvelope();
  void computeFigures();
  void fillAlignment();

  PageContext context_;
  QString path_;
  std::unique_ptr<session::Recording> recording_;
  std::unique_ptr<session::Recording> other_;
  std::vector<session::Touch> touches_;
  std::vector<session::Touch> other_touches_;
  std::vector<session::ReviewNote> review_notes_;
  bool notes_damaged_ = false;  // then nothing is written over them
  ReviewPlayer player_;

  QStackedWidget* stack_;
  SessionList* list_;
  QLabel* title_ = nullptr;
  QLabel* time_ = nullptr;
  QToolButton* play_ = nullptr;
  QComboBox* speed_ = nullptr;
  widgets::SessionOverview* overview_;
  ReviewCurves* curves_;
  CurveTools* curve_tools_;
  class QHBoxLayout* bar_ = nullptr;
  widgets::CameraImage* camera_ = nullptr;
  QLabel* camera_words_ = nullptr;
  NoteTable* note_table_ = nullptr;
  QLineEdit* note_field_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  TouchTable* touch_table_ = nullptr;
  FiguresTable* figures_table_ = nullptr;
  WhatIfPanel* what_if_ = nullptr;
  QLineEdit* compare_path_ = nullptr;
  QComboBox* our_touch_ = nullptr;
  QComboBox* their_touch_ = nullptr;
  QLabel* compare_words_ = nullptr;
  std::uint64_t shown_picture_ = 0;

  Background touch_work_;
  Background figures_work_;
  Background compare_work_;
  Background export_work_;
};

}  // namespace fyd::console
