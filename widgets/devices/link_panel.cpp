#include "widgets/devices/link_panel.h"

#include <QVBoxLayout>

#include "widgets/basics/icon.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr int kShape = 24;

enum RowIndex {
  condition,
  peer,
  local,
  protocol,
  round_trip,
  jitter,
  loss,
  rate,
  age,
  received,
  sent,
  times_lost,
  predictor,
  ahead,
  arrived,
  led,
  led_error
};

QString countText(std::uint64_t count) { return QString::number(count); }

QString orNone(const QString& text) { return text.isEmpty() ? kNoValue : text; }

struct SecurityWords {
  QString shape;
  QString word;
  QString explanation;
};

SecurityWords describe(const LinkView& view) {
  switch (view.security) {
    case LinkView::Security::sealed:
      return {QStringLiteral("lock"), LinkPanel::tr("Secured"),
              LinkPanel::tr("Only a robot with the same key is heard; what is said cannot be read or changed.")};
    case LinkView::Security::open:
      return {QStringLiteral("lock-open"), LinkPanel::tr("Not secured"),
              view.local_only ? LinkPanel::tr("Nothing is checked or hidden; only programs on this computer reach it.")
                              : LinkPanel::tr("Nothing is checked or hidden: whoever reaches this address can pose as "
                                              "the robot. Use it on a line of its own.")};
    case LinkView::Security::no_link: break;
  }
  return {
      {}, LinkPanel::tr("No link"), LinkPanel::tr("No robot on a network: the target is a scene's, or set by hand.")};
}

}  // namespace

LinkPanel::LinkPanel(QWidget* parent)
    : QFrame(parent),
      shape_(new QLabel(this)),
      security_(new QLabel(this)),
      explanation_(new QLabel(this)),
      grid_(new QGridLayout),
      refused_title_(new QLabel(this)),
      refusals_(new QGridLayout) {
  setProperty("surface", "panel");
  setAccessibleName(tr("Link"));
  shape_->setFixedSize(kShape, kShape);
  security_->setObjectName(QStringLiteral("link_security"));
  security_->setFont(textFont(TextSize::normal, true));
  explanation_->setFont(textFont(TextSize::small));
  explanation_->setProperty("role", "muted");
  explanation_->setWordWrap(true);
  refused_title_->setFont(textFont(TextSize::normal, true));
  for (QGridLayout* grid : {grid_, refusals_}) {
    grid->setHorizontalSpacing(kGrid);
    grid->setVerticalSpacing(kGrid / 2);
    grid->setColumnStretch(1, 1);
  }
  auto* security = new QHBoxLayout;
  security->setSpacing(kGrid);
  security->addWidget(shape_);
  security->addWidget(security_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid / 2);
  layout->addLayout(security);
  layout->addWidget(explanation_);
  layout->addSpacing(kGrid / 2);
  layout->addLayout(grid_);
  layout->addSpacing(kGrid / 2);
  layout->addWidget(refused_title_);
  layout->addLayout(refusals_);
  // In the order of RowIndex.
  for (const QString& label :
       {tr("State"), tr("Robot"), tr("Listening on"), tr("Protocol"), tr("Round trip"), tr("Jitter"), tr("Loss"),
        tr("Messages"), tr("Last message"), tr("Received"), tr("Sent"), tr("Times lost"), tr("Predictor"),
        tr("Predicted ahead"), tr("Arrived"), tr("Predicted"), tr("Prediction error")}) {
    rows_.push_back(addRow(*grid_, static_cast<int>(rows_.size()), label));
  }
  rows_[jitter].label->setToolTip(tr("How far the time between the robot's messages strays: four mean deviations."));
  rows_[loss].label->setToolTip(tr("Share of the robot's messages of the last second that did not arrive."));
  rows_[times_lost].label->setToolTip(tr("How often the robot was silent for longer than the link allows."));
  rows_[arrived].label->setToolTip(tr("Where the newest touch leads the arm by itself: x, y, z."));
  rows_[led].label->setToolTip(tr("Where the arm is led: where the finger will be when it gets there."));
  rows_[led_error].label->setToolTip(
      tr("Where the finger was said to be, against where it was seen after: RMS over about a second."));
  connect(&Look::instance(), &Look::changed, this, &LinkPanel::showSecurity);
  setLink({});
}

