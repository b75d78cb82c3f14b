// A program with more inputs than this one (insert.py): recordings of today in its hands, and its own.
//
//   later_program replay FILE     JSON: whether it is identical, and what of its inputs the recording faults
//   later_program copy FILE OUT   writes the recording anew, with its own inputs in it; OUT.partial is left as a crash
//                                 leaves it
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstring>
#include <vector>

#include "core/recording/reader/recording_salvage.h"
#include "core/recording/recovery/verify.h"
#include "core/recording/writer/recording_writer.h"
#include "core/replay/replay.h"

namespace {

using namespace fyd;

template <class T>
T orFail(Result<T> result) {
  if (result) return std::move(*result);
  throw std::runtime_error(result.error().text());
}
void orFail(const Result<void>& result) {
  if (!result) throw std::runtime_error(result.error().text());
}

void replayed(const std::string& path) {
  const auto recording = orFail(recording::Recording::open(path));
  const auto first = orFail(recording->step(0)).inputs;
  const auto result = orFail(replay::replay(*recording, {}, {}));
  const nlohmann::json out = {
      {"identical", result.identical},
      {"beyond_tolerance", result.beyond_tolerance},
      {"intact", orFail(recording::verify(path, {})).intact()},
      {"samples", result.samples},
      {"lacking", recording->info().missing_columns},
      {"values", {first.finger.value.inserted_mm2, first.inserted_K, first.inserted.value.value_K}},
      {"count", first.inserted.count}};
  std::puts(out.dump().c_str());
}

void copied(const std::string& from, const std::string& to) {
  const auto recording = orFail(recording::DamagedRecording::open(from));  // steps as they stand in the file
  // What the file has no columns for is what the step gives.
  std::vector<pipeline::TelemetrySample> filled;
  (void)orFail(replay::replay(*orFail(recording::Recording::open(from)), {},
                              [&filled](const auto&, const auto& recorded) { filled.push_back(recorded); }));
  auto writer = orFail(recording::RecordingWriter::create(to, recording->info().header));
  recording::KnownDamage damage;
  for (std::uint64_t row = 0; row < recording->info().committed_samples; ++row) {
    auto record = orFail(recording->damagedStep(row, damage));
    record.telemetry = filled.at(row);
    pipeline::Inputs& in = record.inputs;
    in.finger.value.inserted_mm2 = 100.5;
    in.inserted_K = 200.5 + static_cast<double>(row);
    in.inserted = {.value = {.value_K = 300.5}, .taken = in.now, .count = 1 + row / 100};
    orFail(writer->append(record));
  }
  orFail(writer->commit());
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 3 && std::strcmp(words[1], "replay") == 0) return replayed(words[2]), 0;
    if (count == 4 && std::strcmp(words[1], "copy") == 0) return copied(words[2], words[3]), 0;
    std::fputs("usage: later_program replay FILE | copy FILE OUT\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "later_program: %s\n", error.what());
  }
  return 1;
}
