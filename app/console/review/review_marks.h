// The marks of a review: the recording's own events and notes, and the notes and tags written in the review, which are
// kept in a file beside it and entered into the catalogue. Notes are shown as marks over the whole session and as a list.
#pragma once

#include <QCoreApplication>
#include <functional>
#include <string>
#include <vector>

#include "app/console/review/review_tables.h"
#include "app/console/review/shown_recording.h"
#include "app/console/shell/background.h"
#include "core/catalogue/catalogue_delivery.h"
#include "core/recording/reader/review_notes.h"
#include "widgets/curves/session_overview.h"
#include "widgets/status/notice_stack.h"

namespace fyd::console {

class ReviewMarks {
  Q_DECLARE_TR_FUNCTIONS(ReviewMarks)
 public:
  using Tell = std::function<void(widgets::Severity, const QString&)>;
  /// @param overview, table must outlive this
  /// @param catalogue word as after --catalogue
  ReviewMarks(widgets::SessionOverview* overview, NoteTable* table, QString catalogue, Tell tell);

  /// Reads the notes beside the recording; errors are shown as a notice.
  void open(const ShownRecording& shown);
  void show(const recording::Recording& recording);
  /// A note at `at_s`, into the file beside the recording. @return whether it was written; else a notice says why
  bool write(recording::NoteKind kind, const QString& text, double at_s);
  /// As they were last set in a review, or those of the recording.
  [[nodiscard]] QStringList tags() const;
  /// Words between commas, in place of the former tags. @return whether they were written; else a notice says why
  bool writeTags(const QString& text);

 private:
  /// For the catalogue.
  struct Change {
    std::string id;  ///< of the recording
    catalogue::ReviewChange change;
  };
  /// Changes the notes as they stand in the file by now, for another window may have written there too.
  bool save(catalogue::ReviewChange change);
  void deliver(Change change);
  void deliverNext();

  widgets::SessionOverview* overview_ = nullptr;
  NoteTable* table_ = nullptr;
  Tell tell_;
  ShownRecording shown_;
  QString catalogue_;
  std::vector<std::string> own_tags_;  // of the recording
  recording::ReviewNotes review_;
  std::vector<Change> waiting_;  // the first is under way
  Background work_;
};

}  // namespace fyd::console
