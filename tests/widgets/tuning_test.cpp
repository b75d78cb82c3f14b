// The tuning panel: slider, field and parameter are one; bad entries change nothing; every change can be undone.
#include "tests/widgets/suite.h"
#include "tests/widgets/wait.h"
#include "widgets/tuning/tuning_panel.h"

namespace fyd::tests {
namespace {

enum class Method { first, second, third };
constexpr std::array<std::string_view, 3> kMethods = {"first", "second", "third"};

struct Tuned {
  double target = 0.6;
  double gain = 0.1;
  int count = 3;
  double percent = 25;
  Method method = Method::first;
  template <class Visitor>
  void describe(Visitor& v) {
    v.real("a.target", target, {.unit = "N/mm", .minimum = 0.05, .maximum = 3, .help = "Target.", .live = true});
    v.real("a.gain", gain, {.minimum = 0, .maximum = 1e12, .help = "Gain.", .live = true});
    v.integer("a.count", count, {.name = "Count", .minimum = 1, .maximum = 9, .help = "Count.", .live = true});
    v.real("a.percent", percent, {.unit = "%", .minimum = 0, .maximum = 100, .help = "Share.", .live = true});
    v.choice("a.method", method, kMethods, {.help = "Method.", .live = true});
  }
};

struct TuningFixture {
  TuningFixture() {
    Tuned current;
    Tuned standard;
    current.percent = 30;
    model.load(bindParameters(current), bindParameters(standard));
    const std::vector<widgets::TuningSection> sections = {{QStringLiteral("Softness"),
                                                           widgets::Quantity::stiffness,
                                                           {{QStringLiteral("a.target"), QStringLiteral("Target")},
                                                            {QStringLiteral("a.gain"), QStringLiteral("Kp")},
                                                            {QStringLiteral("a.count"), {}},
                                                            {QStringLiteral("a.absent"), QStringLiteral("Absent")}}},
                                                          {QStringLiteral("Texture"),
                                                           widgets::Quantity::vibration,
                                                           {{QStringLiteral("a.percent"), QStringLiteral("Dead zone")},
                                                            {QStringLiteral("a.method"), QStringLiteral("Method")}}}};
    panel = std::make_unique<widgets::TuningPanel>(model, sections, QStringLiteral("a.target"));
    panel->resize(270, 600);
    panel->show();
    (void)QTest::qWaitForWindowActive(panel.get(), kPatience_ms);
  }
  double value(const char* id) const { return model.find(id)->value; }
  void type(const char* id, const QString& text) const {
    QLineEdit* field = panel->row(QLatin1String(id))->field();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
  }
  widgets::TuningModel model;
  std::unique_ptr<widgets::TuningPanel> panel;
};

}  // namespace

class TuningTest : public QObject {
  Q_OBJECT
 private slots:
  void sliderFieldAndParameterAreOne() {
    TuningFixture f;
    QSignalSpy asked(&f.model, &widgets::TuningModel::asked);
    widgets::TuningRow* row = f.panel->row(QStringLiteral("a.percent"));
    row->slider()->setValue(row->slider()->maximum() / 2);
    QCOMPARE(f.value("a.percent"), 50.0);
    QCOMPARE(row->field()->text(), QStringLiteral("50"));
    QCOMPARE(asked.last()[0].toString(), QStringLiteral("a.percent"));
    QCOMPARE(asked.last()[1].toDouble(), 50.0);
    f.type("a.percent", QStringLiteral("12,5"));
    QCOMPARE(f.value("a.percent"), 12.5);
    QCOMPARE(row->slider()->value(), 50);  // an eighth of 400 steps
    QCOMPARE(asked.count(), 2);            // setting the slider from the field asks for nothing
    QTest::keyClick(row->slider(), Qt::Key_Right);
    QVERIFY(f.value("a.percent") > 12.5);
  }

