// The view of a scene, offscreen: a picture is judged by the colours at places that were worked out by hand.
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>
#include <deque>
#include <set>

#include "tests/widgets/suite.h"
#include "tests/widgets/wait.h"
#include "widgets/basics/theme.h"
#include "widgets/scene/scene_marks.h"
#include "widgets/scene/scene_view.h"

namespace fyd::tests {
namespace {

using widgets::SceneRole;
using widgets::SceneSide;
using widgets::SceneView;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A square of `n` × `n` cells in the plane z = `z_mm`, its outside above.
scene::TriangleSoup plane(double half_mm, double z_mm, std::uint32_t n = 1) {
  scene::TriangleSoup out;
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) {
      out.vertices.push_back({half_mm * (2.0 * i / n - 1.0), half_mm * (2.0 * j / n - 1.0), z_mm});
    }
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i;
      out.triangles.push_back({a, a + 1, a + n + 2});
      out.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  }
  return out;
}

/// A closed box around `middle`.
scene::TriangleSoup cube(Vec3 middle, double half_mm) {
  scene::TriangleSoup out;
  for (unsigned i = 0; i < 8; ++i) {
    const auto side = [&](unsigned bit) { return (i & bit) != 0 ? half_mm : -half_mm; };
    out.vertices.push_back(middle + Vec3{side(1), side(2), side(4)});
  }
  out.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return out;
}

widgets::SceneBody body(const scene::TriangleSoup& soup, SceneRole role = SceneRole::rigid) {
  return {.name = QStringLiteral("body"), .vertices_mm = soup.vertices, .triangles = soup.triangles, .role = role};
}

struct Shown {
  Shown() {
    view.resize(400, 400);
    view.show();
  }
  void bodies(const std::vector<widgets::SceneBody>& all) { view.setBodies(all); }
  QImage grab() {
    [this] { WAIT_FOR(view.settled()); }();
    return view.grab().toImage();
  }
  SceneView view;
};

QColor ground() { return widgets::theme().panel; }
bool isGround(const QImage& image, int x, int y) { return image.pixelColor(x, y) == ground(); }

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }
bool nearby(Vec3 a, Vec3 b, double tolerance) {
  return near(a.x, b.x, tolerance) && near(a.y, b.y, tolerance) && near(a.z, b.z, tolerance);
}

void move(SceneView& view, QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held,
          Qt::KeyboardModifiers with = Qt::NoModifier) {
  QMouseEvent event(type, at, view.mapToGlobal(at), button, held, with);
  QApplication::sendEvent(&view, &event);
}

void drag(SceneView& view, QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton,
          Qt::KeyboardModifiers with = Qt::NoModifier) {
  move(view, QEvent::MouseButtonPress, from, button, button, with);
  move(view, QEvent::MouseMove, to, Qt::NoButton, button, with);
  move(view, QEvent::MouseButtonRelease, to, button, Qt::NoButton, with);
}

void wheel(SceneView& view, QPointF at, int notches) {
  QWheelEvent event(at, view.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(&view, &event);
}

}  // namespace

class SceneViewTest : public QObject {
  Q_OBJECT
 private slots:
  void init() { widgets::Look::instance().apply(*qApp, widgets::ThemeChoice::dark); }

  void aPlaneSeenFromAboveFillsFourFifths() {
    Shown s;
    const scene::TriangleSoup square = plane(50, 0);
    s.bodies({body(square)});
    s.view.look(SceneSide::top);
    const QImage image = s.grab();
    // 100 mm on 320 of 400 px: from 40 to 360, and 0.3125 mm a pixel.
    QVERIFY(near(s.view.camera().mmPerPixel(), 0.3125, 1e-9));
    for (const int at : {43, 200, 357}) QVERIFY2(!isGround(image, at, 300), qPrintable(QString::number(at)));
    for (const int at : {36, 364}) QVERIFY2(isGround(image, at, 300), qPrintable(QString::number(at)));
    for (const int at : {43, 357}) QVERIFY2(!isGround(image, 150, at), qPrintable(QString::number(at)));
    for (const int at : {36, 364}) QVERIFY2(isGround(image, 150, at), qPrintable(QString::number(at)));
  }

