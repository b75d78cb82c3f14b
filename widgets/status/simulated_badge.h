// Says all the time that the touchpad, or a part of the set-up, is simulated: a hatched sign with the word, and which
// parts are meant.
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/status/part_list.h"

namespace fyd::widgets {

class SimulatedBadge : public QWidget {
  Q_OBJECT
 public:
  explicit SimulatedBadge(QWidget* parent = nullptr);
  /// Hidden where no part is simulated.
  void setParts(const std::vector<PartView>& parts);
  /// Which parts: "all parts", or their names; empty: none.
  [[nodiscard]] QString which() const { return which_; }
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QString words() const;
  QString which_;
};

}  // namespace fyd::widgets
