// The marks of a review: the recording's own events and notes, and the notes written in the review, which are kept in a
// file beside it. They are shown as marks over the whole session and as a list.
#pragma once

#include <QCoreApplication>
#include <functional>
#include <string>
#include <vector>

#include "app/console/review/review_tables.h"
#include "core/recording/reader/review_notes.h"
#include "widgets/curves/session_overview.h"
#include "widgets/status/notice_stack.h"

namespace fyd::console {

class ReviewMarks {
  Q_DECLARE_TR_FUNCTIONS(ReviewMarks)
 public:
  using Tell = std::function<void(widgets::Severity, const QString&)>;
  /// @param overview, table must outlive this
  ReviewMarks(widgets::SessionOverview* overview, NoteTable* table, Tell tell);

  /// Reads the notes beside the recording; errors are shown as a notice.
  void open(const QString& path);
  void show(const recording::Recording& recording);
  /// A note at `at_s`, into the file beside the recording. @return whether it was written; else a notice says why
  bool write(recording::NoteKind kind, const QString& text, double at_s);

 private:
  widgets::SessionOverview* overview_;
  NoteTable* table_;
  Tell tell_;
  std::string path_;
  std::vector<recording::ReviewNote> notes_;
  bool damaged_ = false;  // the file is damaged: it is not overwritten
};

}  // namespace fyd::console
