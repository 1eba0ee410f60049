// gabor-viewer driven by a script: scripted_viewer SCRIPT [OPTION OF gabor-viewer...]

#include "script.hpp"

#include "error.hpp"

#include <fmt/format.h>

int main(int argc, char** argv) {
    using namespace gabor::viewer;
    try {
        Script script(argc > 1 ? argv[1] : "");
        return run_viewer(argc - 1, argv + 1, [&](App& app) { return script.play(app); });
    } catch (const gabor::RequestError& error) {
        fmt::print(stderr, "scripted_viewer: {}\n", error.what());
        return 2;
    }
}
