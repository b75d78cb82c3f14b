#include "core/station/link_thread.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "core/protocol/classic/classic_touchpad_end.h"
#include "core/protocol/link/described_scene.h"
#include "core/protocol/link/link_touchpad_end.h"
#include "core/station/real_time.h"

namespace fyd::station {
namespace {

constexpr Duration kPatience = std::chrono::milliseconds(1);      // also how late a lost link may be noticed
constexpr Duration kLinkLateness = std::chrono::milliseconds(4);  // of this thread, where the clock waits for it
constexpr double kDelayStep_ms = 5.0;
constexpr std::string_view kBoardText = "FYD Console " FYD_VERSION;

}  // namespace

double NeededDelay::add(const protocol::LinkFigures& figures) {
  if (figures.heartbeats < heartbeats_) heartbeats_ = figures.heartbeats;  // counted anew
  if (figures.heartbeats - heartbeats_ >= kHeartbeats) {
    heartbeats_ = figures.heartbeats;
    const double needed_ms = kDelayStep_ms * std::ceil(figures.sample_delay_ms / kDelayStep_ms);
    needed_ms_[next_++ % kValues] = std::isfinite(needed_ms) ? needed_ms : 0.0;
  }
  return *std::ranges::min_element(needed_ms_);
}

Result<std::unique_ptr<LinkThread>> LinkThread::open(const protocol::Endpoint& local,
                                                     const protocol::LinkParameters& parameters,
                                                     const std::optional<protocol::LinkKey>& key, std::string scene) {
  auto socket = protocol::UdpSocket::open(local);
  if (!socket) return tl::unexpected(socket.error());
  std::unique_ptr<protocol::TouchpadEnd> end;
  if (key) {
    end = std::make_unique<protocol::LinkTouchpadEnd>(parameters, *key);
  } else {
    end = std::make_unique<protocol::ClassicTouchpadEnd>(parameters);
  }
  return std::unique_ptr<LinkThread>(
      new LinkThread(std::move(*socket), std::move(end), key.has_value(), std::move(scene)));
}

LinkThread::LinkThread(protocol::UdpSocket socket, std::unique_ptr<protocol::TouchpadEnd> end, bool secured,
                       std::string scene)
    : socket_(std::move(socket)),
      end_(std::move(end)),
      secured_(secured),
      scene_(std::move(scene)),
      board_text_(protocol::describedWith(kBoardText, scene_)),
      monitor_(device::Part::robot, secured
                                        ? say("FYD Link robot, listening on {}", protocol::toString(socket_.local()))
                                        : say("classic robot, listening on {}", protocol::toString(socket_.local()))) {
  status_.protocol = phrase(end_->name());
  status_.secured = secured;
  status_.local = protocol::toString(socket_.local());
}

LinkThread::~LinkThread() { shutDown(); }

void LinkThread::start(bool clock_waits) {
  thread_ = std::jthread([this, clock_waits](const std::stop_token& stop) { run(stop, clock_waits); });
}

void LinkThread::shutDown() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

void LinkThread::offerImage(std::vector<std::uint8_t> encoded) {
  const std::lock_guard lock(image_mutex_);
  offered_image_ = std::move(encoded);
}

protocol::TouchpadAnswer LinkThread::answerFrom(const Announcement& said) const {
  return {.touch = said.touch,
          .taken = said.taken,
          .info = {.k_vib = said.k_vib,
                   .reference_ticks = {static_cast<double>(said.motors.reference_ticks[0]),
                                       static_cast<double>(said.motors.reference_ticks[1])}},
          .board_text = board_text_,
          .image = image_};
}

void LinkThread::takeImage() {
  const std::lock_guard lock(image_mutex_);
  if (!end_->imagesOn()) {  // a picture of now would be an old one when they are wanted again
    image_.clear();
    offered_image_.clear();
  } else if (!offered_image_.empty()) {
    image_.swap(offered_image_);
    offered_image_.clear();
  }
}

void LinkThread::run(const std::stop_token& stop, bool clock_waits) {
  askForRealTime(Urgency::link);
  ClockHold hold(clock_waits);
  std::vector<std::uint8_t> buffer(protocol::kMaximumDatagram);
  Instant published{};
  while (!stop.stop_requested()) {
    const auto received = socket_.receive(buffer, kPatience);
    const Instant now = Clock::now();
    hold.until(now + kLinkLateness);
    const Announcement& said = announcement.read();
    if (received) {
      takeImage();
      const auto& reception = end_->handle({buffer.data(), received->size}, received->from, now, answerFrom(said));
      send(reception.replies.view());
      take(reception, now);
      if (reception.image_used) image_.clear();
    }
    const pipeline::LinkPhase before = end_->phase();
    send(end_->advance(now, answerFrom(said)));
    if (secured_) image_.clear();  // FYD Link sends it without a request
    if (end_->phase() == pipeline::LinkPhase::lost && before != pipeline::LinkPhase::lost) ++newest_.losses;
    newest_.phase = end_->phase();
    snapshot.write(newest_);
    wants_images_.store(end_->imagesOn(), std::memory_order_relaxed);
    if (now - published > NeededDelay::kPeriod) {
      publish(now);
      published = now;
    }
  }
  send(end_->farewell(Clock::now()));
  publish(Clock::now());
}

void LinkThread::send(std::span<const protocol::Datagram> datagrams) {
  for (const protocol::Datagram& datagram : datagrams) {
    if (socket_.send(datagram.bytes, datagram.to) != protocol::SendOutcome::sent) ++send_failures_;
  }
}

void LinkThread::take(const protocol::TouchpadReception& reception, Instant now) {
  if (reception.session_started) {
    ++newest_.sessions;
    newest_.state = {};
    newest_.motor_reference = {};
  }
  if (reception.was_lost) ++newest_.losses;
  if (reception.state) {
    newest_.state.set(*reception.state, now);
    monitor_.succeeded(now);
  }
  for (const auto& sample : reception.accelerations) lost_samples_ += accelerations.push(sample) ? 0 : 1;
  if (reception.command != pipeline::RobotCommand::none && !commands.push(reception.command)) ++lost_samples_;
  if (reception.motor_reference) newest_.motor_reference.set(*reception.motor_reference, now);
}

void LinkThread::publish(Instant now) {
  const protocol::LinkFigures figures = end_->figures(now);
  newest_.sample_delay_ms = needed_delay_.add(figures);
  const std::lock_guard lock(status_mutex_);
  status_.peer = end_->peer() ? protocol::toString(*end_->peer()) : "";
  status_.states_received = figures.states;
  status_.touches_sent = figures.touches;
  status_.refused = figures.refused;
  status_.send_failures = send_failures_;
  status_.samples_lost = lost_samples_;
  status_.phase = end_->phase();
  status_.scenes = end_->peer() ? protocol::compareScenes(scene_, protocol::describedScene(end_->peerText()))
                                : protocol::SceneCopies::none;
  status_.figures = figures;
}

LinkStatus LinkThread::status() const {
  const std::lock_guard lock(status_mutex_);
  return status_;
}

device::DeviceReport LinkThread::part(Instant now) const {
  device::DeviceReport part = monitor_.report(now);
  const LinkStatus link = status();
  switch (link.phase) {
    case pipeline::LinkPhase::waiting:
      part.ok = false;
      part.problem = say("waiting for a robot on {}", link.local);
      break;
    case pipeline::LinkPhase::lost:
      part.ok = false;
      part.problem = say("silent");
      break;
    case pipeline::LinkPhase::closed:
      part.ok = false;
      part.problem = say("has said goodbye");
      break;
    case pipeline::LinkPhase::paused:
    case pipeline::LinkPhase::running:
    case pipeline::LinkPhase::none: break;
  }
  part.errors = link.refused;
  return part;
}

}  // namespace fyd::station
