// Review: from the list to a recording, its cursor, marks, notes, touches, comparison, what-if and exports; a recording
// that is none. The recordings are made here, with numbers that are known.
#include <QClipboard>
#include <QDropEvent>
#include <QFileDialog>
#include <QMimeData>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/catalogue/archive_move.h"
#include "core/catalogue/catalogue.h"
#include "core/catalogue/catalogue_delivery.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/writer/picture_history.h"
#include "tests/widgets/reviewing.h"
#include "tests/widgets/suite.h"
#include "widgets/basics/number_text.h"

namespace fyd::tests {

namespace {

/// From the start to the end. The player moves by the clock's time since it last moved. That moment is not seen, but it
/// is after the move before was told and before its own is: no standstill of the machine makes a sound player fail.
void playsAt(ReviewFixture& f, double speed) {
  console::ReviewPlayer* player = f.page->player();
  const double end_s = f.page->recording()->info().duration_s;
  struct Move {
    double told_s;  ///< since the key
    double time_s;
  };
  std::vector<Move> moves;
  for (int play = 0; moves.size() < 3; ++play) {  // fewer say nothing: a machine that stood still plays it again
    QVERIFY2(play < 20, qPrintable(QString::number(moves.size())));
    moves.clear();
    player->goTo(0.0);
    const Instant key = Clock::now();
    QObject listener;  // however this turn ends, nobody listens after it
    QObject::connect(player, &console::ReviewPlayer::moved, &listener, [&](double time_s) {
      if (time_s < end_s) moves.push_back({toSeconds(Clock::now() - key), time_s});
    });
    f.key(Qt::Key_Space);
    QVERIFY(player->playing());
    WAIT_FOR(!player->playing());  // it stops at the end
    QCOMPARE(player->time_s(), end_s);
  }
  const std::size_t last = moves.size() - 1;
  const double rounded_s = 1e-3 * static_cast<double>(last);  // down, to whole milliseconds, at each move
  const double least_s = moves[last - 1].told_s - moves[0].told_s - rounded_s;
  const QString words = QStringLiteral("%1 moves to %2 s in %3 s").arg(last + 1).arg(moves[last].time_s);
  QVERIFY2(moves[last].time_s - moves[0].time_s >= speed * least_s, qPrintable(words.arg(least_s)));
  QVERIFY2(moves[last].time_s <= speed * moves[last].told_s, qPrintable(words.arg(moves[last].told_s)));
}

std::string idOf(const QString& path) {
  const auto opened = recording::Recording::open(path.toStdString());
  return opened ? (*opened)->info().header.id : std::string();
}
Result<recording::ReviewNotes> notesOf(const QString& path) {
  return recording::readReviewNotes(path.toStdString(), idOf(path));
}

}  // namespace

class ReviewTest : public QObject {
  Q_OBJECT
 private slots:
  void anEmptyCatalogueTeachesAndAWrongFileIsToldInWords() {
    ReviewFixture f;
    QVERIFY(f.page->showsList());
    WAIT_FOR(!f.page->list()->looking());
    QVERIFY(f.page->list()->words().contains(QStringLiteral("Ctrl+R")));
    f.page->list()->path()->setText(f.folder.filePath(QStringLiteral("nothing.h5")));
    QTest::keyClick(f.page->list()->path(), Qt::Key_Return);
    QVERIFY(f.page->list()->words().contains(QStringLiteral("nothing.h5")));
    QVERIFY(f.page->showsList());
    f.page->list()->path()->clear();
    QTest::keyClick(f.page->list()->path(), Qt::Key_Return);
    QVERIFY(f.page->showsList());
  }

  void aRecordingOpensWithItsTouchAndFigures() {
    ReviewFixture f;
    f.openByPath();
    QVERIFY(!f.page->showsList());
    QVERIFY(f.page->title().contains(QStringLiteral("S07")));
    QVERIFY(f.page->title().contains(QStringLiteral("M. Muster")));
    WAIT_EQUAL(f.page->touches()->rowCount(), 1);
    QCOMPARE(f.page->touches()->item(0, 0)->text(), QStringLiteral("2.00"));
    QCOMPARE(f.page->touches()->item(0, 2)->text(), QStringLiteral("2.00"));
    f.page->touches()->setCurrentCell(0, 0);
    QVERIFY(std::abs(f.page->player()->time_s() - 2.0) < 0.0011);
    f.page->curves()->redraw();
    QCOMPARE(f.page->curves()->readout(0)->valueText(0), QStringLiteral("2.00"));
  }

  void aSpikeOfOneSampleIsSeenAtEveryZoom() {
    ReviewFixture f;
    f.openByPath();
    const double at_s = 1e-3 * static_cast<double>(kSpike);
    for (const double span_s : {6.0, 2.0, 0.5, 0.05}) {
      f.page->curves()->show(at_s - 0.5 * span_s, at_s + 0.5 * span_s);
      f.page->curves()->redraw();
      QCOMPARE(f.page->curves()->strip(0)->drawnExtent().upper, 7.0);
    }
  }