  void aSliderOfAWholeNumberHasNothingBetweenThem() {
    TuningFixture f;
    QSignalSpy refused(f.panel.get(), &widgets::TuningPanel::refused);
    QSlider* slider = f.panel->row(QStringLiteral("a.count"))->slider();
    for (int position = 0; position <= slider->maximum(); ++position) {
      slider->setValue(position);
      QCOMPARE(f.value("a.count"), 1.0 + position);
      QCOMPARE(slider->value(), position);
    }
    QCOMPARE(f.value("a.count"), 9.0);
    QCOMPARE(refused.count(), 0);
  }

  void aSliderThatIsRefusedGoesBackToTheValueInUse() {
    TuningFixture f;
    QSignalSpy refused(f.panel.get(), &widgets::TuningPanel::refused);
    QSlider* slider = f.panel->row(QStringLiteral("a.percent"))->slider();
    const int saved = slider->value();
    f.type("a.percent", QStringLiteral("12.5"));
    f.model.feelSaved(true);
    slider->setValue(slider->maximum());
    QCOMPARE(refused.count(), 1);
    QCOMPARE(slider->value(), saved);
  }

  void everyFieldRefusesWhatIsOutOfPlace() {
    TuningFixture f;
    QSignalSpy refused(f.panel.get(), &widgets::TuningPanel::refused);
    int tried = 0;
    for (widgets::TuningRow* row : f.panel->rows()) {
      if (row->field() == nullptr) continue;
      const std::string id = row->id().toStdString();
      const double before = f.value(id.c_str());
      for (const char* entry : {"", "abc", "nan", "inf", "-inf", "1e999", "-1", "1e13", "1.2.3", "0x10", "5 N"}) {
        f.type(id.c_str(), QLatin1String(entry).isEmpty() ? QString() : QLatin1String(entry));
        if (*entry == '\0') {
          row->field()->clear();
          row->field()->setModified(true);
          QTest::keyClick(row->field(), Qt::Key_Return);
        }
        ++tried;
        QCOMPARE(f.value(id.c_str()), before);
        QCOMPARE(refused.count(), tried);
        QVERIFY(refused.last()[0].toString().contains(QStringLiteral("Expected")));
      }
    }
    QCOMPARE(tried, 4 * 11);
    f.type("a.count", QStringLiteral("2.5"));
    QCOMPARE(f.value("a.count"), 3.0);
    f.type("a.count", QStringLiteral("7"));
    QCOMPARE(f.value("a.count"), 7.0);
  }

  void refusedEntryIsReplacedByTheValueWhenTheFieldIsLeft() {
    TuningFixture f;
    f.type("a.target", QStringLiteral("99"));
    QLineEdit* field = f.panel->row(QStringLiteral("a.target"))->field();
    QVERIFY(field->property("refused").toBool());
    QCOMPARE(field->selectedText(), QStringLiteral("99"));  // the next key writes another value
    f.panel->row(QStringLiteral("a.gain"))->field()->setFocus();
    QCOMPARE(field->text(), QStringLiteral("0.6"));
    QVERIFY(!field->property("refused").toBool());
  }

  void aNumberThatIsLeftWithoutEnterIsSetBack() {
    TuningFixture f;
    QSignalSpy asked(&f.model, &widgets::TuningModel::asked);
    QLineEdit* field = f.panel->row(QStringLiteral("a.target"))->field();
    const auto write = [&] {
      field->setFocus();
      field->selectAll();
      QTest::keyClicks(field, QStringLiteral("2"));  // of 2.5, say
    };
    const auto leave = [&](Qt::FocusReason reason) {
      QFocusEvent out(QEvent::FocusOut, reason);
      QApplication::sendEvent(field, &out);
    };
    const auto ways = {
        std::function([&] { QTest::keyClick(field, Qt::Key_Tab); }),
        std::function([&] { f.panel->row(QStringLiteral("a.gain"))->field()->setFocus(); }),
        std::function([&] { leave(Qt::ActiveWindowFocusReason); }),  // another window comes to the front
    };
    for (const auto& way : ways) {
      write();
      leave(Qt::PopupFocusReason);  // the field's own menu
      QCOMPARE(field->text(), QStringLiteral("2"));
      way();
      QCOMPARE(f.value("a.target"), 0.6);
      QCOMPARE(field->text(), QStringLiteral("0.6"));
      QVERIFY(!field->isModified());
    }
    QCOMPARE(asked.count(), 0);
  }

