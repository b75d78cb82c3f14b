// The plant of felt_peer.py: motors, rollers, cloth and finger, written from the requirement. It stands in C++ for speed
// only and shares nothing with the program: no header, no library.
//
// Per motor, speed w in deg/s, drive in parts of the largest duty:
//   motor   w' = (W/T)(k u/100 - w/W - load - F(w) sgn w), F(w) = b (c + (1 - c) exp(-(w/v)^2)), stuck while |drive| < b
//   board   u = clip(clip(25 %/deg (reference - angle)) + duty), both within +-100 %
//   second  7 % weaker with its own friction; it pulls the other way
//   finger  x'' = 2 z W0 (r' - x') + W0^2 (r - x), r the mean of both rollers
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace {

constexpr int kStepsPerSample = 10;
constexpr double kStep_s = 1e-3 / kStepsPerSample;
constexpr double kGravity = 9.80665;

constexpr double kTimeConstant_s = 0.015;
constexpr double kFreeSpeed_deg_s = 207.0;
constexpr double kStribeckSpeed_deg_s = 6.0;
constexpr double kSecondStrength = 0.93;
constexpr double kLoad = 0.04;
constexpr double kPositionGain = 25.0;  // % of duty per degree
constexpr double kPlay_deg = 0.5;       // to each side, where there is any
constexpr double kRadius_m = 0.010;

struct Motor {
  double strength = 0, pull = 0, breakaway = 0;
  double hold = 0;  // the reference at which it stands still
  double angle = 0, speed = 0, bent = 0, roller = 0;
};

void step(Motor& motor, double duty, double sliding, double presliding, bool slack) {
  const double held = std::clamp(kPositionGain * (motor.hold - motor.angle), -100.0, 100.0);
  const double u = std::clamp(held + duty, -100.0, 100.0);
  const double drive = motor.strength * u / 100 - motor.speed / kFreeSpeed_deg_s - motor.pull;
  const double ratio = motor.speed / kStribeckSpeed_deg_s;
  const double slide = motor.breakaway * (sliding + (1 - sliding) * std::exp(-ratio * ratio));
  const double push = kStep_s * kFreeSpeed_deg_s / kTimeConstant_s;
  if (presliding > 0) {  // Dahl's bristles instead of sticking
    const double reach = presliding * slide / std::max(motor.breakaway, 1e-12);
    motor.bent = std::clamp(motor.bent + kStep_s * motor.speed, -reach, reach);
    motor.speed += push * (drive - motor.breakaway * motor.bent / presliding);
  } else {
    const double pushed = motor.speed + push * drive;
    const double brake = push * (motor.speed == 0 ? motor.breakaway : slide);
    motor.speed = std::copysign(std::max(std::abs(pushed) - brake, 0.0), pushed);
  }
  motor.angle += kStep_s * motor.speed;
  motor.roller = slack ? std::clamp(motor.roller, motor.angle - kPlay_deg, motor.angle + kPlay_deg) : motor.angle;
}

}  // namespace

// What all runs have in common. The order is that of felt_peer.py.
struct Plant {
  double damping;
  double friction;  // of the second motor, in that of the first
  double sliding;   // friction while it slides, in that at which it breaks away
  double presliding_deg;
  double alive;  // strength of the second motor, 0: it is dead
  double slack;  // 1: the rollers have play
};

// duty: samples × runs × 2, %; breakaway_percent, resonance_Hz: one a run; finger_g: samples × runs; angle_deg: samples × runs × 2.
extern "C" void feltPlant(const Plant* plant, std::size_t samples, std::size_t runs, const double* duty,
                          const double* breakaway_percent, const double* resonance_Hz, double* finger_g,
                          double* angle_deg) {
  for (std::size_t run = 0; run < runs; ++run) {
    const double b = breakaway_percent[run] / 100;
    const double w0 = 2 * std::numbers::pi * resonance_Hz[run];
    const double second = kSecondStrength * plant->alive;
    std::array<Motor, 2> motors{
        Motor{.strength = 1, .pull = kLoad, .breakaway = b, .hold = kLoad * 100 / kPositionGain},
        Motor{.strength = second,
              .pull = -kLoad,
              .breakaway = b * plant->friction,
              .hold = second > 0 ? -kLoad / second * 100 / kPositionGain : 0.0}};
    double x = 0, v = 0, before = 0;  // m, m/s, m
    for (std::size_t n = 0; n < samples; ++n) {
      const std::size_t at = n * runs + run;
      double sum = 0;
      for (int part = 0; part < kStepsPerSample; ++part) {
        for (std::size_t m = 0; m < 2; ++m) {
          step(motors[m], duty[2 * at + m], plant->sliding, plant->presliding_deg, plant->slack > 0);
        }
        const double turned_deg = (motors[0].roller + motors[1].roller) / 2;
        const double r = turned_deg * std::numbers::pi / 180 * kRadius_m;
        const double a = 2 * plant->damping * w0 * ((r - before) / kStep_s - v) + w0 * w0 * (r - x);
        before = r;
        v += kStep_s * a;
        x += kStep_s * v;
        sum += a;
      }
      finger_g[at] = sum / kStepsPerSample / kGravity;
      for (std::size_t m = 0; m < 2; ++m) angle_deg[2 * at + m] = motors[m].angle;
    }
  }
}
