#pragma once
// Light that the paths of an integrator cannot find, or hardly ever: what smooth surfaces reflect or transmit onto others; with light
// paths, only what is then seen by way of smooth surfaces, too.

#include <string>
#include <vector>

namespace eikonal {

struct PackedScene;

/// A sentence for each of: lights without an area (point, spot, distant ...), which no path can hit, so that their light behind smooth
/// surfaces is missing; and lamps so small that few paths hit them. A path that is scattered at random finds a lamp of area A in a scene of
/// radius R about once in pi R^2 / A: worth mentioning below 1 / 1000. Empty if the scene has no such lights, or no smooth surfaces.
std::vector<std::string> missedLight(const PackedScene& packed);
/// Those of these sentences that more light paths, or merging, would mend: subsurface bodies are nothing that light paths go through.
std::vector<std::string> lightForLightPaths(const PackedScene& packed);
/// Whether the first of the latter holds: some light is missing, however many samples there are.
bool missesLightForGood(const PackedScene& packed);

}  // namespace eikonal
