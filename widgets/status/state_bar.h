// Top of the window: the safety state in word, colour and shape, why and what to do, since when; the parts and the link
// in words; the recording, Tare, the arming button that must be held, and Stop.
#pragma once

#include <QElapsedTimer>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <vector>

#include "core/pipeline/safety.h"
#include "widgets/basics/hold_button.h"
#include "widgets/status/part_list.h"
#include "widgets/status/record_button.h"

namespace fyd::widgets {

class StateBar : public QFrame {
  Q_OBJECT
 public:
  explicit StateBar(QWidget* parent = nullptr);

  void showState(pipeline::SafetyState state, pipeline::Fault fault);
  /// Whether the haptic loop sends no telemetry: the state shown may then be outdated.
  void showSilence(bool silent);
  void showParts(const std::vector<PartView>& parts) { parts_->setParts(parts); }

  [[nodiscard]] PartList* parts() const { return parts_; }
  [[nodiscard]] HoldButton* armButton() const { return arm_; }
  [[nodiscard]] QPushButton* stopButton() const { return stop_; }
  [[nodiscard]] RecordButton* recordButton() const { return record_; }
  [[nodiscard]] QPushButton* tareButton() const { return tare_; }
  [[nodiscard]] QString stateWord() const { return word_->text(); }
  [[nodiscard]] QString stateReason() const { return why_->text(); }

 signals:
  void stopAsked();
  void armAsked();
  void tareAsked();

 private:
  void refresh();
  void refreshSince();

  pipeline::SafetyState state_ = pipeline::SafetyState::disconnected;
  pipeline::Fault fault_ = pipeline::Fault::none;
  bool known_ = false;
  bool silent_ = false;
  QElapsedTimer since_;
  QTimer since_timer_;
  QLabel* shape_;
  QLabel* word_;
  QLabel* since_label_;
  QLabel* why_;
  PartList* parts_;
  RecordButton* record_;
  QPushButton* tare_;
  HoldButton* arm_;
  QPushButton* stop_;
};

}  // namespace fyd::widgets
