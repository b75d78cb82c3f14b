// Shows every text as it is written. A label or a tool tip takes a text with a < in it for HTML, and texts come from
// recordings, files and other computers: names of operators, notes, paths. No text of this window needs markup.
#pragma once

#include <QObject>

namespace fyd::console {

class PlainTexts : public QObject {
 public:
  /// Watches the whole application for as long as it lives.
  PlainTexts();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace fyd::console
