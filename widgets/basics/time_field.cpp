#include "widgets/basics/time_field.h"

#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr double kRounded_s = 0.000501;  // the ends are named in milliseconds: what is named must be taken

}  // namespace

TimeField::TimeField(QWidget* parent) : QLineEdit(parent) {
  setObjectName(QStringLiteral("time_field"));
  setAccessibleName(tr("Go to a time of the session"));
  setPlaceholderText(tr("go to, s"));
  setFixedWidth(10 * kGrid);
  setMaxLength(20);
  say({});
  connect(this, &QLineEdit::returnPressed, this, &TimeField::take);
  connect(this, &QLineEdit::textEdited, this, [this] { say({}); });
}

void TimeField::say(const QString& problem) {
  problem_ = problem;
  setProperty("refused", problem.isEmpty() ? "" : "true");
  restyle(*this);
  setAccessibleDescription(problem);
  setToolTip(problem.isEmpty() ? tr("Session time in seconds, 83.5, or minutes and seconds, 1:23.5; then Enter (J)")
                               : problem);
  if (problem.isEmpty()) {
    QToolTip::hideText();
  } else {
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), problem, this);
  }
}

void TimeField::take() {
  const double time_s = readTime_s(text());
  const auto [first_s, last_s] = span_ ? span_() : std::pair(std::nan(""), std::nan(""));
  if (!std::isfinite(time_s)) {
    say(tr("'%1' is no time; expected seconds, such as 83.5, or minutes and seconds, such as 1:23.5.").arg(text()));
  } else if (!std::isfinite(first_s) || !std::isfinite(last_s)) {
    say(tr("There are no values yet to go to."));
  } else if (time_s < first_s - kRounded_s || time_s > last_s + kRounded_s) {
    say(tr("%1 s: there are values from %2 s to %3 s.")
            .arg(plainNumber(time_s), numberText(first_s, 3), numberText(last_s, 3)));
  } else {
    clear();
    say({});
    clearFocus();  // the keys belong to the curves again
    emit asked(std::clamp(time_s, first_s, last_s));
  }
  if (!problem_.isEmpty()) selectAll();
}

}  // namespace fyd::widgets
