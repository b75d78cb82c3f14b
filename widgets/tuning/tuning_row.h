// One parameter in a tuning panel: name, slider and field (or a choice), unit, mark when it differs from what is saved
// or is not yet confirmed by the station, and the ways back to the saved value and to the default. All of it comes from
// the parameter's description.
#pragma once

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "widgets/basics/theme.h"
#include "widgets/tuning/tuning_model.h"
#include "widgets/tuning/tuning_question_box.h"

namespace fyd::widgets {

enum class RowDetail {
  brief,  ///< what a narrow panel has room for; the rest in the tool tip
  full,   ///< help, and what was, is, is saved and is the default
};

class TuningRow : public QWidget {
  Q_OBJECT
 public:
  TuningRow(TuningModel& model, QString id, const QString& label, Quantity quantity, QWidget* parent = nullptr,
            RowDetail detail = RowDetail::brief);

  [[nodiscard]] const QString& id() const { return id_; }
  [[nodiscard]] QSlider* slider() const { return slider_; }
  [[nodiscard]] QLineEdit* field() const { return field_; }
  [[nodiscard]] QComboBox* choice() const { return choice_; }
  [[nodiscard]] QToolButton* resetButton() const { return reset_; }
  [[nodiscard]] QToolButton* revertButton() const { return revert_; }  ///< nullptr in a brief row
  [[nodiscard]] QLabel* mark() const { return mark_; }
  /// The doubt about a value entered here; nullptr: there was none yet.
  [[nodiscard]] TuningQuestionBox* questionBox() const { return question_; }
  /// A full row in a narrow place: the name above, slider and field below it. A brief row always has this layout.
  void setNarrow(bool narrow);
  /// Width in px that a full row needs to place name, usable slider and field side by side.
  [[nodiscard]] int wideWidth() const { return wide_px_; }
  [[nodiscard]] QString facts() const { return facts_ == nullptr ? QString() : facts_->text(); }

 signals:
  /// An entry was refused; the sentence says what is allowed.
  void refused(const QString& why, const QString& parameter);
  /// Enter ended an entry here: the focus is free to go.
  void entered();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QToolButton* buildBack(const QString& symbol, const QString& words);
  void buildNumber();
  void buildChoice();
  void layOutBrief(QGridLayout& grid);
  void layOutFull(QGridLayout& grid);
  void placeFull();
  QLabel* buildUnit(const QString& widest);
  void refresh();
  void refreshMark();
  void takeSlider(int position);
  void takeField();
  /// What was written and not taken is gone: the field shows the value in use again.
  void giveUpEntry();
  /// The field has something that is not taken: being written, or refused.
  [[nodiscard]] bool holdsAnEntry() const;
  void showQuestion();
  void markRefused(bool refused);
  [[nodiscard]] double toValue(int position) const;
  [[nodiscard]] int toPosition(double value) const;
  [[nodiscard]] const TunedParameter& parameter() const { return *model_.find(id_std_); }

  TuningModel& model_;
  QString id_;
  std::string id_std_;
  Quantity quantity_;
  double lower_ = 0.0;  ///< the slider's ends; the field takes the whole range
  double upper_ = 1.0;
  int steps_ = 400;  ///< of the slider; of a whole number at most as many as its values allow
  QLabel* name_ = nullptr;
  QLabel* mark_ = nullptr;
  QToolButton* reset_ = nullptr;
  QToolButton* revert_ = nullptr;
  bool narrow_ = false;
  int wide_px_ = 0;
  QLabel* unit_ = nullptr;
  QLabel* help_ = nullptr;
  QLabel* facts_ = nullptr;
  QSlider* slider_ = nullptr;
  QLineEdit* field_ = nullptr;
  TuningQuestionBox* question_ = nullptr;
  QComboBox* choice_ = nullptr;
};

}  // namespace fyd::widgets