  void theSidesShowWhatIsThere() {
    // A large cube in the middle, small ones out along x, y and z: where each is drawn, by hand.
    const scene::TriangleSoup middle = cube({}, 10), x = cube({60, 0, 0}, 6), y = cube({0, 60, 0}, 6),
                              z = cube({0, 0, 60}, 6);
    Shown s;
    s.bodies({body(middle), body(x), body(y), body(z)});
    const auto at = [&](const QImage& image, double right_mm, double up_mm) {
      // The box reaches from −10 to 66 along each axis, so its middle is at 28.
      const double px = 1.0 / s.view.camera().mmPerPixel();
      return !isGround(image, qRound(200 + px * (right_mm - 28)), qRound(200 - px * (up_mm - 28)));
    };
    s.view.look(SceneSide::front);
    QImage image = s.grab();
    QVERIFY(at(image, 60, 0) && at(image, 0, 60) && at(image, 0, 0) && !at(image, 60, 60));
    QVERIFY(near(s.view.camera().azimuth_deg(), 0, 0) && near(s.view.camera().elevation_deg(), 0, 0));
    QVERIFY(near(s.view.camera().depth_mm({0, 1, 0}) - s.view.camera().depth_mm({}), 1, 1e-12));  // +y is away
    s.view.look(SceneSide::top);
    image = s.grab();
    QVERIFY(at(image, 60, 0) && at(image, 0, 60) && !at(image, 60, 60));
    QVERIFY(near(s.view.camera().depth_mm({0, 0, 1}) - s.view.camera().depth_mm({}), -1, 1e-12));  // +z is near
    s.view.look(SceneSide::right);
    image = s.grab();
    QVERIFY(at(image, 60, 0) && at(image, 0, 60) && !at(image, 60, 60));
    QVERIFY(near(s.view.camera().depth_mm({1, 0, 0}) - s.view.camera().depth_mm({}), -1, 1e-12));  // +x is near
  }

  void whatIsNearerHides() {
    const scene::TriangleSoup low = plane(50, 0), high = plane(20, 10);
    Shown s;
    s.bodies({body(low, SceneRole::soft), body(high, SceneRole::own)});
    s.view.look(SceneSide::top);
    QImage image = s.grab();
    // Both lie flat under one light, so the shades have the ratio of the colours.
    const auto like = [&](int x, SceneRole role) {
      const QColor is = image.pixelColor(x, 200), of = widgets::sceneColours().outside[static_cast<std::size_t>(role)];
      const double share = is.redF() / of.redF();
      return near(is.greenF(), share * of.greenF(), 0.02) && near(is.blueF(), share * of.blueF(), 0.02) && share > 0.5;
    };
    QVERIFY(like(230, SceneRole::own));
    QVERIFY(like(330, SceneRole::soft));
    QVERIFY(!like(330, SceneRole::own));
    // From below the large one hides the small, and shows its inside: another colour, hatched.
    for (int i = 0; i < 60; ++i) QTest::keyClick(&s.view, Qt::Key_Down);
    QVERIFY(near(s.view.camera().elevation_deg(), -90, 0));
    image = s.grab();
    std::set<QRgb> shades;
    for (int x = 210; x < 250; ++x) shades.insert(image.pixel(x, 230));
    QVERIFY(shades.size() > 1);
    QVERIFY(!like(230, SceneRole::own) && !isGround(image, 230, 200));
  }

  void theForceIsAGreenSegmentWithItsValue() {
    const scene::TriangleSoup square = plane(50, 0);
    Shown s;
    s.bodies({body(square)});
    widgets::SceneState state{.point_mm = {0, 0, -5}, .proxy_mm = {0, 0, 0}, .force_N = {3, 0, 4}};
    s.view.setState(state);
    s.view.look(SceneSide::top);
    QImage image = s.grab();
    // 3 N of it lie across the picture, 24 px for each; 5 N in all.
    QCOMPARE(image.pixelColor(200 + 50, 200), widgets::theme().live);
    QCOMPARE(image.pixelColor(200 + 70, 200), widgets::theme().live);
    QVERIFY(image.pixelColor(200 + 74, 200) != widgets::theme().live);
    QVERIFY2(s.view.words().contains(QStringLiteral("force 5.00 N")), qPrintable(s.view.words()));
    QVERIFY(s.view.words().contains(QStringLiteral("Haptic point 0.0, 0.0, −5.0 mm")));
    WAIT_EQUAL(s.view.accessibleDescription(), s.view.words());
    // Without a contact there is no segment and no value.
    state.force_N = widgets::kNowhere;
    s.view.setState(state);
    image = s.grab();
    QVERIFY(image.pixelColor(250, 200) != widgets::theme().live);
    QVERIFY(s.view.words().contains(QStringLiteral("force —")));
  }

