// Long work in Review: it says how far it is, is cancelled by a click and by a key, leaves nothing behind, works when
// it is asked for again; a crashed recording is made whole; the window closes in the middle of it.
#include <QSignalSpy>
#include <atomic>
#include <thread>

#include "core/catalogue/catalogue.h"
#include "core/recording/file/recording_hdf5.h"
#include "core/sim/gesture_card.h"
#include "tests/unit/recording/recording_damage.h"
#include "tests/widgets/hands.h"
#include "tests/widgets/reviewing.h"
#include "tests/widgets/suite.h"

namespace fyd::tests {
namespace {

using widgets::ProgressBar;

/// While it lives no other thread reads a recording: work that was begun is not over before it is looked at.
using Halt = std::unique_lock<recording::FairMutex>;

struct WorkFixture : ReviewFixture {
  WorkFixture() {
    openByPath();
    waitForTouches();
  }
  void waitForTouches() const {
    WAIT_EQUAL(page->touches()->rowCount(), 1);
    WAIT_FOR(page->work()->running().empty());
  }
  [[nodiscard]] QStringList files() const {
    return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
  }
  /// The newest, once it is seen.
  [[nodiscard]] ProgressBar* bar() const {
    if (page->work()->running().empty()) return nullptr;
    ProgressBar* newest = page->work()->running().back();
    return QTest::qWaitFor([newest] { return newest->isVisible(); }, kPatience_ms) ? newest : nullptr;
  }
  /// As an operator does it; what ran may go on then, and ends.
  void cancelByClick(Halt& halt) {
    ProgressBar* newest = bar();
    QVERIFY(newest != nullptr);
    QTest::mouseClick(newest->cancelButton(), Qt::LeftButton);
    QVERIFY(!newest->cancelButton()->isEnabled());
    QVERIFY(newest->words().startsWith(QStringLiteral("Cancelling")));
    letGo(halt);
  }
  void letGo(Halt& halt) const {
    halt.unlock();
    WAIT_FOR(page->work()->running().empty());
    QVERIFY(!page->work()->isVisible());
  }
  void cancelByKey() { key(Qt::Key_X, Qt::ControlModifier | Qt::ShiftModifier); }
};

}  // namespace

class ReviewWorkTest : public QObject {
  Q_OBJECT
 private slots:
  void aBarSaysHowLongItWillTakeOnceItCanTell() {
    QCOMPARE(ProgressBar::shareText(0, 60.0), QStringLiteral("0 %"));
    QCOMPARE(ProgressBar::shareText(50, 1.0), QStringLiteral("50 %"));
    QCOMPARE(ProgressBar::shareText(25, 60.0), QStringLiteral("25 % · 3 min left"));
    QCOMPARE(ProgressBar::shareText(90, 60.0), QStringLiteral("90 % · less than 1 min left"));
    QCOMPARE(ProgressBar::shareText(100, 60.0), QStringLiteral("100 %"));
    QCOMPARE(ProgressBar::shareText(50, std::nan("")), QStringLiteral("50 %"));
  }

  void anExportSaysHowFarItIs() {
    WorkFixture f;
    f.page->exports()->exportAs(QStringLiteral("csv"));
    QCOMPARE(f.page->work()->running().size(), std::size_t{1});
    QProgressBar* progress = f.page->work()->running().front()->progress();
    QCOMPARE(f.page->work()->running().front()->cancelButton()->accessibleName(),
             QStringLiteral("Cancel: Writing session.csv"));
    QCOMPARE(progress->accessibleName(), QStringLiteral("Writing session.csv"));
    const QSignalSpy moved(progress, &QProgressBar::valueChanged);
    WAIT_FOR(f.told().contains(QStringLiteral("session.csv is written")));
    QVERIFY(moved.count() >= 3);
    for (qsizetype i = 1; i < moved.count(); ++i) QVERIFY(moved[i][0].toInt() > moved[i - 1][0].toInt());
    QVERIFY(f.page->work()->running().empty());
    QVERIFY(!f.page->work()->isVisible());
  }

