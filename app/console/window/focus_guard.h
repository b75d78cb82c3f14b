// Where the focus goes when the control that has it is hidden or may not be pressed any more. Qt gives it to the next
// control of the window, which may close or start something: here it stays in its panel, or goes where a key does no harm.
#pragma once

#include <QObject>
#include <QWidget>
#include <functional>

namespace fyd::console {

class FocusGuard : public QObject {
  Q_OBJECT
 public:
  /// @param harmless gets the focus that would leave its panel
  FocusGuard(std::function<QWidget*()> harmless, QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void moved(QWidget* from, QWidget* to);

  std::function<QWidget*()> harmless_;
  bool as_by_tab_ = false;  ///< the newest focus came as the Tab key gives it, which is how Qt moves it by itself
};

}  // namespace fyd::console
