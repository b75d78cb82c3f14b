// Parameters of the link to the robot, on the touchpad's side.
#pragma once

#include "core/base/parameter.h"

namespace fyd::protocol {

struct LinkParameters {
  double lost_cap_ms = 100.0;
  double closing_s = 3.0;
  double takeover_silence_s = 1.0;
  double state_rate_Hz = 100.0;
  double touch_rate_Hz = 100.0;
  double freshness_ms = 300.0;
  double flow_bit_per_s = 0.0;
  bool classic_images = false;

  template <class Visitor>
  void describe(Visitor& v) {
    v.real("link.lost_cap_ms", lost_cap_ms,
           {.unit = "ms",
            .minimum = 20,
            .maximum = 2000,
            .help = "Longest silence of the robot before the link counts as lost, however slow or uneven it sends."});
    v.real("link.closing_s", closing_s,
           {.unit = "s",
            .minimum = 0,
            .maximum = 30,
            .help = "How long a robot that said goodbye is still answered when another one takes its place."});
    v.real("link.takeover_silence_s", takeover_silence_s,
           {.unit = "s",
            .minimum = 0.1,
            .maximum = 600,
            .help = "Silence of a robot after which another one may take its place."});
    v.real("link.state_rate_Hz", state_rate_Hz,
           {.unit = "Hz",
            .minimum = 1,
            .maximum = 1000,
            .help = "States a second that a robot on FYD Link is granted at most; each carries the accelerations "
                    "since the last, the newest 32 of them."});
    v.real(
        "link.touch_rate_Hz", touch_rate_Hz,
        {.unit = "Hz",
         .minimum = 10,
         .maximum = 1000,
         .help = "Touches a second that a robot on FYD Link is sent at most; it takes longer gaps for a lost link."});
    v.real("link.freshness_ms", freshness_ms,
           {.unit = "ms",
            .minimum = 20,
            .maximum = 5000,
            .help = "Age from which a message of FYD Link is refused, however authentic it is."});
    v.real("link.flow_bit_per_s", flow_bit_per_s,
           {.unit = "bit/s",
            .minimum = 0,
            .maximum = 1e10,
            .help = "Flow of the line to the robot, to which FYD Link fits its touches; 0: as much as they need."});
    v.boolean("link.classic_images", classic_images,
              {.help = "Send camera pictures when a classic robot asks for them; off, because the published robot "
                       "program asks and cannot read them."});
  }
};

}  // namespace fyd::protocol
