// The recorder's settings.
#pragma once

namespace fyd::recording {

struct RecorderOptions {
  double pre_trigger_s = 10.0;
  double smallest_free_MB = 200.0;
  double whole_pictures_Hz = 10.0;

  template <class Visitor>
  void describe(Visitor& v) {
    v.real("session.pre_trigger_s", pre_trigger_s,
           {.unit = "s", .minimum = 0, .maximum = 60, .help = "How far before its start a recording reaches back."});
    v.real("session.smallest_free_MB", smallest_free_MB,
           {.unit = "MB",
            .minimum = 10,
            .maximum = 1e6,
            .help = "A recording stops, closed and whole, before the disk has less room than this."});
    v.real("session.whole_pictures_Hz", whole_pictures_Hz,
           {.unit = "Hz",
            .minimum = 0.1,
            .maximum = 1000,
            .help = "Whole pictures recorded in a second; the region of interest is recorded of every picture."});
  }
};

}  // namespace fyd::recording
