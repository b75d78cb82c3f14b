// The bar above a recording: back to the list, play, speed, the cursor's time, what the recording is, recover.
#pragma once

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "app/console/review/review_player.h"
#include "widgets/basics/time_field.h"

namespace fyd::console {

class ReviewBar : public QWidget {
  Q_OBJECT
 public:
  /// @param player is played and paused by it; outlives it
  ReviewBar(ReviewPlayer& player, QWidget* parent);
  void setTime(double time_s);
  void setTitle(const QString& title);
  [[nodiscard]] QString title() const { return title_->text(); }
  /// At its right end.
  void addButton(QToolButton* button) { layout_->addWidget(button); }
  [[nodiscard]] widgets::TimeField* timeField() const { return time_field_; }
  [[nodiscard]] QToolButton* recoverButton() const { return recover_; }

 signals:
  void listAsked();

 private:
  void addPlaying(ReviewPlayer& player);

  QHBoxLayout* layout_ = nullptr;
  QLabel* time_ = nullptr;
  widgets::TimeField* time_field_ = nullptr;
  QLabel* title_ = nullptr;
  QToolButton* recover_ = nullptr;
};

}  // namespace fyd::console
