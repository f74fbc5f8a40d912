#pragma once
// The variances that pbrt-v4's film "gbuffer" writes, made of those that our film keeps.

#include "image/film_image.h"

namespace eikonal {

/// Fills in sampleVariance, the variance of one sample of a pixel, and relativeVariance, that over the mean, for an image with `variance`.
/// samples: of a pixel, where the image has no sampleCount. The film keeps the variance of the luminance, so a channel's is estimated: its
/// deviation is to that of the luminance as the channel is to the luminance. 0 for black. pbrt-v4 counts the samples of surfaces only;
/// these are all samples.
void addSampleVariance(FilmImage& image, double samples = 1);

}  // namespace eikonal
