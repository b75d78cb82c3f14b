// fyd finger IMAGE... [--profile P] [--set id=value] [--json]
#include <cmath>
#include <iostream>

#include "app/cli/parts/command.h"
#include "app/cli/parts/profile_options.h"
#include "core/device/camera/camera.h"
#include "core/device/camera/picture_decoder.h"
#include "core/sensing/finger_detector.h"

namespace fyd::cli {
namespace {

nlohmann::ordered_json detectionJson(const std::string& path, const sensing::FingerDetection& found) {
  const auto onlyInContact = [&](double value) { return jsonNumber(found.contact ? value : std::nan("")); };
  return {{"image", path},
          {"contact", found.contact},
          {"area_px", jsonNumber(found.area_px)},
          {"area_mm2", jsonNumber(found.area_mm2)},
          {"x_px", onlyInContact(found.x_px)},
          {"y_px", onlyInContact(found.y_px)},
          {"x_mm", onlyInContact(found.x_mm)},
          {"y_mm", onlyInContact(found.y_mm)},
          {"quality", jsonNumber(found.quality)},
          {"reason", sensing::toString(found.reason)}};
}

void printFinger(const std::string& path, const sensing::FingerDetection& found) {
  if (!found.contact) {
    std::cout << fmt::format("{}: {} (area {:.0f} px)\n", path, sensing::toString(found.reason), found.area_px);
    return;
  }
  std::cout << fmt::format("{}: finger at {:.2f} {:.2f} mm ({:.2f} {:.2f} px), area {:.1f} mm², quality {:.2f}, {}\n",
                           path, found.x_mm, found.y_mm, found.x_px, found.y_px, found.area_mm2, found.quality,
                           sensing::toString(found.reason));
}

}  // namespace

void add_finger(CLI::App& app) {
  struct Options {
    std::vector<std::string> images;
    ProfileOptions profile;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("finger", "Find the finger in pictures of the cloth, each on its own");
  command
      ->add_option("image", options->images,
                   "Picture as the camera delivers it; area_px counts its pixels, in thesis mode those of the "
                   "160 × 120 working picture")
      ->required();
  options->profile.addTo(*command);
  command->add_flag("--json", options->json, "One JSON array, in the order given");
  command->callback([options] {
    const sensing::FingerParameters parameters = options->profile.load().step.sensing.finger;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    std::vector<Message> problems;
    for (const std::string& path : options->images) {
      const auto read = device::readPicture(path);
      if (!read) problems.push_back(read.error().message);
      const cv::Mat picture = read ? *read : cv::Mat();
      const sensing::FingerDetection found = sensing::FingerDetector(parameters).detect(device::viewOf(picture));
      if (options->json) {
        all.push_back(detectionJson(path, found));
      } else {
        printFinger(path, found);
      }
    }
    if (options->json) printJson(all);
    if (!problems.empty())
      throw Failure(listed(std::move(problems), "{}\n{}"));  // the other pictures have their answer
  });
}

}  // namespace fyd::cli
