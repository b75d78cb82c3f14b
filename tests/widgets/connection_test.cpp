// Devices are chosen and connected in the window: by address to a simulated touchpad that is served over the network,
// wrong ones, while something can move, with the touchpad gone and back; what a start remembers; the first steps.
#include "app/console/calibrate/calibrate_page.h"
#include "app/console/window/start.h"
#include "core/sim/server/touchpad_process.h"
#include "tests/widgets/hands.h"
#include "tests/widgets/suite.h"
#include "widgets/devices/cable_text.h"
#include "widgets/devices/device_text.h"

namespace fyd::tests {

using pipeline::SafetyState;

namespace {

/// A touchpad of one's own on the network, with its camera.
class NetworkTouchpad {
 public:
  NetworkTouchpad() { switchOn(); }
  void switchOn() {
    const auto at = [](std::uint16_t port) {
      return protocol::parseEndpoint(fmt::format("127.0.0.1:{}", port)).value();
    };
    sim::TouchpadProcessOptions options;
    options.modbus_tcp = at(port_);
    options.camera_mjpeg = at(camera_port_);
    WAIT_FOR((process_ = started(options)) != nullptr);
    port_ = process_->modbusPort();
    camera_port_ = process_->cameraPort();
  }
  void switchOff() { process_.reset(); }
  [[nodiscard]] QString address() const { return QStringLiteral("127.0.0.1:%1").arg(port_); }
  [[nodiscard]] QString camera() const { return QStringLiteral("http://127.0.0.1:%1/").arg(camera_port_); }

 private:
  static std::unique_ptr<sim::TouchpadProcess> started(sim::TouchpadProcessOptions options) {
    auto process = sim::TouchpadProcess::start(std::move(options));
    return process ? std::move(*process) : nullptr;
  }
  std::unique_ptr<sim::TouchpadProcess> process_;
  std::uint16_t port_ = 0;
  std::uint16_t camera_port_ = 0;
};

/// A start of the program without options: what it reads, it reads from the files of the start before.
struct Started {
  explicit Started(const QTemporaryDir& folder) : profile(folder.filePath(QStringLiteral("profile.toml"))) {
    const console::WindowMemory memory(console::memoryFile(profile));
    start = console::readStart({}, profile, memory).value();
    auto opened = console::openStart(start).value();
    window = std::make_unique<console::MainWindow>(std::move(opened.session), profile, QString(), memory);
    window->show();
    window->activateWindow();
    (void)QTest::qWaitForWindowActive(window.get(), kPatience_ms);
    window->start();
    if (start.first) window->showFirstSteps();
    if (!start.damaged_profile.empty()) {
      window->tellDamagedProfile(start.damaged_profile);
    } else if (start.devices_remembered) {
      window->expectDevices(opened.missing);
    }
  }
  [[nodiscard]] std::optional<console::ConnectionWords> remembered() const {
    return console::WindowMemory(console::memoryFile(profile)).devices();
  }
  [[nodiscard]] QString state() const { return window->stateBar()->stateWord(); }
  [[nodiscard]] widgets::ConnectionForm* form() const {
    return qobject_cast<console::DevicesPage*>(window->frame()->page(QStringLiteral("devices")))->form();
  }
  [[nodiscard]] QString present() const { return QString::fromStdString(window->connection().present().touchpad); }

