// The place "Tune" on a scripted session: find and change, undo, compare, presets, step response, auto-tune; what the
// station confirms and what it does not; the readiness list's buttons.
#include <qcustomplot.h>

#include "app/console/calibrate/calibrate_part_list.h"
#include "app/console/tune/tune_page.h"
#include "core/control/static_law.h"
#include "tests/widgets/hands.h"
#include "tests/widgets/suite.h"

namespace fyd::tests {
namespace {

using widgets::TuningResponse;

struct TuneFixture : Fixture {
  TuneFixture() {
    window->frame()->go(QStringLiteral("tune"));
    page = qobject_cast<console::TunePage*>(window->frame()->page(QStringLiteral("tune")));
  }
  /// Types a value as an operator does.
  void type(const char* id, const QString& text) const { enter(page->list()->row(QLatin1String(id))->field(), text); }
  static void enter(QLineEdit* field, const QString& text) {
    field->setFocus();
    field->selectAll();
    QTest::keyClick(field, Qt::Key_Delete);
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
  }
  [[nodiscard]] widgets::TuningModel& model() const { return page->model(); }
  [[nodiscard]] double value(const char* id) const { return std::as_const(model()).find(id)->value; }
  /// What the session, and so the touchpad, has.
  [[nodiscard]] double used(const char* id) const {
    const auto bound = bindParameters(session->profile);
    return findParameter(bound, id)->value();
  }
  /// The step's answer to a change.
  void answer(const char* id, double value, pipeline::EventKind kind = pipeline::EventKind::parameter_changed) const {
    const auto bound = bindParameters(session->profile);
    const auto index = static_cast<std::uint16_t>(findParameter(bound, id) - bound.data());
    session->notices.push_back({.event = {.kind = kind, .index = index, .value = value}, .message = verbatim(id)});
    window->feed().pump();
  }
  [[nodiscard]] QString mark(const char* id) const { return page->list()->row(QLatin1String(id))->mark()->text(); }
  [[nodiscard]] QStringList presets() const {
    QStringList out;
    for (int i = 0; i < page->presets()->list()->count(); ++i) out << page->presets()->list()->item(i)->text();
    return out;
  }
  void choosePreset(const QString& name) const {
    page->tabs()->setCurrentWidget(page->presets());
    page->presets()->list()->setCurrentItem(page->presets()->list()->findItems(name, Qt::MatchExactly).front());
  }

  console::TunePage* page;
};

}  // namespace

class TuneTest : public QObject {
  Q_OBJECT
 private slots:
  void theSimulationIsASourceOnlyBesideASimulatedTouchpad() {
    TuneFixture f;
    const QComboBox* sources = f.page->proposal()->sources();
    QCOMPARE(sources->count(), 2);
    f.session->profile.calibrated_on = "FYD-0007";
    changeDevices(f, {.touchpad = "modbus-tcp:10.0.0.7:502"});
    WAIT_EQUAL(sources->count(), 1);
    QVERIFY(sources->itemText(0).contains(QStringLiteral("this session")));
    QVERIFY(!f.page->study().proposal());
    QVERIFY2(f.page->proposal()->words().contains(QStringLiteral("proposes gains")),
             qPrintable(f.page->proposal()->words()));
  }

  void everyLiveParameterIsThereWithItsRangeDefaultAndHelp() {
    TuneFixture f;
    station::Profile profile;
    int live = 0;
    for (const Parameter& parameter : bindParameters(profile)) {
      if (!parameter.info.live || parameter.kind == ParameterKind::list) continue;
      ++live;
      const QString id = QString::fromStdString(std::string(parameter.id));
      const widgets::TuningRow* row = f.page->list()->row(id);
      QVERIFY2(row != nullptr, qPrintable(id));
      QVERIFY2(row->facts().contains(QStringLiteral("default")), qPrintable(row->facts()));
      QVERIFY(!row->accessibleName().isEmpty() && !row->accessibleDescription().isEmpty());
    }
    QVERIFY(live > 40);
    QCOMPARE(f.page->list()->rows().size(), static_cast<std::size_t>(live));
    QCOMPARE(f.page->list()->shownCount(), live);
  }

  void searchFindsByNameIdentifierHelpAndGroup() {
    TuneFixture f;
    QTest::keyClick(f.window.get(), Qt::Key_F, Qt::ControlModifier);
    QLineEdit* search = f.page->list()->search();
    QVERIFY(search->hasFocus());
    QTest::keyClicks(search, QStringLiteral("dead zone"));
    QVERIFY(f.page->list()->row(QStringLiteral("texture.dead_zone_percent"))->isVisible());
    QVERIFY(!f.page->list()->row(QStringLiteral("control.kp"))->isVisible());
    for (const auto& [words, least] : {std::pair{"control.", 8}, {"stiffness control", 8}, {"FINGER threshold", 1}}) {
      search->setText(QLatin1String(words));
      QVERIFY2(f.page->list()->shownCount() >= least, words);
    }
    search->setText(QStringLiteral("no such thing"));
    QCOMPARE(f.page->list()->shownCount(), 0);
    search->clear();
    f.type("control.kp", QStringLiteral("0.3"));
    search->setFocus();
    f.page->list()->onlyChanged()->click();
    QCOMPARE(f.page->list()->shownCount(), 1);
  }

