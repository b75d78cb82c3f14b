// Describes a recording before it starts: operator, subject's code, tags, notes, file. While it runs: its file, a
// line for notes, and the button that ends it. An invalid entry is marked, with what is expected.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QToolButton>
#include <functional>

#include "widgets/status/recording_view.h"

namespace fyd::widgets {

class RecordingForm : public QFrame {
  Q_OBJECT
 public:
  explicit RecordingForm(QWidget* parent = nullptr);

  void setEntries(const RecordingEntries& entries);
  [[nodiscard]] RecordingEntries entries() const;
  /// A file name for a subject; used until the operator writes one.
  void setSuggestion(std::function<QString(const QString& subject)> suggest);
  /// A new file name: the present one has been used, or time has passed.
  void suggest();
  [[nodiscard]] bool fileIsSuggested() const { return !file_is_own_; }
  void setRecording(const RecordingView& view);
  /// The disk is waited for: nothing is started or ended meanwhile.
  void setWaiting(bool waiting);
  /// Gives the focus to what comes next: the operator's field while it is empty, else the button that starts or ends.
  void focusNext();

  [[nodiscard]] QLineEdit* operatorField() const { return operator_; }
  [[nodiscard]] QLineEdit* subjectField() const { return subject_; }
  [[nodiscard]] QLineEdit* tagsField() const { return tags_; }
  [[nodiscard]] QPlainTextEdit* notesField() const { return notes_; }
  [[nodiscard]] QLineEdit* fileField() const { return file_; }
  [[nodiscard]] QLineEdit* noteField() const { return note_; }
  [[nodiscard]] QPushButton* startButton() const { return start_; }
  [[nodiscard]] QPushButton* stopButton() const { return stop_; }
  [[nodiscard]] QString hint() const { return hint_->text(); }

 signals:
  void startAsked(const fyd::widgets::RecordingEntries& entries);
  void stopAsked();
  /// Its field is to be cleared once it is written: words that were refused stay.
  void noteAsked(const QString& text);

 private:
  void build();
  void start();
  void sayNote();
  void mark(EntryProblem::Field field);
  /// On the button that can be pressed, or on the form while none can.
  void keepFocus();
  void say(const QString& words, const char* role);
  [[nodiscard]] QWidget* widgetOf(EntryProblem::Field field) const;
  void chooseFile();

  RecordingView view_;
  std::function<QString(const QString&)> suggest_;
  bool file_is_own_ = false;  ///< written by the operator
  bool waiting_ = false;
  QLineEdit* operator_ = nullptr;
  QLineEdit* subject_ = nullptr;
  QLineEdit* tags_ = nullptr;
  QPlainTextEdit* notes_ = nullptr;
  QLineEdit* file_ = nullptr;
  QToolButton* browse_ = nullptr;
  QWidget* before_ = nullptr;
  QWidget* during_ = nullptr;
  QLabel* figures_ = nullptr;
  QLineEdit* note_ = nullptr;
  QLabel* hint_ = nullptr;
  QPushButton* start_ = nullptr;
  QPushButton* stop_ = nullptr;
};

}  // namespace fyd::widgets
