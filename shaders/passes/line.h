// A table entry that the passes share with C++.

#ifndef GABOR_LINE_H
#define GABOR_LINE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

// The position of a column or row of pixels: in cells or, in perspective, in pixels from the middle of the
// horizon.
struct Line {
    int cell;
    float local;
};

GABOR_INTERFACE_END

#endif // GABOR_LINE_H
