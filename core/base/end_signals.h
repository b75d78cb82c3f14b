// Signals that ask a program to end, remembered so that it ends by itself, with its recording closed:
// SIGINT (Ctrl+C), SIGTERM (logout, shutdown, kill) and SIGHUP (the terminal or the session is gone).
//
// SIGINT or SIGTERM one second or more after the first ends the program at once, in case it does not react to the
// first. An earlier one counts as a repetition: a logout sends SIGTERM and SIGHUP together, a shell repeats its
// terminal's SIGHUP.
#pragma once

namespace fyd {

/// From now on; what came before is forgotten. SIGHUP stays ignored where the caller has it ignored, as nohup does.
void watchForEnd();

/// The first that came since `watchForEnd`; 0: none.
[[nodiscard]] int endSignal();

/// Becomes readable when one comes, for a program that waits for events; -1 before `watchForEnd`.
[[nodiscard]] int endSignalDescriptor();

/// Exit code that a shell reports for a program ended by a signal.
[[nodiscard]] constexpr int exitCodeOf(int signal) { return 128 + signal; }

/// A reader that went away (SIGPIPE) and a limit on the size of files (SIGXFSZ) no longer end the program in the middle
/// of its work: the write fails, with EPIPE or EFBIG, as it does on a full disk. Standard input, output and error that
/// are closed no longer lend their numbers to the files and devices that are opened later, which would get what is
/// printed; printing there still fails. For the first line of a `main`.
void makeFailedWritesErrors();

}  // namespace fyd
