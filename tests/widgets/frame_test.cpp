// The window's frame and the place "Devices": the rail by keys and clicks, devices that come and go, tests of the
// motors that last only while a button is held, and a search that stops nothing.
#include <atomic>

#include "app/console/window/places.h"
#include "tests/widgets/device_reports.h"
#include "tests/widgets/hands.h"
#include "tests/widgets/suite.h"
#include "widgets/tuning/tuning_text.h"

namespace fyd::tests {

using pipeline::SafetyState;

namespace {

device::DeviceReport camera() {
  device::DeviceReport out{
      .part = device::Part::camera, .kind = verbatim("camera device"), .description = verbatim("/dev/video0")};
  out.problem = verbatim("no picture for 2.1 s; check the cable");
  out.errors = 3;
  out.counters = {
      {.kind = say("frozen picture"), .count = 2}, {.kind = say("no picture"), .count = 1}, {.kind = say("other")}};
  out.controls = {
      {.name = say("brightness"), .wanted = 40.0, .actual = 40.0, .supported = true, .words = say("set to 40 %")},
      {.name = say("exposure"), .words = say("this source has none")}};
  return out;
}

QToolButton* railButton(const Fixture& f, const char* place) {
  return f.window->frame()->navigationBar()->findChild<QToolButton*>(QStringLiteral("navigation_place.") +
                                                                     QLatin1String(place));
}

/// Its width once it stands still: a busy machine takes its time to lay docks out.
int settledWidth(const QWidget& widget) {
  int last = -1;
  for (int round = 0, still = 0; round < 200 && still < 5; ++round) {
    QTest::qWait(40);
    still = widget.width() == last ? still + 1 : 0;
    last = widget.width();
  }
  return last;
}

}  // namespace

class FrameTest : public QObject {
  Q_OBJECT
 private slots:
  void theRailGoesByKeysAndByClicksAndSaysWhereItIs() {
    Fixture f;
    QCOMPARE(f.window->frame()->place(), QStringLiteral("operate"));
    QVERIFY(railButton(f, "operate")->isChecked());
    QTest::keyClick(f.window.get(), Qt::Key_5, Qt::ControlModifier);
    QCOMPARE(f.window->frame()->place(), QStringLiteral("devices"));
    QVERIFY(devicesOf(f)->isVisible() && !f.window->operate()->isVisible());
    QVERIFY(railButton(f, "devices")->isChecked() && !railButton(f, "operate")->isChecked());
    QTest::mouseClick(railButton(f, "operate"), Qt::LeftButton);
    QVERIFY(f.window->operate()->isVisible());
    QTest::mouseClick(railButton(f, "operate"), Qt::LeftButton);  // where one is already
    QVERIFY(railButton(f, "operate")->isChecked());
    railButton(f, "devices")->setFocus();
    QTest::keyClick(railButton(f, "devices"), Qt::Key_Space);
    QVERIFY(devicesOf(f)->isVisible());
    QVERIFY(f.window->operate()->curves()->following());  // the space bar was the button's
    for (QToolButton* each : f.window->frame()->navigationBar()->findChildren<QToolButton*>()) {
      QVERIFY(!each->accessibleName().isEmpty() && !each->text().isEmpty() && !each->icon().isNull());
      QVERIFY2(each->toolTip().contains(QLatin1String("Ctrl+")), qPrintable(each->toolTip()));
    }
    f.window->frame()->go(QStringLiteral("kitchen"));
    QCOMPARE(f.window->frame()->place(), QStringLiteral("devices"));
  }

  void theWindowSaysThatItAnswersAndNotWhileItIsBusy() {
    Fixture f;
    passTimers(100);
    QCOMPARE(f.session->beats, 0);  // not started
    f.window->start();
    WAIT_FOR(f.session->beats > 5);
    const int before = f.session->beats;
    QThread::msleep(300);  // the window's own thread is busy
    QCOMPARE(f.session->beats, before);
    WAIT_FOR(f.session->beats > before);
  }

