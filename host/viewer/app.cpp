#include "viewer/app.hpp"

#include "viewer/panels.hpp"
#include "viewer/screenshot.hpp"
#include "viewer/view_input.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <cmath>
#include <cstring>

namespace gabor::viewer {

namespace {

constexpr double moving_budget =
    0.022; // seconds of a frame for the noise, in which there must be time for the rest
constexpr double still_budget = 0.030;
constexpr double sampling_budget = 0.004; // while time plays

constexpr std::uint32_t most_samples = 1 << 21;
constexpr double reload_interval = 0.25; // seconds
constexpr float panel_width = 26;        // in heights of the font

struct ShaderFile {
    const char* path;
    Stage stage;
};
constexpr std::array shader_files{
    ShaderFile{"passes/pixels.comp", Stage::compute}, ShaderFile{"viewer/ingredients.comp", Stage::compute},
    ShaderFile{"viewer/solid.comp", Stage::compute}, ShaderFile{"viewer/show.vert", Stage::vertex},
    ShaderFile{"viewer/show.frag", Stage::fragment}};

void drop(GLFWwindow* window, int count, const char** paths) {
    if (count > 0)
        open_preset(*static_cast<Session*>(glfwGetWindowUserPointer(window)), paths[0]);
}

Placement placement(const Options& options, const Settings& settings) {
    Placement placement = options.script || options.screenshot ? Placement{} : settings.placement;
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
      device_(options.device, window_.presentation()), shaders_(options.shaders),
      swapchain_(device_, window_.handle()),
      gui_(device_, window_, swapchain_.render_pass(), swapchain_.images()), pool_(make_pool(device_)),
      commands_(make_commands(device_, pool_)), session_(options.document, options.device),
      remember_(!options.script && !options.screenshot) {
    if (options.script)
        script_.emplace(*options.script);
    if (remember_)
        session_.panels = settings_.panels;
    glfwSetWindowUserPointer(window_.handle(), &session_);
    glfwSetDropCallback(window_.handle(), drop);
    load_shaders();
    if (!session_.shader_error.empty())
        throw std::runtime_error(session_.shader_error);
}

App::~App() {
    device_.state().device.waitIdle();
    if (remember_)
        save_settings({window_.placement(), session_.panels});
}

// All or nothing: what does not compile leaves everything as it was.
void App::load_shaders() {
    decltype(spirv_) compiled;
    for (const ShaderFile& file : shader_files) {
        Compiled result = shaders_.compile(file.path, file.stage);
        if (!result.error.empty()) {
            session_.shader_error = result.error;
            return;
        }
        compiled[file.path] = std::move(result.spirv);
    }
    session_.shader_error.clear();
    swapchain_.wait();
    spirv_ = std::move(compiled);
    painter_ = std::make_unique<Painter>(device_, swapchain_.render_pass(), spirv_["viewer/show.vert"],
                                         spirv_["viewer/show.frag"]);
    for (std::size_t side = 0; side < works_.size(); ++side) {
        works_[side].canvas->replace(spirv(works_[side].canvas->subject()));
        works_[side].law.reset();
    }
}

void App::poll_shaders() {
    const double now = glfwGetTime();
    if (now - shaders_polled_ < reload_interval)
        return;
    shaders_polled_ = now;
    if (shaders_.changed()) {
        load_shaders();
        if (session_.shader_error.empty())
            say(session_, "the shaders have been read again");
        busy_ = true;
    }
}

const std::vector<std::uint32_t>& App::spirv(const Subject& subject) const {
    return spirv_.find(subject.shader)->second;
}

std::vector<Area> App::areas(Extent window) const {
    const float per_unit = static_cast<float>(window.width) / std::max(ImGui::GetIO().DisplaySize.x, 1.0f);
    const int panel = session_.panels ? static_cast<int>(panel_width * ImGui::GetFontSize() * per_unit) : 0;
    const int width = std::max(window.width - panel, 2);
    if (!session_.history.now.rival || on_body(session_.history.now.view()))
        return {{0, 0, width, window.height}};
    const int left = std::clamp(static_cast<int>(static_cast<float>(width) * session_.divider), 1, width - 1);
    return {{0, 0, left, window.height}, {left, 0, width - left, window.height}};
}

bool App::work(Extent window) {
    const std::vector<Subject> wanted = subjects(session_.document());
    const std::vector<Area> where = areas(window);
    session_.view = {where[0].width, where[0].height};
    if (works_.size() != wanted.size() || session_.sides.size() != wanted.size()) {
        works_.resize(wanted.size());
        session_.sides.resize(wanted.size());
    }
    bool more = false;
    for (std::size_t side = 0; side < wanted.size(); ++side) {
        Work& work = works_[side];
        if (!work.canvas || !work.canvas->subject().same_pass(wanted[side])) {
            work.canvas = std::make_unique<Canvas>(device_, wanted[side], spirv(wanted[side]));
            work.law.reset();
        }
        const double share = 1.0 / static_cast<double>(wanted.size());
        const bool moving = ImGui::IsAnyMouseDown() || session_.playing;
        if (work.canvas->work(wanted[side], session_.document(), {where[side].width, where[side].height},
                              share * (moving ? moving_budget : still_budget))) {
            more = true;
            work.picture_measured = false;
        }
        measure(side, wanted[side]);
        more |= !work.picture_measured || work.samples < most_samples;

        Side& told = session_.sides[side];
        const double cost = work.canvas->seconds_per_pixel();
        told.name = wanted[side].name;
        told.visited = wanted[side].visited;
        told.nanoseconds = cost * 1e9;
        told.milliseconds = cost * 1e3 * where[side].width * where[side].height;
        told.stride = work.canvas->stride();
        told.measured = measurer_.measured(side);
    }
    return more || !measurer_.idle();
}

// While the view stands still: the spectrum of what it shows, and the law of the values, more of them with
// every frame.
void App::measure(std::size_t side, const Subject& subject) {
    Work& work = works_[side];
    // Other instances, times and scales have the same law.
    render::Picture picture = in_plane(subject).picture;
    picture.seed = 0;
    picture.time = 0;
    picture.scale = 32;
    std::string measured = fmt::format("{} {} {}", subject.shader, subject.name, render::to_json(picture));
    if (!work.law || measured != work.measured) {
        work.law = std::make_unique<Law>(device_, subject, spirv(subject));
        work.measured = std::move(measured);
        work.samples = 0;
        work.picture_measured = false;
        measurer_.reset(side);
    }
    if (!measurer_.idle())
        return;
    const Canvas& canvas = *work.canvas;
    if (canvas.fine() && !work.picture_measured) {
        work.picture_measured = true;
        if (subject.view == View::plane)
            measurer_.add_picture(side, work.canvas->pixels(), subject.channels, canvas.grid(),
                                  session_.document().picture.scale);
    } else if ((canvas.fine() || session_.playing) && work.samples < most_samples) {
        const std::span<const float> values = work.law->sample(
            session_.document(), work.draws++, session_.playing ? sampling_budget : still_budget);
        work.samples +=
            static_cast<std::uint32_t>(values.size()) / static_cast<std::uint32_t>(work.law->channels());
        measurer_.add_samples(side, values, work.law->channels());
    }
}

void App::panels() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float width = session_.panels ? panel_width * ImGui::GetFontSize() : 0;
    overlay(session_, size.x - width, size.y);
    help_window(session_);
    if (!session_.panels)
        return;
    ImGui::SetNextWindowPos({size.x - width, 0});
    ImGui::SetNextWindowSize({width, size.y});
    ImGui::Begin("panels", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PushItemWidth(-7.5f * ImGui::GetFontSize());
    // Tab goes from one field to the next only while one is edited: else it splits the view.
    ImGui::PushAllowKeyboardFocus(ImGui::GetIO().WantTextInput);
    struct Section {
        const char* title;
        void (*panel)(Session&);
    };
    constexpr std::array sections{
        Section{"Noise", noise_panel}, Section{"Spectrum", spectrum_panel}, Section{"Output", output_panel},
        Section{"Measurements", measurements_panel}, Section{"Take it home", take_home_panel}};
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

void App::paint(vk::CommandBuffer commands, const std::vector<Area>& where) {
    for (std::size_t side = 0; side < works_.size(); ++side)
        painter_->paint(commands, *works_[side].canvas, where[side], session_.document(), side);
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

void App::save_window(const std::string& path) {
    const Extent extent = window_.pixels();
    swapchain_.wait();
    screenshot(
        device_, extent, path, [&](vk::CommandBuffer commands) { painter_->prepare(commands); },
        [&](vk::CommandBuffer commands) {
            paint(commands, areas(extent));
            gui_.draw(commands);
        });
}

void App::save_picture(const std::string& path) {
    const Document& document = session_.document();
    const Subject subject = subjects(document).front();
    const Extent extent{document.picture.width, document.picture.height};
    Canvas canvas(device_, subject, spirv(subject));
    while (canvas.work(subject, document, extent, still_budget)) {
    }
    swapchain_.wait();
    screenshot(
        device_, extent, path, [&](vk::CommandBuffer commands) { painter_->prepare(commands); },
        [&](vk::CommandBuffer commands) {
            painter_->paint(commands, canvas, {0, 0, extent.width, extent.height}, document, 0);
        });
}

Script::Hands App::hands() {
    GLFWwindow* window = window_.handle();
    return {[window](int width, int height) { glfwSetWindowSize(window, width, height); },
            [window](const std::string& how) {
                if (how == "minimize")
                    glfwIconifyWindow(window);
                else if (how == "restore")
                    glfwRestoreWindow(window);
                else if (how == "hide")
                    glfwHideWindow(window);
                else
                    glfwShowWindow(window);
            },
            [this](const std::string& path, bool with_panels) {
                if (with_panels)
                    window_picture_ = path;
                else
                    save_picture(path);
            },
            [this] { return !busy_ && !session_.exporter.running(); }};
}

bool App::frame() {
    swapchain_.wait();
    poll_shaders();
    gui_.begin();
    if (script_ && !script_->play(session_, hands()))
        return false;
    ImGui::NewFrame();
    const ImGuiIO& io = ImGui::GetIO();
    if (session_.playing) {
        double& time = session_.document().picture.time;
        time += double{io.DeltaTime} / double{session_.period};
        time -= std::floor(time);
    }
    const float panel = session_.panels ? panel_width * ImGui::GetFontSize() : 0;
    bool closing =
        view_input(session_, io.DisplaySize.x - panel, io.DisplaySize.y, io.DisplayFramebufferScale.x);
    closing |= window_.close_asked();
    panels();
    if (!ImGui::IsAnyItemActive() && !ImGui::IsAnyMouseDown())
        session_.history.settle();
    gui_.end();
    if (closing)
        return false;
    if (!window_.shown())
        return true;
    const Extent extent = window_.pixels();
    busy_ = work(extent);
    if (window_picture_) {
        save_window(*window_picture_);
        window_picture_.reset();
    }
    if (const Target* target = swapchain_.acquire(extent))
        draw(*target);
    return true;
}

void App::run() {
    do {
        const bool wanted = busy_ || script_ || session_.playing || session_.exporter.running();
        if (!window_.shown())
            glfwWaitEventsTimeout(script_ ? 0.02 : 0.25);
        else if (wanted || glfwGetTime() - last_input_ < 0.5)
            glfwPollEvents();
        else {
            const double before = glfwGetTime();
            glfwWaitEventsTimeout(reload_interval);
            if (glfwGetTime() - before < 0.9 * reload_interval)
                last_input_ = glfwGetTime(); // something has happened
        }
    } while (frame());
}

} // namespace gabor::viewer
