// Parts for which motors move, by a button that is really held; what teaches where nothing is measured yet; the report;
// ages in the readiness list; and the whole of it on the simulated touchpad.
#include <fstream>

#include "app/console/calibrate/calibrate_records.h"
#include "app/console/shell/calibration_ages.h"
#include "core/station/profile/calibration_file.h"
#include "tests/widgets/calibrating.h"
#include "tests/widgets/simulated_touchpad.h"
#include "tests/widgets/suite.h"
#include "widgets/basics/number_text.h"

namespace fyd::tests {

namespace {

struct Moving : Calibrating {
  using Calibrating::Calibrating;
  void hold() {
    (void)holdUntil([this] { return page->moveButton()->engaged(); });
  }
  /// @return whether it came
  template <class Come>
  [[nodiscard]] bool holdUntil(Come&& come) {
    state(SafetyState::stopped);  // accepting may have looked half a second after the last word: silent, and no button
    QTest::mousePress(page->moveButton(), Qt::LeftButton);
    const auto looks = [&] {
      state(SafetyState::stopped);  // a station that says nothing is silent
      return come();
    };
    return QTest::qWaitFor(looks, kPatience_ms);
  }
  void letGo() { QTest::mouseRelease(page->moveButton(), Qt::LeftButton); }
  /// The motors stand there, and a finger presses that deep.
  void press(double stretch_deg, double indentation_mm, double force_N) {
    session->test_status.resting = true;
    session->test_status.commanded_deg = {stretch_deg, -stretch_deg};
    pipeline::TelemetrySample sample;
    sample.now = instantAt(++session->seconds * 0.001);
    sample.state = SafetyState::stopped;
    sample.contact = true;
    sample.stretch_measured_deg = stretch_deg;
    sample.indentation_mm = indentation_mm;
    sample.force_N = force_N;
    session->telemetry.push_back(sample);
    window->feed().pump();
    readings(8);
  }
  [[nodiscard]] QString offered() const { return page->entries()->field(0)->text(); }
};

double stiffnessAt(double stretch_deg) { return 0.4 + 0.004 * stretch_deg; }

/// Encoders as a touchpad with these zeros and signs reports them.
device::DeviceReport encoders(double stretch_deg) {
  device::DeviceReport out = touchpad(0.1);
  const auto counts = [](double deg, double zero) {
    return std::fmod(std::round(zero + deg * control::kEncoderCountsPerDegree) + 4096.0, 4096.0);
  };
  out.values.push_back(
      {.name = say("encoder {}", std::size_t{1}), .number = counts(stretch_deg, 4000.0), .unit = "counts"});
  out.values.push_back(
      {.name = say("encoder {}", std::size_t{2}), .number = counts(stretch_deg, 700.0), .unit = "counts"});
  return out;
}

}  // namespace

class CalibrateMotionTest : public QObject {
  Q_OBJECT
 private slots:
  void whyTheMotorsMayNotBeMovedIsSaid() {
    Moving c("encoders");
    auto* why = c.page->findChild<QLabel*>(QStringLiteral("calibrate_why_still"));
    QVERIFY(c.page->moveButton()->isEnabled());
    QVERIFY(!why->isVisible());
    c.state(SafetyState::active);
    QVERIFY(!c.page->moveButton()->isEnabled());
    QVERIFY(why->isVisible());
    c.page->choose(QStringLiteral("load-cell"));  // nothing moves for it
    QVERIFY(!why->isVisible());
  }

