#include "widgets/tuning/tuning_list.h"

#include <QHBoxLayout>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/vertical_scroll.h"
#include "widgets/tuning/tuning_text.h"

namespace fyd::widgets {
namespace {

Quantity quantityOf(std::string_view id) {
  if (id.starts_with("control.")) return Quantity::stiffness;
  if (id.starts_with("texture.")) return Quantity::vibration;
  return Quantity::none;
}

}  // namespace

TuningList::TuningList(TuningModel& model, QWidget* parent)
    : QFrame(parent),
      model_(model),
      search_(new QLineEdit(this)),
      only_changed_(new QCheckBox(tr("Only what differs"), this)),
      summary_(new QLabel(this)),
      empty_(new QLabel(tr("No parameter is found so. The search looks at name, identifier, help and group."), this)),
      scroll_(makeVerticalScroll(this)) {
  setProperty("surface", "panel");
  setAccessibleName(tr("All live parameters"));
  search_->setObjectName(QStringLiteral("tuning_search"));
  search_->setPlaceholderText(tr("Search parameters"));
  search_->setAccessibleName(tr("Search parameters"));
  search_->setToolTip(
      tr("Words of the name, the identifier, the help or the group (Ctrl+F); Enter goes to the first that is found"));
  search_->setClearButtonEnabled(true);
  only_changed_->setObjectName(QStringLiteral("tuning_only_changed"));
  only_changed_->setToolTip(tr("Show only parameters that differ from the saved profile"));
  summary_->setProperty("role", "muted");
  summary_->setFont(textFont(TextSize::small));
  empty_->setWordWrap(true);
  empty_->setProperty("role", "muted");

  auto* head = new QHBoxLayout;
  head->setSpacing(kGrid);
  head->addWidget(search_, 1);
  head->addWidget(only_changed_);
  head->addWidget(summary_);
  auto* body = new QWidget(scroll_);
  auto* rows = new QVBoxLayout(body);
  rows->setContentsMargins(0, 0, kGrid, 0);
  rows->setSpacing(kGrid);
  rows->addWidget(empty_);
  addRows(rows);
  rows->addStretch(1);
  scroll_->setWidget(body);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addLayout(head);
  layout->addWidget(scroll_, 1);
  connect(search_, &QLineEdit::textChanged, this, &TuningList::filter);
  connect(search_, &QLineEdit::returnPressed, this, &TuningList::goToFirst);
  connect(only_changed_, &QCheckBox::toggled, this, &TuningList::filter);
  connect(&model_, &TuningModel::changed, this, [this] {
    if (only_changed_->isChecked()) filter();
  });
  filter();
}

void TuningList::addRows(QVBoxLayout* layout) {
  std::vector<const TunedParameter*> live;
  for (const TunedParameter& parameter : model_.parameters()) {
    if (parameter.info.info.live) live.push_back(&parameter);
  }
  // The gains first: they are what the step response beside the list is about.
  std::stable_partition(live.begin(), live.end(),
                        [](const TunedParameter* each) { return each->info.id.starts_with("control."); });
  QString room;
  for (const TunedParameter* parameter : live) {
    const Parameter& info = parameter->info;
    if (const QString title = moduleTitle(info.id); title != room) {
      room = title;
      auto* label = new QLabel(title, this);
      label->setFont(textFont(TextSize::normal, true));
      label->setContentsMargins(kGrid + kGrid / 2, groups_.empty() ? 0 : kGrid, 0, 0);
      layout->addWidget(label);
      groups_.push_back({.title = label, .rows = {}});
    }
    const QString id = QString::fromUtf8(info.id.data(), static_cast<qsizetype>(info.id.size()));
    auto* row = new TuningRow(model_, id, tunedName(info), quantityOf(info.id), this, RowDetail::full);
    connect(row, &TuningRow::refused, this, &TuningList::refused);
    connect(row, &TuningRow::entered, this, &TuningList::entered);
    layout->addWidget(row);
    rows_.push_back(row);
    groups_.back().rows.push_back(row);
  }
}

void TuningList::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  int widest_px = 0;
  for (const TuningRow* row : rows_) widest_px = std::max(widest_px, row->wideWidth());
  const int needed_px = widest_px + kGrid;
  const int bar_px = scroll_->verticalScrollBar()->sizeHint().width();
  for (TuningRow* row : rows_) row->setNarrow(scroll_->width() - bar_px < needed_px);
}

void TuningList::filter() {
  const bool only_changed = only_changed_->isChecked();
  int shown = 0;
  for (const Group& group : groups_) {
    bool any = false;
    for (TuningRow* row : group.rows) {
      const TunedParameter& parameter = *model_.find(row->id().toStdString());
      // A row that is being edited stays, also when its value has just become the saved one.
      const bool wanted = (!only_changed || parameter.changed() || row->isAncestorOf(focusWidget())) &&
                          tunedMatches(parameter.info, search_->text());
      row->setVisible(wanted);
      any = any || wanted;
      shown += wanted ? 1 : 0;
    }
    group.title->setVisible(any);
  }
  empty_->setVisible(shown == 0);
  summary_->setText(tr("%1 of %2").arg(shown).arg(static_cast<qsizetype>(rows_.size())));
}

void TuningList::goToFirst() {
  const auto found = std::ranges::find_if(rows_, [](const TuningRow* row) { return !row->isHidden(); });
  if (found == rows_.end()) return;
  QWidget* editor = (*found)->field();
  if (editor == nullptr) editor = (*found)->choice();
  editor->setFocus(Qt::TabFocusReason);  // which marks what a field holds
  scroll_->ensureWidgetVisible(*found);
}

TuningRow* TuningList::row(const QString& id) const {
  for (TuningRow* row : rows_) {
    if (row->id() == id) return row;
  }
  return nullptr;
}

int TuningList::shownCount() const {
  return static_cast<int>(std::ranges::count_if(rows_, [](const TuningRow* row) { return !row->isHidden(); }));
}

}  // namespace fyd::widgets
