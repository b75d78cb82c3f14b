// The whole window on a scripted session: what keys and clicks ask of it, what it shows of what it hears.
#include <QFileDialog>
#include <QSignalSpy>
#include <stdexcept>

#include "app/console/operate/finger_menu.h"
#include "app/console/shell/background.h"
#include "app/console/shell/options.h"
#include "app/console/shell/views.h"
#include "app/console/window/places.h"
#include "tests/widgets/hands.h"
#include "tests/widgets/suite.h"

namespace fyd::tests {
namespace {

using pipeline::OperatorAction;
using pipeline::SafetyState;

int indexOf(station::Profile& profile, std::string_view id) {
  const auto bound = bindParameters(profile);
  return static_cast<int>(findParameter(bound, id) - bound.data());
}

}  // namespace

class ConsoleTest : public QObject {
  Q_OBJECT
 private slots:
  void escStopsFromAFocusedFieldAListAMenuAndADialog() {
    Fixture f;
    QLineEdit* field = f.row("control.kp")->field();
    field->setFocus();
    QTest::keyClicks(field, QStringLiteral("12"));
    QTest::keyClick(field, Qt::Key_Escape);
    QVERIFY(f.session->stops >= 1);

    int before = f.session->stops;
    QComboBox* choice = f.row("texture.method")->choice();
    choice->showPopup();
    QTest::keyClick(choice->view(), Qt::Key_Escape);
    QVERIFY(f.session->stops > before);

    before = f.session->stops;
    f.window->palette()->open();
    QTest::keyClick(f.window->palette()->field(), Qt::Key_Escape);
    QVERIFY(f.session->stops > before);
    QVERIFY(!f.window->palette()->isVisible());

    before = f.session->stops;
    QDialog modal(f.window.get());
    modal.setModal(true);
    modal.show();
    QTest::keyClick(&modal, Qt::Key_Escape);
    QVERIFY(f.session->stops > before);

    before = f.session->stops;
    QMenu* menu = f.window->menuBar()->actions().first()->menu();
    menu->popup(QPoint(10, 10));
    QTest::keyClick(menu, Qt::Key_Escape);
    QVERIFY(f.session->stops > before);
  }

  void escStopsFromEveryFileDialog() {
    Fixture f;
    QVERIFY(QCoreApplication::testAttribute(Qt::AA_DontUseNativeDialogs));
    const auto stops_from = [&](const char* what, const std::function<void()>& open) {
      open();
      QFileDialog* dialog = nullptr;
      for (QFileDialog* each : f.window->findChildren<QFileDialog*>()) {
        if (each->isVisible()) dialog = each;
      }
      QVERIFY2(dialog != nullptr, what);
      const int before = f.session->stops;
      QTest::keyClick(dialog, Qt::Key_Escape);
      QVERIFY2(f.session->stops > before, what);
      WAIT_FOR(f.window->findChildren<QFileDialog*>().isEmpty());
    };
    const auto browse = [](const QWidget* form) { return [form] { form->findChild<QToolButton*>()->click(); }; };
    stops_from("finger", [&] { f.window->operate()->finger()->chooseFile(); });
    f.window->frame()->go(QStringLiteral("review"));
    stops_from("review", [&] { f.window->commands().action(QStringLiteral("review.open"))->trigger(); });
    QTest::keyClick(f.window.get(), Qt::Key_R, Qt::ControlModifier);
    int files = 0;
    for (QToolButton* each : f.window->recording()->form()->findChildren<QToolButton*>()) {
      if (each->accessibleName() != QStringLiteral("Choose the file")) continue;
      stops_from("recording", [each] { each->click(); });
      ++files;
    }
    QCOMPARE(files, 1);
    stops_from("camera", browse(devicesOf(f)->form()->camera()));
    for (QToolButton* each : f.window->link()->form()->findChildren<QToolButton*>()) {
      stops_from(qPrintable(each->accessibleName()), [each] { each->click(); });
    }
  }

