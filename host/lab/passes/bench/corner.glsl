// The gradients at the corners of Perlin's noises.

uint corner_word(ivec2 corner, uint instance) {
    uint word = uint(corner.x) * 0x9e3779b1u ^ (uint(corner.y) * 0x85ebca6bu + instance);
    word = (word ^ (word >> 16u)) * 0x21f0aaadu;
    word = (word ^ (word >> 15u)) * 0xd35a2d97u;
    return word ^ (word >> 15u);
}

// Dot product of the offset with one of eight gradients.
float slope(ivec2 corner, vec2 offset, uint instance) {
    uint word = corner_word(corner, instance);
    vec2 along = (word & 1u) == 0u ? offset : offset.yx;
    float u = (word & 2u) == 0u ? along.x : -along.x;
    float v = (word & 4u) == 0u ? along.y : -along.y;
    return u + 0.5 * v;
}
