// State bar, hold button, camera, readiness, notices and log, each alone.
#include "tests/widgets/suite.h"
#include "tests/widgets/wait.h"
#include "widgets/basics/icon.h"
#include "widgets/devices/camera_panel.h"
#include "widgets/devices/picture_pick.h"
#include "widgets/status/log_view.h"
#include "widgets/status/notice_stack.h"
#include "widgets/status/readiness_list.h"
#include "widgets/status/state_bar.h"
#include "widgets/status/state_text.h"

namespace fyd::tests {

using pipeline::Fault;
using pipeline::SafetyState;

namespace {

/// The mouse goes there with its left button down.
void dragTo(QWidget& widget, QPointF to) {
  QMouseEvent moved(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&widget, &moved);
}

}  // namespace

class ControlTest : public QObject {
  Q_OBJECT
 private slots:
  void armNeedsHoldingByMouse() {
    widgets::HoldButton button(QStringLiteral("Hold to arm"));
    button.show();
    QVERIFY(QTest::qWaitForWindowExposed(&button, kPatience_ms));
    QSignalSpy held(&button, &widgets::HoldButton::held);
    QTest::mouseClick(&button, Qt::LeftButton);
    passTimers(widgets::HoldButton::kHold_ms + 200);
    QCOMPARE(held.count(), 0);
    QTest::mousePress(&button, Qt::LeftButton);
    WAIT_FOR(button.progress() > 0.2 || held.count() == 1);  // the second when the machine stood still in between
    WAIT_EQUAL(held.count(), 1);
    passTimers(2 * widgets::HoldButton::kHold_ms);
    QTest::mouseRelease(&button, Qt::LeftButton);
    QCOMPARE(held.count(), 1);  // once for each hold
  }

  void armNeedsHoldingByKeyAndAutoRepeatIsNoHold() {
    widgets::HoldButton button(QStringLiteral("Hold to arm"));
    button.show();
    button.setFocus();
    QVERIFY(QTest::qWaitForWindowActive(&button, kPatience_ms));
    QSignalSpy held(&button, &widgets::HoldButton::held);
    QTest::keyClick(&button, Qt::Key_Space);
    passTimers(widgets::HoldButton::kHold_ms + 100);
    QCOMPARE(held.count(), 0);
    QTest::keyPress(&button, Qt::Key_Space);
    QTest::qWait(50);
    QKeyEvent repeat_up(QEvent::KeyRelease, Qt::Key_Space, Qt::NoModifier, QString(), true);
    QKeyEvent repeat_down(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, QString(), true);
    QApplication::sendEvent(&button, &repeat_up);
    QApplication::sendEvent(&button, &repeat_down);
    WAIT_EQUAL(held.count(), 1);
    QTest::keyRelease(&button, Qt::Key_Space);
  }

  void holdIsTakenBackByLeavingAndByLosingTheFocus() {
    widgets::HoldButton button(QStringLiteral("Hold to arm"));
    button.resize(120, 40);
    button.show();
    QVERIFY(QTest::qWaitForWindowExposed(&button, kPatience_ms));
    QSignalSpy held(&button, &widgets::HoldButton::held);
    QTest::mousePress(&button, Qt::LeftButton);
    QTest::qWait(100);
    dragTo(button, {400, 400});
    QCOMPARE(button.progress(), 0.0);
    QTest::mouseRelease(&button, Qt::LeftButton, {}, QPoint(400, 400));
    QTest::mousePress(&button, Qt::LeftButton);
    QFocusEvent lost(QEvent::FocusOut);
    QApplication::sendEvent(&button, &lost);
    passTimers(widgets::HoldButton::kHold_ms + 100);
    QCOMPARE(held.count(), 0);
  }

