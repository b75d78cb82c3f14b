// The manual in a panel, in the window's language: pages with links, back and contents, and a search through all
// of them. Never modal.
#pragma once

#include <QLineEdit>
#include <QListWidget>
#include <QStringList>
#include <QTextBrowser>
#include <QToolButton>

#include "app/console/shell/side_dock.h"

namespace fyd::console {

class HelpDock : public SideDock {
  Q_OBJECT
 public:
  explicit HelpDock(QWidget* parent = nullptr);
  /// Opens the panel at a topic. @param topic "operate.md#curves"
  void showTopic(const QString& topic);
  [[nodiscard]] const QString& topic() const { return topic_; }
  [[nodiscard]] QTextBrowser* page() const { return page_; }
  [[nodiscard]] QLineEdit* field() const { return field_; }
  [[nodiscard]] QListWidget* found() const { return found_; }
  [[nodiscard]] QToolButton* backButton() const { return back_; }

 private:
  HelpDock(QWidget* body, QWidget* parent);
  void build(QWidget& body);
  void follow(const QUrl& link);
  void load(const QString& topic);
  void search(const QString& words);
  void goToFound(const QListWidgetItem* item);
  /// @param heading its number on the page, from 0; an invalid one leaves the page as it is
  void scrollTo(int heading);

  QTextBrowser* page_ = nullptr;
  QLineEdit* field_ = nullptr;
  QListWidget* found_ = nullptr;
  QToolButton* back_ = nullptr;
  QString topic_;
  QStringList former_;
};

}  // namespace fyd::console
