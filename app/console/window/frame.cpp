#include "app/console/window/frame.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <string>

#include "app/console/window/places.h"
#include "widgets/basics/theme.h"

namespace fyd::console {

using widgets::kGrid;

namespace {

/// Only the shown page may claim its size, so that a hidden wide page does not widen the window.
void claimSize(Page& page, bool claims) {
  const auto policy = claims ? QSizePolicy::Preferred : QSizePolicy::Ignored;
  page.setSizePolicy(policy, policy);
}

constexpr int kLeastPlace_px = 440;  // height of a place that is still used without scrolling inside it

/// A scroll area takes the preferred height for its width as the least: this one has none, so that a low window
/// shrinks lists and plots before anything scrolls away.
class ShrinkingLayout : public QVBoxLayout {
 public:
  using QVBoxLayout::QVBoxLayout;
  [[nodiscard]] bool hasHeightForWidth() const override { return false; }
};

/// The places as large as the area; larger, and scrolled, where it is smaller than what the shown one needs.
QScrollArea* scrolled(QStackedWidget* stack) {
  auto* places = new QWidget;
  places->setMinimumHeight(kLeastPlace_px);
  auto* layout = new ShrinkingLayout(places);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(stack);
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);  // the focus goes to the controls in it
  area->setWidget(places);
  return area;
}

}  // namespace

Frame::Frame(const PageContext& context, CommandRegistry& commands, QWidget* parent)
    : QWidget(parent),
      commands_(commands),
      strips_(new QVBoxLayout),
      navigation_bar_(new widgets::NavigationBar(this)),
      state_bar_(new widgets::StateBar(this)),
      notices_(new widgets::NoticeStack(this)),
      panel_area_(new QMainWindow(this)),
      stack_(new QStackedWidget(this)) {
  auto* group = new QActionGroup(this);
  for (const PlaceInfo& info : places()) {
    const QString id = QLatin1String(info.id);
    const std::string command = std::string("place.") + info.id;
    QAction* action =
        commands_.add({command.c_str(), "View", info.word, info.icon, info.keys, true}, [this, id](bool) { go(id); });
    group->addAction(action);
    navigation_bar_->add(action);
    Page* page = info.make(context, stack_);
    stack_->addWidget(page);
    claimSize(*page, false);
    pages_[id] = page;
    PlaceCommands own(commands_, id);
    page->addCommands(own);
  }
  auto* column = new QVBoxLayout;
  column->setSpacing(kGrid);
  column->addWidget(state_bar_);
  column->addLayout(strips_);
  column->addWidget(panel_area_, 1);
  column->addWidget(notices_);
  panel_area_->setWindowFlags(Qt::Widget);  // a part of the window, not one of its own
  area_ = scrolled(stack_);
  panel_area_->setCentralWidget(area_);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addWidget(navigation_bar_);
  layout->addLayout(column, 1);
}

void Frame::addStrip(widgets::GuideStrip* strip) {
  strips_->addWidget(strip);
  setTabOrder(state_bar_->stopButton(), strip->closeButton());  // where it is seen: between the bar and the place
}

void Frame::go(const QString& place) {
  const auto wanted = pages_.find(place);
  if (wanted == pages_.end() || place == place_) return;
  if (Page* former = page(place_)) {
    former->leave();
    claimSize(*former, false);
  }
  place_ = place;
  claimSize(*wanted->second, true);
  stack_->setCurrentWidget(wanted->second);
  for (QScrollBar* bar : {area_->verticalScrollBar(), area_->horizontalScrollBar()}) bar->setValue(0);
  commands_.showPlace(place);
  commands_.action(QStringLiteral("place.") + place)->setChecked(true);
  wanted->second->enter();
}

QWidget* Frame::placeButton() const {
  const QAction* action = commands_.action(QStringLiteral("place.") + place_);
  for (auto* button : navigation_bar_->findChildren<QToolButton*>()) {
    if (button->defaultAction() == action) return button;
  }
  return navigation_bar_;
}

Page* Frame::page(const QString& place) const {
  const auto found = pages_.find(place);
  return found == pages_.end() ? nullptr : found->second;
}

}  // namespace fyd::console
