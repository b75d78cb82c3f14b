// A second recording to compare with the one in review: chosen by its path, drawn behind it, aligned at a touch.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QWidget>
#include <memory>
#include <vector>

#include "app/console/review/touch_search.h"

namespace fyd::console {

class ReviewComparison : public QWidget {
  Q_OBJECT
 public:
  explicit ReviewComparison(widgets::ProgressBars* bars, QWidget* parent = nullptr);

  /// Removes the second recording, and the touches of the reviewed one.
  void clear();
  /// The touches of the reviewed session.
  void setTouches(const std::vector<exports::Touch>& touches);
  void compare(const QString& path);
  /// Aligns the other's touch `theirs` with the session's touch `ours`, both from 0; -1: the start.
  void alignAt(int ours, int theirs);
  [[nodiscard]] QString words() const { return words_->text(); }

 signals:
  /// @param recording nullptr: none; valid until the next emission
  /// @param later_by_s session time, s, of the other recording's time 0
  void otherChanged(const recording::Recording* recording, double later_by_s);

 private:
  void build();
  void fillChoices();

  std::unique_ptr<recording::Recording> other_;
  std::vector<exports::Touch> touches_;
  std::vector<exports::Touch> other_touches_;
  QLineEdit* path_ = nullptr;
  QPushButton* choose_ = nullptr;
  QComboBox* our_touch_ = nullptr;
  QComboBox* their_touch_ = nullptr;
  QLabel* words_ = nullptr;
  TouchSearch search_;
};

}  // namespace fyd::console
