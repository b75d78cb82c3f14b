#include "widgets/tuning/tuning_row.h"

#include <QKeyEvent>
#include <QSignalBlocker>
#include <utility>

#include "widgets/basics/core_text.h"
#include "widgets/basics/icon.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/wheel_guard.h"
#include "widgets/tuning/tuning_text.h"

namespace fyd::widgets {
namespace {

/// A slider's upper end: the range's maximum, or, when that is infinite or far wider than needed for tuning, the
/// largest of ten times the default, twice the saved value and 1.
double sliderEnd(const TunedParameter& p) {
  const double usual = std::max({std::abs(p.standard) * 10.0, std::abs(p.saved) * 2.0, 1.0});
  return std::isfinite(p.info.info.maximum) && p.info.info.maximum <= 100.0 * usual ? p.info.info.maximum : usual;
}

}  // namespace

TuningRow::TuningRow(TuningModel& model, QString id, const QString& label, Quantity quantity, QWidget* parent,
                     RowDetail detail)
    : QWidget(parent),
      model_(model),
      id_(std::move(id)),
      id_std_(id_.toStdString()),
      quantity_(quantity),
      name_(new QLabel(label, this)),
      mark_(new QLabel(this)) {
  const Parameter& info = parameter().info;
  const QString help = coreText(info.info.help);
  const QString unit = unitText(info);
  QString tip = help + QLatin1Char('\n') + coreText(describeRange(info));
  tip += QLatin1Char('\n') + tr("Parameter %1").arg(id_);
  name_->setToolTip(tip);
  setAccessibleName(unit.isEmpty() ? label : tr("%1 in %2").arg(label, unit));
  setAccessibleDescription(help);
  reset_ = buildBack(QStringLiteral("reset"), tr("Reset %1 to its default").arg(label));
  connect(reset_, &QToolButton::clicked, this, [this] { model_.resetToDefault(id_std_); });
  if (info.kind == ParameterKind::choice || info.kind == ParameterKind::boolean) {
    buildChoice();
  } else {
    buildNumber();
  }
  if (detail == RowDetail::full) {
    revert_ = buildBack(QStringLiteral("saved"), tr("Back to the saved value of %1").arg(label));
    connect(revert_, &QToolButton::clicked, this, [this] { model_.revertToSaved(id_std_); });
    help_ = new QLabel(help, this);
    facts_ = new QLabel(this);
  }
  for (QWidget* editor :
       {static_cast<QWidget*>(slider_), static_cast<QWidget*>(field_), static_cast<QWidget*>(choice_)}) {
    if (editor == nullptr) continue;
    editor->setToolTip(tip);
    editor->setAccessibleName(accessibleName());
    editor->setAccessibleDescription(help);
  }
  if (field_ != nullptr) {
    field_->setFixedWidth(QFontMetrics(textFont(TextSize::normal)).horizontalAdvance(QStringLiteral("0.00000")) + 16);
  }
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kGrid / 2);
  grid->setVerticalSpacing(0);
  mark_->setFixedWidth(kGrid);
  mark_->setFont(textFont(TextSize::normal, true));
  grid->addWidget(mark_, 0, 0);
  if (detail == RowDetail::full) {
    layOutFull(*grid);
  } else {
    layOutBrief(*grid);
  }
  connect(&model_, &TuningModel::changed, this, [this](const QString& changed) {
    if (changed == id_) refresh();
  });
  connect(&model_, &TuningModel::feelingSavedChanged, this, &TuningRow::refresh);
  connect(&model_, &TuningModel::questionChanged, this, &TuningRow::showQuestion);
  connect(&Look::instance(), &Look::changed, this, &TuningRow::refresh);
  refresh();
}

