#include "widgets/curves/curve_stack.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/basics/number_text.h"

namespace fyd::widgets {
namespace {

constexpr int kTimeDecimals = 3;  // samples are 1 ms apart
constexpr int kStretch = 4;
constexpr int kStretchWithScale = 5;  // this one also carries the time scale

}  // namespace

CurveStack::CurveStack(TimeWindow window, QWidget* parent)
    : QWidget(parent), windows_{window}, mark_label_(new QLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  mark_label_->setObjectName(QStringLiteral("mark_label"));
  mark_label_->setFont(textFont(TextSize::small));
  mark_label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  mark_label_->hide();
  layout->addWidget(mark_label_);
}

void CurveStack::add(StripSetup setup) {
  const std::size_t index = strips_.size();
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  auto* strip = new CurveStrip(setup.title, setup.unit, setup.least, setup.traces, false, row);
  auto* readout = new Readout(setup.title, setup.unit, setup.entries, setup.large, row);
  layout->addWidget(strip, 1);
  layout->addWidget(readout);
  static_cast<QVBoxLayout*>(this->layout())->addWidget(row, kStretch);
  connect(strip, &CurveStrip::panned, this,
          [this, index](double by_s) { change(index, [by_s](TimeWindow& window) { window.pan(by_s); }); });
  connect(strip, &CurveStrip::zoomed, this, [this, index](double factor, double about_s) {
    change(index, [=](TimeWindow& window) { window.zoom(factor, window.to_s() + about_s); });
  });
  connect(strip, &CurveStrip::boxed, this, [this, index](double from_s, double to_s) {
    change(index, [=](TimeWindow& window) { window.show(window.to_s() + from_s, window.to_s() + to_s); });
  });
  connect(strip, &CurveStrip::stretched, this, &CurveStack::moved);
  connect(strip, &CurveStrip::clicked, this, [this, index](double at_s) { emit clicked(window(index).to_s() + at_s); });
  connect(strip, &CurveStrip::followAsked, this, &CurveStack::followAsked);
  strips_.push_back({std::move(setup), strip, readout, row});
  windows_.resize(strips_.size(), windows_.front());
  arrange();
}

std::size_t CurveStack::indexOf(const QString& id) const {
  const auto found = std::ranges::find_if(strips_, [&](const Strip& each) { return each.setup.id == id; });
  return static_cast<std::size_t>(found - strips_.begin());
}

void CurveStack::setShown(std::size_t index, bool shown) {
  const auto others = std::ranges::count_if(strips_, [](const Strip& each) { return each.setup.shown; });
  if (!shown && strips_[index].setup.shown && others == 1) return;
  strips_[index].setup.shown = shown;
  marks_changed_ = true;
  arrange();
  emit moved();
}

// The lowest strip carries the time scale; each does when they show different times.
void CurveStack::arrange() {
  auto* layout = static_cast<QVBoxLayout*>(this->layout());
  bool lowest = true;
  for (auto it = strips_.rbegin(); it != strips_.rend(); ++it) {
    const bool scale = it->setup.shown && (lowest || !linked_);
    if (it->setup.shown) lowest = false;
    it->row->setVisible(it->setup.shown);
    it->strip->setTimeScale(scale);
    layout->setStretchFactor(it->row, scale ? kStretchWithScale : kStretch);
  }
}

void CurveStack::setLinked(bool linked) {
  if (linked == linked_) return;
  const TimeWindow common = window();
  std::ranges::fill(windows_, common);
  linked_ = linked;
  arrange();
  emit moved();
}

void CurveStack::change(std::size_t index, const std::function<void(TimeWindow&)>& change) {
  last_moved_ = index;
  TimeWindow& window = windows_[linked_ ? 0 : index];
  change(window);
  if (hold_) hold_(window);
  emit moved();
}

void CurveStack::forEachWindow(const std::function<void(TimeWindow&)>& change) {
  for (TimeWindow& each : windows_) {
    change(each);
    if (hold_) hold_(each);
  }
  emit moved();
}

void CurveStack::advance(double newest_s) {
  for (TimeWindow& each : windows_) each.advance(newest_s);
}

void CurveStack::setCursor_s(double time_s) {
  cursor_s_ = time_s;
  emit moved();
}

void CurveStack::setMark(Mark which, double time_s) {
  marks_s_[static_cast<std::size_t>(which)] = time_s;
  marks_changed_ = true;
  mark_label_->setText(markText());
  mark_label_->setVisible(!mark_label_->text().isEmpty());
  emit moved();
}

void CurveStack::clearMarks() {
  setMark(Mark::a, std::numeric_limits<double>::quiet_NaN());
  setMark(Mark::b, std::numeric_limits<double>::quiet_NaN());
}

QString CurveStack::markText() const {
  const double a_s = mark_s(Mark::a);
  const double b_s = mark_s(Mark::b);
  QStringList parts;
  if (std::isfinite(a_s)) parts << tr("A %1").arg(quantityText(a_s, kTimeDecimals, tr("s")));
  if (std::isfinite(b_s)) parts << tr("B %1").arg(quantityText(b_s, kTimeDecimals, tr("s")));
  if (parts.size() == 2) {
    parts << tr("Δt %1").arg(quantityText(b_s - a_s, kTimeDecimals, tr("s")));
    if (b_s != a_s) parts << quantityText(1.0 / std::abs(b_s - a_s), 2, tr("Hz"));
  }
  return parts.join(QStringLiteral("    "));
}

QString CurveStack::markWords(std::size_t index, const CurveSource& source) const {
  const bool a = std::isfinite(mark_s(Mark::a));
  const bool b = std::isfinite(mark_s(Mark::b));
  if (!a && !b) return {};
  const StripSetup& setup = strips_[index].setup;
  QStringList parts;
  for (std::size_t entry = 0; entry < setup.channels.size(); ++entry) {
    const int decimals = setup.entries[entry].decimals;
    const double at_a = a ? source.valueAt(setup.channels[entry], mark_s(Mark::a)) : 0.0;
    const double at_b = b ? source.valueAt(setup.channels[entry], mark_s(Mark::b)) : 0.0;
    QString text = setup.entries[entry].label;
    if (!text.isEmpty()) text += QLatin1Char(' ');
    parts << text + numberText(a && b ? at_b - at_a : a ? at_a : at_b, decimals);
  }
  // The letter and the unit once: strips may be narrow.
  QString values = parts.join(QStringLiteral("  "));
  if (!setup.unit.isEmpty()) values += QLatin1Char(' ') + setup.unit;
  return (a && b ? tr("Δ %1") : a ? tr("A %1") : tr("B %1")).arg(values);
}

void CurveStack::holdRanges(bool hold) {
  for (const Strip& each : strips_) {
    each.strip->chooseRange(hold ? std::optional(each.strip->shownRange()) : std::nullopt);
  }
  emit moved();
}

bool CurveStack::following() const {
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    if (shown(i) && !window(i).following()) return false;
  }
  return true;
}

