#include "render/likeness.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <fstream>

namespace gabor::render {

namespace {

// Of files that are small, so that a wrong name cannot fill the memory.
std::string read_text(const std::string& path) {
    constexpr std::size_t most = 1 << 20;
    std::ifstream file(path, std::ios::binary);
    std::string text(most + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (!file.is_open() || file.bad() || text.empty() || text.size() > most)
        throw RequestError(fmt::format("cannot read '{}': it takes a JSON file of at most 1 MiB", path));
    return text;
}

// Says of which file a wrong request speaks.
template <typename Read>
auto of_file(const std::string& path, Read read) {
    try {
        return read();
    } catch (const RequestError& error) {
        throw RequestError(fmt::format("'{}': {}", path, error.what()));
    }
}

} // namespace

Likeness read_likeness(const std::string& path) {
    if (path.ends_with(".json")) {
        const std::string text = read_text(path);
        return {of_file(path, [&] { return from_json(text); }), {}};
    }
    const image::ExrReader file(path);
    if (file.parameters().empty())
        throw RequestError(fmt::format(
            "'{}' has no 'gabor' attribute: it takes an EXR that gabor rendered, or its JSON", path));
    return {of_file(path, [&] { return from_json(file.parameters()); }), file.window()};
}

std::vector<Lobe> read_lobes(const std::string& path) {
    const std::string text = read_text(path);
    return of_file(path, [&] { return lobes_from_json(text); });
}

} // namespace gabor::render