  void aChangeAppliesLiveIsConfirmedAndCanBeTakenBack() {
    TuneFixture f;
    f.type("control.kp", QStringLiteral("0,3"));
    QCOMPARE(f.used("control.kp"), 0.3);
    QCOMPARE(f.mark("control.kp"), QStringLiteral("◦"));  // sent, not confirmed
    QVERIFY(f.page->list()->row(QStringLiteral("control.kp"))->facts().contains(QStringLiteral("not yet confirmed")));
    f.answer("control.kp", 0.3);
    QCOMPARE(f.mark("control.kp"), QStringLiteral("•"));
    const QString facts = f.page->list()->row(QStringLiteral("control.kp"))->facts();
    for (const char* each : {"was 0.15", "is 0.3", "saved 0.15", "default 0.15"}) {
      QVERIFY2(facts.contains(QLatin1String(each)), qPrintable(facts));
    }
    QCOMPARE(f.window->operate()->tuning()->row(QStringLiteral("control.kp"))->field()->text(), QStringLiteral("0.3"));
    QTest::keyClick(f.page, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(f.used("control.kp"), 0.15);
    QTest::keyClick(f.page, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(f.used("control.kp"), 0.3);
    click(f.page->list()->row(QStringLiteral("control.kp"))->revertButton());
    QCOMPARE(f.used("control.kp"), 0.15);
    f.type("texture.k_vib", QStringLiteral("2"));
    QTest::keyClick(f.page, Qt::Key_S, Qt::ControlModifier);
    QVERIFY(!f.model().anyChanged());
    QVERIFY(f.page->list()->row(QStringLiteral("texture.k_vib"))->resetButton()->isVisible());
    click(f.page->list()->row(QStringLiteral("texture.k_vib"))->resetButton());
    QCOMPARE(f.used("texture.k_vib"), 1.0);
    QVERIFY(f.model().anyChanged());
  }

  void whatTheStationDoesNotAnswerOrRefusesIsSaid() {
    TuneFixture f;
    f.type("control.kp", QStringLiteral("0.3"));
    f.answer("control.kp", 0.3, pipeline::EventKind::parameter_refused);
    QCOMPARE(f.value("control.kp"), 0.15);  // what the step goes on with
    QCOMPARE(f.mark("control.kp"), QStringLiteral("!"));
    QVERIFY(f.page->list()->row(QStringLiteral("control.kp"))->facts().contains(QStringLiteral("refused")));
    f.session->refuses = true;
    f.type("control.ki", QStringLiteral("6"));
    QCOMPARE(f.value("control.ki"), 5.0);
    QVERIFY(f.page->list()->row(QStringLiteral("control.ki"))->facts().contains(QStringLiteral("by the script")));
    f.session->refuses = false;
    f.type("texture.k_vib", QStringLiteral("3"));
    WAIT_EQUAL(f.mark("texture.k_vib"), QStringLiteral("!"));
    QVERIFY(f.page->list()->row(QStringLiteral("texture.k_vib"))->facts().contains(QStringLiteral("did not answer")));
    f.answer("texture.k_vib", 3.0);  // late, but there
    QCOMPARE(f.mark("texture.k_vib"), QStringLiteral("•"));
  }

  void aValueThatTheStationRaisedIsShownBesideTheOneAskedFor() {
    TuneFixture f;
    constexpr const char* kDelay = "texture.input_delay_ms";
    const auto said = [&] { return f.page->readback()->table()->item(0, 3)->text(); };
    f.type(kDelay, QStringLiteral("10"));
    WAIT_EQUAL(f.mark(kDelay), QStringLiteral("!"));  // no answer
    f.answer(kDelay, 10.0);                           // late, but there
    QCOMPARE(f.mark(kDelay), QStringLiteral("•"));
    QVERIFY(std::as_const(f.model()).find(kDelay)->delivery == widgets::Delivery::confirmed);
    QTest::keyClick(f.page, Qt::Key_S, Qt::ControlModifier);
    WAIT_EQUAL(said(), QStringLiteral("confirmed"));
    f.answer(kDelay, 40.0);  // of its own accord
    QCOMPARE(f.value(kDelay), 10.0);
    QVERIFY(!f.model().anyChanged());
    QCOMPARE(f.mark(kDelay), QStringLiteral("!"));
    const widgets::TuningRow* row = f.page->list()->row(QLatin1String(kDelay));
    QVERIFY2(row->mark()->toolTip().contains(QStringLiteral("uses 40")), qPrintable(row->mark()->toolTip()));
    WAIT_EQUAL(said(), QStringLiteral("differs"));
    f.answer(kDelay, 45.0);  // and once more
    QVERIFY2(row->facts().contains(QStringLiteral("uses 45")), qPrintable(row->facts()));
    f.type(kDelay, QStringLiteral("20"));
    f.answer(kDelay, 20.0, pipeline::EventKind::parameter_refused);
    QCOMPARE(f.value(kDelay), 10.0);  // not what was raised, which would be saved
    f.type(kDelay, QStringLiteral("45"));
    f.answer(kDelay, 45.0);
    WAIT_EQUAL(said(), QStringLiteral("confirmed"));
  }

  void everyFieldRefusesBadEntries() {
    TuneFixture f;
    QSignalSpy refused(f.page->list(), &widgets::TuningList::refused);
    int tried = 0;
    for (widgets::TuningRow* row : f.page->list()->rows()) {
      if (row->field() == nullptr) continue;
      const std::string id = row->id().toStdString();
      const double before = f.value(id.c_str());
      for (const char* entry : {"abc", "nan", "1e999", "-1e15"}) {
        row->field()->setText(QLatin1String(entry));
        row->field()->setModified(true);
        QTest::keyClick(row->field(), Qt::Key_Return);
        QCOMPARE(refused.count(), ++tried);
        QCOMPARE(f.value(id.c_str()), before);
      }
    }
    QVERIFY(f.session->changes.empty());
  }

  void compareSwitchesLiveAndNothingCanBeChangedMeanwhile() {
    TuneFixture f;
    QVERIFY(!f.page->compare()->savedButton()->isEnabled());  // nothing to compare
    f.type("control.kp", QStringLiteral("0.3"));
    f.type("texture.k_vib", QStringLiteral("2"));
    QCOMPARE(f.page->differences()->table()->rowCount(), 2);
    click(f.page->compare()->savedButton());
    QCOMPARE(f.used("control.kp"), 0.15);
    QCOMPARE(f.used("texture.k_vib"), 1.0);
    QVERIFY(!f.page->list()->row(QStringLiteral("control.kp"))->field()->isEnabled());
    QVERIFY(!f.window->operate()->tuning()->row(QStringLiteral("control.kp"))->slider()->isEnabled());
    QVERIFY(!f.page->differences()->revertAllButton()->isEnabled());
    QVERIFY(!f.model().change("control.ki", 6.0));
    QCOMPARE(f.page->differences()->table()->rowCount(), 2);  // what differs stays listed
    QTest::keyClick(f.page, Qt::Key_B, Qt::ControlModifier);
    QCOMPARE(f.used("control.kp"), 0.3);
    QCOMPARE(f.used("texture.k_vib"), 2.0);
    // Undo returns to the current values first; saving keeps these, not what is felt.
    click(f.page->compare()->savedButton());
    QTest::keyClick(f.page, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(f.used("texture.k_vib"), 2.0);
    click(f.page->compare()->savedButton());
    QTest::keyClick(f.page, Qt::Key_S, Qt::ControlModifier);
    const auto saved = station::loadProfile(f.folder.filePath(QStringLiteral("profile.toml")).toStdString());
    QVERIFY(saved.has_value());
    QCOMPARE(saved->step.control.kp, 0.3);
    QCOMPARE(f.page->differences()->table()->rowCount(), 0);
  }

  void differencesGoBackOneByOneAndAllAtOnce() {
    TuneFixture f;
    f.type("control.kp", QStringLiteral("0.3"));
    f.type("control.ki", QStringLiteral("6"));
    f.type("texture.k_vib", QStringLiteral("2"));
    QCOMPARE(f.page->differences()->table()->item(1, 0)->text(), QStringLiteral("Ki"));
    f.page->differences()->table()->selectRow(1);
    click(f.page->differences()->revertButton());
    QCOMPARE(f.used("control.ki"), 5.0);
    QCOMPARE(f.used("control.kp"), 0.3);
    QTest::keyClick(f.page, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!f.model().anyChanged());
    f.model().undo();
    QCOMPARE(f.used("control.kp"), 0.3);
    QCOMPARE(f.used("texture.k_vib"), 2.0);
  }

  void presetsAreSavedLoadedRenamedDeletedAndTakenBack() {
    TuneFixture f;
    f.page->tabs()->setCurrentWidget(f.page->presets());
    f.type("control.kp", QStringLiteral("0.3"));
    f.type("texture.k_vib", QStringLiteral("2"));
    f.enter(f.page->presets()->nameField(), QStringLiteral("soft"));
    QCOMPARE(f.presets(), QStringList{QStringLiteral("soft")});
    QVERIFY(QFileInfo::exists(f.folder.filePath(QStringLiteral("presets/soft.toml"))));
    f.model().undo();  // the saving
    QVERIFY(f.presets().isEmpty());
    f.model().redo();
    QVERIFY(f.model().revertAll().has_value());
    QCOMPARE(f.used("control.kp"), 0.15);
    const int steps = f.model().undoStack()->count();
    f.choosePreset(QStringLiteral("soft"));
    click(f.page->presets()->loadButton());
    QCOMPARE(f.used("control.kp"), 0.3);
    QCOMPARE(f.used("texture.k_vib"), 2.0);
    QCOMPARE(f.model().undoStack()->count(), steps + 1);
    f.model().undo();
    QCOMPARE(f.used("control.kp"), 0.15);
    QCOMPARE(f.used("texture.k_vib"), 1.0);

    f.choosePreset(QStringLiteral("soft"));
    f.page->presets()->nameField()->setText(QStringLiteral("softer"));
    click(f.page->presets()->renameButton());
    QCOMPARE(f.presets(), QStringList{QStringLiteral("softer")});
    f.choosePreset(QStringLiteral("softer"));
    click(f.page->presets()->removeButton());
    QVERIFY(f.presets().isEmpty());
    f.model().undo();
    QCOMPARE(f.presets(), QStringList{QStringLiteral("softer")});
    f.model().undo();
    QCOMPARE(f.presets(), QStringList{QStringLiteral("soft")});
    QMenu* menu = f.window->operate()->tuning()->presetButton()->menu();
    emit menu->aboutToShow();
    QCOMPARE(menu->actions().size(), 1);
    menu->actions().front()->trigger();
    QCOMPARE(f.used("control.kp"), 0.3);
  }

  void calibratedValuesAreOneTouchpadsAndInNoPreset() {
    TuneFixture f;
    constexpr const char* kCalibrated = "sensing.finger_threshold";
    f.type(kCalibrated, QStringLiteral("91"));
    QCOMPARE(f.used(kCalibrated), 91.0);
    f.page->tabs()->setCurrentWidget(f.page->presets());
    f.enter(f.page->presets()->nameField(), QStringLiteral("here"));
    f.choosePreset(QStringLiteral("here"));
    click(f.page->presets()->removeButton());
    QVERIFY(f.presets().isEmpty());
    QVERIFY(QDir(f.folder.path()).mkpath(QStringLiteral("presets")));
    QFile older(f.folder.filePath(QStringLiteral("presets/older.toml")));
    QVERIFY(older.open(QIODevice::WriteOnly));
    older.write("[sensing]\nfinger_threshold = 92\n[texture]\nk_vib = 2\n");
    older.close();
    QVERIFY(f.model().anyChanged());
    // Another touchpad: its own value is the saved one, and nothing leads back to the former one's.
    station::Profile other = f.session->profile;
    other.calibrated_on = "serial:B2";
    other.step.sensing.finger.threshold = 55;
    f.session->arrives_with = other;
    f.session->changes.clear();
    changeDevices(f, {.touchpad = "modbus-tcp:10.0.0.7:502"});
    QCOMPARE(f.value(kCalibrated), 55.0);
    QVERIFY(!f.model().anyChanged());
    QVERIFY(f.model().revertAll().has_value());
    // What is of no touchpad can still be taken back: a deleted preset has no other copy.
    f.model().undo();
    QCOMPARE(f.presets(), (QStringList{QStringLiteral("here"), QStringLiteral("older")}));
    f.model().undo();  // the saving of it
    QCOMPARE(f.presets(), QStringList{QStringLiteral("older")});
    for (int i = 0; i < 2; ++i) f.model().undo();
    for (int i = 0; i < 4; ++i) f.model().redo();
    QCOMPARE(f.presets(), QStringList{QStringLiteral("older")});
    f.model().undo();
    QVERIFY(f.session->changes.empty());
    QCOMPARE(f.value(kCalibrated), 55.0);
    f.window->frame()->go(QStringLiteral("operate"));
    f.window->frame()->go(QStringLiteral("tune"));
    for (const char* preset : {"here", "older"}) {
      f.choosePreset(QLatin1String(preset));
      click(f.page->presets()->loadButton());
      QCOMPARE(f.used(kCalibrated), 55.0);
    }
    QCOMPARE(f.used("texture.k_vib"), 2.0);
    // A session of the same touchpad leaves both.
    f.type(kCalibrated, QStringLiteral("60"));
    changeDevices(f, {.touchpad = "modbus-tcp:10.0.0.7:502", .robot = "none"});
    QVERIFY(std::as_const(f.model()).find(kCalibrated)->changed());
    f.model().undo();
    QCOMPARE(f.used(kCalibrated), 55.0);
  }

  void badPresetsAndNamesChangeNothingAndSayWhy() {
    TuneFixture f;
    f.page->tabs()->setCurrentWidget(f.page->presets());
    for (const char* name : {"../evil", "a/b", ".hidden", " a", "a.b"}) {
      f.enter(f.page->presets()->nameField(), QLatin1String(name));
      QVERIFY2(f.page->presets()->words().contains(QStringLiteral("expected")), name);
      QVERIFY(f.page->presets()->nameField()->property("refused").toBool());
    }
    QVERIFY(f.presets().isEmpty());
    QVERIFY(QDir(f.folder.path()).mkdir(QStringLiteral("presets")));
    QFile bad(f.folder.filePath(QStringLiteral("presets/bad.toml")));
    QVERIFY(bad.open(QIODevice::WriteOnly));
    bad.write("[texture]\nk_vib = 2\n[control]\nkp = -1\n");
    bad.close();
    f.window->frame()->go(QStringLiteral("operate"));
    f.window->frame()->go(QStringLiteral("tune"));
    f.choosePreset(QStringLiteral("bad"));
    QTest::keyClick(f.page->presets()->list(), Qt::Key_Return);
    QVERIFY2(f.page->presets()->words().contains(QStringLiteral("bad.toml:4")), qPrintable(f.page->presets()->words()));
    QVERIFY(f.session->changes.empty());  // not even k_vib, which was good
    f.enter(f.page->presets()->nameField(), QStringLiteral("good"));
    f.choosePreset(QStringLiteral("bad"));
    f.page->presets()->nameField()->setText(QStringLiteral("good"));
    click(f.page->presets()->renameButton());
    QVERIFY(f.page->presets()->words().contains(QStringLiteral("there is one of this name")));
  }

  void theStepResponseFollowsTheGains() {
    TuneFixture f;
    WAIT_FOR(f.page->response()->has(TuningResponse::current));
    QCOMPARE(f.page->response()->response(TuningResponse::current).verdict, control::LoopVerdict::settles);
    const double before = f.page->response()->response(TuningResponse::current).settling_s;
    QCOMPARE(f.page->response()->response(TuningResponse::saved).settling_s, before);
    f.type("control.ki", QStringLiteral("0.5"));
    WAIT_FOR(f.page->response()->response(TuningResponse::current).settling_s != before);
    QCOMPARE(f.page->response()->response(TuningResponse::saved).settling_s, before);
    f.type("control.ki", QStringLiteral("0"));
    f.type("control.kp", QStringLiteral("0"));
    WAIT_EQUAL(f.page->response()->response(TuningResponse::current).verdict, control::LoopVerdict::does_not_settle);
    QCOMPARE(f.page->response()->figure(TuningResponse::current, 4), QStringLiteral("—"));  // no gain, no margin
    QCOMPARE(f.page->response()->figure(TuningResponse::proposed, 0), QStringLiteral("—"));
  }

  void whatIsSaidOfTheMotorsFollowsThemWhileThePlaceIsOpen() {
    TuneFixture f;  // before the first answer, as a window that was closed here begins
    const QString none = QStringLiteral("The motors have not answered yet");
    QVERIFY2(f.page->response()->ground().contains(none), qPrintable(f.page->response()->ground()));
    const auto hear = [&](double age_ms, int samples = 1) {
      for (int i = 0; i < samples; ++i) {
        f.session->say(pipeline::SafetyState::ready);
        f.session->telemetry.back().motors_age_ms = age_ms;
      }
      f.window->feed().pump();
    };
    hear(3.5);
    WAIT_FOR(!f.page->response()->ground().contains(none));
    QVERIFY2(f.page->response()->ground().contains(QStringLiteral("3.5 ms old")),
             qPrintable(f.page->response()->ground()));
    hear(5.5, 4000);
    WAIT_FOR(f.page->response()->ground().contains(QStringLiteral("5.")));
    changeDevices(f, {.touchpad = "modbus-tcp:10.0.0.7:502"});  // of another it is not known yet
    WAIT_FOR(f.page->response()->ground().contains(none));
  }

  void whatTheLoopsModelCallsUnstableIsAskedFirst() {
    TuneFixture f;
    // The touchpad's motors have not answered: only what no touchpad bears is asked about.
    f.type("control.kp", QStringLiteral("6"));
    QCOMPARE(f.used("control.kp"), 6.0);
    f.type("control.kp", QStringLiteral("20"));
    QCOMPARE(f.used("control.kp"), 6.0);
    widgets::TuningRow* row = f.page->list()->row(QStringLiteral("control.kp"));
    QVERIFY(row->questionBox()->isVisible());
    QVERIFY2(row->questionBox()->words().contains(QStringLiteral("on any touchpad")),
             qPrintable(row->questionBox()->words()));
    const widgets::TuningRow* other = f.window->operate()->tuning()->row(QStringLiteral("control.kp"));
    QVERIFY(other->questionBox() != nullptr);              // the same question in the other place
    emit f.model().changed(QStringLiteral("control.kp"));  // as Ctrl+S: what is asked about still stands there
    QVERIFY(row->questionBox()->isVisible());
    QCOMPARE(row->field()->text(), QStringLiteral("20"));
    QCOMPARE(other->field()->text(), QStringLiteral("20"));
    QTest::keyClick(row->questionBox()->leaveButton(), Qt::Key_Return);
    QCOMPARE(f.used("control.kp"), 6.0);
    QVERIFY(f.page->response()->plot()->hasFocus());
    f.type("control.kp", QStringLiteral("0.15"));
    QVERIFY(f.page->response()->plot()->hasFocus());
    // Motors that answer 20 ms late bear less, and the sentence says why.
    pipeline::TelemetrySample sample;
    sample.now = instantAt(0.001);
    sample.motors_age_ms = 20.0;
    f.session->telemetry = {sample};
    f.window->feed().pump();
    f.type("control.kp", QStringLiteral("6"));
    QCOMPARE(f.used("control.kp"), 0.15);
    QVERIFY2(row->questionBox()->words().contains(QStringLiteral("20.0 ms")), qPrintable(row->questionBox()->words()));
    click(row->questionBox()->applyButton());
    QCOMPARE(f.used("control.kp"), 6.0);
    WAIT_EQUAL(f.page->response()->response(TuningResponse::current).verdict, control::LoopVerdict::unstable);
    QVERIFY(f.page->response()->ground().contains(QStringLiteral("20.0 ms")));
    QCOMPARE(f.page->response()->figure(TuningResponse::current, 1), QStringLiteral("—"));  // it never settles
    f.type("texture.k_vib", QStringLiteral("5"));  // nothing of the loop: not asked
    QCOMPARE(f.used("texture.k_vib"), 5.0);
    QTest::keyClick(f.page, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);  // all back to saved: steady
    QCOMPARE(f.used("control.kp"), 0.15);
    QTest::keyClick(f.page, Qt::Key_Z, Qt::ControlModifier);  // undo would be unstable again
    QCOMPARE(f.used("control.kp"), 0.15);
    QVERIFY(f.page->foot()->questionBox()->isVisible());
    click(f.page->foot()->questionBox()->leaveButton());
    QCOMPARE(f.used("control.kp"), 0.15);
  }

  void anUnstablePresetIsAskedFirst() {
    TuneFixture f;
    QVERIFY(QDir(f.folder.path()).mkdir(QStringLiteral("presets")));
    QFile file(f.folder.filePath(QStringLiteral("presets/wild.toml")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("[texture]\nk_vib = 2\n[control]\nkp = 20\n");
    file.close();
    f.window->frame()->go(QStringLiteral("operate"));
    f.window->frame()->go(QStringLiteral("tune"));
    f.choosePreset(QStringLiteral("wild"));
    QTest::keyClick(f.page->presets()->list(), Qt::Key_Return);
    QVERIFY(f.session->changes.empty());
    QVERIFY(f.page->foot()->questionBox()->isVisible());
    click(f.page->foot()->questionBox()->applyButton());
    QCOMPARE(f.used("control.kp"), 20.0);
    QCOMPARE(f.used("texture.k_vib"), 2.0);
  }

  void twoGainsAreComparedWithFourClicks() {
    Fixture f;
    f.window->frame()->go(QStringLiteral("tune"));  // 1: the place
    const auto* page = qobject_cast<console::TunePage*>(f.window->frame()->page(QStringLiteral("tune")));
    widgets::TuningRow* row = page->list()->row(QStringLiteral("control.kp"));
    WAIT_FOR(row->isVisible());
    QVERIFY2(!row->field()->visibleRegion().isEmpty(), "the gains are in sight without a search");
    QTest::mouseClick(row->field(), Qt::LeftButton);  // 2: its number, all of which is taken
    WAIT_FOR(row->field()->hasSelectedText());
    QTest::keyClicks(row->field(), QStringLiteral("0.3"));
    QTest::keyClick(row->field(), Qt::Key_Return);
    click(page->compare()->savedButton());  // 3
    QCOMPARE(f.session->profile.step.control.kp, 0.15);
    click(page->compare()->currentButton());  // 4
    QCOMPARE(f.session->profile.step.control.kp, 0.3);
  }

  void enterInTheSearchGoesToWhatItFound() {
    TuneFixture f;
    QTest::keyClick(f.window.get(), Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(f.page->list()->search(), QStringLiteral("dead zone"));
    QTest::keyClick(f.page->list()->search(), Qt::Key_Return);
    QVERIFY(f.page->list()->row(QStringLiteral("texture.dead_zone_percent"))->field()->hasFocus());
  }

  void autoTuneProposesAndOnlyAcceptApplies() {
    TuneFixture f;
    f.type("control.ki", QStringLiteral("0.5"));
    f.session->changes.clear();
    QTest::keyClick(f.page, Qt::Key_U, Qt::ControlModifier);
    QVERIFY(f.page->proposal()->cancelButton()->isEnabled());
    QVERIFY(!f.page->proposal()->acceptButton()->isEnabled());
    WAIT_FOR(f.page->proposal()->hasProposal());
    QVERIFY(f.session->changes.empty());
    QCOMPARE(f.page->proposal()->table()->rowCount(), 6);
    QVERIFY(f.page->response()->has(TuningResponse::proposed));
    const double proposed = f.page->study().proposal()->proposed.ki_per_s;
    QVERIFY(proposed > 0.5);
    const int steps = f.model().undoStack()->count();
    click(f.page->proposal()->acceptButton());
    QCOMPARE(f.used("control.ki"), proposed);
    QCOMPARE(f.model().undoStack()->count(), steps + 1);
    QVERIFY(!f.page->proposal()->acceptButton()->isEnabled());
    f.model().undo();
    QCOMPARE(f.used("control.ki"), 0.5);
    QCOMPARE(f.used("control.measurement_lag_s"), 0.25);
  }

  void aProposalThatIsAppliedAfterAQuestionIsSaidToBeInUse() {
    TuneFixture f;
    f.type("control.ki", QStringLiteral("0.5"));
    f.page->tabs()->setCurrentWidget(f.page->proposal());
    click(f.page->proposal()->startButton());
    WAIT_FOR(f.page->proposal()->hasProposal());
    const double proposed = f.page->study().proposal()->proposed.ki_per_s;
    f.model().setDoubt([](std::span<const widgets::Setting>) { return QStringLiteral("By the script."); });
    click(f.page->proposal()->acceptButton());
    QVERIFY(f.model().question());
    f.model().leaveAsItIs();
    passTimers(20);
    QVERIFY(f.page->proposal()->hasProposal());
    QCOMPARE(f.used("control.ki"), 0.5);
    click(f.page->proposal()->acceptButton());
    f.model().applyAnyway();
    QCOMPARE(f.used("control.ki"), proposed);
    WAIT_FOR(f.page->proposal()->words().startsWith(QStringLiteral("Accepted")));
    QVERIFY(!f.page->proposal()->acceptButton()->isEnabled());
  }

  void whatIsAskedAboutAProposalGoesWithIt() {
    TuneFixture f;
    f.type("control.ki", QStringLiteral("0.5"));
    f.page->tabs()->setCurrentWidget(f.page->proposal());
    f.model().setDoubt([](std::span<const widgets::Setting>) { return QStringLiteral("By the script."); });
    f.session->changes.clear();
    const auto accept = [&] {
      WAIT_FOR(f.page->proposal()->hasProposal());
      click(f.page->proposal()->acceptButton());
      QVERIFY(f.model().question());
    };
    click(f.page->proposal()->startButton());
    accept();
    click(f.page->proposal()->startButton());  // another proposal is wanted
    QVERIFY(!f.model().question());
    accept();
    click(f.page->proposal()->discardButton());
    QVERIFY(!f.model().question());
    f.model().applyAnyway();
    QVERIFY(f.session->changes.empty());
    // What was asked in its place is about something else.
    click(f.page->proposal()->startButton());
    accept();
    QVERIFY(f.model().change("control.kp", 0.3).has_value());
    passTimers(20);
    click(f.page->proposal()->discardButton());
    QVERIFY(f.model().question());
    f.model().applyAnyway();
    QCOMPARE(f.used("control.kp"), 0.3);
    QCOMPARE(f.used("control.ki"), 0.5);
  }

  void autoTuneCancelledOrDiscardedChangesNothing() {
    TuneFixture f;
    const QSignalSpy proposed(&f.page->study(), &console::LoopStudy::proposed);
    f.page->tabs()->setCurrentWidget(f.page->proposal());
    click(f.page->proposal()->startButton());
    click(f.page->proposal()->cancelButton());
    QVERIFY(f.page->proposal()->startButton()->isEnabled());
    QVERIFY(!f.page->proposal()->hasProposal());
    QVERIFY(f.page->proposal()->words().contains(QStringLiteral("Cancelled")));
    click(f.page->proposal()->startButton());
    WAIT_FOR(f.page->proposal()->hasProposal());
    QCOMPARE(proposed.count(), 1);  // the first would have come before the second, for it began before it
    click(f.page->proposal()->discardButton());
    QVERIFY(!f.page->study().proposal().has_value());
    // A session in which nothing has moved says too little, and is told so.
    f.page->proposal()->sources()->setCurrentIndex(1);
    click(f.page->proposal()->startButton());
    WAIT_FOR(f.page->proposal()->words().contains(QStringLiteral("expected")));
    QVERIFY(f.session->changes.empty());
  }

  void autoTuneReadsTheLastMinuteOfTheSession() {
    TuneFixture f;
    control::ControlParameters parameters;
    const control::StaticLaw law(parameters);
    const auto second = [&](int number) {
      std::vector<pipeline::TelemetrySample> samples(1000);
      const double scale = number < 20 ? 1.4 : 1.1;  // another cloth, more than a minute before the end
      for (int i = 0; i < 1000; ++i) {
        pipeline::TelemetrySample& sample = samples[static_cast<std::size_t>(i)];
        const double t_s = number + i * 0.001;
        sample.now = instantAt(t_s);
        sample.stretch_measured_deg = control::excitationAngle_deg(t_s, parameters);
        sample.stiffness_N_per_mm = scale * law.stiffness_N_per_mm(sample.stretch_measured_deg).value;
        sample.stiffness_observable = true;
      }
      return samples;
    };
    for (int i = 0; i < 80; ++i) f.page->study().listen(second(i));
    const auto heard = static_cast<double>(f.page->study().heard());
    // Samples 10 to 11 ms apart.
    QVERIFY2(heard > 5450 && heard <= 6001, qPrintable(QString::number(heard)));
    f.page->tabs()->setCurrentWidget(f.page->proposal());
    f.page->proposal()->sources()->setCurrentIndex(1);
    click(f.page->proposal()->startButton());
    WAIT_FOR(f.page->proposal()->hasProposal());
    QVERIFY(std::abs(f.page->study().proposal()->cloth.scale - 1.1) < 0.02);
    const auto first = second(0);
    f.page->study().listen(std::span(first).first(10));  // time goes back: another session
    QCOMPARE(f.page->study().heard(), std::size_t{1});
    // Also one that begins anew with a calibration, whose time goes on.
    f.window->feed().restart();
    QCOMPARE(f.page->study().heard(), std::size_t{0});
    QVERIFY(!f.page->study().proposal());
  }

  void whatTheDevicesReadBackStandsBesideWhatWasAsked() {
    TuneFixture f;
    device::DeviceReport camera{.part = device::Part::camera};
    camera.controls = {{.name = say("brightness"), .wanted = 40.0, .actual = 40.0, .supported = true},
                       {.name = say("contrast"), .wanted = 40.0, .actual = 55.0, .supported = true},
                       {.name = say("exposure"), .wanted = 40.0}};
    f.session->reports = {camera};
    pipeline::TelemetrySample sample;
    sample.now = instantAt(0.001);
    sample.stretch_reference_deg = 45.0;
    sample.stretch_measured_deg = 44.8;
    f.session->telemetry = {sample};
    f.type("control.kp", QStringLiteral("0.3"));  // and no answer yet
    f.window->feed().pump();
    f.window->frame()->go(QStringLiteral("operate"));
    f.window->frame()->go(QStringLiteral("tune"));
    const auto said = [&](int row) { return f.page->readback()->table()->item(row, 3)->text(); };
    QCOMPARE(f.page->readback()->table()->rowCount(), 7);
    QCOMPARE(said(0), QStringLiteral("differs"));
    QCOMPARE(said(1), QStringLiteral("confirmed"));
    QCOMPARE(said(2), QStringLiteral("confirmed"));
    QCOMPARE(said(3), QStringLiteral("differs"));
    QCOMPARE(said(4), QStringLiteral("cannot be read back"));
    QCOMPARE(said(5), QStringLiteral("cannot be read back"));
    f.answer("control.kp", 0.3);
    WAIT_EQUAL(said(0), QStringLiteral("confirmed"));
  }

  void aTouchpadThatAnotherProgramHasIsNotBlamedOnItsCable() {
    Fixture f;
    const auto told = [&](bool in_use) {
      f.session->present.touchpad = "modbus-tcp:10.0.0.7:502";
      f.session->reports = {{.part = device::Part::touchpad, .in_use = in_use}};
      f.session->lines = {{.what = say("Motors answer"),
                           .ok = false,
                           .why = phrase(toString(pipeline::Fault::motors_stale)),
                           .remedy = say("Check the touchpad's power and its cable."),
                           .fault = pipeline::Fault::motors_stale}};
      f.session->say(pipeline::SafetyState::disconnected);
      f.session->telemetry.back().fault = pipeline::Fault::motors_stale;
      f.window->feed().pump();
      return f.window->stateBar()->stateReason();
    };
    const QString taken = told(true);
    QVERIFY2(taken.startsWith(QStringLiteral("Another program drives the touchpad. Close what has it at 10.0.0.7:502")),
             qPrintable(taken));
    QVERIFY2(!taken.contains(QStringLiteral("cable")) && !taken.contains(QStringLiteral("silent")), qPrintable(taken));
    const QString silent = told(false);
    QVERIFY2(silent.contains(QStringLiteral("silent")) && silent.contains(QStringLiteral("network cable to 10.0.0.7")),
             qPrintable(silent));
  }

  void readinessSaysWhyAndHowAndLeadsToWhereItIsMended() {
    Fixture f;
    f.session->lines = {{.what = say("Motors answer"),
                         .ok = false,
                         .why = say("the motors are silent"),
                         .remedy = say("Check the touchpad's power and its serial cable."),
                         .fault = pipeline::Fault::motors_stale},
                        {.what = say("Stiffness target known"),
                         .ok = false,
                         .why = say("no stiffness target"),
                         .remedy = say("Choose the robot's stiffness or set one by hand."),
                         .fault = pipeline::Fault::no_target},
                        {.what = say("Camera sees"), .ok = true},
                        {.what = say("Load cell in span"),
                         .ok = false,
                         .why = say("the load cell's value is outside its span"),
                         .fault = pipeline::Fault::bridge_invalid}};
    f.window->feed().pump();
    const widgets::ReadinessList* list = f.window->operate()->readiness();
    QVERIFY2(list->title().contains(QStringLiteral("1/4")), qPrintable(list->title()));
    QStringList words;
    for (const QLabel* label : list->findChildren<QLabel*>()) words << label->text();
    QVERIFY(words.contains(QStringLiteral("The motors are silent")));
    QVERIFY(words.contains(QStringLiteral("Check the touchpad's power and its serial cable.")));
    WAIT_EQUAL(list->findChildren<QToolButton*>().size(), 3);  // the former lines go with the next event
    const auto* by_hand = list->findChild<QToolButton*>(QStringLiteral("mend_session.target_by_hand"));
    WAIT_FOR(by_hand->isVisible());  // laid out with the next event
    click(list->findChild<QToolButton*>(QStringLiteral("mend_session.target_by_hand")));
    QCOMPARE(f.session->count(pipeline::OperatorAction::target_by_hand), 1);
    click(list->findChild<QToolButton*>(QStringLiteral("mend_place.devices")));
    QCOMPARE(f.window->frame()->place(), QStringLiteral("devices"));
    f.window->frame()->go(QStringLiteral("operate"));
    click(list->findChild<QToolButton*>(QStringLiteral("mend_calibrate:load-cell")));
    QCOMPARE(f.window->frame()->place(), QStringLiteral("calibrate"));
    const auto* parts = f.window->findChild<console::CalibrationPartList*>();
    QVERIFY(parts->currentItem()->text().contains(QStringLiteral("Load cell")));
  }
};

std::unique_ptr<QObject> makeTuneTest() { return std::make_unique<TuneTest>(); }

}  // namespace fyd::tests

#include "tune_test.moc"
