// The project's own icons (resources/icons/*.svg), drawn in one colour that follows the theme, sharp at every scale.
#pragma once

#include <QColor>
#include <QIcon>
#include <QPixmap>
#include <QString>

class QPainter;
class QRectF;

namespace fyd::widgets {

/// @param name file name without ".svg"; an unknown name gives an empty icon
/// @param colour invalid: the theme's text colour at the time of painting
[[nodiscard]] QIcon icon(const QString& name, const QColor& colour = {});
void paintIcon(QPainter& painter, const QRectF& where, const QString& name, const QColor& colour);

}  // namespace fyd::widgets
