// Named presets: save the present values under a name, load, rename, delete. It handles only
// names; the owner keeps the files.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>

namespace fyd::widgets {

class TuningPresetList : public QWidget {
  Q_OBJECT
 public:
  explicit TuningPresetList(QWidget* parent = nullptr);
  void setNames(const QStringList& names);
  /// Why an entry was refused; empty: it was accepted.
  void setProblem(const QString& why);

  [[nodiscard]] QListWidget* list() const { return list_; }
  [[nodiscard]] QLineEdit* nameField() const { return name_; }
  [[nodiscard]] QPushButton* saveButton() const { return save_; }
  [[nodiscard]] QPushButton* loadButton() const { return load_; }
  [[nodiscard]] QPushButton* renameButton() const { return rename_; }
  [[nodiscard]] QPushButton* removeButton() const { return remove_; }
  [[nodiscard]] QString words() const { return words_->text(); }

 signals:
  void saveAsked(const QString& name);
  void loadAsked(const QString& name);
  void renameAsked(const QString& from, const QString& to);
  void removeAsked(const QString& name);

 private:
  void refresh();
  [[nodiscard]] QString chosen() const;

  QLabel* words_ = nullptr;
  QListWidget* list_ = nullptr;
  QLineEdit* name_ = nullptr;
  QPushButton* save_ = nullptr;
  QPushButton* load_ = nullptr;
  QPushButton* rename_ = nullptr;
  QPushButton* remove_ = nullptr;
  QString problem_;
};

}  // namespace fyd::widgets
