#include "system/process.hpp"
#include "viewer/app.hpp"

int main(int argc, char** argv) {
    gabor::system::prepare();
    return gabor::viewer::run_viewer(argc, argv);
}
