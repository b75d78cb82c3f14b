// One device as an operator reads it: which it is, whether it answers and what to do if not, rate, age, errors by kind,
// live values, a camera's controls, and buttons for small tests that last only while they are held.
#pragma once

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QString>
#include <QVBoxLayout>
#include <vector>

#include "core/device/device_report.h"
#include "widgets/basics/hold_button.h"

namespace fyd::widgets {

class DeviceCard : public QFrame {
  Q_OBJECT
 public:
  explicit DeviceCard(QWidget* parent = nullptr);

  void setReport(const device::DeviceReport& report);
  /// Buttons for tests, by their words; their place in the list is their number. None: they are hidden, until given
  /// again.
  void setTests(const QStringList& words);
  /// @param why said below the buttons while they are not allowed
  void allowTests(bool allowed, const QString& why);
  /// State of the present or the last test; empty: none yet.
  void showTest(const QString& words);

  [[nodiscard]] QString stateWord() const { return state_->text(); }
  [[nodiscard]] QString problem() const { return problem_->isHidden() ? QString() : problem_->text(); }
  /// What stands beside a label: a figure, a value, a counter or a control. Empty when there is no such row.
  [[nodiscard]] QString value(const QString& label) const;
  [[nodiscard]] HoldButton* testButton(int test) const { return tests_[static_cast<std::size_t>(test)]; }
  [[nodiscard]] QString testText() const { return test_words_->text(); }
  /// Number of columns of live values, depending on the width.
  [[nodiscard]] int valueColumns() const { return values_.columns; }

 signals:
  void testHeld(int test);
  void testLetGo();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Row {
    QLabel* label;
    QLabel* value;
  };
  struct Entry {
    QString label;
    QString value;
  };
  /// A titled list of rows that grows and shrinks with what the device tells.
  struct Section {
    QLabel* title = nullptr;
    QGridLayout* grid = nullptr;
    int columns = 1;
    std::vector<Row> rows;
  };

  void build();
  Section section(const QString& title);
  void fill(Section& section, const std::vector<Entry>& entries);
  void showState(bool ok);
  [[nodiscard]] static std::vector<Entry> figures(const device::DeviceReport& report);
  [[nodiscard]] static std::vector<Entry> controls(const device::DeviceReport& report);

  bool ok_ = false;
  bool allowed_ = false;
  QString why_not_;
  QString test_;
  QVBoxLayout* layout_ = nullptr;
  QLabel* symbol_ = nullptr;
  QLabel* name_ = nullptr;
  QLabel* kind_ = nullptr;
  QLabel* shape_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* description_ = nullptr;
  QLabel* problem_ = nullptr;
  Section figures_;
  Section values_;
  Section errors_;
  Section controls_;
  QWidget* test_area_ = nullptr;
  QLabel* test_words_ = nullptr;
  std::vector<HoldButton*> tests_;
  std::vector<Entry> shown_values_;
};

}  // namespace fyd::widgets
