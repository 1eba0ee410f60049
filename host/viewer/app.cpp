#include "viewer/app.hpp"

#include "viewer/document_json.hpp"
#include "viewer/effect.hpp"
#include "viewer/gallery.hpp"
#include "viewer/panels.hpp"
#include "viewer/photograph.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gabor::viewer {

namespace {

constexpr double moving_budget =
    0.022; // seconds of a frame for the noise, in which there must be time for the rest
constexpr double resting_budget = 0.030;
constexpr double sampling_budget = 0.004; // while time plays
constexpr double rest = 0.3;              // seconds without a change, after which it is measured

constexpr std::uint32_t most_samples = 1 << 21;
constexpr double reload_interval = 0.25; // seconds
constexpr float panel_width = 26;        // in heights of the font

void drop(GLFWwindow* window, int count, const char** paths) {
    Session& session = *static_cast<Session*>(glfwGetWindowUserPointer(window));
    if (count > 0 && !session.question)
        open_file(session, paths[0]);
}

// The values of a material have none.
bool has_law(const NoisePass& noise) {
    return !render::has_material(noise.request);
}

Placement placement(const Options& options, const Settings& settings) {
    Placement placement = options.screenshot ? Placement{} : settings.placement;
    if (options.size) {
        placement.width = options.size->width;
        placement.height = options.size->height;
        placement.maximized = false;
    }
    return placement;
}

vk::raii::CommandPool make_pool(const vulkan::Device& device) {
    return {device.state().device,
            {vk::CommandPoolCreateFlagBits::eResetCommandBuffer, device.state().family}};
}

vk::raii::CommandBuffer make_commands(const vulkan::Device& device, const vk::raii::CommandPool& pool) {
    vk::raii::CommandBuffers buffers(device.state().device, {*pool, vk::CommandBufferLevel::ePrimary, 1});
    return std::move(buffers.front());
}

} // namespace

App::App(const Options& options)
    : settings_(load_settings()), window_(placement(options, settings_), !options.screenshot),
      device_(options.device, window_.presentation()), compiler_(options.shaders),
      swapchain_(device_, window_.handle()),
      gui_(device_, window_, swapchain_.render_pass(), swapchain_.images(),
           options.ui_scale.value_or(settings_.ui_scale)),
      pool_(make_pool(device_)), commands_(make_commands(device_, pool_)),
      session_(options.document.value_or(document_of({})), options.device), timing_(device_),
      remember_(!options.screenshot) {
    if (remember_)
        restore(options);
    glfwSetWindowUserPointer(window_.handle(), &session_);
    glfwSetDropCallback(window_.handle(), drop);
    session_.export_shaders = [this](const render::Request& request) { return export_shaders(request); };
    load_shaders();
    if (session_.shader_error.empty())
        spirv(wanted().front().shader);
    if (!session_.shader_error.empty())
        throw std::runtime_error(session_.shader_error);
}

App::~App() {
    device_.state().device.waitIdle();
    if (remember_)
        save_settings({window_.placement(), session_.panels, session_.ui_scale, to_json(session_.document()),
                       session_.preset_path, session_.export_target.path, session_.recent});
}

// The last session, but for what the command line says.
void App::restore(const Options& options) {
    session_.panels = settings_.panels;
    session_.ui_scale = options.ui_scale.value_or(settings_.ui_scale);
    session_.recent = settings_.recent;
    if (!options.preset.empty())
        return open_preset(session_, options.preset);
    if (options.document || settings_.document.empty())
        return;
    attempt(session_, [&] {
        const Document last = document_from_json(settings_.document);
        render::load_paint(last.request.paint); // it must still be there
        session_.history = History(last);
        session_.kept = last;
        session_.preset_path = settings_.preset_path;
        session_.export_target.path = settings_.export_path;
    });
}