  void aPointInsideABodyIsFainterThanOneInFront() {
    const scene::TriangleSoup square = plane(50, 0);
    Shown s;
    s.bodies({body(square)});
    s.view.look(SceneSide::top);
    s.view.setState({.point_mm = {10, 10, 5}});
    const QPoint at(232, 168);
    const QColor before = s.grab().pixelColor(at);
    QCOMPARE(before, widgets::theme().text);
    s.view.setState({.point_mm = {10, 10, -5}});
    const QColor behind = s.grab().pixelColor(at);
    QVERIFY(behind != before);
    QVERIFY(!(behind == ground()));
  }

  void turnedMovedAndZoomedByTheHand() {
    Shown s;
    const scene::TriangleSoup box = cube({}, 50);
    s.bodies({body(box)});
    s.view.look(SceneSide::front);
    const QImage before = s.grab();
    drag(s.view, {200, 300}, {100, 350});
    QVERIFY(near(s.view.camera().azimuth_deg(), 40, 1e-9));
    QVERIFY(near(s.view.camera().elevation_deg(), 20, 1e-9));
    QVERIFY(s.grab() != before);
    drag(s.view, {0, 0}, {0, 5000});
    QCOMPARE(s.view.camera().elevation_deg(), 90.0);
    // Moved: what lay under the hand stays under it.
    const Vec3 corner{50, 50, 50};
    for (const auto& [button, with] : {std::pair{Qt::MiddleButton, Qt::NoModifier},
                                       {Qt::RightButton, Qt::NoModifier},
                                       {Qt::LeftButton, Qt::ShiftModifier}}) {
      const QPointF was = s.view.camera().project(corner, s.view.size());
      drag(s.view, {200, 200}, {230, 190}, button, with);
      const QPointF now = s.view.camera().project(corner, s.view.size());
      QVERIFY(near(now.x() - was.x(), 30, 1e-9) && near(now.y() - was.y(), -10, 1e-9));
    }
    // Zoomed: so does what lies under the wheel.
    const QPointF under = s.view.camera().project(corner, s.view.size());
    wheel(s.view, under, 3);
    const QPointF still = s.view.camera().project(corner, s.view.size());
    QVERIFY(near(still.x(), under.x(), 1e-6) && near(still.y(), under.y(), 1e-6));
    QVERIFY(near(s.view.camera().mmPerPixel() * std::pow(1.15, 3), 100.0 / 320.0, 1e-9));
    wheel(s.view, {5, 5}, 5000);
    wheel(s.view, {5, 5}, -9000);
    QVERIFY(s.view.camera().mmPerPixel() > 0 && std::isfinite(s.view.camera().mmPerPixel()));
    QTest::keyClick(&s.view, Qt::Key_Home);
    QVERIFY(near(s.view.camera().azimuth_deg(), -30, 1e-9) && near(s.view.camera().elevation_deg(), 30, 1e-9));
    QVERIFY(nearby(s.view.camera().target_mm(), {}, 1e-9));
  }

