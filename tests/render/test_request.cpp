#include "error.hpp"
#include "render/plan/plan.hpp"
#include "render/request/material.hpp"
#include "render/request/parameters.hpp"
#include "set_text.hpp"

#include <catch2/catch.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <string>

using namespace gabor;
using render::Parameter;
using render::Request;
using render::Value;

namespace {

// Returns a value within the range that differs from `value`.
Value another(const Parameter& parameter, const Value& value) {
    switch (parameter.type) {
    case Parameter::Type::flag:
        return !std::get<bool>(value);
    case Parameter::Type::choice: {
        const std::vector<std::string_view>& all = parameter.choices;
        return std::string(all.at(std::get<std::string>(value) == all[1] ? 2 : 1));
    }
    case Parameter::Type::text:
        return "a \"name\".exr";
    case Parameter::Type::lobes:
        return std::vector<noise::Lobe>{{0.1, -33.3, 0.25, 12.345678901234567, 3, 0.7}, {7, 90}};
    case Parameter::Type::colour:
        return std::array{0.1, 0.25, 0.7};
    case Parameter::Type::integer:
        return parameter.range.high;
    default:
        const double third = (parameter.range.high - parameter.range.low) / 3;
        return std::get<double>(value) == parameter.range.low + third ? parameter.range.high - third
                                                                      : parameter.range.low + third;
    }
}

Request of_view(std::string_view name) {
    Request request;
    set_text(request, "view", name);
    return request;
}

bool draw_alike(const Request& a, const Request& b) {
    const auto planned = [](const Request& request) {
        return render::plan(request, render::viewport_of(request, {0, 0, request.width, request.height}));
    };
    const render::Plan one = planned(a), other = planned(b);
    return one.channels == other.channels && one.tables == other.tables &&
           std::ranges::equal(one.steps, other.steps, [](const render::Step& x, const render::Step& y) {
               return x.shader == y.shader && x.constants == y.constants && x.push == y.push &&
                      x.runs == y.runs;
           });
}

const std::vector<std::string_view> views = render::parameter("view").choices;

bool is_accepted(const Request& request) {
    try {
        render::check(request);
        return true;
    } catch (const RequestError&) { // conflicts with the initial request
        return false;
    }
}

} // namespace

TEST_CASE("every parameter survives a round trip through JSON and text exactly, and changes the plan",
          "[request]") {
    std::map<std::string_view, int> seen;
    for (const std::string_view view : views) {
        Request several = of_view(view);
        if (render::is_pattern(several.kind))
            render::set(several, "lobes", std::vector<noise::Lobe>(3));
        std::vector<Request> starts{of_view(view), several};
        for (const std::string_view material : render::materials) {
            for (const bool boards : {false, true}) { // and a coat and a finish
                starts.push_back(of_view(view));
                render::set(starts.back(), "material", std::string(material));
                starts.back().boards = starts.back().coat = starts.back().finish = boards;
            }
        }
        starts.push_back(of_view(view));
        starts.back().fractal.shape = 1;
        if (starts.back().kind == render::Kind::noise)
            starts.back().kind = render::Kind::fractal;
        for (const Request& start : starts) {
            for (const Parameter& parameter : render::parameters()) {
                INFO(view << ", " << start.lobes.size() << " lobes, " << start.material << ", "
                          << parameter.name);
                const std::optional<Value> before = parameter.get(start);
                if (!before)
                    continue;
                Request changed = start;
                const Value value = another(parameter, *before);
                render::set(changed, parameter.name, value);
                REQUIRE_FALSE(changed == start);
                CHECK(*parameter.get(changed) == value);
                const std::string text = render::to_text(value);
                CHECK(render::read(parameter, text) == value);
                Request by_text = start;
                set_text(by_text, parameter.name, text);
                CHECK(by_text == changed);
                if (!is_accepted(changed))
                    continue;
                CHECK(render::from_json(render::to_json(changed)) == changed);
                ++seen[parameter.name];
                CHECK_FALSE(draw_alike(start, changed));
                if (!std::holds_alternative<double>(value))
                    continue;
                auto [low, high] = parameter.slider; // whose ends, too, have an effect
                if (parameter.name == "pitch" &&
                    start.kind == render::Kind::terrain) // no camera is below the ground
                    low = 0;
                for (const auto& [end, sign] : {std::pair(low, 1), {high, -1}}) {
                    Request inside = changed;
                    parameter.place.put(changed, end);
                    const double step =
                        std::max(1e-3 * (high - low), parameter.type == Parameter::Type::integer ? 1.0 : 0.0);
                    parameter.place.put(inside, end + sign * step);
                    INFO(end);
                    if (is_accepted(changed) && is_accepted(inside))
                        CHECK_FALSE(draw_alike(changed, inside));
                }
            }
        }
    }
    for (const Parameter& parameter : render::parameters()) {
        INFO(parameter.name);
        CHECK(seen[parameter.name] > 0);
    }
    CHECK(render::from_json("{}") == Request());
}

