// From the texture signal to a duty cycle in % [thesis §4.1.4]. The sign is the turning direction.
#pragma once

#include <cstdint>

namespace fyd::texture {

struct PwmSettings {
  double k_vib = 1.0;
  double full_scale_g = 2.0;        ///< s_max, > 0
  double maximum_percent = 100.0;   ///< MAX, 0…100
  double dead_zone_percent = 25.0;  ///< DEADZONE, 0…100; the edge itself passes

  template <class Archive>
  void serialize(Archive& archive) {
    archive(k_vib, full_scale_g, maximum_percent, dead_zone_percent);
  }
};

struct Duty {
  double percent = 0.0;
  bool clipped = false;  ///< a limit cut it
};

/// round(k_vib · s/s_max · MAX), halves away from zero, so that −s gives exactly the opposite; limited to ±MAX; zero
/// inside the dead zone. A signal that is not finite gives 0.
[[nodiscard]] Duty symmetricDuty(double signal_g, const PwmSettings& settings);

/// As printed: ⌊s/s_max · MAX⌋, limited to ±MAX, zero inside the dead zone, and times k_vib at the very end, so that
/// the product may exceed 100 and the floor pulls both signs downward. A signal that is not finite gives 0.
[[nodiscard]] Duty thesisDuty(double signal_g, const PwmSettings& settings);

/// What may really be sent: within ±min(MAX, 100), and within ±100 together with the share (signed, %) that the board's
/// position loop uses at the same time. An unknown share (NaN) counts as none: the board then limits the sum itself,
/// unseen.
[[nodiscard]] Duty limitDuty(const Duty& wanted, double maximum_percent, double position_share_percent);

}  // namespace fyd::texture
