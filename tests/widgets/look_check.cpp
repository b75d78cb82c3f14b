#include "tests/widgets/look_check.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QStackedWidget>
#include <QTabBar>
#include <QTextDocument>

#include <qcustomplot.h>

#include "widgets/basics/heading_table.h"

namespace fyd::tests {
namespace {

constexpr int kHeaderPadding = 16;  // px, of the style sheet
constexpr int kLeastSlider_px = 64;
constexpr int kSlack = 1;  // px: a scale that is no whole number rounds

QString nameOf(const QWidget& widget, const QString& text) {
  return QStringLiteral("%1 %2 \"%3\"")
      .arg(QLatin1String(widget.metaObject()->className()), widget.objectName(), text.simplified());
}

QString sizes(QSize wanted, QSize given) {
  return QStringLiteral(" wants %1×%2, has %3×%4")
      .arg(wanted.width())
      .arg(wanted.height())
      .arg(given.width())
      .arg(given.height());
}

QString textOf(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
  return {};
}

/// Text that a scroll area moves, or that is cut on purpose, is not cut off.
bool cutsOnPurpose(const QWidget& widget) {
  return widget.sizePolicy().horizontalPolicy() == QSizePolicy::Ignored || widget.property("elides").toBool();
}

QString cutLabel(const QLabel& label) {
  if (label.text().isEmpty() || cutsOnPurpose(label)) return {};
  const QSize given = label.contentsRect().size();
  if (label.wordWrap()) {
    const int wanted = label.heightForWidth(label.width());
    const bool too_long_a_word =
        label.fontMetrics().boundingRect(QRect(0, 0, given.width(), 10000), Qt::TextWordWrap, label.text()).width() >
        given.width() + kSlack;
    const bool rich = Qt::mightBeRichText(label.text());
    return wanted > label.height() + kSlack || (too_long_a_word && !rich) ? sizes({given.width(), wanted}, label.size())
                                                                          : QString();
  }
  const QSize wanted = label.sizeHint();
  // The line's leading may go; its letters may not.
  const bool low = label.height() + kSlack < label.fontMetrics().ascent();
  return wanted.width() > label.width() + kSlack || low ? sizes(wanted, label.size()) : QString();
}

QString cutControl(const QWidget& widget) {
  QSize wanted = widget.sizeHint();
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
    const int text = box->fontMetrics().horizontalAdvance(box->currentText());
    wanted.setWidth(text + 3 * box->fontMetrics().height() / 2);
  }
  // A frame that is thicker in focus costs no text.
  wanted.setHeight(widget.fontMetrics().height());
  return wanted.width() > widget.width() + kSlack || wanted.height() > widget.height() ? sizes(wanted, widget.size())
                                                                                       : QString();
}

QString cutTabs(const QTabBar& bar) {
  int wanted = 0;
  for (int i = 0; i < bar.count(); ++i) {
    wanted += bar.tabRect(i).width();
    const int text = bar.fontMetrics().horizontalAdvance(bar.tabText(i));
    if (text > bar.tabRect(i).width()) return QStringLiteral(" tab %1 is cut").arg(bar.tabText(i));
  }
  return wanted > bar.width() + kSlack ? sizes({wanted, bar.height()}, bar.size()) : QString();
}

QString cutHeader(const QHeaderView& header) {
  if (header.orientation() != Qt::Horizontal || header.model() == nullptr) return {};
  for (int i = 0; i < header.count(); ++i) {
    if (header.isSectionHidden(i)) continue;
    const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
    int wanted = 0;
    for (const QString& line : text.split(QLatin1Char('\n'))) {
      wanted = std::max(wanted, header.fontMetrics().horizontalAdvance(line));
    }
    if (wanted + kHeaderPadding > header.sectionSize(i))
      return QStringLiteral(" column %1 is cut").arg(text.simplified());
  }
  return {};
}

/// An axis's name stands about the middle of its axis, and what does not fit into the plot is not seen.
QString cutAxes(const QCustomPlot& plot) {
  for (const QCPAxisRect* rect : plot.axisRects()) {
    for (const QCPAxis* axis : rect->axes()) {
      if (!axis->visible() || axis->label().isEmpty()) continue;
      const bool level = axis->orientation() == Qt::Horizontal;
      const int middle = level ? rect->rect().center().x() : rect->rect().center().y();
      const int room = 2 * std::min(middle, (level ? plot.width() : plot.height()) - middle);
      const int wanted = QFontMetrics(axis->labelFont()).horizontalAdvance(axis->label());
      if (wanted > room + kSlack)
        return QStringLiteral(" axis %1 wants %2, has %3").arg(axis->label()).arg(wanted).arg(room);
    }
  }
  return {};
}

/// Inside every ancestor, up to the first that scrolls.
bool liesOutside(const QWidget& widget) {
  QRect place(QPoint(0, 0), widget.size());
  for (const QWidget* each = &widget; each->parentWidget() != nullptr && !each->isWindow();
       each = each->parentWidget()) {
    const QWidget* above = each->parentWidget();
    place.translate(each->pos());
    if (const auto* scroll = qobject_cast<const QAbstractScrollArea*>(above->parentWidget())) {
      // What can be scrolled to is not cut off; sideways many areas do not scroll.
      return scroll->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff && place.right() > above->width() + kSlack;
    }
    if (!above->rect().adjusted(-kSlack, -kSlack, kSlack, kSlack).contains(place)) return true;
  }
  return false;
}

void findOverlaps(const QWidget& parent, QStringList& out) {
  QList<const QWidget*> texts;
  for (const QObject* child : parent.children()) {
    const auto* widget = qobject_cast<const QWidget*>(child);
    if (widget != nullptr && widget->isVisible() && !widget->isWindow() && !textOf(*widget).isEmpty()) texts << widget;
  }
  for (qsizetype i = 0; i < texts.size(); ++i) {
    for (qsizetype j = i + 1; j < texts.size(); ++j) {
      const QRect both = texts[i]->geometry() & texts[j]->geometry();
      if (both.width() <= kSlack || both.height() <= kSlack) continue;
      out << nameOf(*texts[i], textOf(*texts[i])) + QStringLiteral(" lies over ") +
                 nameOf(*texts[j], textOf(*texts[j]));
    }
  }
}

}  // namespace

