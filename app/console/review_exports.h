// Exports and reports of the recording in review: beside it, never over a file, off the window's thread.
#pragma once

#include <QObject>
#include <functional>
#include <string>

#include "app/console/background.h"
#include "app/console/review_curves.h"
#include "core/session/export_recording.h"
#include "widgets/notice_stack.h"

namespace fyd::console {

class ReviewExports : public QObject {
  Q_OBJECT
 public:
  using Tell = std::function<void(widgets::Severity, const QString&)>;
  explicit ReviewExports(Tell tell, QObject* parent = nullptr) : QObject(parent), tell_(std::move(tell)) {}

  /// Empty: none. Work under way goes on with its own.
  void setRecording(const QString& path) { path_ = path; }
  /// Beside the recording, in the format of the ending: report.html, report.pdf, csv, mat, mcap, mkv.
  void exportAs(const QString& ending);
  /// The rows and fields that `curves` show, as CSV.
  void exportShown(const ReviewCurves& curves, const QString& target);

 private:
  void exportTo(const std::string& target, const session::ExportOptions& options);

  Tell tell_;
  QString path_;
  Background work_;
};

}  // namespace fyd::console