  void theCursorStepsBySampleAndPlaysAtItsSpeed() {
    ReviewFixture f;
    f.openByPath();
    f.page->player()->goTo(1.0);
    f.key(Qt::Key_Right);
    QVERIFY(std::abs(f.page->player()->time_s() - 1.001) < 1e-6);
    f.key(Qt::Key_Left);
    f.key(Qt::Key_Left);
    QVERIFY(std::abs(f.page->player()->time_s() - 0.999) < 1e-6);
    for (const double speed : {4.0, 16.0}) {
      f.page->player()->setSpeed(speed);
      playsAt(f, speed);
      if (QTest::currentTestFailed()) return;
    }
  }

  void figuresBetweenAAndBAreThoseOfTheSamples() {
    ReviewFixture f;
    f.openByPath();
    f.page->player()->goTo(0.5);
    f.key(Qt::Key_BracketLeft);
    f.page->player()->goTo(1.5);
    f.key(Qt::Key_BracketRight);
    f.page->curves()->redraw();
    QCOMPARE(f.page->curves()->strip(0)->markWords(), QStringLiteral("Δ 1.00 N"));
    QVERIFY(f.page->curves()->stack()->markText().contains(QStringLiteral("Δt 1.000 s")));
    WAIT_EQUAL(f.page->figures()->rowCount(), 5);
    QCOMPARE(f.page->figures()->item(0, 3)->text(), QStringLiteral("1.000"));     // B − A, N
    QCOMPARE(f.page->figures()->item(0, 4)->text(), QStringLiteral("1.000"));     // N/s
    QCOMPARE(f.page->figures()->item(0, 5)->text(), QStringLiteral("1.000"));     // mean
    QCOMPARE(f.page->figures()->item(2, 5)->text(), QString(widgets::kNoValue));  // no stiffness before the touch
  }

  void figuresOfABehindBStandUnderTheirNamesAndGoWithTheMarks() {
    ReviewFixture f;
    const QString other = makeRecording(f.folder, QStringLiteral("other.h5"), 3000);
    f.openByPath();
    console::FiguresTable* table = f.page->figures();
    const auto heading = [&] { return table->horizontalHeaderItem(0)->text(); };
    const QString none = heading();
    const auto mark = [&] {
      f.page->player()->goTo(1.5);
      f.key(Qt::Key_BracketLeft);
      f.page->player()->goTo(0.5);
      f.key(Qt::Key_BracketRight);
      WAIT_EQUAL(table->rowCount(), 5);
    };
    mark();
    QCOMPARE(table->item(0, 1)->text(), QStringLiteral("1.500"));       // at A
    QCOMPARE(table->item(0, 2)->text(), QStringLiteral("0.500"));       // at B
    QCOMPARE(table->item(0, 3)->text(), widgets::numberText(-1.0, 3));  // B − A
    QCOMPARE(table->item(0, 4)->text(), QStringLiteral("1.000"));       // N/s, whichever mark is first
    QCOMPARE(heading(), QStringLiteral("Δt %1 s").arg(widgets::numberText(-1.0, 3)));
    f.key(Qt::Key_Backslash);
    QCOMPARE(table->rowCount(), 0);
    QCOMPARE(heading(), none);
    mark();
    QVERIFY(heading() != none);
    QVERIFY(f.page->open(other));
    QCOMPARE(table->rowCount(), 0);
    QCOMPARE(heading(), none);
  }

