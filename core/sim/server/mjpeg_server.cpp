#include "core/sim/server/mjpeg_server.h"

#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <opencv2/imgcodecs.hpp>

#include "core/base/codecs/codecs.h"
#include "core/base/system_reason.h"

namespace fyd::sim {
namespace {

using Tcp = asio::ip::tcp;

constexpr std::size_t kLongestRequest = 4096;
constexpr std::size_t kMaximumReaders = 8;
constexpr Duration kLongestSilence = std::chrono::seconds(3);  // of a reader that has not asked for anything
constexpr double kFlatGrey = 200.0;
constexpr int kWrongBytes = 8;
constexpr std::string_view kStreamHead =
    "HTTP/1.0 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=picture\r\n"
    "Cache-Control: no-store\r\nConnection: close\r\n\r\n";
constexpr std::string_view kNotFound = "HTTP/1.0 404 Not Found\r\nContent-Length: 0\r\nConnection: close\r\n\r\n";
constexpr std::string_view kNotAllowed =
    "HTTP/1.0 405 Method Not Allowed\r\nAllow: GET\r\nContent-Length: 0\r\nConnection: close\r\n\r\n";

Result<Tcp::endpoint> toAsio(const protocol::Endpoint& endpoint) {
  if (endpoint.v6) return Tcp::endpoint(asio::ip::address_v6(endpoint.address, endpoint.scope), endpoint.port);
  asio::ip::address_v4::bytes_type bytes{};
  std::copy_n(endpoint.address.begin(), bytes.size(), bytes.begin());
  return Tcp::endpoint(asio::ip::address_v4(bytes), endpoint.port);
}

}  // namespace

struct MjpegServer::Acceptor {
  asio::io_context context;
  Tcp::acceptor acceptor{context};
};

struct MjpegServer::Reader {
  Tcp::socket socket;
  Instant came;
  std::string request;
  std::string pending;
  bool streaming = false;
  bool last = false;  ///< closes when nothing is pending

  void hear(Instant now) {
    const bool late = now - came > kLongestSilence;  // or eight that say nothing would keep everybody else out
    std::array<char, 512> buffer{};
    std::error_code problem;
    const std::size_t got = socket.read_some(asio::buffer(buffer), problem);
    if (problem == asio::error::would_block) {
      last = last || (!streaming && late);
      return;
    }
    if (problem) {
      pending.clear();
      last = true;
      return;
    }
    if (streaming || last) return;
    request.append(buffer.data(), got);
    if (request.find("\r\n\r\n") == std::string::npos) {
      last = late || request.size() > kLongestRequest;
      return;
    }
    const bool get = request.starts_with("GET ");
    const bool root = request.starts_with("GET / ") || request.starts_with("GET /?");
    streaming = root;
    last = !root;
    pending = root ? kStreamHead : get ? kNotFound : kNotAllowed;
  }