  QString profile;
  console::Start start;
  std::unique_ptr<console::MainWindow> window;
};

void enter(widgets::PartChoice* part, int kind, const QString& text) {
  part->kind()->setCurrentIndex(kind);
  part->entry()->setFocus();
  part->entry()->lineEdit()->selectAll();
  QTest::keyClicks(part->entry()->lineEdit(), text);
}

constexpr int kNetwork = 1;  // of the touchpad's kinds
constexpr int kStream = 2;   // of the camera's kinds

void connectTo(const Started& day, const NetworkTouchpad& touchpad) {
  day.window->frame()->go(QStringLiteral("devices"));
  enter(day.form()->touchpad(), kNetwork, touchpad.address());
  enter(day.form()->camera(), kStream, touchpad.camera());
  WAIT_FOR(day.form()->connectButton()->isEnabled());
  click(day.form()->connectButton());
  WAIT_EQUAL(day.present(), QStringLiteral("modbus-tcp:") + touchpad.address());
  WAIT_FOR(day.window->connection().work().isEmpty());
}

void stationSays(const Fixture& f, SafetyState state, bool contact = false) {
  f.session->say(state);
  f.session->telemetry.back().contact = contact;
  f.window->feed().pump();
}

}  // namespace

class ConnectionTest : public QObject {
  Q_OBJECT
 private slots:
  void fromTheFirstStartATouchpadIsConnectedByItsAddressAndRemembered() {
    const QTemporaryDir folder;
    NetworkTouchpad touchpad;
    int clicks = 0;
    const auto press = [&clicks](QWidget* widget) {
      click(widget);
      ++clicks;
    };
    {
      const Started day(folder);
      QVERIFY(day.start.first && day.window->firstSteps()->strip()->isVisible());
      WAIT_FOR(day.state() != QStringLiteral("Unknown"));
      press(day.window->firstSteps()->strip()->button(QStringLiteral("first_own")));
      QCOMPARE(day.window->frame()->place(), QStringLiteral("devices"));
      WAIT_FOR(day.form()->touchpad()->entry()->hasFocus() || day.form()->touchpad()->entry()->lineEdit()->hasFocus());
      QTest::keyClicks(QApplication::focusWidget(), touchpad.address());
      // The camera's list, its entry, and the address.
      day.form()->camera()->kind()->setCurrentIndex(kStream);
      clicks += 2;
      press(day.form()->camera()->entry());
      QTest::keyClicks(day.form()->camera()->entry()->lineEdit(), touchpad.camera());
      WAIT_FOR(day.form()->connectButton()->isEnabled());
      press(day.form()->connectButton());
      WAIT_EQUAL(day.present(), QStringLiteral("modbus-tcp:") + touchpad.address());
      QCOMPARE(clicks, 5);
      WAIT_EQUAL(day.state(), QStringLiteral("Ready"));
      // Each step is ticked by what is so.
      const auto& steps = day.window->firstSteps()->strip()->steps();
      WAIT_FOR(steps[0].done && steps[1].done);
      QVERIFY(!steps[2].done && !steps[3].done);
      QCOMPARE(day.remembered()->touchpad, day.present().toStdString());
      day.window->close();
    }
    const Started next(folder);
    QVERIFY(!next.start.first && next.start.devices_remembered);
    QCOMPARE(next.present(), QStringLiteral("modbus-tcp:") + touchpad.address());
    WAIT_EQUAL(next.state(), QStringLiteral("Ready"));
    QVERIFY(!next.window->missing()->strip()->isVisible());
    next.window->close();
  }

  void whatCannotWorkIsSaidAtItsFieldAndTheSessionGoesOn() {
    const QTemporaryDir folder;
    const Started day(folder);
    NetworkTouchpad touchpad;
    touchpad.switchOff();
    WAIT_EQUAL(day.state(), QStringLiteral("Ready"));
    day.window->frame()->go(QStringLiteral("devices"));
    for (const auto& [address, camera] : {std::pair{QStringLiteral("nonsense"), QStringLiteral("no such folder/")},
                                          std::pair{touchpad.address(), touchpad.camera()}}) {
      enter(day.form()->touchpad(), kNetwork, address);
      enter(day.form()->camera(), kStream, camera);
      WAIT_FOR(day.form()->connectButton()->isEnabled());
      click(day.form()->connectButton());
      QVERIFY(!day.window->connection().work().isEmpty());
      WAIT_FOR(day.window->connection().work().isEmpty());
      QVERIFY2(!day.form()->touchpad()->problem().isEmpty(), qPrintable(address));
      QVERIFY2(!day.form()->camera()->problem().isEmpty(), qPrintable(camera));
      QVERIFY(day.form()->motors()->problem().isEmpty());
      QCOMPARE(day.present(), QStringLiteral("simulated"));
      WAIT_EQUAL(day.state(), QStringLiteral("Ready"));
    }
    QVERIFY2(day.form()->touchpad()->problem().contains(touchpad.address()),
             qPrintable(day.form()->touchpad()->problem()));
    QVERIFY(!day.remembered());
    // What is entered anew is not the one that failed.
    QTest::keyClicks(day.form()->touchpad()->entry()->lineEdit(), QStringLiteral("1"));
    QVERIFY(day.form()->touchpad()->problem().isEmpty());
    day.window->close();
  }

  void whatWasSaidOfATryGoesWithTheNext() {
    Fixture f;
    f.window->frame()->go(QStringLiteral("devices"));
    stationSays(f, SafetyState::ready);
    f.window->connection().change({.touchpad = "modbus-tcp:bad"});
    WAIT_EQUAL(f.window->notices()->count(), 1);
    QVERIFY(f.window->notices()->text(0).contains(QStringLiteral("bad by the script")));
    WAIT_FOR(f.window->connection().work().isEmpty());
    changeDevices(f, {.touchpad = "modbus-tcp:10.0.0.7:502"});
    QCOMPARE(f.session->present.touchpad, std::string("modbus-tcp:10.0.0.7:502"));
    QCOMPARE(f.window->notices()->count(), 1);
    QVERIFY(f.window->notices()->text(0).contains(QStringLiteral("Connected")));
    // Of the new session nothing is known yet, least of all that it is ready.
    QCOMPARE(f.window->stateBar()->stateWord(), QStringLiteral("Starting"));
    QVERIFY(!f.window->stateBar()->armButton()->isEnabled());
  }