  void theStiffnessMapWhileTheButtonIsHeld() {
    Moving c("stiffness");
    QVERIFY(!c.page->takeButton()->isVisible());
    QVERIFY(c.page->moveButton()->isVisible());
    QCOMPARE(c.offered(), QStringLiteral("20"));
    QVERIFY(c.page->fitPanel()->plot()->empty());
    std::vector<double> asked;
    for (int stretch = 0; stretch < 3; ++stretch) {
      const double deg = c.offered().toDouble();
      asked.push_back(deg);
      c.hold();
      QCOMPARE(c.session->tests.back(), device::DeviceTest::stretch);
      QCOMPARE(c.session->stretches.back(), deg);
      const int keeps = c.session->keeps;
      WAIT_FOR(c.session->keeps > keeps);
      c.press(deg, 0.1, 0.0);
      QVERIFY2(c.page->hint().startsWith(QLatin1String("Press the cloth now")), qPrintable(c.page->hint()));
      for (const double depth_mm : {2.0, 4.0, 6.0}) c.press(deg, depth_mm, stiffnessAt(deg) * depth_mm + 0.05);
      c.press(deg, 6.1, stiffnessAt(deg) * 6.1);
      QVERIFY2(c.page->hint().startsWith(QLatin1String("This depth is taken")), qPrintable(c.page->hint()));
      const int stops = c.session->test_stops;
      c.letGo();
      QVERIFY(c.session->test_stops > stops);
      QCOMPARE(c.page->points().size(), 3 * (static_cast<std::size_t>(stretch) + 1));
      QVERIFY(c.page->acceptButton()->isEnabled() == (stretch == 2));
    }
    QCOMPARE(asked, (std::vector<double>{20.0, 90.0, 55.0}));
    const widgets::FitView& plot = c.page->fitPanel()->plot()->fit();
    QCOMPARE(plot.bars.size(), std::size_t{3});
    QVERIFY(!plot.curve.empty() && !plot.former_curve.empty());
    QVERIFY2(c.page->fitPanel()->figures().contains(QLatin1String("of at most 0.3 N")),
             qPrintable(c.page->fitPanel()->figures()));
    QVERIFY(c.page->fitPanel()->figures().contains(QLatin1String("valid from 20.0 to 90.0 deg")));
    c.click(c.page->acceptButton());
    const auto profile = c.saved();
    QVERIFY(profile.has_value());
    const control::ControlParameters& control = profile->step.control;
    QCOMPARE(control.law_angle_deg.size(), std::size_t{3});
    QVERIFY(std::abs(control.law_stiffness_N_per_mm[1] - stiffnessAt(55.0)) < 1e-6);
    QCOMPARE(station::loadCalibrationRecords(c.profilePath())->front().conditions, std::string("simulated points"));
  }

  void motorsMoveOnlyWhileTheyMayAndWhileTheButtonIsHeld() {
    Moving c("stiffness");
    for (const SafetyState busy : {SafetyState::active, SafetyState::held, SafetyState::disconnected}) {
      c.state(busy);
      QVERIFY(!c.page->moveButton()->isEnabled());
    }
    c.state(SafetyState::ready);
    QVERIFY(c.page->moveButton()->isEnabled());
    // A problem stays until the next one: each is waited for in its own words.
    for (const auto& [bad, told] : {std::pair{"", "type a number"}, std::pair{"nan", "\"nan\" is no number"},
                                    std::pair{"1e308", "1e308"}, std::pair{"200", "200 is out of range"}}) {
      c.type(0, QLatin1String(bad));
      const auto problem = [&c] { return c.page->entries()->problem(); };
      QVERIFY2(!problem().contains(QLatin1String(told)), qPrintable(problem()));
      QVERIFY2(c.holdUntil([&, told = told] { return problem().contains(QLatin1String(told)); }),
               qPrintable(problem()));
      QVERIFY2(c.session->tests.empty(), bad);
      c.letGo();
    }
    c.click(c.page->moveButton());  // a click is no hold
    QTest::keyClick(c.page, Qt::Key_Return, Qt::ControlModifier);
    QVERIFY(c.session->tests.empty());
    c.type(0, QStringLiteral("30"));
    c.hold();
    QCOMPARE(c.session->tests.size(), std::size_t{1});
    c.state(SafetyState::active);  // the button is disabled under the finger
    QVERIFY(!c.session->test_status.running);
    c.letGo();
    c.state(SafetyState::stopped);
    c.hold();
    QCOMPARE(c.session->tests.size(), std::size_t{2});
    c.page->choose(QStringLiteral("load-cell"));  // another part
    QVERIFY(!c.session->test_status.running);
    c.letGo();
    c.page->choose(QStringLiteral("stiffness"));
    c.session->refuses = true;
    c.type(0, QStringLiteral("30"));
    const auto hint_tells = [&c] { return c.page->hint().contains(QLatin1String("refused by the script")); };
    QVERIFY(!hint_tells());
    QVERIFY2(c.holdUntil(hint_tells), qPrintable(c.page->hint()));
    c.letGo();
  }