TEST_CASE("each member of one lobe survives a round trip through JSON", "[request]") {
    for (double noise::Lobe::*member : {&noise::Lobe::frequency, &noise::Lobe::orientation,
                                        &noise::Lobe::frequency_spread, &noise::Lobe::orientation_spread,
                                        &noise::Lobe::power, &noise::Lobe::radius, &noise::Lobe::stretch}) {
        Request request;
        request.lobes.front().*member = 0.75;
        const std::string text = render::to_json(request);
        INFO(text);
        CHECK_FALSE(request == Request());
        CHECK(render::from_json(text) == request);
    }
}

TEST_CASE("colours are refused with what they cannot colour, and if their JSON is not one of a colour",
          "[request]") {
    const std::string
        start = R"("colour": {"weights": [[[0, 0.8], [0.3, 0.2], [-0.1, 0.4]]], "histogram": [)"
                R"([0, 1, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0]], "mean": [0.5, 0.4, 0.3], )",
        mixing = R"("mixing": [[0.2, 0.1, 0], [0.2, -0.1, 0], [0.1, 0, 0.1]])";
    const auto with = [&](const std::string& rest, const std::string& more = "") {
        return render::from_json("{" + start + rest + "}" + more + "}");
    };
    CHECK_FALSE(with(mixing).colour->linear);
    CHECK(with(mixing + R"(, "linear": true)").colour->linear);
    CHECK(render::from_json(render::to_json(with(mixing))) == with(mixing));
    for (const char* wrong : {R"("mixing": [[1, 0, 0], [0, 1, 0]])",
                              R"("mixing": [[1, 0, 0, 0], [0, 1, 0], [0, 0, 1]])", R"("linear": true)"})
        CHECK_THROWS_WITH(with(wrong), Catch::Contains("a colour has weights"));
    CHECK_THROWS_WITH(with(mixing + R"(, "gamma": 2)"), Catch::Contains("a colour has weights"));
    for (const char* other :
         {R"("gradient": true)", R"("phasor": true)", R"("paint": "a.exr")", R"("material": "wood")"})
        CHECK_THROWS_WITH(with(mixing, std::string(", ") + other), Catch::Contains("colours conflict with"));
    Request request = with(mixing);
    request.quadrature = true;
    CHECK_THROWS_WITH(render::check(request), Catch::Contains("colours conflict with"));
    for (const noise::Lobe& lobe : {noise::Lobe{.power = 0}, noise::Lobe{.frequency_spread = 0.1}}) {
        Request of_two = with(mixing);
        of_two.lobes.push_back(lobe);
        of_two.colour->weights.push_back(of_two.colour->weights.front());
        CHECK_THROWS_WITH(render::check(of_two), Catch::Contains("colour requires weights"));
        render::drop_conflicting(of_two, "lobes");
        CHECK_FALSE(of_two.colour);
    }
    render::drop_conflicting(request, "phasor");
    CHECK_FALSE(request.colour);
}

TEST_CASE("a full turn of an angle changes nothing", "[request]") {
    for (const auto& [view, material, angle] : {std::array{"sphere", "wood", "yaw"},
                                                {"torus", "none", "yaw"},
                                                {"landscape", "none", "yaw"},
                                                {"ocean", "none", "yaw"},
                                                {"flat", "wood", "light_azimuth"},
                                                {"terrain", "none", "light_azimuth"},
                                                {"flat", "none", "orientation"}}) {
        INFO(view << ", " << material << ", " << angle);
        Request turned = of_view(view), other = of_view(view);
        set_text(turned, "material", material);
        set_text(other, "material", material);
        set_text(turned, angle, "-150");
        set_text(other, angle, "570");
        CHECK(draw_alike(turned, other));
    }
}

TEST_CASE("JSON with a member that the request does not have is refused by one line", "[request]") {
    const auto refused = [](const char* json) {
        try {
            render::from_json(json);
            return std::string("accepted");
        } catch (const RequestError& error) {
            return std::string(error.what());
        }
    };
    CHECK(refused(R"({"values": 1})").starts_with("unknown parameter 'values'"));
    CHECK(refused(R"({"quadrature": true})").starts_with("unknown parameter 'quadrature'"));
    CHECK(refused(R"({"lobes": []})") == "lobes: the list of lobes is empty");
    CHECK(refused(R"({"view": "slice", "tileable": false})").starts_with("tileable "));
    CHECK(refused(R"({"frequency": 4, "lobes": [{}, {}]})").starts_with("frequency "));
    CHECK(refused(R"({"wood.rings": 4})").starts_with("wood.rings "));
}