  void everyChangeIsUndoneAndADragIsOneChange() {
    TuningFixture f;
    widgets::TuningRow* row = f.panel->row(QStringLiteral("a.percent"));
    for (int i = 130; i < 200; ++i) row->slider()->setValue(i);
    f.type("a.gain", QStringLiteral("0.3"));
    f.panel->row(QStringLiteral("a.method"))->choice()->setFocus();
    QTest::keyClick(f.panel->row(QStringLiteral("a.method"))->choice(), Qt::Key_Down);
    QCOMPARE(f.value("a.method"), 1.0);
    QCOMPARE(f.model.undoStack()->count(), 3);
    auto* undo = f.panel->findChild<QToolButton*>(QStringLiteral("undo_button"));
    for (int i = 0; i < 3; ++i) QTest::mouseClick(undo, Qt::LeftButton);
    QVERIFY(!undo->isEnabled());
    QCOMPARE(f.value("a.percent"), 30.0);
    QCOMPARE(f.value("a.gain"), 0.1);
    QCOMPARE(f.value("a.method"), 0.0);
    QTest::mouseClick(f.panel->findChild<QToolButton*>(QStringLiteral("redo_button")), Qt::LeftButton);
    QVERIFY(f.value("a.percent") > 40.0);
  }

  void resetGoesToTheDefaultAndTheMarkTellsWhatIsNotSaved() {
    TuningFixture f;
    QVERIFY(!f.model.anyChanged());  // 30 is what the profile has, though not the default
    widgets::TuningRow* row = f.panel->row(QStringLiteral("a.percent"));
    QVERIFY(row->resetButton()->isVisible());
    QTest::mouseClick(row->resetButton(), Qt::LeftButton);
    QCOMPARE(f.value("a.percent"), 25.0);
    QVERIFY(!row->resetButton()->isVisible());
    QVERIFY(f.model.anyChanged());
    f.model.markSaved();
    QVERIFY(!f.model.anyChanged());
  }

  void changesFromElsewhereAreShownAndNotAskedForAgain() {
    TuningFixture f;
    QSignalSpy asked(&f.model, &widgets::TuningModel::asked);
    f.model.accept("a.percent", 40.0);
    QCOMPARE(f.panel->row(QStringLiteral("a.percent"))->field()->text(), QStringLiteral("40"));
    QCOMPARE(asked.count(), 0);
    QCOMPARE(f.model.undoStack()->count(), 0);
  }

  void whatIsBeingWrittenStaysThoughTheValueChangesElsewhere() {
    TuningFixture f;
    widgets::TuningRow* row = f.panel->row(QStringLiteral("a.percent"));
    for (const bool refused : {false, true}) {
      const QString entry = refused ? QStringLiteral("999") : QStringLiteral("4");
      row->field()->setFocus();
      row->field()->selectAll();
      QTest::keyClicks(row->field(), entry);
      if (refused) QTest::keyClick(row->field(), Qt::Key_Return);
      f.model.accept("a.percent", refused ? 60.0 : 50.0);
      emit widgets::Look::instance().changed();
      QCOMPARE(row->field()->text(), entry);
      QCOMPARE(row->field()->property("refused").toBool(), refused);
      QCOMPARE(row->slider()->value(), refused ? 240 : 200);
    }
    f.type("a.percent", QStringLiteral("45"));
    QCOMPARE(f.value("a.percent"), 45.0);
    QCOMPARE(row->field()->text(), QStringLiteral("45"));
  }

