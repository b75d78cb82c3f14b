// The window's manners: languages, layouts that come back, a settings file that is damaged, the manual, and a walk over
// every control of every place: named, with its unit, reached by the Tab key, and seen to have the focus.
#include <QDrag>
#include <QToolTip>

#include "app/console/review/review_page.h"
#include "app/console/shell/language.h"
#include "app/console/window/command_palette.h"
#include "app/console/window/manual.h"
#include "app/console/window/places.h"
#include "core/device/serial_port.h"
#include "core/pipeline/parameters.h"
#include "core/station/notice.h"
#include "tests/files_of_at_most.h"
#include "tests/widgets/look_check.h"
#include "tests/widgets/reviewing.h"
#include "tests/widgets/scripted_session.h"
#include "tests/widgets/suite.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"
#include "widgets/status/state_text.h"

namespace fyd::tests {
namespace {

/// Another language for a while.
struct Speaking {
  explicit Speaking(const char* code) { console::speak(*qApp, QLatin1String(code)); }
  ~Speaking() { console::speak(*qApp, QStringLiteral("en")); }
};

QString nameOf(const QWidget& widget) {
  if (!widget.accessibleName().isEmpty()) return widget.accessibleName();
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  return button != nullptr ? button->text() : QString();
}

QString describe(const QWidget& widget) {
  QString out = QLatin1String(widget.metaObject()->className());
  for (const QWidget* each = &widget; each != nullptr && !each->isWindow(); each = each->parentWidget()) {
    if (!each->objectName().isEmpty()) out += QLatin1Char(' ') + each->objectName();
  }
  return out + QLatin1Char(' ') + nameOf(widget);
}

std::unique_ptr<console::MainWindow> windowWith(const QString& memory, const QTemporaryDir& folder) {
  return std::make_unique<console::MainWindow>(std::make_unique<ScriptedSession>(),
                                               folder.filePath(QStringLiteral("profile.toml")), QString(),
                                               console::WindowMemory(memory));
}

console::ReviewPage* reviewOf(const console::MainWindow& window) {
  return qobject_cast<console::ReviewPage*>(window.frame()->page(QStringLiteral("review")));
}

/// Stretch between chosen values in place of force, each curve with its own time.
void choose(widgets::CurveStack& stack) {
  const std::size_t stretch = stack.indexOf(QStringLiteral("stretch"));
  stack.setShown(stretch, true);
  stack.setShown(0, false);
  stack.strip(stretch)->chooseRange(widgets::Range{-12.5, 100.0});
  stack.setLinked(false);
}

void verifyChosen(const widgets::CurveStack& stack) {
  const std::size_t stretch = stack.indexOf(QStringLiteral("stretch"));
  QVERIFY(!stack.linked() && stack.shown(stretch) && !stack.shown(0) && stack.shown(1));
  QCOMPARE(stack.strip(stretch)->chosenRange().value_or(widgets::Range{}), (widgets::Range{-12.5, 100.0}));
  QVERIFY(!stack.strip(1)->chosenRange());
}

/// Drags that a hand begins which presses on selected text and moves far away at once.
template <typename TextEdit>
qsizetype dragsOutOf(TextEdit& text) {
  text.selectAll();
  QTextCursor first = text.textCursor();
  first.setPosition(2);
  const QPointF on = text.cursorRect(first).center();
  const auto mouse = [&](QEvent::Type type, const QPointF& at, Qt::MouseButton button, Qt::MouseButtons held) {
    QMouseEvent event(type, at, text.viewport()->mapToGlobal(at), button, held, Qt::NoModifier);
    QCoreApplication::sendEvent(text.viewport(), &event);
  };
  mouse(QEvent::MouseButtonPress, on, Qt::LeftButton, Qt::LeftButton);
  mouse(QEvent::MouseMove, on + QPointF(400, 300), Qt::NoButton, Qt::LeftButton);
  const qsizetype begun = text.template findChildren<QDrag*>().size();  // one that has ended goes with the next events
  mouse(QEvent::MouseButtonRelease, on + QPointF(400, 300), Qt::LeftButton, Qt::NoButton);
  return begun;
}

}  // namespace

class MannersTest : public QObject {
  Q_OBJECT
 private slots:
  void noTextBeginsADrag() {
    Fixture f;
    QPlainTextEdit any(QStringLiteral("hello hello"));
    any.show();
    QCOMPARE(dragsOutOf(any), qsizetype{1});
    QTest::keyClick(f.window.get(), Qt::Key_R, Qt::ControlModifier);
    QPlainTextEdit* notes = f.window->recording()->form()->notesField();
    notes->setPlainText(QStringLiteral("hello hello"));
    QCOMPARE(dragsOutOf(*notes), qsizetype{0});
    f.window->help()->showTopic(QStringLiteral("operate.md"));
    QCOMPARE(dragsOutOf(*f.window->help()->page()), qsizetype{0});
    for (const QLineEdit* each : f.window->findChildren<QLineEdit*>()) QVERIFY(!each->dragEnabled());
  }