QToolButton* TuningRow::buildBack(const QString& symbol, const QString& words) {
  auto* button = new QToolButton(this);
  button->setIcon(icon(symbol));
  button->setIconSize({14, 14});
  button->setFixedSize(26, 26);
  button->setProperty("flat", true);
  QSizePolicy keeps_its_place = button->sizePolicy();
  keeps_its_place.setRetainSizeWhenHidden(true);
  button->setSizePolicy(keeps_its_place);
  button->setAccessibleName(words);
  return button;
}

QLabel* TuningRow::buildUnit(const QString& widest) {
  const QFont font = textFont(TextSize::small);
  auto* unit = new QLabel(unitText(parameter().info), this);
  unit->setProperty("role", "muted");
  unit->setFont(font);
  unit->setFixedWidth(QFontMetrics(font).horizontalAdvance(widest));
  return unit;
}

void TuningRow::layOutBrief(QGridLayout& grid) {
  grid.setColumnStretch(1, 1);
  grid.addWidget(name_, 0, 1);
  if (choice_ != nullptr) {
    grid.addWidget(choice_, 0, 2, 1, 2);
  } else {
    grid.addWidget(field_, 0, 2);
    grid.addWidget(buildUnit(QStringLiteral("N/mm")), 0, 3);
    grid.addWidget(slider_, 1, 1, 1, 4);
  }
  grid.addWidget(reset_, 0, 4);
}

void TuningRow::layOutFull(QGridLayout& grid) {
  constexpr int kName_px = 22 * kGrid;
  constexpr int kLeastSlider_px = 12 * kGrid;
  unit_ = buildUnit(choice_ == nullptr ? QStringLiteral("deg/(N/mm)/s") : QString());
  name_->setFixedWidth(kName_px);
  if (slider_ != nullptr) {
    slider_->setMinimumWidth(kLeastSlider_px);
    wide_px_ = mark_->width() + kName_px + kLeastSlider_px + field_->maximumWidth() + unit_->maximumWidth() +
               revert_->width() + reset_->width() + 6 * grid.horizontalSpacing();
  }
  for (QLabel* label : {help_, facts_}) {
    label->setFont(textFont(TextSize::small));
    label->setWordWrap(true);
    label->setProperty("role", "muted");
    grid.addWidget(label, label == help_ ? 2 : 3, 1, 1, 6);
  }
  grid.setColumnStretch(2, 1);
  placeFull();
}

/// Wide: name, slider, field, unit, the ways back. Narrow: the name and the ways back, then the others below.
void TuningRow::placeFull() {
  auto& grid = static_cast<QGridLayout&>(*layout());
  const int editors = narrow_ ? 1 : 0;  // their row
  grid.addWidget(name_, 0, 1, 1, narrow_ ? 4 : 1);
  if (choice_ != nullptr) {
    grid.addWidget(choice_, editors, narrow_ ? 1 : 3, 1, narrow_ ? 3 : 2, narrow_ ? Qt::AlignLeft : Qt::Alignment());
  } else {
    grid.addWidget(slider_, editors, narrow_ ? 1 : 2, 1, narrow_ ? 2 : 1);
    grid.addWidget(field_, editors, 3);
    grid.addWidget(unit_, editors, 4, 1, narrow_ ? 3 : 1);
  }
  grid.addWidget(revert_, 0, 5);
  grid.addWidget(reset_, 0, 6);
}

void TuningRow::setNarrow(bool narrow) {
  if (help_ == nullptr || narrow == narrow_) return;
  narrow_ = narrow;
  for (QWidget* each : {static_cast<QWidget*>(name_), static_cast<QWidget*>(choice_), static_cast<QWidget*>(slider_),
                        static_cast<QWidget*>(field_), static_cast<QWidget*>(unit_)}) {
    if (each != nullptr) layout()->removeWidget(each);
  }
  placeFull();
}