  void theEncodersAlongASweep() {
    Moving c("encoders");
    c.session->reports = {encoders(0.0)};
    c.hold();
    QCOMPARE(c.session->tests.back(), device::DeviceTest::sweep);
    // The motors jump to their zero from wherever they stood, later than they are sent there.
    c.session->test_status.resting = true;
    c.session->test_status.commanded_deg = {0.0, 0.0};
    for (const double deg : {13.0, 9.0, 3.0, 0.0}) {
      c.session->reports = {encoders(deg)};
      c.readings(1);
      QVERIFY(c.page->points().empty());
    }
    for (const double deg : {0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 25.0, 20.0, 15.0, 10.0, 5.0, 0.0}) {
      c.session->test_status.resting = false;
      c.readings(2);
      c.session->reports = {encoders(deg)};
      c.session->test_status.resting = true;
      c.session->test_status.commanded_deg = {deg, -deg};
      c.readings(3);
    }
    QCOMPARE(c.page->points().size(), std::size_t{13});
    QCOMPARE(c.page->points()[0][1], 4000.0);
    QCOMPARE(c.page->points()[6][1], 245.0);  // the encoder has counted from 0 again
    c.session->test_status = {
        .running = false, .test = device::DeviceTest::sweep, .finished = true, .words = say("finished")};
    c.readings(1);
    QVERIFY2(c.page->hint().contains(QLatin1String("finished")), qPrintable(c.page->hint()));
    c.letGo();
    QVERIFY2(c.page->acceptButton()->isEnabled(), qPrintable(c.page->fitPanel()->verdict()));
    QVERIFY(c.page->fitPanel()->figures().contains(QLatin1String("encoder 2: counts against its motor")));
    c.click(c.page->acceptButton());
    const auto profile = c.saved();
    QVERIFY(profile.has_value());
    QVERIFY(std::abs(profile->step.control.encoder_zero_first_counts - 4000) <= 1);
    QVERIFY(std::abs(profile->step.control.encoder_zero_second_counts - 700) <= 1);
    QVERIFY(!profile->step.control.encoder_first_inverted && profile->step.control.encoder_second_inverted);
    // One that is let go leaves no points, however many it had.
    c.session->test_status = {.running = true, .test = device::DeviceTest::sweep};
    c.hold();
    for (const double deg : {0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0}) {
      c.session->test_status.resting = false;
      c.readings(2);
      c.session->reports = {encoders(deg)};
      c.session->test_status.resting = true;
      c.session->test_status.commanded_deg = {deg, -deg};
      c.readings(3);
    }
    QCOMPARE(c.page->points().size(), std::size_t{7});
    QVERIFY(c.page->acceptButton()->isEnabled());
    c.letGo();
    QVERIFY2(c.page->hint().contains(QLatin1String("not finished")), qPrintable(c.page->hint()));
    QVERIFY(!c.page->acceptButton()->isEnabled());
    QVERIFY(c.page->unfinished().isEmpty());
  }