  void aClosedSessionSaysSoAndWhatToDo() {
    Fixture f;
    std::vector<widgets::PartView> parts;
    connect(&f.window->feed(), &console::SessionFeed::parts, this, [&](const auto& shown) { parts = shown; });
    f.session->view.picture = cv::Mat(240, 320, CV_8UC1, cv::Scalar(200));
    f.session->view.number = 57;
    stationSays(f, SafetyState::ready);
    QVERIFY(!parts.empty() && f.window->stateBar()->armButton()->isEnabled());
    f.session->open = f.session->takes_commands = false;
    f.session->view = {};
    f.window->feed().pump();
    const widgets::StateBar* bar = f.window->stateBar();
    QCOMPARE(bar->stateWord(), QStringLiteral("Closed"));
    QVERIFY2(bar->stateReason().contains(QStringLiteral("Devices")), qPrintable(bar->stateReason()));
    QVERIFY(!bar->armButton()->isEnabled());
    QVERIFY(parts.empty());  // above all no loop that is well
    const widgets::CameraImage* image = f.window->operate()->camera()->image();
    QVERIFY(image->picture().isNull());
    QVERIFY2(image->emptyText().contains(QStringLiteral("closed")), qPrintable(image->emptyText()));
    for (const char* id : {"session.tare", "session.target_by_hand", "session.target_from_robot"}) {
      f.window->notices()->dismissAll();
      f.window->commands().action(QLatin1String(id))->trigger();
      QVERIFY2(f.window->notices()->shownText().contains(QStringLiteral("The session is closed")), id);
    }
    // Devices that are asked do not open it; one that is being opened starts.
    f.session->reads_long = true;
    f.window->connection().change({.touchpad = "modbus-tcp:10.0.0.7:502"});
    f.window->feed().pump();
    QCOMPARE(bar->stateWord(), QStringLiteral("Closed"));
    f.session->opens_long = true;
    f.session->reads_long = false;
    WAIT_EQUAL(bar->stateWord(), QStringLiteral("Starting"));
    f.window->feed().pump();
    const auto* calibrate = qobject_cast<console::CalibratePage*>(f.window->frame()->page(QStringLiteral("calibrate")));
    const QString comes = QStringLiteral("Other devices are being connected");
    QVERIFY2(image->emptyText().contains(comes), qPrintable(image->emptyText()));
    QVERIFY2(calibrate->picture()->emptyText().contains(comes), qPrintable(calibrate->picture()->emptyText()));
    for (const char* id : {"session.tare", "session.target_by_hand", "session.target_from_robot"}) {
      f.window->notices()->dismissAll();
      f.window->commands().action(QLatin1String(id))->trigger();
      QVERIFY2(f.window->notices()->shownText().contains(comes), id);
    }
    f.session->opens_long = false;
    WAIT_FOR(f.window->connection().work().isEmpty());
    f.window->feed().pump();
    QCOMPARE(bar->stateWord(), QStringLiteral("Starting"));
    QCOMPARE(image->emptyText(), QStringLiteral("No picture yet."));
    QCOMPARE(calibrate->picture()->emptyText(), QStringLiteral("No picture yet."));
    QVERIFY(!parts.empty());
  }

  void whatALibraryThrowsWhileDevicesAreChangedIsSaidAndTheyCanBeChangedAgain() {
    Fixture f;
    const console::ConnectionWords wanted{.touchpad = "modbus-tcp:10.0.0.7:502"};
    const auto told = [&] { return f.window->notices()->text(f.window->notices()->count() - 1); };
    stationSays(f, SafetyState::ready);
    f.session->check_throws = true;
    f.window->connection().change(wanted);
    QVERIFY(!f.window->connection().work().isEmpty());
    WAIT_FOR(f.window->connection().work().isEmpty());
    QCOMPARE(told(), QStringLiteral("Not connected; all is as it was. bad check by the script."));
    QVERIFY(f.session->open);
    f.session->check_throws = false;
    f.session->opening_throws = true;
    stationSays(f, SafetyState::ready);
    f.window->connection().change(wanted);
    WAIT_FOR(f.window->connection().closed());
    WAIT_FOR(f.window->connection().work().isEmpty());
    QCOMPARE(told(), QStringLiteral("The session is closed. bad opening by the script. Choose other devices."));
    QCOMPARE(f.window->stateBar()->stateWord(), QStringLiteral("Closed"));
    f.session->opening_throws = false;
    changeDevices(f, wanted);
    QCOMPARE(f.session->present.touchpad, wanted.touchpad);
    QVERIFY(f.window->session().isOpen());
  }

  void aCamerasPasswordIsNotShown() {
    const console::ConnectionWords words{.camera = "rtsp://lab:s3cret@10.0.0.5/live"};
    for (const QString& shown : {console::inWords(words), widgets::cableRemedy(pipeline::Fault::camera_stale, words)}) {
      QVERIFY2(shown.contains(QStringLiteral("rtsp://10.0.0.5/live")), qPrintable(shown));
      QVERIFY2(!shown.contains(QStringLiteral("s3cret")), qPrintable(shown));
    }
  }

