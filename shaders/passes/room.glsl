// The surroundings of materials on the page, for light.glsl.
const int environment = 0;
