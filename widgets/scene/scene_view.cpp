#include "widgets/scene/scene_view.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"
#include "widgets/scene/scene_marks.h"

namespace fyd::widgets {
namespace {

constexpr qint64 kRateWindow_ms = 1000;
constexpr std::size_t kMostPainted = 128;  // times that are kept: more than a second's
constexpr qint64 kFootEvery_ms = 500;      // a number that changes faster cannot be read
constexpr int kMost_px = 8192;             // of a picture's side
constexpr int kNarrow_px = 420;            // of the view

struct Side {
  SceneSide side;
  const char* name;
  const char* key;
};
constexpr Side kSides[] = {{SceneSide::home, QT_TRANSLATE_NOOP("SceneView", "Home"), "Home"},
                           {SceneSide::front, QT_TRANSLATE_NOOP("SceneView", "Front"), "1"},
                           {SceneSide::top, QT_TRANSLATE_NOOP("SceneView", "Top"), "2"},
                           {SceneSide::right, QT_TRANSLATE_NOOP("SceneView", "Right"), "3"}};

}  // namespace

SceneView::SceneView(QWidget* parent)
    : QWidget(parent), meshes_(SceneMeshes::of({})), empty_text_(tr("No scene yet.")) {
  setObjectName(QStringLiteral("scene_view"));
  setAccessibleName(tr("Scene"));
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(minimumSizeHint());
  setAttribute(Qt::WA_OpaquePaintEvent);
  buildButtons();
  clock_.start();
  since_change_.start();
  ticks_.setTimerType(Qt::PreciseTimer);
  ticks_.setInterval(kTick_ms);
  connect(&ticks_, &QTimer::timeout, this, &SceneView::tick);
  connect(&Look::instance(), &Look::changed, this, &SceneView::wake);
  worker_.start();
  refreshFoot();
}

SceneView::~SceneView() = default;

void SceneView::buildButtons() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid / 2);
  row->addStretch();
  touch_ = new QToolButton(this);
  touch_->setObjectName(QStringLiteral("scene_touch"));
  touch_->setText(tr("Touch"));
  touch_->setToolTip(
      tr("A drag in the picture moves the haptic point instead of turning the scene; wheel or Shift: "
         "nearer or farther. Without this button: Ctrl and drag."));
  touch_->setCheckable(true);
  touch_->setFont(textFont(TextSize::small));
  touch_->setFocusPolicy(Qt::TabFocus);
  touch_->hide();
  row->addWidget(touch_);
  row->addSpacing(kGrid);
  for (const Side& each : kSides) {
    auto* button = new QToolButton(this);
    button->setText(tr(each.name));
    button->setObjectName(QStringLiteral("scene_%1").arg(QLatin1String(each.name).toString().toLower()));
    button->setToolTip(tr("Show the whole scene from this side (%1)")
                           .arg(QKeySequence(QLatin1String(each.key)).toString(QKeySequence::NativeText)));
    button->setFont(textFont(TextSize::small));
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QToolButton::clicked, this, [this, side = each.side] { look(side); });
    row->addWidget(button);
    buttons_.append(button);
  }
  layout->addLayout(row);
  layout->addStretch();
}

void SceneView::setBodies(std::span<const SceneBody> bodies) { setMeshes(SceneMeshes::of(bodies)); }

void SceneView::setMeshes(std::shared_ptr<const SceneMeshes> meshes) {
  meshes_ = std::move(meshes);
  shapes_.assign(meshes_->bodies.size(), nullptr);
  box_known_ = false;
  side_ = SceneSide::home;
  look(SceneSide::home);
  refreshFoot();
}

void SceneView::setShape(std::size_t body, std::span<const Vec3> vertices_mm) {
  std::vector<float> shape = meshes_->shapeOf(body, vertices_mm);
  if (shape.empty()) return;
  shapes_[body] = std::make_shared<const std::vector<float>>(std::move(shape));
  parts_asked_ = false;
  wake();
}

void SceneView::setState(const SceneState& state) {
  if (!(state.parts == state_.parts)) parts_asked_ = false;
  state_ = state;
  if (!box_known_) {
    box_known_ = true;
    if (side_) look(*side_);
  }
  news_ = true;
  wake();
}

void SceneView::setEmptyText(const QString& text) {
  empty_text_ = text;
  update();
}

void SceneView::look(SceneSide side) {
  side_ = side;
  camera_.look(side, box(), size());
  wake();
}

