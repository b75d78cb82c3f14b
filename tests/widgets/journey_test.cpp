// A day's work in one window on the simulated touchpad, by keys and clicks: the first start, calibrate everything,
// tune, run and record, stop, review, export, and the next morning. What is looked at is what the operator sees.
#include "app/console/review/review_page.h"
#include "app/console/tune/tune_page.h"
#include "tests/widgets/hands.h"
#include "tests/widgets/simulated_touchpad.h"
#include "tests/widgets/suite.h"

namespace fyd::tests {
namespace {

const QString kNote = QStringLiteral("the cloth was turned");
const QString kOperator = QStringLiteral("M. Muster");
const QString kSubject = QStringLiteral("S07");

/// The home of somebody who never started the console.
class NewHome {
 public:
  NewHome() {
    for (const char* name : kNames) former_.push_back(qgetenv(name));
    qputenv("HOME", folder_.path().toUtf8());
    for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"}) {
      qputenv(name, folder_.filePath(QLatin1String(name).mid(4)).toUtf8());
    }
  }
  ~NewHome() {
    for (std::size_t i = 0; i < former_.size(); ++i) {
      former_[i].isNull() ? qunsetenv(kNames[i]) : qputenv(kNames[i], former_[i]);
    }
  }
  /// In a folder that is not there yet.
  [[nodiscard]] QString profile() const { return folder_.filePath(QStringLiteral("CONFIG_HOME/console/profile.toml")); }
  /// The only file of these endings below the sessions' folder; empty: none, or more.
  [[nodiscard]] QString session(const QString& ending) const {
    const QDir sessions(folder_.filePath(QStringLiteral("Documents/FYD sessions")));
    const QStringList found = sessions.entryList({QStringLiteral("* S07") + ending}, QDir::Files);
    return found.size() == 1 ? sessions.filePath(found.front()) : QString();
  }

 private:
  static constexpr const char* kNames[] = {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"};
  QTemporaryDir folder_;
  std::vector<QByteArray> former_;
};

/// A start of the program: what it reads, it reads from the files of the start before.
struct Day {
  explicit Day(const NewHome& home) {
    station::StationOptions options;
    options.profile_file = home.profile().toStdString();
    if (QFile::exists(home.profile())) options.profile = station::loadProfile(home.profile().toStdString()).value();
    auto session = console::openSession(options).value();
    const console::WindowMemory memory(console::memoryFile(home.profile()));
    window = std::make_unique<console::MainWindow>(std::move(session), home.profile(), QString(), memory);
    window->show();
    window->activateWindow();
    (void)QTest::qWaitForWindowActive(window.get(), kPatience_ms);
    window->start();
  }
  template <class T>
  T* place(const char* id, Qt::Key number) const {
    key(number, Qt::ControlModifier);
    T* page = qobject_cast<T*>(window->frame()->page(QLatin1String(id)));
    return page->isVisible() ? page : nullptr;
  }
  /// Where the focus is, as a key of the keyboard goes.
  void key(Qt::Key key, Qt::KeyboardModifiers with = {}) const {
    QWidget* focus = QApplication::focusWidget();
    QTest::keyClick(focus != nullptr ? focus : window.get(), key, with);
  }
  void type(const QString& text) const { QTest::keyClicks(QApplication::focusWidget(), text); }
  void overtype(const QString& text) const {
    key(Qt::Key_A, Qt::ControlModifier);
    type(text);
  }
  void tabTo(const QWidget* widget) const {
    constexpr int kMost = 60;
    for (int i = 0; i < kMost && !widget->hasFocus(); ++i) key(Qt::Key_Tab);
    QVERIFY2(widget->hasFocus(), qPrintable(widget->objectName()));
  }
  /// By the command palette.
  void command(const QString& words) const {
    key(Qt::Key_K, Qt::ControlModifier);
    (void)QTest::qWaitFor([this] { return window->palette()->field()->hasFocus(); }, kPatience_ms);
    type(words);
    key(Qt::Key_Return);
    window->activateWindow();
    (void)QTest::qWaitForWindowActive(window.get(), kPatience_ms);
  }
  [[nodiscard]] bool told(const QString& words) const {
    for (int i = 0; i < window->notices()->count(); ++i) {
      if (window->notices()->text(i).contains(words)) return true;
    }
    return false;
  }
  [[nodiscard]] QString state() const { return window->stateBar()->stateWord(); }

