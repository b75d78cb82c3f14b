#include "app/console/window/leaving.h"

#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

const QString kCause = QStringLiteral("leaving");

using widgets::tr;

}  // namespace

Leaving::Leaving(widgets::NoticeStack& notices, std::function<void()> leave)
    : notices_(notices), leave_(std::move(leave)) {}

bool Leaving::mayLeave(const QStringList& unfinished) {
  // A question that was answered by reading it away is asked anew.
  const bool asked = notices_.shows(kCause) && said_ == unfinished;
  if (unfinished.isEmpty() || asked) return true;
  withdraw();
  said_ = unfinished;
  notices_.post(
      {.severity = widgets::Severity::warning,
       .text = tr("Quit? Now: %1. Quitting stops the motors and closes the recording; what is not finished is "
                  "lost. Ctrl+Q again quits.")
                   .arg(unfinished.join(QStringLiteral("; "))),
       .cause = kCause,
       .actions = {{QStringLiteral("quit_now"), tr("Quit"), leave_},
                   {QStringLiteral("quit_not"), tr("Stay"), [this] { withdraw(); }}}});
  return false;
}

void Leaving::look(const std::function<QStringList()>& unfinished) {
  if (notices_.shows(kCause) && unfinished().isEmpty()) withdraw();
}

void Leaving::withdraw() { notices_.withdraw(kCause); }

}  // namespace fyd::console
