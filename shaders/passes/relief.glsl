// Puts a material on a surface in space, and lights it. Include it after plane.glsl, camera.glsl, light.glsl and the definition of
// material_at(p, dx, dy), a material in the plane. The pass and copied code include it.

// The material at a point on the surface, and the slope of its relief, in space.
struct Relief {
    GaborMaterial material;
    vec3 slope;
};

// How the material lies on a surface at a point: which point of the material is there, the gradients in space of that point's
// coordinates, and how much of the material here lies in this way.
struct Chart {
    vec2 at;
    vec3 right;
    vec3 down;
    float share;
};

const float torus_ring = 0.68; // as in body.glsl
const float torus_tube = 0.3;

// The hemisphere around `middle`, which has coordinates that keep the distance from there.
Chart chart_of_hemisphere(vec3 normal, float unit, vec3 middle, vec3 right, vec3 down, float tear, float margin) {
    float cosine = dot(normal, middle);
    vec2 flat_at = vec2(dot(normal, right), dot(normal, down));
    float sine = max(length(flat_at), 1.0e-3), stretch = atan(sine, cosine) / sine;
    vec3 outward = (1.0 - stretch * cosine) / (sine * sine) * (normal * cosine - middle); // the gradient of `stretch`
    return Chart(unit * stretch * flat_at, stretch * (right - normal * flat_at.x) + flat_at.x * outward,
                 stretch * (down - normal * flat_at.y) + flat_at.y * outward,
                 smoothstep(-margin, margin, unit * cosine + tear));
}

// A torus's angles, from its front and its outer side on, or a turn away where that is nearer.
Chart chart_of_torus(vec3 p, vec3 normal, float unit, bvec2 turned, float tear, float margin) {
    float axis_distance = length(p.xy);
    vec2 outward = p.xy / axis_distance;
    vec2 angle = vec2(atan(p.x, -p.y), atan(-normal.z, dot(normal.xy, outward))), away = 3.1415927 - abs(angle); // pi
    vec2 arc = unit * vec2(torus_ring, torus_tube), share = 0.5 + 0.5 * smoothstep(vec2(0.0), vec2(margin), arc * away + tear);
    if (turned.x) {
        angle.x -= angle.x < 0.0 ? -6.2831853 : 6.2831853; // 2 pi
        share.x = 1.0 - share.x;
    }
    if (turned.y) {
        angle.y -= angle.y < 0.0 ? -6.2831853 : 6.2831853; // 2 pi
        share.y = 1.0 - share.y;
    }
    vec3 right = vec3(-outward.y, outward.x, 0.0);
    return Chart(arc * angle, unit * torus_ring / axis_distance * right, cross(normal, right), share.x * share.y);
}

// The relief at p, in units of the material; dx and dy are the steps to the next pixels. `body` is 0 for the plane z = 0,
// 1 for a sphere and 2 for a torus. A sphere has the material on two hemispheres, of which one faces the camera's first
// place; a torus has it along its angles. Where charts meet, the higher one covers the other along a ragged line. Of
// `lost`, only the sum of xx and yy is right. The loop keeps compilers from inlining the material more than once.
Relief relief_at(vec3 p, vec3 dx, vec3 dy, vec3 normal, int body) {
    vec2 outward = p.xy / max(length(p.xy), 1.0e-6);
    float unit = body == 1 ? length(p) : length(p.xy) / (torus_ring + torus_tube * dot(normal.xy, outward));
    float margin = min(0.1, 0.2 * unit);
    float tear = body == 0 ? 0.0 : 0.5 * margin * gabor_noise(3.0 * (p.xy + vec2(0.6, -0.5) * p.z), 1.0, 0.8, 77u);
    GaborMaterial m = GaborMaterial(vec3(0.0), 0.0, vec2(0.0), 0.0, 0.0, vec3(0.0));
    vec3 slope = vec3(0.0);
    float whole = 0.0;
    int charts = body == 0 ? 1 : body == 1 ? 2 : 4;
    for (int i = 0; i < charts; ++i) {
        Chart chart = Chart(p.xy, vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), 1.0);
        if (body == 1) { // the middle of the front is 30 degrees above the equator
            float side = i == 0 ? 1.0 : -1.0;
            chart = chart_of_hemisphere(normal, unit, side * vec3(0.0, -0.8660254, 0.5), vec3(side, 0.0, 0.0),
                                        vec3(0.0, -0.5, -0.8660254), side * tear, margin);
            chart.at += vec2(64.0 * float(i));
        } else if (body == 2) {
            chart = chart_of_torus(p, normal, unit, bvec2(i % 2 == 1, i > 1), tear, margin);
        }
        if (chart.share < 0.01)
            continue;
        GaborMaterial there = material_at(chart.at, vec2(dot(dx, chart.right), dot(dx, chart.down)),
                                          vec2(dot(dy, chart.right), dot(dy, chart.down)));
        float share = body == 0 ? 1.0 : chart.share * exp(clamp(400.0 * there.height, -20.0, 20.0));
        whole += share;
        m.colour += share * there.colour;
        m.height += share * there.height;
        m.roughness += share * there.roughness;
        m.metalness += share * there.metalness;
        slope += share * (there.slope.x * chart.right + there.slope.y * chart.down);
        m.lost.x += share * dot(there.lost, vec3(dot(chart.right, chart.right), dot(chart.down, chart.down),
                                                 2.0 * dot(chart.right, chart.down)));
    }
    m.colour /= whole;
    m.height /= whole;
    m.roughness /= whole;
    m.metalness /= whole;
    m.lost.x /= whole;
    return Relief(m, slope / whole);
}

