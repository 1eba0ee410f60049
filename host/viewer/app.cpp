#include "viewer/app.hpp"

#include "viewer/document_json.hpp"
#include "viewer/file_dialog.hpp"
#include "viewer/input.hpp"
#include "viewer/overlays.hpp"
#include "viewer/panels.hpp"
#include "viewer/photograph.hpp"

#include "error.hpp"
#include "system/process.hpp"

#include <CLI/CLI.hpp>
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <utility>

namespace gabor::viewer {

namespace {

constexpr double moving_budget = 0.022;  // seconds per frame for drawing the noise
constexpr double resting_budget = 0.060; // the same at rest; longer, because each frame has a fixed cost
constexpr double waking_interval = 0.25; // seconds between frames while nothing happens
constexpr double saving_interval = 2;    // seconds between saves of the session
constexpr const char* first_preset = "desert"; // shown until another document is opened
constexpr float widest_panel = 26;             // in font heights
constexpr float narrowest_panel = 20;

volatile std::sig_atomic_t received_signal = 0;

extern "C" void note_signal(int signal) {
    received_signal = signal;
}

void drop(GLFWwindow* window, int count, const char** paths) {
    Session& session = *static_cast<Session*>(glfwGetWindowUserPointer(window));
    if (count > 0 && !session.question)
        open_file(session, paths[0]);
}

Placement placement(const Options& options, const Settings& settings) {
    Placement placement = settings.placement;
    if (options.size) {
        placement.width = options.size->width;
        placement.height = options.size->height;
        placement.maximized = false;
    }
    return placement;
}

Document first_document() {
    Document document = load_document(first_preset);
    document.path = fmt::format("{}.json", first_preset);
    return document;
}

} // namespace

App::App(const Options& options)
    : settings_(load_settings()), window_(placement(options, settings_)),
      device_(options.device, window_.presentation()), swapchain_(device_, window_.handle()),
      gui_(device_, window_, swapchain_.render_pass(), swapchain_.images(),
           options.ui_scale.value_or(settings_.ui_scale)),
      painter_(device_, swapchain_.render_pass()), commands_(device_),
      session_(options.document ? *options.document : first_document(), options.device), canvas_(device_) {
    restore(options);
    glfwSetWindowUserPointer(window_.handle(), &session_);
    glfwSetDropCallback(window_.handle(), drop);
}

App::~App() {
    device_.state().device.waitIdle();
    save_session();
}

void App::restore(const Options& options) {
    session_.panels = settings_.panels;
    session_.ui_scale = options.ui_scale.value_or(settings_.ui_scale);
    session_.recent = settings_.recent;
    const auto restore_document = [this](bool as_saved) {
        attempt(session_, [&] {
            Document last = document_from_json(settings_.document);
            render::load_paint(last.request.paint); // throws if the file is missing
            last.path = settings_.preset_path;
            if (std::filesystem::exists(last.path))
                last.origin = std::filesystem::absolute(last.path);
            session_.history = History(last);
            if (as_saved)
                session_.saved = last;
            session_.export_target.path = settings_.export_path;
        });
    };
    const bool lost = settings_.unsaved_by != 0 && !system::is_running(settings_.unsaved_by);
    if (!options.preset.empty())
        open_preset(session_, options.preset);
    else if (!options.document && !settings_.document.empty() && !lost)
        restore_document(true);
    if (lost) {
        offering_ = true;
        const auto answered = [=, this](bool restored) {
            offering_ = false;
            if (restored)
                restore_document(false);
        };
        session_.question = Question{"The last session ended before its changes were saved.",
                                     {{"Restore them", [=] { answered(true); }, 'R'},
                                      {"Discard them", [=] { answered(false); }, 'D'}}};
    }
}

void App::save_session() {
    if (offering_ && session_.question) // the settings keep the lost session until the question is answered
        return;
    Document document = session_.document();
    if (session_.playing)
        time_of(document.request) = 0; // playing alone must not cause a save
    const bool unsaved = session_.closing != Closing::now && is_changed(session_);
    Settings settings{window_.placement(), session_.panels || small_,
                      session_.ui_scale,   to_json(document),
                      document.path,       session_.export_target.path,
                      session_.recent,     unsaved ? system::process_id() : 0};
    if (settings == settings_)
        return;
    settings_ = std::move(settings);
    const std::string error = save_settings(settings_);
    if (!error.empty() && error != unkept_)
        notify(session_, error, true);
    unkept_ = error;
}

Area App::view_area(Extent window) const {
    const float per_unit = static_cast<float>(window.width) / std::max(ImGui::GetIO().DisplaySize.x, 1.0f);
    const int width = std::max(static_cast<int>(view_width() * per_unit), 2);
    const int left =
        shows_photograph(session_) ? static_cast<int>(static_cast<float>(width) * session_.divider) : 0;
    return {left, 0, std::max(width - left, 2), window.height};
}

bool App::refine(Extent window) {
    if (!session_.fitter.photograph()) {
        photograph_.reset();
        photograph_pixels_.reset();
    }
    const Area view = view_area(window);
    session_.view = {view.width, view.height};
    session_.tiling.reset();
    if (session_.tiles && has_effect(session_.document(), "tiles"))
        session_.tiling = tiling_of(session_.document(), session_.view);
    if (session_.gallery) // it hides the view
        return false;
    const Camera camera = session_.tiling ? session_.tiling->camera : session_.document().camera;
    const Drawing wanted = drawing_of(session_.document());
    const bool moving = ImGui::IsAnyMouseDown() || session_.playing;
    const double slice =
        resting_budget * std::max(1.0, view.width * view.height / 1e6); // large views take longer to paint
    return canvas_.refine(wanted, camera, session_.tiling ? session_.tiling->tile : session_.view,
                          moving ? moving_budget : slice);
}

// Describes the position under the pointer and the values of the channels there.
std::string App::value_under_pointer() {
    const ImGuiIO& io = ImGui::GetIO();
    const Area view = view_area(window_.pixels());
    const auto per_unit = double{io.DisplayFramebufferScale.x};
    const auto x = static_cast<int>(std::floor(per_unit * double{io.MousePos.x})) - view.x;
    const auto y = static_cast<int>(std::floor(per_unit * double{io.MousePos.y}));
    const Extent grid = canvas_.grid();
    if (io.WantCaptureMouse || ImGui::IsAnyMouseDown() || !canvas_.fine() || session_.tiling || x < 0 ||
        y < 0 || x >= grid.width || y >= grid.height)
        return {};
    const std::size_t channels = canvas_.channels().size();
    const auto at =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(x);
    return reading(session_.document(), {x + 0.5 - grid.width / 2.0, y + 0.5 - grid.height / 2.0},
                   canvas_.channels(), canvas_.pixels().subspan(channels * at, channels));
}

float App::view_width() const {
    const float width = ImGui::GetIO().DisplaySize.x;
    const float em = ImGui::GetFontSize();
    return width - (session_.panels ? std::clamp(0.45f * width, narrowest_panel * em, widest_panel * em) : 0);
}

void App::panels() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    // The panel folds away when the window becomes small, and unfolds when it grows again.
    const bool small = size.x < 1.6f * widest_panel * ImGui::GetFontSize();
    if (small != std::exchange(small_, small))
        session_.panels = !small;
    const float view = view_width();
    if (session_.gallery) {
        gallery_ = gallery_window(session_, view, size.y);
    } else {
        view_overlay(session_, busy_ ? glfwGetTime() - rested_at_ : 0);
        session_.reading = value_under_pointer();
        reading_overlay(session_, view);
        photograph_overlay(session_, view, size.y);
    }
    message_overlay(session_, view, size.y);
    help_window(session_);
    if (!session_.panels) {
        if (small_)
            unfold_button(session_);
        return;
    }
    ImGui::SetNextWindowPos({view, 0});
    ImGui::SetNextWindowSize({size.x - view, size.y});
    ImGui::Begin("panels", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    // Tab moves between fields only while one is being edited; otherwise it is a shortcut.
    ImGui::PushItemFlag(ImGuiItemFlags_NoTabStop, !ImGui::GetIO().WantTextInput);
    side_panel(session_);
    ImGui::PopItemFlag();
    ImGui::End();
}

void App::paint(vk::CommandBuffer commands, const Area& view) {
    if (session_.gallery)
        return paint_presets(commands, view.height);
    if (canvas_.stride() > 0)
        painter_.paint(commands, canvas_, view, session_.document(), session_.tiling);
    if (shows_photograph(session_) && view.x > 0)
        paint_photograph(commands, {0, 0, view.x, view.height});
}

// Paints the photograph at the same position and scale as the noise's picture.
void App::paint_photograph(vk::CommandBuffer commands, const Area& area) {
    if (photograph_ != session_.fitter.photograph()) {
        photograph_ = session_.fitter.photograph();
        photograph_pixels_ = render::upload(device_, photograph_->pixels);
    }
    const Document& document = session_.document();
    const double scale = document.request.scale * document.camera.zoom; // window pixels per kernel radius
    const auto corner = [&](const Coordinate& middle, int first, int pixels) {
        return static_cast<float>(first + pixels / 2.0 -
                                  (static_cast<double>(middle.whole) + middle.part) * scale);
    };
    painter_.paint_colours(
        commands, *photograph_pixels_, photograph_->grid,
        static_cast<float>(photograph_->square * document.camera.zoom),
        {{{corner(document.camera.x, area.x, area.width), corner(document.camera.y, area.y, area.height)},
          area}});
}

void App::paint_presets(vk::CommandBuffer commands, int height) {
    constexpr int cell = PresetPictures::cell;
    constexpr int margin = (cell - PresetPictures::side) / 2;
    const PresetPictures& pictures = preset_pictures();
    const float per_unit = ImGui::GetIO().DisplayFramebufferScale.x;
    if (!preset_pixels_)
        preset_pixels_ = render::upload(device_, pictures.colours);
    const float side = std::round(gallery_.picture_side * per_unit);
    const float stride = side / PresetPictures::side;
    std::vector<PlacedColours> pieces;
    for (const auto& [preset, corner] : gallery_.pictures) {
        const auto index = static_cast<int>(preset);
        const float x = std::round(corner.x * per_unit);
        const float y = std::round(corner.y * per_unit);
        const auto left = static_cast<float>(index % PresetPictures::columns * cell + margin);
        const auto top = static_cast<float>(index / PresetPictures::columns * cell + margin);
        const int first = static_cast<int>(std::max(y, gallery_.top * per_unit));
        const int end = std::min(static_cast<int>(y + side), height);
        pieces.push_back({{x - left * stride, y - top * stride},
                          {static_cast<int>(x), first, static_cast<int>(side), end - first}});
    }
    painter_.paint_colours(commands, *preset_pixels_, pictures.extent, stride, pieces);
}

void App::draw(const RenderTarget& target) {
    const vk::CommandBuffer commands = *commands_;
    commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
    painter_.prepare(commands);
    const vk::ClearValue dark(vk::ClearColorValue(std::array{0.05f, 0.05f, 0.055f, 1.0f}));
    const vk::Extent2D extent(static_cast<std::uint32_t>(target.extent.width),
                              static_cast<std::uint32_t>(target.extent.height));
    commands.beginRenderPass({swapchain_.render_pass(), *target.framebuffer, {{0, 0}, extent}, dark},
                             vk::SubpassContents::eInline);
    paint(commands, view_area(target.extent));
    gui_.draw(commands);
    commands.endRenderPass();
    commands.end();
    swapchain_.present(commands);
}

void App::write_png(Extent extent, const std::string& path,
                    const std::function<void(vk::CommandBuffer)>& draw) {
    swapchain_.wait();
    save_png(
        device_, extent, path, [&](vk::CommandBuffer commands) { painter_.prepare(commands); }, draw);
}

void App::save_picture(const std::string& path) {
    const Document& document = session_.document();
    const Drawing drawing = drawing_of(document);
    const Extent extent{document.request.width, document.request.height};
    while (canvas_.refine(drawing, render::default_camera(document.request), extent, resting_budget)) {
    }
    write_png(extent, path, [&](vk::CommandBuffer commands) {
        painter_.paint(commands, canvas_, {0, 0, extent.width, extent.height}, document);
    });
}

bool App::frame(const FrameHook& hook) {
    swapchain_.wait();
    for (const std::string_view name : file_names(session_))
        gui_.prepare(name);
    gui_.begin();
    if (hook && !hook(*this))
        return false;
    const ImGuiIO& io = ImGui::GetIO();
    render::Request& request = session_.document().request;
    if (session_.playing && request.kind == render::Kind::sea) {
        time_of(request) += double{io.DeltaTime};
    } else if (session_.playing && !render::is_surface(request.kind)) {
        request.evolution += double{io.DeltaTime} / double{session_.period};
        request.evolution -= std::floor(request.evolution);
    }
    handle_input(session_, view_width(), io.DisplaySize.y);
    panels();
    dialog_window(session_); // modal windows must come last
    question_window(session_);
    poll_fitter(session_);
    poll_exporter(session_);
    if (!ImGui::IsAnyItemActive() && !ImGui::IsAnyMouseDown())
        session_.history.commit();
    gui_.end();
    gui_.set_scale(session_.ui_scale);
    window_.set_full_screen(session_.full_screen);
    if (window_.take_close_request() && session_.closing == Closing::no)
        session_.closing = Closing::asked;
    continue_closing(session_);
    if (session_.closing == Closing::now || received_signal)
        return false;
    if (glfwGetTime() - saved_at_ >= saving_interval) {
        saved_at_ = glfwGetTime();
        save_session();
    }
    if (!window_.shown())
        return true;
    const Extent extent = window_.pixels();
    busy_ = refine(extent);
    if (!busy_)
        rested_at_ = glfwGetTime();
    if (window_png_)
        write_png(extent, *std::exchange(window_png_, {}), [&](vk::CommandBuffer commands) {
            paint(commands, view_area(extent));
            gui_.draw(commands);
        });
    if (const RenderTarget* target = swapchain_.acquire(extent))
        draw(*target);
    return true;
}

int App::run(const FrameHook& hook) {
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, note_signal);
    do {
        const bool wanted = busy_ || hook || gui_.has_input() || session_.playing ||
                            session_.exporter.running() || session_.fitter.running();
        if (!window_.shown())
            glfwWaitEventsTimeout(hook ? 0.02 : 0.25);
        else if (wanted || glfwGetTime() - last_input_ < 0.5)
            glfwPollEvents();
        else {
            const double before = glfwGetTime();
            glfwWaitEventsTimeout(waking_interval);
            if (glfwGetTime() - before < 0.9 * waking_interval)
                last_input_ = glfwGetTime(); // an event ended the wait
        }
    } while (frame(hook));
    return received_signal;
}