  void escAndTheRedButtonStopInADrag() {
    struct DragsFilter : QObject {  // newer than the window's own, it takes all that a hand does
      bool eventFilter(QObject*, QEvent* event) override {
        return event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease ||
               event->type() == QEvent::ShortcutOverride || event->type() == QEvent::MouseButtonPress ||
               event->type() == QEvent::MouseButtonRelease || event->type() == QEvent::MouseMove;
      }
    };
    Fixture f;
    DragsFilter drag;
    qApp->installEventFilter(&drag);
    QWindow* window = f.window->windowHandle();
    QTest::keyClick(window, Qt::Key_Escape);
    const int by_key = f.session->stops;
    QVERIFY(by_key >= 1);
    const QPushButton* stop = f.window->stateBar()->stopButton();
    const QPoint on = stop->mapTo(f.window.get(), stop->rect().center());
    QTest::mouseClick(window, Qt::LeftButton, {}, on + QPoint(0, 2 * stop->height()));
    QCOMPARE(f.session->stops, by_key);  // beside it
    QTest::mouseClick(window, Qt::LeftButton, {}, on);
    QVERIFY(f.session->stops > by_key);
  }

  void numbersHaveTheDecimalSignOfTheLanguageAndReadEither() {
    QCOMPARE(widgets::numberText(1.5, 2), QStringLiteral("1.50"));
    {
      const Speaking italian("it");
      QCOMPARE(widgets::numberText(-1.5, 2), QString::fromUtf8("−1,50"));
      QCOMPARE(widgets::plainNumber(12345.5), QStringLiteral("12345,5"));
      QCOMPARE(widgets::readNumber(QStringLiteral("0,55")), 0.55);
      QCOMPARE(widgets::readNumber(QStringLiteral("0.55")), 0.55);
      QVERIFY(std::isnan(widgets::readNumber(QStringLiteral("1.234,5"))));
      QCOMPARE(QString::number(1.5), QStringLiteral("1.5"));  // what files are written with
    }
    QCOMPARE(widgets::plainNumber(0.62), QStringLiteral("0.62"));
  }

  void everySentenceOfTheCoreIsTranslatedWithItsValues() {
    for (const console::Language& language : console::languages()) {
      if (QLatin1String(language.code) == QLatin1String("en")) continue;
      const Speaking other(language.code);
      for (std::size_t i = 0; i < pipeline::kFaultCount; ++i) {
        const auto fault = static_cast<pipeline::Fault>(i);
        const QString phrase = QString::fromUtf8(toString(fault).data());
        QVERIFY2(widgets::coreText(toString(fault)) != phrase, toString(fault).data());
        pipeline::Event event{.kind = pipeline::EventKind::state_changed, .state = pipeline::SafetyState::held};
        event.fault = fault;
        const QString translated = widgets::coreText(station::describeEvent(event, {}));
        QVERIFY2(!translated.contains(phrase) && translated.contains(widgets::coreText(toString(fault))),
                 qPrintable(translated));
      }
      const QString clamped =
          widgets::coreText(station::describeEvent({.kind = pipeline::EventKind::target_clamped, .value = 0.912}, {}));
      QVERIFY2(clamped.contains(QLatin1String("0,912")) && !clamped.contains(QLatin1String("target")),
               qPrintable(clamped));
    }
    const Speaking italian("it");
    QCOMPARE(widgets::coreText(say("what nobody ever said: {}", 1.5)), QStringLiteral("what nobody ever said: 1,5"));
    QCOMPARE(widgets::coreText("what nobody ever said"), QStringLiteral("what nobody ever said"));
    QCOMPARE(widgets::coreText(verbatim("a {} 1.5 of others")), QStringLiteral("a {} 1.5 of others"));
    QCOMPARE(widgets::coreText(say("{}: not open", "/dev/%1 {}")), QStringLiteral("/dev/%1 {}: non aperto"));
    QCOMPARE(widgets::coreText(Message{}), QString());
  }

  void aDevicesFailureIsTranslatedWithItsValues() {
    const Speaking french("fr");
    const auto said = [](const Message& message) { return widgets::coreText(message); };
    QCOMPARE(said(device::explainPort("/dev/ttyUSB0", EBUSY)),
             QString::fromUtf8("/dev/ttyUSB0 : utilisé par un autre programme (« fuser /dev/ttyUSB0 » le nomme)"));
    QCOMPARE(said(say("{}: {} at register {}: {}", "10.0.0.7:502", say("reading"), 5,
                      say("exception 3: it refuses the value"))),
             QString::fromUtf8("10.0.0.7:502 : lecture au registre 5 : exception 3 : il refuse la valeur"));
    QCOMPARE(
        said(say("{}: mend that, then arm again",
                 explained(say("the touchpad's motors are in the state {}", say("fault")), say("heartbeat lost")))),
        QString::fromUtf8("les moteurs du touchpad sont dans l'état défaut (battement perdu) : y remédier, puis "
                          "armer de nouveau"));
  }