TEST_CASE("out-of-range values are refused, however they are set", "[request]") {
    int refused = 0;
    for (const std::string_view view : views) {
        for (const Parameter& parameter : render::parameters()) {
            Request request = of_view(view);
            if (parameter.range.low == parameter.range.high || !parameter.get(request))
                continue;
            INFO(view << ", " << parameter.name);
            for (const double outside : {parameter.range.low - 1, parameter.range.high + 1,
                                         std::numeric_limits<double>::quiet_NaN()}) {
                CHECK_THROWS_WITH(render::set(request, parameter.name, outside),
                                  Catch::Contains(std::string(parameter.name)));
                parameter.place.put(request,
                                    outside == outside ? outside : 0.25); // programs can bypass set()
                if (outside != outside && parameter.type != Parameter::Type::integer)
                    parameter.place.put(request, outside);
                if (parameter.type != Parameter::Type::integer)
                    CHECK_THROWS_AS(render::check(request), RequestError);
                ++refused;
            }
            if (parameter.type == Parameter::Type::integer)
                CHECK_THROWS_AS(render::set(request, parameter.name, parameter.range.low + 0.5),
                                RequestError);
            for (const double end : {parameter.range.low, parameter.range.high}) {
                render::set(request, parameter.name, end);
                CHECK(std::get<double>(*parameter.get(request)) == end);
            }
        }
    }
    CHECK(refused > 100);
}

// Newer parameters may be missing from the golden file until it is rewritten as CONTRIBUTING.md describes.
TEST_CASE("ranges, sliders and defaults equal those in the golden file", "[request]") {
    std::vector<std::string> rows;
    const auto add = [&](std::string_view name, const render::Range& range, const render::Range& slider,
                         const std::string& value) {
        rows.push_back(fmt::format("{}: {} to {}, slider {} to {}, default {}", name, range.low, range.high,
                                   slider.low, slider.high, value));
    };
    for (const Parameter& parameter : render::parameters()) {
        std::optional<Value> value;
        for (const std::string_view view : views)
            value = value ? value : parameter.get(of_view(view));
        if (parameter.group != Parameter::Group::material && parameter.group != Parameter::Group::boards &&
            parameter.type != Parameter::Type::lobes)
            add(parameter.name, parameter.range, parameter.slider, value ? render::to_text(*value) : "none");
    }
    for (const render::LobeParameter& parameter : render::lobe_parameters())
        add(fmt::format("lobe's {}", parameter.name), parameter.range, parameter.slider,
            fmt::format("{}", noise::Lobe{}.*parameter.member));
    const std::string path = GABOR_GOLDEN_FOLDER "/parameters.txt";
    if (const char* mode = std::getenv("GABOR_GOLDEN"); mode && mode == std::string("write"))
        std::ofstream(path) << fmt::format("{}\n", fmt::join(rows, "\n"));
    std::ifstream file(path);
    std::size_t lines = 0;
    for (std::string line; std::getline(file, line); ++lines) {
        INFO(line);
        CHECK(std::ranges::find(rows, line) != rows.end());
    }
    CHECK(lines > 40);
}

TEST_CASE("a body keeps its pose when its shape changes, and the order of parameters does not matter",
          "[request]") {
    Request body = of_view("sphere");
    set_text(body, "yaw", "30");
    set_text(body, "view", "torus");
    CHECK(body.view == render::View{.projection = render::Projection::torus, .orbit = {.yaw = 30}});
    CHECK(render::from_json(R"({"depth": 2, "view": "slice"})").view ==
          render::View{.projection = render::Projection::slice, .depth = 2});
}

TEST_CASE("conflicting parameters are refused, or dropped on request", "[request]") {
    struct Pair {
        Request start;
        const char* first;
        const char* first_value;
        const char* second;
        const char* second_value;
    };
    for (const Pair& pair : {Pair{of_view("flat"), "paint", "a.exr", "lobes", "[{}, {}]"},
                             Pair{of_view("flat"), "paint", "a.exr", "view", "horizon"},
                             Pair{of_view("flat"), "filter", "true", "recipe", "lattice-2"},
                             Pair{of_view("flat"), "lobes", "[{\"stretch\": 2}]", "recipe", "one"},
                             Pair{of_view("flat"), "evolution", "0.5", "material", "sand"},
                             Pair{of_view("flat"), "phasor", "true", "material", "sand"},
                             Pair{of_view("flat"), "recipe", "one", "material", "wood"},
                             Pair{of_view("flat"), "recipe", "one", "view", "terrain"},
                             Pair{of_view("flat"), "recipe", "lattice-4", "view", "slice"},
                             Pair{of_view("flat"), "recipe", "pure", "view", "sphere"}}) {
        INFO(pair.first << ", " << pair.second);
        Request both = pair.start;
        set_text(both, pair.first, pair.first_value);
        render::check(both);
        CHECK(render::is_set(both, pair.first));
        set_text(both, pair.second, pair.second_value);
        CHECK_THROWS_WITH(render::check(both), Catch::Contains("conflicts with"));
        Request first = both;
        render::drop_conflicting(first, pair.first);
        render::check(first);
        CHECK(render::is_set(first, pair.first));
        CHECK_FALSE(render::is_set(first, pair.second));
        Request second = both;
        render::drop_conflicting(second, pair.second);
        render::check(second);
        CHECK(render::is_set(second, pair.second));
    }
    CHECK_THROWS_AS(render::check({.lobes = {}}), RequestError);
}
