#include "widgets/basics/progress_bar.h"

#include <QHBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr int kPatience_ms = 300;
constexpr int kBarWidth = 24 * kGrid;
constexpr int kWordsWidth = 30 * kGrid;
constexpr double kEnoughToGoBy_s = 5.0;

}  // namespace

ProgressBar::ProgressBar(QWidget* parent)
    : QWidget(parent),
      words_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      share_(new QLabel(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  words_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  words_->setMinimumWidth(kWordsWidth);
  words_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  progress_->setFixedSize(kBarWidth, kGrid);
  share_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  share_->setMinimumWidth(share_->fontMetrics().horizontalAdvance(shareText(99, 60.0)));  // the bar stays in place
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(kGrid, 0, kGrid, 0);
  layout->setSpacing(kGrid);
  layout->addWidget(words_, 1);
  layout->addWidget(progress_);
  layout->addWidget(share_);
  layout->addWidget(cancel_);
  patience_.setSingleShot(true);
  patience_.setInterval(kPatience_ms);
  connect(&patience_, &QTimer::timeout, this, [this] {
    show();
    emit shownChanged();
  });
  connect(cancel_, &QPushButton::clicked, this, &ProgressBar::cancel);
  hide();
}

void ProgressBar::begin(const QString& words) {
  static int begun = 0;
  number_ = ++begun;
  running_ = true;
  asked_ = false;
  cancel_->setEnabled(true);
  describe(words);
  cancel_->setAccessibleName(tr("Cancel: %1").arg(words));
  progress_->setValue(0);
  share_->setText(shareText(0, 0.0));
  patience_.start();
  since_.start();
}

void ProgressBar::describe(const QString& words) {
  words_->setText(words);
  words_->setToolTip(words);
  progress_->setAccessibleName(words);
}

void ProgressBar::setDone(double share) {
  if (!running_ || !std::isfinite(share)) return;
  const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
  progress_->setValue(std::max(percent, progress_->value()));
  share_->setText(shareText(progress_->value(), 1e-3 * static_cast<double>(since_.elapsed())));
}

QString ProgressBar::shareText(int percent, double elapsed_s) {
  QString share = tr("%1 %").arg(percent);
  if (percent < 1 || percent > 99 || !(elapsed_s >= kEnoughToGoBy_s)) return share;
  const double left_s = elapsed_s * (100 - percent) / percent;
  constexpr double kMinute_s = 60.0;
  return left_s < kMinute_s ? tr("%1 · less than 1 min left").arg(share)
                            : tr("%1 · %2 min left").arg(share, numberText(std::ceil(left_s / kMinute_s), 0));
}

void ProgressBar::end() {
  running_ = false;
  patience_.stop();
  hide();
  emit shownChanged();
}

void ProgressBar::cancel() {
  if (!running_ || asked_) return;
  asked_ = true;
  cancel_->setEnabled(false);
  describe(tr("Cancelling: %1").arg(words()));
  emit cancelAsked();
}

ProgressBars::ProgressBars(QString keys, QWidget* parent) : QWidget(parent), keys_(std::move(keys)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid / 2);
  hide();
}

ProgressBar* ProgressBars::add() {
  auto* bar = new ProgressBar(this);
  bar->cancelButton()->setToolTip(tr("Cancel the newest with %1").arg(keys_));
  layout()->addWidget(bar);
  connect(bar, &ProgressBar::shownChanged, this, &ProgressBars::showIfNeeded);
  return bar;
}

std::vector<ProgressBar*> ProgressBars::running() const {
  std::vector<ProgressBar*> out;
  for (ProgressBar* bar : findChildren<ProgressBar*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (bar->running()) out.push_back(bar);
  }
  std::ranges::stable_sort(out, {}, &ProgressBar::number);
  return out;
}

bool ProgressBars::cancelNewest() {
  const auto bars = running();
  for (auto bar = bars.rbegin(); bar != bars.rend(); ++bar) {
    if (!(*bar)->cancelButton()->isEnabled()) continue;  // was cancelled already
    (*bar)->cancel();
    return true;
  }
  return false;
}

void ProgressBars::showIfNeeded() {
  const auto bars = running();
  setVisible(std::ranges::any_of(bars, [](const ProgressBar* bar) { return !bar->isHidden(); }));
}

}  // namespace fyd::widgets
