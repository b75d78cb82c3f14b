// A line above the page that says what to do next, with the buttons for it; where a way has several steps, those that are
// done are ticked and the present one is strong. It covers nothing and can be closed.
#pragma once

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <functional>
#include <vector>

namespace fyd::widgets {

class GuideStrip : public QFrame {
  Q_OBJECT
 public:
  struct Step {
    QString words;
    bool done = false;
    friend bool operator==(const Step&, const Step&) = default;
  };
  struct Action {
    QString id;  ///< name of its button
    QString words;
    std::function<void()> run;
  };

  /// @param name what it is, for the screen reader
  explicit GuideStrip(const QString& name, QWidget* parent = nullptr);

  /// @param current step; as many as there are steps: none. Equal words keep their buttons, and the focus in them.
  void setGuide(const std::vector<Step>& steps, std::size_t current, const QString& advice,
                const std::vector<Action>& actions);
  /// The focus goes to the present step's first button.
  void takeFocus();
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  [[nodiscard]] std::size_t current() const { return current_; }
  [[nodiscard]] QString advice() const { return advice_->text(); }
  /// null: the present step has no such button
  [[nodiscard]] QPushButton* button(const QString& id) const { return findChild<QPushButton*>(id); }
  [[nodiscard]] QToolButton* closeButton() const { return close_; }

 signals:
  void closeAsked();

 private:
  void rebuildSteps();
  void rebuildActions(const std::vector<Action>& actions);

  std::vector<Step> steps_;
  std::size_t current_ = 0;
  QStringList action_ids_;
  QHBoxLayout* step_row_ = nullptr;
  QHBoxLayout* action_row_ = nullptr;
  QWidget* step_body_ = nullptr;
  QWidget* action_body_ = nullptr;
  QLabel* advice_ = nullptr;
  QToolButton* close_ = nullptr;
};

}  // namespace fyd::widgets
