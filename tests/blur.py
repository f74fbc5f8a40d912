"""What a filter, a denoiser or an eye makes of an image's error: both measurements of samplers, tests/accuracy/equal_error.py and tests/bench/points.py, look at it."""

import numpy as np

BLUR = 1.5


def blur(image):
    """An image of one channel after a Gaussian of BLUR pixels, mirrored at its edges."""
    radius = int(4 * BLUR)
    weights = np.exp(-0.5 * (np.arange(-radius, radius + 1) / BLUR) ** 2)
    for axis in (0, 1):
        padded = np.pad(image, [(radius, radius) if a == axis else (0, 0) for a in (0, 1)], mode="reflect")
        image = sum(w * np.take(padded, range(i, i + image.shape[axis]), axis) for i, w in enumerate(weights / weights.sum()))
    return image