  void overTheListNoCommandActsOnTheHiddenRecording() {
    ReviewFixture f;
    const auto offered = [&](const char* id) { return f.window->commands().action(QLatin1String(id))->isEnabled(); };
    QVERIFY(!offered("review.export_csv") && offered("review.open"));  // nothing is open yet
    f.openByPath();
    QVERIFY(offered("review.export_csv") && offered("review.bookmark"));
    f.page->player()->goTo(1.0);
    QTest::keyClick(f.window.get(), Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(f.page->showsList());
    const QDir folder(f.folder.path());
    const QStringList files = folder.entryList(QDir::Files);
    const auto tab = f.page->tabs()->currentIndex();
    f.window->setFocus();
    for (const int key : {Qt::Key_B, Qt::Key_BracketLeft, Qt::Key_Space, Qt::Key_Right, Qt::Key_N, Qt::Key_E}) {
      QTest::keyClick(f.window.get(), static_cast<Qt::Key>(key));
    }
    QTest::keyClick(f.window.get(), Qt::Key_P, Qt::ControlModifier);
    for (QAction* each : f.window->commands().actions()) {
      if (!each->objectName().startsWith(QLatin1String("review."))) continue;
      const QStringList of_list = {QStringLiteral("review.open"), QStringLiteral("review.list"),
                                   QStringLiteral("review.compare"), QStringLiteral("review.recover"),
                                   QStringLiteral("review.cancel")};
      QVERIFY2(each->isEnabled() == of_list.contains(each->objectName()), qPrintable(each->objectName()));
    }
    QCOMPARE(folder.entryList(QDir::Files), files);  // no bookmark beside it, no report
    QVERIFY(!f.page->player()->playing() && f.page->player()->time_s() == 1.0);
    QVERIFY(!std::isfinite(f.page->curves()->stack()->mark_s(widgets::CurveStack::Mark::a)));
    QCOMPARE(f.page->tabs()->currentIndex(), tab);
    f.openByPath();
    f.key(Qt::Key_B);
    QCOMPARE(f.page->notes()->rowCount(), 1);
  }

  void aNoteStandsBesideTheFileAndTheRecordingIsUnchanged() {
    ReviewFixture f;
    f.openByPath();
    QFile recording(f.path);
    QVERIFY(recording.open(QIODevice::ReadOnly));
    const QByteArray before = recording.readAll();
    f.page->player()->goTo(3.0);
    f.key(Qt::Key_N);
    QVERIFY(f.page->noteField()->hasFocus());
    QTest::keyClicks(f.page->noteField(), QStringLiteral("feels soft <b>"));
    QTest::keyClick(f.page->noteField(), Qt::Key_Return);
    QVERIFY(f.page->curves()->hasFocus());  // the next key is a command again, and the note is seen in its list
    QCOMPARE(f.page->notes()->item(f.page->notes()->currentRow(), 2)->text(), QStringLiteral("feels soft <b>"));
    f.key(Qt::Key_B);
    QCOMPARE(f.page->notes()->rowCount(), 2);
    const auto notes = notesOf(f.path);
    QVERIFY2(notes, notes ? "" : notes.error().text().c_str());
    QCOMPARE(notes->notes.size(), std::size_t{2});
    QCOMPARE(QString::fromStdString(notes->notes.front().text), QStringLiteral("feels soft <b>"));
    recording.seek(0);
    QVERIFY(recording.readAll() == before);
    // A damaged file of notes is told, and not written over without a word.
    QFile beside(QString::fromStdString(recording::reviewNotesPath(f.path.toStdString())));
    QVERIFY(beside.open(QIODevice::WriteOnly));
    beside.write("{\"notes\": [{\"kind\": 3}]}");
    beside.close();
    f.page->open(f.path);
    QVERIFY(f.told().contains(QStringLiteral("note 1")));
    f.page->writeNote(recording::NoteKind::note, QStringLiteral("one more"));
    QVERIFY(beside.open(QIODevice::ReadOnly));
    QVERIFY(beside.readAll().startsWith("{\"notes\": [{\"kind\": 3}]}"));
  }

  void tagsAndNotesAddedLaterAreFoundAndMoveWithTheRecording() {
    ReviewFixture f;
    const auto found = [](const char* words) {
      const auto entries = catalogue::Catalogue::open("").and_then(
          [&](const catalogue::Catalogue& catalogue) { return catalogue.search({.text = words}); });
      return entries ? static_cast<int>(entries->size()) : -1;
    };
    QVERIFY(catalogue::catalogueRecording("", f.path.toStdString()));
    f.openByPath();
    QFile recording(f.path);
    QVERIFY(recording.open(QIODevice::ReadOnly));
    const QByteArray before = recording.readAll();
    QCOMPARE(found("velvet"), 0);
    f.key(Qt::Key_T, Qt::ShiftModifier);
    QVERIFY(f.page->tagsField()->hasFocus());
    f.page->tagsField()->setText(QStringLiteral("velvet,  left hand,"));
    QTest::keyClick(f.page->tagsField(), Qt::Key_Return);
    f.page->writeNote(recording::NoteKind::note, QStringLiteral("squeaks"));
    WAIT_EQUAL(found("velvet"), 1);
    WAIT_EQUAL(found("squeaks"), 1);
    f.page->tagsField()->setText(QStringLiteral("velvet"));
    QTest::keyClick(f.page->tagsField(), Qt::Key_Return);
    WAIT_EQUAL(found("left"), 0);
    QCOMPARE(found("velvet"), 1);
    f.page->open(f.path);
    QCOMPARE(f.page->tagsField()->text(), QStringLiteral("velvet"));
    recording.seek(0);
    QVERIFY(recording.readAll() == before);
    // A catalogue made anew from the files knows them too.
    const auto entry = catalogue::readCatalogueEntry(f.path.toStdString());
    QVERIFY(entry && entry->tags == std::vector<std::string>{"velvet"} && entry->notes == "squeaks");
    f.page->tagsField()->setText(QString(1000, QLatin1Char('x')));  // too long
    QTest::keyClick(f.page->tagsField(), Qt::Key_Return);
    QCOMPARE(f.page->recording() != nullptr, true);
    QVERIFY(notesOf(f.path)->tags == std::vector<std::string>{"velvet"});
    const QString shelf = f.folder.filePath(QStringLiteral("shelf"));
    QVERIFY(QDir().mkpath(shelf));
    QVERIFY(catalogue::storeClosed(f.path.toStdString(), shelf.toStdString(), "none"));
    const auto moved = notesOf(shelf + QStringLiteral("/session.h5"));
    QVERIFY(moved && moved->tags && moved->notes.size() == 1);
    // The recording that is still open here is no longer at its place.
    const QString left = QString::fromStdString(recording::reviewNotesPath(f.path.toStdString()));
    QVERIFY(!QFile::exists(left));
    f.page->writeNote(recording::NoteKind::note, QStringLiteral("to nobody"));
    QVERIFY(f.told().contains(QStringLiteral("No such file")));
    QVERIFY(!QFile::exists(left));
  }

  void aClickOnTheCurvesGivesThePlaceItsKeysBack() {
    ReviewFixture f;
    f.openByPath();
    for (QWidget* clicked :
         {static_cast<QWidget*>(f.page->curves()->strip(0)->plot()), static_cast<QWidget*>(f.page->overview())}) {
      QVERIFY(!clicked->toolTip().contains(QStringLiteral("follow")));  // nothing does here
      f.page->noteField()->setFocus();
      f.page->player()->goTo(0.0);
      QTest::mouseClick(clicked, Qt::LeftButton, {}, clicked->rect().center());
      QVERIFY(f.page->curves()->hasFocus());
      QVERIFY(f.page->player()->time_s() > 0.0);
    }
  }

  void whatAnotherWindowWroteMeanwhileStays() {
    ReviewFixture f;
    f.openByPath();
    f.page->writeNote(recording::NoteKind::note, QStringLiteral("ours"));
    auto there = notesOf(f.path);  // the other window
    QVERIFY(there && there->notes.size() == 1);
    there->notes.push_back({.time_s = 0.5, .text = "theirs"});
    there->tags = std::vector<std::string>{"velvet"};
    QVERIFY(recording::writeReviewNotes(f.path.toStdString(), idOf(f.path), *there));
    f.page->tagsField()->setText(QStringLiteral("left hand"));
    QTest::keyClick(f.page->tagsField(), Qt::Key_Return);
    f.page->writeNote(recording::NoteKind::note, QStringLiteral("ours too"));
    const auto now = notesOf(f.path);
    QVERIFY(now && now->notes.size() == 3);
    QVERIFY(now->tags == (std::vector<std::string>{"left hand", "velvet"}));
    QCOMPARE(f.page->tagsField()->text(), QStringLiteral("left hand, velvet"));
    const auto shown = [&] {
      QStringList words;
      for (int row = 0; row < f.page->notes()->rowCount(); ++row) words << f.page->notes()->item(row, 2)->text();
      return words;
    };
    QVERIFY(shown().contains(QStringLiteral("theirs")));
  }

  void ofAnotherRecordingUnderTheSameNameNothingIsMade() {
    ReviewFixture f;
    f.openByPath();
    const QString other = makeRecording(f.folder, QStringLiteral("other.h5"));
    QVERIFY(QFile::remove(f.path) && QFile::rename(other, f.path));
    const QString why = QStringLiteral("another recording has this name now");
    f.page->noteField()->setText(QStringLiteral("soft"));
    QTest::keyClick(f.page->noteField(), Qt::Key_Return);
    QVERIFY2(f.told().contains(why), qPrintable(f.told()));
    QVERIFY(!QFile::exists(QString::fromStdString(recording::reviewNotesPath(f.path.toStdString()))));
    f.page->exports()->exportAs(QStringLiteral("csv"));
    WAIT_FOR(f.page->exports()->underWay().isEmpty());
    QVERIFY(!QFile::exists(f.folder.filePath(QStringLiteral("session.csv"))));
    f.page->whatIf()->run();
    WAIT_FOR(f.page->whatIf()->words().contains(why));
    // Opened again it is the other one, and the note that was refused is not left for it.
    QVERIFY(f.page->open(f.path));
    QVERIFY(f.page->noteField()->text().isEmpty());
    f.page->writeNote(recording::NoteKind::note, QStringLiteral("hard"));
    QCOMPARE(notesOf(f.path)->notes.size(), std::size_t{1});
    // Nor are its notes those of a third that came there before it was opened.
    const QString third = makeRecording(f.folder, QStringLiteral("third.h5"));
    QVERIFY(QFile::remove(f.path) && QFile::rename(third, f.path));
    QVERIFY(f.page->open(f.path));
    QVERIFY2(f.told().contains(QStringLiteral("notes are of another recording")), qPrintable(f.told()));
    QCOMPARE(f.page->notes()->rowCount(), 0);
    QFile beside(QString::fromStdString(recording::reviewNotesPath(f.path.toStdString())));
    QVERIFY(beside.open(QIODevice::ReadOnly));
    const QByteArray before = beside.readAll();
    f.page->writeNote(recording::NoteKind::note, QStringLiteral("lost"));
    QVERIFY(beside.seek(0) && beside.readAll() == before);
  }

  void aGrowingRecordingIsSeenAsFarAsTheWindowSays() {
    ReviewFixture f;
    const QString path = f.folder.filePath(QStringLiteral("grow.h5"));
    auto writer = recording::RecordingWriter::create(
        path.toStdString(), {.id = std::string(32, 'e'), .started = Instant(std::chrono::seconds(100))});
    QVERIFY(writer);
    const auto grow = [&](std::uint64_t from, std::uint64_t to) {
      for (std::uint64_t i = from; i < to; ++i) {
        recording::StepRecord record = row(i, kPress);
        if (i == kSpike) (void)record.events.push({.kind = pipeline::EventKind::tare_done});
        if (!(*writer)->append(record)) return false;
      }
      return (*writer)->commit().has_value();
    };
    QVERIFY(grow(0, kPress));
    f.openByPath(path + QStringLiteral(".partial"));
    QVERIFY2(f.page->title().contains(QStringLiteral("still being recorded")), qPrintable(f.page->title()));
    WAIT_FOR(f.page->work()->running().empty());
    QCOMPARE(f.page->notes()->rowCount(), 0);
    const auto comeBack = [&] {
      QTest::keyClick(f.window.get(), Qt::Key_1, Qt::ControlModifier);
      QTest::keyClick(f.window.get(), Qt::Key_3, Qt::ControlModifier);
    };
    QVERIFY(grow(kPress, kRows));
    comeBack();
    QCOMPARE(f.page->notes()->rowCount(), 1);
    QCOMPARE(f.page->overview()->marks().size(), std::size_t{1});
    WAIT_EQUAL(f.page->touches()->rowCount(), 1);
    // Once it is closed it has another name, by which all that is made of it finds it.
    QVERIFY((*writer)->close());
    writer->reset();
    comeBack();
    QVERIFY2(f.page->title().startsWith(QStringLiteral("grow.h5 ")), qPrintable(f.page->title()));
    QVERIFY2(f.page->title().contains(QStringLiteral("whole")), qPrintable(f.page->title()));
    f.page->writeNote(recording::NoteKind::note, QStringLiteral("soft"));
    QCOMPARE(notesOf(path)->notes.size(), std::size_t{1});
    f.page->exports()->exportAs(QStringLiteral("csv"));
    WAIT_FOR(f.page->exports()->underWay().isEmpty());
    QVERIFY2(QFile::exists(f.folder.filePath(QStringLiteral("grow.csv"))), qPrintable(f.told()));
    QCOMPARE(f.page->recent().paths().constFirst(), path);
  }

  void inAHoleOfLostSamplesThereIsNoValue() {
    ReviewFixture f;
    const QString path = f.folder.filePath(QStringLiteral("hole.h5"));
    auto writer = recording::RecordingWriter::create(
        path.toStdString(), {.id = std::string(32, 'f'), .started = Instant(std::chrono::seconds(100))});
    QVERIFY(writer);
    for (std::uint64_t i = 0; i < kRows; ++i) {
      if (i < 2000 || i >= 5000) QVERIFY((*writer)->append(row(i, kRows)));
    }
    QVERIFY((*writer)->close());
    f.openByPath(path);
    const auto& source = f.page->curves()->source();
    for (const double at_s : {1.9995, 2.02, 5.0005, 6.02})
      QVERIFY2(source.valueAt(0, at_s) > 1.9, qPrintable(QString::number(at_s)));
    for (const double at_s : {2.1, 3.5, 4.9995, 6.1})
      QVERIFY2(std::isnan(source.valueAt(0, at_s)), qPrintable(QString::number(at_s)));
  }

  void aPictureThatCannotBeReadIsNotOneThatWasNotTaken() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("pictures.h5"));
    auto writer = recording::RecordingWriter::create(
        path.toStdString(), {.id = std::string(32, 'c'), .started = Instant(std::chrono::seconds(100))});
    QVERIFY(writer);
    cv::Mat noise(240, 320, CV_8UC1);
    cv::RNG(1).fill(noise, cv::RNG::UNIFORM, 0, 255);
    for (std::uint64_t i = 0; i < kRows; ++i) {
      QVERIFY((*writer)->append(row(i, kPress)));
      if (i != 1000 && i != 3000) continue;
      QVERIFY((*writer)->append(recording::encodePicture(
          {.picture = noise, .region_px = {10, 10, 300, 200}, .taken = row(i, kPress).inputs.now, .number = i})));
    }
    QVERIFY((*writer)->close());
    const auto opened = recording::Recording::open(path.toStdString());
    QVERIFY(opened);
    console::ReviewCamera camera;
    const auto words = [&](double time_s) {
      camera.showAt(opened->get(), time_s);
      return camera.findChild<QLabel*>()->text();
    };
    QCOMPARE(words(0.5), QStringLiteral("No picture was taken before the cursor."));
    QVERIFY(!words(1.5).contains(QStringLiteral("No picture")));
    QVERIFY(QFile::resize(path, 1'100'000));
    QVERIFY2(words(3.5).startsWith(path), qPrintable(words(3.5)));
  }

