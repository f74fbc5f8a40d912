// Searches the masks of kernels/math/joint_pairs.clh: `joint_pairs_search SEED BEAM` prints those that it finds, and for each projection
// the quality parameters t of the first 2^2, 2^3 ... points. The shipped masks are those of seed 14 and a beam of 300.
//
// A pair of the joint sequence is (U i, P U i): U is a triangular matrix modulo 2, made of steps i ^= (i >> shift) & mask, and P is
// Pascal's. The first 2^m points depend on the first m columns of U only, so masks grow column by column, and the best of each length are
// kept.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

namespace {

using uint = std::uint32_t;
constexpr int steps = 4, longest = 12, longestOfThreePairs = 9;
constexpr int shifts[steps] = {1, 2, 3, 1};

struct Masks { uint step[steps] = {}; };

uint reorder(const Masks& masks, uint i) {
    for (int s = 0; s < steps; ++s) i ^= (i >> shifts[s]) & masks.step[s];
    return i;
}
uint pascal(uint i) {
    i ^= (i & 0xaaaaaaaa) >> 1; i ^= (i & 0xcccccccc) >> 2; i ^= (i & 0xf0f0f0f0) >> 4; i ^= (i & 0xff00ff00) >> 8;
    return i ^ ((i & 0xffff0000) >> 16);
}

/// Row r of the generator matrices of both coordinates, digits from the most significant on.
struct Rows { uint coordinate[2][16] = {}; };
Rows rowsOf(const Masks& masks, int columns) {
    Rows rows;
    for (int j = 0; j < columns; ++j) {
        const uint first = reorder(masks, 1u << j), second = pascal(first);
        for (int r = 0; r < columns; ++r) {
            rows.coordinate[0][r] |= ((first >> r) & 1) << j;
            rows.coordinate[1][r] |= ((second >> r) & 1) << j;
        }
    }
    return rows;
}

/// The first 2^m points of some coordinates.
class Net {
public:
    Net(int m, std::vector<const uint*> coordinates) : m_(m), coordinates_(std::move(coordinates)) {}
    /// The smallest t so that any m - t leading rows, however shared among coordinates, are independent (Niederreiter 1987).
    int t() {
        int rank = 0;
        while (rank < m_ && areIndependent(0, rank + 1)) ++rank;
        return m_ - rank;
    }

private:
    bool areIndependent(size_t coordinate, int rows) {
        const std::vector<uint> before = basis_;
        bool independent = true;
        const bool isLast = coordinate + 1 == coordinates_.size();
        for (int n = 0; independent && n <= rows; ++n) {
            independent = n == 0 || add(coordinates_[coordinate][n - 1]);
            if (independent && !isLast) independent = areIndependent(coordinate + 1, rows - n);
        }
        basis_ = before;
        return independent;
    }
    bool add(uint row) {
        for (uint b : basis_) row = std::min(row, row ^ b);
        if (row == 0) return false;
        for (uint& b : basis_) b = std::min(b, b ^ row);
        basis_.push_back(row);
        return true;
    }

    int m_;
    std::vector<const uint*> coordinates_;
    std::vector<uint> basis_;
};

/// Other pairs that a pair must be well spread with, and how much that counts.
struct Projection { std::vector<size_t> with; double weight; };
struct Candidate { Masks masks; double cost = 0, tie = 0; std::vector<std::vector<int>> t; };

/// Powers of four are what people render with.
double importance(int m) { return m == 4 || m == 6 || m == 8 ? 4 : m == 10 ? 1.5 : 1; }

Candidate grown(Candidate c, int m, const std::vector<Rows>& others, const std::vector<Projection>& projections) {
    const Rows own = rowsOf(c.masks, m);
    for (size_t p = 0; p < projections.size(); ++p) {
        if (projections[p].with.size() > 1 && m > longestOfThreePairs) continue;
        std::vector<const uint*> coordinates;
        for (size_t other : projections[p].with)
            coordinates.insert(coordinates.end(), {others[other].coordinate[0], others[other].coordinate[1]});
        coordinates.insert(coordinates.end(), {own.coordinate[0], own.coordinate[1]});
        c.t[p].push_back(Net(m, coordinates).t());
        c.cost += projections[p].weight * importance(m) * std::pow(2.0, c.t[p].back());
    }
    return c;
}

Candidate search(const std::vector<Masks>& pairs, const std::vector<Projection>& projections, size_t beam, std::mt19937& random) {
    std::vector<Candidate> front(1);
    front[0].t.resize(projections.size());
    for (int j = 1; j < longest; ++j) {
        std::vector<Rows> others;
        for (const Masks& m : pairs) others.push_back(rowsOf(m, j + 1));
        std::vector<Candidate> next;
        for (const Candidate& c : front) {
            std::vector<uint> columns;
            for (uint choice = 0; choice < 1u << steps; ++choice) {
                Candidate n = c;
                bool fits = true;
                for (int s = 0; s < steps; ++s) {
                    if (!(choice >> s & 1)) continue;
                    fits = fits && j >= shifts[s];
                    if (fits) n.masks.step[s] |= 1u << (j - shifts[s]);
                }
                const uint column = reorder(n.masks, 1u << j);
                if (!fits || std::find(columns.begin(), columns.end(), column) != columns.end()) continue;
                columns.push_back(column);
                next.push_back(grown(n, j + 1, others, projections));
                next.back().tie = (random() & 0xffff) * 1e-7;
            }
        }
        std::sort(next.begin(), next.end(), [](const Candidate& a, const Candidate& b) { return a.cost + a.tie < b.cost + b.tie; });
        next.resize(std::min(next.size(), beam));
        front = next;
    }
    /* Beyond, anything will do */
    for (int s = 0; s < steps; ++s)
        for (int j = longest; j < 32; ++j)
            if (random() & 1) front[0].masks.step[s] |= 1u << (j - shifts[s]);
    return front[0];
}

}  // namespace

int main(int argc, char** argv) {
    std::mt19937 random(argc > 1 ? static_cast<uint>(std::atoi(argv[1])) : 14);
    const size_t beam = argc > 2 ? static_cast<size_t>(std::atoi(argv[2])) : 300;
    const char* names[] = {"pixel", "vertex 0", "vertex 1", "lens", "vertex 2"};
    const std::vector<std::vector<Projection>> wanted = {{},
        {{{0}, 1}},
        {{{1}, 1}, {{0}, .7}, {{0, 1}, .5}},
        {{{0}, 1}, {{1}, 1}, {{2}, .3}},
        {{{2}, 1}, {{1}, .7}, {{0}, .4}, {{1, 2}, .4}}};
    std::vector<Masks> pairs(1);
    for (size_t p = 1; p < wanted.size(); ++p) {
        const Candidate best = search(pairs, wanted[p], beam, random);
        pairs.push_back(best.masks);
        std::printf("%s:", names[p]);
        for (uint mask : best.masks.step) std::printf(" 0x%08x", mask);
        std::printf("\n");
        for (size_t w = 0; w < wanted[p].size(); ++w) {
            std::printf("   with");
            for (size_t other : wanted[p][w].with) std::printf(" %s,", names[other]);
            std::printf(" t =");
            for (int t : best.t[w]) std::printf(" %d", t);
            std::printf("\n");
        }
    }
}
