#include "viewer/app.hpp"

int main(int argc, char** argv) {
    return gabor::viewer::run_viewer(argc, argv);
}