  void theHandDrivesThePointInThePlaneOfThePicture() {
    Shown s;
    const scene::TriangleSoup square = plane(50, 0);
    s.bodies({body(square)});
    s.view.setState({.point_mm = {10, 10, 5}});
    s.view.look(SceneSide::top);
    std::vector<Vec3> to;
    int released = 0;
    connect(&s.view, &SceneView::pointDriven, &s.view, [&](Vec3 at) { to.push_back(at); });
    connect(&s.view, &SceneView::pointReleased, &s.view, [&] { ++released; });
    drag(s.view, {232, 168}, {264, 168});  // not drivable: the scene turns
    QVERIFY(to.empty() && released == 0);
    s.view.look(SceneSide::top);
    s.view.setDrivable(true);
    move(s.view, QEvent::MouseButtonPress, {232, 168}, Qt::LeftButton, Qt::LeftButton);
    QVERIFY(nearby(to.back(), {10, 10, 5}, 1e-9));
    move(s.view, QEvent::MouseMove, {264, 200}, Qt::NoButton, Qt::LeftButton);
    QVERIFY(nearby(to.back(), {20, 0, 5}, 1e-9));  // 32 px of 0.3125 mm
    wheel(s.view, {264, 200}, 1);                  // away from the eye: down
    QVERIFY(nearby(to.back(), {20, 0, 5 - 1.25}, 1e-9));
    move(s.view, QEvent::MouseMove, {264, 184}, Qt::NoButton, Qt::LeftButton, Qt::ShiftModifier);
    QVERIFY(nearby(to.back(), {20, 0, 5 - 1.25 - 5}, 1e-9));
    QCOMPARE(released, 0);
    move(s.view, QEvent::MouseButtonRelease, {264, 184}, Qt::LeftButton, Qt::NoButton);
    QCOMPARE(released, 1);
    QVERIFY(nearby(s.view.camera().target_mm(), {}, 1e-9));  // the scene did not move

    // The same without a mouse.
    to.clear();
    QTest::keyPress(&s.view, Qt::Key_Right, Qt::ControlModifier);
    QVERIFY(nearby(to.back(), {11.25, 10, 5}, 1e-9));
    QTest::keyPress(&s.view, Qt::Key_PageUp, Qt::ControlModifier);
    QVERIFY(nearby(to.back(), {11.25, 10, 3.75}, 1e-9));
    QTest::keyRelease(&s.view, Qt::Key_Control);
    QCOMPARE(released, 2);

    // Not beyond reason, and let go when it is hidden or taken away.
    move(s.view, QEvent::MouseButtonPress, {232, 168}, Qt::LeftButton, Qt::LeftButton);
    move(s.view, QEvent::MouseMove, {1e9, 0}, Qt::NoButton, Qt::LeftButton);
    QVERIFY(nearby(to.back(), {10, 10, 5}, 1e-9));
    s.view.hide();
    QCOMPARE(released, 3);
    s.view.show();
    move(s.view, QEvent::MouseButtonPress, {232, 168}, Qt::LeftButton, Qt::LeftButton);
    s.view.setDrivable(false);
    QCOMPARE(released, 4);
  }

  void withTheTouchButtonADragAnywhereDrivesThePointWithinItsReach() {
    Shown s;
    const scene::TriangleSoup square = plane(50, 0);
    s.bodies({body(square)});
    s.view.setState({.point_mm = {10, 10, 0}});
    s.view.look(SceneSide::top);
    std::vector<Vec3> to;
    connect(&s.view, &SceneView::pointDriven, &s.view, [&](Vec3 at) { to.push_back(at); });
    QVERIFY(!s.view.touchButton()->isVisible());
    widgets::SceneBox reach;
    reach.add(Vec3{-45, -30, -24});
    reach.add(Vec3{45, 30, 0});
    s.view.setDrivable(true, reach);
    drag(s.view, {100, 300}, {110, 300});
    QVERIFY(to.empty());  // the scene turned
    s.view.look(SceneSide::top);
    QTest::mouseClick(s.view.touchButton(), Qt::LeftButton);
    const QImage before = s.grab();
    move(s.view, QEvent::MouseButtonPress, {100, 300}, Qt::LeftButton, Qt::LeftButton);
    move(s.view, QEvent::MouseMove, {132, 300}, Qt::NoButton, Qt::LeftButton);
    QVERIFY(nearby(to.back(), {20, 10, 0}, 1e-9));
    // The hand is shown: a cross of the accent's colour at 20, 10, which is 64 px right and 32 px above the middle.
    const QImage led = s.grab();
    QCOMPARE(led.pixelColor(264, 168 + 7), widgets::theme().accent);
    QVERIFY(before.pixelColor(264, 168 + 7) != widgets::theme().accent);
    move(s.view, QEvent::MouseMove, {390, 20}, Qt::NoButton, Qt::LeftButton);
    QVERIFY(nearby(to.back(), {45, 30, 0}, 1e-9));
    wheel(s.view, {390, 20}, 100);
    QVERIFY(nearby(to.back(), {45, 30, -24}, 1e-9));
    move(s.view, QEvent::MouseButtonRelease, {390, 20}, Qt::LeftButton, Qt::NoButton);
    QVERIFY(s.grab().pixelColor(264, 168 + 7) != widgets::theme().accent);
    s.view.setDrivable(false);
    QVERIFY(!s.view.touchButton()->isVisible() && !s.view.touchButton()->isChecked());
  }

