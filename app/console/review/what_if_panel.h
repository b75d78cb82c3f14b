// "What would other parameters have done?": runs the recorded inputs through the step again, off the window's thread.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>
#include <memory>

#include "app/console/review/review_source.h"
#include "app/console/review/shown_recording.h"
#include "app/console/shell/long_work.h"
#include "core/replay/replay.h"

namespace fyd::console {

class WhatIfPanel : public QWidget {
  Q_OBJECT
 public:
  explicit WhatIfPanel(widgets::ProgressBars* bars, QWidget* parent = nullptr);

  /// Empty: none. Drops the result of the former recording.
  void setRecording(const ShownRecording& shown);
  void run();
  [[nodiscard]] QString words() const { return words_->text(); }
  [[nodiscard]] QComboBox* parameter() const { return parameter_; }
  [[nodiscard]] QLineEdit* value() const { return value_; }
  [[nodiscard]] QPushButton* runButton() const { return run_; }
  [[nodiscard]] QPushButton* addButton() const { return add_; }
  [[nodiscard]] QListWidget* settings() const { return settings_; }

 signals:
  /// Curves in the order of kReviewQuantities; nullptr: none any more.
  void replayed(std::shared_ptr<const fyd::widgets::CurveBuffer> curves);

 private:
  void build();
  void addSetting();
  void finish(const Result<replay::ReplayResult>& result, std::shared_ptr<const widgets::CurveBuffer> curves);

  ShownRecording shown_;
  QComboBox* parameter_ = nullptr;
  QLineEdit* value_ = nullptr;
  QPushButton* add_ = nullptr;
  QListWidget* settings_ = nullptr;
  QCheckBox* closed_loop_ = nullptr;
  QPushButton* run_ = nullptr;
  QLabel* words_ = nullptr;
  LongWork work_;
};

}  // namespace fyd::console
