// The law of gabor_lattice_3d.glsl over independent instances.