bool CurveStack::rangesHeld() const {
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    if (shown(i) && !strips_[i].strip->chosenRange()) return false;
  }
  return !strips_.empty();
}

void CurveStack::freeRanges() {
  for (const Strip& each : strips_) each.strip->freeRange();
}

void CurveStack::draw(const CurveSource& source) {
  std::vector<TimeMark> marks;
  if (std::isfinite(cursor_s_)) marks.push_back({.time_s = cursor_s_, .name = {}, .strong = true});
  if (std::isfinite(mark_s(Mark::a))) marks.push_back({.time_s = mark_s(Mark::a), .name = tr("A")});
  if (std::isfinite(mark_s(Mark::b))) marks.push_back({.time_s = mark_s(Mark::b), .name = tr("B")});
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    if (!shown(i)) continue;
    strips_[i].strip->setMarks(marks);
    if (marks_changed_) strips_[i].strip->setMarkWords(markWords(i, source));
    readCursor(i, source);
    strips_[i].strip->draw(source, window(i));
  }
  marks_changed_ = false;
}

double CurveStack::column_s() const {
  double least_s = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    if (!shown(i)) continue;
    least_s = std::min(least_s, window(i).span_s() / static_cast<double>(strips_[i].strip->columns()));
  }
  return least_s;
}

void CurveStack::readCursor(std::size_t index, const CurveSource& source) {
  const auto& [setup, strip, readout, row] = strips_[index];
  std::vector<double> values;
  if (std::isfinite(cursor_s_)) {
    for (const Trace& trace : setup.traces) values.push_back(source.valueAt(trace.channel, cursor_s_));
  }
  if (readsCursor(index)) {
    for (std::size_t entry = 0; entry < setup.channels.size(); ++entry) {
      const auto trace = std::ranges::find(setup.traces, setup.channels[entry], &Trace::channel);
      readout->setValue(entry, values[static_cast<std::size_t>(trace - setup.traces.begin())]);
    }
    readout->setWhen(tr("at %1").arg(quantityText(cursor_s_, kTimeDecimals, tr("s"))));
    readout->setNote({});
  }
  strip->setCursorValues(cursor_s_, std::move(values));
}

}  // namespace fyd::widgets
