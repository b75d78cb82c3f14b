// Live tuning of stiffness and texture: source of the stiffness target, gains, vibration.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QRadioButton>
#include <QToolButton>
#include <vector>

#include "widgets/tuning/tuning_foot.h"
#include "widgets/tuning/tuning_model.h"
#include "widgets/tuning/tuning_row.h"

namespace fyd::widgets {

struct TuningSection {
  struct Row {
    QString id;
    QString label;  ///< empty: the parameter's own name
  };
  QString title;
  Quantity quantity = Quantity::none;
  std::vector<Row> rows;  ///< ids the model does not have are left out
};

class TuningPanel : public QFrame {
  Q_OBJECT
 public:
  /// @param target_id the parameter that holds the target while it is set by hand
  TuningPanel(TuningModel& model, const std::vector<TuningSection>& sections, const QString& target_id,
              QWidget* parent = nullptr);

  void showTargetByHand(bool by_hand);
  [[nodiscard]] bool targetByHand() const { return by_hand_->isChecked(); }
  [[nodiscard]] TuningRow* row(const QString& id) const;
  [[nodiscard]] const std::vector<TuningRow*>& rows() const { return rows_; }
  [[nodiscard]] QPushButton* saveButton() const { return foot_->saveButton(); }
  /// Presets are files, so the owner provides their menu. Without one there is no button.
  void setPresetMenu(QMenu* menu);
  [[nodiscard]] QToolButton* presetButton() const { return preset_; }
  [[nodiscard]] TuningFoot* foot() const { return foot_; }
  [[nodiscard]] TuningCompare* compare() const { return foot_->compare(); }
  [[nodiscard]] QRadioButton* byHandButton() const { return by_hand_; }
  [[nodiscard]] QRadioButton* fromRobotButton() const { return from_robot_; }

 signals:
  void targetByHandAsked();
  void targetFromRobotAsked();
  void saveAsked();
  void refused(const QString& why, const QString& parameter);
  void entered();  ///< Enter ended an entry: the focus is free to go

 private:
  void addSection(class QVBoxLayout* layout, const TuningSection& section, const QString& target_id);
  QWidget* buildTargetChoice();

  TuningModel& model_;
  std::vector<TuningRow*> rows_;
  QRadioButton* from_robot_ = nullptr;
  QRadioButton* by_hand_ = nullptr;
  QToolButton* preset_ = nullptr;
  TuningFoot* foot_ = nullptr;
};

}  // namespace fyd::widgets
