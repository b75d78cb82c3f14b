#include "widgets/devices/device_card.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <cmath>

#include "widgets/basics/core_text.h"
#include "widgets/basics/icon.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"
#include "widgets/devices/device_text.h"

namespace fyd::widgets {
namespace {

constexpr int kSymbol = 24;
constexpr int kWide = 52 * kGrid;  // from here on two columns of values have room

QString iconOf(device::Part part) {
  if (part == device::Part::camera) return QStringLiteral("camera");
  if (part == device::Part::motor_board) return QStringLiteral("arm");
  return QStringLiteral("touchpad");
}

QLabel* small(QLabel* label, bool muted) {
  label->setFont(textFont(TextSize::small));
  if (muted) label->setProperty("role", "muted");
  return label;
}

}  // namespace

DeviceCard::DeviceCard(QWidget* parent)
    : QFrame(parent),
      layout_(new QVBoxLayout(this)),
      symbol_(new QLabel(this)),
      name_(new QLabel(this)),
      kind_(small(new QLabel(this), true)),
      shape_(new QLabel(this)),
      state_(new QLabel(this)),
      description_(small(new QLabel(this), true)),
      problem_(new QLabel(this)),
      test_area_(new QWidget(this)),
      test_words_(small(new QLabel(this), true)) {
  setProperty("surface", "panel");
  build();
  connect(&Look::instance(), &Look::changed, this, [this] { showState(ok_); });
}

void DeviceCard::build() {
  name_->setFont(textFont(TextSize::normal, true));
  state_->setFont(textFont(TextSize::normal, true));
  symbol_->setFixedSize(kSymbol, kSymbol);
  shape_->setFixedSize(2 * kGrid, 2 * kGrid);
  problem_->setProperty("role", "warning");
  for (QLabel* text : {description_, problem_, test_words_}) text->setWordWrap(true);
  description_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* head = new QHBoxLayout;
  head->setSpacing(kGrid);
  head->addWidget(symbol_);
  head->addWidget(name_);
  head->addWidget(kind_, 1, Qt::AlignBaseline);
  head->addWidget(shape_);
  head->addWidget(state_);
  layout_->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, 2 * kGrid);
  layout_->setSpacing(kGrid / 2);
  layout_->addLayout(head);
  layout_->addWidget(description_);
  layout_->addWidget(problem_);
  figures_ = section({});
  errors_ = section(tr("Errors by kind"));
  values_ = section(tr("Live values"));
  controls_ = section(tr("Controls"));
  auto* tests = new QVBoxLayout(test_area_);
  tests->setContentsMargins(0, kGrid, 0, 0);
  tests->setSpacing(kGrid / 2);
  auto* title = new QLabel(tr("Test, while held"), test_area_);
  title->setFont(textFont(TextSize::normal, true));
  tests->addWidget(title);
  layout_->addWidget(test_area_);
  layout_->addStretch(1);
  test_area_->hide();
  showState(false);
}

DeviceCard::Section DeviceCard::section(const QString& title) {
  Section out{.title = new QLabel(title, this), .grid = new QGridLayout, .rows = {}};
  out.title->setFont(textFont(TextSize::normal, true));
  out.title->hide();
  out.grid->setHorizontalSpacing(kGrid);
  out.grid->setVerticalSpacing(2);
  out.grid->setColumnStretch(1, 1);
  layout_->addSpacing(kGrid / 2);
  layout_->addWidget(out.title);
  layout_->addLayout(out.grid);
  return out;
}

void DeviceCard::fill(Section& section, const std::vector<Entry>& entries) {
  while (section.rows.size() < entries.size()) {
    section.rows.push_back({small(new QLabel(this), true), small(new QLabel(this), false)});
    section.rows.back().value->setWordWrap(true);
  }
  const auto columns = static_cast<std::size_t>(section.columns);
  const std::size_t lines = (entries.size() + columns - 1) / columns;
  for (std::size_t i = 0; i < section.rows.size(); ++i) {
    const Row& row = section.rows[i];
    const bool shown = i < entries.size();
    if (shown) {
      // Read downwards, column by column.
      const int line = static_cast<int>(i % lines);
      const int column = 3 * static_cast<int>(i / lines);
      if (section.grid->itemAtPosition(line, column) == nullptr ||
          section.grid->itemAtPosition(line, column)->widget() != row.label) {
        section.grid->addWidget(row.label, line, column, Qt::AlignTop);
        section.grid->addWidget(row.value, line, column + 1, Qt::AlignTop);
      }
      row.label->setText(entries[i].label);
      if (row.value->text() != entries[i].value) {
        row.value->setText(entries[i].value);
        row.value->setAccessibleName(entries[i].label + QStringLiteral(": ") + entries[i].value);
      }
    }
    row.label->setVisible(shown);
    row.value->setVisible(shown);
  }
  section.title->setVisible(!entries.empty() && !section.title->text().isEmpty());
}