// What is on the screen, all or nothing: what does not compile leaves everything as it was.
void App::load_shaders() {
    std::vector<std::string> shown{"viewer/show.vert", "viewer/show.frag"};
    for (const Pane& pane : panes_) {
        shown.push_back(pane.canvas->noise().shader);
        if (pane.sampler)
            shown.push_back(pane.sampler->noise().shader);
    }
    decltype(spirv_) compiled;
    for (const std::string& path : shown) {
        if (compiled.contains(path))
            continue;
        Compiled result = compiler_.compile(path);
        if (!result.error.empty()) {
            session_.shader_error = result.error;
            return;
        }
        compiled[path] = std::move(result.spirv);
    }
    session_.shader_error.clear();
    swapchain_.wait();
    spirv_ = std::move(compiled);
    painter_ = std::make_unique<Painter>(device_, swapchain_.render_pass(), spirv_["viewer/show.vert"],
                                         spirv_["viewer/show.frag"]);
    for (Pane& pane : panes_) {
        pane.canvas->replace(spirv_[pane.canvas->noise().shader]);
        pane.sampler.reset();
        pane.measured = {};
    }
}

// Compiled when it is first wanted.
const Spirv* App::spirv(const std::string& path) {
    auto known = spirv_.find(path);
    if (known == spirv_.end()) {
        Compiled result = compiler_.compile(path);
        if (!result.error.empty())
            session_.shader_error = result.error;
        // Empty where it does not compile, and not tried again until something changes.
        known = spirv_.emplace(path, std::move(result.spirv)).first;
    }
    return known->second.empty() ? nullptr : &known->second;
}

const Spirv& App::required(const std::string& path) {
    const Spirv* code = spirv(path);
    if (!code)
        throw std::runtime_error(session_.shader_error);
    return *code;
}

Exporter::Shaders App::export_shaders(const render::Request& request) {
    Exporter::Shaders shaders;
    shaders.colours = required("viewer/show.comp");
    const Spirv& pass = required(render::pass_of(request));
    if (!compiler_.as_built())
        shaders.pass = pass;
    return shaders;
}

void App::poll_shaders() {
    const double now = glfwGetTime();
    if (now - shaders_polled_ < reload_interval)
        return;
    shaders_polled_ = now;
    if (compiler_.changed()) {
        load_shaders();
        if (session_.shader_error.empty())
            notify(session_, "the shaders have been read again");
        busy_ = true;
    }
}

Document App::shown() const {
    Document document = session_.history.now;
    if (session_.tiling)
        document.camera = session_.tiling->camera;
    return document;
}

std::vector<NoisePass> App::wanted() const {
    return noise_passes(shown(), device_.info().kind == "CPU");
}

std::vector<Area> App::areas(Extent window) const {
    const float per_unit = static_cast<float>(window.width) / std::max(ImGui::GetIO().DisplaySize.x, 1.0f);
    const int panel = session_.panels ? static_cast<int>(panel_width * ImGui::GetFontSize() * per_unit) : 0;
    const int width = std::max(window.width - panel, 2);
    const render::Request& request = session_.history.now.request;
    if (shows_photograph(session_)) {
        const int photograph = static_cast<int>(static_cast<float>(width) * session_.divider);
        return {{photograph, 0, std::max(width - photograph, 2), window.height}};
    }
    if (!session_.history.now.comparison || render::in_space(request) || render::has_material(request))
        return {{0, 0, width, window.height}};
    const int left = std::clamp(static_cast<int>(static_cast<float>(width) * session_.divider), 1, width - 1);
    return {{0, 0, left, window.height}, {left, 0, width - left, window.height}};
}

