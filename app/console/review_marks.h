// What is marked in a review: the recording's own events and notes, and the notes written here, which stand in a file
// beside it. They are shown as marks over the whole session and as a list.
#pragma once

#include <QCoreApplication>
#include <functional>
#include <string>
#include <vector>

#include "app/console/review_tables.h"
#include "core/session/review_notes.h"
#include "widgets/notice_stack.h"
#include "widgets/session_overview.h"

namespace fyd::console {

class ReviewMarks {
  Q_DECLARE_TR_FUNCTIONS(ReviewMarks)
 public:
  using Tell = std::function<void(widgets::Severity, const QString&)>;
  /// @param overview, table must outlive this
  ReviewMarks(widgets::SessionOverview* overview, NoteTable* table, Tell tell);

  /// Reads the notes beside the recording; what is wrong with them is told.
  void open(const QString& path);
  void show(const session::Recording& recording);
  /// A note at `at_s`, into the file beside the recording. @return whether it was written; why not is told
  bool write(session::NoteKind kind, const QString& text, double at_s);

 private:
  widgets::SessionOverview* overview_;
  NoteTable* table_;
  Tell tell_;
  std::string path_;
  std::vector<session::ReviewNote> notes_;
  bool damaged_ = false;  // then nothing is written over them
};

}  // namespace fyd::console
