#pragma once
// Light on a diffuse floor, against closed forms. The camera looks at the origin of the floor y = 0, whose
// reflectance is rho = 1/2: what it sees is L = rho E / pi, with the irradiance E derived in each test.

#include "rendering.h"

#include <cmath>
#include <string>

namespace eikonal {

constexpr double rho = 0.5, pi = M_PI;
inline const std::string floorShape = "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5]\n"
    "Shape \"trianglemesh\" \"point3 P\" [-50 0 -50  50 0 -50  50 0 50  -50 0 50] \"integer indices\" [0 1 2 0 2 3]\n";

inline View atTheOrigin(int maxDepth = 1) {
    View view;
    view.lookAt = "0 1 -2  0 0 0  0 1 0";
    view.maxDepth = maxDepth;
    return view;
}
inline Rendered onTheFloor(const std::string& light) { return render(sceneText(atTheOrigin(), light + "\n" + floorShape), surfaces()); }

inline std::string emitter(const std::string& shape, const std::string& more = "") {
    return "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] " + more + " Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n" +
           shape + "\nAttributeEnd";
}
constexpr double Le = 4;

// A rectangle parallel to the floor at height 1 with a corner above the origin, sides a and b (Howell's catalogue of configuration factors,
// B-4): E = L / 2 (a / sqrt(1 + a^2) atan(b / sqrt(1 + a^2)) + b / sqrt(1 + b^2) atan(a / sqrt(1 + b^2))).
inline double irradianceOfRectangle(double a, double b) {
    const double p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
    return Le / 2 * (a / p * std::atan(b / p) + b / q * std::atan(a / q));
}

}  // namespace eikonal
