// What is drawn over the picture of a scene: haptic point, proxy, the force as a green segment with its value, axes and
// scale. What a body hides is drawn fainter and dashed, so that a point inside a body is still seen.
#pragma once

#include <QPainter>

#include "widgets/scene_caster.h"

namespace fyd::widgets {

inline constexpr double kSceneForce_px_per_N = 24.0;  ///< of the segment; the same at every zoom
inline constexpr double kSceneLongest_px = 240.0;  ///< a longer one ends here with a gap, and the value says the rest

/// @param picture tells what is hidden, and from where the scene is seen
/// @param above_px the value stands below this
void paintSceneMarks(QPainter& painter, const ScenePicture& picture, const SceneState& state, QSizeF widget_px,
                     double above_px);
/// Where a hand leads the haptic point to, and from where.
void paintSceneHand(QPainter& painter, const ScenePicture& picture, const SceneState& state, Vec3 hand_mm,
                    QSizeF widget_px);
/// Words over a picture, on a ground of their own.
void paintSceneWords(QPainter& painter, const QRectF& box, int alignment, const QString& text, const QColor& colour);
/// The marks' words and shapes: what is what.
void paintSceneLegend(QPainter& painter, QPointF top_left, const SceneState& state);
/// Axes, and a bar of a round number of millimetres. @return the bar's text
QString paintSceneScale(QPainter& painter, const SceneCamera& camera, QSizeF widget_px);

/// "2.31 N", "—" when there is none.
[[nodiscard]] QString sceneForceText(const SceneState& state);
[[nodiscard]] QString scenePlaceText(Vec3 place_mm);
[[nodiscard]] SceneColours sceneColours();

}  // namespace fyd::widgets
