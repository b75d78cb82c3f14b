// The events a step can report, one line each. Included several times, each time with another definition of EVENT:
// no #pragma once.
//
//   EVENT(name, number, label, severity, slides_in, weight, said, logged)
//
//   number     stored in files: it never changes, and a new line takes the next free number
//   label      its name in an exported log
//   severity   information, warning or error, as the window shows it
//   slides_in  whether it is shown as a notice over the window; otherwise it goes to the log
//   weight     in a report and a chart: plain, marked or serious
//   said       the operator's sentence
//   logged     what an exported log says of it
//
// Each is an expression of the event `e`; the last two may use the helpers of the file that reads them.
// Stability: stable since 0.1

// clang-format off
EVENT(state_changed, 0, "state changed",  // state, fault
      e.state == SafetyState::held ? warning : information, e.state == SafetyState::held,
      e.state == SafetyState::held || e.state == SafetyState::stopped ? serious : plain,
      stateSentence(e, lateness), withFault(toString(e.state), e))
EVENT(arm_refused, 1, "arm refused",  // fault: what is missing
      warning, true, plain,
      say("Not armed: {}. {}", phrase(toString(e.fault)), phrase(remedy(e.fault))), withFault("not armed", e))
EVENT(tare_done, 2, "tare done",  // value: largest change of an offset, mm
      information, true, plain,
      say("Tare done; the largest offset moved by {:.2f} mm.", e.value),
      fmt::format("largest change of an offset {:.3f} mm", e.value))
EVENT(tare_failed, 3, "tare failed",  // value: the sensing::TareState that says why
      warning, true, plain,
      say("Tare failed: {}. Keep the cloth untouched and try again.", whyNoTare(e)),
      std::string(toString(static_cast<sensing::TareState>(e.value))))
EVENT(parameter_changed, 4, "parameter changed",  // index, value
      information, false, marked, changeSentence(e, parameters), describeChange(e))
EVENT(parameter_refused, 5, "parameter refused",  // index, value: not live, not finite or out of range
      warning, true, plain,
      say("{} = {} was refused.", nameOf(e, parameters), e.value), describeChange(e) + " (refused)")
EVENT(robot_command, 6, "robot command",  // value: the command
      information, false, plain,
      say("The robot's operator asks: {}.", phrase(toString(static_cast<RobotCommand>(e.value)))),
      fmt::format("command {}", e.value))
EVENT(target_clamped, 7, "target clamped",  // value: nearest reachable stiffness, N/mm
      warning, false, plain,
      say("The target is out of reach; rendering the nearest, {:.3f} N/mm.", e.value),
      fmt::format("nearest reachable {:.3f} N/mm", e.value))
EVENT(time_reversed, 8, "time reversed",  // value: by how many seconds
      error, true, serious,
      say("The clock went back by {:.3f} s; that step moved nothing.", e.value), fmt::format("by {} s", e.value))
EVENT(law_contradicted, 9, "law contradicted",  // value: measured stiffness over that of the law
      warning, true, marked,
      say("The cloth measures {:.2f} times as stiff as its law: the law drives alone. Check light, sensors and "
          "calibration.", e.value),
      fmt::format("measured {:.3f} times the law", e.value))
// clang-format on