  void aStretchIsExportedAndItsFolderShown() {
    ReviewFixture f;
    f.openByPath();
    console::ExportPanel* panel = f.page->tabs()->exportPanel();
    f.key(Qt::Key_E);
    QVERIFY(f.page->tabs()->currentWidget() == panel);
    QVERIFY(!panel->stretchButton()->isEnabled());
    f.page->player()->goTo(1.5);
    f.page->setMark(widgets::CurveStack::Mark::a);
    f.page->player()->goTo(0.5);
    f.page->setMark(widgets::CurveStack::Mark::b);  // before A: the stretch is the same
    QVERIFY(panel->stretchButton()->text().contains(QStringLiteral("0.500 s to 1.500 s")));
    panel->stretchButton()->click();
    panel->writeButton()->click();
    WAIT_EQUAL(panel->written()->count(), 1);
    QFile csv(f.folder.filePath(QStringLiteral("session 0.500-1.500 s.csv")));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    const auto lines = csv.readAll().split('\n').size();
    QVERIFY2(lines >= 1001 && lines <= 1003, qPrintable(QString::number(lines)));  // with the names and the end
    QUrl shown;
    bool opens = true;
    panel->setOpenFolder([&](const QUrl& url) {
      shown = url;
      return opens;
    });
    panel->folderButton()->click();
    QCOMPARE(shown.toLocalFile(), QFileInfo(csv).absolutePath());
    QVERIFY(panel->words().isEmpty());
    opens = false;
    panel->folderButton()->click();
    QVERIFY(panel->words().contains(QFileInfo(csv).absolutePath()));
    panel->copyButton()->click();
    QCOMPARE(QApplication::clipboard()->text(), csv.fileName());
    panel->writeButton()->click();  // never over a file, and the place says so
    WAIT_FOR(panel->words().contains(QStringLiteral("exists")));
    panel->format()->setCurrentIndex(panel->format()->findData(QStringLiteral("pdf")));
    QVERIFY(!panel->stretchButton()->isEnabled() && panel->wholeButton()->isChecked());
  }

