// The place "Calibrate" by clicks and keys: points with known weights and distances, entries that are none, signals
// that move, what is missing, what "Accept" writes and what "Discard" leaves alone.
#include <fstream>

#include "app/console/shell/calibration_ages.h"
#include "core/base/parameter.h"
#include "core/calibration/calibration_part.h"
#include "core/sim/cloth/cloth.h"
#include "core/sim/touchpad/ir_sensor.h"
#include "core/sim/touchpad/picture.h"
#include "core/station/profile/calibration_file.h"
#include "tests/sweep.h"
#include "tests/widgets/calibrating.h"
#include "tests/widgets/hands.h"
#include "tests/widgets/suite.h"

namespace fyd::tests {

/// The touchpad and the camera while a sphere presses the simulated cloth over a sensor, or beside it: a cloth that was
/// solved without the estimator's formula.
static void pressCloth(Calibrating& c, int sensor, double depth_mm, double beside_mm = 0.0) {
  const sim::SimParameters simulated{.cloth = sim::ClothKind::membrane};
  sim::Cloth cloth(simulated);
  const sim::SensorPlace over = sim::kIrPlaces[static_cast<std::size_t>(sensor)];
  const sim::FingerState finger{
      .x_mm = over.x_mm + beside_mm, .y_mm = over.y_mm, .indentation_mm = depth_mm, .lifted = false};
  const sim::Pressing press = cloth.press(20.0, finger, 0.0);
  c.session->reports = {touchpad(0.1)};
  for (std::size_t i = 0; i < sim::kIrPlaces.size(); ++i) {
    const double sunk_mm = cloth.deflection_mm(sim::kIrPlaces[i].x_mm, sim::kIrPlaces[i].y_mm, finger);
    c.session->reports[0].values[i].number = sim::irVolts(100.0 - sunk_mm) * 4096 / 3.3;
  }
  const sim::Spot seen = sim::seenFromBelow(
      {finger.x_mm + press.centre_x_mm, finger.y_mm + press.centre_y_mm, press.area_mm2}, depth_mm, 100.0);
  c.session->view.finger = {.contact = true,
                            .area_mm2 = seen.area_mm2,
                            .x_mm = seen.x_mm,
                            .y_mm = seen.y_mm,
                            .reason = sensing::FingerReason::found};
}

class CalibrateTest : public QObject {
  Q_OBJECT
 private slots:
  void aLoadCellFromKnownWeightsToTheFiles() {
    Calibrating c("load-cell", "serial:A7");
    QCOMPARE(c.window->frame()->place(), QStringLiteral("calibrate"));
    QVERIFY(c.partText("Load cell").contains(QLatin1String("never calibrated")));
    QVERIFY(!c.page->acceptButton()->isEnabled());
    QComboBox* unit = c.page->entries()->unit(0);
    c.page->parts()->setFocus();
    QTest::keyClick(c.page->parts(), Qt::Key_Tab);
    QVERIFY(c.page->entries()->field(0)->hasFocus());
    QTest::keyClick(c.page->entries()->field(0), Qt::Key_Tab);
    QVERIFY(unit->hasFocus());
    QTest::keyClick(unit, Qt::Key_Down);
    QCOMPARE(unit->currentText(), QStringLiteral("g"));
    c.take(QStringLiteral("0"));
    c.session->reports = {touchpad(bridgeOf(200.0))};
    c.take(QStringLiteral("200"));
    QCOMPARE(c.page->points().size(), std::size_t{2});
    QVERIFY2(c.page->fitPanel()->verdict().startsWith(QLatin1String("Not yet: 2 different weights")),
             qPrintable(c.page->fitPanel()->verdict()));
    QVERIFY(c.page->missing().contains(QLatin1String("add weights between")));
    QVERIFY(!c.page->acceptButton()->isEnabled());
    QTest::keyClick(unit, Qt::Key_Up);  // the same cell in newtons
    for (const double force_N : {4.0, 6.0}) {
      c.session->reports = {touchpad(bridgeOf(force_N * 1000.0 / kStandardGravity))};
      c.take(QString::number(force_N));
    }
    QCOMPARE(c.page->points().size(), std::size_t{4});
    QVERIFY(std::abs(c.page->points()[1][1] - 0.2 * kStandardGravity) < 1e-9);
    QVERIFY2(c.page->fitPanel()->verdict().startsWith(QLatin1String("Good")),
             qPrintable(c.page->fitPanel()->verdict()));
    QCOMPARE(c.page->fitPanel()->plot()->fit().points.size(), std::size_t{4});
    QCOMPARE(c.page->fitPanel()->plot()->fit().residuals.size(), std::size_t{4});
    QVERIFY(!c.page->fitPanel()->plot()->fit().former_curve.empty());
    QVERIFY(c.page->fitPanel()->figures().contains(QLatin1String("of at most 0.1 N")));
    // The same figure in the verdict and beside it.
    const QString held_out = c.page->fitPanel()->figures().section(QStringLiteral(" of at most"), 0, 0).toLower();
    QVERIFY2(held_out.startsWith(QStringLiteral("held-out error 0")) &&
                 c.page->fitPanel()->verdict().contains(held_out.chopped(2) + QStringLiteral(" N of at most 0.1 N")),
             qPrintable(held_out + QStringLiteral(" | ") + c.page->fitPanel()->verdict()));
    QCOMPARE(c.page->fitPanel()->changes()->item(0, 0)->text(), QStringLiteral("force_slope_g, g/(mV/V)"));
    QCOMPARE(c.page->fitPanel()->changes()->item(0, 1)->text(), QStringLiteral("1004.9"));
    const QTableWidget* fitted = c.page->fitPanel()->coefficients();
    QCOMPARE(fitted->rowCount(), 2);
    QCOMPARE(fitted->item(0, 0)->text(), QStringLiteral("slope, N/(mV/V)"));
    c.page->choose(QStringLiteral("ir-1"));  // points of a part that is not shown are not forgotten at the exit
    QCOMPARE(c.page->unfinished(), QStringLiteral("calibration points not accepted: Load cell 4"));
    c.page->choose(QStringLiteral("load-cell"));
    QCOMPARE(c.page->fitPanel()->changes()->item(0, 2)->text().toDouble(), kSlope_g);
    QVERIFY(!QFileInfo::exists(QString::fromStdString(c.profilePath())));

    c.state(SafetyState::active);
    c.click(c.page->acceptButton());
    QVERIFY(c.page->hint().contains(QLatin1String("press Esc first")));
    QVERIFY(!QFileInfo::exists(QString::fromStdString(c.profilePath())));
    QCOMPARE(c.session->begun_anew, 0);

    c.state(SafetyState::stopped);
    c.page->fitPanel()->who()->clear();
    c.click(c.page->acceptButton());
    QVERIFY2(c.page->hint().contains(QLatin1String("Who measured?")), qPrintable(c.page->hint()));
    QVERIFY(c.page->fitPanel()->who()->hasFocus());
    QVERIFY(c.page->fitPanel()->offeredName()->isHidden());  // nobody calibrated here before
    QVERIFY(!QFileInfo::exists(QString::fromStdString(c.profilePath())));
    QTest::keyClicks(c.page->fitPanel()->who(), QStringLiteral("R. Lee"));
    QTest::keyClicks(c.page->fitPanel()->conditions(), QStringLiteral("21 C"));
    c.click(c.page->acceptButton());
    QVERIFY(c.page->parts()->hasFocus());  // the button may not be pressed any more, and nothing else is about to be
    const auto profile = c.saved();
    QVERIFY(profile.has_value());
    QVERIFY(std::abs(profile->step.sensing.load_cell.slope_g_per_mV_per_V - kSlope_g) < 1e-6);
    QVERIFY(std::abs(profile->step.sensing.load_cell.offset_g - kOffset_g) < 1e-6);
    const auto records = station::loadCalibrationRecords(c.profilePath());
    QVERIFY(records.has_value());
    QCOMPARE(records->size(), std::size_t{1});
    QCOMPARE(records->front().procedure, std::string("load-cell"));
    QCOMPARE(records->front().who, std::string("R. Lee"));
    QCOMPARE(records->front().conditions, std::string("21 C"));
    QCOMPARE(records->front().touchpad, std::string("serial:A7"));
    QVERIFY(!records->front().simulated);
    const QImage picture(c.folder.filePath(QString::fromStdString(records->front().picture)));
    QVERIFY2(!picture.isNull(), records->front().picture.c_str());
    QCOMPARE(records->front().samples.size(), std::size_t{2});
    QCOMPARE(records->front().samples[1].values.size(), std::size_t{4});
    QCOMPARE(records->front().coefficients.size(), std::size_t{2});
    QVERIFY(records->front().coefficients[0].standard_error >= 0.0);
    QCOMPARE(records->front().points, std::int64_t{4});
    QCOMPARE(c.session->begun_anew, 1);
    QVERIFY(std::abs(c.session->profile.step.sensing.load_cell.slope_g_per_mV_per_V - kSlope_g) < 1e-6);
    QCOMPARE(c.session->commands.size(), std::size_t{0});
    QVERIFY(c.page->points().empty());
    c.state(SafetyState::stopped);
    QCOMPARE(c.window->operate()->curves()->buffer().size(), std::size_t{1});  // the new session's time begins at 0
    c.page->fitPanel()->who()->clear();  // the next one's name is offered, not taken
    QVERIFY(!c.page->fitPanel()->offeredName()->isHidden());
    c.click(c.page->fitPanel()->offeredName());
    QCOMPARE(c.page->fitPanel()->who()->text(), QStringLiteral("R. Lee"));
    QVERIFY2(c.partText("Load cell").contains(QLatin1String("calibrated today")), qPrintable(c.partText("Load cell")));
    // "Save profile" must not bring the old values back.
    c.window->commands().action(QStringLiteral("session.save_profile"))->trigger();
    QVERIFY(std::abs(c.saved()->step.sensing.load_cell.slope_g_per_mV_per_V - kSlope_g) < 1e-6);
  }

