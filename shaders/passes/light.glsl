// A material under a lamp at the upper left, with soft light from a window around it. The surface is the plane z = 0; y points
// down the picture.
// Microfacets after Walter et al., "Microfacet models for refraction through rough surfaces", 2007 (GGX).

// The light from direction `d`: a bright window above, dark walls.
vec3 surroundings(vec3 d, float roughness) {
    float soft = 0.3 + 0.6 * roughness;
    float window = smoothstep(-soft, soft, 0.35 - abs(d.x + 0.12 - 0.2 * d.y)) * smoothstep(-soft, soft, 0.4 - d.y);
    return vec3(0.13, 0.14, 0.16) + vec3(0.8, 0.85, 0.95) * window;
}

// The direction to the eye, which is above the middle of the picture. Places are -0.5 to 0.5 along its longer side.
vec3 eye_above(vec2 place) {
    return normalize(vec3(-place, 1.8));
}

// The direction to the lamp.
vec3 lamp_above(vec2 place) {
    return normalize(vec3(vec2(-0.75, -0.85) - 0.6 * place, 1.0));
}

const vec3 backdrop = vec3(0.016, 0.017, 0.019); // behind a body

// The sky, from the horizon at 0 to the picture's edge at 1.
vec3 sky_colour(float up) {
    return mix(vec3(0.62, 0.69, 0.76), vec3(0.27, 0.42, 0.62), up);
}

// What reflects the light, as in GaborMaterial.
struct Surface {
    vec3 colour;
    float roughness;
    float metalness;
};

// The light towards the eye, linear.
//   normal     of the surface, of length 1, z pointing out of the picture
//   eye, lamp  directions towards them, of length 1
vec3 lit(Surface material, vec3 normal, vec3 eye, vec3 lamp) {
    vec3 between = normalize(eye + lamp);
    float facing = max(dot(normal, lamp), 0.0);
    float seen = max(dot(normal, eye), 0.05);

    vec3 mirror = mix(vec3(0.04), material.colour, material.metalness);
    vec3 fresnel = mirror + (1.0 - mirror) * pow(1.0 - max(dot(between, eye), 0.0), 5.0);
    vec3 edge = mirror + (max(vec3(1.0 - material.roughness), mirror) - mirror) * pow(1.0 - seen, 5.0);
    float a = max(material.roughness * material.roughness, 0.01);
    float cosine = max(dot(normal, between), 0.0);
    float spread = cosine * cosine * (a * a - 1.0) + 1.0;
    float facets = a * a / (3.1415927 * spread * spread);
    float k = 0.5 * a;
    float shadow = 0.25 / ((facing * (1.0 - k) + k) * (seen * (1.0 - k) + k));

    vec3 diffuse = (1.0 - material.metalness) * material.colour;
    vec3 sky = vec3(0.27, 0.29, 0.32) * (0.5 + 0.5 * normal.z);
    vec3 shine = surroundings(reflect(-eye, normal), material.roughness);
    return diffuse * (sky + 0.95 * facing * vec3(1.0, 0.96, 0.9)) + edge * shine * 0.7
           + 1.1 * facing * facets * shadow * fresnel;
}
