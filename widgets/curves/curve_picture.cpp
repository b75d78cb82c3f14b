#include "widgets/curves/curve_picture.h"

#include <QBuffer>
#include <QImage>
#include <QPageSize>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <algorithm>
#include <array>
#include <charconv>

#include <qcustomplot.h>

#include "widgets/basics/words.h"
#include "widgets/curves/curve_catalogue.h"

namespace fyd::widgets {
namespace {

constexpr int kTitleHeight = 5 * kGrid;
constexpr int kNameHeight = 3 * kGrid;
constexpr int kLeast = 40 * kGrid;  // width in px when the window has no size yet
constexpr int kDensity = 2;         // pixels of a PNG for one of the window

QSize sizeOf(const CurveStack& stack) {
  QSize size(kLeast, kTitleHeight);
  for (std::size_t i = 0; i < stack.size(); ++i) {
    if (!stack.shown(i)) continue;
    size.setWidth(std::max(size.width(), stack.strip(i)->width()));
    size.rheight() += kNameHeight + stack.strip(i)->height();
  }
  return size;
}

void paintName(QPainter& painter, const StripSetup& setup, int width) {
  painter.setFont(textFont(TextSize::small, true));
  painter.setPen(theme().text);
  const QString name = setup.unit.isEmpty() ? setup.title : tr("%1, %2").arg(setup.title, setup.unit);
  const QRect line(kGrid, 0, width - 2 * kGrid, kNameHeight);
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, name);
  int x = line.left() + painter.fontMetrics().horizontalAdvance(name) + 2 * kGrid;
  painter.setFont(textFont(TextSize::small));
  for (const Readout::Entry& entry : setup.entries) {
    if (entry.label.isEmpty()) continue;
    const QColor colour = entry.quantity == Quantity::none ? theme().text : theme().of(entry.quantity);
    painter.setPen(QPen(colour, 1, entry.dashed ? Qt::DashLine : Qt::SolidLine));
    painter.drawLine(x, kNameHeight / 2, x + 2 * kGrid, kNameHeight / 2);
    painter.setPen(colour);
    x += 2 * kGrid + kGrid / 2;
    painter.drawText(QRect(x, 0, width - x, kNameHeight), Qt::AlignLeft | Qt::AlignVCenter, entry.label);
    x += painter.fontMetrics().horizontalAdvance(entry.label) + 2 * kGrid;
  }
}

void paint(QCPPainter& painter, const CurveStack& stack, const QString& title) {
  const QSize size = sizeOf(stack);
  painter.fillRect(QRect(QPoint(0, 0), size), theme().panel);
  painter.setFont(textFont(TextSize::normal, true));
  painter.setPen(theme().text);
  const QRect head(kGrid, 0, size.width() - 2 * kGrid, kTitleHeight);
  painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, title);
  painter.setFont(textFont(TextSize::small));
  painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, stack.markText());
  int y = kTitleHeight;
  for (std::size_t i = 0; i < stack.size(); ++i) {
    if (!stack.shown(i)) continue;
    painter.save();
    painter.translate(0, y);
    paintName(painter, stack.setup(i), size.width());
    painter.translate(0, kNameHeight);
    stack.strip(i)->paintTo(painter, {size.width(), stack.strip(i)->height()});
    painter.restore();
    y += kNameHeight + stack.strip(i)->height();
  }
}

void paintPage(QPdfWriter& writer, const CurveStack& stack, const QString& title) {
  QCPPainter painter(&writer);
  painter.setMode(QCPPainter::pmVectorized);
  const QSize size = sizeOf(stack);
  const double scale = std::min(writer.width() / static_cast<double>(size.width()),
                                writer.height() / static_cast<double>(size.height()));
  painter.scale(scale, scale);
  paint(painter, stack, title);
}

void appendNumber(QByteArray& line, double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.begin(), text.end(), static_cast<float>(value)).ptr;
  line.append(text.data(), end - text.data());
}

}  // namespace

QString wordOf(PictureKind kind) {
  switch (kind) {
    case PictureKind::svg: return QStringLiteral("svg");
    case PictureKind::pdf: return QStringLiteral("pdf");
    case PictureKind::png: break;
  }
  return QStringLiteral("png");
}

Result<QByteArray> pictureOf(const CurveStack& stack, PictureKind kind, const QString& title) {
  QByteArray out;
  QBuffer buffer(&out);
  buffer.open(QIODevice::WriteOnly);
  const QSize size = sizeOf(stack);
  if (kind == PictureKind::pdf) {
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageOrientation(QPageLayout::Landscape);
    writer.setTitle(title);
    paintPage(writer, stack, title);
  } else if (kind == PictureKind::svg) {
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setViewBox(QRect(QPoint(0, 0), size));
    generator.setSize(size);
    generator.setTitle(title);
    QCPPainter painter(&generator);
    painter.setMode(QCPPainter::pmVectorized);
    paint(painter, stack, title);
  } else {
    QImage image(size * kDensity, QImage::Format_RGB32);
    if (image.isNull()) return fail("a picture of {} x {} pixels: too large", size.width(), size.height());
    QCPPainter painter;
    painter.begin(&image);
    painter.scale(kDensity, kDensity);
    paint(painter, stack, title);
    painter.end();
    if (!image.save(&buffer, "PNG")) return fail("png: the picture could not be made");
  }
  if (out.isEmpty()) return fail("{}: the picture could not be made", wordOf(kind).toStdString());
  return out;
}

CurveTable tableOf(const CurveStack& stack, const CurveSource& source) {
  std::vector<std::size_t> channels;
  double from_s = std::numeric_limits<double>::infinity();
  double to_s = -from_s;
  for (std::size_t i = 0; i < stack.size(); ++i) {
    if (!stack.shown(i)) continue;
    from_s = std::min(from_s, stack.window(i).from_s());
    to_s = std::max(to_s, stack.window(i).to_s());
    for (const Trace& trace : stack.setup(i).traces) {
      if (trace.channel < kCurveChannels) channels.push_back(trace.channel);
    }
  }
  std::ranges::sort(channels);
  CurveTable out;
  for (const std::size_t channel : channels) {
    const pipeline::TelemetryField& field = pipeline::telemetryFields()[curveFields()[channel]];
    out.names.push_back(std::string(field.name) + " [" + std::string(field.unit) + "]");
  }
  out.rows = source.rows(channels, from_s, to_s);
  return out;
}

QByteArray csvOf(const CurveTable& table) {
  QByteArray out = "time [s]";
  for (const std::string& name : table.names) out.append(',').append(name.c_str());
  out.append('\n');
  for (std::size_t row = 0; row < table.rows.time_s.size(); ++row) {
    out.append(QByteArray::number(table.rows.time_s[row], 'f', 6));
    for (const std::vector<float>& column : table.rows.values) {
      out.append(',');
      appendNumber(out, column[row]);
    }
    out.append('\n');
  }
  return out;
}

}  // namespace fyd::widgets
