return gabor_noise(Place, Frequency, Orientation, (uint)(int)Seed);
