// Notices slide in over the lower left of a window, below the readiness list, do not take the focus and stay until they
// are dismissed.
#pragma once

#include <QFrame>
#include <QPropertyAnimation>
#include <QString>
#include <QVBoxLayout>
#include <QWidget>

namespace fyd::widgets {

enum class Severity { information, warning, error };
[[nodiscard]] QString severityWord(Severity severity);

class NoticeStack : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kMost = 3;  ///< shown at once; the rest is in the log

  explicit NoticeStack(QWidget* over);
  /// A notice with the same text as one still shown is counted there instead of shown again.
  void post(Severity severity, const QString& text);
  void dismissAll();
  [[nodiscard]] int count() const { return layout_->count(); }
  [[nodiscard]] QString text(int index) const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  void dismiss(QWidget* notice);
  QVBoxLayout* layout_;
  QPropertyAnimation* slide_;
};

}  // namespace fyd::widgets
