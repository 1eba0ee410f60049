// The interface of passes/pixels.comp for the viewer's own passes, which so are driven in the same way.

layout(local_size_x = 8, local_size_y = 8) in;

// Where the pixels of a column or a row are: in cells, or in perspective in pixels from the middle.
struct Line {
    int cell;
    float local;
};

layout(std430, set = 0, binding = 0) readonly buffer Columns { Line columns[]; };
layout(std430, set = 0, binding = 1) readonly buffer Rows { Line rows[]; };
layout(std430, set = 0, binding = 4) writeonly buffer Picture { float picture[]; };

layout(push_constant) uniform Push {
    vec2 radius;
    ivec2 period;
    float time;
    float frequency;
    float orientation;
    float pixel; // of a plane in perspective the camera's height, of a body its unit, in kernel radii
    float focal_length;
    uint seed;
    int width;
    int height;
    int first_row;
    int paint_width; // these six are no matter here
    int paint_height;
    float paint_scale_x;
    float paint_scale_y;
    float paint_x;
    float paint_y;
    float camera_x;
    float camera_y;
    int before;
    float amplitude; // of what is not normalized by itself
    float stride;    // pixels per value
    float yaw;       // where the eye of a body is, radians
    float pitch;
};
