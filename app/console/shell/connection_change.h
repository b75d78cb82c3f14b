// Changes the session's devices while the window stays open. They are asked first, on their own thread, while the
// present session continues, so that a choice that cannot work does not end it; then the session ends and another
// begins with them, or the former one when they cannot be opened after all.
#pragma once

#include <QObject>
#include <vector>

#include "app/console/shell/background.h"
#include "app/console/shell/session.h"
#include "app/console/shell/session_feed.h"
#include "app/console/shell/tuning_bridge.h"
#include "widgets/status/notice_stack.h"

namespace fyd::console {

class ConnectionChange : public QObject {
  Q_OBJECT
 public:
  ConnectionChange(Session& session, SessionFeed& feed, TuningBridge& tuning, QObject* parent = nullptr);

  /// Why the devices may not be changed now, and what to do; empty: they may.
  [[nodiscard]] QString hindrance() const;
  /// What is being done; empty: nothing.
  [[nodiscard]] const QString& work() const { return work_; }
  /// There is no session, and none is being opened.
  [[nodiscard]] bool closed() const { return !session_.isOpen() && !opening_.running(); }
  /// Only while the present session continues.
  [[nodiscard]] bool canBeCancelled() const { return asking_.running(); }
  /// What could not be had of the last choice; none after one that could.
  [[nodiscard]] const std::vector<station::ConnectionProblem>& problems() const { return problems_; }
  [[nodiscard]] ConnectionWords present() const { return session_.connection(); }

  /// While something hinders it, only that is told; while something is being done, nothing happens.
  void change(const ConnectionWords& wanted);
  void cancel();
  /// A recording begins or ends, which may take the disk's time: the session may not be left meanwhile.
  void waitForRecorder(bool waits);
  [[nodiscard]] bool recorderWaits() const { return recorder_waits_; }
  [[nodiscard]] static QString recorderWaitsText();

 signals:
  void refreshed();  ///< one of the above is another
  void leaving();    ///< the present session ends now
  /// Another session began. @param words of its devices
  void arrived(const fyd::console::ConnectionWords& words);
  void told(fyd::widgets::Severity severity, const QString& text);

 private:
  [[nodiscard]] bool mayBegin();
  void show(const QString& work);
  void hear(std::span<const pipeline::TelemetrySample> samples);
  void answered(const ConnectionWords& wanted, std::vector<station::ConnectionProblem> problems);
  void leaveFor(const ConnectionWords& wanted);
  void done(const ConnectionWords& wanted, const Result<void>& outcome);
  void connectWork();
  void tellUnchanged(const QString& why);

  Session& session_;
  SessionFeed& feed_;
  TuningBridge& tuning_;
  bool can_move_ = true;  // until the first sample says otherwise
  bool silent_ = false;
  bool recording_ = false;
  bool recorder_waits_ = false;
  QString work_;
  std::string former_;  ///< touchpad of the session that was left, as in touchpad_name.h
  std::vector<station::ConnectionProblem> problems_;
  Background asking_;
  Background opening_;
};

/// "Touchpad simulated, camera its own, robot none": for notices.
[[nodiscard]] QString inWords(const ConnectionWords& words);

}  // namespace fyd::console
