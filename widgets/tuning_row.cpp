#include "widgets/tuning_row.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QSignalBlocker>

#include "widgets/core_text.h"
#include "widgets/icon.h"
#include "widgets/number_text.h"

namespace fyd::widgets {
namespace {

QString fromView(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }

QString unitText(std::string_view unit) { return unit == "1" ? QString() : fromView(unit); }

/// Where a slider ends: the range itself, or, when that is far wider than anybody tunes, ten times the default.
double sliderEnd(const TunedParameter& p) {
  const double usual = std::max({std::abs(p.standard) * 10.0, std::abs(p.saved) * 2.0, 1.0});
  return std::isfinite(p.info.info.maximum) && p.info.info.maximum <= 100.0 * usual ? p.info.info.maximum : usual;
}

}  // namespace

TuningRow::TuningRow(TuningModel& model, QString id, const QString& label, Quantity quantity, QWidget* parent)
    : QWidget(parent),
      model_(model),
      id_(std::move(id)),
      id_std_(id_.toStdString()),
      quantity_(quantity),
      name_(new QLabel(label, this)),
      mark_(new QLabel(this)),
      reset_(new QToolButton(this)) {
  const ParameterInfo& info = parameter().info.info;
  const QString help = tr(std::string(info.help).c_str());
  const QString unit = unitText(info.unit);
  QString tip = help + QLatin1Char('\n') + QString::fromStdString(describeRange(parameter().info));
  tip += QLatin1Char('\n') + tr("Parameter %1").arg(id_);
  name_->setToolTip(tip);
  setAccessibleName(unit.isEmpty() ? label : tr("%1 in %2").arg(label, unit));
  setAccessibleDescription(help);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kGrid / 2);
  grid->setVerticalSpacing(0);
  grid->setColumnStretch(1, 1);
  mark_->setFixedWidth(kGrid);
  mark_->setFont(textFont(TextSize::normal, true));
  grid->addWidget(mark_, 0, 0);
  grid->addWidget(name_, 0, 1);
  reset_->setIcon(icon(QStringLiteral("reset")));
  reset_->setIconSize({14, 14});
  reset_->setFixedSize(26, 26);
  reset_->setProperty("flat", true);
  QSizePolicy keeps_its_place = reset_->sizePolicy();
  keeps_its_place.setRetainSizeWhenHidden(true);
  reset_->setSizePolicy(keeps_its_place);
  reset_->setAccessibleName(tr("Reset %1 to its default").arg(label));
  connect(reset_, &QToolButton::clicked, this, [this] { model_.resetToDefault(id_std_); });
  if (parameter().info.kind == ParameterKind::choice) {
    buildChoice();
    grid->addWidget(choice_, 0, 2, 1, 2);
    grid->addWidget(reset_, 0, 4);
  } else {
    buildNumber();
    field_->setFixedWidth(QFontMetrics(textFont(TextSize::normal)).horizontalAdvance(QStringLiteral("0.00000")) + 16);
    auto* unit_label = new QLabel(unit, this);
    unit_label->setProperty("role", "muted");
    unit_label->setFont(textFont(TextSize::small));
    unit_label->setFixedWidth(QFontMetrics(textFont(TextSize::small)).horizontalAdvance(QStringLiteral("N/mm")));
    grid->addWidget(field_, 0, 2);
    grid->addWidget(unit_label, 0, 3);
    grid->addWidget(reset_, 0, 4);
    grid->addWidget(slider_, 1, 1, 1, 4);
  }
  for (QWidget* editor :
       {static_cast<QWidget*>(slider_), static_cast<QWidget*>(field_), static_cast<QWidget*>(choice_)}) {
    if (editor == nullptr) continue;
    editor->setToolTip(tip);
    editor->setAccessibleName(accessibleName());
    editor->setAccessibleDescription(help);
  }
  connect(&model_, &TuningModel::changed, this, [this](const QString& changed) {
    if (changed == id_) refresh();
  });
  connect(&Look::instance(), &Look::changed, this, &TuningRow::refresh);
  refresh();
}