  void theAccelerometerAtRestIsNotedAndChangesNothing() {
    Calibrating c("rest");
    c.click(c.page->takeButton());
    QVERIFY2(c.page->hint().contains(QLatin1String("sends no acceleration")), qPrintable(c.page->hint()));
    const auto measure = [&](double tremble_g) {
      for (int i = 0; i < 152; ++i) {
        if (i == 1) c.click(c.page->takeButton());
        pipeline::TelemetrySample sample;
        sample.now = instantAt(++c.session->seconds * 0.001);
        sample.state = SafetyState::stopped;
        sample.acceleration_x_g = tremble_g * (i % 2);
        sample.acceleration_y_g = 0.001 * (i % 3);
        sample.acceleration_z_g = 1.0;
        c.session->telemetry.push_back(sample);
        c.window->feed().pump();
        c.page->poll();
      }
    };
    measure(0.5);
    QVERIFY2(c.page->hint().contains(QLatin1String("x moves by")), qPrintable(c.page->hint()));
    measure(0.0);
    QVERIFY2(c.page->acceptButton()->isEnabled(), qPrintable(c.page->fitPanel()->verdict()));
    QVERIFY(c.page->trace()->shown() > 0);
    c.click(c.page->acceptButton());
    QCOMPARE(c.session->begun_anew, 0);
    const auto records = station::loadCalibrationRecords(c.profilePath());
    QCOMPARE(records->size(), std::size_t{1});
    QVERIFY(records->front().changes.empty());
    QVERIFY(c.partText("Accelerometer").contains(QLatin1String("calibrated today")));
  }

  void emptyPlacesTeachAndTheLiveCurveMarksThePoints() {
    Calibrating c("load-cell");
    const widgets::FitPlot* plot = c.page->fitPanel()->plot();
    QVERIFY(plot->empty());
    QVERIFY2(plot->fit().empty_text.contains(QLatin1String("different weights")), qPrintable(plot->fit().empty_text));
    c.readings(5);
    QVERIFY(c.page->trace()->shown() >= 5);
    QCOMPARE(c.page->trace()->marked(), 0);
    c.take(QStringLiteral("1"));
    QCOMPARE(c.page->trace()->marked(), 1);
    QVERIFY(!plot->empty());
    c.page->choose(QStringLiteral("ir-1"));
    QVERIFY(plot->empty());
    QCOMPARE(c.page->trace()->marked(), 0);
    c.page->choose(QStringLiteral("camera"));
    QVERIFY(!c.page->trace()->isVisible());
  }

  void noFieldTakesWhatIsNoNumberAndRepeatedPointsAreNotEnough() {
    Calibrating c("load-cell");
    for (const char* part : {"load-cell", "ir-1"}) {
      c.page->choose(QLatin1String(part));
      for (const char* bad : {"", " ", "nan", "inf", "-inf", "1e308", "-1e308", "1,2,3", "0x10", "ten", "--1"}) {
        c.take(QLatin1String(bad), 12);
        QVERIFY2(c.page->points().empty(), bad);
        QVERIFY2(!c.page->entries()->problem().isEmpty(), bad);
      }
      for (int i = 0; i < 4; ++i) c.take(QStringLiteral("50,0"));  // a comma, and always the same
      QCOMPARE(c.page->points().size(), std::size_t{4});
      QVERIFY2(c.page->fitPanel()->verdict().startsWith(QLatin1String("Not yet: 1 different")),
               qPrintable(c.page->fitPanel()->verdict()));
      QVERIFY(c.page->missing().contains(QLatin1String("add")));
      QVERIFY(!c.page->acceptButton()->isEnabled());
    }
  }

