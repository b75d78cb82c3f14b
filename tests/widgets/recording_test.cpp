// Recording from the window: the journey from Ctrl+R to a closed file, entries that cannot be taken, notes and markers,
// and what is told when something goes wrong.
#include "core/catalogue/catalogue.h"
#include "tests/widgets/reviewing.h"
#include "tests/widgets/scripted_session.h"
#include "tests/widgets/suite.h"

namespace fyd::tests {

using recording::RecorderState;

namespace {

void write(QLineEdit* field, const QString& text) {
  field->setFocus();
  field->selectAll();
  if (text.isEmpty()) QTest::keyClick(field, Qt::Key_Delete);
  QTest::keyClicks(field, text);
}

/// A window with the panel open and entries that can be taken.
struct RecordingFixture : Fixture {
  RecordingFixture() {
    window->resize(1280, 720);  // the button shows both of its lines
    QTest::keyClick(window.get(), Qt::Key_R, Qt::ControlModifier);
    form = window->recording()->form();
    write(form->operatorField(), QStringLiteral("M. Muster"));
    write(form->fileField(), folder.filePath(QStringLiteral("new folder/one.h5")));
  }
  void waitForDisk() const { WAIT_FOR(form->startButton()->isEnabled()); }
  void press(QPushButton* button) const {
    QTest::mouseClick(button, Qt::LeftButton);
    waitForDisk();
  }
  [[nodiscard]] QString button() const { return window->stateBar()->recordButton()->text(); }
  [[nodiscard]] QString told() const {
    const int count = window->notices()->count();
    return count == 0 ? QString() : window->notices()->text(count - 1);
  }
  widgets::RecordingForm* form;
};

}  // namespace

class RecordingTest : public QObject {
  Q_OBJECT
 private slots:
  void whatIsNoTextIsNotPastedIntoTheNotes() {
    RecordingFixture f;
    QClipboard* clipboard = QApplication::clipboard();
    clipboard->setMimeData(new QMimeData);  // as of a desktop where nothing was ever selected
    f.form->notesField()->paste();
    clipboard->setImage(QImage(8, 8, QImage::Format_RGB32));
    f.form->notesField()->paste();
    QCOMPARE(f.form->notesField()->toPlainText(), QString());
    clipboard->setText(QStringLiteral("from elsewhere"));
    f.form->notesField()->paste();
    QCOMPARE(f.form->notesField()->toPlainText(), QStringLiteral("from elsewhere"));
    clipboard->clear();
  }

