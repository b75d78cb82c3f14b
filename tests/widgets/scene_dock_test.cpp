// The scene's panel of the Operate place: what stands where the robot stands, when it opens, and how a scene is chosen.
#include "core/scene/scene_stage.h"
#include "core/sim/scene_file.h"
#include "tests/widgets/scripted_session.h"
#include "tests/widgets/suite.h"

namespace fyd::tests {
namespace {

/// A scene file with a square of 20 mm beside it, which looks up.
class SceneFolder {
 public:
  [[nodiscard]] QString write(const QByteArray& scene) const {
    (void)put(QStringLiteral("square.obj"), "v -10 -10 0\nv 10 -10 0\nv 10 10 0\nv -10 10 0\nf 1 2 3\nf 1 3 4\n");
    return put(QStringLiteral("scene.toml"), scene);
  }
  [[nodiscard]] std::shared_ptr<scene::SceneStage> stage(const QByteArray& scene) const {
    return std::make_shared<scene::SceneStage>(
        std::make_shared<const scene::LoadedScene>(sim::openScene(write(scene).toStdString()).value()));
  }

 private:
  [[nodiscard]] QString put(const QString& name, const QByteArray& content) const {
    QFile file(folder_.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) qFatal("no scene");
    return file.fileName();
  }
  QTemporaryDir folder_;
};

const QByteArray kFlying =
    "[[body]]\nmesh = \"square.obj\"\nunit = \"mm\"\nposition_mm = [0, 0, 5]\n"
    "velocity_mm_per_s = [10, 0, 0]\n";

}  // namespace

class SceneDockTest : public QObject {
  Q_OBJECT
 private slots:
  void aSessionsSceneIsShownAndWhatTheFingerTouchesOfIt() {
    const SceneFolder folder;
    // A wide plate 4 mm above where the haptic point begins: it is in it wherever the demonstration leads.
    const QString file = folder.write(
        "[[body]]\nname = \"plate\"\nmesh = \"square.obj\"\nunit = \"m\"\n"
        "position_mm = [0, 0, 4]\nstiffness_N_per_mm = 0.25\ncontact = \"facet\"\n");
    station::StationOptions options;
    options.touchpad = "simulated";
    options.robot = "scene:" + file.toStdString();
    auto session = console::openSession(options);
    QVERIFY2(session.has_value(), session ? "" : session.error().message.text().c_str());
    const QTemporaryDir home;
    console::MainWindow window(std::move(*session), home.filePath(QStringLiteral("profile.toml")));
    window.show();
    window.start();
    const console::SceneDock* dock = window.operate()->scene();
    const widgets::SceneView* view = dock->view();
    WAIT_FOR(dock->isVisible());
    WAIT_FOR(view->state().force_N.finite());
    WAIT_FOR(view->picture() != nullptr);
    const widgets::SceneState state = view->state();
    QCOMPARE(state.parts.placements.size(), std::size_t{1});
    QCOMPARE(state.parts.placements[0].origin_mm.z, 4.0);
    QVERIFY(std::abs(state.proxy_mm.z - 4.0) < 1e-9);  // on the plate
    QVERIFY(state.force_N.z > 0.0);
    QVERIFY(std::abs(state.force_N.z - 0.25 * (4.0 - state.point_mm.z)) < 1e-9);
    QVERIFY2(view->words().contains(QStringLiteral(" N")), qPrintable(view->words()));
    WAIT_FOR(view->footText().startsWith(QStringLiteral("2 triangles")));
    window.close();
  }

  void opensWithASceneClosesWithoutAndSaysHowToGetOne() {
    Fixture f;
    const console::SceneDock* dock = f.window->operate()->scene();
    f.window->feed().pump();
    QVERIFY(!dock->isVisible());
    QTest::keyClick(f.window.get(), Qt::Key_E, Qt::ControlModifier);
    QVERIFY(dock->isVisible());
    QVERIFY(dock->view()->words().contains(QStringLiteral("--robot scene:FILE")));
    QTest::keyClick(f.window.get(), Qt::Key_E, Qt::ControlModifier);
    QVERIFY(!dock->isVisible());
    const SceneFolder folder;
    f.session->stage = folder.stage(kFlying);
    f.window->feed().pump();
    QVERIFY(dock->isVisible());
    QVERIFY(f.window->commands().action(QStringLiteral("view.panel_scene"))->isChecked());
    QVERIFY(!dock->view()->words().contains(QStringLiteral("--robot scene:FILE")));
    // Closed by its cross it stays closed while the session lasts.
    QTest::mouseClick(dock->findChild<QToolButton*>(QStringLiteral("scene_close")), Qt::LeftButton);
    f.window->feed().pump();
    QVERIFY(!dock->isVisible());
    f.session->stage = folder.stage(kFlying);  // another
    f.window->feed().pump();
    QVERIFY(dock->isVisible());
    f.session->stage.reset();
    f.window->feed().pump();
    QVERIFY(!dock->isVisible());
  }

