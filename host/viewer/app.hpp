#pragma once

#include "viewer/gui.hpp"
#include "viewer/painter.hpp"
#include "viewer/session.hpp"
#include "viewer/settings.hpp"
#include "viewer/target.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace gabor::viewer {

struct Options {
    std::optional<Document> document;      ///< none: that of the last session
    std::string preset;                    ///< from where the document is; empty for nowhere
    std::string device;                    ///< as for vulkan::Device
    std::optional<std::string> screenshot; ///< one picture, and no window
    std::optional<Extent> size;            ///< of the window
    std::optional<float> ui_scale;         ///< none: that of the last session
};

/// The program: a window, what it shows, and what is done in it.
class App {
  public:
    /// What is called in each frame, once Dear ImGui has the window's input: tests play theirs here, and end
    /// the program by returning false.
    using FrameHook = std::function<bool(App&)>;

    explicit App(const Options& options);
    ~App();

    /// Until the window is closed, or the hook ends it.
    void run(const FrameHook& hook = {});

    Session& session() { return session_; }
    const Window& window() const { return window_; }
    /// Whether the picture is in full resolution.
    bool fine() const;
    /// Whether nothing is left to refine, to measure, to fit or to export.
    bool settled() const { return !busy_ && !session_.exporter.running() && !session_.fitter.running(); }
    /// The picture itself, without a window around it, as gabor render would have it.
    void save_picture(const std::string& path);
    /// The window with its panels, at the end of this frame.
    void save_window(const std::string& path) { window_png_ = path; }

  private:
    bool frame(const FrameHook& hook); ///< whether to go on
    void restore(const Options& options);
    Area view_area(Extent window) const; ///< of the noise, in the window's pixels
    bool refine(Extent window);          ///< whether anything is left to do
    void measure(const Drawing& drawing, bool rested);
    float view_width() const; ///< in Dear ImGui's units
    void panels();
    void draw(const Target& target);
    void paint(vk::CommandBuffer commands, const Area& view);
    void paint_photograph(vk::CommandBuffer commands, const Area& area);
    void paint_presets(vk::CommandBuffer commands, const Area& view);
    void write_window_png(const std::string& path);
    Document shown() const; ///< the session's, as its camera shows it

    Settings settings_;
    Window window_;
    vulkan::Device device_;
    Swapchain swapchain_;
    Gui gui_;
    Painter painter_;
    vk::raii::CommandPool pool_;
    vk::raii::CommandBuffer commands_ = nullptr;
    Session session_;
    MeasuringThread measuring_;
    Canvas canvas_;
    ValueSampler sampler_;
    std::optional<render::Request> measured_; ///< whose values these samples are
    std::uint32_t samples_ = 0;
    std::uint32_t draws_ = 0;
    bool picture_measured_ = false;
    Drawing drawn_; ///< in the last frame
    Camera drawn_from_;
    double changed_ = 0;                           ///< when it was something else
    std::shared_ptr<const Photograph> photograph_; ///< whose pixels these are
    std::optional<vulkan::Buffer> photograph_pixels_;
    std::size_t presets_drawn_ = 0; ///< of those whose pixels these are
    std::optional<vulkan::Buffer> preset_pixels_;
    std::optional<std::string> window_png_; ///< to write at the end of this frame
    double last_input_ = 0;
    bool busy_ = true;
    bool remember_; ///< the window's placement, for the next time
};

/// The program gabor-viewer, and the exit status that it ends with. `hook`: as for App::run.
int run_viewer(int argc, char** argv, const App::FrameHook& hook = {});

} // namespace gabor::viewer
