// Damaged JPEGs of the cloth, with and without a finger: what share is refused, and how often one that passes makes the
// detector wrong (contact where there is none, none where there is, or a place more than 1 mm off). Beside it what
// OpenCV's own decoder lets pass. Then a source that damages every picture, from its first one on: how many wrong ones
// are handed on before it is not believed any more. Every cut picture must be refused, every whole one read.
//
//   attack_damaged_pictures [PICTURES] [SEED]      of each kind; full length: attack_damaged_pictures 2500
#include <cstdio>
#include <cstdlib>
#include <random>

#include <fcntl.h>
#include <unistd.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/device/camera/camera.h"
#include "core/device/camera/picture_decoder.h"
#include "core/sensing/finger_detector.h"
#include "core/sim/touchpad/simulated_camera.h"

namespace {

using namespace fyd;
using Bytes = std::vector<std::uint8_t>;

constexpr std::array kKinds = {"one bit",          "one byte",          "8 bytes",
                               "1 % of the bytes", "64 bytes in a row", "a third left"};

Bytes damaged(Bytes bytes, std::size_t kind, std::mt19937_64& random) {
  const std::size_t size = bytes.size();
  const auto spoil = [&](std::size_t at) { bytes[at] = static_cast<std::uint8_t>(bytes[at] + 1 + random() % 255); };
  switch (kind) {
    case 0: {
      std::uint8_t& byte = bytes[random() % size];
      byte = static_cast<std::uint8_t>(byte ^ (1U << (random() % 8)));
      break;
    }
    case 1: spoil(random() % size); break;
    case 2:
      for (int i = 0; i < 8; ++i) spoil(random() % size);
      break;
    case 3:
      for (std::size_t i = 0; i < size / 100; ++i) spoil(random() % size);
      break;
    case 4: {
      const std::size_t start = random() % (size - 64);
      for (std::size_t i = start; i < start + 64; ++i) spoil(i);
      break;
    }
    default: bytes.resize(size / 3);
  }
  return bytes;
}

/// Whether the detector says of `picture` something else than of the picture before it was damaged.
bool wrong(const cv::Mat& picture, const cv::Mat& original) {
  const auto look = [](const cv::Mat& at) { return sensing::FingerDetector().detect(device::viewOf(at)); };
  const sensing::FingerDetection a = look(picture);
  const sensing::FingerDetection b = look(original);
  return a.contact != b.contact || (a.contact && std::hypot(a.x_mm - b.x_mm, a.y_mm - b.y_mm) > 1.0);
}

cv::Mat byOpenCv(const Bytes& bytes) {
  try {
    return cv::imdecode(bytes, cv::IMREAD_ANYCOLOR);
  } catch (const cv::Exception&) {
    return {};
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int pictures = argc > 1 ? std::atoi(argv[1]) : 25;
  std::mt19937_64 random(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0)
    ::dup2(nowhere, STDERR_FILENO);  // libjpeg's words
  int failures = 0;
  std::printf("%% of %d pictures\n%-28s %-18s | OpenCV refuses, wrong | we refuse, wrong | handed on, wrong\n",
              pictures, "", "");
  for (const bool colour : {false, true}) {
    for (const int quality : {75, 92}) {
      for (const bool finger : {false, true}) {
        auto world = std::make_shared<sim::TouchpadWorld>(
            sim::SimParameters{}, sim::FingerPath::constant(5, -8, finger ? 6 : 0), instantAt(0));
        world->advanceTo(instantAt(0.1));
        sim::SimulatedCamera camera(world);
        for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
          device::DamageWatch watch;
          std::array<int, 2> cv_count{}, our_count{}, handed{};
          for (int i = 0; i < pictures; ++i) {
            cv::Mat original = camera.frameAt(instantAt(0.1)).picture;
            if (colour) cv::cvtColor(original, original, cv::COLOR_GRAY2BGR);
            Bytes whole;
            cv::imencode(".jpg", original, whole, {cv::IMWRITE_JPEG_QUALITY, quality});
            if (!device::decodeJpeg(whole)) ++failures;
            const Bytes bytes = damaged(whole, kind, random);
            const cv::Mat theirs = byOpenCv(bytes);
            ++cv_count.at(0);
            if (!theirs.empty()) {
              --cv_count[0];
              cv_count[1] += wrong(theirs, original) ? 1 : 0;
            }
            const auto ours = device::decodeJpeg(bytes);
            const bool refused = !ours || ours->size() != original.size();
            watch.saw(refused);
            our_count[0] += refused ? 1 : 0;
            if (kind + 1 == kKinds.size() && !refused) ++failures;
            if (refused) continue;
            const bool is_wrong = wrong(*ours, original);
            our_count[1] += is_wrong ? 1 : 0;
            handed[0] += watch.believed() ? 1 : 0;
            handed[1] += watch.believed() && is_wrong ? 1 : 0;
          }
          const auto share = [pictures](int count) { return 100.0 * count / pictures; };
          std::printf("%s, quality %d, %-8s %-18s | %5.1f %5.1f | %5.1f %5.2f | %d %d\n", colour ? "colour" : "grey  ",
                      quality, finger ? "finger" : "cloth", kKinds.at(kind), share(cv_count[0]), share(cv_count[1]),
                      share(our_count[0]), share(our_count[1]), handed[0], handed[1]);
        }
      }
    }
  }
  if (failures > 0) std::printf("%d whole pictures refused or cut ones read\n", failures);
  return failures > 0 ? 1 : 0;
}