  void aRacketWithCornersIsDrawnWithThem() {
    Shown s;
    widgets::SceneState state;
    state.parts.sheets = {{.centre_mm = {0, 0, 0}, .half_width_mm = {40, 0, 0}, .half_height_mm = {0, 20, 0}}};
    s.view.setState(state);
    s.view.look(SceneSide::top);
    const QImage image = s.grab();
    const double px = 1.0 / s.view.camera().mmPerPixel();
    const auto drawn = [&](double x_mm, double y_mm) {
      return !isGround(image, qRound(200 + px * x_mm), qRound(200 - px * y_mm));
    };
    for (const double x : {-39.0, 39.0}) {
      for (const double y : {-19.0, 19.0}) QVERIFY(drawn(x, y));
    }
    QVERIFY(!drawn(42, 0) && !drawn(0, 22) && !drawn(-42, 19) && !drawn(39, -22));
    // Turned away it is a line; none at all without a height, or with a side that is no number.
    for (const Vec3 bad : {Vec3{}, Vec3{80, 0, 0}, Vec3{kNaN, 1, 0}, Vec3{1e300, 1, 0}}) {
      state.parts.sheets[0].half_height_mm = bad;
      s.view.setState(state);
      QVERIFY(isGround(s.grab(), 230, 230));
    }
  }

