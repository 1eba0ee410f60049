#pragma once

#include <cstdint>
#include <string_view>

namespace gabor::system {

/// Prepares a program that prints and opens files: call it first in `main`. Printing to a closed stream or
/// pipe, and writing beyond a limit of size, then fail like any other error. On Windows, also makes UTF-8 the
/// encoding of file names and of what is printed, and lets the viewer print to the console that started it.
void prepare();

/// Whether stderr is a terminal that understands ANSI's escape sequences.
bool is_terminal();

/// Makes requests to end the program, such as Ctrl-C, set a flag instead. A process that has not ended a
/// second later ends at once, and so does one that receives a second request.
void note_interrupts();
/// The first request that arrived after `note_interrupts`; 0 for none.
int interrupt();
/// Ends the process in such a way that shells and job schedulers see the request.
[[noreturn]] void end_by(int interrupt);

/// Shows the message of a program with a window, if nobody could see it on stderr.
void show_error(std::string_view message);

/// The number of this process.
int process_id();
/// Whether a process with this number runs.
bool is_running(int process);

/// The largest resident memory of this process so far, in bytes.
std::uint64_t peak_memory();
/// The processor time of this process so far, in seconds.
double cpu_seconds();
/// Makes the C library return memory that software drivers free on other threads. After two minutes of use,
/// the viewer takes 184 MiB with glibc's settings and 288 MiB without.
void return_memory();

} // namespace gabor::system