  void lettingGoEarlyIsHeardThoughTheWindowWasBusy() {
    widgets::HoldButton button(QStringLiteral("Hold to arm"));
    button.resize(120, 40);
    button.show();
    QVERIFY(QTest::qWaitForWindowExposed(&button, kPatience_ms));
    QSignalSpy held(&button, &widgets::HoldButton::held);
    // Timers first, as after a stall: what the hand did meanwhile still waits.
    const auto stall = [](int ms) {
      QThread::msleep(static_cast<unsigned long>(ms));
      QApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
    };
    QTest::mousePress(&button, Qt::LeftButton);
    stall(2 * widgets::HoldButton::kHold_ms);
    QCOMPARE(held.count(), 0);
    QTest::mouseRelease(&button, Qt::LeftButton);
    // Short of the whole hold by the last stall only.
    QTest::mousePress(&button, Qt::LeftButton);
    constexpr int kStep_ms = widgets::HoldButton::kLongestStep_ms;
    for (int i = 0; i < widgets::HoldButton::kHold_ms / kStep_ms; ++i) stall(kStep_ms + 5);
    QVERIFY(button.progress() > 0.5);
    QCOMPARE(held.count(), 0);
    QTest::mouseRelease(&button, Qt::LeftButton);
    passTimers(widgets::HoldButton::kHold_ms + 200);
    QCOMPARE(held.count(), 0);
    // A window that is always slow still arms.
    QTest::mousePress(&button, Qt::LeftButton);
    for (int i = 0; i < 1000 && held.isEmpty(); ++i) stall(kStep_ms + 5);
    QCOMPARE(held.count(), 1);
    QTest::mouseRelease(&button, Qt::LeftButton);
  }

  void onePressBeginsOneHoldThoughTheMouseComesBack() {
    widgets::HoldButton button(QStringLiteral("Hold to move"));
    button.resize(120, 40);
    button.show();
    QVERIFY(QTest::qWaitForWindowExposed(&button, kPatience_ms));
    QSignalSpy held(&button, &widgets::HoldButton::held);
    QSignalSpy let_go(&button, &widgets::HoldButton::letGo);
    const QPointF inside = QRectF(button.rect()).center();
    QFocusEvent lost(QEvent::FocusOut);
    for (const bool acted : {false, true}) {
      for (const auto& end : {std::function([&] {
                                dragTo(button, {400, 400});
                              }),
                              std::function([&] { QApplication::sendEvent(&button, &lost); }), std::function([&] {
                                button.setEnabled(false);
                                button.setEnabled(true);
                              })}) {
        held.clear();
        let_go.clear();
        QTest::mousePress(&button, Qt::LeftButton);
        if (acted) WAIT_EQUAL(held.count(), 1);
        end();
        QCOMPARE(let_go.count(), acted ? 1 : 0);
        dragTo(button, {400, 400});
        dragTo(button, inside);
        dragTo(button, inside + QPointF(1, 0));
        passTimers(widgets::HoldButton::kHold_ms + 200);
        QCOMPARE(held.count(), acted ? 1 : 0);
        QVERIFY(!button.engaged() && button.progress() == 0.0);
        QTest::mouseRelease(&button, Qt::LeftButton);
      }
    }
    QTest::mousePress(&button, Qt::LeftButton);
    WAIT_EQUAL(held.count(), 2);
    QTest::mouseRelease(&button, Qt::LeftButton);
  }

  void everyStateSaysWhatWhyAndWhatToDo() {
    for (std::size_t s = 0; s < pipeline::kSafetyStateCount; ++s) {
      for (std::size_t l = 0; l < pipeline::kFaultCount; ++l) {
        const auto words = widgets::describeState(static_cast<SafetyState>(s), static_cast<Fault>(l));
        QVERIFY(!words.word.isEmpty() && !words.why.isEmpty() && words.why.endsWith(QLatin1Char('.')));
        QVERIFY(!widgets::icon(words.icon).isNull());
        const bool latched =
            s == static_cast<std::size_t>(SafetyState::held) || s == static_cast<std::size_t>(SafetyState::stopped);
        if (latched) QVERIFY(words.to_do.contains(QStringLiteral("Re-arm")));
      }
    }
  }