bool App::refine(Extent window) {
    if (!session_.fitter.photograph()) {
        photograph_.reset();
        photograph_pixels_.reset();
    }
    const std::vector<Area> where = areas(window);
    session_.view = {where[0].width, where[0].height};
    session_.tiling.reset();
    if (session_.tiles && without_effect(session_.document(), "tiles").empty())
        session_.tiling = tiling_of(
            session_.document(), {std::min(where.front().width, where.back().width), where.front().height});
    const Camera camera = shown().camera;
    const std::vector<NoisePass> wanted = this->wanted();
    for (const NoisePass& noise : wanted)
        if (!spirv(noise.shader) || (has_law(noise) && !spirv(value_pass(noise).shader)))
            return false; // until its error is mended the last good picture stays
    if (panes_.size() != wanted.size() || session_.panes.size() != wanted.size()) {
        panes_.resize(wanted.size());
        session_.panes.resize(wanted.size());
    }
    const bool moving = ImGui::IsAnyMouseDown() || session_.playing;
    const double budget = (moving ? moving_budget : resting_budget) / static_cast<double>(wanted.size());
    bool more = false;
    for (std::size_t index = 0; index < wanted.size(); ++index) {
        Pane& pane = panes_[index];
        if (!pane.canvas || !pane.canvas->noise().same_pipeline(wanted[index]))
            pane.canvas = std::make_unique<Canvas>(device_, wanted[index], required(wanted[index].shader));
        const Extent extent =
            session_.tiling ? session_.tiling->tile : Extent{where[index].width, where[index].height};
        more |= pane.canvas->refine(wanted[index], camera, extent, budget);
    }
    timing_.set(wanted);
    if (more || moving || wanted != shown_ || camera != shown_from_) {
        shown_ = wanted;
        shown_from_ = camera;
        changed_ = glfwGetTime();
        for (Pane& pane : panes_)
            pane.picture_measured = false;
    }
    const bool rested = glfwGetTime() - changed_ >= rest && !session_.exporter.running();
    if (rested && measuring_.idle() && !timing_.done()) {
        timing_.run();
        more = true;
    } else {
        for (std::size_t index = 0; index < wanted.size(); ++index) {
            if (has_law(wanted[index])) {
                measure(index, wanted[index], rested || session_.playing);
                more |= !panes_[index].picture_measured || panes_[index].samples < most_samples;
            } else if (std::exchange(panes_[index].sampler, nullptr)) {
                panes_[index].measured = {};
                measuring_.reset(index);
            }
        }
    }
    for (std::size_t index = 0; index < wanted.size(); ++index) {
        const double nanoseconds = timing_.nanoseconds(index);
        session_.panes[index] = {wanted[index].name,
                                 wanted[index].visits(),
                                 timing_.function(index),
                                 nanoseconds,
                                 1e-6 * nanoseconds * where[index].width * where[index].height,
                                 measuring_.measured(index)};
    }
    return more || !timing_.done() || !measuring_.idle();
}

// While the view stands still: the spectrum of what it shows, and the statistics of the values, of more of
// them with every frame.
void App::measure(std::size_t index, const NoisePass& noise, bool rested) {
    Pane& pane = panes_[index];
    const NoisePass values = value_pass(noise);
    if (pane.measured != values) {
        pane.measured = values;
        pane.samples = 0;
        pane.picture_measured = false;
        measuring_.reset(index);
    }
    if (!rested || !measuring_.idle())
        return;
    if (!pane.sampler || !pane.sampler->noise().same_pipeline(values))
        pane.sampler = std::make_unique<ValueSampler>(device_, values, required(values.shader));
    pane.sampler->set(values);
    const Canvas& canvas = *pane.canvas;
    if (canvas.fine() && !pane.picture_measured) {
        pane.picture_measured = true;
        if (is_flat(noise.request.view) && !noise.request.colour)
            measuring_.add_picture(index, pane.canvas->pixels(), noise.channel_count(), canvas.grid(),
                                   noise.request.scale * shown().camera.zoom);
    } else if ((canvas.fine() || session_.playing) && pane.samples < most_samples) {
        const std::span<const float> values_now =
            pane.sampler->sample(pane.draws++, session_.playing ? sampling_budget : resting_budget);
        const int channels = pane.sampler->noise().channel_count();
        pane.samples += static_cast<std::uint32_t>(values_now.size()) / static_cast<std::uint32_t>(channels);
        const bool covered = pane.sampler->noise().channels.back() == "A";
        measuring_.add_samples(index, values_now, channels, covered ? channels - 1 : -1);
    }
}

float App::view_width() const {
    return ImGui::GetIO().DisplaySize.x - (session_.panels ? panel_width * ImGui::GetFontSize() : 0);
}

