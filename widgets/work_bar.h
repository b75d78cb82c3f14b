// Long work as a slim bar: what is being done, which share of it, how long it will take yet, and Cancel. Nothing is
// shown while nothing runs, nor for work that is over in a moment.
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QWidget>
#include <vector>

namespace fyd::widgets {

class WorkBar : public QWidget {
  Q_OBJECT
 public:
  explicit WorkBar(QWidget* parent = nullptr);

  void begin(const QString& words);
  /// @param share 0 to 1
  void setDone(double share);
  /// "25 % · 3 min left"; no time is said while there is too little to go by.
  [[nodiscard]] static QString shareText(int percent, double elapsed_s);
  void end();
  [[nodiscard]] bool running() const { return running_; }
  /// Counts every beginning of any bar: what began later has a larger one.
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] QString words() const { return words_->text(); }
  [[nodiscard]] QProgressBar* progress() const { return progress_; }
  [[nodiscard]] QPushButton* cancelButton() const { return cancel_; }

 public slots:
  /// Asks once; the bar stays until the work has ended.
  void cancel();

 signals:
  void cancelAsked();
  void shownChanged();

 private:
  void describe(const QString& words);

  QLabel* words_;
  QProgressBar* progress_;
  QLabel* share_;
  QPushButton* cancel_;
  QTimer patience_;
  QElapsedTimer since_;
  bool running_ = false;
  bool asked_ = false;
  int number_ = 0;
};

/// Bars below one another, the newest last.
class WorkBars : public QWidget {
  Q_OBJECT
 public:
  /// @param keys that cancel the newest, for its tool tip
  explicit WorkBars(QString keys, QWidget* parent = nullptr);
  /// One for work of its own; hidden until it begins. Whoever asked for it deletes it once it has ended, or this does.
  [[nodiscard]] WorkBar* add();
  /// @return whether anything ran
  bool cancelNewest();
  /// In the order they began.
  [[nodiscard]] std::vector<WorkBar*> running() const;

 private:
  void showIfNeeded();

  QString keys_;
};

}  // namespace fyd::widgets