  void aTouchBecomesAGestureCardOnceItIsChosen() {
    WorkFixture f;
    QVERIFY(!f.page->cardButton()->isEnabled());
    f.key(Qt::Key_G);
    WAIT_FOR(f.told().contains(QStringLiteral("Choose a touch")));
    f.page->touches()->setCurrentCell(0, 0);
    QVERIFY(f.page->cardButton()->isEnabled());
    QTest::mouseClick(f.page->cardButton(), Qt::LeftButton);
    const QString path = f.folder.filePath(QStringLiteral("session touch 1.gesture"));
    WAIT_FOR(QFileInfo::exists(path) && f.page->work()->running().empty());
    WAIT_FOR(f.told().contains(QStringLiteral("is written")));
    const auto card = sim::readGestureFile(path.toStdString());
    QVERIFY2(card.has_value(), card ? "" : card.error().text().c_str());
    QCOMPARE(card->name, std::string("session.h5, touch 1"));
    // What row() of the fixture says: 2 s of a finger at 10 mm/s, 4 mm deep.
    QVERIFY2(std::abs(card->duration_s() - 2.0) < 0.1, qPrintable(QString::number(card->duration_s())));
    for (const auto& knot : card->rows) {
      QVERIFY(std::abs(knot.state.x_mm - (card->rows.front().state.x_mm + 10.0 * knot.time_s)) < 1e-6);
      QCOMPARE(knot.state.indentation_mm, 4.0);
    }
    const QByteArray before = contentOf(path);
    f.key(Qt::Key_G);  // once more: beside it, not over it
    WAIT_FOR(QFileInfo::exists(f.folder.filePath(QStringLiteral("session touch 1 (2).gesture"))));
    WAIT_FOR(f.page->work()->running().empty());
    QCOMPARE(contentOf(path), before);
  }
  void aCancelledExportLeavesNothingAndTheNextOneWorks() {
    WorkFixture f;
    for (const char* name : {"csv", "mat", "mcap", "html"}) {
      const QString ending = QString::fromLatin1(name);
      const QStringList before = f.files();
      Halt halt = recording::hdf5Lock();
      f.page->exports()->exportAs(ending);
      QVERIFY(f.bar() != nullptr);
      QVERIFY(f.bar()->words().contains(QStringLiteral("session.") + ending));
      f.page->exports()->exportAs(ending);  // impatience
      QVERIFY(f.told().contains(QStringLiteral("already")));
      QCOMPARE(f.page->work()->running().size(), std::size_t{1});
      f.cancelByClick(halt);
      QVERIFY(f.told().contains(QStringLiteral("cancelled; no file is left")));
      QCOMPARE(f.files(), before);
      f.page->exports()->exportAs(ending);
      WAIT_FOR(f.told().contains(QStringLiteral(" is written")));
      QVERIFY(f.files().contains(QStringLiteral("session.") + ending));
    }
  }

  void theKeyCancelsTheNewestFirst() {
    WorkFixture f;
    const QStringList before = f.files();
    f.cancelByKey();
    QVERIFY(f.told().contains(QStringLiteral("Nothing is running")));
    Halt halt = recording::hdf5Lock();
    f.page->exports()->exportAs(QStringLiteral("csv"));
    f.page->exports()->exportAs(QStringLiteral("mat"));
    const auto bars = f.page->work()->running();
    QCOMPARE(bars.size(), std::size_t{2});
    f.cancelByKey();
    QVERIFY(bars[0]->cancelButton()->isEnabled());
    QVERIFY(!bars[1]->cancelButton()->isEnabled());
    f.cancelByKey();
    QVERIFY(!bars[0]->cancelButton()->isEnabled());
    f.letGo(halt);
    QCOMPARE(f.files(), before);
  }

