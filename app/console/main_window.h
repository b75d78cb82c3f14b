// The window: puts its frame of places, the docks and the notices together, and passes on what concerns all of them:
// stop, arm, tare, the log. What a place does stands in the place.
#pragma once

#include <QMainWindow>
#include <QTime>
#include <memory>

#include "app/console/command_palette.h"
#include "app/console/command_registry.h"
#include "app/console/dock_set.h"
#include "app/console/frame.h"
#include "app/console/help_dock.h"
#include "app/console/key_guard.h"
#include "app/console/layouts_dialog.h"
#include "app/console/link_dock.h"
#include "app/console/operate_page.h"
#include "app/console/recording_control.h"
#include "app/console/robot_change.h"
#include "app/console/session.h"
#include "app/console/session_feed.h"
#include "app/console/trial_run.h"
#include "app/console/tuning_bridge.h"
#include "app/console/window_memory.h"
#include "widgets/log_view.h"
#include "widgets/notice_stack.h"

class QDockWidget;

namespace fyd::console {

class ReviewPage;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// @param profile_path where "Save profile" writes
  /// @param catalogue of sessions, word as after --catalogue
  /// @param memory what is remembered from start to start
  MainWindow(std::unique_ptr<Session> session, const QString& profile_path, const QString& catalogue = {},
             const WindowMemory& memory = WindowMemory({}));
  ~MainWindow() override;

  /// Starts the session's threads and the flow of news.
  void start();
  /// Arms once when first Ready, as a headless station does; for pictures of the window.
  void armOnce() { arm_once_ = true; }

  /// Goes to the place "Review" and opens a recording there.
  void review(const QString& recording);

  [[nodiscard]] Session& session() { return *session_; }
  [[nodiscard]] SessionFeed& feed() { return *feed_; }
  [[nodiscard]] Frame* frame() const { return frame_; }
  [[nodiscard]] widgets::StateBar* stateBar() const { return frame_->stateBar(); }
  [[nodiscard]] OperatePage* operate() const;
  [[nodiscard]] widgets::NoticeStack* notices() const { return notices_; }
  [[nodiscard]] widgets::LogView* log() const { return log_; }
  [[nodiscard]] CommandRegistry& commands() { return *commands_; }
  [[nodiscard]] LinkDock* link() const { return link_; }
  [[nodiscard]] RecordingControl* recording() const { return recording_; }
  [[nodiscard]] TrialRun* trials() const { return trials_; }
  [[nodiscard]] CommandPalette* palette() const { return palette_; }
  [[nodiscard]] HelpDock* help() const { return help_; }
  [[nodiscard]] LayoutsDialog* layouts() const { return layouts_; }
  [[nodiscard]] Layout layoutNow() const;
  /// What of it cannot be had is said in the log.
  void setLayoutTo(const Layout& layout);
  void tell(widgets::Severity severity, const QString& text, bool slide_in = true);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  PageContext context();
  [[nodiscard]] ReviewPage* reviewPage() const;
  void buildDocks();
  void connectFeed();
  void connectStateBar();
  void connectCommands();
  void connectLook();
  void connectLayouts();
  void recall();
  void remember();
  void stop();
  void ask(pipeline::OperatorAction action);
  void takeSamples(std::span<const pipeline::TelemetrySample> samples);
  void takeNotice(const station::Notice& notice);

  std::unique_ptr<Session> session_;
  QString catalogue_;
  WindowMemory memory_;
  TuningBridge tuning_;
  SessionFeed* feed_;
  CommandRegistry* commands_;
  KeyGuard* keys_;
  Frame* frame_;
  widgets::NoticeStack* notices_;
  widgets::LogView* log_ = nullptr;
  QDockWidget* log_dock_ = nullptr;
  HelpDock* help_;
  LinkDock* link_;
  RobotChange* robot_;
  RecordingControl* recording_;
  TrialRun* trials_;
  CommandPalette* palette_;
  DockSet panels_;
  LayoutsDialog* layouts_;
  Layout standard_;  ///< the curves of a first start; no words of Qt put the panels to their standard places
  bool arm_once_ = false;
};

}  // namespace fyd::console