  void stateBarFollowsTheStateAndOwnsUpToSilence() {
    widgets::StateBar bar;
    bar.show();
    QCOMPARE(bar.stateWord(), QStringLiteral("Starting"));
    QVERIFY(!bar.armButton()->isEnabled());
    bar.showState(SafetyState::held, Fault::robot_lost);
    QCOMPARE(bar.stateWord(), QStringLiteral("Held"));
    QVERIFY(bar.stateReason().contains(QStringLiteral("robot is silent")));
    QCOMPARE(bar.armButton()->text(), QStringLiteral("Hold to re-arm"));
    bar.showState(SafetyState::active, Fault::none);
    QVERIFY(!bar.armButton()->isEnabled());
    bar.showSilence(true);
    QCOMPARE(bar.stateWord(), QStringLiteral("Unknown"));
    QVERIFY(bar.stopButton()->isEnabled());
    QSignalSpy stop(&bar, &widgets::StateBar::stopAsked);
    QTest::mousePress(bar.stopButton(), Qt::LeftButton);  // on the way down
    QCOMPARE(stop.count(), 1);
    QTest::mouseRelease(bar.stopButton(), Qt::LeftButton);
  }

  void unknownIsTimedFromTheSilenceOn() {
    widgets::StateBar bar;
    bar.showState(SafetyState::active, Fault::none);
    QTest::qWait(1100);
    bar.showSilence(true);
    QCOMPARE(bar.stateTime(), QStringLiteral("for 0 s"));
    bar.showSilence(false);  // the state that it still is
    QVERIFY(bar.stateTime() != QStringLiteral("for 0 s"));
  }