  /// @return false when this reader can be removed
  bool speak(const std::string& part) {
    if (streaming && !last && pending.size() <= kStreamHead.size()) pending += part;
    std::error_code problem;
    while (!pending.empty() && !problem) {
      pending.erase(0, socket.write_some(asio::buffer(pending), problem));
    }
    if (problem && problem != asio::error::would_block) return false;
    return !last || !pending.empty();
  }
};

Result<std::unique_ptr<MjpegServer>> MjpegServer::start(const protocol::Endpoint& local,
                                                        std::unique_ptr<device::Camera> camera, FaultPlan faults) {
  if (const auto loaded = codecs::load(); !loaded) return tl::unexpected(loaded.error());
  std::unique_ptr<Acceptor> acceptor;
  auto wanted = toAsio(local);
  std::error_code problem;
  try {
    acceptor = std::make_unique<Acceptor>();
  } catch (const std::system_error& failed) {
    problem = failed.code();
  }
  if (!problem) acceptor->acceptor.open(wanted->protocol(), problem);
  if (!problem) acceptor->acceptor.set_option(Tcp::acceptor::reuse_address(true), problem);
  if (!problem) acceptor->acceptor.bind(*wanted, problem);
  if (!problem) acceptor->acceptor.listen(static_cast<int>(kMaximumReaders), problem);
  if (!problem) acceptor->acceptor.non_blocking(true, problem);
  if (problem) return fail("MJPEG {}: cannot listen: {}", protocol::toString(local), systemReason(problem));
  protocol::Endpoint bound = local;
  bound.port = acceptor->acceptor.local_endpoint(problem).port();
  return std::unique_ptr<MjpegServer>(
      new MjpegServer(std::move(acceptor), bound, std::move(camera), std::move(faults)));
}

MjpegServer::MjpegServer(std::unique_ptr<Acceptor> acceptor, const protocol::Endpoint& local,
                         std::unique_ptr<device::Camera> camera, FaultPlan faults)
    : acceptor_(std::move(acceptor)), local_(local), camera_(std::move(camera)), faults_(std::move(faults)) {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

MjpegServer::~MjpegServer() {
  thread_.request_stop();
  thread_.join();
}

void MjpegServer::acceptReaders() {
  while (readers_.size() < kMaximumReaders) {
    std::error_code problem;
    Tcp::socket socket = acceptor_->acceptor.accept(problem);
    if (problem) return;
    socket.non_blocking(true, problem);
    socket.set_option(Tcp::no_delay(true), problem);
    readers_.push_back({.socket = std::move(socket), .came = Clock::now(), .request = {}, .pending = {}});
  }
}

bool MjpegServer::encodeNext() {
  const auto frame = camera_->next();  // waits for it
  if (!frame) return false;
  const Instant now = Clock::now();
  if (faults_.active(TouchpadFault::camera_freeze, now) && !part_.empty()) return true;
  if (faults_.active(TouchpadFault::garbage, now)) {
    part_.resize(2000);
    for (char& byte : part_) byte = static_cast<char>(random_());
    return true;
  }
  const cv::Mat picture = faults_.active(TouchpadFault::camera_flat, now)
                              ? cv::Mat(frame->picture.size(), frame->picture.type(), cv::Scalar::all(kFlatGrey))
                              : frame->picture;
  std::vector<std::uint8_t> jpeg;
  if (!codecs::encodePicture(".jpg", picture, jpeg, {cv::IMWRITE_JPEG_QUALITY, 92})) return false;
  if (faults_.active(TouchpadFault::camera_cut, now)) jpeg.resize(jpeg.size() / 3);
  for (int i = 0; i < kWrongBytes && faults_.active(TouchpadFault::camera_damage, now); ++i) {
    jpeg[random_() % jpeg.size()] = static_cast<std::uint8_t>(random_());
  }
  part_ = fmt::format("--picture\r\nContent-Type: image/jpeg\r\nContent-Length: {}\r\n\r\n", jpeg.size());
  part_.append(jpeg.begin(), jpeg.end());
  part_ += "\r\n";
  return true;
}

/// Pictures of a camera without power end its connections; one that is silent keeps them open.
bool MjpegServer::interrupted() {
  const Instant now = Clock::now();
  if (faults_.active(TouchpadFault::brown_out, now)) {
    readers_.clear();
    return true;
  }
  const int late = faults_.begun(TouchpadFault::late_reply, now, FaultPlan::Count::without_duration);
  if (late > late_pictures_ || faults_.active(TouchpadFault::late_reply, now)) std::this_thread::sleep_for(kLateBy);
  late_pictures_ = late;
  return faults_.active(TouchpadFault::silence, now);
}

void MjpegServer::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    if (!encodeNext() || interrupted()) continue;
    ++pictures_;
    acceptReaders();
    for (auto reader = readers_.begin(); reader != readers_.end();) {
      reader->hear(Clock::now());
      reader = reader->speak(part_) ? std::next(reader) : readers_.erase(reader);
    }
  }
}

}  // namespace fyd::sim