// A point of the surface that a pixel shows, and how it is seen.
struct SurfacePoint {
    vec3 position;
    vec3 dx; // steps to the points that the next pixels show
    vec3 dy;
    vec3 normal;
    vec3 eye;   // direction to the eye, along the axes of the picture
    vec2 place; // as in lamp_above
};

SurfacePoint point_of_plane(Footprint here, vec3 eye, vec2 place) {
    return SurfacePoint(vec3(here.position, 0.0), vec3(here.dx, 0.0), vec3(here.dy, 0.0), vec3(0.0, 0.0, 1.0), eye, place);
}

// The point of the plane that a pixel shows, from above or, if `sky` rows are above the horizon, in perspective. The parameters are
// those of passes/material_interface.h.
SurfacePoint point_of_pixel(vec2 pixel_at, vec2 center, vec2 corner, float pixel, float sky, float focal_length) {
    if (sky > 0.0) {
        vec2 at = pixel_at - vec2(center.x, sky);
        Footprint here = footprint_below_horizon(at, pixel, focal_length);
        here.position += corner;
        return point_of_plane(here, eye_above_horizon(at, focal_length), vec2(0.0));
    }
    vec2 place = (pixel_at - center) / (2.0 * max(center.x, center.y));
    return point_of_plane(footprint_from_above(corner + pixel * pixel_at, pixel), eye_above(place), place);
}

// p, dx and dy are in radii of the sphere, which is `unit` units of the material.
SurfacePoint point_of_body(vec3 p, vec3 dx, vec3 dy, vec3 normal, float unit, Axes axes) {
    vec3 eye = normalize(in_picture(eye_distance * axes.toward_eye - p, axes));
    return SurfacePoint(unit * p, unit * dx, unit * dy, normal, eye, vec2(0.0));
}

// A piece of the surface as it is seen, along the axes of the picture.
struct Sample {
    GaborMaterial material;
    vec3 slope;
    vec3 normal; // with the relief
    vec3 eye;
    vec2 place;
};

// `body` is as in relief_at. A shader should call this once: each call compiles the material again.
Sample sample_at(SurfacePoint here, int body, Axes axes) {
    Relief relief = relief_at(here.position, here.dx, here.dy, here.normal, body);
    Sample seen = Sample(relief.material, relief.slope, bumped_normal(here.normal, relief.slope), here.eye, here.place);
    if (body != 0) { // planes have the axes of the picture
        seen.slope = in_picture(seen.slope, axes);
        seen.normal = in_picture(seen.normal, axes);
    }
    return seen;
}

// The light of the sample to the eye: see lit() in light.glsl. `lamp` is as in lamp_above, `body` as in sky_above.
vec3 lit_sample(Sample here, vec2 lamp, bool body) {
    GaborMaterial m = here.material;
    return lit(Surface(m.colour, gabor_roughness(m), m.metalness), here.normal, here.eye, lamp_above(here.place, lamp), sky_above(body));
}
