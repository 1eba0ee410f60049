#pragma once

#include <stdexcept>

namespace gabor {

/// The request itself was wrong: the message says what was wrong and what is accepted. Exit status 2.
/// Every other exception means that a correct request failed while working. Exit status 1.
class RequestError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace gabor