  void entriesThatAreNoneAreSaidInWords() {
    Calibrating c("load-cell");
    const auto refused = [&](const QString& text, const char* expected) {
      c.take(text);
      const QString words = c.page->entries()->problem();
      QVERIFY2(words.contains(QLatin1String(expected)), qPrintable(text + QStringLiteral(": ") + words));
      QVERIFY(c.page->points().empty());
    };
    refused(QString(), "type a number first");
    refused(QStringLiteral("two"), "\"two\" is no number");
    refused(QStringLiteral("nan"), "is no number");
    refused(QStringLiteral("-1"), "out of range; expected 0 to 100 N");
    refused(QStringLiteral("1e300"), "out of range");
    QTest::keyClick(c.page->entries()->unit(0), Qt::Key_Down);
    refused(QStringLiteral("20000"), "expected 0 to 10197 g");
    c.take(QStringLiteral("1,5"));  // a comma is as good as a point
    QCOMPARE(c.page->points().size(), std::size_t{1});
    QVERIFY(c.page->entries()->problem().isEmpty());
    c.click(c.page->backButton());
    QVERIFY(c.page->points().empty());
    c.type(0, QStringLiteral("7"));
    QTest::keyClick(c.page->entries()->field(0), Qt::Key_Return);
    c.readings(10);
    QCOMPARE(c.page->points().size(), std::size_t{1});
  }

  void aSmallRangeIsSaidToAHundredth() {
    Calibrating c("ir-1");
    QTest::keyClick(c.page->entries()->unit(0), Qt::Key_Down);
    c.take(QStringLiteral("0.05"));
    const QString words = c.page->entries()->problem();
    QVERIFY2(words.contains(QLatin1String("expected 0.1 to 100 cm")), qPrintable(words));
  }

