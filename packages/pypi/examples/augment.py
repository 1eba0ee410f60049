"""Adds noise of a random scale, direction and strength to pictures, as a transform for PyTorch."""

import gabor_noise
import numpy as np
import torch


def add_noise(picture: torch.Tensor) -> torch.Tensor:
    """Takes and returns a float tensor of shape (channels, height, width)."""
    number = np.random.default_rng(int(torch.randint(2**31, ())))  # follows torch.manual_seed, and each worker's seed
    noise = gabor_noise.image(picture.shape[-2:], scale=number.uniform(8, 64), frequency=number.uniform(0, 4),
                              orientation=number.uniform(0, np.pi), seed=int(number.integers(2**31)), workers=1)
    return picture + number.uniform(0, 0.2) * torch.from_numpy(noise)


if __name__ == "__main__":
    torch.manual_seed(7)
    pictures = torch.stack([add_noise(torch.full((3, 224, 224), 0.5)) for _ in range(16)])
    print(pictures.shape, float(pictures.mean()), float(pictures.std()))
