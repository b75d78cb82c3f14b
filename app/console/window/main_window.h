// The window: combines the frame with its places, the docks and the notices, and handles what concerns all of them:
// stop, arm, tare, the log. Each place implements its own functions.
#pragma once

#include <QMainWindow>
#include <QTime>
#include <memory>
#include <optional>

#include "app/console/operate/operate_page.h"
#include "app/console/operate/recording_control.h"
#include "app/console/shell/command_registry.h"
#include "app/console/shell/connection_change.h"
#include "app/console/shell/dock_set.h"
#include "app/console/shell/key_guard.h"
#include "app/console/shell/session.h"
#include "app/console/shell/session_feed.h"
#include "app/console/shell/tuning_bridge.h"
#include "app/console/window/command_palette.h"
#include "app/console/window/damaged_profile.h"
#include "app/console/window/first_steps.h"
#include "app/console/window/frame.h"
#include "app/console/window/help_dock.h"
#include "app/console/window/layouts_dialog.h"
#include "app/console/window/leaving.h"
#include "app/console/window/link_dock.h"
#include "app/console/window/missing_devices.h"
#include "app/console/window/notice_causes.h"
#include "app/console/window/plain_texts.h"
#include "app/console/window/trial_run.h"
#include "app/console/window/window_memory.h"
#include "widgets/status/log_view.h"
#include "widgets/status/notice_stack.h"

class QDockWidget;

namespace fyd::console {

class DevicesPage;
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

  /// Starts the session's threads and the feed.
  void start();
  /// The display is gone: stops the motors and closes the recording. Only the session is touched.
  void endWithoutDisplay();
  /// Arms once when first Ready, as a headless station does; for screenshots.
  void armOnce() { arm_once_ = true; }

  /// @param names of kPanelNames
  void openPanels(const QStringList& names);

  /// Shows the way from the first start to the first touch.
  void showFirstSteps() { first_steps_->show(); }
  /// The devices are those of last time: when they do not come, the window says what to do.
  /// @param why the session could not be opened; empty: it is open
  void expectDevices(const Message& why) { missing_->expect(why); }
  /// The user's own profile cannot be read: the window says why, and what to do. The session is closed.
  void tellDamagedProfile(const Message& why) { damaged_profile_->tell(why); }

  /// Goes to the place "Review" and opens a recording there.
  void review(const QString& recording);

  [[nodiscard]] Session& session() { return *session_; }
  [[nodiscard]] SessionFeed& feed() { return *feed_; }
  [[nodiscard]] ConnectionChange& connection() { return *connection_; }
  [[nodiscard]] Frame* frame() const { return frame_; }
  [[nodiscard]] widgets::StateBar* stateBar() const { return frame_->stateBar(); }
  [[nodiscard]] OperatePage* operate() const;
  [[nodiscard]] widgets::NoticeStack* notices() const { return frame_->notices(); }
  [[nodiscard]] widgets::LogView* log() const { return log_; }
  [[nodiscard]] CommandRegistry& commands() { return *commands_; }
  [[nodiscard]] LinkDock* link() const { return link_; }
  [[nodiscard]] RecordingControl* recording() const { return recording_; }
  [[nodiscard]] TrialRun* trials() const { return trials_; }
  [[nodiscard]] CommandPalette* palette() const { return palette_; }
  [[nodiscard]] HelpDock* help() const { return help_; }
  [[nodiscard]] FirstSteps* firstSteps() const { return first_steps_; }
  [[nodiscard]] MissingDevices* missing() const { return missing_; }
  [[nodiscard]] DamagedProfile* damagedProfile() const { return damaged_profile_; }
  [[nodiscard]] LayoutsDialog* layouts() const { return layouts_; }
  [[nodiscard]] Layout layoutNow() const;
  /// What cannot be restored of it is noted in the log.
  void setLayoutTo(const Layout& layout);
  /// @param cause what withdraws the notice when it is gone; empty: it stays until it is read
  void tell(widgets::Severity severity, const QString& text, bool slide_in = true, const QString& cause = {});
  /// What closing the window now would end or lose, as phrases.
  [[nodiscard]] QStringList unfinished() const;

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  PageContext context();
  [[nodiscard]] ReviewPage* reviewPage() const;
  [[nodiscard]] DevicesPage* devicesPage() const;
  void buildDocks();
  void connectFeed();
  void connectDevices();
  void showWhetherClosed();
  void chooseDevices(bool own);
  void showLink();
  /// What a line of "Ready?" offers: a command, or "calibrate:PART", the part of a calibration that shows a signal.
  void mend(const QString& command);
  void connectStateBar();
  void connectCommands();
  void connectLook();
  void setTheme(widgets::ThemeChoice choice);
  [[nodiscard]] bool motorsMayBeOn() const;
  void takeWaitingTheme();
  void connectLayouts();
  void recall();
  void remember();
  void stop();
  void quit();
  void ask(pipeline::OperatorAction action);
  void takeSamples(std::span<const pipeline::TelemetrySample> samples);
  void takeNotice(const station::Notice& notice);
  void takeReadiness(const std::vector<widgets::ReadinessRow>& rows);
  void leadToArm();
  /// A notice that a file is written, with a button that shows its folder.
  void tellWritten(const QString& text, const QString& file);

  PlainTexts plain_texts_;  // before there is a label
  std::unique_ptr<Session> session_;
  QString catalogue_;
  WindowMemory memory_;
  TuningBridge tuning_;
  SessionFeed* feed_ = nullptr;
  ConnectionChange* connection_ = nullptr;
  CommandRegistry* commands_ = nullptr;
  KeyGuard* keys_ = nullptr;
  Frame* frame_ = nullptr;
  widgets::LogView* log_ = nullptr;
  QDockWidget* log_dock_ = nullptr;
  FirstSteps* first_steps_ = nullptr;
  MissingDevices* missing_ = nullptr;
  DamagedProfile* damaged_profile_ = nullptr;
  HelpDock* help_ = nullptr;
  LinkDock* link_ = nullptr;
  RecordingControl* recording_ = nullptr;
  TrialRun* trials_ = nullptr;
  CommandPalette* palette_ = nullptr;
  DockSet panels_;
  LayoutsDialog* layouts_ = nullptr;
  NoticeCauses causes_;
  Leaving leaving_;
  pipeline::SafetyState state_ = pipeline::SafetyState::disconnected;
  Layout standard_;  ///< the curves of a first start; the panels' states are empty, which gives the standard layout
  bool arm_once_ = false;
  std::optional<widgets::ThemeChoice> waiting_theme_;
  bool theme_comes_ = false;  ///< the waiting one, in a moment
};

}  // namespace fyd::console
