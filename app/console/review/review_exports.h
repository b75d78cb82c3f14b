// Exports and reports of the recording in review: into its folder, never replacing a file. Several may be written at
// once, each with its bar; one that is cancelled leaves no file.
#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <string>

#include "app/console/review/review_curves.h"
#include "app/console/review/shown_recording.h"
#include "app/console/shell/long_work.h"
#include "core/export/export_recording.h"
#include "core/export/touches.h"
#include "widgets/status/notice_stack.h"

namespace fyd::console {

class ReviewExports : public QObject {
  Q_OBJECT
 public:
  using Tell = std::function<void(widgets::Severity, const QString&)>;
  ReviewExports(widgets::ProgressBars* bars, Tell tell, QObject* parent = nullptr)
      : QObject(parent), bars_(bars), tell_(std::move(tell)) {}

  /// Empty: none. Work under way continues with its own recording.
  void setRecording(const ShownRecording& shown) { shown_ = shown; }
  /// Beside the recording, in the format of the ending: report.html, report.pdf, csv, mat, mcap, mkv.
  void exportAs(const QString& ending);
  /// The same from `from_s` to `to_s`, both included; the file's name says so. Not for reports.
  void exportStretch(const QString& ending, double from_s, double to_s);
  /// The rows and fields that `curves` show, as CSV.
  void exportShown(const ReviewCurves& curves, const QString& target);
  /// A touch as a gesture card. @param number from 1
  void exportCard(const exports::Touch& touch, int number);
  /// Names of the files that are being written.
  [[nodiscard]] QStringList underWay() const;
  /// Cancels all of them; no partial file is left.
  void drop();

 signals:
  void written(const QString& path);
  void failed(const QString& why);

 private:
  using Write = std::function<Result<void>(const recording::Progress&)>;
  void exportTo(const std::string& target, const exports::ExportOptions& options);
  /// @param then text that follows "… is written." in the notice
  void run(const std::string& target, Write write, const QString& then = {});

  /// Beside the recording. @param of which part of it; empty: all
  [[nodiscard]] std::string targetFor(const QString& ending, const QString& of = {}) const;
  void finish(const std::string& target, const Result<void>& done, const QString& then);

  widgets::ProgressBars* bars_ = nullptr;
  Tell tell_;
  ShownRecording shown_;
  std::map<std::string, LongWork*> works_;  // by the file each writes
};

}  // namespace fyd::console