  void searchesAndFiguresAreCancelled() {
    WorkFixture f;
    Halt halt = recording::hdf5Lock();
    f.page->open(f.path);
    QVERIFY(f.bar() != nullptr && f.bar()->words().contains(QStringLiteral("touches in session.h5")));
    f.cancelByClick(halt);
    QCOMPARE(f.page->touches()->rowCount(), 0);
    f.page->open(f.path);
    f.waitForTouches();

    halt.lock();
    f.page->player()->goTo(0.5);
    f.key(Qt::Key_BracketLeft);
    f.page->player()->goTo(1.5);
    f.key(Qt::Key_BracketRight);
    f.cancelByClick(halt);
    QCOMPARE(f.page->figures()->rowCount(), 0);
    f.key(Qt::Key_BracketRight);
    WAIT_EQUAL(f.page->figures()->rowCount(), 5);

    halt.lock();
    f.page->comparison()->compare(f.path);
    f.cancelByClick(halt);
    const auto words = f.page->comparison()->findChildren<QLabel*>();
    QVERIFY(std::ranges::any_of(words, [](const QLabel* each) { return each->text().contains("was cancelled"); }));

    halt.lock();
    f.page->tabs()->setCurrentWidget(f.page->whatIf());
    QTest::mouseClick(f.page->whatIf()->runButton(), Qt::LeftButton);
    QVERIFY(!f.page->whatIf()->runButton()->isEnabled());
    f.cancelByClick(halt);
    QVERIFY(f.page->whatIf()->runButton()->isEnabled());
  }

  void theChosenSessionStaysChosenWhenTheListIsReadAgain() {
    ReviewFixture f;
    console::SessionList* list = f.page->list();
    const auto record = [&](const char* id, const char* started) {
      auto catalogue = catalogue::Catalogue::open({});
      return catalogue && catalogue->add({.id = id,
                                          .path = f.folder.filePath(QLatin1String(id)).toStdString(),
                                          .station = "here",
                                          .started_utc = started,
                                          .operator_name = id});
    };
    const auto lookAgain = [&](int rows) {
      list->look();
      WAIT_FOR(!list->looking());
      QCOMPARE(list->table()->rowCount(), rows);
    };
    QVERIFY(record("first", "2026-11-20T10:00:00.000Z") && record("second", "2026-11-21T10:00:00.000Z"));
    lookAgain(2);
    QCOMPARE(list->table()->currentRow(), -1);
    list->table()->setCurrentCell(0, 3);  // the newest is on top
    QVERIFY(list->path()->text().endsWith(QLatin1String("second")));
    QVERIFY(record("third", "2026-11-22T10:00:00.000Z"));
    list->path()->setText(QStringLiteral("/written/meanwhile.h5"));
    lookAgain(3);
    QCOMPARE(list->table()->currentRow(), 1);
    QCOMPARE(list->table()->currentColumn(), 3);
    QCOMPARE(list->table()->selectedItems().value(0)->toolTip(), f.folder.filePath(QStringLiteral("second")));
    QCOMPARE(list->path()->text(), QStringLiteral("/written/meanwhile.h5"));
    // Not among those found, then again.
    list->filter()->setText(QStringLiteral("third"));
    lookAgain(1);
    QCOMPARE(list->table()->currentRow(), -1);
    list->filter()->clear();
    lookAgain(3);
    QCOMPARE(list->table()->currentRow(), 1);
  }

  void aCrashedRecordingIsMadeWholeFromTheList() {
    ReviewFixture f;
    QVERIFY(QDir(f.folder.path()).mkdir(QStringLiteral("crashed")));
    const QString file = makeRecording(f.folder, QStringLiteral("crashed/killed.h5"), kPress, true);
    {
      auto catalogue = catalogue::Catalogue::open({});
      QVERIFY2(catalogue, catalogue ? "" : catalogue.error().text().c_str());
      QVERIFY(catalogue->addFolder(f.folder.filePath(QStringLiteral("crashed")).toStdString()));
    }
    f.page->list()->look();
    WAIT_EQUAL(f.page->list()->table()->rowCount(), 1);
    WAIT_EQUAL(f.page->list()->table()->item(0, 5)->text(), QStringLiteral("recorder crashed"));
    f.page->list()->table()->setCurrentCell(0, 0);
    QVERIFY(f.page->list()->words().contains(QStringLiteral("Recover makes it whole")));
    QCOMPARE(f.page->list()->path()->text(), file);
    QTest::mouseClick(f.page->list()->recoverButton(), Qt::LeftButton);
    WAIT_FOR(f.told().contains(QStringLiteral("killed.h5 is whole: 6000 samples")));
    QVERIFY(!QFile::exists(file));
    WAIT_EQUAL(f.page->list()->table()->item(0, 5)->text(), QStringLiteral("whole"));
    QCOMPARE(f.page->list()->table()->currentRow(), 0);
    QCOMPARE(f.page->list()->path()->text(), file.chopped(8));  // where it is now
    QVERIFY(f.page->showsList());
    f.openByPath(file.chopped(8));
    WAIT_EQUAL(f.page->touches()->rowCount(), 1);
    QVERIFY(f.page->title().contains(QStringLiteral("· whole")));
    QVERIFY(!f.page->recoverButton()->isVisible());
  }

