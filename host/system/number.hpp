#pragma once

#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>
#include <type_traits>

namespace gabor::system {

/// std::from_chars for a float or double, by the C library, whose locale must be "C" for numbers.
template <class Float>
std::from_chars_result from_chars_by_strtod(const char* first, const char* last, Float& value) {
    std::string text(first, last);
    const std::size_t start = text.starts_with('-') ? 1 : 0;
    // strtod would also take spaces, a second sign and hexadecimal digits.
    if (start == text.size() ||
        (!std::isalnum(static_cast<unsigned char>(text[start])) && text[start] != '.'))
        return {first, std::errc::invalid_argument};
    if (text[start] == '0' && start + 1 < text.size() && std::tolower(text[start + 1]) == 'x')
        text.resize(start + 1);
    char* stop = nullptr;
    errno = 0;
    Float number = 0;
    if constexpr (std::is_same_v<Float, float>)
        number = std::strtof(text.c_str(), &stop);
    else
        number = std::strtod(text.c_str(), &stop);
    const char* const end = first + (stop - text.c_str());
    if (end == first)
        return {first, std::errc::invalid_argument};
    if (errno == ERANGE && (number == 0 || std::isinf(number)))
        return {end, std::errc::result_out_of_range};
    value = number;
    return {end, std::errc()};
}

using std::from_chars;

#ifndef __cpp_lib_to_chars // Apple's library reads only integers before macOS 26
inline std::from_chars_result from_chars(const char* first, const char* last, float& value) {
    return from_chars_by_strtod(first, last, value);
}
inline std::from_chars_result from_chars(const char* first, const char* last, double& value) {
    return from_chars_by_strtod(first, last, value);
}
#endif

} // namespace gabor::system