  void theCurvesTimeIsThatOfTheSessionThatIsShown() {
    Fixture f;
    const widgets::CurveView* curves = f.window->operate()->curves();
    const auto begins_anew = [&] {
      f.session->say(SafetyState::ready);
      f.window->feed().pump();
      return curves->buffer().size() == 1 && curves->buffer().firstTime_s() == 0.0 && curves->following() &&
             !std::isfinite(curves->stack()->cursor_s()) &&
             !std::isfinite(curves->stack()->mark_s(widgets::CurveStack::Mark::a));
    };
    const auto look_back = [&] {
      for (int i = 0; i < 5; ++i) f.session->say(SafetyState::ready);
      f.window->feed().pump();
      QVERIFY(curves->buffer().lastTime_s() > 0.003);
      f.window->operate()->curves()->setMark(widgets::CurveStack::Mark::a);
      f.window->operate()->curves()->goTo(0.002);
      QVERIFY(!curves->following());
    };
    look_back();
    changeDevices(f, {.touchpad = "modbus-tcp:10.0.0.7:502"});
    QVERIFY(begins_anew());
    QVERIFY(curves->timeWindow().to_s() == 0.0);
    look_back();
    f.session->refuses = true;  // the former devices are back, with a session of their own
    changeDevices(f, {.touchpad = "simulated"});
    QVERIFY(begins_anew());
  }

  void theFocusStaysAtConnectWhileItWorks() {
    Fixture f;
    f.window->frame()->go(QStringLiteral("devices"));
    stationSays(f, SafetyState::ready);
    widgets::ConnectionForm* form = devicesOf(f)->form();
    form->connectButton()->setFocus();
    form->setWork(QStringLiteral("working"), false);
    QVERIFY(!form->connectButton()->hasFocus());
    form->setWork({}, false);
    QVERIFY(form->connectButton()->hasFocus());
  }

  void connectStaysWhereItIsWhateverIsChosenOrSaidAboveIt() {
    Fixture f;
    f.window->resize(1280, 720);
    f.window->frame()->go(QStringLiteral("devices"));
    stationSays(f, SafetyState::ready);
    widgets::ConnectionForm* form = devicesOf(f)->form();
    const auto place = [&] {
      passTimers(50);
      return QRect(form->connectButton()->mapTo(f.window.get(), QPoint(0, 0)), form->connectButton()->size());
    };
    const QRect before = place();
    QVERIFY(before.isValid() && f.window->rect().contains(before));
    form->touchpad()->kind()->setCurrentIndex(1);  // a field for the address
    QCOMPARE(place(), before);
    form->touchpad()->entry()->setEditText(QStringLiteral("10.0.0.7:502"));
    form->touchpad()->setProblem(QStringLiteral("It does not answer: check power and cable. ").repeated(3));
    QCOMPARE(place(), before);
    form->touchpad()->entry()->setEditText(QStringLiteral("10.0.0.8:502"));  // the words go
    QCOMPARE(place(), before);
    form->setWork(QStringLiteral("Asking. ").repeated(30), true);
    QCOMPARE(place(), before);
    form->setWork({}, false);
    QCOMPARE(place(), before);
  }

  void theFirstStartMakesTheFolderOfTheProfileSoThatASecondWindowIsTold() {
    const QTemporaryDir folder;
    const QString profile = folder.filePath(QStringLiteral("new/profile.toml"));
    (void)console::readStart({}, profile, console::WindowMemory(console::memoryFile(profile)));
    widgets::FileClaim first(profile);
    widgets::FileClaim second(profile);
    QVERIFY(first.otherProgram().isEmpty() && !second.otherProgram().isEmpty());
  }

  void aRealTouchpadNeedsACamera() {
    const QTemporaryDir folder;
    const Started day(folder);
    const NetworkTouchpad touchpad;
    WAIT_EQUAL(day.state(), QStringLiteral("Ready"));
    day.window->frame()->go(QStringLiteral("devices"));
    enter(day.form()->touchpad(), kNetwork, touchpad.address());
    QVERIFY(day.form()->camera()->kind()->currentIndex() != 0);  // asked for by itself
    day.form()->camera()->kind()->setCurrentIndex(0);
    WAIT_FOR(day.form()->connectButton()->isEnabled());
    click(day.form()->connectButton());
    WAIT_FOR(day.window->connection().work().isEmpty());
    QVERIFY(!day.form()->camera()->problem().isEmpty() && day.form()->touchpad()->problem().isEmpty());
    QCOMPARE(day.present(), QStringLiteral("simulated"));
    day.window->close();
  }