  void aThemeWaitsUntilNothingRenders() {
    Fixture f;
    widgets::Look& look = widgets::Look::instance();
    const widgets::ThemeChoice before = look.choice();
    const auto chosen =
        before == widgets::ThemeChoice::light ? widgets::ThemeChoice::dark : widgets::ThemeChoice::light;
    const auto become = [&](SafetyState state) {
      f.session->say(state);
      f.window->feed().pump();
    };
    become(SafetyState::active);
    f.window->commands().action(QStringLiteral("view.theme_") + widgets::themeWord(chosen))->trigger();
    QCOMPARE(look.choice(), before);
    become(SafetyState::active);
    QCOMPARE(look.choice(), before);
    become(SafetyState::held);  // its drives stay enabled
    QTest::qWait(500);
    QCOMPARE(look.choice(), before);
    become(SafetyState::stopped);
    QCOMPARE(look.choice(), before);  // first the state is seen
    WAIT_FOR(look.choice() == chosen);
    f.window->commands().action(QStringLiteral("view.theme_") + widgets::themeWord(before))->trigger();
    QCOMPARE(look.choice(), before);  // nothing renders: at once
  }

  void stopWorksFromEveryPlace() {
    Fixture f;
    for (const console::PlaceInfo& place : console::places()) {
      f.window->frame()->go(QLatin1String(place.id));
      int before = f.session->stops;
      QTest::keyClick(f.window->frame()->stack()->currentWidget(), Qt::Key_Escape);
      QVERIFY2(f.session->stops > before, place.id);
      before = f.session->stops;
      QVERIFY(f.window->stateBar()->stopButton()->isVisible());
      QTest::mouseClick(f.window->stateBar()->stopButton(), Qt::LeftButton);
      QVERIFY2(f.session->stops > before, place.id);
    }
  }

  void thePanelsShareFollowsTheWindowInBothDirections() {
    Fixture f;
    const QWidget* picture = f.window->operate()->camera()->image();
    auto* area = f.window->operate()->findChild<QMainWindow*>();
    auto* camera = area->findChild<QDockWidget*>(QStringLiteral("camera"));
    f.window->resize(1280, 720);
    const int before = settledWidth(*camera);
    QVERIFY(picture->width() < 300);
    f.window->resize(3840, 2160);
    WAIT_FOR(picture->width() > 0.12 * 3840);
    // Not quite its share, as when its contents needed more for a while.
    area->resizeDocks({camera}, {camera->width() + 30}, Qt::Horizontal);
    QTest::qWait(100);
    f.window->resize(1280, 720);
    WAIT_EQUAL(camera->width(), before);
    for (const int width : {2000, 1700, 1500, 1280}) {  // by steps
      f.window->resize(width, 720);
      QTest::qWait(20);
    }
    WAIT_EQUAL(camera->width(), before);
  }

  void aWidthDrawnByHandIsLeftAlone() {
    Fixture f;
    auto* area = f.window->operate()->findChild<QMainWindow*>();
    auto* camera = area->findChild<QDockWidget*>(QStringLiteral("camera"));
    f.window->resize(1600, 1000);
    const int before = settledWidth(*camera);
    const auto drag = [&](int by_px) {
      const QPoint edge(camera->geometry().right() + 2, camera->geometry().center().y());
      QTest::mousePress(area, Qt::LeftButton, {}, edge);
      QTest::mouseMove(area, edge + QPoint(by_px, 0));
      (void)settledWidth(*camera);
      QTest::mouseRelease(area, Qt::LeftButton, {}, edge + QPoint(by_px, 0));
      return settledWidth(*camera);
    };
    const int drawn = drag(70);
    QVERIFY2(drawn > before + 40, qPrintable(QString::number(drawn)));
    for (const QSize size : {QSize(2400, 1200), QSize(1600, 1000)}) {
      f.window->resize(size);
      QCOMPARE(settledWidth(*camera), drawn);
    }
    (void)drag(before - drawn);  // back to its share: it follows again
    f.window->resize(3000, 1600);
    WAIT_FOR(camera->width() > drawn);
  }

