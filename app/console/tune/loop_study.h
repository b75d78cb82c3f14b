// Simulation of the stiffness loop: the step response of current and saved gains, and auto-tune. Computed off the
// window's thread by the core's own model of the loop; nothing here changes a value.
#pragma once

#include <QObject>
#include <QTimer>
#include <deque>
#include <optional>

#include "app/console/shell/background.h"
#include "core/control/auto_tune.h"
#include "core/pipeline/telemetry.h"
#include "core/station/profile/profile.h"
#include "widgets/tuning/tuning_response.h"

namespace fyd::console {

/// Data source from which auto-tune identifies cloth and sensors.
enum class TuneSource {
  simulation,  ///< the safe excitation on the simulated touchpad, in virtual time
  session,     ///< the last minute of this session
};

class LoopStudy : public QObject {
  Q_OBJECT
 public:
  explicit LoopStudy(QObject* parent = nullptr);

  /// Remembers the last minute of stretch and stiffness, for TuneSource::session.
  void listen(std::span<const pipeline::TelemetrySample> samples);

  /// Computes the responses for these values; those being computed for others are dropped.
  /// @param timing of this touchpad
  void setValues(const control::ControlParameters& current, const control::ControlParameters& saved,
                 const control::LoopTiming& timing);
  void autoTune(TuneSource source, const station::Profile& present);
  void cancel();
  /// Drops the proposal and the model identified with it.
  void discard();

  /// Another touchpad is listened to from now on.
  void forget() { heard_.clear(); }

  [[nodiscard]] bool tuning() const { return tuning_.running(); }
  [[nodiscard]] const std::optional<control::TuneProposal>& proposal() const { return proposal_; }
  [[nodiscard]] std::size_t heard() const { return heard_.size(); }

 signals:
  void responses(const fyd::widgets::ResponseView& current, const fyd::widgets::ResponseView& saved);
  void respondingChanged(bool running);
  void tuningChanged(bool running);
  void progressed(double done);
  /// `proposal` is available.
  void proposed(const fyd::widgets::ResponseView& response);
  void failed(const QString& why);

 private:
  void respond();

  control::ControlParameters current_;
  control::ControlParameters saved_;
  control::LoopTiming timing_;
  std::optional<control::TuneProposal> proposal_;
  std::deque<control::TuneSample> heard_;
  QTimer soon_;
  Background responding_;
  Background tuning_;
};

}  // namespace fyd::console
