#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "names.hpp"
#include "noise/recipe.hpp"
#include "render/request/material.hpp"
#include "render/request/parameters.hpp"
#include "vulkan/device.hpp"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace gabor::cli {

namespace {

void print_devices() {
    for (const vulkan::DeviceInfo& device : vulkan::devices())
        fmt::print(R"({}  {}
   kind            {}
   driver          {}
   Vulkan          {}
   memory          {} MiB
   storage buffer  {} MiB at most
   workgroup       {} invocations at most, {} per subgroup
   GPU timing      {}
)",
                   device.index, device.name, device.kind, device.driver, device.api, device.memory >> 20,
                   device.storage_buffer >> 20, device.group_invocations, device.subgroup,
                   device.timestamps ? "yes" : "no");
}

void print_recipes(bool as_json) {
    nlohmann::ordered_json list;
    for (const noise::Recipe& recipe : noise::recipes()) {
        auto macros = nlohmann::ordered_json::object();
        for (const noise::Macro& macro : noise::macros(recipe))
            macros[std::string(macro.name)] = macro.value;
        list.push_back({{"name", recipe.name},
                        {"is", recipe.summary},
                        {"visited", noise::visited_impulses(recipe)},
                        {"file", noise::drop_in(recipe)},
                        {"macros", macros}});
        if (as_json)
            continue;
        fmt::print("{:<10}{}, {}; {} {} visited\n", recipe.name, noise::drop_in(recipe), recipe.summary,
                   noise::visited_impulses(recipe), recipe.is_lattice() ? "nodes" : "impulses");
        for (const noise::Macro& macro : noise::macros(recipe))
            fmt::print("          #define {} {}\n", macro.name, macro.value);
    }
    if (as_json)
        fmt::print("{}\n", list.dump(2));
}

void print_material(const std::string& text) {
    std::vector<std::string_view> names(render::materials.begin(), render::materials.end());
    names.insert(names.end(), {"boards", "coat", "finish"});
    const std::string name(in_any_case(text, names));
    if (std::ranges::find(names, name) == names.end())
        throw RequestError(fmt::format("MATERIAL '{}': {}", text, expected(text, names)));
    using enum render::Parameter::Group;
    const auto group = name == "boards"   ? boards
                       : name == "coat"   ? coat
                       : name == "finish" ? finish
                                          : material;
    render::Request request;
    render::set(request, "material", group == material ? name : "wood");
    request.boards = request.coat = request.finish = true;
    for (const render::Parameter& p : render::parameters())
        if (p.group == group && p.scope.holds(request))
            fmt::print("{:<32}{}: {} [{}]\n", render::option_name(p), p.help, render::accepted(p),
                       render::to_text(*p.get(request)));
}

} // namespace

void add_devices_command(CLI::App& app) {
    app.add_subcommand("devices", "List the Vulkan devices with their drivers and limits")
        ->callback(print_devices);
}

void add_materials_command(CLI::App& app) {
    auto name = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand(
        "materials", "List materials, or the options of one, of boards, a coat or a finish");
    add_option(*command, "MATERIAL", *name, "",
               fmt::format("{}, boards, coat or finish", fmt::join(render::materials, ", ")));
    command->callback([name] {
        if (!name->empty())
            print_material(*name);
        else
            fmt::print("{}\n", fmt::join(render::materials, "\n"));
    });
}

void add_recipes_command(CLI::App& app) {
    auto as_json = std::make_shared<bool>(false);
    CLI::App* command =
        app.add_subcommand("recipes", "List the recipes, and the GLSL macros that select them");
    command->add_flag("--json", *as_json, "Print JSON");
    command->callback([as_json] { print_recipes(*as_json); });
}

} // namespace gabor::cli