/// The box around all bodies and parts.
SceneBox SceneView::box() const {
  SceneBox out;
  for (std::size_t b = 0; b < meshes_->bodies.size(); ++b) {
    if (meshes_->bodies[b].box.empty()) continue;
    const ScenePlacement at = b < state_.parts.placements.size() ? state_.parts.placements[b] : ScenePlacement{};
    for (const Vec3& corner : meshes_->bodies[b].box.corners()) {
      out.add(at.origin_mm + corner.x * at.x_axis + corner.y * at.y_axis + corner.z * at.z_axis);
    }
  }
  const auto addRound = [&out](Vec3 centre_mm, double radius_mm) {
    const Vec3 wide{radius_mm, radius_mm, radius_mm};
    out.add(centre_mm - wide);
    out.add(centre_mm + wide);
  };
  for (const SceneStick& each : state_.parts.sticks) {
    out.add(each.from_mm);
    out.add(each.to_mm);
  }
  for (const SceneBall& each : state_.parts.balls) addRound(each.centre_mm, each.radius_mm);
  for (const SceneDisc& each : state_.parts.discs) addRound(each.centre_mm, each.radius_mm);
  for (const SceneSheet& each : state_.parts.sheets) addRound(each.centre_mm, each.radius_mm());
  if (out.empty()) out.add(state_.point_mm);
  return out;
}

bool SceneView::nothingToShow() const {
  const SceneParts& p = state_.parts;
  return meshes_->triangles == 0 && p.sticks.empty() && p.balls.empty() && p.discs.empty() && p.sheets.empty() &&
         !state_.point_mm.finite() && !state_.proxy_mm.finite();
}

SceneShot SceneView::shot() const {
  const double ratio = devicePixelRatioF();
  const QSizeF wanted = QSizeF(size()) * ratio;
  return {.camera = camera_,
          .size_px = QSize(std::min(kMost_px, qRound(wanted.width())), std::min(kMost_px, qRound(wanted.height()))),
          .pixel_ratio = ratio,
          .colours = sceneColours()};
}

bool SceneView::outdated() const {
  return !parts_asked_ || !asked_ || asked_->meshes != meshes_ || !(asked_->shot == shot());
}

bool SceneView::settled() const {
  return !outdated() && answer_ && answer_->number == asked_->number && !news_ &&
         (answer_->picture.fineness.samples > 1 || !answer_->problem.isEmpty());
}

void SceneView::wake() {
  if (!moving()) painted_ms_.clear();  // a pause must not lower the picture rate
  since_change_.restart();
  if (isVisible() && !ticks_.isActive()) ticks_.start();
}

void SceneView::tick() {
  if (auto answer = worker_.take()) {
    const bool other = !answer_ || answer_->meshes != answer->meshes;
    answer_ = std::move(answer);
    if (other) refreshFoot();
    if (answer_->picture.fineness.samples == 1 || moving()) news_ = true;
    update();
  }
  if (outdated()) {
    ask(false);
  } else if (since_change_.elapsed() > kStill_ms && !finest_asked_ && !worker_.busy() && answer_ && !settled()) {
    ask(true);
  }
  if (news_) update();
  if (clock_.elapsed() - foot_ms_ > kFootEvery_ms) refreshFoot();
  if (settled() && !moving()) {
    refreshFoot();
    ticks_.stop();
  }
}

void SceneView::ask(bool finest) {
  auto request = std::make_unique<SceneRequest>();
  request->meshes = meshes_;
  request->shapes = shapes_;
  request->parts = state_.parts;
  request->shot = shot();
  request->finest = finest;
  request->number = asked_ ? asked_->number + 1 : 1;
  asked_ = Asked{meshes_, request->shot, request->number};
  parts_asked_ = true;
  finest_asked_ = finest;
  worker_.ask(std::move(request));
}

bool SceneView::moving() const { return isVisible() && since_change_.elapsed() < qint64{2} * kStill_ms; }

double SceneView::picturesPerSecond() const {
  if (!moving() || painted_ms_.size() < 2) return 0.0;
  // Of the last second; where it had fewer than three, of the last three.
  const auto in_window = std::ranges::lower_bound(painted_ms_, clock_.elapsed() - kRateWindow_ms);
  const auto least = painted_ms_.end() - std::min<std::ptrdiff_t>(3, std::ssize(painted_ms_));
  const auto first = std::min(in_window, least);
  // A picture that is late already lowers the rate.
  const qint64 until_ms = std::max(painted_ms_.back(), clock_.elapsed() - kTick_ms);
  const auto span_ms = static_cast<double>(until_ms - *first);
  return span_ms <= 0.0 ? 0.0 : 1e3 * static_cast<double>(painted_ms_.end() - first - 1) / span_ms;
}

