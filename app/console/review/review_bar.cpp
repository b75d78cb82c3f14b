#include "app/console/review/review_bar.h"

#include <QComboBox>

#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console {

using widgets::kGrid;

ReviewBar::ReviewBar(ReviewPlayer& player, QWidget* parent)
    : QWidget(parent),
      layout_(new QHBoxLayout(this)),
      time_(new QLabel(this)),
      time_field_(new widgets::TimeField(this)),
      title_(new QLabel(this)),
      recover_(new QToolButton(this)) {
  layout_->setContentsMargins(kGrid, 0, kGrid, 0);
  layout_->setSpacing(kGrid);
  auto* back = new QToolButton(this);
  back->setText(tr("Sessions"));
  back->setToolTip(tr("The list of sessions (Ctrl+Shift+O)"));
  connect(back, &QToolButton::clicked, this, &ReviewBar::listAsked);
  layout_->addWidget(back);
  addPlaying(player);
  time_->setAccessibleName(tr("Cursor"));
  time_->setMinimumWidth(10 * kGrid);
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  title_->setObjectName(QStringLiteral("review_title"));
  title_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  title_->setMinimumWidth(0);
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  layout_->addWidget(time_);
  layout_->addWidget(time_field_);
  layout_->addWidget(title_, 1);
  recover_->setObjectName(QStringLiteral("recover_button"));
  recover_->setText(tr("Recover"));
  recover_->setToolTip(
      tr("Its recorder crashed, or it is damaged; what can be proven is shown. This makes the recording whole. Nothing "
         "is deleted."));
  recover_->setProperty("role", "warning");
  recover_->hide();
  layout_->addWidget(recover_);
}

void ReviewBar::addPlaying(ReviewPlayer& player) {
  auto* play = new QToolButton(this);
  play->setObjectName(QStringLiteral("play_button"));
  play->setText(tr("Play"));
  play->setToolTip(tr("Play or pause (Space)"));
  connect(play, &QToolButton::clicked, &player, &ReviewPlayer::togglePlaying);
  connect(&player, &ReviewPlayer::playingChanged, play,
          [play](bool playing) { play->setText(playing ? tr("Pause") : tr("Play")); });
  auto* chosen_speed = new QComboBox(this);
  chosen_speed->setObjectName(QStringLiteral("play_speed"));
  chosen_speed->setAccessibleName(tr("Speed of playing"));
  for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
    chosen_speed->addItem(tr("%1 ×").arg(widgets::plainNumber(speed)), speed);
  }
  chosen_speed->setCurrentIndex(3);
  connect(chosen_speed, &QComboBox::currentIndexChanged, &player,
          [&player, chosen_speed](int index) { player.setSpeed(chosen_speed->itemData(index).toDouble()); });
  layout_->addWidget(play);
  layout_->addWidget(chosen_speed);
}

void ReviewBar::setTime(double time_s) { time_->setText(tr("%1 s").arg(widgets::numberText(time_s, 3))); }

void ReviewBar::setTitle(const QString& title) {
  title_->setText(title);
  title_->setToolTip(title);
}

}  // namespace fyd::console
