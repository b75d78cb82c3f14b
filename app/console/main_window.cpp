#include "app/console/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QScreen>

#include "app/console/views.h"
#include "core/sensing/finger_detector.h"
#include "widgets/icon.h"

namespace fyd::console {

using widgets::Severity;

MainWindow::MainWindow(std::unique_ptr<Session> session, const QString& profile_path)
    : session_(std::move(session)),
      tuning_(*session_, profile_path),
      feed_(new SessionFeed(*session_, this)),
      commands_(new CommandRegistry(this)),
      keys_(new KeyGuard(this)),
      page_(new OperatePage(tuning_.model(), this)),
      notices_(new widgets::NoticeStack(page_)),
      link_(new LinkDock(this)),
      palette_(new CommandPalette(*commands_, this)) {
  setWindowTitle(tr("FYD Console"));
  setWindowIcon(widgets::icon(QStringLiteral("fyd-console")));
  setCentralWidget(page_);
  buildLog();
  commands_->fill(*menuBar());
  addDockWidget(Qt::RightDockWidgetArea, link_);
  link_->hide();
  showRobot();
  connectFeed();
  connectPage();
  connectCommands();
  if (session_->simulated()) {
    const sensing::FingerParameters finger = session_->currentProfile().step.sensing.finger;
    page_->camera()->setTouchable([finger](QPointF px) {
      double x_mm = 0.0;
      double y_mm = 0.0;
      sensing::toMillimetres(finger, px.x(), px.y(), x_mm, y_mm);
      return QPointF(x_mm, y_mm);
    });
  }
  resize(QSize(1280, 720).boundedTo(screen()->availableSize()));
}

MainWindow::~MainWindow() {
  session_->shutDown();
  delete page_;  // before the tuning it shows: a field that loses the focus still wants to hand over its entry
}

void MainWindow::start() {
  session_->start();
  feed_->start();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  session_->requestStop();
  session_->shutDown();
  event->accept();
}

void MainWindow::buildLog() {
  log_dock_ = new QDockWidget(tr("Log"), this);
  log_dock_->setFeatures(QDockWidget::NoDockWidgetFeatures);
  log_dock_->setTitleBarWidget(new QWidget(log_dock_));  // the search field says what it is
  log_ = new widgets::LogView(log_dock_);
  log_dock_->setWidget(log_);
  addDockWidget(Qt::BottomDockWidgetArea, log_dock_);
  log_dock_->hide();
}

void MainWindow::connectFeed() {
  connect(feed_, &SessionFeed::telemetry, this, &MainWindow::takeSamples);
  connect(feed_, &SessionFeed::silent, page_->stateBar(), &widgets::StateBar::showSilence);
  connect(feed_, &SessionFeed::picture, this,
          [this](const station::CameraView& view) { page_->camera()->setPicture(toCameraPicture(view)); });
  connect(feed_, &SessionFeed::cameraMissing, page_->camera(), &widgets::CameraPanel::showMissing);
  connect(feed_, &SessionFeed::parts, page_->stateBar(), &widgets::StateBar::showParts);
  connect(feed_, &SessionFeed::link, link_->panel(), &widgets::LinkPanel::setLink);
  connect(feed_, &SessionFeed::silent, link_, &LinkDock::showSilence);
  connect(feed_, &SessionFeed::readiness, page_->readiness(), &widgets::ReadinessList::setRows);
  connect(feed_, &SessionFeed::notice, this, &MainWindow::takeNotice);
  connect(&tuning_, &TuningBridge::told, this,
          [this](Severity severity, const QString& text) { tell(severity, text); });
}

void MainWindow::connectPage() {
  connect(keys_, &KeyGuard::stopPressed, this, &MainWindow::stop);
  connect(page_->stateBar(), &widgets::StateBar::stopAsked, this, &MainWindow::stop);
  connect(page_->stateBar(), &widgets::StateBar::armAsked, this, [this] { ask(pipeline::OperatorAction::arm); });
  connect(page_->stateBar(), &widgets::StateBar::tareAsked, this, [this] { ask(pipeline::OperatorAction::tare); });
  connect(page_->stateBar()->parts(), &widgets::PartList::opened, commands_->action(QStringLiteral("view.link")),
          &QAction::trigger);
  connect(link_->form(), &widgets::RobotForm::reconnectAsked, this,
          [this](const QString& robot, const QString& key_file) {
            reconnect({.robot = robot.toStdString(), .key_file = key_file.toStdString()});
          });
  connect(page_->tuning(), &widgets::TuningPanel::targetByHandAsked, &tuning_, &TuningBridge::targetByHand);
  connect(page_->tuning(), &widgets::TuningPanel::targetFromRobotAsked, &tuning_, &TuningBridge::targetFromRobot);
  connect(page_->tuning(), &widgets::TuningPanel::saveAsked, &tuning_, &TuningBridge::save);
  connect(page_->tuning(), &widgets::TuningPanel::refused, this,
          [this](const QString& why) { tell(Severity::warning, why); });
  const widgets::CameraImage* image = page_->camera()->image();
  connect(image, &widgets::CameraImage::fingerMoved, this,
          [this](double x_mm, double y_mm, double depth_mm) { session_->moveSimulatedFinger(x_mm, y_mm, depth_mm); });
  connect(image, &widgets::CameraImage::fingerReleased, this, [this] { session_->releaseSimulatedFinger(); });
}

void MainWindow::connectCommands() {
  const auto on = [this](const char* id, auto run) { commands_->on(QLatin1String(id), run); };
  on("session.stop", [this](bool) { stop(); });
  on("session.tare", [this](bool) { ask(pipeline::OperatorAction::tare); });
  on("session.target_from_robot", [this](bool) { page_->tuning()->fromRobotButton()->click(); });
  on("session.target_by_hand", [this](bool) { page_->tuning()->byHandButton()->click(); });
  on("session.save_profile", [this](bool) { tuning_.save(); });
  on("session.quit", [this](bool) { close(); });
  on("edit.undo", [this](bool) { tuning_.model().undoStack()->undo(); });
  on("edit.redo", [this](bool) { tuning_.model().undoStack()->redo(); });
  on("curves.pause", [this](bool) { page_->curves()->togglePause(); });
  on("curves.follow", [this](bool) { page_->curves()->follow(); });
  for (const int span_s : {5, 10, 30, 60}) {
    commands_->on(QStringLiteral("curves.span_%1").arg(span_s),
                  [this, span_s](bool) { page_->curves()->chooseSpan(span_s); });
  }
  QToolButton* mask = page_->camera()->maskButton();
  on("view.mask", [mask](bool shown) { mask->setChecked(shown); });
  QAction* mask_action = commands_->action(QStringLiteral("view.mask"));
  mask_action->setChecked(mask->isChecked());
  connect(mask, &QToolButton::toggled, mask_action, &QAction::setChecked);
  on("view.log", [this](bool shown) {
    log_dock_->setVisible(shown);
    resizeDocks({log_dock_}, {18 * widgets::kGrid}, Qt::Vertical);
  });
  connect(log_dock_, &QDockWidget::visibilityChanged, commands_->action(QStringLiteral("view.log")),
          &QAction::setChecked);
  on("view.link", [this](bool shown) { link_->setVisible(shown); });
  connect(link_, &QDockWidget::visibilityChanged, commands_->action(QStringLiteral("view.link")), &QAction::setChecked);
  on("view.notices_read", [this](bool) { notices_->dismissAll(); });
  const auto look = [](widgets::ThemeChoice choice) { widgets::Look::instance().apply(*qApp, choice); };
  on("view.theme_dark", [look](bool) { look(widgets::ThemeChoice::dark); });
  on("view.theme_light", [look](bool) { look(widgets::ThemeChoice::light); });
  on("view.theme_system", [look](bool) { look(widgets::ThemeChoice::system); });
  on("view.palette", [this](bool) { palette_->open(); });
}

void MainWindow::showRobot() {
  const RobotWords now = session_->robot();
  link_->form()->setRobot(QString::fromStdString(now.robot), QString::fromStdString(now.key_file));
  page_->tuning()->showTargetByHand(now.robot == "none");  // as a station starts then
}

void MainWindow::reconnect(const RobotWords& wanted) {
  feed_->pump();  // what the ending session still has to say, its state above all
  if (!link_->mayReconnect()) return;
  arm_once_ = false;
  const auto done = session_->reconnect(wanted);
  link_->restart(session_->isOpen());
  feed_->restart();
  tuning_.restart();
  if (done) {
    showRobot();
    tell(Severity::information, tr("Robot is now: %1.").arg(QString::fromStdString(wanted.robot)));
    return;
  }
  // The former robot's station is a new one as well, and starts with the robot's target.
  if (session_->isOpen() && page_->tuning()->byHandButton()->isChecked()) tuning_.targetByHand();
  const QString why = QString::fromStdString(done.error().message);
  tell(Severity::error, session_->isOpen() ? tr("Robot not changed. %1.").arg(why)
                                           : tr("The session is closed. %1. Choose another robot.").arg(why));
}

void MainWindow::stop() {
  arm_once_ = false;
  session_->requestStop();
}

void MainWindow::ask(pipeline::OperatorAction action) {
  if (!session_->command({.action = action})) {
    tell(Severity::error, tr("The station did not take the command: too many at once. Try again."));
  }
}

void MainWindow::takeSamples(std::span<const pipeline::TelemetrySample> samples) {
  page_->curves()->append(samples);
  const pipeline::TelemetrySample& newest = samples.back();
  page_->stateBar()->showState(newest.state, newest.lack);
  link_->showState(newest.state);
  if (arm_once_ && newest.state == pipeline::SafetyState::ready) {
    arm_once_ = false;
    ask(pipeline::OperatorAction::arm);
  }
}

void MainWindow::takeNotice(const station::Notice& notice) {
  tuning_.hear(notice.event);
  const Telling telling = tellingOf(notice.event);
  tell(telling.severity, QString::fromStdString(notice.text), telling.slides_in);
}

void MainWindow::tell(Severity severity, const QString& text, bool slide_in) {
  log_->add(QTime::currentTime().toString(QStringLiteral("HH:mm:ss.zzz")), severity, text);
  if (slide_in) notices_->post(severity, text);
}

}  // namespace fyd::console
