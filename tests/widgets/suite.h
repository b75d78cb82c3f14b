// Each file of this folder is a suite: an object whose slots are its tests.
#pragma once

#include <QObject>
#include <memory>

namespace fyd::tests {

std::unique_ptr<QObject> makeCurveLineTest();
std::unique_ptr<QObject> makeCurveTest();
std::unique_ptr<QObject> makeCurveToolsTest();
std::unique_ptr<QObject> makeControlTest();
std::unique_ptr<QObject> makeTuningTest();
std::unique_ptr<QObject> makeTuneTest();
std::unique_ptr<QObject> makeLinkTest();
std::unique_ptr<QObject> makeConnectionTest();
std::unique_ptr<QObject> makeConsoleTest();
std::unique_ptr<QObject> makeFrameTest();
std::unique_ptr<QObject> makeRecordingTest();
std::unique_ptr<QObject> makeCalibrateTest();
std::unique_ptr<QObject> makeCalibrateFieldsTest();
std::unique_ptr<QObject> makeCalibrateMotionTest();
std::unique_ptr<QObject> makeReviewTest();
std::unique_ptr<QObject> makeReviewWorkTest();
std::unique_ptr<QObject> makeMannersTest();
std::unique_ptr<QObject> makeJourneyTest();
std::unique_ptr<QObject> makeSceneDockTest();
std::unique_ptr<QObject> makeSceneViewTest();

}  // namespace fyd::tests