  void aSpaceBarThatIsDownSinceArmingDoesNotStop() {
    Fixture f;
    QPushButton* stop = f.window->stateBar()->stopButton();
    stop->setFocus();
    QVERIFY(stop->hasFocus());
    const auto key = [&](QEvent::Type type, quint64 at_ms) {
      QKeyEvent event(type, Qt::Key_Space, Qt::NoModifier, QStringLiteral(" "));
      event.setTimestamp(at_ms);
      QCoreApplication::sendEvent(stop, &event);
    };
    for (const quint64 repeated_ms : {quint64{5000}, quint64{5033}}) {
      key(QEvent::KeyRelease, repeated_ms);
      key(QEvent::KeyPress, repeated_ms);
    }
    key(QEvent::KeyRelease, 5060);
    QCOMPARE(f.session->stops, 0);
    key(QEvent::KeyPress, 5061);
    QCOMPARE(f.session->stops, 1);
    key(QEvent::KeyRelease, 5100);
    for (int presses = 2; presses < 4; ++presses) {  // where no time is told, each is a press
      key(QEvent::KeyPress, 0);
      key(QEvent::KeyRelease, 0);
      QCOMPARE(f.session->stops, presses);
    }
  }

  void stopButtonAndMenuStop() {
    Fixture f;
    QTest::mouseClick(f.window->stateBar()->stopButton(), Qt::LeftButton);
    QCOMPARE(f.session->stops, 1);
    f.window->commands().action(QStringLiteral("session.stop"))->trigger();
    QCOMPARE(f.session->stops, 2);
  }

  void armingTakesAHoldAndNothingElseArms() {
    Fixture f;
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    widgets::HoldButton* arm = f.window->stateBar()->armButton();
    QVERIFY(arm->isEnabled());
    QTest::mouseClick(arm, Qt::LeftButton);
    for (QAction* action : f.window->commands().actions()) {
      const QString id = action->objectName();
      if (id != QLatin1String("session.quit") && id != QLatin1String("view.palette")) action->trigger();
    }
    passTimers(widgets::HoldButton::kHold_ms + 100);
    QCOMPARE(f.session->count(OperatorAction::arm), 0);
    arm->setFocus();
    QTest::keyPress(arm, Qt::Key_Space);  // the window's own use of the space bar stands back
    WAIT_EQUAL(f.session->count(OperatorAction::arm), 1);
    QTest::keyRelease(arm, Qt::Key_Space);
  }

  void aStopDuringAHoldArmsNothingThoughKeyOrMouseStaysDown() {
    Fixture f;
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    widgets::HoldButton* arm = f.window->stateBar()->armButton();
    QWindow* keyboard = f.window->windowHandle();  // by way of shortcuts and filters to what has the focus
    arm->setFocus();
    const auto stops = {
        std::function([&] { QTest::keyClick(keyboard, Qt::Key_Escape); }),
        std::function([&] { f.window->commands().action(QStringLiteral("session.stop"))->trigger(); }),
    };
    for (const auto& stop : stops) {
      const int before = f.session->stops;
      QTest::keyPress(keyboard, Qt::Key_Space);
      stop();
      QVERIFY(f.session->stops > before);
      QCOMPARE(arm->progress(), 0.0);
      passTimers(widgets::HoldButton::kHold_ms + 200);
      QCOMPARE(f.session->count(OperatorAction::arm), 0);
      QTest::keyRelease(keyboard, Qt::Key_Space);
    }
    QTest::mousePress(arm, Qt::LeftButton);
    QTest::keyClick(keyboard, Qt::Key_Escape);
    const QPointF beside = QRectF(arm->rect()).center() + QPointF(2, 0);
    QMouseEvent moved(QEvent::MouseMove, beside, arm->mapToGlobal(beside), Qt::NoButton, Qt::LeftButton,
                      Qt::NoModifier);
    QApplication::sendEvent(arm, &moved);  // a hand trembles
    passTimers(widgets::HoldButton::kHold_ms + 200);
    QCOMPARE(f.session->count(OperatorAction::arm), 0);
    QTest::mouseRelease(arm, Qt::LeftButton);
    // Pressed anew, by either, it arms.
    QTest::mousePress(arm, Qt::LeftButton);
    WAIT_EQUAL(f.session->count(OperatorAction::arm), 1);
    QTest::mouseRelease(arm, Qt::LeftButton);
    QTest::keyClick(keyboard, Qt::Key_Escape);
    QTest::keyPress(keyboard, Qt::Key_Space);
    WAIT_EQUAL(f.session->count(OperatorAction::arm), 2);
    QTest::keyRelease(keyboard, Qt::Key_Space);
  }

