#include "app/console/window/missing_devices.h"

#include <algorithm>

#include "widgets/basics/core_text.h"

namespace fyd::console {

MissingDevices::MissingDevices(const PageContext& context, std::function<void()> choose, QObject* parent)
    : QObject(parent),
      context_(context),
      choose_(std::move(choose)),
      strip_(new widgets::GuideStrip(tr("Devices not found"))) {
  strip_->hide();
  patience_.setSingleShot(true);
  connect(&patience_, &QTimer::timeout, this, [this] {
    refresh();
    strip_->show();
  });
  connect(&context_.feed, &SessionFeed::telemetry, this, [this](std::span<const pipeline::TelemetrySample> samples) {
    if (expecting_ && samples.back().state != pipeline::SafetyState::disconnected) end();
  });
  connect(&context_.connection, &ConnectionChange::refreshed, this, &MissingDevices::refresh);
  connect(strip_, &widgets::GuideStrip::closeAsked, this, &MissingDevices::end);
}

void MissingDevices::expect(const Message& why) {
  why_ = why;
  expecting_ = true;
  patience_.start(why.empty() ? kPatience_ms : 0);
}

void MissingDevices::end() {
  expecting_ = false;
  patience_.stop();
  strip_->hide();
}

QString MissingDevices::reason() const {
  QStringList reasons;
  for (const station::ConnectionProblem& each : context_.connection.problems()) {
    reasons << widgets::coreText(each.message);
  }
  if (!reasons.isEmpty()) return reasons.join(QStringLiteral("; "));
  if (!context_.session.isOpen()) return widgets::coreText(why_);
  for (const device::DeviceReport& part : context_.session.devices()) {
    if (!part.ok && !part.problem.empty()) return widgets::coreText(part.problem);
  }
  return tr("no answer yet");
}

void MissingDevices::refresh() {
  if (!expecting_) return;
  const ConnectionWords words = context_.connection.present();
  const bool open = context_.session.isOpen();
  QString text = tr("The devices of last time are not there. Looked for: %1. %2.").arg(inWords(words), reason());
  if (!context_.connection.work().isEmpty()) {
    text = context_.connection.work();
  } else if (open) {
    const auto devices = context_.session.devices();
    const bool in_use = std::ranges::any_of(devices, &device::DeviceReport::in_use);
    text += QLatin1Char(' ') + (in_use ? tr("They are asked again by themselves: close the other program.")
                                       : tr("They are asked again by themselves: check power and cables."));
  }
  std::vector<widgets::GuideStrip::Action> actions;
  if (!open) {
    actions.push_back({QStringLiteral("missing_retry"), tr("Try again"),
                       [this] { context_.connection.change(context_.connection.present()); }});
  }
  actions.push_back({QStringLiteral("missing_choose"), tr("Choose others"), choose_});
  actions.push_back({QStringLiteral("missing_simulated"), tr("Use the simulation"),
                     [this] { context_.connection.change(ConnectionWords{}); }});
  strip_->setGuide({}, 0, text, actions);
}

}  // namespace fyd::console