  void aSignalThatMovesOrIsSilentGivesNoPoint() {
    Calibrating c("load-cell");
    c.type(0, QStringLiteral("1"));
    c.click(c.page->takeButton());
    for (int i = 0; i < 10; ++i) {
      c.session->reports = {touchpad(0.1 + 0.02 * i)};
      c.page->poll();
    }
    QVERIFY(c.page->points().empty());
    QVERIFY2(c.page->hint().contains(QLatin1String("Bridge moves by")), qPrintable(c.page->hint()));
    c.session->reports[0].ok = false;
    c.session->reports[0].problem = verbatim("no answer");
    c.click(c.page->takeButton());
    QVERIFY2(c.page->hint().contains(QLatin1String("Touchpad does not answer: no answer")), qPrintable(c.page->hint()));
    // Motors that went off by themselves, while Held: the load cell does not mind.
    c.session->reports[0].problem = verbatim("motors off: mend that, then arm again");
    c.session->reports[0].measures = true;
    c.session->reports[0].age_ms = 900.0;
    c.click(c.page->takeButton());
    QVERIFY2(c.page->hint().contains(QLatin1String("900 ms old")), qPrintable(c.page->hint()));
    c.session->reports[0].age_ms = 5.0;
    c.take(QStringLiteral("1"));
    QCOMPARE(c.page->points().size(), std::size_t{1});
    c.click(c.page->backButton());
    c.type(0, QStringLiteral("1"));
    c.session->reports = {touchpad(0.1)};
    c.session->reports[0].age_ms = 2000.0;
    c.click(c.page->takeButton());
    QVERIFY(c.page->hint().contains(QLatin1String("2000 ms old")));
    c.session->reports.clear();
    c.readings(1);
    QVERIFY(c.page->live().contains(QLatin1String("no device tells 'load cell'")));
    QVERIFY(c.page->points().empty());
  }

  void aDistanceSensorFromTypedDistances() {
    Calibrating c("ir-2", "serial:A7");
    // A profile on the disk, and a tare since that is not saved.
    QVERIFY(station::saveProfile(c.session->profile, c.profilePath()).has_value());
    ParameterList& offsets = c.session->profile.step.sensing.indentation.ir_offset_mm;
    offsets[0] = offsets[1] = offsets[2] = 98.75;
    for (const double distance_mm : stepsTo(40.0, 300.0, 20.0)) {
      c.session->reports = {touchpad(0.1, sim::irCode(sim::irVolts(distance_mm)))};
      c.take(QString::number(distance_mm));
    }
    QVERIFY2(c.page->fitPanel()->verdict().startsWith(QLatin1String("Good")),
             qPrintable(c.page->fitPanel()->verdict()));
    // The file has been written by something else since the window read it: said once, then overwritten.
    c.click(c.page->acceptButton());
    QVERIFY(station::loadCalibrationRecords(c.profilePath())->empty());
    c.state(SafetyState::stopped);
    c.click(c.page->acceptButton());
    const auto profile = c.saved();
    QVERIFY(profile.has_value());
    const sensing::IndentationParameters& p = profile->step.sensing.indentation;
    QVERIFY(p.ir_curve_mm[0].size() == 0 && p.ir_curve_mm[2].size() == 0);
    const sensing::IrDistance sensor(p.ir_curve_mm[1].view(), static_cast<int>(p.ir_lowest_code[1]),
                                     static_cast<int>(p.ir_highest_code[1]), p.ir_curve_form[1]);
    for (const double distance_mm : {50.0, 110.0, 190.0}) {
      const auto read = sensor.read(sim::irCode(sim::irVolts(distance_mm)));
      QVERIFY(read.valid);
      QVERIFY2(std::abs(read.distance_mm - distance_mm) < 2.0, qPrintable(QString::number(read.distance_mm)));
    }
    const auto records = station::loadCalibrationRecords(c.profilePath());
    QCOMPARE(records->size(), std::size_t{1});
    QCOMPARE(records->front().sensor, 2);
    QVERIFY(c.partText("sensor 2").contains(QLatin1String("calibrated today")));
    // The offset was taken with the former curve, tared or not: said in amber, here and before arming, until a tare.
    const QString again = QStringLiteral("taken with another curve: take it again (Distance sensor 2)");
    QVERIFY2(c.partText("No-touch").contains(again), qPrintable(c.partText("No-touch")));
    for (int i = 0; i < c.page->parts()->count(); ++i) {
      const bool amber = c.page->parts()->item(i)->foreground().color() == widgets::theme().warning;
      QCOMPARE(amber, c.page->parts()->item(i)->text().contains(again));
    }
    QVERIFY(p.ir_offset_mm[0] == 100.0 && p.ir_offset_mm[1] == 98.75);
    QCOMPARE(station::outdatedParts(c.profilePath(), *profile)->size(), std::size_t{1});
    const auto before_arming = [&] {
      c.window->feed().pump();
      return c.window->operate()->readiness()->title();
    };
    WAIT_EQUAL(before_arming(), QStringLiteral("Ready? 1/2"));
    c.session->profile.step.sensing.indentation.ir_offset_mm[1] = 98.5;  // a tare
    WAIT_EQUAL(before_arming(), QStringLiteral("Ready? 1/1"));
    QVERIFY(c.partText("sensor 1").contains(QLatin1String("never calibrated")));
  }

  void pointsMeasuredOnTheSimulationAreCalledSoAndStayThere() {
    Calibrating c("load-cell");
    for (const double force_N : {0.0, 2.0, 4.0, 6.0}) {
      c.session->reports = {touchpad(bridgeOf(force_N * 1000.0 / kStandardGravity))};
      c.take(QString::number(force_N));
    }
    c.click(c.page->acceptButton());
    const auto records = station::loadCalibrationRecords(c.profilePath());
    QCOMPARE(records->size(), std::size_t{1});
    QCOMPARE(records->front().conditions, std::string("simulated points"));
    QVERIFY(records->front().simulated);
    QVERIFY(std::abs(c.saved()->step.sensing.load_cell.slope_g_per_mV_per_V - kSlope_g) < 1e-6);
    // The profile itself, which a real touchpad loads, keeps what it had.
    QCOMPARE(station::loadProfile(c.profilePath())->step.sensing.load_cell.slope_g_per_mV_per_V, 1004.8805);
    const auto real = station::loadProfileFor(c.profilePath(), "serial:A7");
    QVERIFY(real.has_value());
    QCOMPARE(real->profile.step.sensing.load_cell.slope_g_per_mV_per_V, 1004.8805);
    QVERIFY(!real->set_aside);
    // Nor is it shown as one of a real touchpad.
    c.session->profile.calibrated_on = "serial:A7";
    QVERIFY(c.partText("Load cell").contains(QLatin1String("calibrated today")));
    c.page->enter();
    QVERIFY2(c.partText("Load cell").contains(QLatin1String("never calibrated")), qPrintable(c.partText("Load cell")));
    QVERIFY(c.page->simulateButton()->isHidden());
  }

