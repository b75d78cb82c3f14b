// Exports and reports of the recording in review: beside it, never over a file. Several may be written at once, each
// with its bar; one that is cancelled leaves no file.
#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <string>

#include "app/console/long_work.h"
#include "app/console/review_curves.h"
#include "core/session/export_recording.h"
#include "core/session/touches.h"
#include "widgets/notice_stack.h"

namespace fyd::console {

class ReviewExports : public QObject {
  Q_OBJECT
 public:
  using Tell = std::function<void(widgets::Severity, const QString&)>;
  ReviewExports(widgets::WorkBars* bars, Tell tell, QObject* parent = nullptr)
      : QObject(parent), bars_(bars), tell_(std::move(tell)) {}

  /// Empty: none. Work under way goes on with its own.
  void setRecording(const QString& path) { path_ = path; }
  /// Beside the recording, in the format of the ending: report.html, report.pdf, csv, mat, mcap, mkv.
  void exportAs(const QString& ending);
  /// The rows and fields that `curves` show, as CSV.
  void exportShown(const ReviewCurves& curves, const QString& target);
  /// A touch as a gesture card. @param number from 1
  void exportCard(const session::Touch& touch, int number);
  /// All of them end soon, and leave nothing.
  void drop();

 private:
  using Write = std::function<Result<void>(const session::Progress&)>;
  void exportTo(const std::string& target, const session::ExportOptions& options);
  /// @param then what is told after "… is written."
  void run(const std::string& target, Write write, const QString& then = {});

  void finish(const std::string& target, const Result<void>& done, const QString& then);

  widgets::WorkBars* bars_;
  Tell tell_;
  QString path_;
  std::map<std::string, LongWork*> works_;  // by the file each writes
};

}  // namespace fyd::console