  void initialsAndEnterAfterTheKeyRecord() {
    Fixture f;
    QTest::keyClick(f.window.get(), Qt::Key_R, Qt::ControlModifier);
    widgets::RecordingForm* form = f.window->recording()->form();
    write(form->fileField(), f.folder.filePath(QStringLiteral("two.h5")));
    f.window->recording()->dock()->hide();
    QTest::keyClick(f.window.get(), Qt::Key_R, Qt::ControlModifier);
    QVERIFY(form->operatorField()->hasFocus());
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("mm"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    WAIT_FOR(form->startButton()->isEnabled());
    QCOMPARE(f.session->recordings.size(), std::size_t{1});
    QCOMPARE(f.session->recordings[0].operator_name, std::string("mm"));
  }

  void fromTheKeyToAClosedFile() {
    RecordingFixture f;
    QVERIFY(f.window->recording()->dock()->isVisible());
    write(f.form->subjectField(), QStringLiteral("S07"));
    write(f.form->tagsField(), QStringLiteral(" pilot,left hand ,, pilot"));
    QTest::keyClicks(f.form->notesField(), QStringLiteral("first try"));
    f.press(f.form->startButton());
    QCOMPARE(f.session->recordings.size(), std::size_t{1});
    const recording::RecordingRequest& asked = f.session->recordings[0];
    QCOMPARE(asked.path, f.folder.filePath(QStringLiteral("new folder/one.h5")).toStdString());
    QCOMPARE(asked.operator_name, std::string("M. Muster"));
    QCOMPARE(asked.subject, std::string("S07"));
    QCOMPARE(asked.notes, std::string("first try"));
    QCOMPARE(asked.tags, (std::vector<std::string>{"pilot", "left hand"}));
    QVERIFY(QFileInfo(f.folder.filePath(QStringLiteral("new folder"))).isDir());
    QCOMPARE(f.form->notesField()->toPlainText(), QString());  // they are this recording's, not the next one's

    f.session->recorder.seconds = 751.4;
    f.session->recorder.bytes = 24'100'000;
    f.session->recorder.minutes_left = 41.7;
    f.window->feed().pump();
    QCOMPARE(f.button(), QStringLiteral("REC 00:12:31\n24.1 MB · 41 min left"));
    QVERIFY(f.form->stopButton()->isVisible() && !f.form->startButton()->isVisible());
    QVERIFY(!f.form->subjectField()->isVisible());

    // Ctrl+R again only shows where to stop.
    f.window->recording()->dock()->hide();
    QTest::keyClick(f.window.get(), Qt::Key_R, Qt::ControlModifier);
    QCOMPARE(f.session->recording_stops, 0);
    QVERIFY(f.form->stopButton()->hasFocus());
    QTest::keyClick(f.form->stopButton(), Qt::Key_Return);
    f.waitForDisk();
    QCOMPARE(f.session->recording_stops, 1);
    QVERIFY(f.told().contains(QStringLiteral("one.h5")));
    QCOMPARE(f.button(), QStringLiteral("Record"));
    QVERIFY(f.form->fileField()->text() != QString::fromStdString(asked.path));
  }

  void theWindowListensWhileTheDiskIsWaitedFor() {
    RecordingFixture f;
    f.session->say(pipeline::SafetyState::ready);
    f.window->feed().pump();
    const auto esc_is_heard = [&] {
      const int before = f.session->stops;
      QTest::keyClick(f.window.get(), Qt::Key_Escape);
      return f.session->stops > before;
    };
    f.session->disk_waits = true;
    f.form->startButton()->setFocus();
    QTest::keyClick(f.form->startButton(), Qt::Key_Return);
    QVERIFY(!f.form->startButton()->isEnabled());
    QVERIFY(esc_is_heard());
    QTest::keyClick(f.form->operatorField(), Qt::Key_Return);  // nothing is begun twice
    QVERIFY2(f.window->connection().hindrance().contains(QStringLiteral("beginning")),
             qPrintable(f.window->connection().hindrance()));
    f.session->disk_waits = false;
    f.waitForDisk();
    QCOMPARE(f.session->recordings.size(), std::size_t{1});
    QVERIFY(f.told().startsWith(QStringLiteral("Recording into ")));
    QVERIFY(f.form->stopButton()->hasFocus());

    f.session->disk_waits = true;
    QTest::mouseClick(f.form->stopButton(), Qt::LeftButton);
    QVERIFY(!f.form->stopButton()->isEnabled() && f.form->stopButton()->isVisible());
    QVERIFY(esc_is_heard());
    f.session->disk_waits = false;
    f.waitForDisk();
    QCOMPARE(f.session->recording_stops, 1);
    QVERIFY(f.told().startsWith(QStringLiteral("Recording closed: ")));
    QVERIFY(f.form->startButton()->hasFocus());

    // A disk that refuses after a while: it can be tried again.
    f.session->disk_waits = true;
    f.session->refuses = true;
    f.form->startButton()->setFocus();
    QTest::keyClick(f.form->startButton(), Qt::Key_Return);
    QVERIFY(!f.form->startButton()->hasFocus());
    f.session->disk_waits = false;
    f.waitForDisk();
    QVERIFY(f.told().startsWith(QStringLiteral("Not recording.")));
    QVERIFY(f.form->startButton()->hasFocus());
    f.session->refuses = false;
  }

  void aRecordingThatHasEndedAgainIsNotSaidToBeUnderWay() {
    RecordingFixture f;
    f.session->recording_ends = true;
    f.press(f.form->startButton());
    QCOMPARE(f.told(), QStringLiteral("Not recording. The session has ended meanwhile."));
    f.session->disk_throws = true;
    f.press(f.form->startButton());
    QCOMPARE(f.told(), QStringLiteral("Recording failed. bad disk by the script"));
    QVERIFY(f.window->connection().hindrance() != console::ConnectionChange::recorderWaitsText());
  }

  void aWindowClosedWhileARecordingBeginsClosesIt() {
    RecordingFixture f;
    f.session->disk_waits = true;
    QTest::mouseClick(f.form->startButton(), Qt::LeftButton);
    const std::jthread disk([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      f.session->disk_waits = false;
    });
    f.window->close();
    QCOMPARE(f.session->recordings.size(), std::size_t{1});
    QCOMPARE(f.session->recording_stops, 1);
    QVERIFY(f.session->stops >= 1 && f.session->shut_downs >= 1);
    // One that goes without having been closed waits as well.
    RecordingFixture gone;
    gone.session->disk_waits = true;
    QTest::mouseClick(gone.form->startButton(), Qt::LeftButton);
    std::atomic<bool> written = false;
    const std::jthread later([&written, session = gone.session] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      written = true;
      session->disk_waits = false;
    });
    gone.window.reset();
    QVERIFY(written);
  }

