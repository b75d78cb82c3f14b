// Top of the window: the safety state in word, colour and shape, why and what to do, since when; what is simulated; the
// parts and the link in words; the recording, Tare, the arming button that must be held, and Stop. Arm and Stop stand at
// the right end and have one size: where they are depends on the window's width only.
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
#include "widgets/status/simulated_badge.h"
#include "widgets/status/state_text.h"

namespace fyd::widgets {

class StateBar : public QFrame {
  Q_OBJECT
 public:
  explicit StateBar(QWidget* parent = nullptr);

  void showState(pipeline::SafetyState state, pipeline::Fault fault);
  /// How late this computer was when the state became Held, as a phrase; empty: on time. Forgotten with that state.
  void showLateness(const QString& lateness);
  /// Whether the haptic loop sends no telemetry: the state shown may then be outdated.
  void showSilence(bool silent);
  /// Another session begins: its state is not known yet, and its time begins anew.
  void restart();
  /// Whether there is no session: its devices could not be had, and others are to be chosen.
  void showClosed(bool closed);
  /// What arming would be refused for now. To be called often: what was said before the state changed is forgotten.
  void showMissing(const MissingNow& missing);
  void showParts(const std::vector<PartView>& parts);
  /// The motion that an operator's held button makes; empty: none. The motors are then on outside Active.
  void showMotion(const QString& motion);

  [[nodiscard]] PartList* parts() const { return parts_; }
  [[nodiscard]] HoldButton* armButton() const { return arm_; }
  [[nodiscard]] QPushButton* stopButton() const { return stop_; }
  [[nodiscard]] RecordButton* recordButton() const { return record_; }
  [[nodiscard]] QPushButton* tareButton() const { return tare_; }
  [[nodiscard]] SimulatedBadge* badge() const { return badge_; }
  [[nodiscard]] QString stateWord() const { return word_->text(); }
  [[nodiscard]] QString stateReason() const { return reason_; }
  [[nodiscard]] QString stateTime() const { return since_label_->text(); }

 signals:
  void stopAsked();
  void armAsked();
  void tareAsked();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void build();
  enum class Room { plenty, narrow, tight };
  void setRoom(Room room);
  [[nodiscard]] Room roomIn(int width) const;
  void refresh();
  void refreshSince();
  /// The state is not known any more, for the loop says nothing.
  [[nodiscard]] bool unknown() const { return known_ && !closed_ && silent_; }

  pipeline::SafetyState state_ = pipeline::SafetyState::disconnected;
  pipeline::Fault fault_ = pipeline::Fault::none;
  std::optional<MissingNow> missing_;
  QString lateness_;
  QString motion_;
  QString reason_;
  Room room_ = Room::plenty;
  int narrow_width_ = 0;  ///< px, that the narrow bar needs
  bool known_ = false;
  bool closed_ = false;
  bool silent_ = false;
  QElapsedTimer since_;
  QElapsedTimer silent_since_;
  QTimer since_timer_;
  QLabel* shape_ = nullptr;
  QLabel* word_ = nullptr;
  QLabel* since_label_ = nullptr;
  QLabel* why_ = nullptr;
  SimulatedBadge* badge_ = nullptr;
  PartList* parts_ = nullptr;
  RecordButton* record_ = nullptr;
  QPushButton* tare_ = nullptr;
  HoldButton* arm_ = nullptr;
  QPushButton* stop_ = nullptr;
};

}  // namespace fyd::widgets
