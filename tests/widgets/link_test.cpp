// The link's panel: what it says of every protocol, where it opens, and when and how the robot is changed.
#include "app/console/shell/views.h"
#include "core/protocol/endpoint.h"
#include "core/protocol/link/link_key_file.h"
#include "core/protocol/udp_socket.h"
#include "tests/widgets/scripted_session.h"
#include "tests/widgets/suite.h"
#include "widgets/basics/number_text.h"

namespace fyd::tests {

using pipeline::LinkPhase;
using pipeline::SafetyState;
using widgets::LinkView;

namespace {

station::StationStatus classicStatus() {
  station::StationStatus out;
  out.parts = {{.part = device::Part::robot, .ok = true, .rate_hz = 998.6, .age_ms = 1.0}};
  out.link = {.protocol = say("classic, not secured"),
              .secured = false,
              .local = "127.0.0.1:3490",
              .peer = "127.0.0.2:3490",
              .states_received = 1234,
              .touches_sent = 1233,
              .refused = 9,
              .phase = LinkPhase::running};
  out.link.figures.jitter_ms = 0.44;
  out.link.figures.silence_ms = 3.0;
  out.link.figures.lost = 2;
  (void)out.link.figures.refusals.push({.reason = "other address", .count = 7});
  (void)out.link.figures.refusals.push({.reason = "out of turn", .count = 2});
  return out;
}

station::StationStatus sealedStatus() {
  station::StationStatus out = classicStatus();
  out.link.protocol = say("FYD Link 1, sealed");
  out.link.secured = true;
  out.link.figures.round_trip_ms = 3.14;
  out.link.figures.loss_percent = 0.96;
  out.link.figures.refusals.clear();
  (void)out.link.figures.refusals.push({.reason = "wrong key or damaged", .count = 9});
  return out;
}

QString valueOf(const widgets::LinkPanel& panel, const char* label) { return panel.value(QLatin1String(label)); }

QRect linkPlace(const console::MainWindow& window) { return window.stateBar()->parts()->place(QStringLiteral("Link")); }

}  // namespace

class LinkTest : public QObject {
  Q_OBJECT
 private slots:
  void classicIsShownAsInsecureInWordsAndShape() {
    widgets::LinkPanel panel;
    panel.setLink(console::toLink(classicStatus()));
    QCOMPARE(panel.securityWord(), QStringLiteral("Not secured"));
    QCOMPARE(panel.securityShape(), QStringLiteral("lock-open"));
    const auto parts = console::toParts(classicStatus(), 0.0, 0);
    const auto part = std::ranges::find(parts, QStringLiteral("Link"), &widgets::PartView::name);
    QVERIFY(part != parts.end());
    QCOMPARE(part->icon, QStringLiteral("lock-open"));
    QVERIFY(part->figures.contains(QStringLiteral("not secured")));
    panel.setLink(console::toLink(sealedStatus()));
    QCOMPARE(panel.securityWord(), QStringLiteral("Secured"));
    QCOMPARE(panel.securityShape(), QStringLiteral("lock"));
  }

  void numbersInARowAreToldApartWhereACommaIsTheirDecimalSign() {
    const QLocale before;
    QCOMPARE(widgets::rowText({QStringLiteral("1.5"), QStringLiteral("2.0")}), QStringLiteral("1.5, 2.0"));
    QLocale::setDefault(QLocale(QLocale::Italian));
    const QString italian = widgets::rowText({QStringLiteral("1,5"), QStringLiteral("2,0")});
    QLocale::setDefault(before);
    QCOMPARE(italian, QStringLiteral("1,5; 2,0"));
  }

  void everyFigureIsShownAndWhatAProtocolCannotTellIsADash() {
    widgets::LinkPanel panel;
    panel.setLink(console::toLink(classicStatus()));
    const QString none = QStringLiteral("—");
    for (const auto& [label, text] : {std::pair{"State", "Running"},
                                      {"Robot", "127.0.0.2:3490"},
                                      {"Listening on", "127.0.0.1:3490"},
                                      {"Protocol", "classic, not secured"},
                                      {"Round trip", "—"},
                                      {"Jitter", "0.4 ms"},
                                      {"Loss", "—"},
                                      {"Messages", "999 a second"},
                                      {"Last message", "3 ms ago"},
                                      {"Received", "1234"},
                                      {"Sent", "1233"},
                                      {"Times lost", "2"},
                                      {"other address", "7"},
                                      {"out of turn", "2"}}) {
      QCOMPARE(valueOf(panel, label), QString::fromUtf8(text));
    }
    panel.setLink(console::toLink(sealedStatus()));
    QCOMPARE(valueOf(panel, "Round trip"), QStringLiteral("3.1 ms"));
    QCOMPARE(valueOf(panel, "Loss"), QStringLiteral("1.0 %"));
    QCOMPARE(valueOf(panel, "wrong key or damaged"), QStringLiteral("9"));
    QVERIFY(valueOf(panel, "out of turn").isEmpty());  // of the former link
    station::StationStatus without;
    without.link.protocol = say("none");
    panel.setLink(console::toLink(without));
    QCOMPARE(panel.securityWord(), QStringLiteral("No link"));
    for (const char* label : {"State", "Robot", "Round trip", "Loss", "Messages", "Last message", "Received"}) {
      QCOMPARE(valueOf(panel, label), none);
    }
  }