  void aDroppedFileOpensAndThoseOpenedLatelyAreRemembered() {
    ReviewFixture f;
    QTest::keyClick(f.window.get(), Qt::Key_1, Qt::ControlModifier);  // dropped in another place
    const auto drop = [&](const QString& file) {
      QMimeData data;
      data.setUrls({QUrl::fromLocalFile(file)});
      QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(f.window.get(), &enter);
      QVERIFY(enter.isAccepted());
      QDropEvent dropped(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(f.window.get(), &dropped);
    };
    const QString wrong = f.folder.filePath(QStringLiteral("shopping.txt"));
    QFile text(wrong);
    QVERIFY(text.open(QIODevice::WriteOnly));
    text.write("milk\n");
    text.close();
    drop(wrong);
    QVERIFY(f.page->showsList());
    QVERIFY2(f.page->list()->words().contains(QStringLiteral("shopping.txt")), qPrintable(f.page->list()->words()));
    drop(f.path);
    QVERIFY(f.page->isVisible() && !f.page->showsList());
    QVERIFY(f.page->title().contains(QStringLiteral("S07")));
    QCOMPARE(f.page->recent().paths(), QStringList{f.path});

    const QString memory = f.folder.filePath(QStringLiteral("memory.ini"));
    console::RecentRecordings first;
    first.keepIn(memory);
    for (int i = 0; i < 20; ++i) first.add(QStringLiteral("/sessions/%1.h5").arg(i));
    first.add(QStringLiteral("/sessions/15.h5"));
    console::RecentRecordings second;
    second.keepIn(memory);
    QCOMPARE(second.paths().size(), console::RecentRecordings::kMost);
    QCOMPARE(second.paths().mid(0, 2),
             (QStringList{QStringLiteral("/sessions/15.h5"), QStringLiteral("/sessions/19.h5")}));
    QMenu menu;
    QString asked;
    second.fill(menu, [&](const QString& path) { asked = path; });
    emit menu.aboutToShow();
    QVERIFY(menu.actions().front()->text().contains(QStringLiteral("not there")));
    menu.actions().front()->trigger();
    QCOMPARE(asked, QStringLiteral("/sessions/15.h5"));
  }

  void aDialogOpensAFileAndNothingIsModal() {
    ReviewFixture f;
    f.key(Qt::Key_O, Qt::ControlModifier);
    auto* dialog = f.window->findChild<QFileDialog*>(QStringLiteral("recording_dialog"));
    QVERIFY(dialog != nullptr && dialog->isVisible() && !dialog->isModal());
    // What a mend sets aside, also the second time.
    QVERIFY2(dialog->nameFilters().constFirst().contains(QStringLiteral("*.h5.damaged*")),
             qPrintable(dialog->nameFilters().constFirst()));
    emit dialog->fileSelected(f.path);
    dialog->close();
    QVERIFY(!f.page->showsList());
    f.key(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(f.page->showsList());
  }

  void twoAreComparedAndATimeIsGoneTo() {
    ReviewFixture f;
    const QString other = makeRecording(f.folder, QStringLiteral("other.h5"), 3000);
    f.page->list()->compareChosen();
    QVERIFY(f.page->list()->words().contains(QStringLiteral("two")));
    emit f.page->list()->compareAsked(f.path, other);
    QVERIFY(!f.page->showsList());
    QVERIFY(f.page->tabs()->currentWidget() == f.page->comparison());
    const std::size_t force = console::ReviewSource::channel(console::ReviewLayer::other, 0);
    QVERIFY(f.page->curves()->source().valueAt(force, 2.5) > 2.2);  // its touch begins at 3 s
    f.key(Qt::Key_J);
    QVERIFY(f.page->timeField()->hasFocus());
    for (const char* wrong : {"99", "later"}) {
      f.page->timeField()->setText(QString::fromUtf8(wrong));
      QTest::keyClick(f.page->timeField(), Qt::Key_Return);
      QVERIFY2(f.page->timeField()->problem().contains(QString::fromUtf8(wrong)), wrong);
      QCOMPARE(f.page->player()->time_s(), 0.0);
    }
    f.page->timeField()->setText(QStringLiteral("0:02.5"));
    QTest::keyClick(f.page->timeField(), Qt::Key_Return);
    QCOMPARE(f.page->player()->time_s(), 2.5);
    f.page->curves()->redraw();
    QCOMPARE(f.page->curves()->readout(0)->when(), QStringLiteral("at 2.500 s"));
  }

  void aSecondSessionLiesOnATouch() {
    ReviewFixture f;
    const QString other = makeRecording(f.folder, QStringLiteral("other.h5"), 3000);
    f.openByPath();
    WAIT_EQUAL(f.page->touches()->rowCount(), 1);
    f.page->comparison()->compare(other);
    QComboBox* their = nullptr;
    for (QComboBox* box : f.page->findChildren<QComboBox*>()) {
      if (box->accessibleName() == QStringLiteral("Align the other session at")) their = box;
    }
    QVERIFY(their != nullptr);
    WAIT_EQUAL(their->count(), 2);
    f.page->comparison()->alignAt(0, 0);
    // Its touch began a second later: laid on this one's, it is drawn a second earlier.
    const std::size_t force = console::ReviewSource::channel(console::ReviewLayer::other, 0);
    QCOMPARE(f.page->curves()->source().valueAt(force, 2.5), 2.0);
    QVERIFY(f.page->curves()->source().valueAt(force, 1.5) > 2.2);  // 2.5 s of its slope
  }

  void theChosenTouchesAreThoseThatTheCurvesLieOn() {
    ReviewFixture f;
    const QString other = makeRecording(f.folder, QStringLiteral("other.h5"), 3000);
    f.openByPath();
    WAIT_EQUAL(f.page->touches()->rowCount(), 1);
    console::ReviewComparison* comparison = f.page->comparison();
    comparison->compare(other);
    QComboBox *our = nullptr, *their = nullptr;
    for (QComboBox* box : comparison->findChildren<QComboBox*>()) {
      (box->accessibleName() == QStringLiteral("Align the other session at") ? their : our) = box;
    }
    WAIT_EQUAL(their->count(), 2);
    their->setCurrentIndex(1);  // its time 3 s at this one's start
    const std::size_t force = console::ReviewSource::channel(console::ReviewLayer::other, 0);
    const auto drawn = [&] { return f.page->curves()->source().valueAt(force, 0.5); };
    QCOMPARE(drawn(), 2.0);
    const exports::Touch touch{.start_s = 2.0, .end_s = 4.0};
    comparison->setTouches({touch, touch});  // found anew
    QCOMPARE(their->currentIndex(), 1);
    QCOMPARE(our->currentIndex(), 0);
    QCOMPARE(drawn(), 2.0);
    our->setCurrentIndex(2);
    comparison->setTouches({});  // the touch is there no more
    QCOMPARE(our->currentIndex(), 0);
    QCOMPARE(drawn(), 2.0);
    comparison->compare(other);
    QVERIFY(our->currentIndex() == 0 && their->currentIndex() == 0);
    QCOMPARE(drawn(), 0.5);
  }

  void trialsAreBegunByAKeyAndMarkedWhileRecordingOnly() {
    ReviewFixture f;
    QVERIFY(!f.window->trials()->plan({.conditions = {QStringLiteral("soft"), QStringLiteral("soft")}}));
    QVERIFY(
        f.window->trials()->plan({.conditions = {QStringLiteral("soft"), QStringLiteral("hard")}, .repetitions = 2}));
    QTest::keyClick(f.window.get(), Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(f.told().contains(QStringLiteral("nothing is being recorded")));
    QCOMPARE(f.window->trials()->begun(), std::size_t{0});
    f.session->recorder.state = recording::RecorderState::recording;
    for (int press = 0; press < 6; ++press)
      QTest::keyClick(f.window.get(), Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(f.session->notes.size(), std::size_t{8});  // four trials, each begun and ended
    for (std::size_t i = 0; i < 8; i += 2) {
      QVERIFY(f.session->notes[i].first == recording::NoteKind::trial_start);
      QVERIFY(f.session->notes[i + 1].first == recording::NoteKind::trial_end);
      QCOMPARE(f.session->notes[i].second, f.session->notes[i + 1].second);
    }
    QVERIFY(f.told().contains(QStringLiteral("All 4")));
  }

  void aTrialEndsWithItsRecording() {
    Fixture f;
    QVERIFY(
        f.window->trials()->plan({.conditions = {QStringLiteral("soft"), QStringLiteral("hard")}, .repetitions = 1}));
    const auto key = [&] { QTest::keyClick(f.window.get(), Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier); };
    f.session->recorder = {.state = recording::RecorderState::recording, .path = "/a.h5"};
    key();
    QCOMPARE(f.session->notes.size(), std::size_t{1});
    f.session->recorder.path = "/b.h5";
    key();
    QCOMPARE(f.session->notes.size(), std::size_t{2});
    QVERIFY(f.session->notes.back().first == recording::NoteKind::trial_start);
    key();
    QVERIFY(f.session->notes.back().first == recording::NoteKind::trial_end);
    QCOMPARE(f.session->notes.back().second, f.session->notes[1].second);
  }

  void wrongWhatIfEntriesAreSaidInWords() {
    ReviewFixture f;
    f.openByPath();
    console::WhatIfPanel* panel = f.page->whatIf();
    f.page->tabs()->setCurrentWidget(panel);
    panel->parameter()->setCurrentText(QStringLiteral("control.nothing"));
    QTest::mouseClick(panel->addButton(), Qt::LeftButton);
    QVERIFY(panel->words().contains(QStringLiteral("control.nothing")));
    panel->parameter()->setCurrentText(QStringLiteral("control.kp"));
    for (const char* wrong : {"", "nan", "1e99", "soft"}) {
      panel->value()->setText(QString::fromUtf8(wrong));
      QTest::mouseClick(panel->addButton(), Qt::LeftButton);
      QVERIFY2(panel->words().contains(QStringLiteral("control.kp")), wrong);
      QCOMPARE(panel->settings()->count(), 0);
    }
    panel->value()->setText(QStringLiteral("20"));
    QTest::mouseClick(panel->addButton(), Qt::LeftButton);
    QCOMPARE(panel->settings()->count(), 1);
    QTest::mouseClick(panel->runButton(), Qt::LeftButton);
    WAIT_FOR(!panel->words().startsWith(QStringLiteral("Running")));
    QVERIFY(!panel->words().isEmpty());  // these rows hold no state of the step: it says so
  }

  void exportsStandBesideTheFileAndAreNeverWrittenOver() {
    ReviewFixture f;
    f.openByPath();
    f.page->exports()->exportAs(QStringLiteral("csv"));
    WAIT_FOR(f.told().contains(QStringLiteral("session.csv is written")));
    f.page->exports()->exportAs(QStringLiteral("csv"));
    WAIT_FOR(f.told().contains(QStringLiteral("exists")));
    f.page->exports()->exportAs(QStringLiteral("html"));
    WAIT_FOR(f.told().contains(QStringLiteral("session.html is written")));
  }

  void whatIsShownIsSavedBesideTheFile() {
    ReviewFixture f;
    f.openByPath();
    f.page->curves()->show(1.0, 2.0);
    f.key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
    WAIT_FOR(f.told().contains(QStringLiteral(".csv is written")));
    const QStringList found =
        QDir(f.folder.path()).entryList({QStringLiteral("session curves*.csv")}, QDir::Files, QDir::Size);
    QVERIFY(!found.isEmpty());
    QFile csv(f.folder.filePath(found.first()));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = csv.readAll().split('\n');
    QVERIFY(lines.front().contains("force_N"));
    QVERIFY(!lines.front().contains("robot_x_mm"));
    QVERIFY(lines.size() >= 1001 && lines.size() <= 1003);  // 1 s with or without its ends, the names, the end
    f.key(Qt::Key_G, Qt::ControlModifier);
    WAIT_FOR(f.told().contains(QStringLiteral(".png is written")));
  }

  void theSpectrumLooksAtTheRecording() {
    ReviewFixture f;
    f.openByPath();
    f.key(Qt::Key_S);
    QVERIFY(f.page->curveTools()->spectrum()->isVisible());
    WAIT_FOR(f.page->curveTools()->spectrum()->words().contains(QStringLiteral("m/s²")));
    f.key(Qt::Key_S);
  }
};

std::unique_ptr<QObject> makeReviewTest() { return std::make_unique<ReviewTest>(); }

}  // namespace fyd::tests

#include "review_test.moc"
