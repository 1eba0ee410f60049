#include "error.hpp"
#include "render/picture.hpp"

#include <catch2/catch.hpp>

#include <limits>

using namespace gabor;

TEST_CASE("a picture survives JSON exactly", "[picture]") {
    const render::Picture picture{640, 65536, 31.700000000000003, 0.1, -33.3, 4294967295u, "paper"};
    const render::Picture back = render::from_json(render::to_json(picture));
    CHECK(back.width == picture.width);
    CHECK(back.height == picture.height);
    CHECK(back.scale == picture.scale);
    CHECK(back.frequency == picture.frequency);
    CHECK(back.orientation == picture.orientation);
    CHECK(back.seed == picture.seed);
    CHECK(back.recipe == picture.recipe);
    CHECK(render::from_json("{}").width == render::Picture().width);
}

TEST_CASE("bad parameters are named", "[picture]") {
    const auto refused = [](const char* json, const char* word) {
        INFO(json);
        CHECK_THROWS_AS(render::from_json(json), RequestError);
        CHECK_THROWS_WITH(render::from_json(json), Catch::Contains(word));
    };
    refused("", "not a JSON object");
    refused("[1]", "not a JSON object");
    refused("{\"seed\": -1}", "seed");
    refused("{\"seed\": 4294967296}", "seed");
    refused("{\"seed\": 1.5}", "seed");
    refused("{\"width\": 18446744073709551615}", "width");
    refused("{\"width\": 65537}", "65536");
    refused("{\"scale\": \"32\"}", "scale");
    refused("{\"scale\": 1e400}", "JSON");
    refused("{\"frequency\": 0}", "0.001");
    refused("{\"recipe\": 1}", "recipe");
    refused("{\"recipe\": \"best\"}", "one, pure, paper");
    refused("{\"colour\": 1}", "colour");
    render::Picture picture;
    picture.frequency = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(render::check(picture), RequestError);
    picture.frequency = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(render::check(picture), RequestError);
}
