#pragma once
// Which scenes store vertices of light paths for paths from the camera to merge with, and how many (kernels/shade/light_vertices.clh).

#include "pack/context.h"

#include <string>

namespace eikonal {

/// Has vertices merged, because of `why`: sets their radius, the scene's or a guess from its size, and how many light paths store them.
void requireMerging(const PackContext& context, settings& frame, const std::string& why);

/// Sets the radius within which vertices merge in the first pass; scene units.
void setMergeRadius(settings& frame, double radius);

/// The vertices that a light path keeps, at most, in the mean of many (kernels/shade/kept_share.clh).
double mostVerticesOfPath(const settings& frame);
/// Room for the vertices of so many light paths.
size_t roomForVertices(const settings& frame, double paths);
/// The light paths of a pass of which one in 2^log2Share keeps its vertices.
double pathsThatKeep(const settings& frame, uint log2Share);
/// Whole passes whose light paths are traced at a time, a power of two: as many as fill a few waves, and keep `mostVertices` at most, if
/// one pass does. pathsOfPass: those that keep theirs.
unsigned passesAtATime(const PackedScene& scene, double pathsOfPass, double mostVertices);

/// Of the light vertices that are stored at a time.
struct VertexPlan {
    unsigned passes = 0;  ///< of whole passes, a power of two; 0: the scene merges none
    size_t vertices = 0;  ///< room for so many
    size_t buckets = 1;   ///< of the hash grid, at most; a power of two
};
/// For a render of so many samples per pixel. The first pass alone has room for all its vertices; no number changes the image.
VertexPlan planVertices(const PackedScene& scene);

}  // namespace eikonal
