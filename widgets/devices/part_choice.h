// Choice of one part's source: its kind in a list, and where the kind needs one, an address, a port or a file, which may
// be picked from what a search found. What is wrong with it stands below it.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <functional>
#include <vector>

namespace fyd::widgets {

/// One kind of source, and how its word is made: a prefix, and behind it the entry.
struct SourceKind {
  enum class Entry { none, text, found, file, folder };
  QString label;   ///< "Network (Modbus TCP)"
  QString prefix;  ///< "modbus-tcp:"; the whole word where there is no entry
  Entry entry = Entry::none;
  QString example;      ///< shown while the entry is empty
  QString missing;      ///< "Enter the touchpad's address, such as 192.168.0.7:502."
  QString file_filter;  ///< of the file dialog
  std::function<bool(const QString& word)> fits;
};

class PartChoice : public QWidget {
  Q_OBJECT
 public:
  /// @param name of the part, "Touchpad"; @param id "touchpad", for the names of its controls
  PartChoice(const QString& name, const QString& id, std::vector<SourceKind> kinds, QWidget* parent = nullptr);

  /// The first kind that it fits; none: nothing changes.
  void setWord(const QString& word);
  [[nodiscard]] QString word() const;
  /// What is still to be entered; empty: nothing.
  [[nodiscard]] QString missing() const;
  /// Ports or cameras that a search found, for the kinds that take one; an entry that was made stays.
  void offer(const QStringList& found);
  /// @param why it cannot be had, and the remedy; empty: it can
  void setProblem(const QString& why);
  [[nodiscard]] QString problem() const { return problem_->text(); }
  /// The cursor goes to the entry, or to the kind where there is none.
  void takeFocus();

  [[nodiscard]] QComboBox* kind() const { return kind_; }
  [[nodiscard]] QComboBox* entry() const { return entry_; }
  [[nodiscard]] QToolButton* browseButton() const { return browse_; }

 signals:
  void changed();

 private:
  [[nodiscard]] const SourceKind& chosen() const;
  void showKind();
  void takeKind();
  void browse();

  std::vector<SourceKind> kinds_;
  std::vector<QString> entries_;  ///< what stood in each kind's entry when another kind was chosen
  std::size_t shown_ = 0;         ///< the kind whose entry is shown
  QStringList found_;
  QComboBox* kind_ = nullptr;
  QComboBox* entry_ = nullptr;
  QToolButton* browse_ = nullptr;
  QLabel* problem_ = nullptr;
};

}  // namespace fyd::widgets
