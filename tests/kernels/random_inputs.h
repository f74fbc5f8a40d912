#pragma once
// Inputs at random, alike on every machine.

#include "eikonal/portable.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace eikonal {

/// A generator whose numbers do not depend on the C++ library: SplitMix64 (Steele, Lea and Flood 2014).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    uint word() { return static_cast<uint>(next() >> 32); }
    uint below(uint n) { return static_cast<uint>((static_cast<std::uint64_t>(word()) * n) >> 32); }
    /// In [0, 1), 24 bits: what the device's sampler gives.
    float unit() { return static_cast<float>(next() >> 40) * 0x1p-24f; }
    float between(float low, float high) { return low + (high - low) * unit(); }
    /// Each octave alike.
    float logBetween(float low, float high) { return low * std::pow(high / low, unit()); }
    vec2 square() { const float x = unit(); return {x, unit()}; }
    vec3 box(float size) { const float x = between(-size, size), y = between(-size, size); return {x, y, between(-size, size)}; }
    /// Uniform on the unit sphere.
    vec3 direction() {
        const double z = 1 - 2 * static_cast<double>(unit()), phi = 2 * M_PI * static_cast<double>(unit()), r = std::sqrt(1 - z * z);
        return {static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi)), static_cast<float>(z)};
    }

private:
    std::uint64_t state_;
};

/// n values of f().
template <class F> auto generate(size_t n, F&& f) {
    std::vector<decltype(f())> values;
    values.reserve(n);
    for (size_t i = 0; i < n; ++i) values.push_back(f());
    return values;
}

inline double dot(vec3 a, vec3 b) {
    return static_cast<double>(a.x) * static_cast<double>(b.x) + static_cast<double>(a.y) * static_cast<double>(b.y) +
           static_cast<double>(a.z) * static_cast<double>(b.z);
}

}  // namespace eikonal
