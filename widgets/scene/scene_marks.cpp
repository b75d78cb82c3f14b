#include "widgets/scene/scene_marks.h"

#include <QCoreApplication>
#include <cmath>

#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr double kPoint_px = 5.0;    // radius of the haptic point's ball
constexpr double kProxy_px = 8.0;    // radius of the proxy's ring
constexpr double kHand_px = 10.0;    // half the cross at the mouse's target of the haptic point
constexpr double kProbe_px = 2.0;    // spacing of the places at which a segment is tested for being hidden
constexpr double kGrazing_px = 2.0;  // a mark that lies on a surface is not hidden by it
constexpr int kMostProbes = 1000;
constexpr double kAxis_px = 24.0;
constexpr double kFarthest_px = 20'000.0;

QColor mix(const QColor& a, const QColor& b, double share) {
  const auto part = [share](int x, int y) { return qRound(x + share * (y - x)); };
  return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

QColor faint(QColor colour) {
  colour.setAlphaF(0.6F);
  return colour;
}

class Marks {
 public:
  Marks(QPainter& painter, const ScenePicture& picture, QSizeF widget_px)
      : painter_(painter), picture_(picture), camera_(picture.shot.camera), size_(widget_px) {}

  [[nodiscard]] QPointF at(Vec3 place_mm) const { return camera_.project(place_mm, size_); }

  /// Whether it is near enough: for very distant points Qt computes dashes endlessly.
  [[nodiscard]] bool paintable(Vec3 place_mm) const {
    const QPointF p = at(place_mm);
    return std::abs(p.x()) < kFarthest_px && std::abs(p.y()) < kFarthest_px;  // false for no number
  }

  [[nodiscard]] bool hidden(Vec3 place_mm, double margin_mm = 0.0) const {
    const double surface_mm = picture_.depthAt(picture_.shot.pixel_ratio * at(place_mm));
    return camera_.depth_mm(place_mm) > surface_mm + margin_mm + kGrazing_px * camera_.mmPerPixel();
  }

  void segment(Vec3 from_mm, Vec3 to_mm, const QColor& colour, double width, bool with_edge) const {
    if (!paintable(from_mm) || !paintable(to_mm)) return;
    const QPointF way = at(to_mm) - at(from_mm);
    const double length_px = std::hypot(way.x(), way.y());
    const int n = std::clamp(static_cast<int>(length_px / kProbe_px), 1, kMostProbes);
    Vec3 begun_mm = from_mm;
    bool begun_hidden = hidden(from_mm);
    for (int i = 1; i <= n; ++i) {
      const Vec3 here_mm = from_mm + (static_cast<double>(i) / n) * (to_mm - from_mm);
      const bool here_hidden = hidden(here_mm);
      if (here_hidden == begun_hidden && i < n) continue;
      piece(at(begun_mm), at(here_mm), begun_hidden, colour, width, with_edge);
      begun_mm = here_mm;
      begun_hidden = here_hidden;
    }
  }

  void ball(Vec3 place_mm, double radius_mm) const {
    if (!paintable(place_mm)) return;
    const bool behind = hidden(place_mm, radius_mm);
    painter_.setPen(QPen(theme().panel, 1.5));
    painter_.setBrush(behind ? faint(theme().text) : theme().text);
    painter_.drawEllipse(at(place_mm), kPoint_px, kPoint_px);
    outline(place_mm, radius_mm, theme().text, behind);
  }

  void ring(Vec3 place_mm, double radius_mm) const {
    if (!paintable(place_mm)) return;
    const bool behind = hidden(place_mm, radius_mm);
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(faint(theme().panel), 5.0));
    if (!behind) painter_.drawEllipse(at(place_mm), kProxy_px, kProxy_px);
    painter_.setPen(QPen(theme().text, 2.0, behind ? Qt::DotLine : Qt::SolidLine));
    painter_.drawEllipse(at(place_mm), kProxy_px, kProxy_px);
    outline(place_mm, radius_mm, theme().text, behind);
  }

  void value(QPointF tip, const QString& text, const QColor& colour, double above_px) const {
    painter_.setFont(textFont(TextSize::normal, true));
    const QFontMetricsF metrics(painter_.font(), painter_.device());
    QRectF box(QPointF(), QSizeF(metrics.horizontalAdvance(text) + 1.5 * kGrid, metrics.height() + kGrid / 2.0));
    box.moveTopLeft(tip + QPointF(1.5 * kGrid, -box.height() / 2));
    // Within the picture wherever the segment ends.
    const auto within = [](double at, double least, double most) {
      return std::clamp(at, least, std::max(least, most));
    };
    box.moveLeft(within(box.left(), 0.5 * kGrid, size_.width() - box.width() - 0.5 * kGrid));
    box.moveTop(within(box.top(), above_px, size_.height() - box.height() - 0.5 * kGrid));
    QColor ground = theme().panel;
    ground.setAlphaF(0.88F);
    painter_.setPen(QPen(colour, 1.0));
    painter_.setBrush(ground);
    painter_.drawRoundedRect(box, 4, 4);
    painter_.setPen(theme().text);
    painter_.drawText(box, Qt::AlignCenter, text);
  }

 private:
  void piece(QPointF from, QPointF to, bool behind, const QColor& colour, double width, bool with_edge) const {
    if (with_edge && !behind) {
      painter_.setPen(QPen(theme().panel, width + 2.5, Qt::SolidLine, Qt::FlatCap));
      painter_.drawLine(from, to);
    }
    QPen pen(colour, width, Qt::SolidLine, Qt::FlatCap);
    if (behind) pen.setDashPattern({3.0, 1.5});
    painter_.setPen(pen);
    painter_.drawLine(from, to);
  }

  /// The true size, where it is larger than the mark.
  void outline(Vec3 place_mm, double radius_mm, const QColor& colour, bool behind) const {
    const double radius_px = radius_mm / camera_.mmPerPixel();
    if (!(radius_px > kProxy_px + 2.0) || radius_px > kFarthest_px) return;
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(faint(colour), 1.0, behind ? Qt::DashLine : Qt::SolidLine));
    painter_.drawEllipse(at(place_mm), radius_px, radius_px);
  }

  QPainter& painter_;
  const ScenePicture& picture_;
  const SceneCamera& camera_;
  QSizeF size_;
};