  void aTouchpadThatIsSwitchedOffIsSaidAndComesBackUnarmed() {
    const QTemporaryDir folder;
    NetworkTouchpad touchpad;
    const Started day(folder);
    WAIT_EQUAL(day.state(), QStringLiteral("Ready"));
    connectTo(day, touchpad);
    WAIT_EQUAL(day.state(), QStringLiteral("Ready"));
    touchpad.switchOff();
    WAIT_FOR(day.state() != QStringLiteral("Ready"));
    touchpad.switchOn();
    WAIT_EQUAL(day.state(), QStringLiteral("Ready"));
    // Back to the simulation, which brings its own pictures.
    day.form()->touchpad()->kind()->setCurrentIndex(0);
    day.form()->camera()->kind()->setCurrentIndex(0);
    click(day.form()->connectButton());
    WAIT_EQUAL(day.present(), QStringLiteral("simulated"));
    WAIT_EQUAL(day.state(), QStringLiteral("Ready"));
    QCOMPARE(day.remembered()->touchpad, std::string("simulated"));
    day.window->close();
  }

  void nothingIsConnectedWhileSomethingCanMoveOrIsRecorded() {
    Fixture f;
    f.window->frame()->go(QStringLiteral("devices"));
    const widgets::ConnectionForm* form = devicesOf(f)->form();
    QVERIFY(!form->connectButton()->isEnabled());  // no state known yet
    for (const auto& [state, allowed] : {std::pair{SafetyState::ready, true},
                                         {SafetyState::active, false},
                                         {SafetyState::stopped, true},
                                         {SafetyState::held, false},
                                         {SafetyState::disconnected, true}}) {
      stationSays(f, state);
      QCOMPARE(form->connectButton()->isEnabled(), allowed);
      QCOMPARE(form->hint().contains(QStringLiteral("Esc first")), !allowed);
    }
    // Armed since the button was painted.
    f.session->say(SafetyState::active);
    click(form->connectButton());
    QCOMPARE(f.session->checks, 0);
    QVERIFY(f.session->asked.empty());
    // Armed while the devices are asked.
    stationSays(f, SafetyState::ready);
    f.session->reads_long = true;
    click(form->connectButton());
    QCOMPARE(form->connectButton()->text(), QStringLiteral("Cancel"));
    stationSays(f, SafetyState::active);
    f.session->reads_long = false;
    WAIT_EQUAL(form->connectButton()->text(), QStringLiteral("Connect"));
    QVERIFY(f.session->asked.empty() && f.session->open);
    const auto told = [&] { return f.window->notices()->text(f.window->notices()->count() - 1); };
    QCOMPARE(told(),
             QStringLiteral("Not connected. Devices can be changed only while nothing can move. Press Esc first."));
    // A recording is begun while the devices are asked.
    stationSays(f, SafetyState::ready);
    f.session->reads_long = true;
    click(form->connectButton());
    f.session->recorder.state = recording::RecorderState::recording;
    stationSays(f, SafetyState::ready);
    f.session->reads_long = false;
    WAIT_EQUAL(form->connectButton()->text(), QStringLiteral("Connect"));
    QVERIFY(f.session->asked.empty() && f.session->open);
    QVERIFY2(told().startsWith(QStringLiteral("Not connected. ")), qPrintable(told()));
    // A recording would end.
    f.session->recorder.state = recording::RecorderState::recording;
    stationSays(f, SafetyState::ready);
    QVERIFY(!form->connectButton()->isEnabled());
    QVERIFY2(form->hint().contains(QStringLiteral("recording")), qPrintable(form->hint()));
  }

  void whatIsChosenIsAskedForInTheStationsWordsAndAFailureLeavesTheFormer() {
    Fixture f;
    f.window->frame()->go(QStringLiteral("devices"));
    widgets::ConnectionForm* form = devicesOf(f)->form();
    stationSays(f, SafetyState::ready);
    form->touchpad()->setWord(QStringLiteral("modbus-rtu:/dev/ttyUSB0:1000000"));
    QVERIFY(!form->connectButton()->isEnabled());  // no camera yet
    form->motors()->setWord(QStringLiteral("qbmove:/dev/ttyUSB1"));
    form->camera()->setWord(QStringLiteral("id=99F1"));
    QVERIFY(form->connectButton()->isEnabled());
    f.session->refuses = true;
    click(form->connectButton());
    WAIT_EQUAL(f.session->asked.size(), std::size_t{1});
    QCOMPARE(f.session->asked[0].touchpad, std::string("modbus-rtu:/dev/ttyUSB0:1000000"));
    QCOMPARE(f.session->asked[0].motors, std::string("qbmove:/dev/ttyUSB1"));
    QCOMPARE(f.session->asked[0].camera, std::string("id=99F1"));
    QCOMPARE(f.session->asked[0].robot, std::string("simulated"));  // as it was
    QCOMPARE(f.session->present.touchpad, std::string("simulated"));
    // For every kind of camera the word comes back as it was given.
    for (const char* word :
         {"", "0", "/dev/video2", "rtsp://10.0.0.9/x", "recording:/s/one.h5", "pictures/", "press.avi"}) {
      form->camera()->setWord(QLatin1String(word));
      QCOMPARE(form->camera()->word(), QLatin1String(word));
    }
  }

