// Panel for auto-tune: start and cancel, progress, the proposal beside the present values. Nothing
// is applied by this panel; Accept only says that the operator wants it.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <vector>

namespace fyd::widgets {

struct ProposalLine {
  QString id;
  QString unit;
  double present = 0.0;
  double proposed = 0.0;
};

class TuningProposal : public QWidget {
  Q_OBJECT
 public:
  explicit TuningProposal(QWidget* parent = nullptr);
  /// Data sources for identifying the cloth; the first is chosen.
  void setSources(const QStringList& names);
  [[nodiscard]] int source() const { return source_->currentIndex(); }

  void showRunning(bool running);
  void showProgress(double done);
  /// @param identified the identified model of cloth and sensors, as text
  void showProposal(const std::vector<ProposalLine>& lines, const QString& identified);
  /// Removes the proposal; the text says why.
  void clear(const QString& words);
  /// What it is for, where there is nothing else to say.
  [[nodiscard]] static QString purpose();

  [[nodiscard]] bool hasProposal() const { return accept_->isEnabled(); }
  [[nodiscard]] QTableWidget* table() const { return table_; }
  [[nodiscard]] QComboBox* sources() const { return source_; }
  [[nodiscard]] QPushButton* startButton() const { return start_; }
  [[nodiscard]] QPushButton* cancelButton() const { return cancel_; }
  [[nodiscard]] QPushButton* acceptButton() const { return accept_; }
  [[nodiscard]] QPushButton* discardButton() const { return discard_; }
  [[nodiscard]] QProgressBar* progress() const { return progress_; }
  [[nodiscard]] QString words() const { return words_->text(); }

 signals:
  void startAsked(int source);
  void cancelAsked();
  void acceptAsked();
  void discardAsked();

 private:
  QComboBox* source_ = nullptr;
  QPushButton* start_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* words_ = nullptr;
  QTableWidget* table_ = nullptr;
  QPushButton* accept_ = nullptr;
  QPushButton* discard_ = nullptr;
};

}  // namespace fyd::widgets