  void noPointOfOneTouchpadIsAcceptedOnAnother() {
    Calibrating c("load-cell");
    const auto point = [&c](double force_N) {
      c.session->reports = {touchpad(bridgeOf(force_N * 1000.0 / kStandardGravity))};
      c.take(QString::number(force_N));
    };
    for (const double force_N : {0.0, 2.0, 4.0, 6.0, 8.0}) point(force_N);
    QVERIFY(c.page->acceptButton()->isEnabled() && c.page->simulateButton()->isVisible());
    c.page->choose(QStringLiteral("ir-1"));
    c.take(QStringLiteral("100"));
    c.page->choose(QStringLiteral("load-cell"));
    c.session->profile.calibrated_on = "serial:A7";
    c.session->profile.step.sensing.load_cell.slope_g_per_mV_per_V = 777.0;
    changeDevices(c, {.touchpad = "modbus-tcp:10.0.0.7:502"});
    QVERIFY(c.page->points().empty());
    QVERIFY2(c.page->unfinished().isEmpty(), qPrintable(c.page->unfinished()));
    QVERIFY(!c.page->acceptButton()->isEnabled() && !c.page->simulateButton()->isVisible());
    QStringList told;
    for (int i = 0; i < c.window->notices()->count(); ++i) told << c.window->notices()->text(i);
    QVERIFY2(told.join(QLatin1Char('|')).contains(QLatin1String("are discarded (Load cell 5, Distance sensor 1 1)")),
             qPrintable(told.join(QLatin1Char('|'))));
    point(5.0);  // one is not enough, and Accept writes nothing
    QCOMPARE(c.page->points().size(), std::size_t{1});
    QVERIFY(!c.page->acceptButton()->isEnabled());
    for (const double force_N : {0.0, 2.0, 4.0}) point(force_N);
    QCOMPARE(c.page->fitPanel()->changes()->item(0, 1)->text().toDouble(), 777.0);  // its own value in force
    c.state(SafetyState::stopped);
    c.click(c.page->acceptButton());
    const auto records = station::loadCalibrationRecords(c.profilePath());
    QCOMPARE(records->size(), std::size_t{1});
    QCOMPARE(records->front().touchpad, std::string("serial:A7"));
    QVERIFY(!records->front().simulated);
    QCOMPARE(records->front().points, std::int64_t{4});
  }

  void pointsOfTwoTouchpadsAreNotMixed() {
    console::CalibrationPoints points;
    points.add(0, {1.0}, console::PointOrigin::measured_on_simulation);
    points.add(0, {2.0}, console::PointOrigin::measured);
    QVERIFY(points.originOf(0) == console::PointOrigin::measured_on_simulation);
    points.takeBack(0);
    QVERIFY(points.originOf(0) == console::PointOrigin::measured_on_simulation);
    points.takeBack(0);
    points.takeBack(0);
    points.add(0, {3.0}, console::PointOrigin::measured);
    QVERIFY(points.originOf(0) == console::PointOrigin::measured);

    Calibrating c("load-cell");
    const auto refused = [&c](std::string_view on, const char* why) {
      c.session->profile.calibrated_on = on;
      const std::size_t before = c.page->points().size();
      c.take(QStringLiteral("2"));
      QVERIFY2(c.page->hint().contains(QLatin1String(why)), qPrintable(c.page->hint()));
      QCOMPARE(c.page->points().size(), before);
    };
    c.take(QStringLiteral("1"));
    refused("serial:A7", "measured on the simulated touchpad: discard them");
    c.click(c.page->discardButton());
    c.take(QStringLiteral("1"));
    QCOMPARE(c.page->points().size(), std::size_t{1});
    refused(station::kSimulatedTouchpad, "measured on another touchpad: discard them");
    c.click(c.page->simulateButton());
    QVERIFY2(c.page->hint().contains(QLatin1String("are measured: discard them")), qPrintable(c.page->hint()));
    c.click(c.page->discardButton());
    c.session->profile.calibrated_on = "serial:A7";
    c.click(c.page->simulateButton());
    QVERIFY2(c.page->hint().contains(QLatin1String("not simulated")), qPrintable(c.page->hint()));
    QVERIFY(c.page->points().empty());
  }

  void discardKeepsTheOldValuesAndRefusedFilesToo() {
    Calibrating c("load-cell");
    c.click(c.page->simulateButton());
    QVERIFY(c.page->acceptButton()->isEnabled());
    c.click(c.page->discardButton());
    QVERIFY(c.page->points().empty());
    QVERIFY(!c.page->acceptButton()->isEnabled());
    QVERIFY(!QFileInfo::exists(QString::fromStdString(c.profilePath())));
    QCOMPARE(c.session->profile.step.sensing.load_cell.slope_g_per_mV_per_V, 1004.8805);
    // A record that cannot be read stops the writing.
    std::ofstream(station::calibrationFileOf(c.profilePath())) << "format = 99\n";
    c.click(c.page->simulateButton());
    c.click(c.page->acceptButton());
    QVERIFY(!QFileInfo::exists(QString::fromStdString(c.profilePath())));
    QCOMPARE(c.session->begun_anew, 0);
    QVERIFY(!c.page->points().empty());
    QVERIFY(QDir(c.folder.path()).entryList({QStringLiteral("*.png")}).isEmpty());
  }

