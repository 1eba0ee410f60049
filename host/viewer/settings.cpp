#include "viewer/settings.hpp"

#include "image/output_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>

namespace gabor::viewer {

namespace {

std::filesystem::path settings_path() {
    if (const char* folder = std::getenv("XDG_CONFIG_HOME"); folder && *folder)
        return std::filesystem::path(folder) / "gabor-noise" / "viewer.json";
    if (const char* home = std::getenv("HOME"); home && *home)
        return std::filesystem::path(home) / ".config" / "gabor-noise" / "viewer.json";
    return {};
}

} // namespace

Settings load_settings() {
    Settings settings;
    std::ifstream file(settings_path());
    const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
    try {
        const auto number = [&](const char* name, int low, int high, int& into) {
            into = std::clamp(json.at(name).get<int>(), low, high);
        };
        Settings read;
        number("x", -1, 32767, read.placement.x);
        number("y", -1, 32767, read.placement.y);
        number("width", 480, 32767, read.placement.width);
        number("height", 320, 32767, read.placement.height);
        read.placement.maximized = json.at("maximized").get<bool>();
        read.panels = json.at("panels").get<bool>();
        read.ui_scale = std::clamp(json.value("ui_scale", 1.0f), least_ui_scale, most_ui_scale);
        read.document = json.value("document", std::string());
        read.preset_path = json.value("preset", std::string());
        read.export_path = json.value("export", std::string());
        read.recent = json.value("recent", std::vector<std::string>());
        read.unsaved_by = json.value("unsaved_by", 0);
        settings = read;
    } catch (const nlohmann::json::exception&) {
        // no file, or one of another version
    }
    return settings;
}

void save_settings(const Settings& settings) {
    const std::filesystem::path path = settings_path();
    const nlohmann::ordered_json json{{"x", settings.placement.x},
                                      {"y", settings.placement.y},
                                      {"width", settings.placement.width},
                                      {"height", settings.placement.height},
                                      {"maximized", settings.placement.maximized},
                                      {"panels", settings.panels},
                                      {"ui_scale", settings.ui_scale},
                                      {"document", settings.document},
                                      {"preset", settings.preset_path},
                                      {"export", settings.export_path},
                                      {"recent", settings.recent},
                                      {"unsaved_by", settings.unsaved_by}};
    try {
        std::filesystem::create_directories(path.parent_path());
        const std::string text =
            json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
        image::OutputFile file(path);
        file.write(std::as_bytes(std::span(text)));
        file.commit();
    } catch (const std::exception&) {
        // unsaved settings are ignored
    }
}

} // namespace gabor::viewer