QString words(const char* text) { return QCoreApplication::translate("SceneView", text); }

}  // namespace

SceneColours sceneColours() {
  const Theme& t = theme();
  SceneColours out;
  out.ground = t.panel;
  const QColor body = t.dark ? mix(t.muted, t.text, 0.3) : mix(t.muted, t.window, 0.45);
  const auto set = [&out](SceneRole role, const QColor& colour) {
    out.outside[static_cast<std::size_t>(role)] = colour;
    out.inside[static_cast<std::size_t>(role)] = mix(colour, out.ground, 0.45);
  };
  set(SceneRole::rigid, body);
  set(SceneRole::soft, mix(body, t.indentation, 0.35));
  set(SceneRole::own, t.dark ? t.text : mix(t.text, t.muted, 0.6));  // on black no shading would be visible
  set(SceneRole::other, t.dark ? t.accent : mix(t.muted, t.window, 0.25));
  return out;
}

void paintSceneWords(QPainter& painter, const QRectF& box, int alignment, const QString& text, const QColor& colour) {
  QColor ground = theme().panel;
  ground.setAlphaF(0.8F);
  const QRectF words = painter.boundingRect(box, alignment, text);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawRoundedRect(words.adjusted(-4, -2, 4, 2), 4, 4);
  painter.setPen(colour);
  painter.drawText(box, alignment, text);
}

QString sceneForceText(const SceneState& state) {
  return quantityText(state.force_N.finite() ? scene::length(state.force_N) : kSceneNone, 2, QStringLiteral("N"));
}

QString scenePlaceText(Vec3 place_mm) {
  if (!place_mm.finite()) return kNoValue;
  return rowText({numberText(place_mm.x, 1), numberText(place_mm.y, 1), numberText(place_mm.z, 1)}) +
         QStringLiteral(" mm");
}

void paintSceneMarks(QPainter& painter, const ScenePicture& picture, const SceneState& state, QSizeF widget_px,
                     double above_px) {
  const Marks marks(painter, picture, widget_px);
  const SceneCamera& camera = picture.shot.camera;
  const bool point = state.point_mm.finite(), proxy = state.proxy_mm.finite();
  const Vec3 origin_mm = proxy ? state.proxy_mm : state.point_mm;
  const double force_N = scene::length(state.force_N);
  if (point && proxy) marks.segment(state.point_mm, state.proxy_mm, theme().text, 1.5, false);
  if (state.force_N.finite() && std::isfinite(force_N) && force_N > 0.0 && marks.paintable(origin_mm)) {
    const double length_px = std::min(kSceneForce_px_per_N * force_N, kSceneLongest_px);
    const Vec3 way = scene::unit(state.force_N);
    const Vec3 tip_mm = origin_mm + (length_px * camera.mmPerPixel()) * way;
    if (kSceneForce_px_per_N * force_N > kSceneLongest_px) {
      const Vec3 gap_mm = origin_mm + (0.9 * length_px * camera.mmPerPixel()) * way;
      marks.segment(origin_mm, origin_mm + (0.85 * length_px * camera.mmPerPixel()) * way, theme().live, 4.0, true);
      marks.segment(gap_mm, tip_mm, theme().live, 4.0, true);
    } else {
      marks.segment(origin_mm, tip_mm, theme().live, 4.0, true);
    }
    if (proxy) marks.ring(state.proxy_mm, state.radius_mm);
    if (point) marks.ball(state.point_mm, state.radius_mm);
    marks.value(marks.at(tip_mm), sceneForceText(state), theme().live, above_px);
    return;
  }
  if (proxy) marks.ring(state.proxy_mm, state.radius_mm);
  if (point) marks.ball(state.point_mm, state.radius_mm);
}

