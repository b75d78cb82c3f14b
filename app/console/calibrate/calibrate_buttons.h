// The row of buttons below the place "Calibrate".
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QString>

#include "widgets/basics/hold_button.h"

namespace fyd::console {

class CalibrationButtons : public QFrame {
  Q_OBJECT
 public:
  explicit CalibrationButtons(QWidget* parent);

  /// What the buttons may do now.
  struct Allowed {
    bool moves = false;     ///< the part's points are taken while motors move
    bool may_move = false;  ///< nothing renders, and the station answers
    QString why_still;      ///< why motors cannot be moved now; empty: they can, or nothing is known
    bool has_points = false;
    bool taking = false;      ///< a point is being averaged
    bool acceptable = false;  ///< the fit's verdict
  };
  void allow(const Allowed& allowed);

  [[nodiscard]] QPushButton* take() const { return take_; }
  [[nodiscard]] QPushButton* back() const { return back_; }
  [[nodiscard]] QPushButton* simulate() const { return simulate_; }
  [[nodiscard]] QPushButton* discard() const { return discard_; }
  [[nodiscard]] QPushButton* accept() const { return accept_; }
  [[nodiscard]] QPushButton* report() const { return report_; }
  [[nodiscard]] widgets::HoldButton* moveButton() const { return move_; }

 private:
  QPushButton* add(const char* name, const QString& text, const QString& tip);

  QLabel* why_still_ = nullptr;
  QPushButton* back_ = nullptr;
  QPushButton* take_ = nullptr;
  widgets::HoldButton* move_ = nullptr;
  QPushButton* simulate_ = nullptr;
  QPushButton* report_ = nullptr;
  QPushButton* discard_ = nullptr;
  QPushButton* accept_ = nullptr;
};

}  // namespace fyd::console
