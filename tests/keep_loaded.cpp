// Under LeakSanitizer nothing is unloaded, so that what a driver leaks is still known by the driver's name,
// and tests/lsan.supp can name it.

#include <dlfcn.h>

extern "C" int dlclose(void*) {
    return 0;
}
