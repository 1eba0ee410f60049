// A table entry that passes over a picture share with C++.

#ifndef GABOR_LINE_H
#define GABOR_LINE_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

// Where the pixels of a column or a row are: in cells, or in perspective in pixels from the horizon's middle.
struct Line {
    int cell;
    float local;
};

GABOR_INTERFACE_END

#endif // GABOR_LINE_H
