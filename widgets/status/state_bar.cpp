#include "widgets/status/state_bar.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QResizeEvent>
#include <QVBoxLayout>

#include "widgets/basics/icon.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

using pipeline::SafetyState;

constexpr int kShape = 40;
constexpr int kButtonHeight = 48;
constexpr int kIconAndMargins = 8 * kGrid;  // px, of a button beside its text
constexpr int kRoomy = 1100;                // px, from where on every reason fits on one line

QPixmap shapePixmap(const QString& name, const QColor& colour, double ratio) {
  QPixmap pixmap(QSize(kShape, kShape) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paintIcon(painter, QRectF(0, 0, kShape, kShape), name, colour);
  return pixmap;
}

int widest(const QFont& font, const QStringList& texts) {
  int out = 0;
  for (const QString& text : texts) out = std::max(out, QFontMetrics(font).horizontalAdvance(text));
  return out;
}

/// A long text divided at the space nearest to its middle.
QString onTwoLines(QString text) {
  constexpr qsizetype kLong = 16;
  if (text.size() <= kLong) return text;
  const qsizetype middle = text.size() / 2;
  const qsizetype before = text.lastIndexOf(QLatin1Char(' '), middle);
  const qsizetype after = text.indexOf(QLatin1Char(' '), middle);
  const bool first = after < 0 || (before >= 0 && middle - before <= after - middle);
  const qsizetype at = first ? before : after;
  if (at >= 0) text[at] = QLatin1Char('\n');
  return text;
}

/// Every word that may stand for the state.
QStringList stateWords() {
  QStringList out = {StateBar::tr("Starting"), StateBar::tr("Closed"), StateBar::tr("Unknown")};
  for (std::size_t i = 0; i < pipeline::kSafetyStateCount; ++i) {
    out << describeState(static_cast<SafetyState>(i), pipeline::Fault::none).word;
  }
  return out;
}

}  // namespace

StateBar::StateBar(QWidget* parent)
    : QFrame(parent),
      shape_(new QLabel(this)),
      word_(new QLabel(this)),
      since_label_(new QLabel(this)),
      why_(new QLabel(this)),
      badge_(new SimulatedBadge(this)),
      parts_(new PartList(this)),
      record_(new RecordButton(this)),
      tare_(new QPushButton(this)),
      arm_(new HoldButton(tr("Hold to arm"), this)),
      stop_(new QPushButton(tr(" STOP   Esc"), this)) {
  build();
  connect(stop_, &QPushButton::pressed, this, &StateBar::stopAsked);  // at once, when the button goes down
  connect(arm_, &HoldButton::held, this, &StateBar::armAsked);
  connect(tare_, &QPushButton::clicked, this, &StateBar::tareAsked);
  connect(&Look::instance(), &Look::changed, this, &StateBar::refresh);
  connect(&since_timer_, &QTimer::timeout, this, &StateBar::refreshSince);
  since_timer_.start(500);
  since_.start();
  refresh();
}

void StateBar::build() {
  setProperty("surface", "panel");
  setAccessibleName(tr("State"));
  word_->setObjectName(QStringLiteral("state_word"));
  word_->setFont(textFont(TextSize::title, true));
  since_label_->setFont(textFont(TextSize::small));
  since_label_->setProperty("role", "muted");
  why_->setObjectName(QStringLiteral("state_reason"));
  why_->setWordWrap(true);
  why_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  why_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  shape_->setFixedSize(kShape, kShape);

  tare_->setObjectName(QStringLiteral("tare_button"));
  tare_->setToolTip(
      tr("Take the present readings as \"not touched\": distance offsets and load-cell zero. "
         "Lift the finger first (Ctrl+T)."));
  tare_->setAccessibleName(tr("Tare"));
  tare_->setAutoDefault(false);
  arm_->setObjectName(QStringLiteral("arm_button"));
  arm_->setToolTip(tr("Hold for 0.6 s, by mouse or with the space bar, to start rendering: the motors switch on."));
  arm_->setFont(textFont(TextSize::normal, true));
  stop_->setObjectName(QStringLiteral("stop_button"));
  stop_->setFont(textFont(TextSize::title, true));
  stop_->setAccessibleName(tr("Stop"));
  stop_->setToolTip(tr("Motors off at once (Esc, from everywhere)"));
  stop_->setAutoDefault(false);
  for (QPushButton* button : {static_cast<QPushButton*>(record_), tare_, static_cast<QPushButton*>(arm_), stop_}) {
    button->setFixedHeight(kButtonHeight);
    button->setIconSize({20, 20});
  }
  // As wide as the longest text of each, so that nothing moves when the state changes.
  word_->setFixedWidth(widest(word_->font(), stateWords()));
  const QStringList arming = onTwoLines(armText(SafetyState::ready)).split(QLatin1Char('\n')) +
                             onTwoLines(armText(SafetyState::held)).split(QLatin1Char('\n'));
  arm_->setFixedWidth(widest(arm_->font(), arming) + kIconAndMargins);
  stop_->setFixedWidth(widest(stop_->font(), {stop_->text()}) + kIconAndMargins);

  auto* words = new QVBoxLayout;
  words->setSpacing(0);
  words->addWidget(word_);
  words->addWidget(since_label_);
  auto* top = new QHBoxLayout;
  top->setSpacing(kGrid);
  top->addStrut(kButtonHeight);  // the style sheet removes the buttons' minimum height
  top->addWidget(shape_);
  top->addLayout(words);
  top->addStretch(1);
  top->addWidget(record_);
  top->addWidget(tare_);
  top->addWidget(arm_);
  top->addWidget(stop_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, kGrid, kGrid, kGrid / 2);
  layout->setSpacing(kGrid / 2);
  layout->addLayout(top);
  auto* reason = new QHBoxLayout;  // across the bar: beside the buttons of a narrow window it would be a tall column
  reason->setSpacing(kGrid);
  reason->addWidget(badge_);
  reason->addWidget(why_, 1);
  layout->addLayout(reason);
  layout->addWidget(parts_);
  const auto needed = [this](Room room) {
    setRoom(room);
    this->layout()->update();  // what is hidden takes its room until then
    this->layout()->activate();
    return minimumSizeHint().width();
  };
  narrow_width_ = needed(Room::narrow);
  setMinimumWidth(needed(Room::tight));  // whatever it shows in a wide window
  setRoom(Room::plenty);
}

