// Makes a recording whole whose recorder crashed, as `fyd session recover` does; the original is never deleted.
#pragma once

#include <functional>

#include "app/console/long_work.h"
#include "core/session/recover.h"
#include "widgets/notice_stack.h"

namespace fyd::console {

class ReviewRecovery : public QObject {
  Q_OBJECT
 public:
  using Tell = std::function<void(widgets::Severity, const QString&)>;
  /// @param catalogue word as after --catalogue: what is whole again is entered there
  ReviewRecovery(widgets::WorkBars* bars, QString catalogue, Tell tell, QObject* parent = nullptr);

  /// One at a time; what came of it is told in words.
  void recover(const QString& path);
  /// Ends soon; the file stays as it was.
  void drop() { work_.drop(); }

 signals:
  /// @param asked the path it was asked for
  /// @param file what can be read now
  void recovered(const QString& asked, const QString& file);

 private:
  void finish(const QString& asked, const Result<session::RecoverOutcome>& outcome);

  QString catalogue_;
  Tell tell_;
  LongWork work_;
};

}  // namespace fyd::console