namespace {

// Prints one line on stderr or, if there is none, shows it.
int fail(int status, std::string message) {
    std::ranges::replace(message, '\n', ' ');
    std::fputs(fmt::format("gabor-viewer: {}\n", message).c_str(), stderr);
    system::show_error(message);
    return status;
}

Extent parse_size(const std::string& text) {
    int width = 0;
    int height = 0;
    int length = 0;
    if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &length) != 2 ||
        static_cast<std::size_t>(length) != text.size() || width < 480 || height < 320 || width > 16384 ||
        height > 16384)
        throw RequestError(
            fmt::format("--window '{}': expected WIDTHxHEIGHT, from 480x320 to 16384x16384", text));
    return {width, height};
}

int run(int argc, char** argv, const App::FrameHook& hook) {
    system::return_memory();
    CLI::App app("Interactive viewer for Gabor noise", "gabor-viewer");
    app.allow_windows_style_options(false); // /name is a path
    app.set_version_flag("--version", "gabor-viewer " GABOR_VERSION);
    std::string preset;
    std::string size;
    Options options;
    app.add_option("FILE,--preset", preset,
                   "Open a JSON file of parameters, an EXR that gabor rendered, or a preset by name")
        ->type_name("FILE");
    app.add_option("--window", size, "Window size")->type_name("WIDTHxHEIGHT");
    app.add_option(
           "--ui-scale", options.ui_scale,
           fmt::format(
               "Scale of panels and text, {} to {}, relative to the desktop's [as in the last session]",
               least_ui_scale, most_ui_scale))
        ->type_name("NUMBER")
        ->check(CLI::Range(least_ui_scale, most_ui_scale).description(""));
    app.add_option("--device", options.device,
                   "Vulkan device: its index or part of its name [the fastest kind]")
        ->type_name("NAME");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success))
            return fail(2, fmt::format("{} (gabor-viewer --help lists what is accepted)", error.what()));
        app.exit(error);
        return 0;
    }
    options.preset = preset;
    if (!preset.empty())
        options.document = load_document(preset);
    if (!size.empty())
        options.size = parse_size(size);
    int signal = 0;
    {
        App viewer(options);
        signal = viewer.run(hook);
    }
    if (signal)
        system::end_by(signal);
    if (const int messages = vulkan::validation_messages())
        return fail(1, fmt::format("{} message(s) from the validation layers", messages));
    return 0;
}

} // namespace

int run_viewer(int argc, char** argv, const App::FrameHook& hook) {
    try {
        return run(argc, argv, hook);
    } catch (const RequestError& error) {
        return fail(2, error.what());
    } catch (const std::exception& error) {
        return fail(1, error.what());
    }
}

} // namespace gabor::viewer