  void whatIsSaidOfARecordingGoesWhenItIsClosed() {
    RecordingFixture f;
    const auto said = [&] {
      QStringList out;
      for (int i = 0; i < f.window->notices()->count(); ++i) out << f.window->notices()->text(i);
      return out;
    };
    QTest::keyClick(f.window.get(), Qt::Key_M, Qt::ControlModifier);
    QVERIFY(said().join(QLatin1Char('|')).contains(QStringLiteral("nothing is being recorded")));
    f.press(f.form->startButton());
    QCOMPARE(said().size(), 1);  // something is, now
    QVERIFY2(said()[0].startsWith(QStringLiteral("Recording into ")), qPrintable(said()[0]));
    QTest::keyClick(f.window.get(), Qt::Key_M, Qt::ControlModifier);
    QCOMPARE(said().size(), 2);
    f.press(f.form->stopButton());
    QVERIFY2(said().size() == 1 && said()[0].startsWith(QStringLiteral("Recording closed: ")),
             qPrintable(said().join(QLatin1Char('|'))));
  }

  void aRecordingThatEndedWholeBecauseTheDiskGotFullIsInTheCatalogue() {
    RecordingFixture f;
    f.press(f.form->startButton());
    const QString closed = makeRecording(f.folder, QStringLiteral("full.h5"));
    QSignalSpy catalogued(f.window->recording(), &console::RecordingControl::catalogued);
    f.session->recorder = {
        .state = RecorderState::failed, .path = closed.toStdString(), .problem = say("whole up to here")};
    f.window->feed().pump();
    WAIT_EQUAL(catalogued.count(), 1);
    f.window->feed().pump();
    const auto entries = catalogue::Catalogue::open("").and_then(
        [](const catalogue::Catalogue& catalogue) { return catalogue.search({}); });
    QVERIFY(entries.has_value());
    const std::string file = QFileInfo(closed).canonicalFilePath().toStdString();
    QVERIFY(std::ranges::any_of(*entries, [&](const auto& each) { return each.path == file; }));
  }