  void theWheelOverAListScrollsAndWhatWasTypedForAKindStaysWithIt() {
    Fixture f;
    f.window->frame()->go(QStringLiteral("devices"));
    widgets::ConnectionForm* form = devicesOf(f)->form();
    const auto turnOver = [](QWidget* list, int by) {
      const QPointF at = list->rect().center();
      QWheelEvent wheel(at, list->mapToGlobal(at), {}, QPoint(0, by), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                        false);
      QApplication::sendEvent(list, &wheel);
    };
    const QStringList ports = {QStringLiteral("/dev/ttyUSB0"), QStringLiteral("/dev/ttyUSB1")};
    widgets::PartChoice* touchpad = form->touchpad();
    const QString address = QStringLiteral("10.0.0.7:502");
    enter(touchpad, kNetwork, address);
    form->camera()->entry()->setFocus();
    for (const int by : {120, -120, -120}) turnOver(touchpad->kind(), by);
    QCOMPARE(touchpad->word(), QStringLiteral("modbus-tcp:") + address);
    QVERIFY(!touchpad->kind()->hasFocus());
    form->offer(ports, {});
    form->motors()->setWord(QStringLiteral("qbmove:/dev/mine"));
    for (const int by : {-120, 120}) turnOver(form->motors()->entry(), by);
    QCOMPARE(form->motors()->word(), QStringLiteral("qbmove:/dev/mine"));
    widgets::RobotForm robot;
    turnOver(robot.kind(), -120);
    QCOMPARE(robot.kind()->currentIndex(), 0);
    // Where the focus is, the wheel chooses; and each kind has its own entry, which waits there.
    touchpad->kind()->setFocus();
    WAIT_FOR(touchpad->kind()->hasFocus());
    form->offer(ports, {});
    turnOver(touchpad->kind(), -120);
    QCOMPARE(touchpad->word(), QStringLiteral("modbus-rtu:/dev/ttyUSB0"));
    turnOver(touchpad->kind(), 120);
    QCOMPARE(touchpad->word(), QStringLiteral("modbus-tcp:") + address);
  }

  void whatASearchFoundGoesIntoTheForm() {
    Fixture f;
    console::DevicesPage* page = devicesOf(f);
    using enum widgets::FoundRow::Use;
    page->setSearch({{QStringLiteral("Serial port"),
                      QStringLiteral("ports"),
                      [] {
                        return std::vector<device::FoundDevice>{
                            {.path = "/dev/ttyUSB7", .node = "/dev/ttyUSB7", .name = {}, .problem = {}}};
                      },
                      {touchpad, motors}},
                     {QStringLiteral("Camera"),
                      QStringLiteral("cameras"),
                      [] {
                        return std::vector<device::FoundDevice>{
                            {.path = "/dev/video3", .node = "/dev/video3", .name = {}, .problem = {}}};
                      },
                      {camera}}});
    f.window->frame()->go(QStringLiteral("devices"));
    WAIT_EQUAL(page->found()->count(), 2);
    QList<QToolButton*> uses = page->found()->findChildren<QToolButton*>();
    QCOMPARE(uses.size(), 3);
    uses[1]->click();
    QCOMPARE(page->form()->devices().motors, QStringLiteral("qbmove:/dev/ttyUSB7"));
    uses[0]->click();
    QCOMPARE(page->form()->devices().touchpad, QStringLiteral("modbus-rtu:/dev/ttyUSB7"));
    QCOMPARE(page->form()->devices().camera, QStringLiteral("/dev/video3"));  // the only one found
  }

  void whatIsWrongWithAPartStaysWhenASearchEnds() {
    widgets::ConnectionForm form;
    form.setDevices({.touchpad = QStringLiteral("modbus-rtu:/dev/ttyUSB4"),
                     .motors = QStringLiteral("qbmove:/dev/ttyUSB5"),
                     .camera = QStringLiteral("/dev/video9")});
    const QString why = QStringLiteral("no such port");
    for (widgets::PartChoice* part : {form.touchpad(), form.motors(), form.camera()}) part->setProblem(why);
    form.offer({QStringLiteral("/dev/ttyUSB0")}, {QStringLiteral("/dev/video0")});
    for (widgets::PartChoice* part : {form.touchpad(), form.motors(), form.camera()}) QCOMPARE(part->problem(), why);
    QCOMPARE(form.devices().touchpad, QStringLiteral("modbus-rtu:/dev/ttyUSB4"));
    QCOMPARE(form.touchpad()->entry()->count(), 1);  // offered it was
    form.touchpad()->kind()->setCurrentIndex(kNetwork);
    QCOMPARE(form.touchpad()->problem(), QString());  // it was said of another kind
  }