  /// Gains from 5 up are doubted, as the loop's model doubts some.
  static void doubtLargeGains(widgets::TuningModel& model) {
    model.setDoubt([](std::span<const widgets::Setting> next) {
      const auto large = [](const widgets::Setting& each) { return each.id == "a.gain" && each.value >= 5.0; };
      return std::ranges::any_of(next, large) ? QStringLiteral("It would swing.") : QString();
    });
  }

  void aDoubtedEntryWaitsInItsRowAndEnterLeavesTheValue() {
    TuningFixture f;
    doubtLargeGains(f.model);
    QSignalSpy asked(&f.model, &widgets::TuningModel::asked);
    QSignalSpy entered(f.panel.get(), &widgets::TuningPanel::entered);
    widgets::TuningRow* row = f.panel->row(QStringLiteral("a.gain"));
    f.type("a.gain", QStringLiteral("7"));
    QCOMPARE(asked.count(), 0);
    QCOMPARE(f.value("a.gain"), 0.1);
    QCOMPARE(entered.count(), 0);
    QVERIFY(row->questionBox() != nullptr && row->questionBox()->isVisible());
    QVERIFY(row->questionBox()->words().startsWith(QStringLiteral("It would swing.")));
    QCOMPARE(row->field()->text(), QStringLiteral("7"));
    QVERIFY(row->questionBox()->leaveButton()->hasFocus());
    QVERIFY(QApplication::activeModalWidget() == nullptr);
    QTest::keyClick(row->questionBox()->leaveButton(), Qt::Key_Return);
    QVERIFY(row->questionBox()->isHidden());
    QCOMPARE(row->field()->text(), QStringLiteral("0.1"));
    QCOMPARE(entered.count(), 1);
    QCOMPARE(asked.count(), 0);
    QCOMPARE(f.model.undoStack()->count(), 0);

    f.type("a.gain", QStringLiteral("8"));
    QTest::mouseClick(row->questionBox()->applyButton(), Qt::LeftButton);
    QCOMPARE(f.value("a.gain"), 8.0);
    QCOMPARE(asked.count(), 1);
    QVERIFY(row->questionBox()->isHidden());
    f.model.undo();  // back to what is not doubted: at once
    QCOMPARE(f.value("a.gain"), 0.1);
    f.model.redo();  // and forward only after the question, which stands where undo and redo are
    QCOMPARE(f.value("a.gain"), 0.1);
    QVERIFY(f.panel->foot()->questionBox()->isVisible());
    QVERIFY(row->questionBox()->isHidden());
    QTest::mouseClick(f.panel->foot()->questionBox()->applyButton(), Qt::LeftButton);
    QCOMPARE(f.value("a.gain"), 8.0);
  }

  void aDraggedSliderStopsWhereTheDoubtBeginsAndGoesOnBehindIt() {
    TuningFixture f;
    widgets::TuningRow* row = f.panel->row(QStringLiteral("a.gain"));
    const int steps = row->slider()->maximum();
    f.model.setDoubt([](std::span<const widgets::Setting> next) {
      return next.front().value > 0.5 ? QStringLiteral("It would swing.") : QString();
    });
    row->slider()->setValue(steps / 4);
    const double quiet = f.value("a.gain");
    QVERIFY(quiet <= 0.5);
    row->slider()->setValue(steps);
    QCOMPARE(f.value("a.gain"), quiet);  // not applied
    QCOMPARE(row->slider()->value(), steps);
    QVERIFY(row->questionBox()->isVisible());
    row->slider()->setValue(steps / 8);
    QVERIFY(row->questionBox()->isHidden());
    QVERIFY(f.value("a.gain") < quiet);
    QCOMPARE(row->slider()->value(), steps / 8);
  }

