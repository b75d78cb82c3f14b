#include "app/console/review/what_if_panel.h"

#include <QCompleter>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "core/pipeline/parameters.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"

namespace fyd::console {
namespace {

using widgets::numberText;

struct Stopped {};

/// Runs on the work's thread. @param curves gets what the replay computes
Result<replay::ReplayResult> replayShown(const ShownRecording& shown, const replay::ReplayOptions& options,
                                         const recording::Progress& progress,
                                         std::shared_ptr<widgets::CurveBuffer>& curves) {
  const auto recording = shown.open();
  if (!recording) return tl::unexpected(recording.error());
  const recording::RecordingInfo& info = (*recording)->info();
  // Limits the memory for a recording of hours: of a longer one the newest samples are kept.
  constexpr std::uint64_t kMostSamples = 8'000'000;
  curves = std::make_shared<widgets::CurveBuffer>(
      kReviewQuantities.size(),
      static_cast<std::size_t>(std::clamp<std::uint64_t>(info.committed_samples, 1, kMostSamples)));
  const auto fields = pipeline::telemetryFields();
  std::array<std::size_t, kReviewQuantities.size()> indexes{};
  for (std::size_t q = 0; q < indexes.size(); ++q) indexes[q] = fieldIndex(kReviewQuantities[q].field);
  std::uint64_t rows = 0;
  try {
    return replay::replay(**recording, options, [&](const auto& replayed, const auto&) {
      constexpr std::uint64_t kLook = 4096;
      const double done = static_cast<double>(rows) / static_cast<double>(info.committed_samples);
      if (rows++ % kLook == 0 && !recording::tellProgress(progress, done)) throw Stopped{};
      std::array<float, kReviewQuantities.size()> values{};
      for (std::size_t q = 0; q < values.size(); ++q) values[q] = static_cast<float>(fields[indexes[q]].read(replayed));
      (void)curves->append(recording::secondsInto(info, replayed.now), values);
    });
  } catch (const Stopped&) {
    return fail("stopped");
  }
}

/// The result of a replay with unchanged parameters, as text.
QString sameness(const replay::ReplayResult& result) {
  if (result.identical) return WhatIfPanel::tr("Identical, bit for bit.");
  if (!result.why_not_exact.empty()) {
    return WhatIfPanel::tr("It cannot be proven bit for bit, a part of the recording is lost: %1")
        .arg(widgets::coreText(result.why_not_exact));
  }
  if (result.different == 0) return WhatIfPanel::tr("Identical, bit for bit, as far as it goes.");
  if (result.arithmetic_recorded != pipeline::kArithmetic) {
    const QString both = WhatIfPanel::tr("Recorded with arithmetic %1, replayed with %2: the bits cannot be the same.")
                             .arg(result.arithmetic_recorded)
                             .arg(pipeline::kArithmetic);
    const bool close = result.tolerance && result.beyond_tolerance == 0;
    return both + QLatin1Char(' ') +
           (close ? WhatIfPanel::tr("The values are, within the tolerance stated for that.")
                  : WhatIfPanel::tr("%1 steps lie beyond the tolerance stated for that.").arg(result.beyond_tolerance));
  }
  return WhatIfPanel::tr("Different from %1 s on (%2).")
      .arg(numberText(result.first_difference_s, 3), QString::fromStdString(result.first_difference_field));
}

}  // namespace

WhatIfPanel::WhatIfPanel(widgets::ProgressBars* bars, QWidget* parent)
    : QWidget(parent),
      parameter_(new QComboBox(this)),
      value_(new QLineEdit(this)),
      add_(new QPushButton(tr("Add"), this)),
      settings_(new QListWidget(this)),
      closed_loop_(new QCheckBox(tr("Motors and cloth answer (closed loop)"), this)),
      run_(new QPushButton(tr("Run again"), this)),
      words_(new QLabel(this)),
      work_(bars) {
  build();
  connect(add_, &QPushButton::clicked, this, &WhatIfPanel::addSetting);
  connect(value_, &QLineEdit::returnPressed, this, &WhatIfPanel::addSetting);
  connect(settings_, &QListWidget::itemActivated, this, [](QListWidgetItem* item) { delete item; });
  connect(run_, &QPushButton::clicked, this, &WhatIfPanel::run);
  setRecording({});
}

void WhatIfPanel::build() {
  pipeline::Parameters parameters;
  parameter_->setEditable(true);
  for (const Parameter& each : bindParameters(parameters)) {
    if (!each.isNumber()) continue;
    const QString id = QString::fromUtf8(each.id.data(), static_cast<qsizetype>(each.id.size()));
    parameter_->addItem(id);
    parameter_->setItemData(parameter_->count() - 1,
                            tr("%1\n%2").arg(widgets::coreText(each.info.help), widgets::coreText(describeRange(each))),
                            Qt::ToolTipRole);
  }
  parameter_->setCurrentText(QStringLiteral("control.kp"));
  parameter_->completer()->setFilterMode(Qt::MatchContains);
  parameter_->completer()->setCompletionMode(QCompleter::PopupCompletion);
  parameter_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  parameter_->setAccessibleName(tr("Parameter to change"));
  value_->setPlaceholderText(tr("value"));
  value_->setAccessibleName(tr("Its value"));
  value_->setMaximumWidth(10 * widgets::kGrid);
  settings_->setAccessibleName(tr("Changed parameters; Enter takes one away"));
  settings_->setMaximumHeight(10 * widgets::kGrid);
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(widgets::kGrid);
  auto* what = new QLabel(tr("Runs the recorded inputs through the step again. Without a change it proves that the "
                             "recording comes out the same, bit for bit."),
                          this);
  what->setWordWrap(true);
  layout->addWidget(what);
  auto* row = new QHBoxLayout;
  row->addWidget(parameter_, 1);
  row->addWidget(value_);
  row->addWidget(add_);
  layout->addLayout(row);
  layout->addWidget(settings_);
  layout->addWidget(closed_loop_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(run_);
  buttons->addStretch(1);
  layout->addLayout(buttons);
  layout->addWidget(words_);
  layout->addStretch(1);
}

void WhatIfPanel::setRecording(const ShownRecording& shown) {
  work_.drop();
  shown_ = shown;
  words_->clear();
  run_->setEnabled(!shown.isNone());
  emit replayed(nullptr);
}

void WhatIfPanel::addSetting() {
  pipeline::Parameters parameters;
  const auto bound = bindParameters(parameters);
  const std::string id = parameter_->currentText().trimmed().toStdString();
  const Parameter* known = findParameter(bound, id);
  if (known == nullptr) {
    words_->setText(tr("There is no parameter '%1'.").arg(parameter_->currentText()));
    return;
  }
  const std::string text = value_->text().trimmed().replace(QLatin1Char(','), QLatin1Char('.')).toStdString();
  if (auto good = assignParameter(*known, text); !good) {
    words_->setText(widgets::coreText(good.error().message));
    return;
  }
  const QString prefix = QString::fromStdString(id + "=");
  for (QListWidgetItem* item : settings_->findItems(prefix, Qt::MatchStartsWith)) delete item;
  settings_->addItem(prefix + QString::fromStdString(text));
  value_->clear();
  words_->clear();
}

void WhatIfPanel::run() {
  if (shown_.isNone()) return;
  replay::ReplayOptions options;
  options.closed_loop = closed_loop_->isChecked();
  for (int i = 0; i < settings_->count(); ++i) options.settings.push_back(settings_->item(i)->text().toStdString());
  words_->setText(tr("Running …"));
  run_->setEnabled(false);
  work_.run(tr("Running %1 again").arg(QFileInfo(shown_.path).fileName()),
            [this, shown = shown_, options](const recording::Progress& progress) {
              std::shared_ptr<widgets::CurveBuffer> curves;
              auto result = guarded([&] { return replayShown(shown, options, progress, curves); });
              return [this, result = std::move(result), curves] { finish(result, curves); };
            });
}

void WhatIfPanel::finish(const Result<replay::ReplayResult>& result,
                         std::shared_ptr<const widgets::CurveBuffer> curves) {
  run_->setEnabled(true);
  if (!result) {
    words_->setText(work_.cancelled() ? tr("Cancelled.") : widgets::coreText(result.error().message));
    emit replayed(nullptr);
    return;
  }
  QStringList lines;
  if (!result->what_if) {
    lines << sameness(*result);
  } else {
    lines << (result->closed_loop ? tr("Closed loop: motors and cloth answer as identified from this recording.")
                                  : tr("Open loop: the recorded inputs as they were; the cloth does not answer."));
    lines << tr("Stiffness error, RMS: %1 % recorded, %2 % so.")
                 .arg(numberText(result->stiffness_error_recorded_percent, 1),
                      numberText(result->stiffness_error_replayed_percent, 1));
  }
  lines << tr("%1 of %2 samples, %3 times real time.")
               .arg(result->samples)
               .arg(result->of)
               .arg(numberText(result->speed_x, 0));
  if (result->gaps > 0) lines << tr("It ends at the first of %1 lost samples.").arg(result->gaps);
  words_->setText(lines.join(QLatin1Char('\n')));
  emit replayed(result->what_if ? std::move(curves) : nullptr);
}

}  // namespace fyd::console