  void bodiesFlyAndNothingIsTouchedBeforeItIs() {
    Fixture f;
    const SceneFolder folder;
    f.session->stage = folder.stage(kFlying);
    f.window->feed().pump();
    const widgets::SceneView* view = f.window->operate()->scene()->view();
    QCOMPARE(view->state().parts.placements.at(0).origin_mm, (Vec3{0.0, 0.0, 5.0}));
    QVERIFY(!view->state().point_mm.finite());
    f.session->stage->show(scene::SceneMoment{.stepped = true, .time_s = 3.0, .point_mm = {1.0, 2.0, 3.0}});
    f.window->feed().pump();
    QCOMPARE(view->state().parts.placements.at(0).origin_mm, (Vec3{30.0, 0.0, 5.0}));
    QCOMPARE(view->state().point_mm, (Vec3{1.0, 2.0, 3.0}));
    QVERIFY(!view->state().force_N.finite());
    QVERIFY(!view->state().proxy_mm.finite());
  }

  void swordsBallAndRacketAreShown() {
    Fixture f;
    const SceneFolder folder;
    f.session->stage = folder.stage("[swords]\nradius_mm = 7\n[ball]\nradius_mm = 30\nracket_width_mm = 200\n");
    scene::SwordState swords;
    swords.known = true;
    swords.local = {.grip_mm = {1.0, 0.0, 0.0}, .tip_mm = {901.0, 0.0, 0.0}};
    swords.distant = {.grip_mm = {1300.0, 0.0, 0.0}, .tip_mm = {400.0, 0.0, 0.0}};
    scene::BallGameState ball;
    ball.ball.position_mm = {0.0, 0.0, 250.0};
    ball.racket_known = true;
    ball.racket.centre_mm = {5.0, 6.0, 7.0};
    f.session->stage->show(scene::SceneMoment{.stepped = true});  // the first step knows no swords yet
    f.window->feed().pump();
    const widgets::SceneView* view = f.window->operate()->scene()->view();
    QVERIFY(view->state().parts.balls.empty());
    f.session->stage->show(scene::SceneMoment{.stepped = true, .time_s = 0.001, .swords = swords, .ball = ball});
    f.window->feed().pump();
    // All of 1300 mm is in the picture.
    QVERIFY(view->camera().mmPerPixel() * view->width() > 1300.0);
    const widgets::SceneParts& parts = view->state().parts;
    QCOMPARE(parts.sticks.size(), std::size_t{2});
    QCOMPARE(parts.sticks[0].to_mm.x, 901.0);
    QCOMPARE(parts.sticks[0].radius_mm, 7.0);
    QVERIFY(parts.sticks[1].role == widgets::SceneRole::other);
    QCOMPARE(parts.balls.at(0).centre_mm.z, 250.0);
    QCOMPARE(parts.balls.at(0).radius_mm, 30.0);
    QCOMPARE(parts.discs.at(0).centre_mm, (Vec3{5.0, 6.0, 7.0}));
    QCOMPARE(parts.discs.at(0).radius_mm, 100.0);
  }

  void aRectangularRacketIsShownAsOne() {
    Fixture f;
    const SceneFolder folder;
    f.session->stage =
        folder.stage("[ball]\nracket_shape = \"rectangle\"\nracket_width_mm = 200\nracket_height_mm = 100\n");
    scene::BallGameState ball;
    ball.racket_known = true;
    ball.racket.centre_mm = {5.0, 6.0, 7.0};
    ball.racket.normal = {1.0, 0.0, 0.0};
    ball.racket.along = {0.0, 0.0, 1.0};
    f.session->stage->show({.stepped = true, .time_s = 0.001, .ball = ball});
    f.window->feed().pump();
    const widgets::SceneParts& parts = f.window->operate()->scene()->view()->state().parts;
    QCOMPARE(parts.discs.size(), std::size_t{1});  // the court
    QCOMPARE(parts.sheets.size(), std::size_t{1});
    QCOMPARE(parts.sheets[0].centre_mm, (Vec3{5.0, 6.0, 7.0}));
    QCOMPARE(parts.sheets[0].half_width_mm, (Vec3{0.0, 0.0, 100.0}));
    QCOMPARE(std::abs(parts.sheets[0].half_height_mm.y), 50.0);
    QCOMPARE(parts.sheets[0].half_height_mm.x, 0.0);
    QCOMPARE(parts.sheets[0].half_height_mm.z, 0.0);
  }

