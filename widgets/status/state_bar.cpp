#include "widgets/status/state_bar.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/basics/icon.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"
#include "widgets/status/state_text.h"

namespace fyd::widgets {
namespace {

constexpr int kShape = 40;
constexpr int kButtonHeight = 48;

QPixmap shapePixmap(const QString& name, const QColor& colour, double ratio) {
  QPixmap pixmap(QSize(kShape, kShape) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paintIcon(painter, QRectF(0, 0, kShape, kShape), name, colour);
  return pixmap;
}

}  // namespace

StateBar::StateBar(QWidget* parent)
    : QFrame(parent),
      shape_(new QLabel(this)),
      word_(new QLabel(this)),
      since_label_(new QLabel(this)),
      why_(new QLabel(this)),
      parts_(new PartList(this)),
      record_(new RecordButton(this)),
      tare_(new QPushButton(tr("Tare"), this)),
      arm_(new HoldButton(tr("Hold to arm"), this)),
      stop_(new QPushButton(tr(" STOP   Esc"), this)) {
  setProperty("surface", "panel");
  setAccessibleName(tr("State"));
  word_->setObjectName(QStringLiteral("state_word"));
  word_->setFont(textFont(TextSize::title, true));
  since_label_->setProperty("role", "muted");
  why_->setObjectName(QStringLiteral("state_reason"));
  why_->setWordWrap(true);
  why_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  shape_->setFixedSize(kShape, kShape);

  tare_->setObjectName(QStringLiteral("tare_button"));
  tare_->setToolTip(
      tr("Take the present readings as \"not touched\": distance offsets and load-cell zero. "
         "Lift the finger first (Ctrl+T)."));
  tare_->setAutoDefault(false);
  arm_->setObjectName(QStringLiteral("arm_button"));
  arm_->setToolTip(tr("Hold for 0.6 s, by mouse or with the space bar, to start rendering: the motors switch on."));
  stop_->setObjectName(QStringLiteral("stop_button"));
  stop_->setFont(textFont(TextSize::title, true));
  stop_->setAccessibleName(tr("Stop"));
  stop_->setToolTip(tr("Motors off at once (Esc, from everywhere)"));
  stop_->setAutoDefault(false);
  for (QPushButton* button : {static_cast<QPushButton*>(record_), tare_, static_cast<QPushButton*>(arm_), stop_}) {
    button->setFixedHeight(kButtonHeight);
    button->setIconSize({20, 20});
  }
  // Wide enough for its longer text, so that nothing moves when the state changes.
  arm_->setMinimumWidth(QFontMetrics(textFont(TextSize::normal, true)).horizontalAdvance(tr("Hold to re-arm")) + 64);
  arm_->setFont(textFont(TextSize::normal, true));

  auto* top = new QHBoxLayout;
  top->setSpacing(kGrid);
  top->addStrut(kButtonHeight);  // the style sheet removes the buttons' minimum height
  top->addWidget(shape_);
  top->addWidget(word_);
  top->addWidget(since_label_, 1);
  top->addWidget(record_);
  top->addWidget(tare_);
  top->addWidget(arm_);
  top->addWidget(stop_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, kGrid, kGrid, kGrid / 2);
  layout->setSpacing(kGrid / 2);
  layout->addLayout(top);
  layout->addWidget(why_);  // across the bar: beside the buttons of a narrow window it would be a tall column
  layout->addWidget(parts_);

  connect(stop_, &QPushButton::pressed, this, &StateBar::stopAsked);  // at once, when the button goes down
  connect(arm_, &HoldButton::held, this, &StateBar::armAsked);
  connect(tare_, &QPushButton::clicked, this, &StateBar::tareAsked);
  connect(&Look::instance(), &Look::changed, this, &StateBar::refresh);
  connect(&since_timer_, &QTimer::timeout, this, &StateBar::refreshSince);
  since_timer_.start(500);
  since_.start();
  refresh();
}

void StateBar::showState(pipeline::SafetyState state, pipeline::Fault fault) {
  if (known_ && state == state_ && fault == fault_) return;
  if (!known_ || state != state_) since_.start();
  known_ = true;
  state_ = state;
  fault_ = fault;
  refresh();
}

void StateBar::showSilence(bool silent) {
  if (silent == silent_) return;
  silent_ = silent;
  refresh();
}

void StateBar::refresh() {
  StateWords words = describeState(state_, fault_);
  QColor colour = stateColour(state_);
  if (!known_) {
    words = {tr("Starting"), tr("Waiting for the haptic loop."), {}, QStringLiteral("state-disconnected")};
    colour = theme().muted;
  } else if (silent_) {
    words = {tr("Unknown"), tr("The haptic loop says nothing; the last state was %1.").arg(words.word),
             tr("Press Esc, then restart the program."), QStringLiteral("state-held")};
    colour = theme().warning;
  }
  word_->setText(words.word);
  word_->setStyleSheet(QStringLiteral("color: %1;").arg(colour.name()));
  why_->setText(words.why + QLatin1Char(' ') + words.to_do);
  shape_->setPixmap(shapePixmap(words.icon, colour, devicePixelRatioF()));
  arm_->setText(armText(state_));
  arm_->setIcon(icon(QStringLiteral("arm")));
  arm_->setEnabled(known_ && !silent_ && state_ != pipeline::SafetyState::active);
  tare_->setIcon(icon(QStringLiteral("tare")));
  stop_->setIcon(icon(QStringLiteral("stop"), theme().on_danger));
  setAccessibleDescription(words.word + QStringLiteral(". ") + why_->text());
  refreshSince();
}

void StateBar::refreshSince() {
  since_label_->setText(tr("for %1").arg(durationText(static_cast<double>(since_.elapsed()) / 1000.0)));
}

}  // namespace fyd::widgets