  void howTheArmIsLedStandsWhereTheRobotsEndSaysIt() {
    widgets::LinkPanel panel;
    station::StationStatus status = classicStatus();
    panel.setLink(console::toLink(status));
    QCOMPARE(valueOf(panel, "Predictor"), QStringLiteral("not told by this robot"));
    QVERIFY(valueOf(panel, "Prediction error").isEmpty());
    status.link.led = station::PredictedArm{.predictor = "order1",
                                            .arrived_mm = {12.34, -4.0, -2.06},
                                            .target_mm = {14.0, -3.5, -2.0},
                                            .error_mm = 0.973,
                                            .horizon_ms = 46.2};
    panel.setLink(console::toLink(status));
    QCOMPARE(valueOf(panel, "Predictor"), QStringLiteral("order1"));
    QCOMPARE(valueOf(panel, "Predicted ahead"), QStringLiteral("46 ms"));
    QCOMPARE(valueOf(panel, "Arrived"), QString::fromUtf8("12.3, −4.0, −2.1 mm"));
    QCOMPARE(valueOf(panel, "Predicted"), QString::fromUtf8("14.0, −3.5, −2.0 mm"));
    QCOMPARE(valueOf(panel, "Prediction error"), QStringLiteral("0.97 mm"));
  }

  void theCouplingIsChosenWhereTheRobotIsAndSaysWhatItDoesWithIt() {
    Fixture f;
    f.window->commands().action(QStringLiteral("view.link"))->trigger();
    widgets::CouplingForm* form = f.window->link()->coupling();
    QVERIFY(form->isVisible());
    QComboBox* choice = form->row()->choice();
    QCOMPARE(choice->currentText(), QStringLiteral("model"));
    QCOMPARE(choice->count(), 4);
    QVERIFY(form->hint().contains(QStringLiteral("only softens")));
    QTest::keyClick(choice, Qt::Key_Up);
    QCOMPARE(choice->currentText(), QStringLiteral("tdpa"));
    QCOMPARE(f.session->changes.back(), std::pair(std::string("pipeline.coupling"), 2.0));
    QVERIFY(!form->hint().contains(QStringLiteral("tells no force")));
    form->setForce(widgets::CouplingForm::Force::not_told);
    QVERIFY(form->hint().contains(QStringLiteral("tells no force")));
    form->setForce(widgets::CouplingForm::Force::told);
    QVERIFY(!form->hint().contains(QStringLiteral("tells no force")));
    QCOMPARE(form->energy(), QString::fromUtf8("Last touch: — given back beyond what was put in, — withheld"));
    form->setEnergy(-3.26, 0.04);
    QCOMPARE(form->energy(), QStringLiteral("Last touch: 3.3 mJ given back beyond what was put in, 0.0 mJ withheld"));
    form->setEnergy(0.8, 1.25);
    QVERIFY(form->energy().startsWith(QStringLiteral("Last touch: 0.0 mJ given back")));
  }

  void thePredictorOfTheSimulatedRobotIsChosen() {
    Fixture f;
    f.window->commands().action(QStringLiteral("view.link"))->trigger();
    widgets::RobotForm* form = f.window->link()->form();
    QVERIFY(form->predictor()->isVisible());
    QCOMPARE(form->predictor()->count(), 7);
    QCOMPARE(form->robot(), QStringLiteral("simulated"));
    form->predictor()->setCurrentText(QStringLiteral("thesis"));
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    QTest::mouseClick(form->reconnectButton(), Qt::LeftButton);
    WAIT_EQUAL(f.session->asked.size(), std::size_t{1});
    QCOMPARE(f.session->asked.back().robot, std::string("simulated:thesis"));
    form->kind()->setCurrentIndex(1);
    QVERIFY(!form->predictor()->isVisible());
    form->setRobot(QStringLiteral("simulated:kalman"), {});
    QCOMPARE(form->robot(), QStringLiteral("simulated:kalman"));
    form->setRobot(QStringLiteral("simulated"), {});
    QCOMPARE(form->robot(), QStringLiteral("simulated"));
  }

