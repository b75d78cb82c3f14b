#include "app/console/window/geometry_dump.h"

#include <QAbstractButton>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QWidget>

namespace fyd::console {
namespace {

QString nameOf(const QWidget& control) {
  if (!control.accessibleName().isEmpty()) return control.accessibleName();
  const auto* button = qobject_cast<const QAbstractButton*>(&control);
  return button != nullptr ? button->text() : QString();
}

}  // namespace

QByteArray dumpGeometry(const QWidget& window) {
  QJsonArray controls;
  for (const QWidget* each : window.findChildren<QWidget*>()) {
    const QString name = nameOf(*each);
    if (name.isEmpty() || !each->isVisible() || each->window() != &window) continue;
    const QPoint corner = each->mapTo(&window, QPoint(0, 0));
    if (!window.rect().intersects(QRect(corner, each->size()))) continue;  // scrolled away, or of a tab behind
    controls.append(QJsonObject{{QStringLiteral("name"), name},
                                {QStringLiteral("id"), each->objectName()},
                                {QStringLiteral("kind"), QLatin1String(each->metaObject()->className())},
                                {QStringLiteral("x"), corner.x()},
                                {QStringLiteral("y"), corner.y()},
                                {QStringLiteral("width"), each->width()},
                                {QStringLiteral("height"), each->height()}});
  }
  const QJsonObject size{{QStringLiteral("width"), window.width()}, {QStringLiteral("height"), window.height()}};
  return QJsonDocument(QJsonObject{{QStringLiteral("window"), size}, {QStringLiteral("controls"), controls}}).toJson();
}

}  // namespace fyd::console