  void theRateIsMeasuredAndShown() {
    Shown s;
    const scene::TriangleSoup square = plane(50, 0, 224);  // 100 352 triangles
    s.bodies({body(square)});
    (void)s.grab();
    WAIT_EQUAL(s.view.footText(), QStringLiteral("100,352 triangles · nothing moves"));
    QCOMPARE(s.view.picturesPerSecond(), 0.0);
    struct Paints : QObject {
      QElapsedTimer clock;
      std::deque<qint64> at_ms;  // of the last second
      bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint) at_ms.push_back(clock.elapsed());
        return false;
      }
      /// Nothing was longer without a picture than this, in the last second.
      bool steady(qint64 longest_ms) {
        const qint64 now_ms = clock.elapsed();
        while (!at_ms.empty() && at_ms.front() < now_ms - 1000) at_ms.pop_front();
        qint64 before_ms = now_ms - 1000;
        for (const qint64 each : at_ms) {
          if (each - before_ms > longest_ms) return false;
          before_ms = each;
        }
        return now_ms - before_ms <= longest_ms;
      }
    } paints;
    paints.clock.start();
    s.view.installEventFilter(&paints);
    double phase = 0.0;
    QTimer hand;
    connect(&hand, &QTimer::timeout, &s.view, [&] { s.view.setState({.point_mm = {phase += 0.01, 0, 1}}); });
    hand.start(10);
    // A standstill of the machine makes the rate of a second a matter of words: one without is waited for.
    double counted = 0.0, said = 0.0;
    const auto foot = [&] { return s.view.footText().contains(QStringLiteral("pictures/s")); };
    QVERIFY(QTest::qWaitFor(
        [&] {
          if (paints.clock.elapsed() < 1500 || !foot() || !paints.steady(300)) return false;
          counted = static_cast<double>(paints.at_ms.size());
          said = s.view.picturesPerSecond();
          return true;
        },
        kPatience_ms));
    QVERIFY2(said > 0.6 * counted && said < 1.5 * counted, qPrintable(QStringLiteral("%1 %2").arg(said).arg(counted)));
    QVERIFY(said <= 1000.0 / SceneView::kTick_ms * 1.1);  // no more than its own timer's
    QVERIFY2(s.view.footText().startsWith(QStringLiteral("100,352 triangles · ")), qPrintable(s.view.footText()));
    hand.stop();
    WAIT_EQUAL(s.view.footText(), QStringLiteral("100,352 triangles · nothing moves"));
  }

  void onlyWhatMovedIsCastAgainAndTheSamePictureComesOut() {
    const scene::TriangleSoup square = plane(50, 0, 20);
    const widgets::SceneBody one[] = {body(square)};
    const auto meshes = widgets::SceneMeshes::of(one);
    widgets::SceneCaster moved, fresh;
    QVERIFY(moved.build(meshes, [] { return true; }));
    QVERIFY(fresh.build(meshes, [] { return true; }));
    widgets::SceneShot shot{.size_px = {400, 300}, .colours = widgets::sceneColours()};
    shot.camera.look(SceneSide::home, meshes->bodies[0].box, {400, 300});
    widgets::SceneParts parts;
    parts.placements = {{}};
    parts.balls = {{.centre_mm = {0, 0, 5}, .radius_mm = 4}};
    parts.discs = {{.centre_mm = {20, 0, 8}, .normal = {0, 1, 2}, .radius_mm = 6}};
    parts.sticks = {{.from_mm = {-40, -40, 2}, .to_mm = {-30, 20, 30}, .radius_mm = 1}};
    parts.sheets = {{.centre_mm = {-20, -20, 8}, .half_width_mm = {5, 0, 1}, .half_height_mm = {0, 8, 0}}};
    const auto go_on = [] { return true; };
    moved.move(parts, {}, shot);
    QVERIFY(moved.cast(shot, {1, 1}, go_on));
    QVERIFY(moved.picture().rays >= std::size_t{400} * 300);
    for (int i = 0; i < 30; ++i) {
      parts.balls[0].centre_mm = parts.balls[0].centre_mm + Vec3{1, 0.5, 0.2};
      parts.discs[0].normal.x += 0.1;
      parts.sticks[0].to_mm.x += 2;
      parts.sheets[0].half_width_mm.z += 0.1;
      moved.move(parts, {}, shot);
      QVERIFY(moved.cast(shot, {1, 1}, go_on));
      QVERIFY2(moved.picture().rays < 400U * 300U / 2, qPrintable(QString::number(moved.picture().rays)));
    }
    parts.balls[0].centre_mm = {-30, 30, 5};  // at once
    parts.sticks.clear();
    moved.move(parts, {}, shot);
    QVERIFY(moved.cast(shot, {1, 1}, go_on));
    fresh.move(parts, {}, shot);
    QVERIFY(fresh.cast(shot, {1, 1}, go_on));
    QCOMPARE(moved.picture().image, fresh.picture().image);
    for (std::size_t i = 0; i < fresh.picture().depth_mm.size(); ++i) {
      const float a = moved.picture().depth_mm[i], b = fresh.picture().depth_mm[i];
      QVERIFY(a == b || std::abs(a - b) < 1e-3F);  // rays began at another place: floats round otherwise
    }
    parts.placements[0].origin_mm = {0, 0, -1};  // the whole body
    moved.move(parts, {}, shot);
    QVERIFY(moved.cast(shot, {1, 1}, go_on));
    fresh.move(parts, {}, shot);
    QVERIFY(fresh.cast(shot, {1, 1}, go_on));
    QCOMPARE(moved.picture().image, fresh.picture().image);
    QVERIFY(moved.picture().depth_mm == fresh.picture().depth_mm);
    moved.move(parts, {}, shot);
    QVERIFY(moved.cast(shot, {1, 1}, go_on));
    QCOMPARE(moved.picture().rays, std::size_t{0});
    QVERIFY(!moved.cast(shot, {1, 4}, [] { return false; }));  // given up, then done again
    QVERIFY(moved.cast(shot, {1, 1}, go_on));
    QCOMPARE(moved.picture().image, fresh.picture().image);
  }

  void depthIsThatOfTheBody() {
    const scene::TriangleSoup square = plane(50, 7);
    const widgets::SceneBody one[] = {body(square)};
    widgets::SceneCaster caster;
    QVERIFY(caster.build(widgets::SceneMeshes::of(one), [] { return true; }));
    widgets::SceneShot shot{.size_px = {200, 200}, .colours = widgets::sceneColours()};
    widgets::SceneBox box;
    box.add(Vec3{-50, -50, 0});
    box.add(Vec3{50, 50, 0});
    shot.camera.look(SceneSide::top, box, {200, 200});
    caster.move({}, {}, shot);
    QVERIFY(caster.cast(shot, {1, 1}, [] { return true; }));
    QVERIFY(near(caster.picture().depthAt({100, 100}), -7, 1e-4));  // 7 mm nearer than the middle of the box
    QVERIFY(std::isinf(caster.picture().depthAt({2, 2})));
    for (const QPointF odd : {QPointF(-1, 0), QPointF(200, 0), QPointF(kNaN, 0), QPointF(1e30, 1e30)}) {
      QVERIFY(std::isinf(caster.picture().depthAt(odd)));
    }
  }

  void aBodyGoesWhereItIsPlacedAndASoftOneHowItIsShaped() {
    const scene::TriangleSoup square = plane(50, 0);
    const scene::TriangleSoup part = plane(10, 1);
    Shown s;
    s.bodies({body(square), body(part, SceneRole::own)});
    widgets::SceneState state;
    state.parts.placements = {{}, {.origin_mm = {30, 0, 0}}};
    s.view.setState(state);
    s.view.look(SceneSide::top);
    QImage image = s.grab();
    const QRgb own = image.pixel(200 + 96, 200), rigid = image.pixel(200, 200);
    QVERIFY(own != rigid);
    // A quarter turn about z through the scene's middle, and another shape.
    state.parts.placements[1] = {.origin_mm = {0, 30, 0}, .x_axis = {0, 1, 0}, .y_axis = {-1, 0, 0}};
    s.view.setState(state);
    image = s.grab();
    QCOMPARE(image.pixel(200, 200 - 96), own);
    QCOMPARE(image.pixel(200 + 96, 200), rigid);
    scene::TriangleSoup wide = part;
    for (Vec3& v : wide.vertices) v.x *= 3.0;  // turned: along y
    s.view.setShape(1, wide.vertices);
    image = s.grab();
    QCOMPARE(image.pixel(200, 200 - 20), own);
    s.view.setShape(1, std::span(wide.vertices).first(2));  // not this body's
    s.view.setShape(7, wide.vertices);
    QCOMPARE(s.grab(), image);
    // Axes that are none, or no place: it is not drawn.
    for (const widgets::ScenePlacement& bad :
         {widgets::ScenePlacement{.origin_mm = {kNaN, 0, 0}}, widgets::ScenePlacement{.x_axis = {2, 0, 0}},
          widgets::ScenePlacement{.x_axis = {0, 0, 0}}, widgets::ScenePlacement{.x_axis = {0, 1, 0}},
          widgets::ScenePlacement{.origin_mm = {1e300, 0, 0}}}) {
      state.parts.placements[1] = bad;
      s.view.setState(state);
      image = s.grab();
      QCOMPARE(image.pixel(200, 200 - 96), rigid);
      QCOMPARE(image.pixel(200, 200), rigid);
    }
  }

  void anEmptySceneSaysSo() {
    Shown s;
    s.view.setEmptyText(QStringLiteral("Open a scene."));
    (void)s.grab();
    QCOMPARE(s.view.words(), QStringLiteral("Open a scene."));
    s.bodies({});
    scene::TriangleSoup none;
    s.bodies({body(none)});
    (void)s.grab();
    QCOMPARE(s.view.words(), QStringLiteral("Open a scene."));
    // A point alone is something.
    s.view.setState({.point_mm = {1, 2, 3}});
    s.view.look(SceneSide::top);
    const QImage image = s.grab();
    QCOMPARE(image.pixelColor(200, 200), widgets::theme().text);
    QVERIFY(s.view.words().contains(QStringLiteral("1.0, 2.0, 3.0 mm")));
  }

  void whatIsNoNumberIsNotDrawn() {
    scene::TriangleSoup square = plane(50, 0, 2);  // 8 triangles around the vertex in the middle
    square.vertices[0] = {kNaN, 0, 0};
    square.triangles.push_back({0, 1, 4'000'000'000U});
    Shown s;
    s.bodies({body(square)});
    const double inf = std::numeric_limits<double>::infinity();
    widgets::SceneState state{
        .point_mm = {kNaN, 0, 0}, .proxy_mm = {0, inf, 0}, .force_N = {inf, kNaN, 0}, .radius_mm = kNaN};
    state.parts.sticks = {{.from_mm = {kNaN, 0, 0}, .to_mm = {1, 1, 1}},
                          {.from_mm = {0, 0, 0}, .to_mm = {inf, 0, 0}},
                          {.from_mm = {1, 1, 1}, .to_mm = {1, 1, 1}},
                          {.radius_mm = kNaN}};
    state.parts.balls = {{.radius_mm = -1}, {.radius_mm = inf}, {.centre_mm = {0, kNaN, 0}}};
    state.parts.discs = {{.normal = {}}, {.normal = {kNaN, 0, 0}}, {.radius_mm = 0}};
    s.view.setState(state);
    s.view.look(SceneSide::top);
    QImage image = s.grab();
    QVERIFY(!isGround(image, 300, 150));
    QVERIFY(isGround(image, 100, 300));  // two triangles had the corner that is none
    QVERIFY2(s.view.footText().contains(QStringLiteral("6 triangles")), qPrintable(s.view.footText()));
    QVERIFY(s.view.footText().contains(QStringLiteral("3 left out")));
    QVERIFY(s.view.words().contains(QStringLiteral("Haptic point —, proxy —, force —")));
    state = {.point_mm = {1e300, -1e300, 1e300}, .proxy_mm = {0, 0, 0}, .force_N = {1e300, 1e300, 0}};
    s.view.setState(state);
    (void)s.grab();
    state.force_N = {1e-300, 0, 0};
    state.parts.sticks.assign(3 * widgets::kMostSceneParts, {.from_mm = {-1e6, 0, 0}, .to_mm = {1e6, 1, 1}});
    s.view.setState(state);
    (void)s.grab();
    s.view.resize(1, 1);
    (void)s.grab();
  }

  void theUnitDoesNotMatter() {
    QImage first;
    for (const double scale : {1.0, 1e-6, 1e6, 1e-3}) {
      scene::TriangleSoup box = cube({7 * scale, -3 * scale, 0}, 20 * scale);
      Shown s;
      s.bodies({body(box)});
      s.view.look(SceneSide::home);
      (void)s.grab();
      const QImage image = s.view.picture()->image;
      if (first.isNull()) first = image;
      int differ = 0;
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          differ += std::abs(qGray(image.pixel(x, y)) - qGray(first.pixel(x, y))) > 8 ? 1 : 0;
        }
      }
      QVERIFY2(differ < 20, qPrintable(QStringLiteral("%1: %2 pixels").arg(scale).arg(differ)));
    }
  }

  void tooManyTrianglesAreNamedAndNotDrawn() {
    const scene::TriangleSoup square = plane(50, 0);
    const std::vector<scene::Triangle> many(scene::kMostTriangles, scene::Triangle{0, 1, 2});
    const widgets::SceneBody huge{.name = QStringLiteral("huge"), .vertices_mm = square.vertices, .triangles = many};
    Shown s;
    s.bodies({body(square), huge});
    (void)s.grab();
    QVERIFY2(s.view.footText().contains(QStringLiteral("too large: huge")), qPrintable(s.view.footText()));
    QVERIFY(s.view.footText().contains(QStringLiteral("2 triangles")));
  }

  void bodiesThatAreReplacedOrTakenAwayWhileTheyAreBuilt() {
    const scene::TriangleSoup large = plane(50, 0, 500), small = plane(50, 0);
    {
      Shown s;
      s.bodies({body(large)});
      WAIT_FOR(s.view.footText().contains(QStringLiteral("preparing 500,000")) || s.view.settled());
      s.bodies({body(small)});
      (void)s.grab();
      QVERIFY(s.view.footText().startsWith(QStringLiteral("2 triangles")));
    }
    Shown gone;
    gone.bodies({body(large)});
    passTimers(20);  // and away while it is at work
  }

  void bothThemesAndADescription() {
    Shown s;
    const scene::TriangleSoup square = plane(50, 0);
    s.bodies({body(square)});
    QVERIFY(isGround(s.grab(), 395, 200));
    const QColor dark = ground();
    widgets::Look::instance().apply(*qApp, widgets::ThemeChoice::light);
    QVERIFY(dark != ground());
    QVERIFY(isGround(s.grab(), 395, 200));
    // A body stands out against its ground in both.
    for (const auto theme : {widgets::ThemeChoice::dark, widgets::ThemeChoice::light}) {
      widgets::Look::instance().apply(*qApp, theme);
      s.view.look(SceneSide::top);
      const QImage image = s.grab();
      QVERIFY(std::abs(qGray(image.pixel(250, 250)) - qGray(ground().rgb())) > 60);
    }
    QCOMPARE(s.view.accessibleName(), QStringLiteral("Scene"));
    for (const auto* button : s.view.findChildren<QToolButton*>()) {
      QVERIFY(!button->text().isEmpty() && !button->toolTip().isEmpty());
    }
    auto* top = s.view.findChild<QToolButton*>(QStringLiteral("scene_top"));
    QVERIFY(top != nullptr);
    s.view.look(SceneSide::front);
    QTest::mouseClick(top, Qt::LeftButton);
    QCOMPARE(s.view.camera().elevation_deg(), 90.0);
  }
};

std::unique_ptr<QObject> makeSceneViewTest() { return std::make_unique<SceneViewTest>(); }

}  // namespace fyd::tests

#include "scene_view_test.moc"
