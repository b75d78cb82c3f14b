// Notices in a strip of fixed height that covers nothing: the newest is shown, those below it one press away. They do
// not take the focus, and stay until they are read or withdrawn because their cause is gone.
#pragma once

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QString>
#include <QToolButton>
#include <functional>
#include <vector>

namespace fyd::widgets {

enum class Severity { information, warning, error };
[[nodiscard]] QString severityWord(Severity severity);

/// What the operator may do about a notice, as a button in it.
struct NoticeAction {
  QString name;  ///< of the button, for tests
  QString text;
  std::function<void()> run;
};

struct Notice {
  Severity severity = Severity::information;
  QString text;
  QString cause;  ///< what `withdraw` names; empty: it stays until it is read
  std::vector<NoticeAction> actions;
};

class NoticeStack : public QFrame {
  Q_OBJECT
 public:
  static constexpr int kMost = 9;  ///< unread at once; the rest is in the log

  explicit NoticeStack(QWidget* parent = nullptr);
  /// A notice with the same text as an unread one is counted there.
  void post(Notice notice);
  void post(Severity severity, const QString& text) {
    post({.severity = severity, .text = text, .cause = {}, .actions = {}});
  }
  /// The cause is gone: its notices leave unread.
  void withdraw(const QString& cause);
  void dismissAll();
  /// Whether a notice of this cause is unread.
  [[nodiscard]] bool shows(const QString& cause) const;
  [[nodiscard]] int count() const { return static_cast<int>(unread_.size()); }
  /// From the oldest.
  [[nodiscard]] QString text(int index) const { return unread_[static_cast<std::size_t>(index)].notice.text; }
  [[nodiscard]] QString shownText() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Unread {
    Notice notice;
    int times = 1;
  };
  void dismissShown();
  void showNext();
  void dropOne();
  void refresh();
  void fitText();

  std::vector<Unread> unread_;  // from the oldest
  std::size_t shown_ = 0;
  QLabel* symbol_ = nullptr;
  QLabel* label_ = nullptr;
  QHBoxLayout* actions_ = nullptr;
  QToolButton* more_ = nullptr;
  QToolButton* close_ = nullptr;
};

}  // namespace fyd::widgets