  std::unique_ptr<console::MainWindow> window;
};

/// A part of the journey; a test goes no further than the first that failed.
#define GO(part) \
  part;          \
  if (QTest::currentTestFailed()) return

void firstStart(const Day& day) {
  QCOMPARE(day.window->frame()->place(), QStringLiteral("operate"));
  WAIT_EQUAL(day.state(), QStringLiteral("Ready"));
  static const QRegularExpression kAllOfThem(QStringLiteral("^Ready\\? ([0-9]+)/\\1$"));
  const widgets::ReadinessList* list = day.window->operate()->readiness();
  WAIT_FOR(kAllOfThem.match(list->title()).hasMatch());
}

void calibrateEverything(const Day& day) {
  auto* page = day.place<console::CalibratePage>("calibrate", Qt::Key_2);
  QVERIFY(page != nullptr);
  page->fitPanel()->who()->setText(QStringLiteral("A. Tester"));
  page->parts()->setFocus();
  day.key(Qt::Key_Home);
  const int count = page->parts()->count();
  for (int part = 0; part < count; ++part) {
    QCOMPARE(page->parts()->currentRow(), part);
    const QString before = page->parts()->currentItem()->text();
    // The curves before it have moved what the untouched cloth reads.
    const bool moved = before.contains(QLatin1String("No-touch"));
    QVERIFY2(before.contains(moved ? QLatin1String("take it again (Distance sensor 1; Distance sensor 2; "
                                                   "Distance sensor 3; Load cell)")
                                   : QLatin1String("never calibrated")),
             qPrintable(before));
    if (before.contains(QLatin1String("Stiffness map"))) {
      GO(measureOneStretch(page));
      QTest::mouseClick(page->discardButton(), Qt::LeftButton);  // the map needs more stretches than there is time for
    }
    GO(takeSimulated(page));
    GO(hearTheStation(*day.window));
    day.key(Qt::Key_Return, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY2(page->hint().startsWith(QLatin1String("Accepted")), qPrintable(before + page->hint()));
    const QString after = page->parts()->currentItem()->text();
    QVERIFY2(after.contains(QLatin1String("fine: calibrated today")), qPrintable(after));
    page->parts()->setFocus();
    day.key(Qt::Key_Down);
  }
}

void tune(const Day& day) {
  auto* page = day.place<console::TunePage>("tune", Qt::Key_6);
  QVERIFY(page != nullptr);
  day.key(Qt::Key_F, Qt::ControlModifier);
  day.type(QStringLiteral("texture.k_vib"));
  const widgets::TuningRow* row = page->list()->row(QStringLiteral("texture.k_vib"));
  GO(day.tabTo(row->field()));
  day.overtype(QStringLiteral("3"));
  day.key(Qt::Key_Z, Qt::ControlModifier);  // of the typing: no value has changed
  QCOMPARE(row->field()->text(), QStringLiteral("1"));
  QVERIFY(row->mark()->text().isEmpty());
  day.overtype(QStringLiteral("2"));
  day.key(Qt::Key_Return);
  // "•": differs from what is saved, and the step has said that it uses it.
  WAIT_EQUAL(row->mark()->text(), QStringLiteral("•"));
  day.key(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(row->field()->text(), QStringLiteral("1"));
  day.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(row->field()->text(), QStringLiteral("2"));
  WAIT_EQUAL(row->mark()->text(), QStringLiteral("•"));
  day.key(Qt::Key_S, Qt::ControlModifier);
  QVERIFY(day.told(QStringLiteral("Profile saved to")));
  QVERIFY(row->mark()->text().isEmpty());
}

/// A finger on the camera's picture, for a second of what is drawn after its force is seen.
void touch(const Day& day) {
  const console::OperatePage* page = day.window->operate();
  QWidget* picture = page->camera()->image();
  const widgets::Readout* force = page->curves()->readout(0);
  QTest::mousePress(picture, Qt::LeftButton, {}, picture->rect().center());
  WAIT_FOR(force->valueText(0).toDouble() > 0.5);
  const widgets::CurveBuffer& drawn = page->curves()->buffer();
  const double seen_s = drawn.lastTime_s();
  WAIT_FOR(drawn.lastTime_s() > seen_s + 1.0);
  QTest::mouseRelease(picture, Qt::LeftButton, {}, picture->rect().center());
}

void runAndRecord(const Day& day) {
  auto* page = day.place<console::OperatePage>("operate", Qt::Key_1);
  QVERIFY(page != nullptr);
  GO(makeActive(*day.window));
  day.key(Qt::Key_R, Qt::ControlModifier);
  const widgets::RecordingForm* form = day.window->recording()->form();
  GO(day.tabTo(form->operatorField()));
  day.overtype(kOperator);
  GO(day.tabTo(form->subjectField()));
  day.overtype(kSubject);
  day.key(Qt::Key_Return);
  WAIT_FOR(form->stopButton()->isVisible());
  static const QRegularExpression kSinceTheStart(QStringLiteral("^REC 00:0[0-9]:[0-5][0-9]"));
  // The small screen of this test has room for the button's sign only; a screen reader says all of it.
  const QString recording = day.window->stateBar()->recordButton()->accessibleName();
  QVERIFY2(kSinceTheStart.match(recording).hasMatch(), qPrintable(recording));
  GO(makeActive(*day.window));
  GO(touch(day));
  GO(day.tabTo(form->noteField()));
  day.type(kNote);
  day.key(Qt::Key_Return);
  QVERIFY(day.told(kNote));
  GO(makeActive(*day.window));
  GO(touch(day));
  // The one key, while something is being typed.
  day.type(QStringLiteral("half a no"));
  day.key(Qt::Key_Escape);
  WAIT_EQUAL(day.state(), QStringLiteral("Stopped"));
  QVERIFY(form->stopButton()->isVisible());  // the recording goes on
  day.key(Qt::Key_R, Qt::ControlModifier);
  QVERIFY(form->stopButton()->hasFocus());
  day.key(Qt::Key_Return);
  WAIT_FOR(day.told(QStringLiteral("Recording closed:")));
  WAIT_EQUAL(day.state(), QStringLiteral("Stopped"));
}

void openTheRecording(const Day& day, const console::ReviewPage& page) {
  const QTableWidget* list = page.list()->table();
  WAIT_EQUAL(list->rowCount(), 1);
  QCOMPARE(list->item(0, 2)->text(), kOperator);
  QCOMPARE(list->item(0, 3)->text(), kSubject);
  GO(day.tabTo(list));
  day.key(Qt::Key_Down);
  day.key(Qt::Key_Return);
  QVERIFY(!page.showsList());
  QVERIFY2(page.title().contains(QStringLiteral("subject S07")), qPrintable(page.title()));
}

/// What the curves say of two marks, by the clock of what was recorded: each cycle that the machine missed between two
/// rows lengthens the way from one to the other.
QString timeBetween(const recording::Recording& recording, std::uint64_t first_row, std::size_t rows) {
  std::vector<pipeline::TelemetrySample> read(rows + 1);
  const auto done = recording.telemetry(first_row, read);
  if (!done) return QString::fromStdString(done.error().text());
  const std::chrono::duration<double> between = read.back().now - read.front().now;
  return QStringLiteral("Δt %1 s").arg(between.count(), 0, 'f', 3);
}

void review(const Day& day) {
  auto* page = day.place<console::ReviewPage>("review", Qt::Key_3);
  QVERIFY(page != nullptr);
  GO(openTheRecording(day, *page));
  WAIT_FOR(page->touches()->rowCount() >= 1);
  bool noted = false;
  for (int row = 0; row < page->notes()->rowCount(); ++row) noted |= page->notes()->item(row, 2)->text() == kNote;
  QVERIFY(noted);
  // A where a touch begins, B a hundred rows later.
  GO(day.tabTo(page->touches()));
  day.key(Qt::Key_Down);
  day.key(Qt::Key_BracketLeft);
  page->curves()->setFocus();
  constexpr std::size_t kRowsBetween = 100;
  const double half_a_row_s = 0.0005;
  const auto first_row = page->recording()->rowAt(page->player()->time_s() - half_a_row_s);
  QVERIFY2(first_row, first_row ? "" : first_row.error().text().c_str());
  for (std::size_t i = 0; i < kRowsBetween; ++i) day.key(Qt::Key_Right);
  day.key(Qt::Key_BracketRight);
  page->curves()->redraw();
  const QString marks = page->curves()->stack()->markText();
  const QString expected = timeBetween(*page->recording(), *first_row, kRowsBetween);
  QVERIFY2(marks.contains(expected), qPrintable(marks + QStringLiteral(", expected ") + expected));
  WAIT_EQUAL(page->figures()->rowCount(), 5);
}

void exportIt(const Day& day, const NewHome& home) {
  day.command(QStringLiteral("export as csv"));
  WAIT_FOR(day.told(QStringLiteral("S07.csv is written")));
  day.key(Qt::Key_P, Qt::ControlModifier);
  WAIT_FOR(day.told(QStringLiteral("S07.html is written")));
  const QByteArray table = contentOf(home.session(QStringLiteral(".csv")));
  QVERIFY(table.startsWith("time_s [s],"));
  QVERIFY2(table.count('\n') > 1000, "more than a second");
  QVERIFY(contentOf(home.session(QStringLiteral(".events.csv"))).contains(kNote.toUtf8()));
  const QByteArray report = contentOf(home.session(QStringLiteral(".html")));
  for (const QString& each : {kNote, kOperator, kSubject, QStringLiteral("<svg"), QStringLiteral("Touches")}) {
    QVERIFY2(report.contains(each.toUtf8()), qPrintable(each));
  }
}

void nextMorning(const Day& day) {
  QCOMPARE(day.window->frame()->place(), QStringLiteral("review"));
  auto* review = qobject_cast<console::ReviewPage*>(day.window->frame()->page(QStringLiteral("review")));
  GO(openTheRecording(day, *review));
  auto* calibrate = day.place<console::CalibratePage>("calibrate", Qt::Key_2);
  QVERIFY(calibrate != nullptr);
  for (int part = 0; part < calibrate->parts()->count(); ++part) {
    const QString words = calibrate->parts()->item(part)->text();
    QVERIFY2(words.contains(QLatin1String("fine: calibrated today")), qPrintable(words));
  }
  auto* tune = day.place<console::TunePage>("tune", Qt::Key_6);
  QVERIFY(tune != nullptr);
  const widgets::TuningRow* row = tune->list()->row(QStringLiteral("texture.k_vib"));
  QCOMPARE(row->field()->text(), QStringLiteral("2"));
  QVERIFY(row->mark()->text().isEmpty());
  const widgets::RecordingForm* form = day.window->recording()->form();
  QCOMPARE(form->operatorField()->text(), kOperator);
  QCOMPARE(form->subjectField()->text(), kSubject);
  WAIT_EQUAL(day.state(), QStringLiteral("Ready"));  // and not Active
}

}  // namespace

class JourneyTest : public QObject {
  Q_OBJECT
 private slots:
  void aDayFromTheFirstStartToTheExportAndTheNextMorning() {
    const NewHome home;
    {
      const Day day(home);
      GO(firstStart(day));
      GO(calibrateEverything(day));
      GO(tune(day));
      GO(runAndRecord(day));
      GO(review(day));
      GO(exportIt(day, home));
      day.key(Qt::Key_Q, Qt::ControlModifier);
      WAIT_FOR(!day.window->isVisible());
    }
    const Day next(home);
    GO(nextMorning(next));
    next.window->close();
  }
};

#undef GO

std::unique_ptr<QObject> makeJourneyTest() { return std::make_unique<JourneyTest>(); }

}  // namespace fyd::tests

#include "journey_test.moc"