void App::panels() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float view = view_width();
    if (session_.gallery) {
        gallery_window(session_, view, size.y);
    } else {
        view_overlay(session_, view, size.y);
        photograph_overlay(session_, view, size.y);
    }
    message_overlay(session_, size.y);
    help_window(session_);
    if (!session_.panels)
        return;
    ImGui::SetNextWindowPos({view, 0});
    ImGui::SetNextWindowSize({size.x - view, size.y});
    ImGui::Begin("panels", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PushItemWidth(-8.5f * ImGui::GetFontSize());
    // Tab goes from one field to the next only while one is edited: else it splits the view.
    ImGui::PushAllowKeyboardFocus(ImGui::GetIO().WantTextInput);
    struct Section {
        const char* title;
        void (*panel)(Session&);
    };
    constexpr std::array sections{
        Section{"Noise", noise_panel},           Section{"Spectrum", spectrum_panel},
        Section{"Output", output_panel},         Section{"Measurements", measurements_panel},
        Section{"Photograph", photograph_panel}, Section{"Files and code", files_panel},
        Section{"Export", export_panel}};
    for (const Section& section : sections)
        if (ImGui::CollapsingHeader(section.title, ImGuiTreeNodeFlags_DefaultOpen)) {
            ImGui::PushID(section.title);
            section.panel(session_);
            ImGui::PopID();
            ImGui::Spacing();
        }
    ImGui::PopAllowKeyboardFocus();
    ImGui::PopItemWidth();
    ImGui::End();
}

bool App::fine() const {
    return !panes_.empty() &&
           std::ranges::all_of(panes_, [](const Pane& pane) { return pane.canvas->fine(); });
}

void App::paint(vk::CommandBuffer commands, const std::vector<Area>& where) {
    if (session_.gallery)
        return paint_presets(commands, where.back());
    for (std::size_t index = 0; index < panes_.size() && index < where.size(); ++index)
        if (panes_[index].canvas)
            painter_->paint(commands, *panes_[index].canvas, where[index], session_.document(), index,
                            session_.tiling);
    if (shows_photograph(session_) && where[0].x > 0)
        paint_photograph(commands, {0, 0, where[0].x, where[0].height});
}

// Where the noise has the picture, pixel by pixel.
void App::paint_photograph(vk::CommandBuffer commands, const Area& area) {
    if (photograph_ != session_.fitter.photograph()) {
        photograph_ = session_.fitter.photograph();
        photograph_pixels_ = render::upload(device_, photograph_->pixels);
    }
    const Document& document = session_.document();
    const double scale =
        document.request.scale * document.camera.zoom; // pixels of the window per kernel radius
    const auto corner = [&](const Coordinate& middle, int first, int pixels) {
        return static_cast<float>(first + pixels / 2.0 -
                                  (static_cast<double>(middle.whole) + middle.part) * scale);
    };
    painter_->paint_colours(
        commands, *photograph_pixels_, photograph_->grid,
        {corner(document.camera.x, area.x, area.width), corner(document.camera.y, area.y, area.height)},
        static_cast<float>(photograph_->square * document.camera.zoom), area);
}

// In place of the view, which ends with its last pane.
void App::paint_presets(vk::CommandBuffer commands, const Area& last) {
    const PresetPictures& pictures = session_.preset_pictures;
    const ImGuiIO& io = ImGui::GetIO();
    const float per_unit = io.DisplayFramebufferScale.x;
    const std::size_t drawn = pictures.drawn();
    if (drawn == 0)
        return;
    if (drawn != presets_drawn_) {
        presets_drawn_ = drawn;
        preset_pixels_ = render::upload(device_, pictures.colours());
    }
    const GalleryPlace place = gallery_place(view_width(), io.DisplaySize.y);
    painter_->paint_colours(commands, *preset_pixels_, PresetPictures::extent(),
                            {place.x * per_unit, place.y * per_unit}, place.scale * per_unit,
                            {0, 0, last.x + last.width, last.height});
}

