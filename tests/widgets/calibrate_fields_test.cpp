// Every field of the place "Calibrate" with entries that are none: said in words, taken as no point, and nothing
// breaks.
#include "core/station/profile/calibration_file.h"
#include "tests/widgets/calibrating.h"
#include "tests/widgets/suite.h"
#include "widgets/basics/number_text.h"

namespace fyd::tests {
namespace {

struct Part {
  QString id;
  QStringList fields;
  std::vector<bool> may_be_empty;
  bool on_picture = false;
  bool moves = false;
};

/// All that have fields; of several sensors the first.
std::vector<Part> parts() {
  std::vector<Part> out;
  for (const auto& step : console::makeCalibrationSteps(station::Profile{})) {
    QStringList fields;
    std::vector<bool> may_be_empty;
    for (const console::CalibrationEntry& entry : step->entries()) {
      fields << entry.name;
      may_be_empty.push_back(std::isfinite(entry.empty));
    }
    if (fields.isEmpty() || step->sensor() > 1) continue;
    out.push_back({step->id(), fields, may_be_empty, step->picture() == console::CalibrationStep::Picture::place,
                   step->motion() != console::CalibrationStep::Motion::none});
  }
  return out;
}

/// What a hand or a clipboard may leave in a field.
QStringList badEntries() {
  return {"",      "  ",      "ten",   "nan",   "inf",    "-inf",      "0x10",
          "1,2,3", "1.000,5", "--1",   "12 mm", "\u0663", "1e999",     "-1e300",
          "-2000", "1e6",     "50;50", "5 0",   "\u221e", "<b>50</b>", QString(300, QLatin1Char('9'))};
}

/// What must be said of it.
const char* complaintOf(const QString& entry) {
  if (entry.trimmed().isEmpty()) return "type a number first";
  return std::isfinite(widgets::readNumber(entry)) ? "is out of range; expected" : "is no number";
}

}  // namespace

class CalibrateFieldsTest : public QObject {
  Q_OBJECT
 private slots:
  void everyFieldSaysWhatIsWrongWithItsEntry() {
    Calibrating c("camera");
    c.session->view.picture = cv::Mat(240, 320, CV_8UC1, cv::Scalar(200));
    c.session->view.number = 1;
    c.window->feed().pump();
    console::CalibrationEntryForm* form = c.page->entries();
    QVERIFY(parts().size() >= 4);
    for (const Part& part : parts()) {
      c.page->choose(part.id);
      if (part.on_picture) c.click(c.page->picture());
      for (qsizetype i = 0; i < part.fields.size(); ++i) {
        for (const QString& bad : badEntries()) {
          if (bad.trimmed().isEmpty() && part.may_be_empty[static_cast<std::size_t>(i)]) continue;
          for (qsizetype other = 0; other < part.fields.size(); ++other) {
            form->field(static_cast<std::size_t>(other))->setText(other == i ? bad : QStringLiteral("20"));
          }
          QTest::keyClick(form->field(static_cast<std::size_t>(i)), Qt::Key_Return);
          c.readings(12);
          const QString problem = form->problem();
          const QByteArray where = QStringLiteral("%1 '%2': %3").arg(part.fields[i], bad.left(20), problem).toUtf8();
          QVERIFY2(c.page->points().empty(), where);
          if (part.moves) (void)form->read();  // read when the button is held; tested with the motors
          QVERIFY2(form->problem().startsWith(part.fields[i] + QStringLiteral(": ")), where);
          QVERIFY2(form->problem().contains(QLatin1String(complaintOf(bad))), where);
          QVERIFY2(form->problem().size() < 100, where);  // an enormous entry is not said in full
          QVERIFY2(form->field(static_cast<std::size_t>(i))->property("refused").toBool(), where);
        }
      }
      // The other sign of decimals, and the typeset minus of the program's own numbers.
      form->field(0)->setText(QStringLiteral("50,5"));
      if (part.fields.size() > 1) form->field(1)->setText(QStringLiteral("\u221250.5"));
      if (part.fields.size() > 2) form->field(2)->clear();
      const auto read = form->read();
      QVERIFY2(read && read->front() == 50.5 && (read->size() < 2 || (*read)[1] == -50.5), qPrintable(part.id));
      QVERIFY2(form->problem().isEmpty(), qPrintable(part.id));
    }
    c.page->choose(QStringLiteral("camera"));
    c.click(c.page->picture());
    form->field(0)->setText(QStringLiteral("-12,5"));
    form->field(1)->setText(QStringLiteral("7"));
    c.click(c.page->takeButton());
    QCOMPARE(c.page->points().size(), std::size_t{1});
    QCOMPARE(c.page->points().front()[2], -12.5);
    QCOMPARE(c.page->points().front()[4], 0.0);  // nothing typed: not pressed down
    QCOMPARE(c.page->table()->item(0, 2)->text(), QStringLiteral("\u221212.500"));
  }

  void whoAndConditionsMayHoldAnything() {
    Calibrating c("load-cell");
    const QString who = QStringLiteral("M. \"Muster\" \\ '''\u00e9 [x] = 1 # \U0001f600");
    c.click(c.page->simulateButton());
    const auto field = [&](const char* name) { return c.page->fitPanel()->findChild<QLineEdit*>(QLatin1String(name)); };
    field("calibration_who")->setText(who);
    field("calibration_conditions")->setText(QString(50000, QLatin1Char('w')));
    c.click(c.page->acceptButton());
    const auto records = station::loadCalibrationRecords(c.profilePath());
    QVERIFY2(records.has_value(), records ? "" : records.error().text().c_str());
    QCOMPARE(QString::fromStdString(records->front().who), who);
    QVERIFY(records->front().conditions.size() < 500);
    c.click(c.page->reportButton());
    QVERIFY2(c.page->hint().contains(QLatin1String("stands beside")), qPrintable(c.page->hint()));
  }
};

std::unique_ptr<QObject> makeCalibrateFieldsTest() { return std::make_unique<CalibrateFieldsTest>(); }

}  // namespace fyd::tests

#include "calibrate_fields_test.moc"