  void readinessCountsAndTellsTheRemedy() {
    widgets::ReadinessList list;
    list.setRows({{QStringLiteral("Motors answer"), true, {}},
                  {QStringLiteral("Camera sees"), false, QStringLiteral("Light.")}});
    QCOMPARE(list.title(), QStringLiteral("Ready? 1/2"));
    const auto labels = list.findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](QLabel* l) { return l->text() == QStringLiteral("Light."); }));
  }

  void theFocusStaysInTheReadinessWhileItsLinesChange() {
    QWidget window;
    auto* lines = new QVBoxLayout(&window);
    auto* first = new QPushButton(QStringLiteral("First"), &window);
    auto* list = new widgets::ReadinessList(&window);
    auto* arm = new QPushButton(QStringLiteral("Arm"), &window);
    for (QWidget* each : {static_cast<QWidget*>(first), static_cast<QWidget*>(list), static_cast<QWidget*>(arm)}) {
      lines->addWidget(each);
    }
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window, kPatience_ms));
    const auto line = [](const QString& command, bool ok, const QString& why) {
      widgets::ReadinessRow row{.what = command, .ok = ok};
      if (ok) return row;
      row.why = why;
      row.command = row.action = command;
      return row;
    };
    const auto show = [&](bool tared, const QString& why, bool linked) {
      list->setRows({line(QStringLiteral("tare"), tared, why), line(QStringLiteral("link"), linked, why)});
    };
    const auto button = [&](const char* command) {
      return list->findChild<QToolButton*>(QStringLiteral("mend_") + QLatin1String(command));
    };
    show(false, QStringLiteral("1 mm"), false);
    WAIT_FOR(button("link")->isVisible());
    first->setFocus();
    QTest::keyClick(first, Qt::Key_Tab);
    QVERIFY(button("tare")->hasFocus());
    QTest::keyClick(button("tare"), Qt::Key_Tab);
    show(false, QStringLiteral("2 mm"), false);
    QVERIFY(button("link")->hasFocus());
    // Pressed, it mends its own line: that line is gone while the button still acts.
    connect(list, &widgets::ReadinessList::commandAsked, list, [&] { show(false, QStringLiteral("2 mm"), true); });
    QTest::keyClick(button("link"), Qt::Key_Space);
    QVERIFY(button("link") == nullptr);
    QVERIFY(button("tare")->hasFocus());
    show(true, {}, true);
    QVERIFY(list->hasFocus());
    QVERIFY(!arm->hasFocus());
    WAIT_FOR(list->findChildren<QToolButton*>().isEmpty());
  }

  void mouseOnThePictureMovesTheSimulatedFinger() {
    widgets::CameraPanel panel;
    panel.resize(340, 420);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel, kPatience_ms));
    QSignalSpy moved(panel.image(), &widgets::CameraImage::fingerMoved);
    QSignalSpy released(panel.image(), &widgets::CameraImage::fingerReleased);
    QImage picture(320, 240, QImage::Format_Grayscale8);
    picture.fill(200);
    panel.setPicture({.picture = picture, .region = QRect(40, 45, 220, 150)});
    const QPoint middle = panel.image()->rect().center();
    QTest::mousePress(panel.image(), Qt::LeftButton, {}, middle);
    QCOMPARE(moved.count(), 0);  // a real touchpad: the mouse does nothing
    panel.setTouchable([](QPointF px) { return QPointF((px.x() - 160) * 0.5, (120 - px.y()) * 0.5); });
    QTest::mousePress(panel.image(), Qt::LeftButton, {}, middle);
    QCOMPARE(moved.count(), 1);
    QVERIFY(std::abs(moved[0][0].toDouble()) < 1.0 && std::abs(moved[0][1].toDouble()) < 1.0);
    QWheelEvent wheel(middle, panel.image()->mapToGlobal(middle), {}, QPoint(0, -120), Qt::LeftButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(panel.image(), &wheel);
    QCOMPARE(moved.last()[2].toDouble(), 4.25);
    QTest::mouseRelease(panel.image(), Qt::LeftButton, {}, middle);
    QCOMPARE(released.count(), 1);
    const auto turn = [&](QPoint by) {
      QWheelEvent event(middle, panel.image()->mapToGlobal(middle), {}, by, Qt::NoButton, Qt::NoModifier,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(panel.image(), &event);
    };
    for (const int x : {-120, 120}) turn({x, 0});
    QCOMPARE(panel.image()->depth_mm(), 4.25);
    for (int i = 0; i < 20; ++i) turn({0, -6});  // a notch in the small turns of a touchpad
    QVERIFY(std::abs(panel.image()->depth_mm() - 4.5) < 1e-9);
    turn({0, 120});
    QVERIFY(std::abs(panel.image()->depth_mm() - 4.25) < 1e-9);
    for (int i = 0; i < 100; ++i) QApplication::sendEvent(panel.image(), &wheel);
    QCOMPARE(panel.image()->depth_mm(), widgets::CameraImage::kMaximumDepth_mm);
  }

  void aRegionIsTheSameWhicheverCornerItIsDraggedFrom() {
    widgets::PicturePick pick;
    pick.resize(320, 240);
    pick.show();
    QVERIFY(QTest::qWaitForWindowExposed(&pick, kPatience_ms));
    QImage picture(320, 240, QImage::Format_Grayscale8);
    picture.fill(200);
    pick.setPicture(picture);
    pick.setKind(widgets::PickKind::rectangle);
    QSignalSpy picked(&pick, &widgets::PicturePick::rectanglePicked);
    const auto drag = [&](QPoint from, QPoint to) {
      QTest::mousePress(&pick, Qt::LeftButton, {}, from);
      QTest::mouseRelease(&pick, Qt::LeftButton, {}, to);
      return pick.rectangle();
    };
    const QRect area(QPoint(40, 30), QPoint(240, 190));
    const QRect region = drag(area.topLeft(), area.bottomRight());
    QVERIFY(region.width() >= 200 && region.height() >= 160);
    QCOMPARE(drag(area.bottomRight(), area.topLeft()), region);
    QCOMPARE(drag(area.topRight(), area.bottomLeft()), region);
    QCOMPARE(drag(area.bottomLeft(), area.topRight()), region);
    QCOMPARE(picked.count(), 4);
  }

  void fingerFiguresAreNoneWithoutContactAndWithoutPicture() {
    widgets::CameraPanel panel;
    QImage picture(32, 24, QImage::Format_Grayscale8);
    picture.fill(10);
    sensing::FingerDetection finger{.contact = true, .area_px = 412, .area_mm2 = 87.4, .x_mm = 12.4, .y_mm = -3.14};
    finger.reason = sensing::FingerReason::found;
    panel.setPicture({.picture = picture, .finger = finger});
    QCOMPARE(panel.figure(0), QStringLiteral("12.4 mm"));
    QCOMPARE(panel.figure(1), QStringLiteral("−3.1 mm"));
    QCOMPARE(panel.figure(2), QStringLiteral("87.4 mm²"));
    finger.contact = false;
    panel.setPicture({.picture = picture, .finger = finger});
    QCOMPARE(panel.figure(0), QStringLiteral("—"));
    panel.showMissing(QStringLiteral("Looked for: device 3"));
    QCOMPARE(panel.figure(2), QStringLiteral("—"));
  }

  void noticesStayUntilReadAndRepeatsAreCounted() {
    widgets::NoticeStack notices;
    notices.resize(900, notices.height());
    notices.show();
    const int height = notices.height();
    notices.post(widgets::Severity::warning, QStringLiteral("Tare failed."));
    notices.post(widgets::Severity::warning, QStringLiteral("Tare failed."));
    notices.post(widgets::Severity::information, QStringLiteral("Saved."));
    QCOMPARE(notices.count(), 2);
    passTimers(400);
    QCOMPARE(notices.count(), 2);
    QTest::mouseClick(notices.findChild<QToolButton*>(QStringLiteral("notice_close")), Qt::LeftButton);
    QCOMPARE(notices.count(), 1);
    QCOMPARE(notices.shownText(), QStringLiteral("Tare failed."));
    for (int i = 0; i < 20; ++i) notices.post(widgets::Severity::error, QString::number(i).repeated(300));
    QCOMPARE(notices.count(), widgets::NoticeStack::kMost);
    QCOMPARE(notices.height(), height);  // nothing moves for it, however much it says
    QVERIFY(notices.minimumSizeHint().width() < 600);
    const QString newest = notices.shownText();
    QTest::mouseClick(notices.findChild<QToolButton*>(QStringLiteral("notice_more")), Qt::LeftButton);
    QVERIFY(notices.shownText() != newest);
    notices.dismissAll();
    QCOMPARE(notices.count(), 0);
    QCOMPARE(notices.height(), height);
  }

  void aNoticeGoesWithItsCauseAndItsButtonsAct() {
    widgets::NoticeStack notices;
    notices.show();
    int pressed = 0;
    notices.post({.severity = widgets::Severity::warning,
                  .text = QStringLiteral("The robot is silent."),
                  .cause = QStringLiteral("robot"),
                  .actions = {}});
    notices.post({.severity = widgets::Severity::warning,
                  .text = QStringLiteral("Quit?"),
                  .cause = QStringLiteral("quit"),
                  .actions = {{QStringLiteral("yes"), QStringLiteral("Quit"), [&] { ++pressed; }}}});
    notices.withdraw(QStringLiteral("robot"));
    QCOMPARE(notices.count(), 1);
    QVERIFY(notices.shows(QStringLiteral("quit")) && !notices.shows(QStringLiteral("robot")));
    QTest::mouseClick(notices.findChild<QPushButton*>(QStringLiteral("yes")), Qt::LeftButton);
    QCOMPARE(pressed, 1);
    notices.withdraw({});  // no cause: nothing
    QCOMPARE(notices.count(), 1);
  }

  void heldSaysWhatIsMissingNowAndWhatIsBack() {
    const auto held = [](Fault fault, const widgets::MissingNow& now) {
      return widgets::describeState(SafetyState::held, fault, now).to_do;
    };
    const QString silent = widgets::asSentence(toString(Fault::motors_stale));
    const QString cable = QStringLiteral("Check the network cable to 10.0.0.7:502.");
    QVERIFY(held(Fault::motors_stale, {silent, cable, Fault::motors_stale}).startsWith(cable));
    QCOMPARE(held(Fault::motors_stale, {}), QStringLiteral("Since then it is back. Hold Re-arm to start again."));
    const QString other = held(Fault::motors_stale, {QStringLiteral("The camera sends no pictures"), cable});
    QVERIFY2(other.contains(QStringLiteral("camera sends no pictures.")) && other.contains(cable), qPrintable(other));
    QVERIFY(!held(Fault::step_gap, {}).contains(QStringLiteral("back")));  // nothing had gone
  }

  void heldNamesThisComputerInsteadOfACableWhenItWasLate() {
    const QString late = QStringLiteral("this computer was late: 9.1 % of the haptic cycles missed");
    widgets::StateBar bar;
    bar.resize(1280, 120);
    bar.show();
    bar.showState(SafetyState::active, Fault::none);
    bar.showLateness(late);  // the notice may come before the sample, and after it
    bar.showState(SafetyState::held, Fault::camera_stale);
    const auto said = [&] { return bar.accessibleDescription(); };
    QVERIFY2(said().contains(QStringLiteral("This computer was late: 9.1 %")), qPrintable(said()));
    QVERIFY2(!said().contains(QStringLiteral("cable")), qPrintable(said()));
    // What is missing even now still has its cable.
    bar.showMissing({widgets::asSentence(toString(Fault::camera_stale)),
                     QStringLiteral("Check the cable of the camera."), Fault::camera_stale});
    QVERIFY2(said().contains(QStringLiteral("Check the cable of the camera.")), qPrintable(said()));
    bar.showState(SafetyState::active, Fault::none);
    bar.showState(SafetyState::held, Fault::camera_stale);
    QVERIFY2(!said().contains(QStringLiteral("was late")), qPrintable(said()));
  }

  void whatIsSimulatedIsSaidWithItsParts() {
    using Origin = widgets::PartView::Origin;
    widgets::StateBar bar;
    bar.resize(1200, 120);
    bar.show();
    const auto show = [&](Origin touchpad, Origin camera) {
      bar.showParts({{.name = QStringLiteral("Touchpad"), .origin = touchpad},
                     {.name = QStringLiteral("Camera"), .origin = camera},
                     {.name = QStringLiteral("Loop")}});
      return bar.badge()->isVisible() ? bar.badge()->which() : QStringLiteral("none");
    };
    const QRect stop = bar.stopButton()->geometry();
    QCOMPARE(show(Origin::simulated, Origin::simulated), QStringLiteral("all parts"));
    QCOMPARE(show(Origin::real, Origin::simulated), QStringLiteral("Camera"));
    QCOMPARE(show(Origin::real, Origin::real), QStringLiteral("none"));
    QCOMPARE(bar.stopButton()->geometry(), stop);
  }

  void logIsSearchedAndBounded() {
    widgets::LogView log;
    for (int i = 0; i < widgets::LogView::kMost + 10; ++i) {
      log.add(QStringLiteral("12:00"), widgets::Severity::information,
              i % 100 == 0 ? QStringLiteral("Held") : QStringLiteral("x"));
    }
    QCOMPARE(log.lines(), widgets::LogView::kMost);
    QTest::keyClicks(log.searchField(), QStringLiteral("held"));
    QCOMPARE(log.shownLines(), 50);
  }
};

std::unique_ptr<QObject> makeControlTest() { return std::make_unique<ControlTest>(); }

}  // namespace fyd::tests

#include "control_test.moc"
