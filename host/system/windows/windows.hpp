#pragma once

// <windows.h> without its macros and rarer parts, and its errors as exceptions.

#define NOMINMAX 1 // as libstdc++ defines it
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <memory>
#include <system_error>

namespace gabor::system {

/// Throws Windows' last error, whose message is in the user's language.
[[noreturn]] inline void fail(DWORD error = ::GetLastError()) {
    throw std::system_error(static_cast<int>(error), std::system_category());
}

/// Closes a handle.
struct CloseHandle {
    void operator()(HANDLE handle) const { ::CloseHandle(handle); }
};

/// A handle that closes itself; null for none.
using Handle = std::unique_ptr<void, CloseHandle>;

} // namespace gabor::system