void TuningRow::buildNumber() {
  const TunedParameter& p = parameter();
  lower_ = std::isfinite(p.info.info.minimum) ? p.info.info.minimum : -sliderEnd(p);
  upper_ = sliderEnd(p);
  if (p.info.kind == ParameterKind::integer) {
    steps_ = static_cast<int>(std::clamp(upper_ - lower_, 1.0, static_cast<double>(steps_)));
  }
  slider_ = new QSlider(Qt::Horizontal, this);
  slider_->setObjectName(id_ + QStringLiteral("_slider"));
  slider_->setRange(0, steps_);
  slider_->setPageStep(std::max(1, steps_ / 20));
  slider_->setProperty("quantity", quantity_ == Quantity::stiffness   ? "stiffness"
                                   : quantity_ == Quantity::vibration ? "vibration"
                                                                      : "");
  guardFromWheel(slider_);
  field_ = new QLineEdit(this);
  field_->setObjectName(id_ + QStringLiteral("_field"));
  field_->setAlignment(Qt::AlignRight);
  field_->installEventFilter(this);
  connect(slider_, &QSlider::valueChanged, this, &TuningRow::takeSlider);
  // Enter only: a number that is half written must not act because another window came to the front.
  connect(field_, &QLineEdit::returnPressed, this, &TuningRow::takeField);
  connect(field_, &QLineEdit::textEdited, this, [this] { markRefused(false); });
}

void TuningRow::buildChoice() {
  choice_ = new QComboBox(this);
  choice_->setObjectName(id_ + QStringLiteral("_choice"));
  const Parameter& info = parameter().info;
  const auto count = info.kind == ParameterKind::boolean ? std::size_t{2} : info.choices.size();
  for (std::size_t i = 0; i < count; ++i) choice_->addItem(valueText(info, static_cast<double>(i)));
  guardFromWheel(choice_);
  connect(choice_, &QComboBox::activated, this, [this](int index) {
    if (const auto ok = model_.change(id_std_, index); !ok) {
      refresh();
      emit refused(coreText(ok.error().message), id_);
    }
  });
}

double TuningRow::toValue(int position) const {
  if (position == steps_) return upper_;
  const double raw = lower_ + (upper_ - lower_) * position / steps_;
  if (parameter().info.kind == ParameterKind::integer) return std::clamp(std::round(raw), lower_, upper_);
  // As many digits as a step of the slider means, so that the field shows 0.62 and not 0.6187500.
  const double digit = std::pow(10.0, std::floor(std::log10((upper_ - lower_) / steps_)));
  const double inverse = std::round(1.0 / digit);
  const double rounded = inverse >= 1.0 ? std::round(raw * inverse) / inverse : std::round(raw / digit) * digit;
  return std::clamp(rounded, lower_, upper_);
}

int TuningRow::toPosition(double value) const {
  return static_cast<int>(std::lround(std::clamp((value - lower_) / (upper_ - lower_), 0.0, 1.0) * steps_));
}

void TuningRow::takeSlider(int position) {
  if (const auto ok = model_.change(id_std_, toValue(position), true); !ok) {
    refresh();  // it must not stand where no value is
    emit refused(coreText(ok.error().message), id_);
  }
}

void TuningRow::takeField() {
  if (!field_->isModified()) {
    emit entered();
    return;
  }
  field_->setModified(false);
  const double value = readNumber(field_->text());
  const auto ok = model_.change(id_std_, value);
  const bool asked = model_.question() && model_.question()->id == id_;
  if (ok && asked) {
    question_->takeFocus();
    return;
  }
  if (ok) {
    refresh();
    emit entered();
    return;
  }
  markRefused(true);
  field_->selectAll();  // the next key writes another value
  emit refused(tr("%1: \"%2\" was not taken. Expected %3.")
                   .arg(name_->text(), field_->text(), coreText(describeRange(parameter().info))),
               id_);
}

void TuningRow::showQuestion() {
  const auto& question = model_.question();
  if (!question || question->id != id_) {
    if (question_ == nullptr || question_->isHidden()) return;
    question_->hide();
    refresh();
    return;
  }
  if (question_ == nullptr) {
    question_ = new TuningQuestionBox(model_, this);
    connect(question_, &TuningQuestionBox::answered, this, &TuningRow::entered);
    auto& grid = static_cast<QGridLayout&>(*layout());
    grid.addWidget(question_, grid.rowCount(), 1, 1, grid.columnCount() - 1);
  }
  refresh();
  question_->showQuestion(question->words);
}