  void theCrashedRecordingThatIsShownIsMadeWholeOrStaysAsItWas() {
    WorkFixture f;
    const QString file = makeRecording(f.folder, QStringLiteral("killed.h5"), kPress, true);
    f.page->open(file);
    f.waitForTouches();
    QVERIFY(f.page->title().contains(QStringLiteral("recorder crashed")));
    QVERIFY(f.page->recoverButton()->isVisible());
    f.page->writeNote(recording::NoteKind::note, QStringLiteral("squeaks"));
    QCOMPARE(f.page->notes()->rowCount(), 1);
    const QByteArray before = contentOf(file);
    const QStringList files = f.files();

    Halt halt = recording::hdf5Lock();
    QTest::mouseClick(f.page->recoverButton(), Qt::LeftButton);
    QVERIFY(f.bar() != nullptr && f.bar()->words().contains(QStringLiteral("Recovering killed.h5.partial")));
    f.cancelByClick(halt);
    QVERIFY(f.told().contains(QStringLiteral("is as it was")));
    QCOMPARE(f.files(), files);
    QVERIFY(contentOf(file) == before);
    QVERIFY(f.page->recoverButton()->isVisible());

    f.window->commands().action(QStringLiteral("review.recover"))->trigger();
    WAIT_FOR(f.told().contains(QStringLiteral("killed.h5 is whole")));
    WAIT_FOR(f.page->title().contains(QStringLiteral("· whole")));  // shown again, as it is now
    QVERIFY(!f.page->recoverButton()->isVisible());
    QCOMPARE(f.page->recording()->info().committed_samples, kRows);
    // Notes that were written before stay in view, those of earlier versions too.
    QCOMPARE(f.page->notes()->rowCount(), 1);
    const QString whole = f.folder.filePath(QStringLiteral("killed.h5"));
    QVERIFY(QFile::rename(whole + QStringLiteral(".notes.json"), file + QStringLiteral(".notes.json")));
    QVERIFY(f.page->open(whole));
    QCOMPARE(f.page->notes()->rowCount(), 1);
    QCOMPARE(f.page->notes()->item(0, 2)->text(), QStringLiteral("squeaks"));
  }

  void damagedCommitsAreSaidAndRecovered() {
    WorkFixture f;
    const QString file = makeRecording(f.folder, QStringLiteral("turned.h5"), kPress);
    const std::string path = file.toStdString();
    recording::samples::flipBit(path, recording::samples::commitAt(path, 3) + 50, 2);
    f.page->open(file);
    f.waitForTouches();
    QVERIFY2(f.page->title().contains(QStringLiteral("damaged")), qPrintable(f.page->title()));
    QVERIFY(f.page->recoverButton()->isVisible());
    QTest::mouseClick(f.page->recoverButton(), Qt::LeftButton);
    QTRY_VERIFY(f.told().contains(QStringLiteral("Nothing was lost")));
    QVERIFY(f.told().contains(QStringLiteral("turned.h5.damaged")));
    QTRY_VERIFY(f.page->title().contains(QStringLiteral("· whole")));
    QVERIFY(!f.page->recoverButton()->isVisible());
    QCOMPARE(f.page->recording()->info().committed_samples, kRows);
  }

