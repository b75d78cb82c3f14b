// A frameless area that scrolls vertically only; its contents are as wide as it is.
#pragma once

#include <QScrollArea>

namespace fyd::widgets {

/// The focus goes to the controls in it, not to the area.
[[nodiscard]] inline QScrollArea* makeVerticalScroll(QWidget* parent) {
  auto* scroll = new QScrollArea(parent);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  return scroll;
}

}  // namespace fyd::widgets