LinkPanel::Row LinkPanel::addRow(QGridLayout& grid, int line, const QString& label) {
  Row row{.label = new QLabel(label, this), .value = new QLabel(this)};
  row.label->setFont(textFont(TextSize::small));
  row.label->setProperty("role", "muted");
  row.value->setFont(textFont(TextSize::small));
  row.value->setWordWrap(true);
  grid.addWidget(row.label, line, 0, Qt::AlignTop);
  grid.addWidget(row.value, line, 1);
  return row;
}

void LinkPanel::set(const Row& row, const QString& text) {
  if (row.value->text() == text) return;
  row.value->setText(text);
  row.value->setAccessibleName(row.label->text() + QStringLiteral(": ") + text);
}

void LinkPanel::setLink(const LinkView& view) {
  view_ = view;
  const auto age_text = [&] { return std::isfinite(view.age_ms) ? tr("%1 ago").arg(ageText(view.age_ms)) : kNoValue; };
  set(rows_[condition], orNone(view.condition));
  set(rows_[peer], orNone(view.peer));
  set(rows_[local], orNone(view.local));
  set(rows_[protocol], orNone(view.protocol));
  set(rows_[round_trip], quantityText(view.round_trip_ms, 1, tr("ms")));
  set(rows_[jitter], quantityText(view.jitter_ms, 1, tr("ms")));
  set(rows_[loss], quantityText(view.loss_percent, 1, tr("%")));
  set(rows_[rate], quantityText(view.rate_hz, 0, tr("a second")));
  set(rows_[age], age_text());
  const bool any = view.security != LinkView::Security::no_link;
  set(rows_[received], any ? countText(view.received) : kNoValue);
  set(rows_[sent], any ? countText(view.sent) : kNoValue);
  set(rows_[times_lost], any ? countText(view.times_lost) : kNoValue);
  const bool told = !view.predictor.isEmpty();
  set(rows_[predictor], told ? view.predictor : tr("not told by this robot"));
  set(rows_[ahead], quantityText(view.ahead_ms, 0, tr("ms")));
  set(rows_[arrived], view.arrived);
  set(rows_[led], view.led);
  set(rows_[led_error], quantityText(view.led_error_mm, 2, QStringLiteral("mm")));
  for (const RowIndex index : {predictor, ahead, arrived, led, led_error}) {
    const bool shown = told || (index == predictor && any);
    rows_[index].label->setVisible(shown);
    rows_[index].value->setVisible(shown);
  }
  const QString why = view.security == LinkView::Security::open ? tr("The classic protocol cannot tell.") : QString();
  for (const RowIndex index : {round_trip, loss}) rows_[index].value->setToolTip(why);
  const char* role = view.health == LinkView::Health::lost ? "warning" : "";
  for (const RowIndex index : {condition, age}) {
    QLabel* value = rows_[index].value;
    if (value->property("role").toString() == QLatin1String(role)) continue;
    value->setProperty("role", role);
    restyle(*value);
  }
  showSecurity();
  showRefusals();
}

void LinkPanel::showSecurity() {
  const SecurityWords words = describe(view_);
  shape_name_ = words.shape;
  security_->setText(words.word);
  explanation_->setText(words.explanation);
  shape_->setVisible(!words.shape.isEmpty());
  shape_->setPixmap(icon(words.shape, theme().text).pixmap(QSize(kShape, kShape), devicePixelRatioF()));
}

void LinkPanel::showRefusals() {
  const bool any = view_.security != LinkView::Security::no_link;
  refused_title_->setText(view_.refused > 0 ? tr("Refused: %1").arg(view_.refused) : tr("Refused: none"));
  refused_title_->setVisible(any);
  while (refusal_rows_.size() < view_.refusals.size()) {
    refusal_rows_.push_back(addRow(*refusals_, static_cast<int>(refusal_rows_.size()), {}));
  }
  for (std::size_t i = 0; i < refusal_rows_.size(); ++i) {
    const Row& row = refusal_rows_[i];
    const bool shown = any && i < view_.refusals.size();
    if (shown) {
      row.label->setText(view_.refusals[i].reason);
      set(row, countText(view_.refusals[i].count));
    }
    row.label->setVisible(shown);
    row.value->setVisible(shown);
  }
}

QString LinkPanel::value(const QString& label) const {
  for (const auto* rows : {&rows_, &refusal_rows_}) {
    for (const Row& row : *rows) {
      if (row.label->text() == label && !row.label->isHidden()) return row.value->text();
    }
  }
  return {};
}

}  // namespace fyd::widgets
