#version 450
#extension GL_GOOGLE_include_directive : require

// Draws the material of the functions GABOR_MATERIAL and GABOR_FILTERED, whose parameters have the type GABOR_PARAMETERS:
// its colour, height, gabor_roughness and metalness, its lit colour, and its slopes or, for a body, the coverage.

#include "passes/channels.h"
#include "passes/material_interface.h"
#include "gabor_noise.glsl"
#include "gabor_spectrum.glsl"
#include "gabor_fractal.glsl"
#include "gabor_materials.glsl"
#include "gabor_compose.glsl"

layout(constant_id = filter_id) const bool filtered = false;
layout(constant_id = tiled_id) const bool tiled = false;
layout(constant_id = view_id) const uint view = view_flat;
layout(constant_id = environment_id) const int environment = 0;
layout(constant_id = boards_id) const bool laid = false;
layout(constant_id = coat_id) const bool coated = false;
layout(constant_id = finish_id) const bool finished = false;
layout(constant_id = unlit_id) const bool unlit = false;
const bool body = view == view_sphere || view == view_torus;
const int channels = body ? material_coverage + 1 : material_slope + 2;
const int rays = 4;

#include "body.glsl"
#include "light.glsl"
#include "plane.glsl"

layout(local_size_x = material_group, local_size_y = material_group) in;

layout(std430, set = 0, binding = 0) writeonly buffer Picture { float picture[]; };
layout(std430, set = 0, binding = 1) readonly buffer Parameters {
    GABOR_PARAMETERS parameters;
    GaborBoards boards;
    GaborCoat coat;
    GaborFinish finish;
};

GABOR_PARAMETERS look;

GaborMaterial material_at(vec2 p, vec2 dx, vec2 dy) {
    vec2 tile = tiled ? pixel * size : vec2(0.0), period = laid ? vec2(0.0) : tile;
    GaborBoard board = GaborBoard(p, dx, dy, seed, vec2(0.0), 0.0, vec2(0.0), vec3(0.0), vec2(1000.0));
    if (laid)
        board = gabor_board(p, filtered ? dx : vec2(0.0), filtered ? dy : vec2(0.0), tile, boards, seed);
    GaborMaterial material;
    if (filtered)
        material = GABOR_FILTERED(board.position, board.dx, board.dy, period, look, board.seed);
    else
        material = GABOR_MATERIAL(board.position, period, look, board.seed);
    if (laid)
        material = gabor_laid(material, board, boards);
    if (coated) { // a coat that wears at edges chips board by board
        uint salt = coat.edge_wear > 0.0 ? board.seed : seed;
        if (filtered)
            material = gabor_coated_filtered(material, p, dx, dy, tile, board.to_edge, coat, salt);
        else
            material = gabor_coated(material, p, tile, board.to_edge, coat, salt);
    }
    if (finished && filtered)
        return gabor_finished_filtered(material, p, dx, dy, tile, finish, seed);
    return finished ? gabor_finished(material, p, tile, finish, seed) : material;
}

#include "relief.glsl"

// What is behind a body: a floor, which fades into the backdrop.
vec3 behind(vec2 pixel_at, Axes axes) {
    vec2 place = (pixel_at + 0.5 - center) / (2.0 * max(center.x, center.y));
    vec3 light = lamp_above(place, lamp), normal = in_picture(vec3(0.0, 0.0, 1.0), axes);
    Floor floor_here = floor_at(pixel_at + 0.5, light.x * axes.right - light.y * axes.up + light.z * axes.toward_eye, axes);
    Surface stone = Surface(vec3(0.09, 0.092, 0.1), 0.8, 0.0);
    vec3 eye = normalize(in_picture(-ray_of(pixel_at + 0.5, axes), axes));
    vec3 shaded = lit(stone, normal, eye, -normal, sky_above(true));
    vec3 lamp_light = lit(stone, normal, eye, light, sky_above(true)) - shaded;
    return mix(backdrop, floor_here.open * (shaded + floor_here.lamp_open * lamp_light), floor_here.near);
}

void write_sample(int at, Sample here, vec3 backlight, float coverage) {
    if (!unlit) {
        vec3 light = lit_sample(here, lamp, body);
        if (body)
            light = mix(backlight, light, coverage);
        for (int i = 0; i < 3; ++i)
            picture[at + material_lit + i] = light[i];
    }
    for (int i = 0; i < 3; ++i)
        picture[at + material_colour + i] = here.material.colour[i];
    picture[at + material_height] = here.material.height;
    picture[at + material_roughness] = gabor_roughness(here.material);
    picture[at + material_metalness] = here.material.metalness;
    if (body) {
        picture[at + material_coverage] = coverage;
    } else {
        picture[at + material_slope] = here.slope.x;
        picture[at + material_slope + 1] = here.slope.y;
    }
}

// A pixel without a material.
void write_background(int at, vec3 light) {
    for (int i = 0; i < channels; ++i)
        picture[at + i] = 0.0;
    for (int i = 0; i < 3; ++i)
        picture[at + material_lit + i] = light[i];
}

void main() {
    look = parameters; // loaded before any branch, because lavapipe would otherwise load it for each invocation
    ivec2 here = ivec2(gl_GlobalInvocationID.xy);
    if (here.x >= width || here.y >= height)
        return;
    int at = (before + here.y * width + here.x) * channels;
    vec2 pixel_at = vec2(here + ivec2(first_column, first_row));
    SurfacePoint point;
    Axes axes = flat_axes();
    float coverage = 1.0;
    vec3 backlight = backdrop;
    if (body) {
        axes = camera_axes(yaw, pitch);
        Seen seen = seen_at(pixel_at, axes);
        if (seen.coverage < 1.0)
            backlight = behind(pixel_at, axes);
        if (!seen.found) {
            write_background(at, backlight);
            return;
        }
        coverage = seen.coverage;
        point = point_of_body(seen.p, seen.dx, seen.dy, seen.normal, unit, axes);
    } else {
        float rows = view == view_horizon ? sky : 0.0;
        float below = pixel_at.y + 0.5 - rows;
        if (below <= 0.0) {
            write_background(at, sky_colour(-below / rows));
            return;
        }
        point = point_of_pixel(pixel_at + 0.5, center, corner, pixel, rows, size.x);
    }
    write_sample(at, sample_at(point, view == view_sphere ? 1 : body ? 2 : 0, axes), backlight, coverage);
}