  void theFirstFocusIsNoButtonThatRecords() {
    Fixture f;
    QVERIFY(!f.window->stateBar()->isAncestorOf(f.window->focusWidget()));
  }

  void howToArmIsSaidUntilItIsArmed() {
    Fixture f;
    QAction* arm = f.window->commands().action(QStringLiteral("session.arm"));
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    arm->trigger();
    QCOMPARE(f.window->notices()->count(), 1);
    f.session->say(SafetyState::active);
    f.window->feed().pump();
    QCOMPARE(f.window->notices()->count(), 0);
    arm->trigger();
    QCOMPARE(f.window->notices()->count(), 0);
  }

  void stopAndArmStandStillWhateverOpensAndWhateverIsSaid() {
    Fixture f;
    const auto at = [&](const QWidget* button) {
      return QRect(button->mapTo(f.window.get(), QPoint(0, 0)), button->size());
    };
    const auto words = [](const QRect& rect) {
      return QStringLiteral("%1,%2 %3x%4").arg(rect.x()).arg(rect.y()).arg(rect.width()).arg(rect.height());
    };
    const widgets::StateBar* bar = f.window->stateBar();
    for (const QSize size : {QSize(1280, 720), QSize(960, 540), QSize(640, 480), QSize(1600, 1000), QSize(3840, 2160)}) {
      f.window->resize(size);
      for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();  // the bar gets narrow, then its layout follows
      QCOMPARE(f.window->size(), size);                               // no place, panel or word needs more
      const QRect stop = at(bar->stopButton());
      const QRect arm = at(bar->armButton());
      QVERIFY(f.window->rect().contains(stop) && f.window->rect().contains(arm) && !stop.intersects(arm));
      const auto still = [&](const char* what) {
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();
        const QRect stop_now = at(bar->stopButton()), arm_now = at(bar->armButton());
        QVERIFY2(stop_now == stop && arm_now == arm,
                 qPrintable(QStringLiteral("%1 at %2x%3: Stop from %4 to %5, Arm from %6 to %7")
                                .arg(QLatin1String(what))
                                .arg(size.width())
                                .arg(size.height())
                                .arg(words(stop), words(stop_now), words(arm), words(arm_now))));
        QVERIFY2(f.window->size() == size, qPrintable(QStringLiteral("%1: the window of %2x%3 becomes %4x%5")
                                                          .arg(QLatin1String(what))
                                                          .arg(size.width())
                                                          .arg(size.height())
                                                          .arg(f.window->width())
                                                          .arg(f.window->height())));
      };
      for (const console::PlaceInfo& place : console::places()) {
        f.window->frame()->go(QLatin1String(place.id));
        still(place.id);
        f.window->openPanels({QStringLiteral("link"), QStringLiteral("recording")});
        still(place.id);
        f.window->openPanels({QStringLiteral("manual"), QStringLiteral("log")});
        still(place.id);
        for (const SafetyState state : {SafetyState::disconnected, SafetyState::connected, SafetyState::ready,
                                        SafetyState::active, SafetyState::held, SafetyState::stopped}) {
          f.session->say(state);
          f.session->telemetry.back().fault =
              state == SafetyState::held ? pipeline::Fault::camera_blind : pipeline::Fault::none;
          f.window->feed().pump();
          still(toString(state).data());
        }
        f.window->tell(widgets::Severity::error, QStringLiteral("Long words. ").repeated(60));
        still("a notice");
        f.session->recorder = {.state = recording::RecorderState::recording, .path = "a.h5"};
        f.session->recorder.seconds = 359'999.0;
        f.window->feed().pump();
        still("a recording");
        f.session->recorder = {};
        f.window->notices()->dismissAll();
        for (auto* panel : f.window->frame()->panelArea()->findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) {
          panel->hide();
        }
        still("closed panels");
      }
    }
  }

