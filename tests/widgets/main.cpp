#include "tests/widgets/suite.h"
#include "widgets/theme.h"

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QLocale::setDefault(QLocale(QStringLiteral("en")));  // whatever the machine speaks
  fyd::widgets::Look::instance().apply(application, fyd::widgets::ThemeChoice::dark);
  int failed = 0;
  for (auto make : {fyd::tests::makeCurveTest, fyd::tests::makeCurveToolsTest, fyd::tests::makeControlTest,
                    fyd::tests::makeTuningTest, fyd::tests::makeTuneTest, fyd::tests::makeLinkTest,
                    fyd::tests::makeConsoleTest, fyd::tests::makeFrameTest, fyd::tests::makeRecordingTest,
                    fyd::tests::makeCalibrateTest, fyd::tests::makeCalibrateMotionTest, fyd::tests::makeReviewTest,
                    fyd::tests::makeReviewWorkTest, fyd::tests::makeMannersTest}) {
    const auto suite = make();
    // While working on one: its name, or a part of it.
    if (argc > 1 && !QByteArray(suite->metaObject()->className()).contains(argv[1])) continue;
    failed += QTest::qExec(suite.get(), 1, argv);
  }
  return failed == 0 ? 0 : 1;
}
