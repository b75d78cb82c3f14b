// Devices that a search found on this computer: each with its persistent path, what it can be used as and, where it
// cannot be opened, why and what to do. Empty, it says what was looked for and what works without a device.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QString>
#include <QVBoxLayout>
#include <vector>

namespace fyd::widgets {

struct FoundRow {
  enum class Use { touchpad, motors, camera };
  QString kind;                ///< "Serial port", "Camera"
  QString name;                ///< maker, model, serial number; may be empty
  QString path;                ///< to open it by
  QString problem;             ///< empty: it can be opened
  std::vector<Use> uses = {};  ///< what it can be to the session
};

class FoundList : public QFrame {
  Q_OBJECT
 public:
  explicit FoundList(QWidget* parent = nullptr);

  /// A search is under way. @param what is looked at now; @param part 0…1 of it done
  void showProgress(const QString& what, double part);
  void setFound(const std::vector<FoundRow>& rows);

  [[nodiscard]] QPushButton* lookButton() const { return look_; }
  [[nodiscard]] QString summary() const { return summary_->text(); }
  [[nodiscard]] int count() const { return count_; }

 signals:
  void lookAsked();
  void useAsked(fyd::widgets::FoundRow::Use as, const QString& path);

 private:
  void addRow(const FoundRow& row);
  QLabel* summary_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* look_ = nullptr;
  QWidget* body_ = nullptr;
  QVBoxLayout* layout_ = nullptr;
  int count_ = 0;
};

}  // namespace fyd::widgets
