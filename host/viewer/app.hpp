#pragma once

#include "viewer/gui.hpp"
#include "viewer/painter.hpp"
#include "viewer/script.hpp"
#include "viewer/settings.hpp"
#include "viewer/shaders.hpp"

#include <deque>
#include <memory>
#include <optional>

namespace gabor::viewer {

struct Options {
    Document document;
    std::string device;                    ///< as for vulkan::Device
    std::filesystem::path shaders;         ///< empty for those built in
    std::optional<std::string> screenshot; ///< one picture, and no window
    std::optional<std::filesystem::path> script;
    std::optional<Extent> size; ///< of the window
};

/// The program: a window, what it shows, and what is done in it.
class App {
  public:
    explicit App(const Options& options);
    ~App();

    /// Until the window is closed, or a script ends.
    void run();
    /// The picture itself, without a window around it, as gabor render would have it.
    void save_picture(const std::string& path);

  private:
    /// What belongs to one side beyond what panels see.
    struct Work {
        std::unique_ptr<Canvas> canvas;
        std::unique_ptr<Law> law;
        std::string measured; ///< what the samples so far are of
        std::uint32_t samples = 0;
        std::uint32_t draws = 0;
        bool picture_measured = false;
    };

    bool frame(); ///< whether to go on
    void load_shaders();
    void poll_shaders();
    std::vector<Area> areas(Extent window) const;
    bool work(Extent window); ///< whether anything is left to do
    void measure(std::size_t side, const Subject& subject);
    void panels();
    void draw(const Target& target);
    void paint(vk::CommandBuffer commands, const std::vector<Area>& areas);
    void save_window(const std::string& path);
    Script::Hands hands();
    const std::vector<std::uint32_t>& spirv(const Subject& subject) const;

    Settings settings_;
    Window window_;
    vulkan::Device device_;
    Shaders shaders_;
    std::map<std::string, std::vector<std::uint32_t>, std::less<>> spirv_;
    Swapchain swapchain_;
    Gui gui_;
    std::unique_ptr<Painter> painter_;
    vk::raii::CommandPool pool_;
    vk::raii::CommandBuffer commands_ = nullptr;
    Session session_;
    Measurer measurer_;
    std::vector<Work> works_;
    std::optional<Script> script_;
    std::optional<std::string> window_picture_; ///< to save at the end of this frame
    double shaders_polled_ = 0;
    double last_input_ = 0;
    bool busy_ = true;
    bool remember_;
};

} // namespace gabor::viewer
