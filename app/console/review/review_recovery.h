// Makes a recording whole whose recorder crashed, as `fyd session recover` does; the original is never deleted.
#pragma once

#include <functional>

#include "app/console/shell/long_work.h"
#include "core/recording/recovery/recover.h"
#include "widgets/status/notice_stack.h"

namespace fyd::console {

class ReviewRecovery : public QObject {
  Q_OBJECT
 public:
  using Tell = std::function<void(widgets::Severity, const QString&)>;
  /// @param catalogue word as after --catalogue: the recovered recording is entered there
  ReviewRecovery(widgets::ProgressBars* bars, QString catalogue, Tell tell, QObject* parent = nullptr);

  /// One at a time; the outcome is shown as a notice.
  void recover(const QString& path);
  /// Cancels the recovery; the file stays as it was.
  void drop() { work_.drop(); }

 signals:
  /// @param asked the path it was asked for
  /// @param file what can be read now
  void recovered(const QString& asked, const QString& file);

 private:
  void finish(const QString& asked, const Result<recording::RecoverOutcome>& outcome);

  QString catalogue_;
  Tell tell_;
  LongWork work_;
};

}  // namespace fyd::console