  void simulatedPointsSayThatTheyAre() {
    Calibrating c("load-cell");
    c.take(QStringLiteral("1"));
    c.click(c.page->simulateButton());
    QVERIFY(c.page->hint().contains(QLatin1String("discard them before")));
    c.click(c.page->discardButton());
    for (const char* part : {"load-cell", "ir-1", "camera-region", "camera"}) {
      c.page->choose(QLatin1String(part));
      c.click(c.page->simulateButton());
      QVERIFY(c.page->missing().contains(QLatin1String("Simulated points")));
      QVERIFY2(c.page->acceptButton()->isEnabled(), qPrintable(QLatin1String(part) + c.page->fitPanel()->verdict()));
      c.state(SafetyState::stopped);  // fitting may take longer than a station may be silent
      c.click(c.page->acceptButton());
    }
    const auto records = station::loadCalibrationRecords(c.profilePath());
    QCOMPARE(records->size(), std::size_t{4});
    for (const auto& record : *records) QCOMPARE(record.conditions, std::string("simulated points"));
    QVERIFY(std::abs(c.session->profile.step.sensing.finger.scale_x_mm_per_px - 100.0 / 220.0) < 0.01);
    // The untouched cloth is measured on the simulation itself, its finger lifted.
    const double counts = sim::irCode(sim::irVolts(100.0));
    c.session->reports = {touchpad(0.03, counts)};
    c.page->choose(QStringLiteral("no-touch"));
    c.click(c.page->simulateButton());
    QCOMPARE(c.session->finger, (std::vector<double>{0.0, 0.0, 0.0}));
    WAIT_FOR(!c.page->points().empty());
    QVERIFY(c.session->finger.empty());
  }

  void theUntouchedCloth() {
    Calibrating c("no-touch");
    c.session->reports = {touchpad(0.03, sim::irCode(sim::irVolts(110.0)))};
    pipeline::TelemetrySample touched;
    touched.now = instantAt(1.0);
    touched.state = SafetyState::stopped;
    touched.contact = true;
    c.session->telemetry.push_back(touched);
    c.window->feed().pump();
    c.click(c.page->takeButton());
    QVERIFY(c.page->hint().contains(QLatin1String("sees a finger")));
    c.state(SafetyState::stopped);
    c.click(c.page->takeButton());
    c.readings(551);  // 11 s, fifty times a second
    QCOMPARE(c.page->points().size(), std::size_t{1});
    QCOMPARE(c.session->profile.step.sensing.indentation.ir_offset_mm[0], 100.0);  // nothing before "Accept"
    c.click(c.page->acceptButton());
    const auto profile = c.saved();
    QVERIFY(profile.has_value());
    QVERIFY(std::abs(profile->step.sensing.indentation.ir_offset_mm[0] - 110.0) < 0.5);
    QCOMPARE(c.session->count(pipeline::OperatorAction::tare), 0);
  }

  void aPrintedTargetByClicksAndArrowKeys() {
    Calibrating c("camera");
    c.session->view.picture = cv::Mat(240, 320, CV_8UC1, cv::Scalar(200));
    c.session->view.number = 1;
    c.window->feed().pump();
    c.type(0, QStringLiteral("1"));
    c.type(1, QStringLiteral("1"));
    c.click(c.page->takeButton());
    QVERIFY(c.page->hint().contains(QLatin1String("click a mark")));
    for (const double y_mm : {-25.0, 25.0}) {
      for (const double x_mm : {-40.0, 0.0, 40.0}) {
        const sim::PicturePoint at = sim::pictureOf(x_mm, y_mm);
        const QPointF drawn = c.page->picture()->drawnAt({at.u_px, at.v_px});
        QTest::mouseClick(c.page->picture(), Qt::LeftButton, {}, drawn.toPoint());
        c.type(0, QString::number(x_mm));
        c.type(1, QString::number(y_mm));
        c.click(c.page->takeButton());
      }
    }
    QCOMPARE(c.page->points().size(), std::size_t{6});
    QVERIFY2(c.page->fitPanel()->verdict().startsWith(QLatin1String("Good")),
             qPrintable(c.page->fitPanel()->verdict()));
    QTest::keyClick(c.page->picture(), Qt::Key_Right, Qt::ShiftModifier);
    const QPointF before = *c.page->picture()->place();
    QTest::keyClick(c.page->picture(), Qt::Key_Down);
    QCOMPARE(*c.page->picture()->place(), before + QPointF(0, 1));
    c.click(c.page->acceptButton());
    const auto profile = c.saved();
    QVERIFY(profile.has_value());
    QVERIFY(std::abs(profile->step.sensing.finger.scale_x_mm_per_px - 100.0 / 220.0) < 0.01);
  }

  void aCameraThatFallsSilentShowsNoPictureAndGivesNoPoint() {
    Calibrating c("camera");
    const auto camera = [&c](bool answers) {
      device::DeviceReport report{
          .part = device::Part::camera, .kind = verbatim("MJPEG"), .description = verbatim("camera of the script")};
      report.ok = answers;
      if (!answers) report.problem = verbatim("no picture for 0.9 s");
      c.session->now.parts = {report};
      if (answers) ++c.session->view.number;
      c.window->feed().pump();
    };
    c.session->view.picture = cv::Mat(240, 320, CV_8UC1, cv::Scalar(200));
    camera(true);
    QVERIFY(!c.page->picture()->picture().isNull());
    QTest::mouseClick(c.page->picture(), Qt::LeftButton);
    QVERIFY(c.page->picture()->place().has_value());
    c.page->choose(QStringLiteral("camera-region"));
    c.page->picture()->setRectangle(QRect(20, 20, 200, 150));
    QTest::mousePress(c.page->picture(), Qt::LeftButton);  // a drag ends with the pictures
    camera(false);
    QTest::mouseRelease(c.page->picture(), Qt::LeftButton, {}, QPoint(30, 30));
    QCOMPARE(c.page->picture()->rectangle(), QRect(20, 20, 200, 150));
    for (const QString& part : {QStringLiteral("camera-region"), QStringLiteral("camera")}) {
      c.page->choose(part);
      for (const bool entered_anew : {false, true}) {
        if (entered_anew) {
          c.window->frame()->go(QStringLiteral("operate"));
          c.window->frame()->go(QStringLiteral("calibrate"));
        }
        QVERIFY(c.page->picture()->picture().isNull());
        if (part == QLatin1String("camera")) {
          c.type(0, QStringLiteral("1"));
          c.type(1, QStringLiteral("1"));
        }
        c.click(c.page->takeButton());
        QVERIFY2(c.page->hint().contains(QLatin1String("there is no picture")), qPrintable(c.page->hint()));
        QVERIFY(c.page->points().empty());
      }
    }
    camera(true);
    QVERIFY(!c.page->picture()->picture().isNull());
    QTest::mouseClick(c.page->picture(), Qt::LeftButton);
    c.type(0, QStringLiteral("1"));
    c.type(1, QStringLiteral("1"));
    c.click(c.page->takeButton());
    QCOMPARE(c.page->points().size(), std::size_t{1});
  }

