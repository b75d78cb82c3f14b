// Ctrl+K: type a few letters of a command, Enter runs it.
#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>

#include "app/console/shell/command_registry.h"

namespace fyd::console {

class CommandPalette : public QDialog {
  Q_OBJECT
 public:
  CommandPalette(const CommandRegistry& registry, QWidget* window);
  void open() override;
  [[nodiscard]] QLineEdit* field() const { return field_; }
  [[nodiscard]] QListWidget* list() const { return list_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// The focus goes back to where it was.
  void hideEvent(QHideEvent* event) override;

 private:
  void filter(const QString& letters);
  void run();
  const CommandRegistry& registry_;
  QLineEdit* field_ = nullptr;
  QListWidget* list_ = nullptr;
  QPointer<QWidget> former_focus_;
};

}  // namespace fyd::console
