GaborFractal fractal = gabor_fractal(Octaves, Gain);
fractal.shape = (int)(Shape + 0.5);
fractal.basis = (int)(Basis + 0.5);
return gabor_fractal_noise(gabor_place_at(Place), fractal, (uint)(int)Seed).noise;