std::vector<DeviceCard::Entry> DeviceCard::figures(const device::DeviceReport& report) {
  const bool camera = report.part == device::Part::camera;
  const double rate = report.rate_hz > 0.0 ? report.rate_hz : std::nan("");
  return {{camera ? tr("Pictures") : tr("Answers"), quantityText(rate, 0, tr("a second"))},
          {camera ? tr("Last picture") : tr("Last answer"),
           std::isfinite(report.age_ms) ? tr("%1 ago").arg(ageText(report.age_ms)) : kNoValue},
          {tr("Errors"), report.errors == 0 ? tr("none since the start") : QString::number(report.errors)}};
}

std::vector<DeviceCard::Entry> DeviceCard::controls(const device::DeviceReport& report) {
  std::vector<Entry> out;
  if (report.part == device::Part::camera && report.controls.empty()) {
    out.push_back({tr("Brightness, contrast, exposure"), tr("this source has none")});
  }
  for (const device::CameraControl& control : report.controls) {
    QString words = deviceWord(control.words);
    if (words.isEmpty()) words = control.supported ? tr("Left as it is") : tr("This source has none");
    const bool told = control.supported && std::isfinite(control.actual);
    const QString now = quantityText(control.actual, 0, tr("%"));
    out.push_back({deviceWord(control.name), told && !words.contains(now) ? tr("%1; now %2").arg(words, now) : words});
  }
  return out;
}

void DeviceCard::setReport(const device::DeviceReport& report) {
  setAccessibleName(coreText(toString(report.part)));
  symbol_->setPixmap(icon(iconOf(report.part), theme().text).pixmap(QSize(kSymbol, kSymbol), devicePixelRatioF()));
  name_->setText(coreText(toString(report.part)));
  kind_->setText(coreText(report.kind));
  description_->setText(breakable(coreText(report.description)));
  problem_->setText(deviceWord(report.problem));
  problem_->setVisible(!report.problem.empty());
  showState(report.ok);
  fill(figures_, figures(report));
  std::vector<Entry> errors;
  for (const device::ErrorCount& each : report.counters) {
    if (each.count > 0) errors.push_back({deviceWord(each.kind), QString::number(each.count)});
  }
  fill(errors_, errors);
  std::vector<Entry> values;
  values.reserve(report.values.size());
  for (const device::ReportValue& each : report.values) {
    values.push_back(
        {deviceWord(each.name), each.text.empty() ? deviceValue(each.number, each.unit) : deviceWord(each.text)});
  }
  shown_values_ = std::move(values);
  fill(values_, shown_values_);
  fill(controls_, controls(report));
}

void DeviceCard::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  const int columns = width() >= kWide ? 2 : 1;
  if (columns == values_.columns) return;
  values_.columns = columns;
  values_.grid->setColumnStretch(4, columns == 2 ? 1 : 0);
  fill(values_, shown_values_);
}

void DeviceCard::showState(bool ok) {
  ok_ = ok;
  state_->setText(ok ? tr("Well") : tr("Problem"));
  const QColor colour = ok ? theme().text : theme().warning;
  state_->setStyleSheet(QStringLiteral("color: %1;").arg(colour.name()));
  shape_->setPixmap(icon(ok ? QStringLiteral("check") : QStringLiteral("warning"), colour)
                        .pixmap(QSize(2 * kGrid, 2 * kGrid), devicePixelRatioF()));
}

void DeviceCard::setTests(const QStringList& words) {
  if (!tests_.empty() || words.isEmpty()) {
    test_area_->setVisible(!words.isEmpty());
    return;
  }
  auto* layout = qobject_cast<QVBoxLayout*>(test_area_->layout());
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid);
  for (int i = 0; i < words.size(); ++i) {
    auto* button = new HoldButton(words[i], test_area_);
    button->setObjectName(QStringLiteral("device_test_%1").arg(i));
    button->setToolTip(tr("Small and slow, and only while the button is held. Esc ends it as well."));
    connect(button, &HoldButton::held, this, [this, i] { emit testHeld(i); });
    connect(button, &HoldButton::letGo, this, &DeviceCard::testLetGo);
    row->addWidget(button, 1);
    tests_.push_back(button);
  }
  layout->addLayout(row);
  layout->addWidget(test_words_);
  test_area_->show();  // after its buttons are in it: one added to a shown area is shown only later
  allowTests(allowed_, why_not_);
}

void DeviceCard::allowTests(bool allowed, const QString& why) {
  allowed_ = allowed;
  why_not_ = why;
  for (HoldButton* button : tests_) button->setEnabled(allowed);
  showTest(test_);
}

void DeviceCard::showTest(const QString& words) {
  test_ = words;
  test_words_->setText(!test_.isEmpty() ? test_
                       : !allowed_      ? why_not_
                                        : tr("A motor goes 2° out and back; the vibration lasts half a second."));
}

QString DeviceCard::value(const QString& label) const {
  for (const Section* each : {&figures_, &values_, &errors_, &controls_}) {
    for (const Row& row : each->rows) {
      if (row.label->text() == label && !row.label->isHidden()) return row.value->text();
    }
  }
  return {};
}

}  // namespace fyd::widgets
