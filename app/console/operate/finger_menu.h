// Menu for the motion of the simulated finger while no mouse moves it: the demonstration, or a gesture card or recorded
// hand, at a speed, once or repeated; the same as `--finger FILE`.
#pragma once

#include <QActionGroup>
#include <QMenu>
#include <QToolButton>
#include <optional>

#include "app/console/shell/background.h"
#include "app/console/shell/session.h"
#include "widgets/status/notice_stack.h"

namespace fyd::console {

class FingerMenu : public QToolButton {
  Q_OBJECT
 public:
  using Tell = std::function<void(widgets::Severity, const QString&)>;
  FingerMenu(Session& session, Tell tell, QWidget* parent = nullptr);

  void playDemonstration();
  /// A card with its own speed and repetition; read on its own thread. Errors are shown as a notice, and the finger
  /// continues as before.
  void playFile(const QString& path);
  /// By dialog.
  void chooseFile();

  [[nodiscard]] double speed() const;
  [[nodiscard]] bool again() const { return again_->isChecked(); }

 private:
  struct Hand {
    QString name;
    sim::FingerPath path;  ///< as recorded
    double speed = 1.0;    ///< as the file says
    bool again = true;
  };

  static Result<Hand> read(const QString& path);
  void take(const Hand& hand);
  void build();
  void setSpeed(double speed);
  void play();
  void show();

  Session& session_;
  Tell tell_;
  std::optional<Hand> hand_;  ///< the last one that was chosen
  bool demonstrates_ = true;
  QString folder_;
  QMenu* menu_ = nullptr;
  QMenu* speeds_ = nullptr;
  QActionGroup* what_ = nullptr;
  QActionGroup* speed_ = nullptr;
  QAction* demonstration_ = nullptr;
  QAction* recorded_ = nullptr;
  QAction* again_ = nullptr;
  Background reading_;
};

}  // namespace fyd::console
