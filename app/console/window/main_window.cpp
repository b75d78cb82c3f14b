#include "app/console/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDesktopServices>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QScreen>
#include <QTimer>
#include <QUrl>
#include <algorithm>

#include "app/console/calibrate/calibrate_page.h"
#include "app/console/devices/devices_page.h"
#include "app/console/review/review_page.h"
#include "app/console/shell/language.h"
#include "app/console/shell/side_dock.h"
#include "app/console/shell/views.h"
#include "app/console/window/focus_guard.h"
#include "app/console/window/manual.h"
#include "app/console/window/places.h"
#include "core/catalogue/catalogue_delivery.h"
#include "core/device/touchpad/test_motion.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/icon.h"

namespace fyd::console {

using widgets::Severity;

namespace {

const QString kHowToArm = QStringLiteral("arm");  // cause of a notice

}  // namespace

MainWindow::MainWindow(std::unique_ptr<Session> session, const QString& profile_path, const QString& catalogue,
                       const WindowMemory& memory)
    : session_(std::move(session)),
      catalogue_(catalogue),
      memory_(memory),
      tuning_(*session_, profile_path),
      feed_(new SessionFeed(*session_, this)),
      connection_(new ConnectionChange(*session_, *feed_, tuning_, this)),
      commands_(new CommandRegistry(this)),
      keys_(new KeyGuard(this)),
      frame_(new Frame(context(), *commands_, this)),
      first_steps_(new FirstSteps(
          context(), memory_, [this](const QString& place) { frame_->go(place); }, this)),
      missing_(new MissingDevices(
          context(), [this] { chooseDevices(false); }, this)),
      damaged_profile_(new DamagedProfile(context(), profile_path, this)),
      help_(new HelpDock(this)),
      link_(new LinkDock(tuning_.model(), *connection_, this)),
      recording_(new RecordingControl(context(), memoryFile(profile_path), this)),
      trials_(new TrialRun(context(), this)),
      palette_(new CommandPalette(*commands_, this)),
      panels_(*frame_->panelArea(), DockSet::Sharing::tabs),
      layouts_(new LayoutsDialog(
          memory_, [this] { return layoutNow(); }, this)),
      leaving_(*notices(), [this] { quit(); }) {
  setWindowTitle(tr("FYD Console"));
  setWindowIcon(widgets::icon(QStringLiteral("fyd-console")));
  setCentralWidget(frame_);
  buildDocks();
  recording_->connectButton(stateBar()->recordButton());
  recording_->addCommands(*commands_);
  trials_->addCommands(*commands_);
  commands_->fill(*menuBar());
  connectFeed();
  connectDevices();
  connectStateBar();
  connectCommands();
  connectLook();
  connectLayouts();
  reviewPage()->recent().keepIn(memoryFile(profile_path));
  new FocusGuard([this] { return frame_->placeButton(); }, frame_);
  new FileDrop(*this, [this](const QString& file) { review(file); });
  standard_ = {.window = {},
               .operate = {},
               .curves = operate()->curveTools()->choice(),
               .review_curves = reviewPage()->curveTools()->choice()};
  frame_->go(QStringLiteral("operate"));
  recall();
}

MainWindow::~MainWindow() {
  recording_->waitForDisk();
  session_->shutDown();
  delete frame_;  // before tuning_: a field that loses the focus still passes its entry to it
}

PageContext MainWindow::context() {
  return {.session = *session_,
          .feed = *feed_,
          .tuning = tuning_,
          .connection = *connection_,
          .catalogue = catalogue_,
          .tell = [this](Severity severity, const QString& text) { tell(severity, text); },
          .tell_about =
              [this](const QString& cause, Severity severity, const QString& text) {
                notices()->withdraw(cause);
                tell(severity, text, true, cause);
              },
          .over = [this](const QString& cause) { notices()->withdraw(cause); },
          .written = [this](const QString& text, const QString& file) { tellWritten(text, file); }};
}

OperatePage* MainWindow::operate() const { return qobject_cast<OperatePage*>(frame_->page(QStringLiteral("operate"))); }

ReviewPage* MainWindow::reviewPage() const { return qobject_cast<ReviewPage*>(frame_->page(QStringLiteral("review"))); }

DevicesPage* MainWindow::devicesPage() const {
  return qobject_cast<DevicesPage*>(frame_->page(QStringLiteral("devices")));
}

void MainWindow::start() {
  if (const QString other = tuning_.claim().otherProgram(); !other.isEmpty()) {
    tell(Severity::warning, tr("%1 is also open in %2: here it is not saved, and no calibration accepted.")
                                .arg(QDir::toNativeSeparators(tuning_.profilePath()), other));
  }
  session_->start();
  feed_->start();
}

void MainWindow::endWithoutDisplay() {
  session_->requestStop();
  const recording::RecorderStatus recorder = session_->recorderStatus();
  const bool recorded = recorder.state == recording::RecorderState::recording && session_->stopRecording().has_value();
  session_->shutDown();
  if (recorded) (void)catalogue::catalogueRecording(catalogue_.toStdString(), recorder.path);  // what fails here, a scan finds
}

void MainWindow::openPanels(const QStringList& names) {
  for (const QString& name : names) {
    if (name == QStringLiteral("first-steps")) showFirstSteps();
    if (auto* panel = frame_->panelArea()->findChild<QDockWidget*>(name)) {
      panel->show();
      panel->raise();
    }
  }
}

void MainWindow::review(const QString& recording) {
  frame_->go(QStringLiteral("review"));
  reviewPage()->open(recording);
}

void MainWindow::quit() {
  if (leaving_.mayLeave(unfinished())) close();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  // What the program itself closes, as at the end of a time or by a signal, is not asked for again.
  if (event->spontaneous() && !leaving_.mayLeave(unfinished())) {
    event->ignore();
    return;
  }
  session_->requestStop();
  remember();
  recording_->finish();
  session_->shutDown();
  event->accept();
}

void MainWindow::buildDocks() {
  log_ = new widgets::LogView;
  log_dock_ = new SideDock(tr("Log"), QStringLiteral("log_close"), tr("Close the log"), log_, this);
  panels_.add(log_dock_, QStringLiteral("log"), Qt::BottomDockWidgetArea, false);
  panels_.add(link_, QStringLiteral("link"), Qt::RightDockWidgetArea, false);
  panels_.add(help_, QStringLiteral("manual"), Qt::RightDockWidgetArea, false);
  panels_.add(recording_->dock(), QStringLiteral("recording"), Qt::RightDockWidgetArea, false);
}

void MainWindow::connectFeed() {
  connect(feed_, &SessionFeed::telemetry, this, &MainWindow::takeSamples);
  connect(feed_, &SessionFeed::silent, stateBar(), &widgets::StateBar::showSilence);
  connect(feed_, &SessionFeed::parts, stateBar(), &widgets::StateBar::showParts);
  connect(feed_, &SessionFeed::parts, this, &MainWindow::showWhetherClosed);
  connect(feed_, &SessionFeed::link, link_->panel(), &widgets::LinkPanel::setLink);
  connect(feed_, &SessionFeed::notice, this, &MainWindow::takeNotice);
  connect(feed_, &SessionFeed::readiness, this, &MainWindow::takeReadiness);
  connect(&tuning_, &TuningBridge::told, this,
          [this](Severity severity, const QString& text) { tell(severity, text); });
  connect(&tuning_, &TuningBridge::refused, this, [this](const QString& why, const QString& id) {
    context().tell_about(entryCause(id), Severity::warning, why);
  });
  connect(&tuning_.model(), &widgets::TuningModel::taken, this,
          [this](const QString& id) { notices()->withdraw(entryCause(id)); });
  connect(recording_, &RecordingControl::catalogued, reviewPage(), &ReviewPage::showNews);
}

void MainWindow::connectDevices() {
  connect(connection_, &ConnectionChange::leaving, this, [this] {
    arm_once_ = false;
    stateBar()->restart();
  });
  connect(connection_, &ConnectionChange::refreshed, this, &MainWindow::showWhetherClosed);
  connect(connection_, &ConnectionChange::told, this, [this](Severity severity, const QString& text) {
    const QString cause = QStringLiteral("connection");
    notices()->withdraw(cause);  // what the try before came to is no longer so
    tell(severity, text, true, cause);
  });
  connect(connection_, &ConnectionChange::arrived, this,
          [this](const ConnectionWords& words) { memory_.setDevices(words); });
  connect(devicesPage(), &DevicesPage::robotAsked, this, &MainWindow::showLink);
  connect(first_steps_, &FirstSteps::ownAsked, this, [this] { chooseDevices(true); });
  frame_->addStrip(first_steps_->strip());
  frame_->addStrip(missing_->strip());
  frame_->addStrip(damaged_profile_->strip());
}

void MainWindow::showWhetherClosed() {
  stateBar()->showClosed(connection_->closed());
  if (connection_->closed()) state_ = pipeline::SafetyState::disconnected;
}

void MainWindow::chooseDevices(bool own) {
  frame_->go(QStringLiteral("devices"));
  if (own) devicesPage()->form()->askForOwn();
}

void MainWindow::showLink() {
  link_->show();
  link_->raise();  // it may be a tab behind another
}

void MainWindow::connectStateBar() {
  const widgets::StateBar* bar = stateBar();
  connect(keys_, &KeyGuard::stopPressed, this, &MainWindow::stop);
  keys_->setStopButton(bar->stopButton());
  connect(bar, &widgets::StateBar::stopAsked, this, &MainWindow::stop);
  connect(bar, &widgets::StateBar::armAsked, this, [this] { ask(pipeline::OperatorAction::arm); });
  connect(bar, &widgets::StateBar::tareAsked, this, [this] { ask(pipeline::OperatorAction::tare); });
  connect(bar->parts(), &widgets::PartList::opened, this, &MainWindow::showLink);
}

void MainWindow::connectCommands() {
  const auto on = [this](const char* id, auto run) { commands_->on(QLatin1String(id), run); };
  on("session.stop", [this](bool) { stop(); });
  on("session.tare", [this](bool) { ask(pipeline::OperatorAction::tare); });
  on("session.save_profile", [this](bool) { tuning_.save(); });
  on("session.quit", [this](bool) { quit(); });
  on("session.arm", [this](bool) { leadToArm(); });
  connectToggle(commands_->action(QStringLiteral("view.log")), log_dock_);
  connectToggle(commands_->action(QStringLiteral("view.link")), link_);
  connectToggle(commands_->action(QStringLiteral("help.manual")), help_);
  connect(help_, &QDockWidget::visibilityChanged, this, [this](bool shown) {
    if (shown && help_->topic().isEmpty()) help_->showTopic(manualTopic(nullptr, frame_->place()));
  });
  on("help.first_steps", [this](bool) { showFirstSteps(); });
  on("help.context", [this](bool) { help_->showTopic(manualTopic(QApplication::focusWidget(), frame_->place())); });
  on("view.notices_read", [this](bool) { notices()->dismissAll(); });
  on("view.palette", [this](bool) { palette_->open(); });
  connect(operate()->readiness(), &widgets::ReadinessList::commandAsked, this, &MainWindow::mend);
}

void MainWindow::mend(const QString& command) {
  constexpr QLatin1String kPart("calibrate:");
  if (command.startsWith(kPart)) {
    frame_->go(QStringLiteral("calibrate"));
    qobject_cast<CalibratePage*>(frame_->page(QStringLiteral("calibrate")))->choose(command.mid(kPart.size()));
  } else if (command == QLatin1String("view.link")) {
    showLink();  // the menu's command would close it where it is open
  } else if (QAction* action = commands_->action(command)) {
    action->trigger();
  }
}

void MainWindow::connectLook() {
  for (const auto choice : {widgets::ThemeChoice::dark, widgets::ThemeChoice::light, widgets::ThemeChoice::system}) {
    commands_->on(QStringLiteral("view.theme_") + themeWord(choice), [this, choice](bool) {
      memory_.setTheme(choice);
      setTheme(choice);
    });
  }
  for (const Language& language : languages()) {
    const QString code = QLatin1String(language.code);
    commands_->on(QStringLiteral("view.language_") + code, [this, code](bool) {
      if (memory_.setLanguage(code)) {
        tell(Severity::information, tr("The language changes when the window is started again."));
      } else {
        tell(Severity::warning, tr("The language stays: the file of the window's settings cannot be written."));
      }
    });
  }
}

void MainWindow::setTheme(widgets::ThemeChoice choice) {
  // Dressing every widget anew takes almost a second, in which the window hears no key and a real device is Held.
  if (motorsMayBeOn() && !session_->status().loop.waits) {
    waiting_theme_ = choice;
    tell(Severity::information, tr("The theme changes once the motors are off: Esc would not be heard meanwhile."), true,
         QStringLiteral("theme"));
    return;
  }
  waiting_theme_.reset();
  notices()->withdraw(QStringLiteral("theme"));
  widgets::Look::instance().apply(*qApp, choice);
}

bool MainWindow::motorsMayBeOn() const {
  return state_ == pipeline::SafetyState::active || state_ == pipeline::SafetyState::held;  // Held keeps the drives enabled
}

void MainWindow::takeWaitingTheme() {
  if (!waiting_theme_ || motorsMayBeOn() || theme_comes_) return;
  constexpr int kPainted_ms = 300;  // until the state bar says that the motors are off
  theme_comes_ = true;
  QTimer::singleShot(kPainted_ms, this, [this] {
    theme_comes_ = false;
    if (waiting_theme_) setTheme(*waiting_theme_);
  });
}

void MainWindow::connectLayouts() {
  commands_->on(QStringLiteral("view.layouts"), [this](bool) { layouts_->open(); });
  commands_->on(QStringLiteral("view.layout_standard"), [this](bool) { setLayoutTo(standard_); });
  connect(layouts_, &LayoutsDialog::chosen, this, &MainWindow::setLayoutTo);
  connect(layouts_, &LayoutsDialog::standardAsked, this, [this] { setLayoutTo(standard_); });
}

Layout MainWindow::layoutNow() const {
  return {.window = panels_.save(),
          .operate = operate()->panels().save(),
          .curves = operate()->curveTools()->choice(),
          .review_curves = reviewPage()->curveTools()->choice()};
}

void MainWindow::setLayoutTo(const Layout& layout) {
  panels_.restore(layout.window);
  operate()->panels().restore(layout.operate);
  if (layout == Layout{}) return;  // a first start: no layout was saved
  for (const auto& [tools, choice] : {std::pair{operate()->curveTools(), layout.curves},
                                      std::pair{reviewPage()->curveTools(), layout.review_curves}}) {
    const QString left_out = tools->choose(choice);
    if (!left_out.isEmpty()) tell(Severity::warning, left_out, false);
  }
}

void MainWindow::recall() {
  resize(QSize(1280, 720).boundedTo(screen()->availableSize()));
  if (const QByteArray kept = memory_.geometry(); !kept.isEmpty()) restoreGeometry(kept);
  setLayoutTo(memory_.layout());
  frame_->go(memory_.page());
  operate()->curves()->setFocus(Qt::OtherFocusReason);  // not the first button: a stray space bar would record
}

void MainWindow::remember() {
  memory_.setGeometry(saveGeometry());
  memory_.setLayout(layoutNow());
  memory_.setPage(frame_->place());
}

void MainWindow::stop() {
  arm_once_ = false;
  session_->requestStop();
  for (widgets::HoldButton* button : findChildren<widgets::HoldButton*>()) button->stop();
}

void MainWindow::ask(pipeline::OperatorAction action) {
  if (session_->command({.action = action})) return;
  tell(Severity::error, session_->isOpen() ? tr("The station did not take the command: too many at once. Try again.")
                                           : closedText(!connection_->closed()));
}

void MainWindow::takeSamples(std::span<const pipeline::TelemetrySample> samples) {
  const pipeline::TelemetrySample& newest = samples.back();
  state_ = newest.state;
  if (state_ == pipeline::SafetyState::active) notices()->withdraw(kHowToArm);
  stateBar()->showState(newest.state, newest.fault);
  const station::DeviceTestStatus motion = session_->deviceTestStatus();
  stateBar()->showMotion(
      motion.running ? widgets::coreText(device::kDeviceTestNames[static_cast<std::size_t>(motion.test)]) : QString());
  link_->showSample(newest);
  takeWaitingTheme();
  if (arm_once_ && newest.state == pipeline::SafetyState::ready) {
    arm_once_ = false;
    ask(pipeline::OperatorAction::arm);
  }
}

void MainWindow::takeReadiness(const std::vector<widgets::ReadinessRow>& rows) {
  // A row without a fault, as one of an old calibration, does not keep from arming.
  const auto unmet = std::ranges::find_if(
      rows, [](const widgets::ReadinessRow& row) { return !row.ok && row.fault != pipeline::Fault::none; });
  stateBar()->showMissing(unmet == rows.end()
                              ? widgets::MissingNow{}
                              : widgets::MissingNow{.why = unmet->why, .remedy = unmet->remedy, .fault = unmet->fault});
  causes_.look(session_->readiness(), state_, *notices());
  leaving_.look([this] { return unfinished(); });
}

void MainWindow::takeNotice(const station::Notice& notice) {
  if (!notice.of_step) {
    tell(Severity::warning, widgets::coreText(notice.message));
    return;
  }
  tuning_.hear(notice.event);
  if (notice.event.kind == pipeline::EventKind::state_changed) {
    stateBar()->showLateness(widgets::coreText(notice.lateness));
  }
  const Telling telling = tellingOf(notice.event);
  const QString cause = causes_.begin(notice.event, *notices());
  tell(telling.severity, widgets::coreText(notice.message), telling.slides_in, cause);
}

void MainWindow::tell(Severity severity, const QString& text, bool slide_in, const QString& cause) {
  const QString clock = QStringLiteral("HH:mm:ss'%1'zzz").arg(QLocale().decimalPoint());
  log_->add(QTime::currentTime().toString(clock), severity, text);
  if (slide_in) notices()->post({.severity = severity, .text = text, .cause = cause, .actions = {}});
}

void MainWindow::tellWritten(const QString& text, const QString& file) {
  tell(Severity::information, text, false);
  const QString folder = QFileInfo(file).absolutePath();
  notices()->post({.severity = Severity::information,
                   .text = text,
                   .cause = {},
                   .actions = {{QStringLiteral("show_folder"), tr("Show in folder"), [this, folder] {
                                  if (QDesktopServices::openUrl(QUrl::fromLocalFile(folder))) return;
                                  tell(Severity::warning,
                                       tr("This computer opens no folder from here: %1.").arg(folder));
                                }}}});
}

QStringList MainWindow::unfinished() const {
  QStringList out;
  if (state_ == pipeline::SafetyState::active) out << tr("the touchpad renders, motors on");
  if (session_->recorderStatus().state == recording::RecorderState::recording)
    out << tr("a recording is being written");
  if (const QString unsaved = tuning_.unsaved(); !unsaved.isEmpty()) out << unsaved;
  for (const PlaceInfo& place : places()) {
    const QString left = frame_->page(QLatin1String(place.id))->unfinished();
    if (!left.isEmpty()) out << left;
  }
  return out;
}

// Arming stays a deliberate hold.
void MainWindow::leadToArm() {
  stateBar()->armButton()->setFocus(Qt::ShortcutFocusReason);
  if (state_ == pipeline::SafetyState::active) return;
  tell(Severity::information, tr("Hold the space bar, or the mouse on the button, for 0.6 s to arm."), true, kHowToArm);
}

}  // namespace fyd::console