StateBar::Room StateBar::roomIn(int width) const {
  return width >= kRoomy ? Room::plenty : width >= narrow_width_ ? Room::narrow : Room::tight;
}

void StateBar::setRoom(Room room) {
  room_ = room;
  const bool narrow = room != Room::plenty;
  record_->setSize(room == Room::tight    ? RecordButton::Size::sign
                   : room == Room::narrow ? RecordButton::Size::line
                                          : RecordButton::Size::full);
  for (QWidget* each : {word_, since_label_}) each->setVisible(room != Room::tight);  // the word then leads the reason
  tare_->setText(narrow ? QString() : tr("Tare"));
  tare_->setFixedWidth(narrow ? kButtonHeight : widest(tare_->font(), {tr("Tare")}) + kIconAndMargins);
  // Room for a second line, so that a longer reason moves nothing below it.
  why_->setMinimumHeight((narrow ? 2 : 1) * QFontMetrics(why_->font()).lineSpacing());
}

void StateBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  const Room room = roomIn(event->size().width());
  if (event->oldSize().isValid() && room == room_) return;
  setRoom(room);
  refresh();
}

void StateBar::showMissing(const MissingNow& missing) {
  if (missing_ == missing) return;
  missing_ = missing;
  refresh();
}

void StateBar::showParts(const std::vector<PartView>& parts) {
  parts_->setParts(parts);
  badge_->setParts(parts);
}

void StateBar::showLateness(const QString& lateness) {
  if (lateness_ == lateness) return;
  lateness_ = lateness;
  refresh();
}

void StateBar::showMotion(const QString& motion) {
  if (motion_ == motion) return;
  motion_ = motion;
  refresh();
}

void StateBar::showState(pipeline::SafetyState state, pipeline::Fault fault) {
  if (known_ && state == state_ && fault == fault_) return;
  if (!known_ || state != state_) since_.start();
  missing_.reset();
  if (state != pipeline::SafetyState::held) lateness_.clear();
  known_ = true;
  state_ = state;
  fault_ = fault;
  refresh();
}

void StateBar::restart() {
  known_ = false;
  missing_.reset();
  lateness_.clear();
  since_.start();
  refresh();
}

void StateBar::showClosed(bool closed) {
  if (closed == closed_) return;
  closed_ = closed;
  restart();
}

void StateBar::showSilence(bool silent) {
  if (silent == silent_) return;
  silent_ = silent;
  silent_since_.start();
  refresh();
}

void StateBar::refresh() {
  StateWords words = describeState(state_, fault_, missing_, lateness_);
  QColor colour = stateColour(state_);
  if (closed_) {
    words = {tr("Closed"), tr("The session has no devices."), tr("Choose them under Devices."),
             QStringLiteral("state-disconnected")};
    colour = theme().muted;
  } else if (!known_) {
    words = {tr("Starting"), tr("Waiting for the haptic loop."), {}, QStringLiteral("state-disconnected")};
    colour = theme().muted;
  } else if (unknown()) {
    words = {tr("Unknown"), tr("The haptic loop says nothing; the last state was %1.").arg(words.word),
             tr("Press Esc, then restart the program."), QStringLiteral("state-held")};
    colour = theme().warning;
  } else if (!motion_.isEmpty()) {
    words.why = tr("A held button moves the motors: %1.").arg(motion_);
    words.to_do = tr("Letting go or Esc switches them off.");
  }
  word_->setText(words.word);
  word_->setStyleSheet(QStringLiteral("color: %1;").arg(colour.name()));
  const QString lead = room_ == Room::tight ? words.word + QStringLiteral(". ") : QString();
  reason_ = words.why + QLatin1Char(' ') + words.to_do;
  why_->setText(lead + reason_);
  shape_->setPixmap(shapePixmap(words.icon, colour, devicePixelRatioF()));
  arm_->setText(onTwoLines(armText(state_)));
  arm_->setAccessibleName(armText(state_));
  arm_->setIcon(icon(QStringLiteral("arm")));
  arm_->setEnabled(known_ && !closed_ && !silent_ && state_ != SafetyState::active);
  tare_->setIcon(icon(QStringLiteral("tare")));
  stop_->setIcon(icon(QStringLiteral("stop"), theme().on_danger));
  setAccessibleDescription(words.word + QStringLiteral(". ") + reason_);
  refreshSince();
}

void StateBar::refreshSince() {
  // The state's own time goes on behind a silence: where the loop speaks again, it may never have changed.
  const qint64 elapsed_ms = (unknown() ? silent_since_ : since_).elapsed();
  since_label_->setText(tr("for %1").arg(durationText(static_cast<double>(elapsed_ms) / 1000.0)));
}

}  // namespace fyd::widgets