bool TuningRow::holdsAnEntry() const { return field_->isModified() || field_->property("refused").toBool(); }

void TuningRow::giveUpEntry() {
  if (!holdsAnEntry()) return;
  field_->setModified(false);
  markRefused(false);
  refresh();
}

void TuningRow::markRefused(bool refused) {
  if (field_ == nullptr || field_->property("refused").toBool() == refused) return;
  field_->setProperty("refused", refused);
  restyle(*field_);
}

void TuningRow::refresh() {
  const TunedParameter& p = parameter();
  const double felt = model_.felt(p);
  const bool free = !model_.feelingSaved();
  const auto& question = model_.question();
  const double shown = question && question->id == id_ ? question->value : felt;  // what is asked about stands there
  if (choice_ != nullptr) {
    const QSignalBlocker quiet(choice_);
    choice_->setCurrentIndex(static_cast<int>(shown));
    choice_->setEnabled(free);
  } else {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(toPosition(shown));
    slider_->setEnabled(free);
    field_->setEnabled(free);
    // What is being written, or mended, is the operator's, whatever changes elsewhere.
    if (!field_->hasFocus() || !holdsAnEntry()) {
      field_->setText(plainNumber(shown));
      field_->setModified(false);
      markRefused(false);
    }
  }
  refreshMark();
  reset_->setVisible(felt != p.standard);
  reset_->setEnabled(free);
  reset_->setToolTip(tr("Back to the default, %1").arg(valueText(p.info, p.standard)));
  if (revert_ == nullptr) return;
  revert_->setVisible(p.changed());
  revert_->setEnabled(free);
  revert_->setToolTip(tr("Back to the saved value, %1").arg(valueText(p.info, p.saved)));
}

void TuningRow::refreshMark() {
  const TunedParameter& p = parameter();
  const bool trouble = p.delivery != Delivery::confirmed && p.delivery != Delivery::pending;
  const QString words = deliveryWords(p);
  const QString saved = p.changed() ? tr("Changed; the profile has %1").arg(valueText(p.info, p.saved)) : QString();
  mark_->setText(trouble                           ? QStringLiteral("!")
                 : p.delivery == Delivery::pending ? QStringLiteral("◦")
                 : p.changed()                     ? QStringLiteral("•")
                                                   : QString());
  const QString role = trouble ? QStringLiteral("warning") : QString();
  if (mark_->property("role").toString() != role) {
    mark_->setProperty("role", role);
    restyle(*mark_);
  }
  mark_->setToolTip(words.isEmpty() ? saved : words);
  mark_->setAccessibleName(!words.isEmpty() ? words : p.changed() ? tr("Changed, not saved") : QString());
  if (facts_ == nullptr) return;
  const QString facts = tunedFacts(model_, p);
  facts_->setText(words.isEmpty() ? facts : facts + QStringLiteral(" · ") + words);
}

bool TuningRow::eventFilter(QObject* watched, QEvent* event) {
  // A field in which nothing was typed has nothing to take back: undo and redo are then of the values.
  if (watched == field_ && event->type() == QEvent::ShortcutOverride && !holdsAnEntry()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return true;
    }
  }
  // A click into a field takes all of it, so that the next key writes a new value.
  if (watched == field_ && event->type() == QEvent::FocusIn &&
      static_cast<QFocusEvent*>(event)->reason() == Qt::MouseFocusReason) {
    QMetaObject::invokeMethod(field_, &QLineEdit::selectAll, Qt::QueuedConnection);
  }
  if (watched == field_ && event->type() == QEvent::FocusOut &&
      static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason) {  // its own menu gives the focus back
    giveUpEntry();
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace fyd::widgets