  void whatARecordingHoldsOfEventsIsSaidInTheWindowsLanguage() {
    const Speaking italian("it");
    ReviewFixture f;
    f.openByPath(makeRecording(f.folder, QStringLiteral("tared.h5"), kPress, false, true));
    QStringList said;
    for (int i = 0; i < f.page->notes()->rowCount(); ++i) {
      for (int c = 0; c < f.page->notes()->columnCount(); ++c) {
        if (f.page->notes()->item(i, c) != nullptr) said << f.page->notes()->item(i, c)->text();
      }
    }
    const QString all = said.join(QLatin1Char('\n'));
    QVERIFY2(all.contains(QStringLiteral("Tara non riuscita")), qPrintable(all));
    QVERIFY2(all.contains(widgets::coreText(toString(sensing::TareState::touched))), qPrintable(all));
    QVERIFY2(!all.contains(QLatin1String("touched")), qPrintable(all));
  }

  void aTranslationThatDoesNotFitItsValuesIsNotUsed() {
    struct Wrong : QTranslator {
      bool isEmpty() const override { return false; }
      QString translate(const char*, const char* text, const char*, int) const override {
        if (QLatin1String(text) == QLatin1String("{} of {:.1f} N")) return QStringLiteral("{1:.1f} N, {0}");
        return QLatin1String(text) == QLatin1String("{} of {} N") ? QStringLiteral("soltanto {}") : QString();
      }
    };
    Wrong wrong;
    QCoreApplication::installTranslator(&wrong);
    QCOMPARE(widgets::coreText(say("{} of {:.1f} N", 2, 1.25)), QStringLiteral("1.2 N, 2"));
    QCOMPARE(widgets::coreText(say("{} of {} N", 2, 1.25)), QStringLiteral("2 of 1.25 N"));
    QCoreApplication::removeTranslator(&wrong);
  }

  void thePaletteNamesKeysAsTheMenusDo() {
    const Speaking french("fr");
    const QTemporaryDir folder;
    const auto window = windowWith(folder.filePath(QStringLiteral("window.ini")), folder);
    window->palette()->open();
    QStringList said;
    for (int i = 0; i < window->palette()->list()->count(); ++i) said << window->palette()->list()->item(i)->text();
    QVERIFY2(said.contains(QStringLiteral("Liaison   (Ctrl+Maj+L)")), qPrintable(said.join(QLatin1Char('\n'))));
    QVERIFY2(said.contains(QStringLiteral("Stop   (Esc)")), qPrintable(said.join(QLatin1Char('\n'))));
  }

  void whatIfExplainsEveryParameterInEveryLanguage() {
    const auto tips = [] {
      widgets::ProgressBars bars(nullptr);
      const console::WhatIfPanel panel(&bars);
      QStringList out;
      for (int i = 0; i < panel.parameter()->count(); ++i) {
        out << panel.parameter()->itemData(i, Qt::ToolTipRole).toString();
      }
      return out;
    };
    const QStringList english = tips();
    QVERIFY(english.size() > 50);
    for (const console::Language& language : console::languages()) {
      if (QLatin1String(language.code) == QLatin1String("en")) continue;
      const Speaking other(language.code);
      const QStringList said = tips();
      QCOMPARE(said.size(), english.size());
      for (qsizetype i = 0; i < said.size(); ++i) {
        const QStringList lines = said[i].split(QLatin1Char('\n'));  // its help, its range
        const QStringList former = english[i].split(QLatin1Char('\n'));
        QVERIFY2(lines.size() == 2 && lines[0] != former[0] && lines[1] != former[1], qPrintable(said[i]));
      }
    }
    const Speaking italian("it");
    pipeline::Parameters parameters;
    const auto bound = bindParameters(parameters);
    const auto refused = checkParameter(*findParameter(bound, "control.kd"), -1.5);
    QVERIFY(!refused);
    const QString said = widgets::coreText(refused.error().message);
    QVERIFY2(said.startsWith(QStringLiteral("control.kd = -1,5: atteso un numero da 0 a ")), qPrintable(said));
  }

  void theLanguageIsTheWantedOneTheKeptOneOrTheSystems() {
    const auto choose = [](const char* first, const char* second) {
      return console::chooseLanguage({QLatin1String(first), QLatin1String(second)});
    };
    QCOMPARE(choose("fr", "it"), QStringLiteral("fr"));
    QCOMPARE(choose("", "it"), QStringLiteral("it"));
    QCOMPARE(choose("klingon", "it"), QStringLiteral("it"));
    QVERIFY(console::isLanguage(choose("", "")));
  }