  void quittingAsksOnceWhileSomethingIsUnderWay() {
    Fixture f;
    QAction* quit = f.window->commands().action(QStringLiteral("session.quit"));
    f.session->say(SafetyState::active);
    f.session->recorder = {.state = recording::RecorderState::recording, .path = "a.h5"};
    f.window->feed().pump();
    quit->trigger();
    QVERIFY(f.window->isVisible());
    const QString asked = f.window->notices()->shownText();
    QVERIFY2(
        asked.contains(QStringLiteral("motors on")) && asked.contains(QStringLiteral("recording is being written")),
        qPrintable(asked));
    QTest::mouseClick(f.window->notices()->findChild<QPushButton*>(QStringLiteral("quit_not")), Qt::LeftButton);
    QCOMPARE(f.window->notices()->count(), 0);
    QVERIFY(f.window->isVisible());
    quit->trigger();
    QVERIFY(f.window->isVisible());
    quit->trigger();
    QVERIFY(!f.window->isVisible());
    QVERIFY(f.session->stops > 0);
  }

  void theButtonOfAnOldQuestionEndsNothingThatItDidNotName() {
    Fixture f;
    f.row("control.kp")->slider()->setValue(60);
    f.window->commands().action(QStringLiteral("session.quit"))->trigger();
    const auto quit = [&] {
      const auto buttons = f.window->notices()->findChildren<QPushButton*>(QStringLiteral("quit_now"));
      const auto shown = std::ranges::find_if(buttons, [](const QPushButton* each) { return each->isVisible(); });
      QVERIFY(shown != buttons.end());
      QTest::mouseClick(*shown, Qt::LeftButton);
    };
    f.session->recorder = {.state = recording::RecorderState::recording, .path = "a.h5"};
    f.window->feed().pump();
    quit();
    QVERIFY(f.window->isVisible());
    const QString asked = f.window->notices()->shownText();
    QVERIFY2(asked.contains(QStringLiteral("recording is being written")), qPrintable(asked));
    quit();
    QVERIFY(!f.window->isVisible());
  }

  void quittingNamesWhatIsChangedAndNotSavedAndTheQuestionGoesWithIt() {
    Fixture f;
    f.row("control.kp")->slider()->setValue(60);
    f.row("texture.k_vib")->slider()->setValue(200);
    QAction* quit = f.window->commands().action(QStringLiteral("session.quit"));
    quit->trigger();
    QVERIFY(f.window->isVisible());
    const QString asked = f.window->notices()->shownText();
    for (const char* id : {"control.kp", "texture.k_vib"}) {
      station::Profile profile;
      const auto bound = bindParameters(profile);
      QVERIFY2(asked.contains(widgets::tunedName(*findParameter(bound, id))), qPrintable(asked));
    }
    f.window->commands().action(QStringLiteral("session.save_profile"))->trigger();
    f.window->feed().pump();
    QVERIFY(!f.window->notices()->shows(QStringLiteral("leaving")));
    quit->trigger();
    QVERIFY(!f.window->isVisible());
  }

  void quittingAsksNothingWhereNothingIsUnderWay() {
    Fixture f;
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    f.window->commands().action(QStringLiteral("session.quit"))->trigger();
    QVERIFY(!f.window->isVisible());
  }

  void aNoticeAboutALostRobotGoesWhenTheRobotIsBack() {
    Fixture f;
    const station::ReadinessLine well{.what = say("Robot connected"), .ok = true};
    f.session->lines = {{.what = say("Robot connected"),
                         .ok = false,
                         .why = phrase(toString(pipeline::Fault::robot_lost)),
                         .remedy = say("Check the network."),
                         .fault = pipeline::Fault::robot_lost}};
    f.session->say(SafetyState::held);
    f.session->telemetry.back().fault = pipeline::Fault::robot_lost;
    f.session->notices.push_back({.event = {.kind = pipeline::EventKind::state_changed,
                                            .state = SafetyState::held,
                                            .fault = pipeline::Fault::robot_lost},
                                  .message = verbatim("Held: the robot is silent.")});
    f.window->feed().pump();
    QCOMPARE(f.window->notices()->count(), 1);
    QVERIFY(f.window->stateBar()->stateReason().contains(QStringLiteral("Check the network.")));
    f.session->lines = {well};
    f.window->feed().pump();
    QCOMPARE(f.window->notices()->count(), 0);
    QCOMPARE(f.window->log()->lines(), 1);
    QVERIFY(f.window->stateBar()->stateReason().contains(QStringLiteral("Since then it is back. Hold Re-arm")));
  }