  void aDoubtedSetWaitsAsOneAndAnotherChangeLeavesIt() {
    TuningFixture f;
    doubtLargeGains(f.model);
    const std::vector<widgets::Setting> preset = {{"a.gain", 9.0}, {"a.percent", 60.0}};
    QVERIFY(f.model.changeAll(QStringLiteral("preset"), preset).has_value());
    QVERIFY(f.model.question() && f.panel->foot()->questionBox()->isVisible());
    QCOMPARE(f.value("a.percent"), 30.0);  // nothing of it
    f.type("a.count", QStringLiteral("4"));
    QVERIFY(!f.model.question() && f.panel->foot()->questionBox()->isHidden());
    QCOMPARE(f.value("a.count"), 4.0);
    QCOMPARE(f.value("a.gain"), 0.1);
    QVERIFY(f.model.changeAll(QStringLiteral("preset"), preset).has_value());
    f.model.applyAnyway();
    QCOMPARE(f.value("a.gain"), 9.0);
    QCOMPARE(f.value("a.percent"), 60.0);
    f.model.undo();
    QCOMPARE(f.value("a.percent"), 30.0);
  }

  void feelingDoubtedValuesWaitsAsWell() {
    TuningFixture f;
    f.type("a.gain", QStringLiteral("9"));
    f.model.markSaved();
    doubtLargeGains(f.model);
    f.type("a.gain", QStringLiteral("0.2"));
    QTest::mouseClick(f.panel->compare()->savedButton(), Qt::LeftButton);
    QVERIFY(!f.model.feelingSaved());
    QVERIFY(!f.panel->compare()->savedButton()->isChecked());
    QVERIFY(f.panel->foot()->questionBox()->isVisible());
    QTest::mouseClick(f.panel->foot()->questionBox()->leaveButton(), Qt::LeftButton);
    QVERIFY(!f.model.feelingSaved() && !f.model.question());
    f.model.feelSaved(true);
    f.model.applyAnyway();
    QVERIFY(f.model.feelingSaved());
    f.model.feelSaved(false);  // to what is not doubted
    QVERIFY(!f.model.feelingSaved());
  }

  void enterInAFieldFreesTheFocusAndAClickTakesAllOfIt() {
    TuningFixture f;
    QSignalSpy entered(f.panel.get(), &widgets::TuningPanel::entered);
    f.type("a.target", QStringLiteral("0.7"));
    QCOMPARE(entered.count(), 1);
    f.type("a.target", QStringLiteral("99"));  // refused: the entry stays to be mended
    QCOMPARE(entered.count(), 1);
    QLineEdit* field = f.panel->row(QStringLiteral("a.gain"))->field();
    QTest::mouseClick(field, Qt::LeftButton);
    WAIT_EQUAL(field->selectedText(), QStringLiteral("0.1"));
  }

  void wheelOverAnUnfocusedRowChangesNothing() {
    TuningFixture f;
    QSlider* slider = f.panel->row(QStringLiteral("a.percent"))->slider();
    f.panel->row(QStringLiteral("a.gain"))->field()->setFocus();
    const QPointF at = slider->rect().center();
    QWheelEvent wheel(at, slider->mapToGlobal(at), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(slider, &wheel);
    QCOMPARE(f.value("a.percent"), 30.0);
  }

  void everyEditorHasANameWithItsUnit() {
    TuningFixture f;
    QCOMPARE(f.panel->row(QStringLiteral("a.target"))->slider()->accessibleName(), QStringLiteral("Target in N/mm"));
    for (widgets::TuningRow* row : f.panel->rows()) QVERIFY(!row->accessibleName().isEmpty());
    QCOMPARE(f.panel->row(QStringLiteral("a.count"))->accessibleName(), QStringLiteral("Count"));  // its own name
  }
};

std::unique_ptr<QObject> makeTuningTest() { return std::make_unique<TuningTest>(); }

}  // namespace fyd::tests

#include "tuning_test.moc"