  void entriesThatCannotBeTakenAreMarkedAndSaidInWords() {
    RecordingFixture f;
    const QString present = f.folder.filePath(QStringLiteral("present.h5"));
    QFile file(present);
    QVERIFY(file.open(QIODevice::WriteOnly));
    struct Case {
      QLineEdit* field;
      QString wrong;
      QString word;
    };
    for (const Case& each :
         {Case{f.form->operatorField(), QString(), QStringLiteral("Operator")},
          {f.form->operatorField(), QString(81, QLatin1Char('x')), QStringLiteral("80")},
          {f.form->subjectField(), QStringLiteral("Erika Muster"), QStringLiteral("never a name")},
          {f.form->subjectField(), QString(33, QLatin1Char('S')), QStringLiteral("32")},
          {f.form->tagsField(), QString(33, QLatin1Char('t')), QStringLiteral("Tag")},
          {f.form->tagsField(), QStringLiteral("a,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p,q"), QStringLiteral("17")},
          {f.form->fileField(), QString(), QStringLiteral("File")},
          {f.form->fileField(), QStringLiteral("here.h5"), QStringLiteral("whole path")},
          {f.form->fileField(), f.folder.filePath(QStringLiteral("one.csv")), QStringLiteral(".h5")},
          {f.form->fileField(), f.folder.filePath(QStringLiteral(".h5")), QStringLiteral(".h5")},
          {f.form->fileField(), present, QStringLiteral("never written over")}}) {
      const QString right = each.field->text();
      write(each.field, each.wrong);
      QTest::keyClick(each.field, Qt::Key_Return);
      QVERIFY2(f.session->recordings.empty(), qPrintable(each.wrong));
      QVERIFY2(f.form->hint().contains(each.word), qPrintable(f.form->hint()));
      QVERIFY(each.field->property("refused").toBool() && each.field->hasFocus());
      write(each.field, right);
      QVERIFY(!each.field->property("refused").toBool());
    }
    f.form->notesField()->setPlainText(QString(2001, QLatin1Char('n')));
    f.press(f.form->startButton());
    QVERIFY(f.form->hint().contains(QStringLiteral("2000")));
    f.form->notesField()->clear();
    f.press(f.form->startButton());
    QCOMPARE(f.session->recordings.size(), std::size_t{1});
  }

  void markersAndNotesGoIntoTheRecordingAndOnlyThere() {
    RecordingFixture f;
    QTest::keyClick(f.window.get(), Qt::Key_M, Qt::ControlModifier);
    QVERIFY(f.session->notes.empty());
    QVERIFY(f.told().contains(QStringLiteral("nothing is being recorded")));
    f.press(f.form->startButton());
    f.session->recorder.seconds = 3.0;
    f.window->feed().pump();
    f.window->frame()->go(QStringLiteral("devices"));  // from every place
    QTest::keyClick(f.window.get(), Qt::Key_M, Qt::ControlModifier);
    QTest::keyClick(f.window.get(), Qt::Key_M, Qt::ControlModifier);
    write(f.form->noteField(), QStringLiteral("  cloth  changed "));
    QTest::keyClick(f.form->noteField(), Qt::Key_Return);
    QTest::keyClick(f.form->noteField(), Qt::Key_Return);  // an empty line is no note
    f.session->refuses = true;
    write(f.form->noteField(), QStringLiteral("long words"));
    QTest::keyClick(f.form->noteField(), Qt::Key_Return);
    QCOMPARE(f.form->noteField()->text(), QStringLiteral("long words"));
    using Noted = std::pair<recording::NoteKind, std::string>;
    QCOMPARE(f.session->notes, (std::vector<Noted>{{recording::NoteKind::bookmark, "Marker 1"},
                                                   {recording::NoteKind::bookmark, "Marker 2"},
                                                   {recording::NoteKind::note, "cloth changed"}}));
  }

  void lostSamplesAreAnErrorAndToldOnce() {
    RecordingFixture f;
    f.press(f.form->startButton());
    f.window->notices()->dismissAll();
    f.session->recorder.lost = 120;
    f.window->feed().pump();
    f.session->recorder.lost = 130;
    f.window->feed().pump();
    QVERIFY(f.button().contains(QStringLiteral("130 samples lost")));
    QCOMPARE(f.window->stateBar()->recordButton()->property("role").toString(), QStringLiteral("danger"));
    QVERIFY(f.form->hint().contains(QStringLiteral("safe")));
    QCOMPARE(f.window->log()->lines(), 2);  // the start and this
  }

