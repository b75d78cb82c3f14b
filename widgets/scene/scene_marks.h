// What is drawn over the picture of a scene: haptic point, proxy, the force as a green segment with its value, axes and
// scale. What a body hides is drawn fainter and dashed, so that a point inside a body is still seen.
#pragma once

#include <QPainter>

#include "widgets/scene/scene_caster.h"

namespace fyd::widgets {

inline constexpr double kSceneForce_px_per_N = 24.0;  ///< of the segment; the same at every zoom
inline constexpr double kSceneLongest_px = 240.0;     ///< a longer one is cut with a gap; the value tells its length

/// @param picture its depth and camera, to find what is hidden
/// @param above_px the value is drawn below this
void paintSceneMarks(QPainter& painter, const ScenePicture& picture, const SceneState& state, QSizeF widget_px,
                     double above_px);
/// The target to which the mouse drives the haptic point, and the line to it.
void paintSceneHand(QPainter& painter, const ScenePicture& picture, const SceneState& state, Vec3 hand_mm,
                    QSizeF widget_px);
/// Text over a picture, with its own background.
void paintSceneWords(QPainter& painter, const QRectF& box, int alignment, const QString& text, const QColor& colour);
/// Legend of the marks.
void paintSceneLegend(QPainter& painter, QPointF top_left, const SceneState& state);
/// Axes, and a bar of a round number of millimetres. @return the bar's text
QString paintSceneScale(QPainter& painter, const SceneCamera& camera, QSizeF widget_px);

/// "2.31 N", "—" when there is none.
[[nodiscard]] QString sceneForceText(const SceneState& state);
[[nodiscard]] QString scenePlaceText(Vec3 place_mm);
[[nodiscard]] SceneColours sceneColours();

}  // namespace fyd::widgets
