// Compares the replacement of std::from_chars, which Apple's systems need, with it.

#include "system/number.hpp"

#include <catch2/catch.hpp>

#include <string_view>

TEST_CASE("numbers are read as by std::from_chars") {
    using gabor::system::from_chars_by_strtod;
    for (const std::string_view text : {"0",      "1.5", "-2",    "-0.25e3",  ".5",
                                        "5.",     "1e",  "1e400", "-1e400",   "1e-400",
                                        "1e39",   "nan", "-inf",  "infinity", "",
                                        "-",      "--1", "+1",    " 1",       "0x10",
                                        "-0x1p3", "1,5", "12abc", "e5",       "9007199254740993"}) {
        CAPTURE(text);
        const auto compare = [&](auto value) {
            auto expected = value, found = value;
            const char *const first = text.data(), *const last = first + text.size();
            const std::from_chars_result by_library = std::from_chars(first, last, expected);
            const std::from_chars_result by_strtod = from_chars_by_strtod(first, last, found);
            CHECK(by_strtod.ec == by_library.ec);
            CHECK(by_strtod.ptr == by_library.ptr);
            CHECK((found == expected || (found != found && expected != expected)));
        };
        compare(7.0);
        compare(7.0f);
    }
}