  void aControlThatIsGoneGivesItsFocusToNothingThatCloses() {
    Fixture f;
    f.window->showFirstSteps();
    f.session->recorder = {.state = recording::RecorderState::recording, .path = "a.h5"};
    f.window->openPanels({QStringLiteral("recording")});
    auto* stop = f.window->findChild<QPushButton*>(QStringLiteral("recording_stop"));
    stop->show();
    stop->setFocus();
    QVERIFY(stop->hasFocus());
    stop->hide();
    for (const QWidget* each : f.window->findChildren<QWidget*>(QStringLiteral("recording_start"))) {
      QVERIFY(!each->hasFocus());
    }
    WAIT_FOR(f.window->frame()->placeButton()->hasFocus());
    // One that has gone to a neighbour of the same panel stays there.
    auto* record = f.window->frame()->stateBar()->recordButton();
    record->setFocus();
    record->setEnabled(false);
    QApplication::processEvents();
    QVERIFY(!f.window->frame()->placeButton()->hasFocus());
  }

  void aMuchLargerWindowGivesThePanelsTheirShare() {
    Fixture f;
    f.window->resize(1280, 720);
    QApplication::processEvents();
    const QWidget* camera = f.window->findChild<QDockWidget*>(QStringLiteral("camera"));
    QVERIFY(camera != nullptr);
    const int before = camera->width();
    f.window->resize(3840, 2160);
    WAIT_FOR(camera->width() > 2 * before);
    f.window->resize(1280, 720);
    WAIT_FOR(camera->width() < 2 * before);
  }

  void thePaletteGivesTheFocusBackAndLeadsToTheArmingButton() {
    Fixture f;
    QLineEdit* field = f.row("control.kp")->field();
    field->setFocus();
    f.window->palette()->open();
    f.window->palette()->hide();
    WAIT_FOR(f.window->focusWidget() == field);
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    f.window->palette()->open();
    QTest::keyClicks(f.window->palette()->field(), QStringLiteral("arm:"));
    QTest::keyClick(f.window->palette()->field(), Qt::Key_Return);
    QCOMPARE(f.window->focusWidget(), f.window->stateBar()->armButton());
    QVERIFY(f.window->notices()->shownText().contains(QStringLiteral("Hold")));
    QCOMPARE(f.session->count(pipeline::OperatorAction::arm), 0);
  }

