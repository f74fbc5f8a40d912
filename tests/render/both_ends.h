#pragma once
// Scenes for paths from both ends, and what paths from the camera say of the same light.

#include "rendering.h"

#include <string>
#include <vector>

namespace eikonal {

View view();
/// The text of a scene with another directive instead of the one of that name.
std::string sceneWith(View v, const std::string& directive, const std::string& world);
/// The same scene with another integrator than "volpath": its name in quotes, and parameters.
std::string withIntegrator(const std::string& integrator, std::string text);

/// Three walls, and what may be between them.
extern const std::string room;
std::string lamp(const std::string& shape);
std::string ball(const std::string& material);
/// A lamp over the walls.
extern const std::string panel;
/// What follows moves.
extern const std::string moving;

/// The mean of an image, and its standard error by what the film says of the variance of each pixel.
Estimate meanOf(const FilmImage& image);

/// The mean of the green of a layer of an image.
double meanGreen(const std::vector<glm::vec3>& layer);

/// The scene `other` has the light of `text`: the means of the images, and of each of 16 parts of them, are within 4 standard errors. bias:
/// by how much of the mean it may be off besides.
void expectSameLight(const std::string& text, const std::string& other, double bias = 0);

/// An image that is rendered in waves of other sizes, in ranges of its samples (24 or more of each pixel), or in part (24 x 24 pixels or
/// more) has the bits of the scene's image.
void expectSameBitsInAnyWaves(const PackedScene& scene, const FilmImage& image);
void expectSameBitsInRangesOfSamples(const PackedScene& scene, const FilmImage& image);
void expectSameBitsInACrop(PackedScene scene, const FilmImage& image);

}  // namespace eikonal