  void theWindowComesBackAsItWasLeft() {
    QTemporaryDir folder;
    const QString memory = folder.filePath(QStringLiteral("window.ini"));
    {
      const auto window = windowWith(memory, folder);
      window->show();
      window->resize(1111, 700);
      window->frame()->go(QStringLiteral("devices"));
      window->commands().action(QStringLiteral("view.log"))->trigger();
      window->commands().action(QStringLiteral("view.theme_light"))->trigger();
      window->commands().action(QStringLiteral("view.language_fr"))->trigger();
      QVERIFY(window->notices()->count() == 1);  // from the next start on
      window->close();
    }
    const console::WindowMemory kept(memory);
    QCOMPARE(kept.language(), QStringLiteral("fr"));
    QVERIFY(kept.theme() == widgets::ThemeChoice::light);
    const auto window = windowWith(memory, folder);
    window->show();
    QCOMPARE(window->width(), 1111);
    QCOMPARE(window->frame()->place(), QStringLiteral("devices"));
    WAIT_FOR(window->log()->isVisible());
    QVERIFY(window->commands().action(QStringLiteral("view.log"))->isChecked());
    widgets::Look::instance().apply(*qApp, widgets::ThemeChoice::dark);
  }

  void aDamagedForeignOrUnwritableMemoryNeverPreventsStarting() {
    QTemporaryDir folder;
    const QString memory = folder.filePath(QStringLiteral("window.ini"));
    const QByteArray damaged[] = {
        "",
        "\0\1\2\xff\xfe garbage [",
        QByteArray(300000, 'x'),
        "[General]\ngeometry=@ByteArray(nonsense)\n",
        "page=kitchen\ntheme=pink\nlanguage=xx\n[layout]\nwindow=@ByteArray(\\0\\0\\0\\xff)\noperate=42\n",
        "[layouts]\nzz\\window=1\n67\\window=@Variant(\\0\\0\\0\\x7f)\n"};
    for (const QByteArray& bytes : damaged) {
      QFile file(memory);
      QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
      file.write(bytes);
      file.close();
      const auto window = windowWith(memory, folder);
      window->show();
      QCOMPARE(window->frame()->place(), QStringLiteral("operate"));
      QVERIFY(window->operate()->tuning()->isVisible());
      QVERIFY(window->stateBar()->stopButton()->isVisible());
      window->layouts()->open();
      window->close();
    }
    const auto window = windowWith(folder.filePath(QStringLiteral("window.ini/below/a/file")), folder);
    window->show();
    QVERIFY(window->operate()->tuning()->isVisible());
    window->close();
  }

  void layoutsAreSavedUsedDeletedAndPutBack() {
    QTemporaryDir folder;
    const auto window = windowWith(folder.filePath(QStringLiteral("window.ini")), folder);
    window->show();
    QAction* camera = window->commands().action(QStringLiteral("view.panel_camera"));
    QVERIFY(camera->isChecked() && window->operate()->camera()->isVisible());
    camera->trigger();
    QVERIFY(!window->operate()->camera()->isVisible());
    console::LayoutsDialog* dialog = window->layouts();
    window->commands().action(QStringLiteral("view.layouts"))->trigger();
    QVERIFY(dialog->isVisible() && !dialog->isModal() && !dialog->useButton()->isEnabled());
    dialog->field()->setText(QString::fromUtf8("Essai [1]/é"));
    QTest::keyClick(dialog->field(), Qt::Key_Return);
    QCOMPARE(dialog->list()->count(), 1);
    QTest::mouseClick(dialog->standardButton(), Qt::LeftButton);
    WAIT_FOR(window->operate()->camera()->isVisible());
    dialog->list()->setCurrentRow(0);
    QTest::mouseClick(dialog->useButton(), Qt::LeftButton);
    WAIT_FOR(!window->operate()->camera()->isVisible());
    QVERIFY(!camera->isChecked());
    dialog->list()->setCurrentRow(0);
    QTest::mouseClick(dialog->deleteButton(), Qt::LeftButton);
    QCOMPARE(dialog->list()->count(), 0);
    // Closed panels of a place that is left and come back to stay as they were.
    window->frame()->go(QStringLiteral("devices"));
    window->frame()->go(QStringLiteral("operate"));
    QVERIFY(!camera->isChecked() && !window->operate()->camera()->isVisible());
    QVERIFY(window->commands().action(QStringLiteral("view.panel_tuning"))->isChecked());
  }

