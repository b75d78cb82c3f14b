// Progress bar of long work: what is being done, which share of it, the time left, and Cancel. Hidden while nothing
// runs, and for work that ends within a moment.
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QWidget>
#include <vector>

namespace fyd::widgets {

class ProgressBar : public QWidget {
  Q_OBJECT
 public:
  explicit ProgressBar(QWidget* parent = nullptr);

  void begin(const QString& words);
  /// @param share 0 to 1
  void setDone(double share);
  /// "25 % · 3 min left"; without the time while it cannot be estimated yet.
  [[nodiscard]] static QString shareText(int percent, double elapsed_s);
  void end();
  [[nodiscard]] bool running() const { return running_; }
  /// Sequence number of the last `begin` over all bars: work that began later has a larger one.
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] QString words() const { return words_->text(); }
  [[nodiscard]] QProgressBar* progress() const { return progress_; }
  [[nodiscard]] QPushButton* cancelButton() const { return cancel_; }

 public slots:
  /// Emits cancelAsked once; the bar stays until the work has ended.
  void cancel();

 signals:
  void cancelAsked();
  void shownChanged();

 private:
  void describe(const QString& words);

  QLabel* words_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* share_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QTimer patience_;
  QElapsedTimer since_;
  bool running_ = false;
  bool asked_ = false;
  int number_ = 0;
};

/// Progress bars below one another, the newest last.
class ProgressBars : public QWidget {
  Q_OBJECT
 public:
  /// @param keys that cancel the newest, for its tool tip
  explicit ProgressBars(QString keys, QWidget* parent = nullptr);
  /// A bar for one piece of work; hidden until it begins. The caller deletes it once it has ended, or this widget does.
  [[nodiscard]] ProgressBar* add();
  /// @return whether anything ran
  bool cancelNewest();
  /// In the order they began.
  [[nodiscard]] std::vector<ProgressBar*> running() const;

 private:
  void showIfNeeded();

  QString keys_;
};

}  // namespace fyd::widgets
