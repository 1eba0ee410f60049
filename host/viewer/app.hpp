#pragma once

#include "viewer/gallery.hpp"
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
    std::optional<Document> document; ///< if not set, the document of the last session
    std::string preset;               ///< file or preset to open; empty for none
    std::string device;               ///< selector, as for vulkan::Device
    std::optional<Extent> size;       ///< size of the window
    std::optional<float> ui_scale;    ///< if not set, the scale of the last session
};

/// The program: a window and everything in it.
class App {
  public:
    /// Called in each frame once Dear ImGui has the window's input, so that tests can add their own.
    /// Returning false ends the program.
    using FrameHook = std::function<bool(App&)>;

    explicit App(const Options& options);
    ~App(); ///< saves the session

    /// Runs until the window is closed, the hook returns false, or SIGINT or SIGTERM arrives. Returns that
    /// signal, or 0.
    int run(const FrameHook& hook = {});

    Session& session() { return session_; }
    const Window& window() const { return window_; }
    /// Whether the picture is drawn at full resolution.
    bool fine() const { return canvas_.fine(); }
    /// Saves only the picture, with the size and camera of gabor render.
    void save_picture(const std::string& path);
    /// Saves the window with its panels, at the end of this frame.
    void save_window(const std::string& path) { window_png_ = path; }

  private:
    bool frame(const FrameHook& hook); ///< returns whether to continue
    /// Restores the last session, except what the command line sets.
    void restore(const Options& options);
    void save_session();
    Area view_area(Extent window) const; ///< the noise's area, in window pixels
    bool refine(Extent window);          ///< returns whether anything is left to do
    std::string value_under_pointer();
    float view_width() const; ///< width of the view in Dear ImGui's units
    void panels();
    void draw(const RenderTarget& target);
    void paint(vk::CommandBuffer commands, const Area& view);
    void paint_photograph(vk::CommandBuffer commands, const Area& area);
    void paint_presets(vk::CommandBuffer commands, int height);
    void write_png(Extent extent, const std::string& path,
                   const std::function<void(vk::CommandBuffer)>& draw);

    Settings settings_;
    Window window_;
    vulkan::Device device_;
    Swapchain swapchain_;
    Gui gui_;
    Painter painter_;
    Commands commands_;
    Session session_;
    Canvas canvas_;
    std::shared_ptr<const Photograph> photograph_; ///< the photograph in `photograph_pixels_`
    std::optional<vulkan::Buffer> photograph_pixels_;
    std::optional<vulkan::Buffer> preset_pixels_;
    Gallery gallery_;                       ///< as drawn in the last frame that showed it
    std::optional<std::string> window_png_; ///< file to write at the end of this frame
    double last_input_ = 0;
    double saved_at_ = 0; ///< when the session was last saved
    bool busy_ = true;
    double rested_at_ = 0;  ///< when the view was last as fine as its pixels
    std::string unkept_;    ///< why settings could not be kept the last time
    bool small_ = false;    ///< whether the window is too small for the panel
    bool offering_ = false; ///< whether a question offers to restore an unsaved session
};

/// Runs gabor-viewer and returns its exit status. `hook` is passed to App::run.
int run_viewer(int argc, char** argv, const App::FrameHook& hook = {});

} // namespace gabor::viewer
