// Serves a camera's pictures as an MJPEG stream over HTTP at "/", to several readers. A slow reader misses pictures and
// never delays the others; one that asks for nothing within three seconds is let go. One thread.
#pragma once

#include <atomic>
#include <list>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/device/camera/camera.h"
#include "core/protocol/endpoint.h"
#include "core/sim/server/touchpad_fault.h"

namespace fyd::sim {

class MjpegServer {
 public:
  /// @param local port 0: any. @return an error when the port is taken
  [[nodiscard]] static Result<std::unique_ptr<MjpegServer>> start(const protocol::Endpoint& local,
                                                                  std::unique_ptr<device::Camera> camera,
                                                                  FaultPlan faults);
  ~MjpegServer();

  [[nodiscard]] const protocol::Endpoint& local() const { return local_; }
  [[nodiscard]] std::uint64_t pictures() const { return pictures_.load(); }

 private:
  struct Acceptor;
  struct Reader;
  MjpegServer(std::unique_ptr<Acceptor> acceptor, const protocol::Endpoint& local,
              std::unique_ptr<device::Camera> camera, FaultPlan faults);
  void run(const std::stop_token& stop);
  void acceptReaders();
  [[nodiscard]] bool encodeNext();
  [[nodiscard]] bool interrupted();

  std::unique_ptr<Acceptor> acceptor_;
  protocol::Endpoint local_;
  std::unique_ptr<device::Camera> camera_;
  FaultPlan faults_;
  std::list<Reader> readers_;
  std::string part_;  // the newest picture with its header
  std::mt19937 random_{1};
  int late_pictures_ = 0;
  std::atomic<std::uint64_t> pictures_{0};
  std::jthread thread_;
};

}  // namespace fyd::sim