  void aPathCopiedFromTheWindowIsTakenAsItIsRead() {
    const QString path = QStringLiteral("/dev/serial/by-id/usb-FTDI_FT232R-port0");
    const QString copied = widgets::breakable(path);
    QVERIFY(copied != path);  // it has breaks, which nobody sees
    widgets::ConnectionForm form;
    form.setDevices({.touchpad = QStringLiteral("modbus-rtu:") + copied,
                     .motors = QStringLiteral("qbmove:") + copied,
                     .camera = copied});
    QCOMPARE(form.devices().touchpad, QStringLiteral("modbus-rtu:") + path);
    QCOMPARE(form.devices().motors, QStringLiteral("qbmove:") + path);
    form.camera()->kind()->setCurrentIndex(kStream);
    form.camera()->entry()->setEditText(copied);
    QCOMPARE(form.devices().camera, path);
    widgets::RobotForm robot;
    robot.setRobot(QStringLiteral("scene:") + copied, {});
    QCOMPARE(robot.robot(), QStringLiteral("scene:") + path);
    robot.setRobot(QStringLiteral("link:127.0.0.1:3490"), copied);
    QCOMPARE(robot.keyFile(), path);
  }

  void missingDevicesOfLastTimeDoNotKeepTheWindowFromOpening() {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("gone.h5"));
    const QString profile = folder.filePath(QStringLiteral("profile.toml"));
    console::WindowMemory(console::memoryFile(profile))
        .setDevices({.touchpad = "recording:" + file.toStdString(), .robot = "none"});
    const Started day(folder);
    QVERIFY(!day.window->session().isOpen());
    const widgets::GuideStrip* strip = day.window->missing()->strip();
    WAIT_FOR(strip->isVisible());
    QVERIFY2(strip->advice().contains(file), qPrintable(strip->advice()));
    WAIT_EQUAL(day.state(), QStringLiteral("Closed"));
    click(strip->button(QStringLiteral("missing_retry")));
    WAIT_FOR(day.window->connection().work().isEmpty());
    QVERIFY(!day.window->session().isOpen() && strip->isVisible());
    click(strip->button(QStringLiteral("missing_choose")));
    QCOMPARE(day.window->frame()->place(), QStringLiteral("devices"));
    click(strip->button(QStringLiteral("missing_simulated")));
    WAIT_EQUAL(day.state(), QStringLiteral("Ready"));
    QVERIFY(!strip->isVisible());
    day.window->close();
  }

  void aTouchpadThatDoesNotAnswerAtTheStartIsSaidUntilItDoes() {
    const QTemporaryDir folder;
    NetworkTouchpad touchpad;
    {
      const Started day(folder);
      WAIT_EQUAL(day.state(), QStringLiteral("Ready"));
      connectTo(day, touchpad);
      day.window->close();
    }
    touchpad.switchOff();
    const Started next(folder);
    const widgets::GuideStrip* strip = next.window->missing()->strip();
    WAIT_FOR(strip->isVisible());
    QVERIFY2(strip->advice().contains(touchpad.address()), qPrintable(strip->advice()));
    QVERIFY(strip->button(QStringLiteral("missing_retry")) == nullptr);  // it is asked again by itself
    touchpad.switchOn();
    WAIT_FOR(!strip->isVisible());
    WAIT_EQUAL(next.state(), QStringLiteral("Ready"));
    next.window->close();
  }

  void optionsGoBeforeWhatIsRemembered() {
    const QTemporaryDir folder;
    const QString profile = folder.filePath(QStringLiteral("profile.toml"));
    console::WindowMemory memory(console::memoryFile(profile));
    memory.setDevices(
        {.touchpad = "modbus-tcp:10.0.0.7:502", .motors = "qbmove:/dev/ttyUSB1", .camera = "0", .robot = "none"});
    const auto sources = [&](const console::Options& options) {
      return station::withProfileSources(console::readStart(options, profile, memory).value().station);
    };
    QCOMPARE(sources({}).touchpad, std::string("modbus-tcp:10.0.0.7:502"));
    QCOMPARE(sources({}).motors, std::string("qbmove:/dev/ttyUSB1"));
    console::Options simulated;
    simulated.station.touchpad = "simulated";
    QCOMPARE(sources(simulated).touchpad, std::string("simulated"));
    QVERIFY(sources(simulated).motors.empty() && sources(simulated).camera.empty());
    QVERIFY(!console::readStart(simulated, profile, memory)->devices_remembered);
    // A wrong word of an option ends the start; a remembered one does not.
    console::Options wrong;
    wrong.station.touchpad = "kitchen";
    QVERIFY(!console::openStart(*console::readStart(wrong, profile, memory)).has_value());
    memory.setDevices({.touchpad = "kitchen"});
    const auto opened = console::openStart(*console::readStart({}, profile, memory));
    QVERIFY(opened.has_value() && !opened->session->isOpen() && !opened->missing.empty());
  }

