#include "app/console/operate/operate_page.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QVBoxLayout>
#include <algorithm>

#include "app/console/operate/recording_control.h"
#include "app/console/shell/curve_limits.h"
#include "app/console/shell/side_dock.h"
#include "app/console/shell/views.h"
#include "core/sensing/finger_detector.h"

namespace fyd::console {
namespace {

using widgets::kGrid;
using widgets::Quantity;

std::vector<widgets::TuningSection> sections() {
  return {
      {OperatePage::tr("Softness"),
       Quantity::stiffness,
       {{QLatin1String(kHandTarget), OperatePage::tr("By hand")},
        {QStringLiteral("control.kp"), {}},
        {QStringLiteral("control.ki"), {}},
        {QStringLiteral("control.kd"), {}}}},
      {OperatePage::tr("Texture"),
       Quantity::vibration,
       {{QStringLiteral("texture.method"), {}},
        {QStringLiteral("texture.pwm"), {}},
        {QStringLiteral("texture.k_vib"), {}},
        {QStringLiteral("texture.dead_zone_percent"), {}},
        {QStringLiteral("texture.maximum_percent"), {}}}},
  };
}

}  // namespace

OperatePage::OperatePage(const PageContext& context, QWidget* parent)
    : Page(parent),
      context_(context),
      ages_(context),
      camera_(new widgets::CameraPanel(this)),
      finger_(new FingerMenu(context.session, context.tell, camera_)),
      readiness_(new widgets::ReadinessList(this)),
      curves_(new widgets::CurveView(this)),
      curve_tools_(new CurveTools(curves_->stack(), context.tell, this)),
      tuning_(new widgets::TuningPanel(context.tuning.model(), sections(), QLatin1String(kHandTarget), this)),
      area_(new QMainWindow(this)),
      scene_(new SceneDock(area_)),
      panels_(*area_) {
  build();
  connectFeed();
  connectCurves();
  connectTuning();
  connectFinger();
}

void OperatePage::build() {
  area_->setWindowFlags(Qt::Widget);  // a part of the page, not a window of its own
  curve_tools_->saver().setFolder(sessionsFolder());
  auto* panel = new QFrame(this);
  panel->setProperty("surface", "panel");
  auto* panel_layout = new QHBoxLayout(panel);
  panel_layout->setContentsMargins(0, 0, 0, 0);
  panel_layout->setSpacing(0);
  auto* pictures = new QVBoxLayout;
  pictures->addWidget(curves_, 2);
  pictures->addWidget(curve_tools_->spectrum(), 1);
  panel_layout->addLayout(pictures, 1);
  panel_layout->addWidget(curve_tools_->panel());

  const auto dock = [this](const QString& title, const char* name, const QString& close, auto body,
                           Qt::DockWidgetArea side) {
    auto* made = new SideDock(title, QLatin1String(name) + QStringLiteral("_close"), close, body, area_);
    panels_.add(made, QLatin1String(name), side, true);
    return made;
  };
  using Parts = std::vector<QWidget*>;
  tuning_->setMinimumWidth(std::max(34 * kGrid, tuning_->minimumSizeHint().width()));  // it scrolls vertically only
  dock(tr("Camera"), "camera", tr("Close the camera's panel"), Parts{camera_}, Qt::LeftDockWidgetArea);
  dock(tr("Readiness"), "readiness", tr("Close the readiness list"), Parts{readiness_}, Qt::LeftDockWidgetArea);
  panels_.add(scene_, QStringLiteral("scene"), Qt::RightDockWidgetArea, context_.session.scene() != nullptr);
  dock(tr("Tuning"), "tuning", tr("Close the tuning panel"), static_cast<QWidget*>(tuning_), Qt::RightDockWidgetArea);
  area_->setCentralWidget(panel);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(area_);
}

void OperatePage::connectFeed() {
  const SessionFeed* feed = &context_.feed;
  connect(feed, &SessionFeed::telemetry, curves_, &widgets::CurveView::append);
  connect(feed, &SessionFeed::restarted, curves_, &widgets::CurveView::restart);
  connect(feed, &SessionFeed::restarted, camera_, [this] { camera_->showMissing(widgets::CameraImage::noneYet()); });
  connect(feed, &SessionFeed::picture, this, [this](const station::CameraView& view) {
    if (isVisible()) camera_->setPicture(toCameraPicture(view));
  });
  connect(feed, &SessionFeed::scene, scene_, &SceneDock::showScene);
  connect(feed, &SessionFeed::cameraMissing, camera_, &widgets::CameraPanel::showMissing);
  connect(feed, &SessionFeed::readiness, this, [this](std::vector<widgets::ReadinessRow> rows) {
    const auto ages = ages_.rows();
    rows.insert(rows.end(), ages.begin(), ages.end());
    readiness_->setRows(rows);
  });
}

void OperatePage::connectCurves() {
  widgets::SpectrumView* spectrum = curve_tools_->spectrum();
  const auto draw = [this, spectrum](bool even_soon) {
    spectrum->draw(curves_->buffer(), curves_->timeWindow(), even_soon);
  };
  connect(curves_, &widgets::CurveView::drawn, spectrum, [draw] { draw(false); });
  connect(spectrum, &widgets::SpectrumView::changed, spectrum, [draw] { draw(true); });
  connect(&context_.tuning.model(), &widgets::TuningModel::changed, this, &OperatePage::showLimits);
}

// Called also when the place is entered: a calibration may have begun the session anew, with another law.
void OperatePage::showLimits() { drawLimits(*curves_->stack(), context_.session.currentProfile().step); }

void OperatePage::connectTuning() {
  TuningBridge* bridge = &context_.tuning;
  connect(tuning_, &widgets::TuningPanel::targetByHandAsked, bridge, &TuningBridge::targetByHand);
  connect(tuning_, &widgets::TuningPanel::targetFromRobotAsked, bridge, &TuningBridge::targetFromRobot);
  connect(tuning_, &widgets::TuningPanel::saveAsked, bridge, &TuningBridge::save);
  connect(tuning_, &widgets::TuningPanel::refused, this, [this](const QString& why, const QString& parameter) {
    context_.tell_about(entryCause(parameter), widgets::Severity::warning, why);
  });
  connect(tuning_, &widgets::TuningPanel::entered, curves_, [this] { curves_->setFocus(Qt::OtherFocusReason); });
  auto* presets = new QMenu(this);
  bridge->presets().feed(*presets);
  tuning_->setPresetMenu(presets);
  connect(bridge, &TuningBridge::targetShown, tuning_, &widgets::TuningPanel::showTargetByHand);
}

void OperatePage::enter() {
  showLimits();
  showFinger();
}

/// The mouse presses only where the finger is simulated. Called again when other devices have come, and when the place
/// is entered: a calibration of the camera moves what lies under the mouse.
void OperatePage::showFinger() {
  const bool simulated = context_.session.simulated();
  widgets::PictureToTouchpad to_touchpad;
  if (simulated) {
    to_touchpad = [finger = context_.session.currentProfile().step.sensing.finger](QPointF px) {
      double x_mm = 0.0;
      double y_mm = 0.0;
      sensing::toMillimetres(finger, px.x(), px.y(), x_mm, y_mm);
      return QPointF(x_mm, y_mm);
    };
  }
  camera_->setTouchable(to_touchpad);
  scene_->setTouchable(simulated);
  finger_->setVisible(simulated);
  for (QAction* each : finger_actions_) each->setEnabled(simulated);
}

void OperatePage::connectFinger() {
  Session& session = context_.session;
  camera_->addBelow(finger_);
  connect(&context_.connection, &ConnectionChange::refreshed, this, [this] {
    if (finger_->isHidden() == context_.session.simulated()) showFinger();
  });
  const widgets::CameraImage* image = camera_->image();
  const auto move = [&session](double x_mm, double y_mm, double depth_mm) {
    session.moveSimulatedFinger(x_mm, y_mm, depth_mm);
  };
  const auto release = [&session] { session.releaseSimulatedFinger(); };
  connect(image, &widgets::CameraImage::fingerMoved, this, move);
  connect(image, &widgets::CameraImage::fingerReleased, this, release);
  connect(scene_, &SceneDock::fingerMoved, this, move);
  connect(scene_, &SceneDock::fingerReleased, this, release);
  showFinger();
}

void OperatePage::addCurveCommands(PlaceCommands& commands) {
  commands.add({"curves.pause", QT_TRANSLATE_NOOP("Commands", "Curves"),
                QT_TRANSLATE_NOOP("Commands", "Pause or follow"), "pause", "Space"},
               [this](bool) { curves_->togglePause(); });
  commands.add({"curves.follow", "Curves", QT_TRANSLATE_NOOP("Commands", "Follow the newest values"), "follow", "F"},
               [this](bool) { curves_->follow(); });
  commands.add({"curves.go_to", "Curves", QT_TRANSLATE_NOOP("Commands", "Go to a time"), "", "J"},
               [this](bool) { curves_->timeField()->setFocus(); });
  const auto span = [&](const char* id, const char* text, const char* keys, double span_s) {
    commands.add({id, "Curves", text, "", keys}, [this, span_s](bool) { curves_->chooseSpan(span_s); });
  };
  span("curves.span_5", QT_TRANSLATE_NOOP("Commands", "Show 5 s"), "Alt+1", 5.0);
  span("curves.span_10", QT_TRANSLATE_NOOP("Commands", "Show 10 s"), "Alt+2", 10.0);
  span("curves.span_30", QT_TRANSLATE_NOOP("Commands", "Show 30 s"), "Alt+3", 30.0);
  span("curves.span_60", QT_TRANSLATE_NOOP("Commands", "Show 60 s"), "Alt+4", 60.0);
  using Mark = widgets::CurveStack::Mark;
  const auto add = [&](const char* id, const char* text, const char* keys, std::function<void()> run) {
    commands.add({id, "Curves", text, "", keys}, [run = std::move(run)](bool) { run(); });
  };
  add("curves.mark_a", QT_TRANSLATE_NOOP("Commands", "Set A"), "[", [this] { curves_->setMark(Mark::a); });
  add("curves.mark_b", QT_TRANSLATE_NOOP("Commands", "Set B"), "]", [this] { curves_->setMark(Mark::b); });
  add("curves.clear_marks", QT_TRANSLATE_NOOP("Commands", "Take the cursor, A and B away"), "\\",
      [this] { curves_->clearMarks(); });
  constexpr double kSample_s = 0.001;
  add("curves.previous_sample", QT_TRANSLATE_NOOP("Commands", "Cursor to the previous sample"), ",",
      [this] { curves_->moveCursor(-kSample_s); });
  add("curves.next_sample", QT_TRANSLATE_NOOP("Commands", "Cursor to the next sample"), ".",
      [this] { curves_->moveCursor(kSample_s); });
  constexpr double kStep = 0.01;  // of what is shown
  add("curves.cursor_back", QT_TRANSLATE_NOOP("Commands", "Cursor back by a hundredth"), "Ctrl+Left",
      [this] { curves_->moveCursor(-kStep * curves_->timeWindow().span_s()); });
  add("curves.cursor_on", QT_TRANSLATE_NOOP("Commands", "Cursor on by a hundredth"), "Ctrl+Right",
      [this] { curves_->moveCursor(kStep * curves_->timeWindow().span_s()); });
  curve_tools_->addCommands(commands, "curves", "Curves", [this] {
    curve_tools_->saver().saveTable(widgets::tableOf(*curves_->stack(), curves_->buffer()));
  });
  for (QToolButton* button : curve_tools_->makeButtons(curves_)) curves_->addButton(button);
}

void OperatePage::addCommands(PlaceCommands& commands) {
  widgets::TuningModel* model = &context_.tuning.model();
  commands.add(
      {"edit.undo", QT_TRANSLATE_NOOP("Commands", "Edit"), QT_TRANSLATE_NOOP("Commands", "Undo"), "undo", "Ctrl+Z"},
      [model](bool) { model->undo(); });
  commands.add({"edit.redo", "Edit", QT_TRANSLATE_NOOP("Commands", "Redo"), "redo", "Ctrl+Shift+Z"},
               [model](bool) { model->redo(); });
  commands.add({"edit.compare", "Edit", QT_TRANSLATE_NOOP("Commands", "Feel saved or current values"), "", "Ctrl+B"},
               [model](bool) { model->feelSaved(!model->feelingSaved()); });
  commands.add({"session.target_by_hand", "Edit", QT_TRANSLATE_NOOP("Commands", "Target by hand"), "", "Ctrl+H"},
               [this](bool) { tuning_->byHandButton()->click(); });
  commands.add({"session.target_from_robot", "Edit", QT_TRANSLATE_NOOP("Commands", "Target from robot"), "robot",
                "Ctrl+Shift+H"},
               [this](bool) { tuning_->fromRobotButton()->click(); });
  const auto panel = [&](const char* id, const char* text, const char* dock, const char* keys = "") {
    connectToggle(commands.add({id, "View", text, "", keys, true}, [](bool) {}),
                  area_->findChild<QDockWidget*>(QLatin1String(dock)));
  };
  panel("view.panel_camera", QT_TRANSLATE_NOOP("Commands", "Camera panel"), "camera");
  panel("view.panel_readiness", QT_TRANSLATE_NOOP("Commands", "Readiness list"), "readiness");
  panel("view.panel_tuning", QT_TRANSLATE_NOOP("Commands", "Tuning panel"), "tuning");
  panel("view.panel_scene", QT_TRANSLATE_NOOP("Commands", "Scene panel"), "scene", "Ctrl+E");
  addCurveCommands(commands);
  finger_actions_ = {commands.add({"session.finger_card", "Edit",
                                   QT_TRANSLATE_NOOP("Commands", "Gesture card for the simulated finger"), "", ""},
                                  [this](bool) { finger_->chooseFile(); }),
                     commands.add({"session.finger_demonstration", "Edit",
                                   QT_TRANSLATE_NOOP("Commands", "Demonstration by the simulated finger"), "", ""},
                                  [this](bool) { finger_->playDemonstration(); })};
  showFinger();
  QToolButton* mask = camera_->maskButton();
  QAction* mask_action =
      commands.add({"view.mask", "View", QT_TRANSLATE_NOOP("Commands", "Finger mask"), "mask", "M", true},
                   [mask](bool shown) { mask->setChecked(shown); });
  mask_action->setChecked(mask->isChecked());
  connect(mask, &QToolButton::toggled, mask_action, &QAction::setChecked);
}

}  // namespace fyd::console
