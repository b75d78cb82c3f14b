#include "widgets/basics/navigation_bar.h"

#include <algorithm>

#include "widgets/basics/theme.h"

namespace fyd::widgets {

NavigationBar::NavigationBar(QWidget* parent) : QFrame(parent), layout_(new QVBoxLayout(this)) {
  setObjectName(QStringLiteral("navigation"));
  setAccessibleName(tr("Places"));
  layout_->setContentsMargins(kGrid / 2, 0, 0, 0);
  layout_->setSpacing(kGrid / 2);
  layout_->addStretch(1);
}

QToolButton* NavigationBar::add(QAction* place) {
  auto* button = new QToolButton(this);
  button->setDefaultAction(place);
  button->setObjectName(QStringLiteral("navigation_") + place->objectName());
  button->setProperty("navigation", true);
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setIconSize({3 * kGrid, 3 * kGrid});
  button->setFont(textFont(TextSize::small));
  // As wide as the longest word of the language, and all alike.
  const int words = QFontMetrics(button->font()).horizontalAdvance(place->text()) + 2 * kGrid;
  width_ = std::max({width_, 8 * kGrid, (words + kGrid - 1) / kGrid * kGrid});
  button->setFixedHeight(7 * kGrid);
  for (QToolButton* each : findChildren<QToolButton*>()) each->setFixedWidth(width_);
  button->setFocusPolicy(Qt::StrongFocus);
  button->setAccessibleName(place->text());
  const QString keys = place->shortcut().toString(QKeySequence::NativeText);
  place->setToolTip(keys.isEmpty() ? place->text() : tr("%1 (%2)").arg(place->text(), keys));
  layout_->insertWidget(layout_->count() - 1, button);
  return button;
}

}  // namespace fyd::widgets
