// A second recording beside the one in review: named by its path, drawn behind, one touch laid on another.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QWidget>
#include <memory>
#include <vector>

#include "app/console/touch_search.h"

namespace fyd::console {

class ReviewComparison : public QWidget {
  Q_OBJECT
 public:
  explicit ReviewComparison(widgets::WorkBars* bars, QWidget* parent = nullptr);

  /// Nothing beside it any more; its own touches are not known yet.
  void clear();
  /// Those of the session in review.
  void setTouches(const std::vector<session::Touch>& touches);
  void compare(const QString& path);
  /// The other one's touch `theirs` stands where the session's `ours` stands, both from 0; -1: its start.
  void alignAt(int ours, int theirs);

 signals:
  /// @param recording nullptr: none; lives until this is sent again
  /// @param later_by_s its second 0 stands at this second of the session
  void otherChanged(const fyd::session::Recording* recording, double later_by_s);

 private:
  void build();
  void fillChoices();

  std::unique_ptr<session::Recording> other_;
  std::vector<session::Touch> touches_;
  std::vector<session::Touch> other_touches_;
  QLineEdit* path_;
  QComboBox* our_touch_;
  QComboBox* their_touch_;
  QLabel* words_;
  TouchSearch search_;
};

}  // namespace fyd::console
