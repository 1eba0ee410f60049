#include "viewer/document.hpp"

namespace gabor::viewer {

namespace {

constexpr std::size_t most_steps = 1000;

// The document but for what moves by itself or by looking around.
Document still(Document document) {
    document.camera = {};
    document.pose = {};
    document.picture.scale = 0;
    document.picture.time = 0;
    return document;
}

} // namespace

bool Document::operator==(const Document& other) const {
    return render::to_json(picture) == render::to_json(other.picture) && camera == other.camera &&
           view == other.view && waves == other.waves && pose == other.pose && filtered == other.filtered && output == other.output && colours == other.colours && contrast == other.contrast &&
           rival == other.rival;
}

Document document_of(const render::Picture& picture) {
    Document document;
    document.picture = picture;
    document.camera = Camera{}.moved(picture.width / 2.0 / picture.scale, picture.height / 2.0 / picture.scale);
    return document;
}

void History::settle() {
    if (still(now) == still(steps_[at_])) {
        steps_[at_] = now;
        return;
    }
    steps_.resize(at_ + 1);
    steps_.push_back(now);
    if (steps_.size() > most_steps)
        steps_.erase(steps_.begin());
    at_ = steps_.size() - 1;
}

void History::undo() {
    if (can_undo())
        go(at_ - 1);
}

void History::redo() {
    if (can_redo())
        go(at_ + 1);
}

void History::go(std::size_t step) {
    steps_[at_] = now;
    at_ = step;
    now = steps_[at_];
}

} // namespace gabor::viewer
