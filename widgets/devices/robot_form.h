// Choice of the session's robot: the simulated one, none, one over the classic protocol, one over FYD Link with a key,
// or a scene instead of a robot. Nothing changes before "Reconnect" is pressed, and only while nothing can move.
#pragma once

#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

namespace fyd::widgets {

class RobotForm : public QFrame {
  Q_OBJECT
 public:
  explicit RobotForm(QWidget* parent = nullptr);

  /// @param names of the predictors that the simulated robot may have; the first is the default
  void setPredictors(const QStringList& names);
  /// @param robot "simulated[:PREDICTOR]", "none", "classic:HOST:PORT", "link:HOST:PORT" or "scene:FILE"; @param
  /// key_file of "link:"
  void setRobot(const QString& robot, const QString& key_file);
  /// Why the robot may not be changed now, and what to do; empty: it may.
  void setHindrance(const QString& why);
  /// A non-empty text replaces the hint; the button then cancels the work, where that is possible.
  void setWork(const QString& words, bool can_be_cancelled);

  [[nodiscard]] QString robot() const;    ///< as entered, in the words of setRobot
  [[nodiscard]] QString keyFile() const;  ///< empty unless FYD Link is chosen
  [[nodiscard]] QComboBox* kind() const { return kind_; }
  [[nodiscard]] QComboBox* predictor() const { return predictor_; }
  [[nodiscard]] QLineEdit* address() const { return address_; }
  [[nodiscard]] QLineEdit* key() const { return key_; }
  [[nodiscard]] QLineEdit* sceneFile() const { return scene_; }
  [[nodiscard]] QPushButton* reconnectButton() const { return reconnect_; }
  [[nodiscard]] QString hint() const { return hint_->text(); }

 signals:
  void reconnectAsked(const QString& robot, const QString& key_file);
  void cancelAsked();

 private:
  void refresh();
  void chooseFile(const QString& title, const QString& filter, QLineEdit* into);

  QString hindrance_;
  QString work_;
  bool can_be_cancelled_ = false;
  QComboBox* kind_ = nullptr;
  QLabel* predictor_label_ = nullptr;
  QComboBox* predictor_ = nullptr;
  QLabel* address_label_ = nullptr;
  QLineEdit* address_ = nullptr;
  QLabel* key_label_ = nullptr;
  QLineEdit* key_ = nullptr;
  QToolButton* browse_ = nullptr;
  QLabel* scene_label_ = nullptr;
  QLineEdit* scene_ = nullptr;
  QToolButton* browse_scene_ = nullptr;
  QLabel* hint_ = nullptr;
  QPushButton* reconnect_ = nullptr;
};

}  // namespace fyd::widgets