  void aFailureSaysWhatHappenedWhatIsSafeAndWhatToDo() {
    RecordingFixture f;
    f.session->refuses = true;
    f.press(f.form->startButton());
    QVERIFY(f.told().contains(QStringLiteral("refused by the script")));
    QVERIFY(f.form->startButton()->isVisible());
    f.session->refuses = false;
    f.press(f.form->startButton());
    f.session->recorder.state = RecorderState::failed;
    f.session->recorder.problem = verbatim("the disk is full; what was written is safe; free some space");
    f.window->feed().pump();
    f.window->feed().pump();
    QVERIFY(f.told().contains(QStringLiteral("free some space")));
    QVERIFY(f.button().contains(QStringLiteral("failed")));
    QVERIFY(f.form->startButton()->isVisible());
    QVERIFY(f.form->hint().contains(QStringLiteral("what was written is safe")));
    // And one that does not close as it should.
    write(f.form->fileField(), f.folder.filePath(QStringLiteral("two.h5")));
    f.press(f.form->startButton());
    f.window->feed().pump();
    f.session->refuses = true;
    f.press(f.form->stopButton());
    QVERIFY2(f.told().contains(QStringLiteral("did not close")), qPrintable(f.told()));
  }

  void aFailureIsReadThoughTheRecordingWasNeverSeenToRun() {
    RecordingFixture f;
    const QString usual = f.form->hint();
    f.session->recorder = {.state = RecorderState::failed,
                           .path = f.folder.filePath(QStringLiteral("one.h5")).toStdString(),
                           .problem = verbatim("the disk is full; free some space")};
    f.window->feed().pump();
    QVERIFY(f.button().contains(QStringLiteral("failed")));
    QVERIFY2(f.form->hint().contains(QStringLiteral("free some space")), qPrintable(f.form->hint()));
    // What is said of an entry stays while there is no other failure.
    write(f.form->operatorField(), {});
    QTest::keyClick(f.form->operatorField(), Qt::Key_Return);
    const QString about_the_entry = f.form->hint();
    QVERIFY(!about_the_entry.contains(QStringLiteral("free some space")));
    f.window->feed().pump();
    QCOMPARE(f.form->hint(), about_the_entry);
    f.session->recorder = {};
    f.window->feed().pump();
    QCOMPARE(f.form->hint(), usual);
  }

  void whatIsAlwaysTheSameIsRemembered() {
    RecordingFixture f;
    write(f.form->subjectField(), QStringLiteral("S07"));
    write(f.form->tagsField(), QStringLiteral("pilot, left hand"));
    QTest::keyClicks(f.form->notesField(), QStringLiteral("only for this one"));
    f.press(f.form->startButton());
    console::MainWindow again(std::make_unique<ScriptedSession>(), f.folder.filePath(QStringLiteral("profile.toml")));
    const widgets::RecordingEntries kept = again.recording()->form()->entries();
    QCOMPARE(kept.operator_name, QStringLiteral("M. Muster"));
    QCOMPARE(kept.subject, QStringLiteral("S07"));
    QCOMPARE(kept.tags, (QStringList{QStringLiteral("pilot"), QStringLiteral("left hand")}));
    QVERIFY(kept.notes.isEmpty());
    QVERIFY2(kept.file.contains(QStringLiteral("FYD sessions/")) && kept.file.endsWith(QStringLiteral(" S07.h5")),
             qPrintable(kept.file));
  }

  void figuresAreWrittenAsAnOperatorReadsThem() {
    QCOMPARE(widgets::clockText(0.0), QStringLiteral("00:00:00"));
    QCOMPARE(widgets::clockText(359'999.9), QStringLiteral("99:59:59"));
    QCOMPARE(widgets::clockText(-3.0), QStringLiteral("00:00:00"));
    QCOMPARE(widgets::clockText(std::nan("")), QStringLiteral("00:00:00"));
    QCOMPARE(widgets::bytesText(640'000), QStringLiteral("640 kB"));
    QCOMPARE(widgets::bytesText(1'250'000'000), QStringLiteral("1.25 GB"));
    QCOMPARE(widgets::timeLeftText(0.4), QStringLiteral("under 1 min left"));
    QCOMPARE(widgets::timeLeftText(400.0), QStringLiteral("6 h left"));
    QVERIFY(widgets::timeLeftText(std::nan("")).isEmpty());
  }
};

std::unique_ptr<QObject> makeRecordingTest() { return std::make_unique<RecordingTest>(); }

}  // namespace fyd::tests

#include "recording_test.moc"
