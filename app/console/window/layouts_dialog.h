// Named layouts of the panels with the choice of curves: save the present one under a name, go back to one, delete one.
// Never modal.
#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <functional>

#include "app/console/window/window_memory.h"

namespace fyd::console {

class LayoutsDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param present returns the present layout
  LayoutsDialog(WindowMemory& memory, std::function<Layout()> present, QWidget* window);
  void open() override;
  [[nodiscard]] QLineEdit* field() const { return field_; }
  [[nodiscard]] QListWidget* list() const { return list_; }
  [[nodiscard]] QPushButton* saveButton() const { return save_; }
  [[nodiscard]] QPushButton* useButton() const { return use_; }
  [[nodiscard]] QPushButton* deleteButton() const { return delete_; }
  [[nodiscard]] QPushButton* standardButton() const { return standard_; }
  [[nodiscard]] QString words() const { return words_->text(); }

 signals:
  void chosen(const fyd::console::Layout& layout);
  void standardAsked();

 private:
  void build();
  void refresh();
  void save();
  void use();
  void remove();

  WindowMemory& memory_;
  std::function<Layout()> present_;
  QLineEdit* field_ = nullptr;
  QListWidget* list_ = nullptr;
  QPushButton* save_ = nullptr;
  QPushButton* use_ = nullptr;
  QPushButton* delete_ = nullptr;
  QPushButton* standard_ = nullptr;
  QLabel* words_ = nullptr;
};

}  // namespace fyd::console
