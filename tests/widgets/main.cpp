#include "app/console/shell/key_guard.h"
#include "tests/own_home.h"
#include "tests/widgets/suite.h"
#include "widgets/basics/theme.h"

int main(int argc, char** argv) {
  const fyd::OwnHome home;
  fyd::console::Application application(argc, argv);
  QLocale::setDefault(QLocale(QStringLiteral("en")));  // whatever the machine speaks
  fyd::widgets::Look::instance().apply(application, fyd::widgets::ThemeChoice::dark);
  int failed = 0;
  for (auto make : {fyd::tests::makeCurveLineTest,
                    fyd::tests::makeCurveTest,
                    fyd::tests::makeCurveToolsTest,
                    fyd::tests::makeControlTest,
                    fyd::tests::makeTuningTest,
                    fyd::tests::makeTuneTest,
                    fyd::tests::makeLinkTest,
                    fyd::tests::makeConsoleTest,
                    fyd::tests::makeConnectionTest,
                    fyd::tests::makeFrameTest,
                    fyd::tests::makeRecordingTest,
                    fyd::tests::makeCalibrateTest,
                    fyd::tests::makeCalibrateFieldsTest,
                    fyd::tests::makeCalibrateMotionTest,
                    fyd::tests::makeReviewTest,
                    fyd::tests::makeReviewWorkTest,
                    fyd::tests::makeMannersTest,
                    fyd::tests::makeJourneyTest,
                    fyd::tests::makeSceneViewTest,
                    fyd::tests::makeSceneDockTest}) {
    const auto suite = make();
    // While working on one: its name, or a part of it, and which of its tests.
    if (argc > 1 && !QByteArray(suite->metaObject()->className()).contains(argv[1])) continue;
    // Without Qt's own handler, whose SIGABRT after a watchdog's end never ends.
    QStringList words = {QLatin1String(argv[0]), QStringLiteral("-nocrashhandler")};
    for (int i = 2; i < argc; ++i) words << QString::fromLocal8Bit(argv[i]);
    failed += QTest::qExec(suite.get(), words);
  }
  return failed == 0 ? 0 : 1;
}