  void whatDoesNotKeepFromArmingIsNotSaidToBeMissing() {
    Fixture f;
    const station::ReadinessLine uncalibrated{.what = say("Calibrated on this touchpad"),
                                              .ok = false,
                                              .why = say("the profile's values are another touchpad's"),
                                              .remedy = say("It does not keep you from arming.")};
    f.session->lines = {uncalibrated};
    f.session->say(SafetyState::stopped);
    f.window->feed().pump();
    QCOMPARE(f.window->stateBar()->stateReason(),
             QStringLiteral("Stopped by the operator; motors off. Hold Re-arm to start again."));
    f.session->lines = {uncalibrated,
                        {.what = say("Robot connected"),
                         .ok = false,
                         .why = say("the robot is silent"),
                         .remedy = say("Check the network."),
                         .fault = pipeline::Fault::robot_lost}};
    f.window->feed().pump();
    QVERIFY2(f.window->stateBar()->stateReason().contains(QLatin1String("Missing now: The robot is silent.")),
             qPrintable(f.window->stateBar()->stateReason()));
  }

  void spacePausesAndFFollowsButNotWhileTyping() {
    Fixture f;
    widgets::CurveView* curves = f.window->operate()->curves();
    f.window->setFocus();
    QTest::keyClick(f.window.get(), Qt::Key_Space);
    QVERIFY(!curves->following());
    QTest::keyClick(f.window.get(), Qt::Key_F);
    QVERIFY(curves->following());
    QLineEdit* field = f.row("control.kp")->field();
    field->setFocus();
    curves->pause();
    QTest::keyClick(field, Qt::Key_F);
    QVERIFY(!curves->following());
  }

