#pragma once

namespace gabor::cli {

/// The whole program: does what the command line asks for and returns the exit status, 0 done, 1 failed while
/// working, 2 the request was wrong. Errors are one line on stderr. After SIGINT or SIGTERM it cleans up and
/// does not return: the signal ends the process.
int run(int argc, const char* const* argv);

} // namespace gabor::cli
