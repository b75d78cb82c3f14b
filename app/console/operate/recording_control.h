// Recording from the window: the form in its panel, the state bar's button, the keys, and the notices when something
// goes wrong.
#pragma once

#include <QObject>

#include "app/console/shell/background.h"
#include "app/console/shell/page.h"
#include "app/console/shell/side_dock.h"
#include "widgets/status/record_button.h"
#include "widgets/status/recording_form.h"

namespace fyd::console {

/// Where recordings and pictures of curves go, unless another place is named.
[[nodiscard]] QString sessionsFolder();

class RecordingControl : public QObject {
  Q_OBJECT
 public:
  /// @param memory file that keeps the entries until the next start
  RecordingControl(const PageContext& context, QString memory, QWidget* window);

  /// Panel, button and commands are put into the window by it.
  [[nodiscard]] SideDock* dock() const { return dock_; }
  [[nodiscard]] widgets::RecordingForm* form() const { return form_; }
  /// The state bar's button shows what the recorder does, and opens the panel.
  void connectButton(widgets::RecordButton* button);
  void addCommands(CommandRegistry& commands);
  /// To be called when the window closes: closes a recording under way.
  void finish();
  /// Waits until the disk has answered what was asked of it: before that the session may not go.
  void waitForDisk() { disk_work_.wait(); }
  /// The next file: documents, a folder for sessions, date, time and subject.
  [[nodiscard]] static QString suggestedFile(const QString& subject);

 signals:
  void catalogued();  ///< a closed recording was entered in the catalogue

 private:
  void open();
  void start(const widgets::RecordingEntries& entries);
  void started(const widgets::RecordingEntries& entries, const Result<void>& outcome);
  void stop();
  void stopped(const QString& file, const Result<void>& outcome);
  void enterIntoCatalogue(const QString& file);
  void mark();
  void note(const QString& text);
  void take(const recording::RecorderStatus& status);
  void remember(const widgets::RecordingEntries& entries) const;
  [[nodiscard]] bool recording() const { return last_.state == recording::RecorderState::recording; }

  PageContext context_;
  QString memory_;
  widgets::RecordingForm* form_ = nullptr;
  SideDock* dock_ = nullptr;
  widgets::RecordButton* button_ = nullptr;
  recording::RecorderStatus last_;
  int markers_ = 0;
  Background catalogue_work_;
  Background disk_work_;  // a recording begins or ends: the window listens meanwhile, above all to Esc
};

}  // namespace fyd::console
