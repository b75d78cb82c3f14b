#include "widgets/status/recording_form.h"

#include <QApplication>
#include <QFileDialog>
#include <QGridLayout>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QVBoxLayout>

#include "widgets/basics/theme.h"
#include "widgets/basics/undragged.h"

namespace fyd::widgets {
namespace {

/// Takes text only. Qt 6.4 ends the program when something without any text is pasted into a QPlainTextEdit: a click
/// with the middle button on a desktop where nothing was ever selected is enough.
class NoteEdit : public Undragged<QPlainTextEdit> {
 public:
  using Undragged::Undragged;

 protected:
  bool canInsertFromMimeData(const QMimeData* source) const override { return source != nullptr && source->hasText(); }
  void insertFromMimeData(const QMimeData* source) override {
    if (canInsertFromMimeData(source)) QPlainTextEdit::insertFromMimeData(source);
  }
};

}  // namespace

using Field = EntryProblem::Field;

RecordingForm::RecordingForm(QWidget* parent)
    : QFrame(parent),
      operator_(new QLineEdit(this)),
      subject_(new QLineEdit(this)),
      tags_(new QLineEdit(this)),
      notes_(new NoteEdit(this)),
      file_(new QLineEdit(this)),
      browse_(new QToolButton(this)),
      before_(new QWidget(this)),
      during_(new QWidget(this)),
      figures_(new QLabel(this)),
      note_(new QLineEdit(this)),
      hint_(new QLabel(this)),
      start_(new QPushButton(this)),
      stop_(new QPushButton(this)) {
  setProperty("surface", "panel");
  setAccessibleName(tr("Recording"));
  build();
  connect(start_, &QPushButton::clicked, this, &RecordingForm::start);
  connect(stop_, &QPushButton::clicked, this, &RecordingForm::stopAsked);
  connect(note_, &QLineEdit::returnPressed, this, &RecordingForm::sayNote);
  connect(browse_, &QToolButton::clicked, this, &RecordingForm::chooseFile);
  for (QLineEdit* field : {operator_, subject_, tags_, file_}) {
    connect(field, &QLineEdit::returnPressed, this, &RecordingForm::start);
    connect(field, &QLineEdit::textEdited, this, [this] { mark(Field::none); });
  }
  connect(subject_, &QLineEdit::textEdited, this, [this] {
    if (!file_is_own_) suggest();
  });
  connect(file_, &QLineEdit::textEdited, this, [this] { file_is_own_ = !file_->text().isEmpty(); });
  setRecording({});
  setWaiting(false);
}

void RecordingForm::build() {
  auto* grid = new QGridLayout(before_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kGrid);
  grid->setVerticalSpacing(kGrid);
  const auto add = [&](const QString& label, QWidget* field, const char* name, int columns) {
    auto* words = new QLabel(label, before_);
    words->setFont(textFont(TextSize::small));
    words->setProperty("role", "muted");
    const int line = grid->rowCount();
    grid->addWidget(words, line, 0, field == notes_ ? Qt::AlignTop : Qt::AlignVCenter);
    grid->addWidget(field, line, 1, 1, columns);
    field->setObjectName(QLatin1String(name));
    field->setAccessibleName(label);
  };
  add(tr("Operator"), operator_, "recording_operator", 2);
  add(tr("Subject"), subject_, "recording_subject", 2);
  add(tr("Tags"), tags_, "recording_tags", 2);
  add(tr("Notes"), notes_, "recording_notes", 2);
  add(tr("File"), file_, "recording_file", 1);
  grid->addWidget(browse_, grid->rowCount() - 1, 2);
  grid->setColumnStretch(1, 1);
  subject_->setPlaceholderText(tr("a code, such as S07; never a name"));
  tags_->setPlaceholderText(tr("pilot, left hand"));
  notes_->setFixedHeight(9 * kGrid);
  notes_->setTabChangesFocus(true);
  browse_->setText(tr("…"));
  browse_->setAccessibleName(tr("Choose the file"));

  auto* lines = new QVBoxLayout(during_);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(kGrid);
  figures_->setFont(textFont(TextSize::small));
  figures_->setWordWrap(true);
  figures_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  note_->setObjectName(QStringLiteral("recording_note"));
  note_->setAccessibleName(tr("A note into the recording"));
  note_->setPlaceholderText(tr("A note; Enter puts it into the recording"));
  note_->setMaxLength(500);
  lines->addWidget(figures_);
  lines->addWidget(note_);

  hint_->setFont(textFont(TextSize::small));
  hint_->setWordWrap(true);
  start_->setObjectName(QStringLiteral("recording_start"));
  stop_->setObjectName(QStringLiteral("recording_stop"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  for (QWidget* each :
       {before_, during_, static_cast<QWidget*>(hint_), static_cast<QWidget*>(start_), static_cast<QWidget*>(stop_)}) {
    layout->addWidget(each);
  }
  // Enter presses the button that has the focus, as the space bar does.
  start_->setAutoDefault(true);
  stop_->setAutoDefault(true);
}

void RecordingForm::setEntries(const RecordingEntries& entries) {
  operator_->setText(entries.operator_name);
  subject_->setText(entries.subject);
  tags_->setText(entries.tags.join(QStringLiteral(", ")));
  notes_->setPlainText(entries.notes);
  file_is_own_ = !entries.file.isEmpty();
  file_->setText(entries.file);
  if (!file_is_own_) suggest();
}

RecordingEntries RecordingForm::entries() const {
  return {.operator_name = operator_->text().trimmed(),
          .subject = subject_->text().trimmed(),
          .notes = notes_->toPlainText().trimmed(),
          .tags = readTags(tags_->text()),
          .file = file_->text().trimmed()};
}

void RecordingForm::setSuggestion(std::function<QString(const QString& subject)> suggest) {
  suggest_ = std::move(suggest);
  this->suggest();
}

void RecordingForm::suggest() {
  file_is_own_ = false;
  if (suggest_) file_->setText(suggest_(subject_->text().trimmed()));
}

void RecordingForm::setRecording(const RecordingView& view) {
  const bool was = view_.state == RecordingView::State::recording;
  const bool is = view.state == RecordingView::State::recording;
  const bool news = view.problem != view_.problem;  // also of a recording that failed before it was seen to run
  view_ = view;
  const bool loses_focus = was != is && isAncestorOf(QApplication::focusWidget());
  before_->setVisible(!is);
  start_->setVisible(!is);
  during_->setVisible(is);
  stop_->setVisible(is);
  if (loses_focus) keepFocus();
  if (is) {
    QStringList words = {view.file, tr("%1, %2").arg(clockText(view.seconds), bytesText(view.bytes)),
                         timeLeftText(view.minutes_left)};
    words.removeAll(QString());
    figures_->setText(words.join(QLatin1Char('\n')));
    say(view.lost > 0 ? tr("%1 samples are not in the file: the computer is too busy. What is written is safe. Close "
                           "other programs.")
                            .arg(view.lost)
                      : QString(),
        "danger");
  } else if (was || news || hint_->text().isEmpty()) {
    mark(Field::none);
  }
}

void RecordingForm::setWaiting(bool waiting) {
  waiting_ = waiting;
  const bool loses_focus = start_->hasFocus() || stop_->hasFocus() || hasFocus();
  start_->setText(waiting ? tr("Waiting for the disk …") : tr("Start recording"));
  stop_->setText(waiting ? tr("Waiting for the disk …") : tr("Stop recording"));
  for (QPushButton* each : {start_, stop_}) each->setEnabled(!waiting);
  if (loses_focus) keepFocus();
}

void RecordingForm::keepFocus() {
  QWidget* keeper = waiting_ ? this : start_->isHidden() ? static_cast<QWidget*>(stop_) : start_;
  keeper->setFocus(Qt::OtherFocusReason);
}

void RecordingForm::focusNext() {
  QWidget* next = start_->isHidden() ? stop_ : start_;
  if (next == start_ && operator_->text().trimmed().isEmpty()) next = operator_;  // it would refuse without
  next->setFocus(Qt::ShortcutFocusReason);
}

void RecordingForm::start() {
  if (waiting_) return;
  const RecordingEntries wanted = entries();
  const EntryProblem problem = checkEntries(wanted);
  mark(problem.field);
  if (problem.field == Field::none) {
    emit startAsked(wanted);
    return;
  }
  say(problem.words, "warning");
  widgetOf(problem.field)->setFocus();
}

void RecordingForm::sayNote() {
  const QString text = note_->text().simplified();
  if (text.isEmpty()) return;
  emit noteAsked(text);
}

QWidget* RecordingForm::widgetOf(EntryProblem::Field field) const {
  switch (field) {
    case Field::operator_name: return operator_;
    case Field::subject: return subject_;
    case Field::tags: return tags_;
    case Field::notes: return notes_;
    case Field::file: return file_;
    case Field::none: break;
  }
  return nullptr;
}

void RecordingForm::mark(EntryProblem::Field field) {
  const QWidget* wrong = widgetOf(field);
  for (QWidget* each : {static_cast<QWidget*>(operator_), static_cast<QWidget*>(subject_), static_cast<QWidget*>(tags_),
                        static_cast<QWidget*>(notes_), static_cast<QWidget*>(file_)}) {
    if (each->property("refused").toBool() == (each == wrong)) continue;
    each->setProperty("refused", each == wrong);
    restyle(*each);
  }
  if (field != Field::none) return;
  if (!view_.problem.isEmpty()) {
    say(view_.problem, "danger");
  } else {
    say(tr("The file begins up to 10 s before you start. Ctrl+M puts a marker."), "muted");
  }
}

void RecordingForm::say(const QString& words, const char* role) {
  hint_->setText(words);
  hint_->setAccessibleName(words);
  hint_->setVisible(!words.isEmpty());
  if (hint_->property("role").toString() == QLatin1String(role)) return;
  hint_->setProperty("role", role);
  restyle(*hint_);
}

void RecordingForm::chooseFile() {
  auto* dialog = new QFileDialog(this, tr("File of the recording"), file_->text(), tr("Recordings (*.h5)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("h5"));
  dialog->setModal(false);  // nothing is modal while a device can move
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    file_->setText(file);
    file_is_own_ = true;
    mark(Field::none);
  });
  dialog->show();
}

}  // namespace fyd::widgets