QStringList lookFaults(const QWidget& window) {
  QStringList out;
  findOverlaps(window, out);
  for (const QWidget* each : window.findChildren<QWidget*>()) {
    if (!each->isVisible() || each->visibleRegion().isEmpty()) continue;
    findOverlaps(*each, out);
    QString fault;
    if (const auto* label = qobject_cast<const QLabel*>(each)) fault = cutLabel(*label);
    const auto* button = qobject_cast<const QAbstractButton*>(each);
    if (button != nullptr && !button->text().isEmpty() && !cutsOnPurpose(*each)) fault = cutControl(*each);
    if (qobject_cast<const QComboBox*>(each) != nullptr && !cutsOnPurpose(*each)) fault = cutControl(*each);
    if (const auto* tabs = qobject_cast<const QTabBar*>(each)) fault = cutTabs(*tabs);
    const auto* slider = qobject_cast<const QSlider*>(each);
    if (slider != nullptr && slider->width() < kLeastSlider_px) fault = sizes({kLeastSlider_px, 0}, slider->size());
    const auto* table = dynamic_cast<const widgets::HeadingTable*>(each);
    if (table != nullptr && table->horizontalScrollBar()->isVisible()) fault = QStringLiteral(" scrolls sideways");
    if (table != nullptr && liesOutside(*table)) fault = QStringLiteral(" sticks out of what it stands in");
    const auto* scroll = qobject_cast<const QScrollArea*>(each);
    if (scroll != nullptr && scroll->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff &&
        scroll->widget() != nullptr && scroll->widget()->width() > scroll->viewport()->width() + kSlack) {
      fault = sizes(scroll->widget()->size(), scroll->viewport()->size());
    }
    if (const auto* header = qobject_cast<const QHeaderView*>(each)) fault = cutHeader(*header);
    if (const auto* plot = qobject_cast<const QCustomPlot*>(each)) fault = cutAxes(*plot);
    if (fault.isEmpty() && !textOf(*each).isEmpty() && liesOutside(*each)) {
      fault = QStringLiteral(" sticks out of what it stands in");
    }
    if (!fault.isEmpty()) out << nameOf(*each, textOf(*each)) + fault;
  }
  return out;
}

