#include "widgets/curves/plot_style.h"

#include <qcustomplot.h>

#include "widgets/basics/theme.h"

namespace fyd::widgets {

void styleAxes(const QList<QCPAxis*>& axes) {
  const Theme& t = theme();
  for (QCPAxis* axis : axes) {
    axis->setSubTicks(false);
    axis->setTickLengthIn(0);
    axis->setBasePen(Qt::NoPen);
    axis->setTickPen(Qt::NoPen);
    axis->setTickLabelColor(t.muted);
    axis->setTickLabelFont(textFont(TextSize::small));
    axis->setLabelColor(t.muted);
    axis->setLabelFont(textFont(TextSize::small));
    axis->grid()->setPen(QPen(t.line, 1));
    axis->grid()->setZeroLinePen(QPen(t.line, 1));
  }
}

}  // namespace fyd::widgets