  void aPlacesCommandsExistOnlyWhileItIsShown() {
    Fixture f;
    QAction* pause = f.window->commands().action(QStringLiteral("curves.pause"));
    QAction* undo = f.window->commands().action(QStringLiteral("edit.undo"));
    QVERIFY(pause->isVisible() && pause->isEnabled());
    f.row("texture.k_vib")->slider()->setValue(200);
    const double changed = f.session->profile.step.texture.k_vib;
    f.window->frame()->go(QStringLiteral("devices"));
    QVERIFY(!pause->isVisible() && !pause->isEnabled() && !undo->isEnabled());
    f.window->setFocus();
    QTest::keyClick(f.window.get(), Qt::Key_Space);
    QTest::keyClick(f.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(f.window->operate()->curves()->following());
    QCOMPARE(f.session->profile.step.texture.k_vib, changed);  // no gain changes unseen
    f.window->palette()->open();
    QTest::keyClicks(f.window->palette()->field(), QStringLiteral("undo"));
    QCOMPARE(f.window->palette()->list()->count(), 0);
    f.window->palette()->hide();
    f.window->frame()->go(QStringLiteral("operate"));
    QVERIFY(pause->isEnabled());
    QTest::keyClick(f.window.get(), Qt::Key_Space);
    QVERIFY(!f.window->operate()->curves()->following());
  }

  void aDeviceSaysWhatItIsHowItDoesAndWhatToDo() {
    widgets::DeviceCard card;
    card.setReport(touchpad());
    QCOMPARE(card.stateWord(), QStringLiteral("Well"));
    QVERIFY(card.problem().isEmpty());
    for (const auto& [label, text] : {std::pair{"Answers", "250 a second"},
                                      {"Last answer", "4 ms ago"},
                                      {"Errors", "none since the start"},
                                      {"IR sensor 1", "2048 counts"},
                                      {"Load cell", "0.1235 mV/V"},
                                      {"Motors", "Switched off"},
                                      {"Current 1", "—"}}) {
      QCOMPARE(card.value(QLatin1String(label)), QString::fromUtf8(text));
    }
    card.setReport(camera());
    QCOMPARE(card.stateWord(), QStringLiteral("Problem"));
    QVERIFY(card.problem().contains(QStringLiteral("check the cable")));
    for (const auto& [label, text] : {std::pair{"Pictures", "—"},
                                      {"Last picture", "—"},
                                      {"Errors", "3"},
                                      {"Frozen picture", "2"},
                                      {"Brightness", "Set to 40 %"},
                                      {"Exposure", "This source has none"},
                                      {"Other", ""},           // none of this kind
                                      {"IR sensor 1", ""}}) {  // of the former device
      QCOMPARE(card.value(QLatin1String(label)), QString::fromUtf8(text));
    }
  }

  void devicesComeAndGoWhileThePageIsOpen() {
    Fixture f;
    f.session->reports = {touchpad(), camera()};
    f.window->frame()->go(QStringLiteral("devices"));
    console::DevicesPage* page = devicesOf(f);
    QCOMPARE(page->cardCount(), std::size_t{2});
    QCOMPARE(page->card(1)->stateWord(), QStringLiteral("Problem"));
    f.session->reports[1].ok = true;
    f.session->reports[1].problem = {};
    WAIT_EQUAL(page->card(1)->stateWord(), QStringLiteral("Well"));  // by itself
    f.session->reports.resize(1);
    WAIT_EQUAL(page->cardCount(), std::size_t{1});
    QVERIFY(!page->card(1)->isVisible());
    f.session->reports.clear();
    WAIT_EQUAL(page->cardCount(), std::size_t{0});
    f.session->reports = {touchpad(), camera(), camera()};
    WAIT_EQUAL(page->cardCount(), std::size_t{3});
    QVERIFY(page->card(2)->isVisible());
    QVERIFY2(f.window->minimumSizeHint().width() <= 1280,
             qPrintable(QString::number(f.window->minimumSizeHint().width())));
    f.window->frame()->go(QStringLiteral("operate"));
    f.session->reports.clear();
    passTimers(500);
    QCOMPARE(page->cardCount(), std::size_t{3});  // a hidden page asks nothing
  }

  void aTestRunsOnlyWhileItsButtonIsHeldAndNothingRenders() {
    Fixture f;
    f.session->reports = {touchpad()};
    f.window->frame()->go(QStringLiteral("devices"));
    console::DevicesPage* page = devicesOf(f);
    widgets::HoldButton* button = page->card(0)->testButton(1);
    for (const auto& [state, allowed] : {std::pair{SafetyState::disconnected, false},
                                         {SafetyState::active, false},
                                         {SafetyState::held, false},
                                         {SafetyState::connected, true},
                                         {SafetyState::stopped, true},
                                         {SafetyState::ready, true}}) {
      f.session->say(state);
      f.window->feed().pump();
      page->refresh();
      QCOMPARE(button->isEnabled(), allowed);
    }
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(f.session->tests.empty());
    QTest::mousePress(button, Qt::LeftButton);
    WAIT_EQUAL(f.session->tests.size(), std::size_t{1});
    QCOMPARE(f.session->tests[0], device::DeviceTest::motor_2);
    // The state bar says so, and nothing of motors that are off.
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    QCOMPARE(f.window->stateBar()->stateWord(), QStringLiteral("Ready"));
    QCOMPARE(f.window->stateBar()->stateReason(),
             QStringLiteral("A held button moves the motors: motor 2. Letting go or Esc switches them off."));
    const int keeps = f.session->keeps;
    WAIT_FOR(f.session->keeps > keeps + 2);
    f.session->test_status.progress = 0.4;
    page->refresh();
    QVERIFY2(page->card(0)->testText().contains(QStringLiteral("40 %")), qPrintable(page->card(0)->testText()));
    QTest::mouseRelease(button, Qt::LeftButton);
    QVERIFY(f.session->test_stops >= 1);
    QVERIFY(page->card(0)->testText().contains(QStringLiteral("released")));
    const int after = f.session->keeps;
    passTimers(400);
    QCOMPARE(f.session->keeps, after);
    QCOMPARE(f.session->tests.size(), std::size_t{1});

    // By key; and another place, or the state, takes it back as letting go does.
    button->setFocus();
    QTest::keyPress(button, Qt::Key_Space);
    WAIT_EQUAL(f.session->tests.size(), std::size_t{2});
    int stops = f.session->test_stops;
    f.window->frame()->go(QStringLiteral("operate"));
    QVERIFY(f.session->test_stops > stops);
    QVERIFY(!button->engaged());
    QTest::keyRelease(button, Qt::Key_Space);
    f.window->frame()->go(QStringLiteral("devices"));
    QTest::mousePress(button, Qt::LeftButton);
    WAIT_EQUAL(f.session->tests.size(), std::size_t{3});
    stops = f.session->test_stops;
    f.session->say(SafetyState::active);
    f.window->feed().pump();
    page->refresh();
    QVERIFY(f.session->test_stops > stops && !button->isEnabled());
    QTest::mouseRelease(button, Qt::LeftButton);
  }

  void testsStandOnTheCardOfTheDeviceWithTheMotors() {
    Fixture f;
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    device::DeviceReport board = touchpad();
    board.part = device::Part::motor_board;
    f.session->reports = {touchpad(), board};
    f.window->frame()->go(QStringLiteral("devices"));
    console::DevicesPage* page = devicesOf(f);
    const auto tests_on = [&](std::size_t card) {
      const auto* button = page->card(card)->findChild<widgets::HoldButton*>(QStringLiteral("device_test_0"));
      return button != nullptr && button->isVisible();
    };
    QVERIFY(!tests_on(0) && tests_on(1));
    widgets::HoldButton* button = page->card(1)->testButton(0);
    QTest::mousePress(button, Qt::LeftButton);
    WAIT_EQUAL(f.session->tests.size(), std::size_t{1});
    // Other devices come while it is held: the motors are the touchpad's own now, and the second card is the camera's.
    f.session->reports = {touchpad(), camera()};
    page->refresh();
    QVERIFY(!f.session->test_status.running);
    QVERIFY(tests_on(0) && !tests_on(1));
    const int keeps = f.session->keeps;
    passTimers(400);
    QCOMPARE(f.session->keeps, keeps);
    QTest::mouseRelease(button, Qt::LeftButton);
    QTest::mousePress(page->card(0)->testButton(1), Qt::LeftButton);
    WAIT_EQUAL(f.session->tests.size(), std::size_t{2});
    WAIT_FOR(f.session->keeps > keeps);
    QTest::mouseRelease(page->card(0)->testButton(1), Qt::LeftButton);
    QVERIFY(!f.session->test_status.running);
    f.session->reports = {camera(), touchpad(), board};
    page->refresh();
    QVERIFY(!tests_on(0) && !tests_on(1) && tests_on(2));
    f.session->reports = {touchpad(), board};  // a card that had them once has them again, and once only
    page->refresh();
    QVERIFY(!tests_on(0) && tests_on(1));
    QCOMPARE(page->card(1)->findChildren<widgets::HoldButton*>().size(), 3);
  }

  void aTestThatIsRefusedSaysWhy() {
    Fixture f;
    f.session->reports = {touchpad()};
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    f.window->frame()->go(QStringLiteral("devices"));
    f.session->refuses = true;
    widgets::HoldButton* button = devicesOf(f)->card(0)->testButton(0);
    QTest::mousePress(button, Qt::LeftButton);
    WAIT_FOR(f.window->notices()->count() == 1);
    QVERIFY(f.window->notices()->text(0).contains(QStringLiteral("refused by the script")));
    QTest::mouseRelease(button, Qt::LeftButton);
  }

  void escEndsATestAndNothingStartsItAgain() {
    Fixture f;
    f.session->reports = {touchpad()};
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    f.window->frame()->go(QStringLiteral("devices"));
    widgets::HoldButton* button = devicesOf(f)->card(0)->testButton(0);
    QTest::mousePress(button, Qt::LeftButton);
    WAIT_EQUAL(f.session->tests.size(), std::size_t{1});
    const int stops = f.session->test_stops;
    QTest::keyClick(button, Qt::Key_Escape);
    QVERIFY(f.session->stops >= 1);
    QVERIFY(f.session->test_stops > stops);
    passTimers(800);  // still pressed
    QCOMPARE(f.session->tests.size(), std::size_t{1});
    QTest::mouseRelease(button, Qt::LeftButton);
  }

  void aSlowSearchBlocksNothingAndTellsHowFarItIs() {
    Fixture f;
    console::DevicesPage* page = devicesOf(f);
    std::atomic<bool> go{false};
    std::atomic<int> looks{0};
    page->setSearch(
        {{QStringLiteral("Serial port"), QStringLiteral("Looking at serial ports …"),
          [&]() -> std::vector<device::FoundDevice> {
            ++looks;
            while (!go) QThread::msleep(5);
            return {{.path = "/dev/serial/by-id/usb-x", .node = "/dev/ttyUSB0", .name = "x 1"}};
          }},
         {QStringLiteral("Camera"), QStringLiteral("Looking at cameras …"), [&]() -> std::vector<device::FoundDevice> {
            return {{.path = "/dev/video0", .problem = verbatim("permission denied; join the group video")}};
          }}});
    f.window->frame()->go(QStringLiteral("devices"));  // looks by itself the first time
    WAIT_EQUAL(looks.load(), 1);
    QVERIFY(!page->found()->lookButton()->isEnabled());
    QVERIFY(page->found()->summary().contains(QStringLiteral("serial ports")));
    QTest::keyClick(f.window.get(), Qt::Key_F5);  // one at a time
    QTest::keyClick(page, Qt::Key_Escape);        // and the window answers meanwhile
    QVERIFY(f.session->stops >= 1);
    go = true;
    WAIT_EQUAL(page->found()->count(), 2);
    QCOMPARE(looks.load(), 1);
    bool remedy = false;
    for (const QLabel* label : page->found()->findChildren<QLabel*>()) {
      remedy = remedy || label->text().contains(QStringLiteral("join the group video"));
    }
    QVERIFY(remedy);
    QTest::mouseClick(page->found()->lookButton(), Qt::LeftButton);
    WAIT_EQUAL(looks.load(), 2);
    WAIT_FOR(page->found()->lookButton()->isEnabled());
    page->setSearch({});
    QTest::keyClick(f.window.get(), Qt::Key_F5);
    WAIT_EQUAL(page->found()->count(), 0);
    QVERIFY(page->found()->summary().contains(QStringLiteral("No serial port and no camera")));
  }
};

std::unique_ptr<QObject> makeFrameTest() { return std::make_unique<FrameTest>(); }

}  // namespace fyd::tests

#include "frame_test.moc"
