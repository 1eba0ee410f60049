#include "viewer/settings.hpp"

#include "image/output_file.hpp"
#include "system/desktop.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <span>

namespace gabor::viewer {

namespace {

std::filesystem::path settings_path() {
    const std::filesystem::path folder = system::settings_folder();
    return folder.empty() ? folder : folder / "gabor-noise" / "viewer.json";
}

} // namespace

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Placement, x, y, width, height, maximized)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Settings, placement, panels, ui_scale, document, preset_path,
                                                export_path, recent, unsaved_by)

Settings load_settings() {
    std::ifstream file(settings_path());
    const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
    try {
        Settings settings = json.get<Settings>();
        Placement& place = settings.placement;
        constexpr int most = 32767;
        place = {std::clamp(place.x, -1, most), std::clamp(place.y, -1, most),
                 std::clamp(place.width, 480, most), std::clamp(place.height, 320, most), place.maximized};
        settings.ui_scale = std::clamp(settings.ui_scale, least_ui_scale, most_ui_scale);
        return settings;
    } catch (const nlohmann::json::exception&) {
        return {}; // the file is missing or broken
    }
}

std::string save_settings(const Settings& settings) {
    const std::filesystem::path path = settings_path();
    try {
        if (path.empty())
            throw std::runtime_error("neither HOME nor XDG_CONFIG_HOME is set");
        std::filesystem::create_directories(path.parent_path());
        const std::string text =
            nlohmann::json(settings).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
        image::OutputFile file(path);
        file.write(std::as_bytes(std::span(text)));
        file.commit();
        return {};
    } catch (const std::exception& error) {
        return fmt::format("cannot keep settings and the session for the next start: {}", error.what());
    }
}

} // namespace gabor::viewer
