// A text out of which nothing is dragged.
#pragma once

#include <QMouseEvent>
#include <QTextCursor>

namespace fyd::widgets {

/// A QPlainTextEdit or QTextEdit of which a press on selected text begins a new selection, not a drag: Qt 6.4's
/// scrolling by itself outside of it begins the drag again and again, and a drag takes every key and click.
template <typename TextEdit>
class Undragged : public TextEdit {
 public:
  using TextEdit::TextEdit;

 protected:
  void mousePressEvent(QMouseEvent* press) override {
    const bool extends = press->modifiers() == Qt::ShiftModifier;
    if (press->button() == Qt::LeftButton && !extends && this->textCursor().hasSelection()) {
      this->setTextCursor(this->cursorForPosition(press->position().toPoint()));
    }
    TextEdit::mousePressEvent(press);
  }
};

}  // namespace fyd::widgets
