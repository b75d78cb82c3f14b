// Whether the window may be closed: at once where nothing is under way, and otherwise after it said what would end, and
// was asked again. The question is a notice with two buttons, so nothing is modal while a device can move.
#pragma once

#include <QStringList>
#include <functional>

#include "widgets/status/notice_stack.h"

namespace fyd::console {

class Leaving {
 public:
  /// @param leave asks mayLeave anew, for more may have come to what the question named, and closes the window
  Leaving(widgets::NoticeStack& notices, std::function<void()> leave);
  /// @param unfinished what would end or be lost now, as phrases
  /// @return true when nothing would, or this was said before and nothing came to it since
  [[nodiscard]] bool mayLeave(const QStringList& unfinished);

  /// To be called now and then: takes the question away once nothing is left of what it names.
  void look(const std::function<QStringList()>& unfinished);

 private:
  void withdraw();

  widgets::NoticeStack& notices_;
  std::function<void()> leave_;
  QStringList said_;
};

}  // namespace fyd::console
