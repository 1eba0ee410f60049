// Prevents unloading under LeakSanitizer, so that its reports name the leaking driver, as tests/lsan.supp
// needs.

#include <dlfcn.h>

extern "C" int dlclose(void*) {
    return 0;
}