  void everyPhaseHasItsOwnWords() {
    QSet<QString> words;
    for (const LinkPhase phase :
         {LinkPhase::waiting, LinkPhase::running, LinkPhase::paused, LinkPhase::lost, LinkPhase::closed}) {
      station::StationStatus status = classicStatus();
      status.link.phase = phase;
      const LinkView view = console::toLink(status);
      QVERIFY(!view.condition.isEmpty());
      words.insert(view.condition);
      QCOMPARE(view.health == LinkView::Health::lost, phase == LinkPhase::lost);
    }
    QCOMPARE(words.size(), 5);
  }

  void closedAtFirstAndOpensFromTheStateBarTheMenuAndTheKeys() {
    Fixture f;
    f.session->now = classicStatus();
    f.window->feed().pump();
    QVERIFY(!f.window->link()->isVisible());
    widgets::PartList* parts = f.window->stateBar()->parts();
    QTest::mouseClick(parts, Qt::LeftButton, {}, linkPlace(*f.window).center());
    QVERIFY(f.window->link()->isVisible());
    QVERIFY(f.window->commands().action(QStringLiteral("view.link"))->isChecked());
    QCOMPARE(valueOf(*f.window->link()->panel(), "Robot"), QStringLiteral("127.0.0.2:3490"));
    QTest::mouseClick(parts, Qt::LeftButton, {}, linkPlace(*f.window).center());
    QVERIFY(f.window->link()->isVisible());  // who asks to see it again does not close it
    QTest::keyClick(f.window.get(), Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!f.window->link()->isVisible());
    f.window->commands().action(QStringLiteral("view.link"))->trigger();
    QTest::mouseClick(f.window->link()->findChild<QToolButton*>(QStringLiteral("link_close")), Qt::LeftButton);
    QVERIFY(!f.window->link()->isVisible());
    QVERIFY(!f.window->commands().action(QStringLiteral("view.link"))->isChecked());
    // The other parts open nothing.
    QTest::mouseClick(parts, Qt::LeftButton, {}, parts->place(QStringLiteral("Robot")).center());
    QVERIFY(!f.window->link()->isVisible());
  }

  void aLongFigureBorrowsRoomAndGivesNoneBack() {
    widgets::PartList parts;
    const QString all = QStringLiteral("a long word about this part, read to its very end");
    const int needed = QFontMetrics(widgets::textFont(widgets::TextSize::small)).horizontalAdvance(all);
    parts.resize(3 * needed, 24);  // a third each would just not do, with sign and name
    std::vector<widgets::PartView> views = {{.name = QStringLiteral("First"), .figures = QStringLiteral("1 Hz")},
                                            {.name = QStringLiteral("Second"), .figures = all},
                                            {.name = QStringLiteral("Third"), .figures = QStringLiteral("1 Hz")}};
    parts.setParts(views);
    const QRect wide = parts.place(QStringLiteral("Second"));
    QVERIFY(wide.width() > needed);
    QVERIFY(parts.place(QStringLiteral("Third")).right() <= parts.width());
    QVERIFY(parts.place(QStringLiteral("First")).right() < wide.left());
    views[1].figures = QStringLiteral("1 Hz");
    parts.setParts(views);
    QCOMPARE(parts.place(QStringLiteral("Second")), wide);
    // Too little for all: the short ones keep what they need, and the long one has the rest.
    const int first = parts.place(QStringLiteral("First")).width();
    parts.resize(needed + 100, 24);
    QVERIFY(parts.place(QStringLiteral("Third")).right() <= parts.width());
    QVERIFY2(parts.place(QStringLiteral("Second")).width() > parts.place(QStringLiteral("First")).width(),
             qPrintable(QString::number(parts.place(QStringLiteral("Second")).width())));
    QVERIFY(parts.place(QStringLiteral("First")).width() <= first);
    parts.resize(100, 24);  // too little for any: alike
    QCOMPARE(parts.place(QStringLiteral("First")).width(), parts.place(QStringLiteral("Third")).width());
  }

