#include "cli/commands.hpp"
#include "vulkan/device.hpp"

#include <fmt/format.h>

namespace gabor::cli {

namespace {

void print_devices() {
    for (const vulkan::DeviceInfo& device : vulkan::devices()) {
        fmt::print("{}  {}\n", device.index, device.name);
        fmt::print("   kind            {}\n", device.kind);
        fmt::print("   driver          {}\n", device.driver);
        fmt::print("   Vulkan          {}\n", device.api);
        fmt::print("   memory          {} MiB\n", device.memory >> 20);
        fmt::print("   storage buffer  {} MiB at most\n", device.storage_buffer >> 20);
        fmt::print("   workgroup       {} invocations at most, {} to a subgroup\n", device.group_invocations,
                   device.subgroup);
        fmt::print("   GPU times       {}\n", device.timestamps ? "yes" : "no");
    }
}

} // namespace

void add_devices_command(CLI::App& app) {
    app.add_subcommand("devices", "List the Vulkan devices, their drivers and the limits that matter here")
        ->callback(print_devices);
}

} // namespace gabor::cli