  void aSavedProfileThatCannotBeReadIsSaidAndSetAsideOnlyWhenAsked() {
    const QTemporaryDir folder;
    const QString profile = folder.filePath(QStringLiteral("profile.toml"));
    const QByteArray damaged("[control\nmethod = 2\n");
    const auto write = [&](const QByteArray& text) {
      QFile file(profile);
      return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    };
    const auto read = [](const QString& path) {
      QFile file(path);
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(not there)");
    };
    QVERIFY(write(damaged) && QDir(folder.path()).entryList({QStringLiteral("*.damaged*")}).isEmpty());
    const auto setAside = [](Started& s) { click(s.window->damagedProfile()->strip()->button("profile_set_aside")); };
    {
      Started s(folder);
      const widgets::GuideStrip* strip = s.window->damagedProfile()->strip();
      QVERIFY(strip->isVisible() && !s.window->missing()->strip()->isVisible());
      QVERIFY2(strip->advice().contains(QLatin1String("profile.toml")), qPrintable(strip->advice()));
      QVERIFY2(strip->advice().contains(QLatin1String("profile.toml:1: ")), qPrintable(strip->advice()));
      QVERIFY(!s.window->session().isOpen());
      // Neither a save nor a connection goes over it.
      s.window->commands().action(QStringLiteral("session.save_profile"))->trigger();
      QVERIFY(s.window->notices()->shownText().contains(QLatin1String("profile.toml")));
      QCOMPARE(read(profile), damaged);
      setAside(s);
      QVERIFY(!strip->isVisible() && !QFileInfo::exists(profile));
      QCOMPARE(read(profile + QStringLiteral(".damaged")), damaged);
      WAIT_FOR(s.window->session().isOpen());
      s.window->commands().action(QStringLiteral("session.save_profile"))->trigger();
      QVERIFY2(read(profile).contains("[control]"), qPrintable(s.window->notices()->shownText()));
    }
    QVERIFY(Started(folder).start.damaged_profile.empty());
    // What was set aside before is not lost.
    QVERIFY(write("x"));
    Started again(folder);
    setAside(again);
    QCOMPARE(read(profile + QStringLiteral(".damaged")), damaged);
    QCOMPARE(read(profile + QStringLiteral(".damaged-2")), QByteArray("x"));
    // Who names the devices on the command line is told there.
    QVERIFY(write("x"));
    console::Options named;
    named.station.touchpad = "simulated";
    QVERIFY(!console::readStart(named, profile, console::WindowMemory(console::memoryFile(profile))).has_value());
  }

  void theFirstStepsAreTickedByWhatIsSoAndCanBeClosedAndCalledAgain() {
    const QTemporaryDir folder;
    const QString profile = folder.filePath(QStringLiteral("profile.toml"));
    const console::WindowMemory memory(console::memoryFile(profile));
    auto made = std::make_unique<ScriptedSession>();
    ScriptedSession* session = made.get();
    console::MainWindow window(std::move(made), profile, QString(), memory);
    window.show();
    const widgets::GuideStrip* strip = window.firstSteps()->strip();
    QVERIFY(!strip->isVisible());
    window.commands().action(QStringLiteral("help.first_steps"))->trigger();
    QVERIFY(strip->isVisible());
    QCOMPARE(strip->current(), std::size_t{0});
    QCOMPARE(window.focusWidget(), strip->button(QStringLiteral("first_simulated")));
    // By the keys it lies between the bar and the place.
    QCOMPARE(strip->closeButton()->previousInFocusChain()->objectName(), QStringLiteral("first_own"));
    strip->closeButton()->setFocus();
    QTest::keyClick(strip->closeButton(), Qt::Key_Backtab);
    QCOMPARE(window.focusWidget(), strip->button(QStringLiteral("first_own")));
    window.stateBar()->stopButton()->setFocus();
    QTest::keyClick(window.stateBar()->stopButton(), Qt::Key_Tab);
    QVERIFY(strip->isAncestorOf(window.focusWidget()));
    strip->button(QStringLiteral("first_simulated"))->setFocus();
    click(strip->button(QStringLiteral("first_simulated")));
    QCOMPARE(strip->current(), std::size_t{1});
    QCOMPARE(window.focusWidget(), strip->button(QStringLiteral("first_connect")));  // and not "Record"
    QCOMPARE(memory.devices()->touchpad, std::string("simulated"));
    session->say(SafetyState::ready);
    window.feed().pump();
    QCOMPARE(strip->current(), std::size_t{3});  // the simulation needs no calibration
    QVERIFY(strip->steps()[1].done && !strip->steps()[2].done && !strip->steps()[3].done);
    session->say(SafetyState::ready);
    session->telemetry.back().contact = true;  // a touch that is not rendered is none
    window.feed().pump();
    QVERIFY(!strip->steps()[3].done);
    click(strip->closeButton());
    QVERIFY(!strip->isVisible() && memory.firstStepsOver());
    QVERIFY(!console::readStart({}, profile, memory)->first);
    window.commands().action(QStringLiteral("help.first_steps"))->trigger();
    session->say(SafetyState::active);
    session->telemetry.back().contact = true;
    window.feed().pump();
    QVERIFY(strip->steps()[3].done);
    QCOMPARE(strip->current(), std::size_t{4});
    window.close();
  }
};

std::unique_ptr<QObject> makeConnectionTest() { return std::make_unique<ConnectionTest>(); }

}  // namespace fyd::tests

#include "connection_test.moc"