  void settingsThatCannotBeWrittenAreNotSaidToBeChanged() {
    QTemporaryDir folder;
    const auto window = windowWith(folder.filePath(QStringLiteral("window.ini")), folder);
    window->show();
    console::LayoutsDialog* dialog = window->layouts();
    dialog->open();
    dialog->field()->setText(QStringLiteral("wide"));
    QTest::keyClick(dialog->field(), Qt::Key_Return);
    QCOMPARE(dialog->list()->count(), 1);
    const QString unwritten = QStringLiteral("the file of the window's settings cannot be written");
    QAction* italian = window->commands().action(QStringLiteral("view.language_it"));
    {
      const FilesOfAtMost full(1);
      dialog->list()->setCurrentRow(0);
      QTest::mouseClick(dialog->deleteButton(), Qt::LeftButton);
      QVERIFY2(dialog->words().contains(unwritten), qPrintable(dialog->words()));
      italian->trigger();
      QVERIFY2(window->notices()->shownText().contains(unwritten), qPrintable(window->notices()->shownText()));
    }
    dialog->field()->setText(QStringLiteral("narrow"));
    QTest::keyClick(dialog->field(), Qt::Key_Return);
    dialog->list()->setCurrentRow(0);
    QTest::mouseClick(dialog->deleteButton(), Qt::LeftButton);
    QVERIFY2(dialog->words().contains(QStringLiteral("narrow is deleted")), qPrintable(dialog->words()));
    italian->trigger();
    QVERIFY2(window->notices()->shownText().contains(QStringLiteral("started again")),
             qPrintable(window->notices()->shownText()));
  }

  void theChoiceOfCurvesIsPartOfALayoutAndComesBackAtTheNextStart() {
    QTemporaryDir folder;
    const QString memory = folder.filePath(QStringLiteral("window.ini"));
    const auto stackOf = [](console::MainWindow& window, const char* place) {
      return place == QLatin1String("operate") ? window.operate()->curves()->stack()
                                               : reviewOf(window)->curves()->stack();
    };
    constexpr const char* kPlaces[] = {"operate", "review"};
    {
      const auto window = windowWith(memory, folder);
      window->show();
      for (const char* place : kPlaces) choose(*stackOf(*window, place));
      console::LayoutsDialog* dialog = window->layouts();
      dialog->open();
      QTest::keyClicks(dialog->field(), QStringLiteral("mine"));
      QTest::keyClick(dialog->field(), Qt::Key_Return);
      QTest::mouseClick(dialog->standardButton(), Qt::LeftButton);
      for (const char* place : kPlaces) {
        const widgets::CurveStack* stack = stackOf(*window, place);
        QVERIFY(stack->linked() && stack->shown(0) && !stack->shown(stack->indexOf(QStringLiteral("stretch"))));
        QVERIFY(!stack->strip(0)->chosenRange());
      }
      dialog->list()->setCurrentRow(0);
      QTest::mouseClick(dialog->useButton(), Qt::LeftButton);
      for (const char* place : kPlaces) verifyChosen(*stackOf(*window, place));
      window->close();
    }
    const auto window = windowWith(memory, folder);
    window->show();
    for (const char* place : kPlaces) verifyChosen(*stackOf(*window, place));
    QVERIFY(!window->operate()->curveTools()->panel()->linkBox()->isChecked());
    QVERIFY(!window->commands().action(QStringLiteral("curves.link_time"))->isChecked());
    QCOMPARE(window->log()->lines(), 0);
  }

  void whetherTheRangesAreHeldIsSaidAsItIs() {
    QTemporaryDir folder;
    const QString memory = folder.filePath(QStringLiteral("window.ini"));
    const auto hold = [](console::MainWindow& window) {
      return window.commands().action(QStringLiteral("curves.hold_ranges"));  // the key R
    };
    {
      const auto window = windowWith(memory, folder);
      window->show();
      QVERIFY(!hold(*window)->isChecked());
      hold(*window)->trigger();
      QVERIFY(hold(*window)->isChecked() && window->operate()->curves()->stack()->strip(1)->chosenRange());
      window->close();
    }
    const auto window = windowWith(memory, folder);
    window->show();
    QVERIFY(hold(*window)->isChecked());
    // One curve follows its values again: they are not all held; the key then holds all.
    widgets::CurveStack* stack = window->operate()->curves()->stack();
    widgets::CurveSetupPanel* panel = window->operate()->curveTools()->panel();
    window->commands().action(QStringLiteral("curves.choose"))->trigger();
    for (const char* end : {"from_force", "to_force"}) {
      auto* field = panel->findChild<QLineEdit*>(QLatin1String(end));
      field->setFocus();
      field->selectAll();
      QTest::keyClick(field, Qt::Key_Delete);
      QTest::keyClick(field, Qt::Key_Return);
    }
    QVERIFY(!stack->strip(0)->chosenRange() && stack->strip(1)->chosenRange() && !hold(*window)->isChecked());
    for (const bool now : {true, false}) {
      hold(*window)->trigger();
      QVERIFY(hold(*window)->isChecked() == now && stack->strip(0)->chosenRange().has_value() == now);
    }
  }