void SceneView::refreshFoot() {
  foot_ms_ = clock_.elapsed();
  const QLocale locale;
  const QString triangles = locale.toString(static_cast<qulonglong>(meshes_->triangles));
  QString text;
  if (meshes_->triangles > 0 && (!answer_ || answer_->meshes != meshes_)) {
    text = tr("preparing %1 triangles…").arg(triangles);
  } else if (moving()) {
    const double rate = picturesPerSecond();
    text = tr("%1 triangles · %2 pictures/s").arg(triangles, numberText(rate, rate < 9.5 ? 1 : 0));
    if (answer_ && answer_->picture.fineness.block > 1) text = tr("%1 · coarser while it moves").arg(text);
  } else {
    text = tr("%1 triangles · nothing moves").arg(triangles);
  }
  if (meshes_->left_out > 0) {
    text = tr("%1 · %2 left out").arg(text, locale.toString(static_cast<qulonglong>(meshes_->left_out)));
  }
  if (!meshes_->too_big.empty()) text = tr("%1 · too large: %2").arg(text, meshes_->too_big.front());
  if (text != foot_) update();
  foot_ = text;
  const QString description = words();
  if (description != accessibleDescription()) setAccessibleDescription(description);
}

QString SceneView::words() const {
  if (answer_ && !answer_->problem.isEmpty()) {
    return tr("The scene cannot be drawn (%1). Haptic point %2, force %3.")
        .arg(answer_->problem, scenePlaceText(state_.point_mm), sceneForceText(state_));
  }
  if (nothingToShow()) return empty_text_;
  return tr("Haptic point %1, proxy %2, force %3; %4.")
      .arg(scenePlaceText(state_.point_mm), scenePlaceText(state_.proxy_mm), sceneForceText(state_), foot_);
}

QString SceneView::hint() const {
  if (touch_->isChecked()) return tr("Drag: touch · Shift or wheel: depth · right button: move");
  return drivable_ ? tr("Drag: turn · Shift: move · wheel: zoom · Ctrl: touch")
                   : tr("Drag: turn · Shift: move · wheel: zoom");
}

void SceneView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme().panel);
  const bool problem = answer_ && !answer_->problem.isEmpty();
  const bool drawn = answer_ && !answer_->picture.image.isNull() && !problem && !nothingToShow();
  if (drawn) {
    const ScenePicture& picture = answer_->picture;
    // While the widget is being resized the last picture stays in the middle.
    const QSizeF shown = QSizeF(picture.image.size()) / picture.shot.pixel_ratio;
    const QPointF corner((width() - shown.width()) / 2, (height() - shown.height()) / 2);
    painter.drawImage(QRectF(corner, shown), picture.image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.translate(corner);
    const double above = buttons_.front()->geometry().bottom() + 0.5 * kGrid;  // no text is drawn under the buttons
    if (driven_mm_) paintSceneHand(painter, picture, state_, *driven_mm_, shown);
    paintSceneMarks(painter, picture, state_, shown, above);
    painter.restore();
    paintSceneScale(painter, picture.shot.camera, size());
    const bool narrow = width() < kNarrow_px;  // legend and buttons, scale and foot do not fit beside each other
    paintSceneLegend(painter, QPointF(kGrid, narrow ? above : kGrid), state_);
    painter.setFont(textFont(TextSize::small));
    const QRectF inner = QRectF(rect()).adjusted(1.5 * kGrid, 0, -1.5 * kGrid, narrow ? -4.0 * kGrid : -kGrid);
    // In a narrow view the mouse's target replaces the foot text.
    const bool hand = driven_mm_.has_value();
    const QString led = hand ? tr("The mouse leads to %1").arg(scenePlaceText(*driven_mm_)) : QString();
    const double foot_px = (narrow ? 1.0 : 0.6) * inner.width();
    const QString foot =
        QFontMetricsF(painter.font(), this).elidedText(narrow && hand ? led : foot_, Qt::ElideRight, foot_px);
    paintSceneWords(painter, inner, Qt::AlignRight | Qt::AlignBottom, foot,
                    narrow && hand ? theme().text : theme().muted);
    if (!narrow && (hand || hint_)) {
      paintSceneWords(painter, inner.adjusted(0, 0, 0, -3.0 * kGrid), Qt::AlignRight | Qt::AlignBottom,
                      hand ? led : hint(), hand ? theme().text : theme().muted);
    }
  } else {
    painter.setPen(theme().muted);
    painter.setFont(textFont(TextSize::normal));
    painter.drawText(QRectF(rect()).adjusted(2 * kGrid, 6 * kGrid, -2 * kGrid, -2 * kGrid),
                     Qt::AlignCenter | Qt::TextWordWrap, problem || nothingToShow() ? words() : foot_);
  }
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().accent, 2));
    painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
  }
  if (news_) {
    news_ = false;
    painted_ms_.push_back(clock_.elapsed());
    if (painted_ms_.size() > kMostPainted) painted_ms_.pop_front();
  }
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (side_) camera_.look(*side_, box(), size());
  wake();
}

void SceneView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  wake();
}

void SceneView::hideEvent(QHideEvent* event) {
  release();  // a hidden view must not keep driving the haptic point
  ticks_.stop();
  QWidget::hideEvent(event);
}

}  // namespace fyd::widgets