  void theReportStandsBesideTheProfile() {
    Calibrating c("load-cell");
    c.click(c.page->reportButton());
    QVERIFY2(c.page->hint().contains(QLatin1String("never calibrated")), qPrintable(c.page->hint()));
    for (int i = 0; i < 2; ++i) {
      c.click(c.page->simulateButton());
      QVERIFY(c.page->fitPanel()->figures().contains(QLatin1String("hysteresis")));
      QVERIFY(c.page->fitPanel()->figures().contains(QLatin1String("drift")));
      const QTableWidget* fitted = c.page->fitPanel()->coefficients();
      const QString shown = fitted->item(0, 2)->text();
      c.click(c.page->acceptButton());
      // As the record keeps it.
      const calibration::Coefficient kept = station::loadCalibrationRecords(c.profilePath())->back().coefficients.at(0);
      QVERIFY(kept.standard_error > 0.0);
      QCOMPARE(shown, QStringLiteral("± ") + widgets::quantityText(kept.standard_error,
                                                                   widgets::decimalsOfUncertainty(kept.standard_error),
                                                                   QStringLiteral("N/(mV/V)")));
    }
    c.click(c.page->reportButton());
    const QStringList made = QDir(c.folder.path()).entryList({QStringLiteral("profile.load-cell.*.pdf")});
    QCOMPARE(made.size(), 1);
    QFile file(c.folder.filePath(made.front()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().startsWith("%PDF"));
  }

  void oldCalibrationsAreSaidBeforeArming() {
    calibration::CalibrationRecord record;
    record.procedure = "load-cell";
    record.when = "2026-01-01T08:00:00Z";
    const station::Profile profile;
    QVERIFY(console::ageingRows({record}, profile, "2026-01-20").empty());
    const auto ageing = console::ageingRows({record}, profile, "2026-06-01");
    QCOMPARE(ageing.size(), std::size_t{1});
    QVERIFY(ageing.front().ok && ageing.front().what.contains(QLatin1String("Load cell: ageing")));
    const auto old = console::ageingRows({record}, profile, "2028-01-01");
    QVERIFY(!old.front().ok && old.front().remedy.contains(QLatin1String("again")));
    // A record on the disk is seen by the place where one arms.
    Fixture f;
    record.when = "2020-01-01T08:00:00Z";
    record.touchpad = station::kSimulatedTouchpad;
    record.simulated = true;
    std::ofstream(station::calibrationFileOf(f.folder.filePath(QStringLiteral("profile.toml")).toStdString()))
        << calibration::formatRecords(std::vector{record});
    f.window->feed().pump();
    QCOMPARE(f.window->operate()->readiness()->title(), QStringLiteral("Ready? 1/2"));
  }

  void everythingOnTheSimulatedTouchpad() {
    auto opened = console::openSession({});
    QVERIFY2(opened.has_value(), opened ? "" : opened.error().text().c_str());
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("profile.toml"));
    console::Session* session = opened->get();
    console::MainWindow window(std::move(*opened), path);
    window.show();
    (void)QTest::qWaitForWindowActive(&window, kPatience_ms);
    window.start();
    QTest::keyClick(&window, Qt::Key_2, Qt::ControlModifier);
    auto* page = qobject_cast<console::CalibratePage*>(window.frame()->page(QStringLiteral("calibrate")));
    page->fitPanel()->who()->setText(QStringLiteral("A. Tester"));
    std::size_t accepted = 0;
    for (const auto& step : console::makeCalibrationSteps(session->currentProfile())) {
      // Without points of its own a part is run on the simulation, in other tests; but the cloth wants offsets that
      // belong to the new curves.
      if (step->simulatedPoints(session->currentProfile()).empty() && step->id() != QLatin1String("no-touch")) continue;
      page->choose(step->id());
      takeSimulated(page);
      hearTheStation(window);
      if (QTest::currentTestFailed()) return;
      QTest::mouseClick(page->acceptButton(), Qt::LeftButton);
      QVERIFY2(page->hint().startsWith(QLatin1String("Accepted")), qPrintable(step->id() + page->hint()));
      QCOMPARE(station::loadCalibrationRecords(path.toStdString())->size(), ++accepted);
    }
    QVERIFY(accepted >= 9);
    // And one stretch for real.
    page->choose(QStringLiteral("stiffness"));
    measureOneStretch(page);
    if (QTest::currentTestFailed()) return;
    WAIT_FOR(!session->deviceTestStatus().running);
    const console::CalibrationPoint& point = page->points().front();
    QVERIFY2(std::abs(point[0] - 20.0) < 2.0 && point[1] > 1.0 && point[2] > 0.2,
             qPrintable(QStringLiteral("%1 %2 %3").arg(point[0]).arg(point[1]).arg(point[2])));
    window.close();
  }
};

std::unique_ptr<QObject> makeCalibrateMotionTest() { return std::make_unique<CalibrateMotionTest>(); }

}  // namespace fyd::tests

#include "calibrate_motion_test.moc"
