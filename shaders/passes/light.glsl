// Lights a material with a lamp and the light of its surroundings. The constant `environment` is 0 for a room with a window, 1
// for an overcast sky, and 2 for darkness. The surface is the plane z = 0; y points down the picture. Surfaces reflect light as
// in glTF 2.0: Lambert's diffuse reflection and GGX microfacets (Walter et al., Microfacet models for refraction through rough
// surfaces, 2007). So the exported maps look the same in other renderers; see docs/gallery.md.

// The room's light from direction `d`: dark walls and a window, blurred by the roughness of the surface that reflects
// it.
const vec3 walls = vec3(0.13, 0.14, 0.16);
const vec3 window = vec3(0.8, 0.85, 0.95);
vec3 room(vec3 d, float roughness) {
    float soft = 0.3 + 2.2 * roughness * roughness;
    return walls + window * smoothstep(-soft, soft, 0.35 - abs(d.x + 0.12 - 0.2 * d.y)) * smoothstep(-soft, soft, 0.4 - d.y);
}

// The mean of the room's light over a hemisphere, weighted by the cosine; within 0.02 of the integral.
vec3 diffuse_room(vec3 n) {
    return walls + window * (0.304 - dot(vec2(0.085, 0.177), n.xy) - dot(vec3(0.182, 0.08, -0.087), vec3(n.xy * n.xy, n.x * n.y)));
}

// The CIE standard overcast sky, over ground that reflects a fifth of its light. `up` is the cosine of the angle to the
// zenith. The mean over a hemisphere is exact (Moon and Spencer, 1942); the blur is within 0.03 of the integral over facets.
const vec3 zenith = vec3(0.56, 0.6, 0.65);
const float ground = 0.155556; // relative to the zenith
vec3 diffuse_overcast(float up) {
    up = clamp(up, -1.0, 1.0);
    return zenith * ((1.0 + up) / 6.0 + 0.141471 * (sqrt(1.0 - up * up) + acos(-up) * up) + 0.5 * ground * (1.0 - up));
}
vec3 overcast(float up, float roughness) {
    float soft = 2.0 * roughness * roughness + 0.001;
    float sharp = mix(ground, (1.0 + 2.0 * max(up, 0.0)) / 3.0, smoothstep(-soft, soft, up));
    return mix(zenith * sharp, diffuse_overcast(up), smoothstep(0.1, 1.0, roughness));
}

// The direction to the eye, which is above the middle of the picture. `place` runs from -0.5 to 0.5 along the picture's longer
// side.
vec3 eye_above(vec2 place) {
    return normalize(vec3(-place, 1.8));
}

// The direction to the lamp. Its distance from the middle of the picture is 2.5 times the picture's longer side. `lamp` holds x
// and y of the unit vector from the middle to the lamp.
vec3 lamp_above(vec2 place, vec2 lamp) {
    return normalize(vec3(2.5 * lamp - place, 2.5 * sqrt(max(1.0 - dot(lamp, lamp), 0.0))));
}

// The direction of the sky, along the picture's axes: above a body in the picture, and above a plane towards the eye.
vec3 sky_above(bool body) {
    return body ? vec3(0.0, -1.0, 0.0) : vec3(0.0, 0.0, 1.0);
}

const vec3 backdrop = vec3(0.016, 0.017, 0.019); // the colour behind a body

// The colour of the sky. `up` is 0 at the horizon and 1 at the picture's edge.
vec3 sky_colour(float up) {
    return environment == 0   ? mix(vec3(0.62, 0.69, 0.76), vec3(0.27, 0.42, 0.62), up)
           : environment == 1 ? overcast(0.25 * up + 0.001, 0.0)
                              : backdrop;
}

// How a surface reflects light, from GaborMaterial.
struct Surface {
    vec3 colour;
    float roughness; // gabor_roughness
    float metalness;
};

// The share of light from all around that the surface reflects to the eye, including light that facets reflect more than once
// (after Fdez-Aguera, A multiple-scattering microfacet model for real-time image based lighting, 2019). `once` and `grazing`
// are fitted to integrals over GGX.
vec3 reflected(vec3 mirror, float roughness, float seen) {
    float square = roughness * roughness;
    float once = 1.0 - square * (0.458 + 0.289 * square * seen); // share that a mirror's facets reflect at the first bounce
    float grazing = pow(max(1.0 - seen, 0.0), 5.28 - 4.03 * roughness) * exp(-6.17 * square);
    return (mirror * (once - grazing) + grazing) * (1.0 + mirror * (1.0 / once - 1.0));
}

// The linear light that the surface sends to the eye.
//   normal         unit normal of the surface, with z pointing out of the picture
//   eye, lamp, up  unit vectors towards the eye, the lamp and the zenith
vec3 lit(Surface material, vec3 normal, vec3 eye, vec3 lamp, vec3 up) {
    const vec3 lamp_light = 0.7 * vec3(1.0, 0.96, 0.9); // irradiance / pi
    vec3 between = normalize(eye + lamp);
    float facing = max(dot(normal, lamp), 0.0);
    float seen = max(dot(normal, eye), 0.05);

    vec3 mirror = mix(vec3(0.04), material.colour, material.metalness);
    vec3 fresnel = mirror + (1.0 - mirror) * pow(1.0 - max(dot(between, eye), 0.0), 5.0);
    float a = max(material.roughness * material.roughness, 0.01);
    float cosine = max(dot(normal, between), 0.0);
    float spread = cosine * cosine * (a * a - 1.0) + 1.0;
    float facets = a * a / (spread * spread); // times pi
    float k = 0.5 * a;
    float shadow = 0.25 / ((facing * (1.0 - k) + k) * (seen * (1.0 - k) + k));

    vec3 share = reflected(mirror, material.roughness, seen);
    vec3 diffuse = (1.0 - share) * (1.0 - material.metalness) * material.colour;
    vec3 around = vec3(0.0), reflection = vec3(0.0);
    if (environment == 0) {
        around = diffuse_room(normal);
        reflection = room(reflect(-eye, normal), material.roughness);
    } else if (environment == 1) {
        around = diffuse_overcast(dot(normal, up));
        reflection = overcast(dot(reflect(-eye, normal), up), material.roughness);
    }
    return diffuse * (around + facing * lamp_light)
           + share * reflection
           + facing * facets * shadow * fresnel * lamp_light;
}

// The normal of a surface with a relief of this slope, in space.
vec3 bumped_normal(vec3 normal, vec3 slope) {
    return normalize(normal - (slope - dot(slope, normal) * normal));
}
