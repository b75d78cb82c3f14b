#include "tests/widgets/suite.h"
#include "widgets/theme.h"

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QLocale::setDefault(QLocale(QStringLiteral("en")));  // whatever the machine speaks
  fyd::widgets::Look::instance().apply(application, fyd::widgets::ThemeChoice::dark);
  int failed = 0;
  for (auto make : {fyd::tests::makeCurveTest, fyd::tests::makeControlTest, fyd::tests::makeTuningTest,
                    fyd::tests::makeLinkTest, fyd::tests::makeConsoleTest, fyd::tests::makeFrameTest,
                    fyd::tests::makeRecordingTest, fyd::tests::makeCalibrateTest, fyd::tests::makeReviewTest}) {
    failed += QTest::qExec(make().get(), 1, argv);
  }
  return failed == 0 ? 0 : 1;
}
