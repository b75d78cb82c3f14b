// Every page in three languages and both themes at the scale of this process (QT_SCALE_FACTOR): nothing cut off,
// nothing over anything else, at 1280×720. With FYD_LOOKS_FOLDER the pictures are kept, for people.
#include "app/console/calibrate/calibrate_page.h"
#include "app/console/shell/key_guard.h"
#include "app/console/shell/language.h"
#include "app/console/tune/tune_page.h"
#include "app/console/window/places.h"
#include "tests/own_home.h"
#include "tests/widgets/device_reports.h"
#include "tests/widgets/look_check.h"
#include "tests/widgets/reviewing.h"

Q_DECLARE_METATYPE(fyd::widgets::ThemeChoice)

namespace fyd::tests {
class LooksTest : public QObject {
  Q_OBJECT
 private slots:
  void everyPageInEveryLanguage_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<widgets::ThemeChoice>("theme");
    for (const console::Language& each : console::languages()) {
      for (const auto theme : {widgets::ThemeChoice::dark, widgets::ThemeChoice::light}) {
        const QString name = QLatin1String(each.code) + QLatin1Char('-') + widgets::themeWord(theme);
        QTest::newRow(qPrintable(name)) << QString::fromLatin1(each.code) << theme;
      }
    }
  }

  void everyPageInEveryLanguage() {
    QFETCH(QString, language);
    QFETCH(widgets::ThemeChoice, theme);
    console::speak(*qApp, language);
    widgets::Look::instance().apply(*qApp, theme);
    Fixture f;
    qputenv("XDG_DATA_HOME", f.folder.filePath(QStringLiteral("data")).toUtf8());
    f.window->resize(1280, 720);
    f.session->reports = {touchpad()};
    f.session->now.parts = {{.part = device::Part::touchpad, .ok = true, .rate_hz = 1000, .age_ms = 1},
                            {.part = device::Part::camera, .ok = true, .rate_hz = 30, .age_ms = 12},
                            {.part = device::Part::robot, .ok = true, .rate_hz = 1000, .age_ms = 2}};
    f.session->now.link.local = "127.0.0.1:3490";
    f.session->now.link.protocol = say("classic, not secured");
    f.session->view.picture = cv::Mat(240, 320, CV_8UC1, cv::Scalar(200));
    f.session->view.number = 1;
    pipeline::TelemetrySample sample;
    sample.now = instantAt(1.0);
    sample.state = pipeline::SafetyState::held;
    sample.fault = pipeline::Fault::steps_missed;  // the longest of the reasons
    f.session->telemetry.push_back(sample);
    f.window->feed().pump();
    QCOMPARE(f.window->size(), QSize(1280, 720));

    for (const console::PlaceInfo& place : console::places()) {
      go(f, place.id);
      look(f, place.id);
    }
    go(f, "calibrate");
    auto* calibrate = qobject_cast<console::CalibratePage*>(f.window->frame()->page(QStringLiteral("calibrate")));
    for (int part = 1; part < calibrate->parts()->count(); ++part) {
      calibrate->parts()->setCurrentRow(part);
      look(f, qPrintable(QStringLiteral("calibrate-%1").arg(part)));
    }
    go(f, "tune");
    auto* tune = qobject_cast<console::TunePage*>(f.window->frame()->page(QStringLiteral("tune")));
    tune->response()->setResponse(widgets::TuningResponse::proposed, {.course = {{0.0, 84.0}, {1.0, 100.0}}});
    for (int tab = 0; tab < tune->tabs()->count(); ++tab) {
      tune->tabs()->setCurrentIndex(tab);
      look(f, qPrintable(QStringLiteral("tune-%1").arg(tab)));
    }
    f.window->review(makeRecording(f.folder, QStringLiteral("session.h5")));
    look(f, "review-recording");
    auto* review = qobject_cast<console::ReviewPage*>(f.window->frame()->page(QStringLiteral("review")));
    widgets::ProgressBar* bar = review->work()->add();
    bar->begin(QStringLiteral("session.h5"));
    bar->setDone(1.0);
    WAIT_FOR(bar->isVisible());
    look(f, "review-working");
    bar->end();
    go(f, "operate");
    f.window->commands().action(QStringLiteral("view.link"))->trigger();
    look(f, "link");
    f.window->commands().action(QStringLiteral("view.link"))->trigger();
    f.window->commands().action(QStringLiteral("session.record"))->trigger();
    look(f, "recording");
    f.window->recording()->dock()->hide();
    f.window->commands().action(QStringLiteral("view.log"))->trigger();
    look(f, "log");
    f.window->commands().action(QStringLiteral("view.log"))->trigger();
    f.window->help()->showTopic(QStringLiteral("operate.md#curves"));
    for (const char* place : {"operate", "review", "devices", "tune", "calibrate"}) {
      go(f, place);
      look(f, qPrintable(QStringLiteral("help-%1").arg(QLatin1String(place))));
      QVERIFY2(f.window->stateBar()->height() <= 120, qPrintable(QString::number(f.window->stateBar()->height())));
    }
    calibrate->choose(QStringLiteral("stiffness"));
    QTest::mouseClick(calibrate->simulateButton(), Qt::LeftButton);
    look(f, "help-calibrate-points");
    f.window->help()->hide();
    look(f, "calibrate-points");
    go(f, "operate");
    f.window->layouts()->open();
    lookAt(*f.window->layouts(), "layouts");
    f.window->palette()->open();
    lookAt(*f.window->palette(), "palette");
  }

 private:
  static void go(const Fixture& f, const char* place) { f.window->frame()->go(QLatin1String(place)); }
  static void look(const Fixture& f, const char* page) {
    lookAt(*f.window, page);
    QCOMPARE(f.window->size(), QSize(1280, 720));  // no panel pushes it apart
  }
  static void lookAt(QWidget& window, const char* page) {
    passTimers(20);  // what is laid out when the event loop comes round
    const QString name = QLatin1String(QTest::currentDataTag()) + QLatin1Char('-') + QLatin1String(page);
    // What comes later, as found devices, needs a moment to be laid out.
    QStringList faults;
    const auto faultless = [&] {
      faults = lookFaults(window);
      return faults.isEmpty();
    };
    (void)QTest::qWaitFor(faultless, kPatience_ms);
    if (const QString folder = qEnvironmentVariable("FYD_LOOKS_FOLDER"); !folder.isEmpty()) {
      window.grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
    }
    for (const QString& fault : faults) qWarning("%s: %s", qPrintable(name), qPrintable(fault));
    QVERIFY2(faults.isEmpty(), qPrintable(name));
  }
};

}  // namespace fyd::tests

int main(int argc, char** argv) {
  const fyd::OwnHome home;
  fyd::console::Application application(argc, argv);
  fyd::tests::LooksTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "looks_main.moc"