  void marksThatArePressedDownTellTheCamerasHeight() {
    Calibrating c("camera");
    c.session->view.picture = cv::Mat(240, 320, CV_8UC1, cv::Scalar(200));
    c.session->view.number = 1;
    c.window->feed().pump();
    for (const double depth_mm : {0.0, 8.0}) {
      for (const double y_mm : {-25.0, 25.0}) {
        for (const double x_mm : {-40.0, 0.0, 40.0}) {
          const double nearer = 90.0 / (90.0 - depth_mm);
          const sim::PicturePoint at = sim::pictureOf(nearer * x_mm, nearer * y_mm);
          QTest::mouseClick(c.page->picture(), Qt::LeftButton, {},
                            c.page->picture()->drawnAt({at.u_px, at.v_px}).toPoint());
          c.type(0, QString::number(x_mm));
          c.type(1, QString::number(y_mm));
          if (depth_mm > 0.0) c.type(2, QString::number(depth_mm));  // empty: on the cloth
          c.click(c.page->takeButton());
        }
      }
    }
    QCOMPARE(c.page->points().size(), std::size_t{12});
    QVERIFY2(c.page->fitPanel()->verdict().startsWith(QLatin1String("Good")),
             qPrintable(c.page->fitPanel()->verdict()));
    c.click(c.page->acceptButton());
    const double height_mm = c.saved()->step.sensing.indentation.camera_height_mm;
    QVERIFY2(std::abs(height_mm - 90.0) < 9.0, qPrintable(QString::number(height_mm)));
  }

  void theClothFromPressesOverTheSensors() {
    Calibrating c("cloth");
    QVERIFY(c.page->instruction().contains(QLatin1String("distance sensor 1")));
    c.click(c.page->takeButton());
    QVERIFY2(c.page->hint().contains(QLatin1String("no cloth")), qPrintable(c.page->hint()));
    pressCloth(c, 0, 3.0, 6.0);
    c.click(c.page->takeButton());
    QVERIFY2(c.page->hint().contains(QLatin1String("beside distance sensor 1")), qPrintable(c.page->hint()));

    constexpr int kReadings = 550;  // 11 s
    pressCloth(c, 0, 3.0);
    c.click(c.page->takeButton());
    c.readings(kReadings / 2);
    const auto* bar = c.page->findChild<QProgressBar*>();
    QVERIFY2(std::abs(bar->value() - 50) <= 1, qPrintable(QString::number(bar->value())));
    QVERIFY(c.page->points().empty());
    c.session->view.finger.contact = false;  // let go too early
    c.readings(1);
    QVERIFY2(c.page->hint().contains(QLatin1String("no finger")), qPrintable(c.page->hint()));
    for (const int sensor : {0, 1, 2}) {
      for (const double depth_mm : {3.0, 3.1}) {
        pressCloth(c, sensor, depth_mm);
        c.click(c.page->takeButton());
        c.readings(kReadings);
      }
    }
    QCOMPARE(c.page->points().size(), std::size_t{6});
    QVERIFY2(c.page->fitPanel()->verdict().contains(QLatin1String("equally deep")),
             qPrintable(c.page->fitPanel()->verdict()));
    QVERIFY(!c.page->acceptButton()->isEnabled());
    QVERIFY2(c.page->missing().contains(QLatin1String("distance sensor 1 once more")), qPrintable(c.page->missing()));
    for (const int sensor : {0, 1, 2}) {
      pressCloth(c, sensor, 5.5);
      c.click(c.page->takeButton());
      c.readings(kReadings);
    }
    QVERIFY2(c.page->fitPanel()->verdict().startsWith(QLatin1String("Good")),
             qPrintable(c.page->fitPanel()->verdict()));
    c.state(SafetyState::stopped);
    c.click(c.page->acceptButton());
    const auto profile = c.saved();
    QVERIFY(profile.has_value());
    const sensing::IndentationParameters& indentation = profile->step.sensing.indentation;
    QVERIFY(indentation.mode == sensing::IndentationMode::contact);
    QVERIFY2(std::abs(indentation.contact_radius_share - 0.61) < 0.1,  // a sphere's
             qPrintable(QString::number(indentation.contact_radius_share)));
    QVERIFY2(profile->step.control.measurement_bias > 0.02 && profile->step.control.measurement_bias < 0.2,
             qPrintable(QString::number(profile->step.control.measurement_bias)));
    QVERIFY(c.partText("Cloth").contains(QLatin1String("fine")));
  }

  void aTareThatComesMeanwhileCountsFromTheNextReading() {
    Calibrating c("cloth");
    constexpr int kReadings = 550;  // 11 s
    const auto tare = [&c](double by_mm) {
      for (std::size_t i = 0; i < 3; ++i) c.session->profile.step.sensing.indentation.ir_offset_mm[i] += by_mm;
      station::Notice notice{.message = say("Tare done")};
      notice.event.kind = pipeline::EventKind::tare_done;
      c.session->notices.push_back(notice);
      c.window->feed().pump();
    };
    pressCloth(c, 0, 3.0);
    c.click(c.page->takeButton());
    c.readings(kReadings);
    QCOMPARE(c.page->points().size(), std::size_t{1});
    const auto depth_mm = [&c](int row) { return c.page->table()->item(row, 1)->text().toDouble(); };
    const double before_mm = depth_mm(0);
    tare(1.5);
    c.click(c.page->takeButton());
    c.readings(kReadings);
    QCOMPARE(c.page->points().size(), std::size_t{2});
    for (const int row : {0, 1}) {  // both are counts
      QVERIFY2(std::abs(depth_mm(row) - before_mm - 1.5) < 0.011, qPrintable(QString::number(depth_mm(row))));
    }
    c.click(c.page->takeButton());
    c.readings(kReadings / 2);
    tare(0.5);
    QVERIFY2(c.page->hint().contains(QLatin1String("a tare came in between")), qPrintable(c.page->hint()));
    c.readings(kReadings);
    QCOMPARE(c.page->points().size(), std::size_t{2});
  }

