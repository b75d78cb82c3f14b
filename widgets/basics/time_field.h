// A field that goes to a time: "83.5", "1:23.5". What cannot be taken is said at the field, and stays there to be mended.
#pragma once

#include <QLineEdit>
#include <functional>
#include <utility>

namespace fyd::widgets {

class TimeField : public QLineEdit {
  Q_OBJECT
 public:
  /// First and last time that there is, s; not finite: none.
  using Span = std::function<std::pair<double, double>()>;
  explicit TimeField(QWidget* parent = nullptr);
  void setSpan(Span span) { span_ = std::move(span); }
  /// Why the last entry was not taken; empty: it was.
  [[nodiscard]] QString problem() const { return problem_; }

 signals:
  void asked(double time_s);

 private:
  void take();
  void say(const QString& problem);

  Span span_;
  QString problem_;
};

}  // namespace fyd::widgets