void TuningRow::buildNumber() {
  const TunedParameter& p = parameter();
  lower_ = std::isfinite(p.info.info.minimum) ? p.info.info.minimum : -sliderEnd(p);
  upper_ = sliderEnd(p);
  slider_ = new QSlider(Qt::Horizontal, this);
  slider_->setObjectName(id_ + QStringLiteral("_slider"));
  slider_->setRange(0, kSteps);
  slider_->setPageStep(kSteps / 20);
  slider_->setProperty("quantity", quantity_ == Quantity::stiffness ? "stiffness" : "vibration");
  slider_->setFocusPolicy(Qt::StrongFocus);
  slider_->installEventFilter(this);
  field_ = new QLineEdit(this);
  field_->setObjectName(id_ + QStringLiteral("_field"));
  field_->setAlignment(Qt::AlignRight);
  field_->installEventFilter(this);
  connect(slider_, &QSlider::valueChanged, this, &TuningRow::takeSlider);
  connect(field_, &QLineEdit::editingFinished, this, &TuningRow::takeField);
  connect(field_, &QLineEdit::textEdited, this, [this] { markRefused(false); });
}

void TuningRow::buildChoice() {
  choice_ = new QComboBox(this);
  choice_->setObjectName(id_ + QStringLiteral("_choice"));
  for (const std::string_view name : parameter().info.choices) choice_->addItem(fromView(name));
  choice_->setFocusPolicy(Qt::StrongFocus);
  choice_->installEventFilter(this);
  connect(choice_, &QComboBox::activated, this, [this](int index) {
    if (const auto ok = model_.change(id_std_, index); !ok) emit refused(coreText(ok.error().message));
  });
}

double TuningRow::toValue(int position) const {
  if (position == kSteps) return upper_;
  const double raw = lower_ + (upper_ - lower_) * position / kSteps;
  // As many digits as a step of the slider means, so that the field shows 0.62 and not 0.6187500.
  const double digit = std::pow(10.0, std::floor(std::log10((upper_ - lower_) / kSteps)));
  const double inverse = std::round(1.0 / digit);
  const double rounded = inverse >= 1.0 ? std::round(raw * inverse) / inverse : std::round(raw / digit) * digit;
  return std::clamp(rounded, lower_, upper_);
}

int TuningRow::toPosition(double value) const {
  return static_cast<int>(std::lround(std::clamp((value - lower_) / (upper_ - lower_), 0.0, 1.0) * kSteps));
}

void TuningRow::takeSlider(int position) {
  if (const auto ok = model_.change(id_std_, toValue(position), true); !ok) {
    emit refused(coreText(ok.error().message));
  }
}

void TuningRow::takeField() {
  if (!field_->isModified()) return;  // also fires when the focus merely passes
  field_->setModified(false);
  const double value = readNumber(field_->text());
  const auto ok = model_.change(id_std_, value);
  if (ok) {
    refresh();
    return;
  }
  markRefused(true);
  emit refused(tr("%1: \"%2\" was not taken. Expected %3.")
                   .arg(name_->text(), field_->text(), QString::fromStdString(describeRange(parameter().info))));
}

void TuningRow::markRefused(bool refused) {
  if (field_ == nullptr || field_->property("refused").toBool() == refused) return;
  field_->setProperty("refused", refused);
  restyle(*field_);
}

void TuningRow::refresh() {
  const TunedParameter& p = parameter();
  if (choice_ != nullptr) {
    const QSignalBlocker quiet(choice_);
    choice_->setCurrentIndex(static_cast<int>(p.value));
  } else {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(toPosition(p.value));
    field_->setText(plainNumber(p.value));
    field_->setModified(false);
    markRefused(false);
  }
  mark_->setText(p.changed() ? QStringLiteral("•") : QString());
  mark_->setToolTip(p.changed() ? tr("Changed; the profile has %1").arg(plainNumber(p.saved)) : QString());
  mark_->setAccessibleName(p.changed() ? tr("Changed, not saved") : QString());
  reset_->setVisible(p.value != p.standard);
  reset_->setToolTip(tr("Back to the default, %1")
                         .arg(p.info.kind == ParameterKind::choice
                                  ? fromView(p.info.choices[static_cast<std::size_t>(p.standard)])
                                  : plainNumber(p.standard)));
}

bool TuningRow::eventFilter(QObject* watched, QEvent* event) {
  // The wheel scrolls the panel; it changes a value only where the operator has put the focus.
  if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
    event->ignore();
    return true;
  }
  if (watched == field_ && event->type() == QEvent::FocusOut && field_->property("refused").toBool()) refresh();
  return QWidget::eventFilter(watched, event);
}

}  // namespace fyd::widgets