  void theMouseInThePictureLeadsTheSimulatedFinger() {
    Fixture f;
    const SceneFolder folder;
    f.session->stage = folder.stage(kFlying);
    f.session->stage->show({.stepped = true, .point_mm = {6.0, -5.0, -3.0}});
    f.window->feed().pump();
    widgets::SceneView* view = f.window->operate()->scene()->view();
    QVERIFY(view->drivable());
    // The touch leads the arm to (x, y, −3 · depth): the thesis' scales.
    QTest::keyPress(view, Qt::Key_Right, {Qt::ControlModifier | Qt::ShiftModifier});
    QCOMPARE(f.session->finger.size(), std::size_t{3});
    const double by_mm = view->camera().mmPerPixel();
    const Vec3 right = view->camera().right();
    QVERIFY(std::abs(f.session->finger[0] - (6.0 + by_mm * right.x)) < 1e-9);
    QVERIFY(std::abs(f.session->finger[1] - (-5.0 + by_mm * right.y)) < 1e-9);
    QVERIFY(std::abs(f.session->finger[2] - 1.0) < 1e-9);
    QTest::keyRelease(view, Qt::Key_Control);
    QVERIFY(f.session->finger.empty());
    // No scene, nothing to lead; what the hand held is let go.
    QTest::keyPress(view, Qt::Key_Right, Qt::ControlModifier);
    QVERIFY(!f.session->finger.empty());
    f.session->stage.reset();
    f.window->feed().pump();
    QVERIFY(!view->drivable());
    QVERIFY(f.session->finger.empty());
  }

  void aSceneIsReadBesideTheSessionAndWhatIsWrongCostsNothing() {
    Fixture f;
    f.window->commands().action(QStringLiteral("view.link"))->trigger();
    widgets::RobotForm* form = f.window->link()->form();
    f.session->say(pipeline::SafetyState::ready);
    f.window->feed().pump();
    form->setRobot(QStringLiteral("scene:bad.toml"), {});
    QTest::mouseClick(form->reconnectButton(), Qt::LeftButton);
    WAIT_FOR(form->reconnectButton()->text() == QStringLiteral("Reconnect"));
    QVERIFY(f.session->asked.empty() && f.session->open);
    QVERIFY2(f.window->notices()->text(0).contains(QStringLiteral("bad by the script")), "the notice");
    // Cancelled while it is read.
    f.session->reads_long = true;
    form->setRobot(QStringLiteral("scene:good.toml"), {});
    QTest::mouseClick(form->reconnectButton(), Qt::LeftButton);
    QCOMPARE(form->reconnectButton()->text(), QStringLiteral("Cancel"));
    QVERIFY(form->hint().startsWith(QStringLiteral("Reading the scene")));
    QVERIFY(!form->sceneFile()->isEnabled());
    QTest::mouseClick(form->reconnectButton(), Qt::LeftButton);
    QCOMPARE(form->reconnectButton()->text(), QStringLiteral("Reconnect"));
    f.session->reads_long = false;
    passTimers(50);
    QVERIFY(f.session->asked.empty() && f.session->open);
    // Armed while it is read: the session that moves is not ended.
    f.session->reads_long = true;
    QTest::mouseClick(form->reconnectButton(), Qt::LeftButton);
    f.session->say(pipeline::SafetyState::active);
    f.window->feed().pump();
    f.session->reads_long = false;
    WAIT_FOR(form->reconnectButton()->text() == QStringLiteral("Reconnect"));
    QVERIFY(f.session->asked.empty() && f.session->open);
    f.session->say(pipeline::SafetyState::ready);
    f.window->feed().pump();
    QTest::mouseClick(form->reconnectButton(), Qt::LeftButton);
    WAIT_FOR(!f.session->asked.empty());
    QCOMPARE(f.session->asked.back().robot, std::string("scene:good.toml"));
    QVERIFY(f.session->open);
  }

  void aSceneIsChosenAsTheRobot() {
    Fixture f;
    f.window->commands().action(QStringLiteral("view.link"))->trigger();
    widgets::RobotForm* form = f.window->link()->form();
    f.session->say(pipeline::SafetyState::ready);
    f.window->feed().pump();
    form->kind()->setCurrentIndex(form->kind()->count() - 1);
    QVERIFY(form->sceneFile()->isVisible() && !form->address()->isVisible());
    QVERIFY(!form->reconnectButton()->isEnabled());  // no file yet
    form->sceneFile()->setFocus();
    QTest::keyClicks(form->sceneFile(), QStringLiteral("/scenes/bumpy plane.toml"));
    QTest::mouseClick(form->reconnectButton(), Qt::LeftButton);
    WAIT_FOR(!f.session->asked.empty());
    QCOMPARE(f.session->asked.back().robot, std::string("scene:/scenes/bumpy plane.toml"));
    QVERIFY(f.session->asked.back().key_file.empty());
    form->setRobot(QStringLiteral("simulated"), {});
    QVERIFY(!form->sceneFile()->isVisible());
    form->setRobot(QStringLiteral("scene:other.toml"), {});
    QCOMPARE(form->robot(), QStringLiteral("scene:other.toml"));
  }
};

std::unique_ptr<QObject> makeSceneDockTest() { return std::make_unique<SceneDockTest>(); }

}  // namespace fyd::tests

#include "scene_dock_test.moc"
