#include "widgets/status/record_button.h"

#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr double kShort_min = 10.0;  // from here on the time that is left is a warning
constexpr double kLong_min = 119.0;

/// The two lines of the button.
QStringList recordingText(const QString& clock, const QString& bytes, double minutes_left) {
  const QString left = timeLeftText(minutes_left);
  return {RecordButton::tr("REC %1").arg(clock), left.isEmpty() ? bytes : bytes + QStringLiteral(" · ") + left};
}

QStringList failedText() { return RecordButton::tr("Recording failed\nPress to read why").split(QLatin1Char('\n')); }

}  // namespace

RecordButton::RecordButton(QWidget* parent) : QPushButton(parent) {
  setObjectName(QStringLiteral("record_button"));
  setAutoDefault(false);
  setFont(textFont(TextSize::small));
  setSize(Size::full);
  connect(&Look::instance(), &Look::changed, this, &RecordButton::refresh);
  refresh();
}

void RecordButton::setSize(Size size) {
  // As wide as its longest usual line, so that nothing moves while it counts.
  const QStringList usual = recordingText(clockText(359'999.0), bytesText(888'800'000), kLong_min);
  const QStringList failed = failedText();
  const QStringList lines = size == Size::full   ? usual + failed
                            : size == Size::line ? QStringList{usual[0]}
                                                 : QStringList();
  int width = 0;
  for (const QString& line : lines) {
    width = std::max(width, QFontMetrics(font()).horizontalAdvance(line));
  }
  setFixedWidth(width + 6 * kGrid);
  size_ = size;
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
  QColor colour = theme().text;
  if (view_.state == State::recording) {
    QStringList lines = recordingText(clockText(view_.seconds), bytesText(view_.bytes), view_.minutes_left);
    shape = QStringLiteral("recording");
    role = view_.minutes_left < kShort_min ? QStringLiteral("warning") : QStringLiteral("danger");
    colour = theme().danger;  // as on every recorder
    if (view_.lost > 0) {
      lines[1] = tr("%1 samples lost").arg(view_.lost);
      shape = QStringLiteral("warning");
      role = QStringLiteral("danger");
    }
    text = lines.join(QLatin1Char('\n'));
  } else if (view_.state == State::failed) {
    text = failedText().join(QLatin1Char('\n'));
    shape = QStringLiteral("warning");
    role = QStringLiteral("danger");
    colour = theme().danger;
  }
  setIcon(widgets::icon(shape, colour));
  if (property("role").toString() != role) {
    setProperty("role", role);
    restyle(*this);
  }
  const QString shown = size_ == Size::full   ? text
                        : size_ == Size::line ? text.section(QLatin1Char('\n'), 0, 0)
                                              : QString();
  if (this->text() == shown && accessible_ == text) return;
  accessible_ = text;
  setText(shown);
  setAccessibleName(QString(text).replace(QLatin1Char('\n'), QStringLiteral(", ")));
  setToolTip(view_.file.isEmpty() ? tr("Record this session into a file (Ctrl+R)")
                                  : text + QLatin1Char('\n') + view_.file);
}

}  // namespace fyd::widgets
