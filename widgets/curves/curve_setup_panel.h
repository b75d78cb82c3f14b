// Which curves are shown, between which values, how much time, and whether their times go together. A panel beside
// the curves: nothing in it is modal, and every change shows at once.
#pragma once

#include <QCheckBox>
#include <QLineEdit>
#include <QToolButton>
#include <QWidget>
#include <vector>

#include "widgets/curves/curve_stack.h"

namespace fyd::widgets {

class CurveSetupPanel : public QWidget {
  Q_OBJECT
 public:
  /// @param stack must outlive this
  explicit CurveSetupPanel(CurveStack* stack, QWidget* parent = nullptr);

  [[nodiscard]] QCheckBox* shownBox(std::size_t index) const { return rows_[index].shown; }
  [[nodiscard]] QLineEdit* lowerField(std::size_t index) const { return rows_[index].lower; }
  [[nodiscard]] QLineEdit* upperField(std::size_t index) const { return rows_[index].upper; }
  [[nodiscard]] QLineEdit* spanField() const { return span_; }
  [[nodiscard]] QCheckBox* linkBox() const { return link_; }
  /// What was wrong with the last entry; empty: nothing.
  [[nodiscard]] QString problem() const { return problem_->text(); }
  /// To be called when something was changed elsewhere, such as by a key.
  void refresh();

 signals:
  void closeAsked();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  struct Row {
    QCheckBox* shown = nullptr;
    QLineEdit* lower = nullptr;
    QLineEdit* upper = nullptr;
  };
  void build();
  void addRow(class QGridLayout* grid, std::size_t index);
  void takeRange(std::size_t index, QLineEdit* changed);
  void takeSpan();
  void refuse(QLineEdit* field, const QString& why);

  CurveStack* stack_ = nullptr;
  std::vector<Row> rows_;
  QLineEdit* span_ = nullptr;
  QCheckBox* link_ = nullptr;
  QLabel* problem_ = nullptr;
};

}  // namespace fyd::widgets