  void theStiffnessMapSaysWhetherItsIndentationWasProven() {
    for (const sim::ClothKind kind : {sim::ClothKind::ideal, sim::ClothKind::membrane}) {
      Calibrating c("stiffness");
      c.session->profile.sim.cloth = kind;
      c.page->enter();
      c.click(c.page->simulateButton());
      QVERIFY2(c.page->fitPanel()->verdict().contains(QLatin1String("never proven")),
               qPrintable(c.page->fitPanel()->verdict()));
      c.page->choose(QStringLiteral("cloth"));
      c.click(c.page->simulateButton());
      QVERIFY2(c.page->acceptButton()->isEnabled(), qPrintable(c.page->fitPanel()->verdict()));
      c.state(SafetyState::stopped);
      c.click(c.page->acceptButton());
      c.page->choose(QStringLiteral("stiffness"));
      QVERIFY(c.page->points().empty());  // of the former cloth
      c.click(c.page->simulateButton());
      QVERIFY2(!c.page->fitPanel()->verdict().contains(QLatin1String("never proven")),
               qPrintable(c.page->fitPanel()->verdict()));
    }
  }

  void pointsThatWereReadWithFormerValuesAreDiscardedAndNamed() {
    Calibrating c("no-touch");
    const auto told = [&c] {
      QStringList out;
      for (int i = 0; i < c.window->notices()->count(); ++i) out << c.window->notices()->text(i);
      return out.join(QLatin1Char('|'));
    };
    const auto untouched = [&c] {
      c.page->choose(QStringLiteral("no-touch"));
      c.session->reports = {touchpad(0.03, sim::irCode(sim::irVolts(110.0)))};
      c.state(SafetyState::stopped);
      c.click(c.page->takeButton());
      c.readings(551);  // 11 s, fifty times a second
      QCOMPARE(c.page->points().size(), std::size_t{1});
    };
    const auto simulate = [&c](const char* part) {
      c.page->choose(QLatin1String(part));
      c.click(c.page->simulateButton());
      QVERIFY2(!c.page->points().empty(), part);
    };
    const auto accept = [&c] {
      c.window->notices()->dismissAll();
      c.state(SafetyState::stopped);  // fitting may take longer than a station may be silent
      QVERIFY2(c.page->acceptButton()->isEnabled(), qPrintable(c.page->fitPanel()->verdict()));
      c.click(c.page->acceptButton());
      QVERIFY2(c.page->points().empty(), qPrintable(c.page->hint()));
    };
    const QString discarded = QStringLiteral("read with the former values are discarded: take them again (%1");
    untouched();
    simulate("ir-1");
    accept();
    QVERIFY2(c.page->unfinished().isEmpty(), qPrintable(c.page->unfinished()));
    QVERIFY2(told().contains(discarded.arg(QStringLiteral("No-touch offsets 1)"))), qPrintable(told()));
    untouched();
    simulate("stiffness");
    simulate("load-cell");
    accept();
    QVERIFY2(c.page->unfinished().isEmpty(), qPrintable(c.page->unfinished()));
    QVERIFY2(told().contains(discarded.arg(QStringLiteral("No-touch offsets 1, Stiffness map "))), qPrintable(told()));
    // The stiffness map's points were read from other zeros than the new ones, of a calibration or a tare; the cloth's
    // are counts, with the contact that the camera saw.
    simulate("cloth");
    simulate("stiffness");
    untouched();
    accept();
    QVERIFY2(told().contains(discarded.arg(QStringLiteral("Stiffness map "))), qPrintable(told()));
    QVERIFY2(c.page->unfinished().contains(QStringLiteral("Cloth")), qPrintable(c.page->unfinished()));
    for (const char* camera : {"camera", "camera-region"}) {
      simulate("cloth");
      simulate("stiffness");
      simulate(camera);
      accept();
      QVERIFY2(c.page->unfinished().isEmpty(), qPrintable(c.page->unfinished()));
      QVERIFY2(told().contains(discarded.arg(QStringLiteral("Cloth "))), qPrintable(told()));
      QVERIFY2(told().contains(QStringLiteral(", Stiffness map ")), qPrintable(told()));
    }
    simulate("cloth");
    simulate("stiffness");
    c.window->frame()->go(QStringLiteral("operate"));
    station::Notice tare{.message = say("Tare done")};
    tare.event.kind = pipeline::EventKind::tare_done;
    c.session->notices.push_back(tare);
    c.window->feed().pump();
    QVERIFY2(!c.page->unfinished().contains(QStringLiteral("Stiffness")), qPrintable(c.page->unfinished()));
    QVERIFY2(c.page->unfinished().contains(QStringLiteral("Cloth")), qPrintable(c.page->unfinished()));
  }

  /// A tare that the window hears while it writes empties the fit that is shown; what was accepted stays what it was.
  void aTareHeardWhileAcceptingTakesNothingBack() {
    Calibrating c("stiffness");
    c.click(c.page->simulateButton());
    c.state(SafetyState::stopped);
    QVERIFY2(c.page->acceptButton()->isEnabled(), qPrintable(c.page->fitPanel()->verdict()));
    station::Notice tare{.message = say("Tare done")};
    tare.event.kind = pipeline::EventKind::tare_done;
    c.session->notices.push_back(tare);
    c.click(c.page->acceptButton());
    QCOMPARE(c.session->begun_anew, 1);
    const auto saved = c.saved();
    QVERIFY(saved.has_value());
    int changed = 0;
    station::Profile in_force = c.session->profile, in_file = *saved, standard;
    const auto own = bindParameters(in_force), written = bindParameters(in_file), usual = bindParameters(standard);
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (calibration::calibratedBy(own[i].id) != "stiffness") continue;
      QCOMPARE(formatParameter(own[i]), formatParameter(written[i]));
      changed += formatParameter(own[i]) != formatParameter(usual[i]) ? 1 : 0;
    }
    QVERIFY(changed > 0);
  }

  void aSessionThatGoesOnWithItsValuesKeepsThePointsReadWithThem() {
    Calibrating c("stiffness");
    c.click(c.page->simulateButton());
    c.page->choose(QStringLiteral("load-cell"));
    c.click(c.page->simulateButton());
    c.state(SafetyState::stopped);
    c.session->refuses = true;
    c.click(c.page->acceptButton());
    QVERIFY2(c.page->unfinished().contains(QStringLiteral("Stiffness map")), qPrintable(c.page->unfinished()));
    QVERIFY2(!c.page->unfinished().contains(QStringLiteral("Load cell")), qPrintable(c.page->unfinished()));
    QVERIFY2(c.page->hint().contains(QStringLiteral("not in force")), qPrintable(c.page->hint()));
  }