void App::draw(const Target& target) {
    const vk::CommandBuffer commands = *commands_;
    commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
    painter_->prepare(commands);
    const vk::ClearValue dark(vk::ClearColorValue(std::array{0.05f, 0.05f, 0.055f, 1.0f}));
    const vk::Extent2D extent(static_cast<std::uint32_t>(target.extent.width),
                              static_cast<std::uint32_t>(target.extent.height));
    commands.beginRenderPass({swapchain_.render_pass(), *target.framebuffer, {{0, 0}, extent}, dark},
                             vk::SubpassContents::eInline);
    paint(commands, areas(target.extent));
    gui_.draw(commands);
    commands.endRenderPass();
    commands.end();
    swapchain_.present(commands);
}

void App::write_window_png(const std::string& path) {
    const Extent extent = window_.pixels();
    swapchain_.wait();
    save_png(
        device_, extent, path, [&](vk::CommandBuffer commands) { painter_->prepare(commands); },
        [&](vk::CommandBuffer commands) {
            paint(commands, areas(extent));
            gui_.draw(commands);
        });
}

void App::save_picture(const std::string& path) {
    const Document& document = session_.document();
    const NoisePass noise = wanted().front();
    const Extent extent{document.request.width, document.request.height};
    std::unique_ptr<Canvas> own; // where the window has none, for to make one takes its time
    if (panes_.empty() || !panes_.front().canvas || !panes_.front().canvas->noise().same_pipeline(noise))
        own = std::make_unique<Canvas>(device_, noise, required(noise.shader));
    Canvas& canvas = own ? *own : *panes_.front().canvas;
    while (canvas.refine(noise, default_camera(document), extent, resting_budget)) {
    }
    swapchain_.wait();
    save_png(
        device_, extent, path, [&](vk::CommandBuffer commands) { painter_->prepare(commands); },
        [&](vk::CommandBuffer commands) {
            painter_->paint(commands, canvas, {0, 0, extent.width, extent.height}, document, 0);
        });
}

bool App::frame(const FrameHook& hook) {
    swapchain_.wait();
    poll_shaders();
    gui_.begin();
    if (hook && !hook(*this))
        return false;
    ImGui::NewFrame();
    const ImGuiIO& io = ImGui::GetIO();
    if (session_.playing && !render::has_material(session_.document().request)) {
        double& time = session_.document().request.time;
        time += double{io.DeltaTime} / double{session_.period};
        time -= std::floor(time);
    }
    handle_input(session_, view_width(), io.DisplaySize.y);
    panels();
    dialog_window(session_); // after all others: a modal window must not be the first to appear
    question_window(session_);
    go_on_fitting(session_);
    if (!ImGui::IsAnyItemActive() && !ImGui::IsAnyMouseDown())
        session_.history.commit();
    gui_.end();
    gui_.set_scale(session_.ui_scale);
    window_.set_full_screen(session_.full_screen);
    if (window_.take_close_request() && session_.closing == Closing::no)
        session_.closing = Closing::asked;
    go_on_closing(session_);
    if (session_.closing == Closing::now)
        return false;
    if (!window_.shown())
        return true;
    const Extent extent = window_.pixels();
    busy_ = refine(extent);
    if (window_png_)
        write_window_png(*std::exchange(window_png_, {}));
    if (const Target* target = swapchain_.acquire(extent)) {
        draw(*target);
        if (session_.metered) {
            swapchain_.wait();
            session_.meter.drawn(glfwGetTime());
        }
    }
    return true;
}

void App::run(const FrameHook& hook) {
    do {
        const bool wanted = busy_ || hook || session_.playing || session_.metered ||
                            session_.exporter.running() || session_.fitter.running();
        if (!window_.shown())
            glfwWaitEventsTimeout(hook ? 0.02 : 0.25);
        else if (wanted || glfwGetTime() - last_input_ < 0.5)
            glfwPollEvents();
        else {
            const double before = glfwGetTime();
            glfwWaitEventsTimeout(reload_interval);
            if (glfwGetTime() - before < 0.9 * reload_interval)
                last_input_ = glfwGetTime(); // something has happened
        }
        session_.meter.read(glfwGetTime());
    } while (frame(hook));
}

} // namespace gabor::viewer