namespace {

struct PaintedText {
  QString text;
  QRectF place;  ///< of its ink
};

/// Draws nothing and remembers the texts.
class TextEngine : public QPaintEngine {
 public:
  TextEngine() : QPaintEngine(QPaintEngine::AllFeatures) {}
  bool begin(QPaintDevice*) override { return true; }
  bool end() override { return true; }
  void updateState(const QPaintEngineState&) override {}
  void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
  void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
  void drawTextItem(const QPointF& at, const QTextItem& item) override {
    if (item.text().trimmed().isEmpty()) return;
    const QRectF ink = QFontMetricsF(item.font()).tightBoundingRect(item.text()).translated(at);
    texts.push_back({item.text(), state->transform().mapRect(ink)});
  }
  [[nodiscard]] Type type() const override { return User; }
  std::vector<PaintedText> texts;
};

class TextDevice : public QPaintDevice {
 public:
  explicit TextDevice(QSize size) : size_(size) {}
  [[nodiscard]] QPaintEngine* paintEngine() const override { return &engine; }
  mutable TextEngine engine;

 protected:
  [[nodiscard]] int metric(PaintDeviceMetric metric) const override {
    constexpr int kDotsPerInch = 96;
    switch (metric) {
      case PdmWidth: return size_.width();
      case PdmHeight: return size_.height();
      case PdmDpiX:
      case PdmDpiY:
      case PdmPhysicalDpiX:
      case PdmPhysicalDpiY: return kDotsPerInch;
      case PdmDevicePixelRatio: return 1;
      case PdmDepth: return 32;
      default: return QPaintDevice::metric(metric);
    }
  }

 private:
  QSize size_;
};

std::vector<PaintedText> textsOf(QWidget& top) {
  std::vector<PaintedText> out;
  QList<QWidget*> widgets = top.findChildren<QWidget*>();
  widgets.prepend(&top);
  for (QWidget* each : widgets) {
    if (!each->isVisible() || each->visibleRegion().isEmpty()) continue;
    if (auto* plot = qobject_cast<QCustomPlot*>(each)) plot->setPlottingHint(QCP::phCacheLabels, false);
    TextDevice device(each->size());
    each->render(&device, QPoint(), QRegion(), QWidget::RenderFlags());
    for (const PaintedText& text : device.engine.texts) {
      const QRectF seen = text.place & QRectF(each->rect());
      if (seen.isEmpty()) continue;
      out.push_back({text.text, seen.translated(each->mapTo(&top, QPoint(0, 0)))});
    }
  }
  return out;
}

}  // namespace

QStringList paintedTexts(QWidget& widget) {
  QStringList out;
  for (const PaintedText& each : textsOf(widget)) out << each.text;
  return out;
}

QStringList textsOverEachOther(QWidget& widget) {
  const std::vector<PaintedText> texts = textsOf(widget);
  QStringList out;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t j = i + 1; j < texts.size(); ++j) {
      const QRectF both = texts[i].place & texts[j].place;
      if (both.width() <= kSlack || both.height() <= kSlack) continue;
      out << QStringLiteral("\"%1\" lies over \"%2\" at %3, %4")
                 .arg(texts[i].text, texts[j].text)
                 .arg(both.x())
                 .arg(both.y());
    }
  }
  return out;
}

QList<QWidget*> controlsOf(const QWidget& window) {
  QList<QWidget*> out;
  for (QWidget* each : window.findChildren<QWidget*>()) {
    if (!each->isVisible() || !each->isEnabled() || qobject_cast<QScrollBar*>(each) != nullptr) continue;
    const QObject* parent = each->parent();
    const bool part = qobject_cast<const QLineEdit*>(parent) != nullptr ||
                      qobject_cast<const QComboBox*>(parent) != nullptr ||
                      qobject_cast<const QAbstractSpinBox*>(parent) != nullptr ||
                      qobject_cast<const QAbstractItemView*>(parent) != nullptr ||
                      qobject_cast<const QTabBar*>(parent) != nullptr || qobject_cast<QHeaderView*>(each) != nullptr;
    if (part) continue;
    if (qobject_cast<QAbstractButton*>(each) != nullptr || qobject_cast<QLineEdit*>(each) != nullptr ||
        qobject_cast<QComboBox*>(each) != nullptr || qobject_cast<QAbstractSlider*>(each) != nullptr ||
        qobject_cast<QAbstractSpinBox*>(each) != nullptr || qobject_cast<QAbstractItemView*>(each) != nullptr ||
        qobject_cast<QPlainTextEdit*>(each) != nullptr || qobject_cast<QTabBar*>(each) != nullptr) {
      out << each;
    }
  }
  return out;
}

}  // namespace fyd::tests
