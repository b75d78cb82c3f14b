// replay RECORDING: reads it, replays it, and computes it again with another gain. Truth: the recording itself, bit for
// bit; and of the numbers that are printed, whoever reads the file without this library.
#include <core/replay/replay.h>

#include <string_view>
#include <vector>

#include "expect.h"

int main(int, char** arguments) {
  const auto recording = fyd::recording::Recording::open(arguments[1]);
  if (!recording) {
    std::fprintf(stderr, "%s\n", recording.error().text().c_str());
    return 1;
  }
  const auto& info = (*recording)->info();

  const auto fields = fyd::pipeline::telemetryFields();
  std::size_t force = 0;
  while (force < fields.size() && fields[force].name != "force_N") ++force;
  expect("a field force_N", force < fields.size());
  std::vector<double> force_N(info.committed_samples);
  expect("its rows", (*recording)->field(force, 0, force_N).has_value());
  double sum_N = 0.0;
  for (const double each : force_N) sum_N += std::isfinite(each) ? each : 0.0;

  const auto same = fyd::replay::replay(**recording, {});
  expect("a replay", same.has_value());
  expect("the same bit for bit", same->identical && same->different == 0 && same->samples == info.committed_samples);

  const auto other = fyd::replay::replay(**recording, {.settings = {"control.kp=3"}});
  expect("another gain changes the steps", other && other->what_if && other->different > 0);
  const auto wrong = fyd::replay::replay(**recording, {.settings = {"control.kp=many"}});
  expect("an error that names the parameter", !wrong && wrong.error().text().find("control.kp") != std::string::npos);

  std::printf("%zu %.17g\n", force_N.size(), sum_N);
}
