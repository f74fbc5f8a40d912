// Makes scenes/gallery/assets/ring.nvdb, a ring of smoke: density in a torus, ragged by sines.
//     g++ -std=c++17 -I. scenes/gallery/make_ring.cpp -lz -lblosc -o /tmp/make_ring && /tmp/make_ring scenes/gallery/assets/ring.nvdb
#include "tests/nanovdb_file.h"

#include <cmath>

int main(int, char** arguments) {
    const auto density = [](int x, int y, int z) {
        const double turn = std::atan2(y, x), r = std::hypot(x, y) - 15 - 1.2 * std::sin(3 * turn), h = z - 1.5 * std::sin(2 * turn + 1);
        const double ragged = std::sin(0.9 * x + 1.7 * std::sin(0.5 * z)) * std::sin(0.8 * y + 1.3 * std::sin(0.7 * x)) *
                              std::sin(0.9 * z + 2);
        const double inside = 1 - std::hypot(r, h) / 6 + 0.3 * ragged;
        return static_cast<float>(inside > 0.02 ? std::round(std::min(1., 1.6 * inside) * 64) / 64 : 0);
    };
    eikonal::writeNanoVdb(arguments[1], {{"density", 24, 1, density}}, nanovdb::io::Codec::ZIP);
}