  void aChoiceOfCurvesThatIsNoneIsLeftOutWithAWordInTheLog() {
    const QByteArray bad[] = {"",
                              "\0\1\xff",
                              "[1, 2]",
                              R"({"linked": 3, "curves": {"kitchen": {"shown": true}}})",
                              R"({"curves": {"force": {"shown": "yes"}}})",
                              R"({"curves": {"force": {"shown": false, "range": [3]}}})",
                              R"({"curves": {"force": {"shown": false, "range": [5, -5]}}})",
                              R"({"curves": {"force": {"shown": false, "range": [0, 1e300]}}})",
                              R"({"curves": {"force": {"shown": false, "range": [0, 1e999]}}})",
                              R"({"curves": {"force": {"shown": false, "range": [null, "8"]}}})",
                              QByteArray(60000, '[')};
    Fixture f;
    const widgets::CurveStack* stack = f.window->operate()->curves()->stack();
    const QByteArray before = f.window->operate()->curveTools()->choice();
    console::Layout layout = f.window->layoutNow();
    for (const QByteArray& choice : bad) {
      layout.curves = choice;
      const int said = f.window->log()->lines();
      f.window->setLayoutTo(layout);
      QVERIFY2(f.window->log()->lines() > said, choice.left(80).constData());
      QCOMPARE(f.window->operate()->curveTools()->choice(), before);
    }
    // The rest of one that is half wrong is taken, and one curve stays.
    layout.curves = R"({"linked": false, "curves": {"force": {"shown": false}, "indentation": {"shown": 1},
                        "stretch": {"shown": true, "range": [-5, 100]}}})";
    f.window->setLayoutTo(layout);
    QVERIFY(!stack->linked() && !stack->shown(0) && stack->shown(1));
    QCOMPARE(*stack->strip(stack->indexOf(QStringLiteral("stretch")))->chosenRange(), (widgets::Range{-5.0, 100.0}));
    layout.curves = f.window->operate()->curveTools()->choice().replace("true", "false");
    f.window->setLayoutTo(layout);
    int shown = 0;
    for (std::size_t i = 0; i < stack->size(); ++i) shown += stack->shown(i) ? 1 : 0;
    QCOMPARE(shown, 1);
  }

  void everyTopicOfTheManualExistsAndF1GoesToTheOneInFocus() {
    for (const QString& topic : console::manualTopics()) {
      const bool page = std::ranges::any_of(console::manualSections(),
                                            [&](const console::ManualSection& each) { return each.page == topic; });
      QVERIFY2(page || console::manualHeading(topic) >= 0, qPrintable(topic));
    }
    QCOMPARE(console::manualHeading(QStringLiteral("operate.md#kitchen")), -1);
    Fixture f;
    f.row("control.kp")->field()->setFocus();
    QTest::keyClick(f.row("control.kp")->field(), Qt::Key_F1);
    QVERIFY(f.window->help()->isVisible());
    QCOMPARE(f.window->help()->topic(), QStringLiteral("operate.md#tuning"));
    QVERIFY(f.window->help()->page()->toPlainText().contains(QStringLiteral("Re-arm"), Qt::CaseInsensitive));
    f.window->frame()->go(QStringLiteral("review"));
    f.window->frame()->setFocus();
    QTest::keyClick(f.window.get(), Qt::Key_F1);
    QVERIFY(f.window->help()->topic().startsWith(QStringLiteral("review.md")));
    QTest::mouseClick(f.window->help()->backButton(), Qt::LeftButton);
    QCOMPARE(f.window->help()->topic(), QStringLiteral("operate.md#tuning"));
  }

  void theManualIsSearchedAndItsLinksLead() {
    Fixture f;
    console::HelpDock* help = f.window->help();
    help->showTopic(QStringLiteral("README.md"));
    QTest::keyClicks(help->field(), QStringLiteral("tare"));
    QVERIFY(help->found()->count() > 1 && help->found()->isVisible());
    QVERIFY(help->found()->item(0)->text().startsWith(QStringLiteral("Tare")));  // a heading comes first
    QTest::keyClick(help->field(), Qt::Key_Return);
    QCOMPARE(help->topic(), QStringLiteral("session.md#tare"));
    help->field()->setText(QStringLiteral("zxqv"));
    QCOMPARE(help->found()->count(), 1);
    help->field()->clear();
    QVERIFY(!help->found()->isVisible());
    emit help->page()->anchorClicked(QUrl(QStringLiteral("operate.md#state-bar")));
    QCOMPARE(help->topic(), QStringLiteral("operate.md#state-bar"));
    emit help->page()->anchorClicked(QUrl(QStringLiteral("#camera")));
    QCOMPARE(help->topic(), QStringLiteral("operate.md#camera"));
    QCOMPARE(help->page()->textCursor().block().text(), QStringLiteral("Camera"));
    emit help->page()->anchorClicked(QUrl(QStringLiteral("../textures/wood.toml")));
    QCOMPARE(help->topic(), QStringLiteral("operate.md#camera"));
  }

  void everyTextIsShownAsItIsWritten() {
    Fixture f;
    for (const QString& place : console::placeNames()) f.window->frame()->go(place);
    const QList<QLabel*> labels = f.window->findChildren<QLabel*>();
    QVERIFY(labels.size() > 50);
    int seen = 0;
    for (const QLabel* label : labels) {
      if (!label->isVisible()) continue;
      ++seen;
      QVERIFY2(label->textFormat() == Qt::PlainText, qPrintable(label->text()));
    }
    QVERIFY(seen > 10);
    QToolTip::showText({}, QStringLiteral("<b>soft</b> a < b <img src=x>"), f.window.get());
    const QWidgetList widgets = QApplication::topLevelWidgets();
    const auto tip = std::ranges::find_if(widgets, [](const QWidget* each) { return each->inherits("QTipLabel"); });
    QVERIFY(tip != widgets.end());
    QVERIFY(qobject_cast<QLabel*>(*tip)->textFormat() == Qt::PlainText);
    QToolTip::hideText();
  }

  void aPictureOfTheManualIsScaledWithoutAPatternOfDots() {
    Fixture f;
    f.window->help()->showTopic(QStringLiteral("operate.md"));
    const QUrl picture(QStringLiteral("images/operate-dark.png"));
    const QImage page = f.window->help()->page()->loadResource(QTextDocument::ImageResource, picture).value<QImage>();
    QVERIFY(page.width() > 300 && page.width() < 1280);
    // Below the panels lies the window's bare background: one colour.
    const QRect bare(page.width() / 2, page.height() * 95 / 100, page.width() / 4, page.height() * 3 / 100);
    for (int x = bare.left(); x <= bare.right(); ++x) {
      for (int y = bare.top(); y <= bare.bottom(); ++y) QCOMPARE(page.pixel(x, y), page.pixel(bare.topLeft()));
    }
  }

  void theManualSpeaksTheWindowsLanguageAndEnglishWhereAPageIsNotTranslated() {
    const Speaking italian("it");
    for (const QString& topic : console::manualTopics()) {
      QVERIFY2(!topic.contains(QLatin1Char('#')) || console::manualHeading(topic) >= 0, qPrintable(topic));
    }
    Fixture f;
    console::HelpDock* help = f.window->help();
    const auto heading = [help] { return help->page()->textCursor().block().text(); };
    auto* in_the_curves = f.window->operate()->curves()->findChild<QAbstractButton*>();
    in_the_curves->setFocus();
    QTest::keyClick(in_the_curves, Qt::Key_F1);
    QCOMPARE(help->topic(), QStringLiteral("operate.md#curves"));
    QCOMPARE(heading(), QStringLiteral("Curve"));
    WAIT_FOR(help->page()->verticalScrollBar()->value() > 0 && help->page()->cursorRect().top() == 0);
    QVERIFY(!help->page()->toPlainText().contains(QLatin1String("translated from")));
    QVERIFY(help->page()->loadResource(QTextDocument::ImageResource, QUrl("../images/operate-dark.png")).isValid());
    // Links name the English heading.
    emit help->page()->anchorClicked(QUrl(QStringLiteral("#tuning")));
    QCOMPARE(heading(), QStringLiteral("Regolazione"));
    emit help->page()->anchorClicked(QUrl(QStringLiteral("../protocol.md")));
    QVERIFY(help->page()->document()->firstBlock().text().startsWith(QLatin1String("FYD Link: the secured")));
    help->field()->setText(QStringLiteral("disposizioni pannelli"));
    QCOMPARE(help->found()->item(0)->text(), QString::fromUtf8("Pannelli e disposizioni  ·  Lavoro"));
    QTest::keyClick(help->field(), Qt::Key_Return);
    QCOMPARE(help->topic(), QStringLiteral("operate.md#panels-and-layouts"));
    QVERIFY(help->page()->textCursor().block().text().contains(QLatin1String("disposizioni")));
  }

  void everyCommandIsInAMenuAndInThePalette() {
    Fixture f;
    QSet<QString> in_menus;
    for (QAction* menu : f.window->menuBar()->actions()) {
      for (const QAction* each : menu->menu()->actions()) in_menus.insert(each->objectName());
    }
    QSet<QString> in_palette;
    f.window->review(
        makeRecording(f.folder, QStringLiteral("session.h5")));  // over the list its commands are not offered
    for (const console::PlaceInfo& place : console::places()) {
      f.window->frame()->go(QLatin1String(place.id));
      f.window->palette()->open();
      QListWidget* list = f.window->palette()->list();
      for (int i = 0; i < list->count(); ++i) in_palette.insert(list->item(i)->data(Qt::UserRole).toString());
      f.window->palette()->hide();
    }
    for (const QAction* each : f.window->commands().actions()) {
      QVERIFY2(in_menus.contains(each->objectName()), qPrintable(each->objectName()));
      QVERIFY2(in_palette.contains(each->objectName()), qPrintable(each->objectName()));
    }
  }

  void everyMenuOpensByItsOwnLetter() {
    Fixture f;
    for (const console::PlaceInfo& place : console::places()) {
      f.window->frame()->go(QLatin1String(place.id));
      QSet<QChar> letters;
      for (const QAction* menu : f.window->menuBar()->actions()) {
        if (!menu->isVisible()) continue;
        const qsizetype mark = menu->text().indexOf(QLatin1Char('&'));
        QVERIFY2(mark >= 0 && mark + 1 < menu->text().size(), qPrintable(menu->text()));
        const QChar letter = menu->text()[mark + 1].toUpper();
        QVERIFY2(!letters.contains(letter), qPrintable(menu->text()));
        letters.insert(letter);
        QTest::keyClick(f.window.get(), static_cast<Qt::Key>(letter.unicode()), Qt::AltModifier);
        WAIT_FOR(menu->menu()->isVisible());
        QVERIFY(menu->menu()->activeAction() != nullptr);  // the arrow keys go on from there
        menu->menu()->close();
      }
    }
  }

  void everyControlIsNamedReachedByTabAndSeenToHaveTheFocus() {
    Fixture f;
    f.window->resize(1280, 720);
    QStringList faults;
    for (const console::PlaceInfo& place : console::places()) {
      f.window->frame()->go(QLatin1String(place.id));
      if (QLatin1String(place.id) == QLatin1String("operate")) {
        for (const char* panel : {"view.log", "view.link", "help.manual"}) {
          f.window->commands().action(QLatin1String(panel))->trigger();
        }
        f.window->commands().action(QStringLiteral("session.record"))->trigger();
      }
      passTimers(30);
      const QList<QWidget*> controls = controlsOf(*f.window);
      QSet<QWidget*> reached;
      f.window->stateBar()->stopButton()->setFocus();
      for (qsizetype i = 0; i < 3 * controls.size() + 400; ++i) {
        QWidget* focus = QApplication::focusWidget();
        if (focus == nullptr) break;
        reached.insert(focus);
        QTest::keyClick(focus, Qt::Key_Tab);
        // A page of the manual is left after its last link.
        if (QApplication::focusWidget() == focus && qobject_cast<QTextBrowser*>(focus) == nullptr) {
          faults << QLatin1String(place.id) + QStringLiteral(": Tab stays in ") + describe(*focus);
          break;
        }
      }
      for (QWidget* each : controls) {
        const QString who = QLatin1String(place.id) + QStringLiteral(": ") + describe(*each);
        if (nameOf(*each).trimmed().isEmpty()) faults << who + QStringLiteral(" has no name");
        // One of a group of radio buttons or exclusive buttons stands for all: the arrow keys go on.
        const auto* button = qobject_cast<QAbstractButton*>(each);
        const bool grouped = button != nullptr && (button->group() != nullptr || button->autoExclusive());
        if (!reached.contains(each) && !grouped) faults << who + QStringLiteral(" is not reached by Tab");
        if (reached.contains(each) && !showsFocus(*each)) faults << who + QStringLiteral(" looks alike with the focus");
      }
    }
    for (const QString& fault : faults) qWarning("%s", qPrintable(fault));
    QVERIFY(faults.isEmpty());
  }

  void everyTunedNumberSaysItsUnit() {
    Fixture f;
    station::Profile profile;
    for (const Parameter& each : bindParameters(profile)) {
      const auto* row = f.window->operate()->tuning()->row(QString::fromUtf8(each.id.data()));
      if (row == nullptr || each.info.unit == "1") continue;
      const QString unit = QString::fromUtf8(each.info.unit.data(), static_cast<qsizetype>(each.info.unit.size()));
      QVERIFY2(row->field()->accessibleName().contains(unit), qPrintable(row->field()->accessibleName()));
      QVERIFY2(row->slider()->accessibleName().contains(unit), qPrintable(row->slider()->accessibleName()));
    }
  }

 private:
  static bool showsFocus(QWidget& widget) {
    widget.setFocus(Qt::TabFocusReason);
    const QImage with = widget.grab().toImage();
    widget.clearFocus();
    return with != widget.grab().toImage();
  }
};

std::unique_ptr<QObject> makeMannersTest() { return std::make_unique<MannersTest>(); }

}  // namespace fyd::tests

#include "manners_test.moc"