  void inANarrowBarAWordIsReadToItsEndAndFiguresAreLeftToTheToolTip() {
    widgets::PartList parts;
    const widgets::PartView pad{.name = QStringLiteral("Touchpad"),
                                .figures = QStringLiteral("1000 Hz · 12 ms"),
                                .health = widgets::PartView::Health::well};
    const widgets::PartView link{.name = QStringLiteral("Liaison"),
                                 .figures = QStringLiteral("classique, non sécurisé"),
                                 .health = widgets::PartView::Health::well};
    parts.setParts({pad, link});
    parts.resize(2000, 24);
    QCOMPARE(parts.shownFigures(pad), pad.figures);
    const QFontMetrics small(widgets::textFont(widgets::TextSize::small));
    const int both = parts.place(pad.name).width() + parts.place(link.name).width();
    int whole = 2000;  // the least width that shows all
    while (parts.shownFigures(pad) == pad.figures) parts.resize(--whole, 24);
    QVERIFY(whole < both);
    QCOMPARE(parts.shownFigures(pad), QStringLiteral("1000 Hz"));
    QVERIFY(parts.place(link.name).width() > small.horizontalAdvance(link.figures));
    QVERIFY(parts.place(link.name).right() <= parts.width());
    QVERIFY(parts.accessibleDescription().contains(pad.figures));
    widgets::PartView silent = pad;
    silent.health = widgets::PartView::Health::missing;
    QCOMPARE(parts.shownFigures(silent), pad.figures);  // what is wrong is said in full
  }

  void withThePanelOpenTheWindowStillFitsItsUsualSize() {
    Fixture f;
    f.window->commands().action(QStringLiteral("view.link"))->trigger();
    QVERIFY2(f.window->minimumSizeHint().width() <= 1280,
             qPrintable(QString::number(f.window->minimumSizeHint().width())));
    QVERIFY2(f.window->minimumSizeHint().height() <= 640,
             qPrintable(QString::number(f.window->minimumSizeHint().height())));
    for (QAbstractButton* button : f.window->link()->findChildren<QAbstractButton*>()) {
      QVERIFY2(!button->text().isEmpty() || !button->accessibleName().isEmpty(), qPrintable(button->objectName()));
    }
  }

  void theRobotIsChangedOnlyWhileNothingCanMove() {
    Fixture f;
    f.window->commands().action(QStringLiteral("view.link"))->trigger();
    widgets::RobotForm* form = f.window->link()->form();
    QPushButton* button = form->reconnectButton();
    QVERIFY(!button->isEnabled());  // no state known yet
    for (const auto& [state, allowed] : {std::pair{SafetyState::ready, true},
                                         {SafetyState::active, false},
                                         {SafetyState::stopped, true},
                                         {SafetyState::held, false},
                                         {SafetyState::connected, true},
                                         {SafetyState::disconnected, true}}) {
      f.session->say(state);
      f.window->feed().pump();
      QCOMPARE(button->isEnabled(), allowed);
    }
    // Armed since the button was painted: the click looks at the newest state.
    f.session->say(SafetyState::active);
    QVERIFY(button->isEnabled());
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(f.session->asked.empty());
    QVERIFY(!button->isEnabled());
    QVERIFY(form->hint().contains(QStringLiteral("Esc")));
  }

  void whatIsChosenIsAskedForInTheStationsWords() {
    Fixture f;
    f.window->commands().action(QStringLiteral("view.link"))->trigger();
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    widgets::RobotForm* form = f.window->link()->form();
    QCOMPARE(form->robot(), QStringLiteral("simulated"));
    const auto choose = [&](int steps_down) {
      form->kind()->setFocus();
      QTest::keyClick(form->kind(), Qt::Key_Home);
      for (int i = 0; i < steps_down; ++i) QTest::keyClick(form->kind(), Qt::Key_Down);
    };
    const auto press = [&] {
      f.session->say(SafetyState::ready);
      f.window->feed().pump();
      QTest::mouseClick(form->reconnectButton(), Qt::LeftButton);
    };
    choose(1);
    QVERIFY(!form->address()->isVisible());
    press();
    WAIT_EQUAL(f.session->present.robot, std::string("none"));
    QVERIFY(f.window->operate()->tuning()->byHandButton()->isChecked());

    choose(2);
    QVERIFY(form->address()->isVisible() && !form->key()->isVisible());
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    QVERIFY(!form->reconnectButton()->isEnabled());  // no address yet
    form->address()->setFocus();
    QTest::keyClicks(form->address(), QStringLiteral("127.0.0.1:3490"));
    QVERIFY(form->reconnectButton()->isEnabled());
    press();
    WAIT_EQUAL(f.session->present.robot, std::string("classic:127.0.0.1:3490"));
    QVERIFY(f.session->asked.back().key_file.empty());
    QVERIFY(!f.window->operate()->tuning()->byHandButton()->isChecked());

    choose(3);
    f.session->say(SafetyState::ready);
    f.window->feed().pump();
    QVERIFY(!form->reconnectButton()->isEnabled());  // no key yet
    form->key()->setFocus();
    QTest::keyClicks(form->key(), QStringLiteral("robot.key"));
    press();
    WAIT_EQUAL(f.session->present.robot, std::string("link:127.0.0.1:3490"));
    QCOMPARE(f.session->asked.back().key_file, std::string("robot.key"));

    choose(2);  // a key that was entered is not handed to a protocol that takes none
    press();
    WAIT_EQUAL(f.session->present.robot, std::string("classic:127.0.0.1:3490"));
    QVERIFY(f.session->asked.back().key_file.empty());
    QCOMPARE(f.session->asked.size(), std::size_t{4});
  }

