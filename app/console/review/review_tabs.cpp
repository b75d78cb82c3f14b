#include "app/console/review/review_tabs.h"

#include <QVBoxLayout>
#include <cmath>

#include "widgets/basics/core_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console {
namespace {

using widgets::kGrid;
using widgets::Severity;

constexpr int kAtLeast = 44 * kGrid;  // every tab
constexpr int kAtMost = 50 * kGrid;   // every column of the touches

}  // namespace

ReviewTabs::ReviewTabs(const PageContext& context, widgets::ProgressBars* bars, ReviewExports* exports, QWidget* parent)
    : QTabWidget(parent),
      context_(context),
      exports_(exports),
      touch_table_(new TouchTable(this)),
      card_(new QToolButton(this)),
      figures_table_(new FiguresTable(this)),
      what_if_(new WhatIfPanel(bars, this)),
      comparison_(new ReviewComparison(bars, this)),
      export_panel_(new ExportPanel(exports, this)),
      touch_search_(bars),
      figures_work_(bars) {
  setMinimumWidth(kAtLeast);
  setMaximumWidth(kAtMost);
  setDocumentMode(true);
  addTab(buildTouches(), tr("Touches"));
  addTab(figures_table_, tr("A – B"));
  addTab(what_if_, tr("What if"));
  addTab(comparison_, tr("Compare"));
  addTab(export_panel_, tr("Export"));
}

QWidget* ReviewTabs::buildTouches() {
  auto* out = new QWidget(this);
  auto* layout = new QVBoxLayout(out);
  layout->setContentsMargins(0, 0, 0, kGrid);
  layout->setSpacing(kGrid);
  layout->addWidget(touch_table_, 1);
  card_->setObjectName(QStringLiteral("card_button"));
  card_->setText(tr("Make a gesture card of this touch"));
  card_->setToolTip(tr("A small file beside the recording, which the simulated finger plays (G)"));
  card_->setEnabled(false);
  connect(card_, &QToolButton::clicked, this, &ReviewTabs::makeCard);
  connect(touch_table_, &QTableWidget::currentCellChanged, this,
          [this] { card_->setEnabled(touch_table_->chosen() != nullptr); });
  layout->addWidget(card_, 0, Qt::AlignHCenter);
  return out;
}

void ReviewTabs::open(const ShownRecording& shown) {
  shown_ = shown;
  clearFigures();
  showTouches({});
  what_if_->setRecording(shown);
  findTouches();
}

void ReviewTabs::close() {
  touch_search_.drop();
  figures_work_.drop();
  what_if_->setRecording({});
  comparison_->clear();
  export_panel_->clear();
}

void ReviewTabs::showTouches(const std::vector<exports::Touch>& touches) {
  touch_table_->setTouches(touches);
  comparison_->setTouches(touches);
  emit touchesChanged(touches);
}

void ReviewTabs::findTouches() {
  touch_table_->setEmptyText(tr("Looking for touches …"));
  touch_search_.look(shown_.path, [this](const auto& found) {
    touch_table_->setEmptyText(found ? tr("The finger never pressed in this session.")
                               : touch_search_.cancelled()
                                   ? tr("The search was cancelled. Open the session again to look for touches.")
                                   : widgets::coreText(found.error().message));
    if (found) showTouches(*found);
  });
}

void ReviewTabs::makeCard() {
  if (const exports::Touch* touch = touch_table_->chosen()) {
    exports_->exportCard(*touch, touch_table_->currentRow() + 1);
  } else {
    context_.tell(Severity::information, tr("Choose a touch in the list first."));
  }
}

void ReviewTabs::showFigures(double a_s, double b_s) {
  setCurrentWidget(figures_table_);
  if (!std::isfinite(a_s) || !std::isfinite(b_s)) return;
  using Figures = Result<std::vector<StretchFigures>>;
  const auto work = [this, shown = shown_, a_s, b_s](const recording::Progress& progress) {
    auto figures = std::make_shared<Figures>(guarded([&]() -> Figures {
      auto opened = shown.open();
      return opened ? figuresBetween(**opened, a_s, b_s, progress) : Figures(tl::unexpected(opened.error()));
    }));
    return [this, figures, a_s, b_s] {
      if (*figures) {
        figures_table_->setFigures(**figures, b_s - a_s);
        return;
      }
      figures_table_->clearFigures();  // those shown belong to former marks
      if (!figures_work_.cancelled()) {
        context_.tell(Severity::warning, widgets::coreText(figures->error().message));
      }
    };
  };
  figures_work_.run(tr("Reckoning between A and B"), work);
}

void ReviewTabs::clearFigures() {
  figures_work_.drop();
  figures_table_->clearFigures();
}

}  // namespace fyd::console