void paintSceneHand(QPainter& painter, const ScenePicture& picture, const SceneState& state, Vec3 hand_mm,
                    QSizeF widget_px) {
  const Marks marks(painter, picture, widget_px);
  if (!marks.paintable(hand_mm)) return;
  const QPointF hand = marks.at(hand_mm);
  for (const auto& [colour, width] : {std::pair{faint(theme().panel), 4.0}, std::pair{theme().accent, 2.0}}) {
    painter.setPen(QPen(colour, width));
    if (marks.paintable(state.point_mm)) painter.drawLine(marks.at(state.point_mm), hand);
    for (const QPointF arm : {QPointF(kHand_px, 0), QPointF(0, kHand_px)}) painter.drawLine(hand - arm, hand + arm);
  }
}

void paintSceneLegend(QPainter& painter, QPointF top_left, const SceneState& state) {
  painter.setFont(textFont(TextSize::small));
  const QFontMetricsF metrics(painter.font(), painter.device());
  const double row_px = metrics.height() + 4.0;
  QPointF at = top_left;
  const auto row = [&](const QString& text, const std::function<void(QPointF)>& sign) {
    const QRectF box(at + QPointF(3.0 * kGrid, 0), QSizeF(metrics.horizontalAdvance(text) + 1.0, row_px));
    paintSceneWords(painter, box, Qt::AlignLeft | Qt::AlignVCenter, text, theme().text);
    sign(at + QPointF(kGrid, row_px / 2));
    at.ry() += row_px;
  };
  row(words(QT_TRANSLATE_NOOP("SceneView", "Haptic point")), [&](QPointF c) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().text);
    painter.drawEllipse(c, kPoint_px, kPoint_px);
  });
  row(words(QT_TRANSLATE_NOOP("SceneView", "Proxy")), [&](QPointF c) {
    painter.setPen(QPen(theme().text, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(c, kProxy_px - 2.0, kProxy_px - 2.0);
  });
  row(words(QT_TRANSLATE_NOOP("SceneView", "Force %1")).arg(sceneForceText(state)), [&](QPointF c) {
    painter.setPen(QPen(theme().live, 4.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(c - QPointF(kGrid, 0), c + QPointF(kGrid, 0));
  });
}

QString paintSceneScale(QPainter& painter, const SceneCamera& camera, QSizeF widget_px) {
  painter.setFont(textFont(TextSize::small));
  const QFontMetricsF metrics(painter.font(), painter.device());
  const QPointF corner(1.5 * kGrid, widget_px.height() - 1.5 * kGrid);
  // 1, 2 or 5 times a power of ten: the longest bar of at most 120 px.
  const double most_mm = 120.0 * camera.mmPerPixel();
  const double power = std::pow(10.0, std::floor(std::log10(most_mm)));
  const double bar_mm = power * (most_mm >= 5.0 * power ? 5.0 : most_mm >= 2.0 * power ? 2.0 : 1.0);
  const double bar_px = bar_mm / camera.mmPerPixel();
  if (!std::isfinite(bar_px)) return {};
  QString text = QStringLiteral("%1 mm").arg(plainNumber(bar_mm));
  painter.setPen(QPen(theme().text, 2.0, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(corner, corner + QPointF(bar_px, 0));
  painter.setPen(QPen(theme().text, 1.0));
  for (const double x : {0.0, bar_px}) painter.drawLine(corner + QPointF(x, -4), corner + QPointF(x, 1));
  const QRectF beside(corner + QPointF(bar_px + kGrid, -metrics.height() / 2 - 1),
                      QSizeF(metrics.horizontalAdvance(text) + 1.0, metrics.height()));
  paintSceneWords(painter, beside, Qt::AlignLeft | Qt::AlignVCenter, text, theme().text);

  const QPointF middle = corner + QPointF(kAxis_px + kGrid, -kAxis_px - 3 * kGrid);
  const std::pair<const char*, Vec3> axes[] = {{"x", {1, 0, 0}}, {"y", {0, 1, 0}}, {"z", {0, 0, 1}}};
  for (const auto& [name, axis] : axes) {
    const QPointF way(scene::dot(axis, camera.right()), -scene::dot(axis, camera.up()));
    painter.setPen(QPen(theme().muted, 1.5));
    painter.drawLine(middle, middle + kAxis_px * way);
    if (std::hypot(way.x(), way.y()) < 0.3) continue;  // points at the eye: its letter would cover the others'
    painter.setPen(theme().text);
    const QPointF at = middle + (kAxis_px + kGrid) * way;
    painter.drawText(QRectF(at - QPointF(kGrid, kGrid), QSizeF(2 * kGrid, 2 * kGrid)), Qt::AlignCenter,
                     QLatin1String(name));
  }
  return text;
}

}  // namespace fyd::widgets