  void aRefusalIsANoticeAndAClosedSessionCanBeTriedAgain() {
    Fixture f;
    f.window->commands().action(QStringLiteral("view.link"))->trigger();
    f.session->say(SafetyState::stopped);
    f.window->feed().pump();
    f.session->refuses = true;
    QPushButton* button = f.window->link()->form()->reconnectButton();
    QTest::mouseClick(button, Qt::LeftButton);
    const auto told = [&] {
      int count = 0;
      for (int i = 0; i < f.window->notices()->count(); ++i) {
        count += f.window->notices()->text(i).contains(QStringLiteral("refused by the script")) ? 1 : 0;
      }
      return count > 0;
    };
    WAIT_FOR(told());
    f.session->say(SafetyState::stopped);
    f.window->feed().pump();
    f.session->open = false;
    QTest::mouseClick(button, Qt::LeftButton);
    WAIT_EQUAL(f.session->asked.size(), std::size_t{2});
    // A closed session has nothing that can move, whatever the feed has last heard.
    WAIT_FOR(f.window->connection().work().isEmpty() && button->isEnabled());
    f.session->refuses = false;
    QTest::mouseClick(button, Qt::LeftButton);
    WAIT_FOR(f.session->open && f.window->connection().work().isEmpty());
    QCOMPARE(f.session->asked.size(), std::size_t{3});
    QVERIFY(!f.window->connection().hindrance().isEmpty());  // until the new session says how it is
  }

  void aRealSessionChangesItsRobotKeepsItsProfileAndComesBackFromAFailure() {
    QTemporaryDir folder;
    const std::string key_file = folder.filePath(QStringLiteral("link.key")).toStdString();
    QVERIFY(protocol::writeKeyFile(protocol::LinkKey::generate(), key_file).has_value());
    station::StationOptions options;
    options.robot = "none";
    auto opened = console::openSession(options);
    QVERIFY(opened.has_value());
    console::Session& session = **opened;
    session.start();
    for (const station::ReadinessLine& line : session.readiness()) QVERIFY(line.what != say("Robot connected"));
    QVERIFY(session.setParameter("texture.k_vib", 1.75).has_value());

    const auto become = [&](const console::ConnectionWords& words) { return session.leaveFor(words)()(); };
    QVERIFY(become({.robot = "classic:127.0.0.1:0"}).has_value());
    const station::LinkStatus classic = session.status().link;
    QVERIFY(!classic.secured && classic.protocol.text().starts_with("classic"));
    QCOMPARE(session.currentProfile().step.texture.k_vib, 1.75);

    // Wrong words, and a port somebody else has: both times the former robot is there afterwards.
    const auto problems = session.checkOf({.robot = "classic:nonsense"})();
    QCOMPARE(problems.size(), std::size_t{1});
    QVERIFY(problems[0].part == device::Part::robot);
    QCOMPARE(session.status().link.local, classic.local);
    auto taken = protocol::UdpSocket::open(*protocol::parseEndpoint("127.0.0.1:0"));
    QVERIFY(taken.has_value());
    const std::string address = protocol::toString(taken->local());
    const auto refused = become({.robot = "link:" + address, .key_file = key_file});
    QVERIFY(!refused.has_value());
    QVERIFY(session.isOpen());
    QCOMPARE(session.connection().robot, std::string("classic:127.0.0.1:0"));
    QVERIFY(!session.status().link.local.empty());

    QVERIFY(become({.robot = "link:127.0.0.1:0", .key_file = key_file}).has_value());
    QVERIFY(session.status().link.secured);
    std::vector<pipeline::TelemetrySample> samples(64);
    std::size_t heard = 0;
    WAIT_FOR((heard += session.takeTelemetry(samples)) > 0);  // its loop runs
    QCOMPARE(session.currentProfile().step.texture.k_vib, 1.75);
    session.shutDown();
  }
};

std::unique_ptr<QObject> makeLinkTest() { return std::make_unique<LinkTest>(); }

}  // namespace fyd::tests

#include "link_test.moc"
