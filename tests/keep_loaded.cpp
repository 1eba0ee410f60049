// Keeps libraries loaded, so that LeakSanitizer's reports name the leaking driver and tests/lsan.supp can
// match it.

#include <dlfcn.h>

extern "C" int dlclose(void*) {
    return 0;
}