  void stepsWhoseInputsAreLostAreKeptAndSaid() {
    WorkFixture f;
    const std::string path = f.path.toStdString();
    recording::samples::flipBit(path, recording::samples::chunkOf(path, "/inputs/motor_reference", 0).first + 9, 2);
    f.page->list()->path()->setText(f.path);
    QTest::mouseClick(f.page->list()->recoverButton(), Qt::LeftButton);
    QTRY_VERIFY(f.told().contains(QStringLiteral("all 6000 samples are saved")));
    QVERIFY(f.told().contains(QStringLiteral("/inputs/motor_reference")));
    f.page->open(f.path);
    f.waitForTouches();
    QVERIFY2(f.page->title().contains(QStringLiteral("parts missing")), qPrintable(f.page->title()));
  }

  void whatIsLostIsSaidAndTheDamagedFileIsKept() {
    ReviewFixture f;
    recording::samples::damageChunk(f.path.toStdString(), "/telemetry", 7);
    const QByteArray bytes = contentOf(f.path);
    f.page->list()->path()->setText(f.path);
    QTest::mouseClick(f.page->list()->recoverButton(), Qt::LeftButton);
    WAIT_FOR(f.told().contains(QStringLiteral("could not be read")));
    QVERIFY(f.told().contains(QStringLiteral("session.h5.damaged")));
    QVERIFY(contentOf(f.path + QStringLiteral(".damaged")) == bytes);
    const auto saved = recording::Recording::open(f.path.toStdString());
    QVERIFY(saved && (*saved)->info().committed_samples < kRows && (*saved)->info().committed_samples > kRows / 2);

    const QString nothing = f.folder.filePath(QStringLiteral("letter.h5"));
    QFile letter(nothing);
    QVERIFY(letter.open(QIODevice::WriteOnly));
    letter.write("Dear Sir");
    letter.close();
    f.page->list()->path()->setText(nothing);
    QTest::mouseClick(f.page->list()->recoverButton(), Qt::LeftButton);
    WAIT_FOR(f.told().contains(QStringLiteral("left as it is")));
    QCOMPARE(contentOf(nothing), QByteArray("Dear Sir"));
    f.page->list()->path()->clear();
    QTest::mouseClick(f.page->list()->recoverButton(), Qt::LeftButton);
    QVERIFY(f.page->work()->running().empty());
  }

  void theWindowClosesInTheMiddle() {
    WorkFixture f;
    const QString file = makeRecording(f.folder, QStringLiteral("killed.h5"), kPress, true);
    const QByteArray crashed = contentOf(file);
    const QStringList files = f.files();
    f.page->showList();
    f.page->list()->path()->setText(file);
    // The window's thread is going to wait for the work, so another one holds that up, and lets it go once all of it
    // was told to end.
    std::atomic<bool> held = false;
    std::atomic<bool> ended = false;
    const std::jthread other([&](const std::stop_token& stop) {
      const Halt halt = recording::hdf5Lock();
      held = true;
      const Instant end = Clock::now() + std::chrono::milliseconds(kPatience_ms);
      while (!ended && !stop.stop_requested() && Clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    });
    while (!held) std::this_thread::yield();
    for (const char* ending : {"csv", "mat", "mcap", "html", "pdf"}) {
      f.page->exports()->exportAs(QString::fromLatin1(ending));
    }
    QTest::mouseClick(f.page->list()->recoverButton(), Qt::LeftButton);
    const auto bars = f.page->work()->running();
    QCOMPARE(bars.size(), std::size_t{6});
    std::size_t still_running = bars.size();
    for (const ProgressBar* bar : bars) {
      QObject::connect(bar, &ProgressBar::shownChanged, [&, bar] {
        if (!bar->running() && --still_running == 0) ended = true;
      });
    }
    f.window.reset();
    QVERIFY2(ended, "all work is told to end before any of it is waited for");
    QVERIFY(contentOf(file) == crashed);
    const auto without = [](QStringList names) {  // the profile and its claim
      names.removeIf([](const QString& name) { return name.contains(QStringLiteral("profile.toml")); });
      return names;
    };
    QCOMPARE(without(f.files()), without(files));
  }
};

std::unique_ptr<QObject> makeReviewWorkTest() { return std::make_unique<ReviewWorkTest>(); }

}  // namespace fyd::tests

#include "review_work_test.moc"
