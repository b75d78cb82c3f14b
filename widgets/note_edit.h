// A field for notes of several lines.
#pragma once

#include <QMimeData>
#include <QPlainTextEdit>

namespace fyd::widgets {

/// Takes text only. Qt 6.4 ends the program when something without any text is pasted into a QPlainTextEdit: a click
/// with the middle button on a desktop where nothing was ever selected is enough.
class NoteEdit : public QPlainTextEdit {
 public:
  using QPlainTextEdit::QPlainTextEdit;

 protected:
  bool canInsertFromMimeData(const QMimeData* source) const override { return source != nullptr && source->hasText(); }
  void insertFromMimeData(const QMimeData* source) override {
    if (canInsertFromMimeData(source)) QPlainTextEdit::insertFromMimeData(source);
  }
};

}  // namespace fyd::widgets
