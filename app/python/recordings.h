// A recording that Python has open.
#pragma once

#include "app/python/common.h"
#include "core/recording/reader/recording.h"

namespace fyd::python {

class OpenRecording {
 public:
  /// @throws Failure
  explicit OpenRecording(const std::string& path);
  ~OpenRecording();
  OpenRecording(const OpenRecording&) = delete;
  OpenRecording& operator=(const OpenRecording&) = delete;

  /// Runs work(recording), which reads and touches no Python object, without the interpreter's lock. What it returns
  /// as a Result is taken out. @throws Failure, also when it is closed
  template <class Work>
  auto run(Work&& work) {
    const Hdf5Turn turn;
    return done(file_.run(
        [&](std::unique_ptr<recording::Recording>& file) -> std::invoke_result_t<Work, recording::Recording&> {
          if (!file) throw Failure{path_ + ": is closed"};
          return work(*file);
        }));
  }
  [[nodiscard]] recording::RecordingInfo info() {
    return run([](recording::Recording& file) -> Result<recording::RecordingInfo> { return file.info(); });
  }
  void close();

 private:
  std::string path_;
  Shared<std::unique_ptr<recording::Recording>> file_;
};

}  // namespace fyd::python