  void aSessionThatCouldNotBeginAnewIsSaidToBeClosed() {
    Calibrating c("load-cell");
    c.click(c.page->simulateButton());
    c.state(SafetyState::stopped);
    c.session->refuses = c.session->loses_former = true;
    c.click(c.page->acceptButton());
    QString said;
    for (int i = 0; i < c.window->notices()->count(); ++i) said += c.window->notices()->text(i);
    QVERIFY2(said.contains(QStringLiteral("the session is closed")), qPrintable(said));
    QVERIFY2(!said.contains(QStringLiteral("goes on")), qPrintable(said));
  }

  /// Its presses are counts: how deep each is follows from the offsets and curves in force.
  void thePressesOnTheClothAreAsDeepAsTheOffsetsInForceSay() {
    Calibrating c("cloth");
    c.click(c.page->simulateButton());
    const auto depth = [&c] { return c.page->table()->item(0, 1)->text().toDouble(); };
    const double before_mm = depth();
    auto& offsets_mm = c.session->profile.step.sensing.indentation.ir_offset_mm;
    // NOLINTNEXTLINE(modernize-loop-convert): they are changed by their index only
    for (std::size_t i = 0; i < offsets_mm.size(); ++i) offsets_mm[i] += 0.5;
    c.page->enter();
    QVERIFY2(std::abs(depth() - before_mm - 0.5) < 0.02, qPrintable(QString::number(depth() - before_mm)));
  }

  void nothingIsAcceptedWhileARecordingBegins() {
    Calibrating c("load-cell");
    c.click(c.page->simulateButton());
    QTest::keyClick(c.window.get(), Qt::Key_R, Qt::ControlModifier);
    widgets::RecordingForm* form = c.window->recording()->form();
    form->operatorField()->setText(QStringLiteral("M. Muster"));
    form->fileField()->setText(c.folder.filePath(QStringLiteral("one.h5")));
    c.session->disk_waits = true;
    c.click(form->startButton());
    QVERIFY(!form->startButton()->isEnabled());
    c.state(SafetyState::stopped);
    c.click(c.page->acceptButton());
    QVERIFY2(c.page->hint().contains(QStringLiteral("A recording is beginning")), qPrintable(c.page->hint()));
    QCOMPARE(c.session->begun_anew, 0);
    QVERIFY(!c.page->points().empty());
    c.session->disk_waits = false;
    WAIT_FOR(form->startButton()->isEnabled());
    QCOMPARE(c.session->recordings.size(), std::size_t{1});
  }

  void theClothsRegionIsDragged() {
    Calibrating c("camera-region");
    cv::Mat picture(240, 320, CV_8UC1, cv::Scalar(220));
    picture(cv::Rect(140, 110, 40, 40)).setTo(60);
    c.session->view.picture = picture;
    c.session->view.number = 1;
    c.window->feed().pump();
    widgets::PicturePick* image = c.page->picture();
    image->setRectangle(QRect(5, 230, 200, 5));
    for (int step = 0; step < 2; ++step) {  // at the picture's edge it stands, and keeps its size
      QTest::keyClick(image, Qt::Key_Left, Qt::ShiftModifier);
      QTest::keyClick(image, Qt::Key_Down, Qt::ShiftModifier);
      QCOMPARE(image->rectangle(), QRect(0, 235, 200, 5));
    }
    const auto at = [image](double x, double y) { return image->drawnAt({x, y}).toPoint(); };
    QTest::mousePress(image, Qt::LeftButton, {}, at(50, 60));
    QTest::mouseMove(image, at(200, 150));
    QTest::mouseRelease(image, Qt::LeftButton, {}, at(250, 190));
    c.click(c.page->takeButton());
    QVERIFY2(c.page->acceptButton()->isEnabled(), qPrintable(c.page->hint()));
    c.click(c.page->acceptButton());
    const auto profile = c.saved();
    QVERIFY(profile.has_value());
    const sensing::FingerParameters& finger = profile->step.sensing.finger;
    QVERIFY(std::abs(finger.roi_x_px - 50) <= 2 && std::abs(finger.roi_y_px - 60) <= 2);
    QVERIFY(std::abs(finger.roi_width_px - 200) <= 4 && std::abs(finger.roi_height_px - 130) <= 4);
    QVERIFY(finger.threshold > 70 && finger.threshold < 215);
  }

  void agesAreSaid() {
    calibration::CalibrationRecord record;
    record.procedure = "load-cell";
    record.when = "2026-01-01T08:00:00Z";
    record.changes = {{"sensing.force_slope_g", "999", "1004.8805"}};
    const station::Profile profile;
    const auto state = [&](const char* today) {
      return console::partStateOf({record}, "load-cell", 0, profile, today).words;
    };
    QCOMPARE(state("2026-01-01"), QStringLiteral("fine: calibrated today"));
    QCOMPARE(state("2026-01-02"), QStringLiteral("fine: calibrated yesterday"));
    QCOMPARE(state("2026-02-01"), QStringLiteral("fine: calibrated 31 days ago"));
    QCOMPARE(state("2026-05-01"), QStringLiteral("ageing: calibrated 120 days ago: repeat it soon"));
    QCOMPARE(state("2027-06-01"), QStringLiteral("old: calibrated 516 days ago: repeat it"));
    QVERIFY(state("2025-01-01").contains(QLatin1String("in the future")));
    QCOMPARE(console::partStateOf({record}, "ir", 1, profile, "2026-01-01").words, QStringLiteral("never calibrated"));
    record.changes = {{"sensing.force_slope_g", "999", "1000"}};
    QCOMPARE(state("2026-01-11"), QStringLiteral("changed since it was calibrated 10 days ago"));
    QCOMPARE(state("2026-01-01"), QStringLiteral("changed since it was calibrated today"));
  }
};

std::unique_ptr<QObject> makeCalibrateTest() { return std::make_unique<CalibrateTest>(); }

}  // namespace fyd::tests

#include "calibrate_test.moc"
