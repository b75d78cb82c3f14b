#include "widgets/status/record_button.h"

#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr double kShort_min = 10.0;  // from here on the time that is left is a warning

}  // namespace

RecordButton::RecordButton(QWidget* parent) : QPushButton(parent) {
  setObjectName(QStringLiteral("record_button"));
  setAutoDefault(false);
  setFont(textFont(TextSize::small));
  // Wide enough for its longest usual text, so that nothing moves while it counts.
  setMinimumWidth(QFontMetrics(font()).horizontalAdvance(QStringLiteral("888.8 MB · 888 min left")) + 7 * kGrid);
  connect(&Look::instance(), &Look::changed, this, &RecordButton::refresh);
  refresh();
}

void RecordButton::setRecording(const RecordingView& view) {
  view_ = view;
  refresh();
}

void RecordButton::refresh() {
  using State = RecordingView::State;
  QString text = tr("Record");
  QString shape = QStringLiteral("record");
  QString role;
  if (view_.state == State::recording) {
    const QString left = timeLeftText(view_.minutes_left);
    QString second = bytesText(view_.bytes);
    if (!left.isEmpty()) second += QStringLiteral(" · ") + left;
    shape = QStringLiteral("recording");
    if (view_.lost > 0) {
      second = tr("%1 samples lost").arg(view_.lost);
      role = QStringLiteral("danger");
    } else if (view_.minutes_left < kShort_min) {
      role = QStringLiteral("warning");
    }
    text = tr("REC %1\n%2").arg(clockText(view_.seconds), second);
  } else if (view_.state == State::failed) {
    text = tr("Recording failed\nPress to read why");
    shape = QStringLiteral("warning");
    role = QStringLiteral("danger");
  }
  const QColor colour = role == QLatin1String("danger")    ? theme().danger
                        : role == QLatin1String("warning") ? theme().warning
                                                           : theme().text;
  setIcon(widgets::icon(shape, colour));
  if (property("role").toString() != role) {
    setProperty("role", role);
    restyle(*this);
  }
  if (this->text() == text) return;
  setText(text);
  QString name = text;
  setAccessibleName(name.replace(QLatin1Char('\n'), QStringLiteral(", ")));
  setToolTip(view_.file.isEmpty() ? tr("Record this session into a file (Ctrl+R)") : view_.file);
}

}  // namespace fyd::widgets
