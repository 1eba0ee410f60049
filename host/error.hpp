#pragma once

#include <stdexcept>
#include <string>

namespace gabor {

/// Means that the request itself was wrong; the exit status is 2. The message says what was wrong and what is
/// accepted. Any other exception means that a valid request could not be carried out; the exit status is 1.
class RequestError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Returns the result of `work`. If `work` throws RequestError, adds a prefix to the message.
template <typename Work>
auto with_prefix(const std::string& prefix, Work work) {
    try {
        return work();
    } catch (const RequestError& error) {
        throw RequestError(prefix + error.what());
    }
}

} // namespace gabor
