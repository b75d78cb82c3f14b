#include "widgets/basics/icon.h"

#include <QFile>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>

#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

/// The drawing with its `currentColor` replaced; the few renderers are cached.
QSvgRenderer* rendererFor(const QString& name, const QColor& colour) {
  static QHash<QString, std::shared_ptr<QSvgRenderer>> kept;
  const QString key = name + colour.name(QColor::HexArgb);
  if (const auto found = kept.constFind(key); found != kept.constEnd()) return found->get();
  QFile file(QStringLiteral(":/fyd/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) return nullptr;
  QByteArray svg = file.readAll();
  svg.replace("currentColor", colour.name().toLatin1());
  auto renderer = std::make_shared<QSvgRenderer>(svg);
  if (!renderer->isValid()) return nullptr;
  kept.insert(key, renderer);
  return renderer.get();
}

class SvgEngine : public QIconEngine {
 public:
  SvgEngine(QString name, const QColor& colour) : name_(std::move(name)), colour_(colour) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    QColor colour = colour_.isValid() ? colour_ : theme().text;
    if (mode == QIcon::Disabled) colour = theme().muted;
    paintIcon(*painter, rect, name_, colour);
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    if (size.isEmpty()) return {};  // a style asks for it where there is no room
    QPixmap out(size);
    out.fill(Qt::transparent);
    QPainter painter(&out);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return out;
  }
  QIconEngine* clone() const override { return new SvgEngine(name_, colour_); }

 private:
  QString name_;
  QColor colour_;
};

}  // namespace

QIcon icon(const QString& name, const QColor& colour) {
  if (!QFile::exists(QStringLiteral(":/fyd/icons/%1.svg").arg(name))) return {};
  return QIcon(new SvgEngine(name, colour));
}

void paintIcon(QPainter& painter, const QRectF& where, const QString& name, const QColor& colour) {
  if (QSvgRenderer* renderer = rendererFor(name, colour)) renderer->render(&painter, where);
}

}  // namespace fyd::widgets