  void tareTargetAndHandValueReachTheSession() {
    Fixture f;
    QTest::mouseClick(f.window->stateBar()->tareButton(), Qt::LeftButton);
    QCOMPARE(f.session->count(OperatorAction::tare), 1);
    QTest::mouseClick(f.window->operate()->tuning()->byHandButton(), Qt::LeftButton, {}, QPoint(6, 10));
    QCOMPARE(f.session->count(OperatorAction::target_by_hand), 1);
    QCOMPARE(f.session->commands.back().value, f.session->profile.step.step.hand_target_N_per_mm);
    QTest::keyClick(f.window.get(), Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(f.session->count(OperatorAction::target_from_robot), 1);
    QLineEdit* field = f.row("pipeline.hand_target_N_per_mm")->field();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("0.55"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(f.session->changes.back(), (std::pair<std::string, double>("pipeline.hand_target_N_per_mm", 0.55)));
  }

  void everyTunedParameterOfTheIssueIsThereAndLive() {
    Fixture f;
    station::Profile profile;
    const auto bound = bindParameters(profile);
    for (const char* id : {"pipeline.hand_target_N_per_mm", "control.kp", "control.ki", "control.kd", "texture.k_vib",
                           "texture.method", "texture.pwm", "texture.dead_zone_percent", "texture.maximum_percent"}) {
      QVERIFY2(f.row(id) != nullptr, id);
      QVERIFY2(findParameter(bound, id)->info.live, id);
    }
  }

  void aRefusalByTheSessionShowsTheRealValueAndSaysWhy() {
    Fixture f;
    f.session->refuses = true;
    f.row("texture.k_vib")->slider()->setValue(200);
    QCOMPARE(f.row("texture.k_vib")->field()->text(), QString::number(f.session->profile.step.texture.k_vib));
    QVERIFY(f.window->notices()->count() >= 1);
    QVERIFY(f.window->notices()->text(0).contains(QStringLiteral("refused by the script")));
  }

  void whatIsSaidOfARefusedEntryGoesWithTheNextGoodOne() {
    Fixture f;
    for (const char* place : {"operate", "tune"}) {
      f.window->frame()->go(QLatin1String(place));
      const auto* page = f.window->frame()->page(QLatin1String(place));
      auto* field = page->findChild<QLineEdit*>(QStringLiteral("control.kp_field"));
      const auto enter = [&](const char* text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QLatin1String(text));
        QTest::keyClick(field, Qt::Key_Return);
      };
      enter("nonsense");
      QCOMPARE(f.window->notices()->count(), 1);
      QVERIFY(f.window->notices()->shownText().contains(QStringLiteral("nonsense")));
      enter("rubbish");  // in the place of the former one
      QCOMPARE(f.window->notices()->count(), 1);
      QVERIFY(f.window->notices()->shownText().contains(QStringLiteral("rubbish")));
      enter("0.2");
      QVERIFY2(f.window->notices()->count() == 0, qPrintable(f.window->notices()->shownText()));
      enter("nonsense");
      enter("0.2");  // the value that it has
      QCOMPARE(f.window->notices()->count(), 0);
    }
    // So does a refusal by the session.
    f.session->refuses = true;
    f.row("texture.k_vib")->slider()->setValue(200);
    QCOMPARE(f.window->notices()->count(), 1);
    f.session->refuses = false;
    f.row("texture.k_vib")->slider()->setValue(220);
    QCOMPARE(f.window->notices()->count(), 0);
  }

  void theRobotsChangeIsShownAndAnEchoDoesNotPullTheSliderBack() {
    Fixture f;
    const auto index = static_cast<std::uint16_t>(indexOf(f.session->profile, "texture.k_vib"));
    const auto changed = [&](double value) {
      f.session->notices.push_back(
          {.event = {.kind = pipeline::EventKind::parameter_changed, .index = index, .value = value},
           .message = verbatim("texture.k_vib")});
      f.window->feed().pump();
    };
    changed(1.1);
    QCOMPARE(f.row("texture.k_vib")->field()->text(), QStringLiteral("1.1"));
    f.row("texture.k_vib")->slider()->setValue(100);
    f.row("texture.k_vib")->slider()->setValue(200);
    const QString set = f.row("texture.k_vib")->field()->text();
    changed(2.5);  // the first of the two, coming back
    QCOMPARE(f.row("texture.k_vib")->field()->text(), set);
    changed(5.0);
    changed(1.2);  // and now the robot's again
    QCOMPARE(f.row("texture.k_vib")->field()->text(), QStringLiteral("1.2"));
  }

  void aFullCommandQueueIsTold() {
    Fixture f;
    f.session->takes_commands = false;
    QTest::mouseClick(f.window->stateBar()->tareButton(), Qt::LeftButton);
    QCOMPARE(f.window->notices()->count(), 1);
  }

  void saveWritesTheProfileAndAFailureSaysWhy() {
    Fixture f;
    f.row("texture.k_vib")->slider()->setValue(200);
    QTest::mouseClick(f.window->operate()->tuning()->saveButton(), Qt::LeftButton);
    auto loaded = station::loadProfile(f.folder.filePath(QStringLiteral("profile.toml")).toStdString());
    QVERIFY(loaded.has_value());
    QCOMPARE(loaded->step.texture.k_vib, f.session->profile.step.texture.k_vib);
    // Changed by an editor since: said once, and overwritten only when asked again.
    const auto by_hand = [&] {
      return station::loadProfile(f.folder.filePath(QStringLiteral("profile.toml")).toStdString())->step.control.kp;
    };
    loaded->step.control.kp = 0.125;
    QVERIFY(station::saveProfile(*loaded, f.folder.filePath(QStringLiteral("profile.toml")).toStdString()));
    f.window->commands().action(QStringLiteral("session.save_profile"))->trigger();
    QCOMPARE(by_hand(), 0.125);
    f.window->commands().action(QStringLiteral("session.save_profile"))->trigger();
    QCOMPARE(by_hand(), f.session->profile.step.control.kp);
    // A second console on the same profile says who has the first, and saves nothing.
    {
      console::MainWindow second(std::make_unique<ScriptedSession>(),
                                 f.folder.filePath(QStringLiteral("profile.toml")));
      second.start();
      const QString process = QString::number(QCoreApplication::applicationPid());
      QVERIFY2(second.notices()->text(0).contains(process), qPrintable(second.notices()->text(0)));
      f.session->profile.step.control.kp = 0.25;
      second.commands().action(QStringLiteral("session.save_profile"))->trigger();
      QVERIFY(by_hand() != 0.25);
    }
    f.window->commands().action(QStringLiteral("session.save_profile"))->trigger();
    QCOMPARE(by_hand(), 0.25);
    // A file in the way of the folder: no right and no privilege gets around that.
    QFile obstacle(f.folder.filePath(QStringLiteral("file")));
    QVERIFY(obstacle.open(QIODevice::WriteOnly));
    auto session = std::make_unique<ScriptedSession>();
    console::MainWindow window(std::move(session), obstacle.fileName() + QStringLiteral("/profile.toml"));
    window.commands().action(QStringLiteral("session.save_profile"))->trigger();
    QVERIFY(window.notices()->text(0).startsWith(QStringLiteral("Profile not saved.")));
  }

  void telemetryNoticesAndSilenceReachTheScreen() {
    Fixture f;
    for (const auto& [state, word] :
         {std::pair{SafetyState::connected, "Connected"}, std::pair{SafetyState::active, "Active"}}) {
      f.session->say(state);
      f.window->feed().pump();
      QCOMPARE(f.window->stateBar()->stateWord(), QLatin1String(word));
    }
    f.session->notices.push_back(
        {.event = {.kind = pipeline::EventKind::tare_done, .value = 0.2}, .message = verbatim("Tare done.")});
    f.window->feed().pump();
    QCOMPARE(f.window->notices()->count(), 1);
    QCOMPARE(f.window->log()->lines(), 1);
    f.window->start();
    WAIT_EQUAL(f.window->stateBar()->stateWord(), QStringLiteral("Unknown"));
  }

  void workThatThrowsEndsWithoutAResult() {
    console::Background work;
    bool finished = false;
    const QSignalSpy failed(&work, &console::Background::failed);
    work.run([](const std::stop_token&) -> console::Background::Finish { throw std::runtime_error("no memory left"); });
    QTRY_VERIFY(!work.running());
    QCOMPARE(failed.count(), 1);
    QCOMPARE(failed.front().front().toString(), QStringLiteral("no memory left"));
    work.run([&](const std::stop_token&) -> console::Background::Finish { return [&] { finished = true; }; });
    QTRY_VERIFY(finished);
    QCOMPARE(failed.count(), 1);
  }

  void missedCyclesAreNoneWhenAnotherSessionCountsAnew() {
    Fixture f;
    QString loop;
    connect(&f.window->feed(), &console::SessionFeed::parts, this, [&](const std::vector<widgets::PartView>& parts) {
      for (const widgets::PartView& part : parts) {
        if (part.icon == QStringLiteral("loop")) loop = part.figures;
      }
    });
    f.session->now.loop.missed_cycles = 40;
    f.window->start();
    WAIT_EQUAL(loop, QStringLiteral("1 kHz · 4.0 % missed"));
    f.session->now = {};  // what a session says whose station has gone
    WAIT_FOR(loop != QStringLiteral("1 kHz · 4.0 % missed"));
    QCOMPARE(loop, QStringLiteral("1 kHz · 0.0 % missed"));
  }

  void missingCameraTeaches() {
    Fixture f;
    f.session->now.parts = {{.part = device::Part::camera,
                             .description = verbatim("device 7"),
                             .ok = false,
                             .problem = verbatim("no such device")}};
    f.window->feed().pump();
    QCOMPARE(f.window->operate()->camera()->figure(0), QStringLiteral("—"));
    QVERIFY(f.window->operate()->camera()->image()->emptyText().contains(QStringLiteral("device 7")));
  }

  void picturesOfEveryKindAreShownOrLeftOut() {
    for (const int type : {CV_8UC1, CV_8UC3}) {
      const QImage image = console::toImage(cv::Mat(12, 17, type, cv::Scalar(10, 20, 30)));
      QCOMPARE(image.size(), QSize(17, 12));
      QCOMPARE(image.pixelColor(3, 3).blue(), 10);
      QCOMPARE(image.pixelColor(3, 3).red(), type == CV_8UC3 ? 30 : 10);
    }
    QVERIFY(console::toImage(cv::Mat()).isNull());
    QVERIFY(console::toImage(cv::Mat(3, 3, CV_32F)).isNull());
    QVERIFY(console::toImage(cv::Mat(3, 3, CV_8UC2)).isNull());
  }

  void simulatedFingerFollowsTheMouse() {
    Fixture f;
    f.session->view.picture = cv::Mat(240, 320, CV_8UC1, cv::Scalar(200));
    f.session->view.number = 1;
    f.window->feed().pump();
    QWidget* image = f.window->operate()->camera()->image();
    QTest::mousePress(image, Qt::LeftButton, {}, image->rect().center());
    QCOMPARE(f.session->finger.size(), std::size_t{3});
    QVERIFY(std::abs(f.session->finger[0]) < 10.0 && f.session->finger[2] == 4.0);
    QTest::mouseRelease(image, Qt::LeftButton, {}, image->rect().center());
    QVERIFY(f.session->finger.empty());
  }

  void theMousePressesNoTouchpadOfOnesOwn() {
    Fixture f;
    f.session->view.picture = cv::Mat(240, 320, CV_8UC1, cv::Scalar(200));
    const auto pressed = [&] {
      ++f.session->view.number;
      f.window->feed().pump();
      f.session->finger.clear();
      QWidget* image = f.window->operate()->camera()->image();
      QTest::mousePress(image, Qt::LeftButton, {}, image->rect().center());
      const bool moved = !f.session->finger.empty();
      QTest::mouseRelease(image, Qt::LeftButton, {}, image->rect().center());
      return moved;
    };
    const QAction* card = f.window->commands().action(QStringLiteral("session.finger_card"));
    QVERIFY(pressed() && f.window->operate()->finger()->isVisible() && card->isEnabled());
    const auto connect_to = [&](const char* touchpad, std::string_view identity) {
      f.session->profile.calibrated_on = identity;
      changeDevices(f, {.touchpad = touchpad});
      QCOMPARE(f.session->present.touchpad, std::string(touchpad));
    };
    connect_to("modbus-tcp:10.0.0.7:502", "FYD-0007");
    QVERIFY(!pressed() && !f.window->operate()->finger()->isVisible() && !card->isEnabled());
    connect_to("simulated", station::kSimulatedTouchpad);
    QVERIFY(pressed() && f.window->operate()->finger()->isVisible() && card->isEnabled());
  }

  void theSimulatedFingerPlaysAGestureCardAtASpeedOnceOrAgain() {
    Fixture f;
    console::FingerMenu* menu = f.window->operate()->finger();
    QVERIFY(menu != nullptr && menu->isVisible());
    QVERIFY(menu->text().contains(QStringLiteral("Demonstration")));
    QVERIFY(f.session->played.empty());  // it goes on with what it does
    const QString path = f.folder.filePath(QStringLiteral("stroke.gesture"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "format = \"FYD gesture 1\"\nname = \"a stroke & more\"\nspeed = 3\nloop = false\n---\n"
        "t_s,x_mm,y_mm,depth_mm\n0,-9,5,2\n3,9,5,2\n");
    file.close();
    menu->playFile(path);
    WAIT_EQUAL(f.session->played.size(), std::size_t{1});
    QVERIFY(std::abs(f.session->played.back().at(0.5).x_mm) <
            1e-9);                                     // half of the way in half a second: three times as fast
    QVERIFY(f.session->played.back().at(1.2).lifted);  // once
    QVERIFY(menu->text().contains(QStringLiteral("a stroke && more")));
    QVERIFY(!menu->again() && menu->speed() == 3.0);
    const auto trigger = [&](const QString& words) {
      QList<QAction*> all = menu->menu()->actions();
      for (QAction* each : menu->menu()->actions()) {
        if (each->menu() != nullptr) all += each->menu()->actions();
      }
      for (QAction* each : all) {
        if (each->text() == words) return each->trigger();
      }
      QFAIL(qPrintable(words));
    };
    trigger(QStringLiteral("1 ×"));
    QVERIFY(std::abs(f.session->played.back().at(1.5).x_mm) < 1e-9);
    trigger(QStringLiteral("Again and again"));
    QVERIFY(!f.session->played.back().at(5.0).lifted);  // 3 s, half a second lifted, and again
    trigger(QStringLiteral("Demonstration"));
    QCOMPARE(f.session->played.back().duration_s(), sim::FingerPath::demonstration().duration_s());
    QVERIFY(menu->text().contains(QStringLiteral("Demonstration")));
    trigger(QStringLiteral("a stroke && more"));
    QCOMPARE(f.session->played.back().at(0.0).x_mm, -9.0);
    // What is no card changes nothing.
    const std::size_t before = f.session->played.size();
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("format = \"FYD gesture 1\"\nname = \"far\"\n---\nt_s,x_mm,y_mm,depth_mm\n0,99,5,2\n3,9,5,2\n");
    file.close();
    const int told = f.window->notices()->count();
    menu->playFile(path);
    WAIT_EQUAL(f.window->notices()->count(), told + 1);
    QCOMPARE(f.session->played.size(), before);
    QVERIFY(menu->text().contains(QStringLiteral("a stroke")));
    QVERIFY(f.window->notices()->text(f.window->notices()->count() - 1).contains(QStringLiteral("x_mm is 99")));
  }
  void everyCommandHasItsOwnKeysAndThePaletteRunsThem() {
    Fixture f;
    // Two places may use the same keys, as only one is shown; nothing else may.
    QSet<QString> ids;
    std::map<QString, QSet<QString>> keys;
    for (const QAction* action : f.window->commands().actions()) {
      QVERIFY2(!ids.contains(action->objectName()), qPrintable(action->objectName()));
      ids.insert(action->objectName());
      const QString own = action->property("keys").toString();
      const QString place = console::CommandRegistry::placeOf(*action);
      if (own.isEmpty()) continue;
      QVERIFY2(!keys[place].contains(own) && !keys[QString()].contains(own), qPrintable(action->objectName()));
      keys[place].insert(own);
    }
    for (const auto& [place, own] : keys) {
      QVERIFY2(place.isEmpty() || !own.intersects(keys[QString()]), qPrintable(place));
    }
    f.window->palette()->open();
    f.window->palette()->field()->setText(QStringLiteral("THEME  light"));  // in any order
    QCOMPARE(f.window->palette()->list()->count(), 1);
    QVERIFY(f.window->palette()->list()->item(0)->text().startsWith(QStringLiteral("Light theme")));
    f.window->palette()->field()->clear();
    QTest::keyClicks(f.window->palette()->field(), QStringLiteral("tare"));
    QTest::keyClick(f.window->palette()->field(), Qt::Key_Return);
    QCOMPARE(f.session->count(OperatorAction::tare), 1);
  }

  void fitsASmallScreenInBothThemesAndEveryControlHasAName() {
    Fixture f;
    for (const auto choice : {widgets::ThemeChoice::light, widgets::ThemeChoice::dark}) {
      widgets::Look::instance().apply(*qApp, choice);
      QVERIFY2(f.window->minimumSizeHint().width() <= 1000,
               qPrintable(QString::number(f.window->minimumSizeHint().width())));
      QVERIFY2(f.window->minimumSizeHint().height() <= 640,
               qPrintable(QString::number(f.window->minimumSizeHint().height())));
    }
    for (QAbstractButton* button : f.window->operate()->findChildren<QAbstractButton*>()) {
      QVERIFY2(!button->text().isEmpty() || !button->accessibleName().isEmpty(), qPrintable(button->objectName()));
    }
  }

  void closingStopsTheMotorsFirst() {
    Fixture f;
    f.window->close();
    QVERIFY(f.session->stops >= 1);
    QVERIFY(f.session->shut_downs >= 1);
  }

  void wrongOptionsAreRefusedWithTheirName() {
    const QString program = QStringLiteral("fyd-console");
    for (const QStringList& wrong :
         {QStringList{QStringLiteral("--theme"), QStringLiteral("pink")},
          QStringList{QStringLiteral("--after"), QStringLiteral("soon")},
          QStringList{QStringLiteral("--after"), QStringLiteral("-1")},
          QStringList{QStringLiteral("--touchpad"), QStringLiteral("kitchen")},
          QStringList{QStringLiteral("--robot"), QStringLiteral("kitchen")},
          QStringList{QStringLiteral("--page"), QStringLiteral("kitchen")},
          QStringList{QStringLiteral("--language"), QStringLiteral("klingon")},
          QStringList{QStringLiteral("--operator"), QStringLiteral("MM")},
          QStringList{QStringLiteral("--touchpad"), QStringLiteral("modbus-tcp:10.0.0.7:502"),
                      QStringLiteral("--simulate")},
          QStringList{QStringLiteral("--trial-seed"), QStringLiteral("7")},
          QStringList{QStringLiteral("--trial-repetitions"), QStringLiteral("4000000000"), QStringLiteral("--trials"),
                      QStringLiteral("soft,hard")},
          QStringList{QStringLiteral("--trial-seed"), QStringLiteral("-7"), QStringLiteral("--trials"),
                      QStringLiteral("soft,hard")},
          QStringList{QStringLiteral("--nonsense")}, QStringList{QStringLiteral("stray")}}) {
      const auto options = console::readOptions(QStringList{program} + wrong, console::placeNames());
      QVERIFY(!options.has_value());
      const QString name = wrong.first().mid(wrong.first().startsWith(QLatin1String("--")) ? 2 : 0);
      QVERIFY(QString::fromStdString(options.error().text()).contains(name));
    }
    const auto options =
        console::readOptions({program, QStringLiteral("--theme"), QStringLiteral("light")}, console::placeNames());
    QVERIFY(options.has_value() && options->theme == widgets::ThemeChoice::light && !options->station.record);
    const QString seed = QStringLiteral("18446744073709551615");
    const auto trials = console::readOptions(
        {program, QStringLiteral("--trials"), QStringLiteral("soft,hard"), QStringLiteral("--trial-seed"), seed},
        console::placeNames());
    QVERIFY2(trials.has_value(), trials ? "" : trials.error().text().c_str());
    QCOMPARE(QString::number(trials->trials.seed), seed);
    const auto wide = console::readOptions({program, QStringLiteral("--trials"), QStringLiteral("soft,hard"),
                                            QStringLiteral("--trial-repetitions"), QStringLiteral("4000000000")},
                                           console::placeNames());
    const QString why = wide ? QString() : QString::fromStdString(wide.error().text());
    QVERIFY2(why.contains(QStringLiteral("4000000000: expected a whole number from 1 to 1000")), qPrintable(why));
    const auto resolved = station::withProfileSources(options->station);
    QVERIFY(resolved.robot == "simulated" && resolved.touchpad == "simulated");
    const QString words = QStringLiteral(
        "fyd-console|--touchpad|modbus-tcp:10.0.0.7:502|--motors|qbmove:/dev/ttyUSB0|--camera|0|--surface|wood.toml|"
        "--record|s.h5|--operator|MM|--subject|S07|--tag|pilot|--tag|left hand|--page|devices");
    const auto more = console::readOptions(words.split(QLatin1Char('|')), console::placeNames());
    QVERIFY2(more.has_value(), more ? "" : more.error().text().c_str());
    QCOMPARE(more->station.touchpad, std::string("modbus-tcp:10.0.0.7:502"));
    QCOMPARE(more->station.motors, std::string("qbmove:/dev/ttyUSB0"));
    QCOMPARE(more->station.surface, std::string("wood.toml"));
    QCOMPARE(more->station.record->subject, std::string("S07"));
    QCOMPARE(more->station.record->tags, (std::vector<std::string>{"pilot", "left hand"}));
    QCOMPARE(more->page, QStringLiteral("devices"));
  }
};

std::unique_ptr<QObject> makeConsoleTest() { return std::make_unique<ConsoleTest>(); }

}  // namespace fyd::tests

#include "console_test.moc"
