// Searches the masks of kernels/math/joint_pairs.clh, in half a minute: `ninja -C build joint_pairs_search`, then
// `build/tests/bench/joint_pairs_search SEED BEAM`. It prints the masks that it finds, and the tables of docs/sampling.md: for pairs that
// neighbour on a path, t of the first 2^m points, and the variance that they leave of a discontinuous and of a smooth integrand, divided by
// that of independent points. The shipped masks are those of seed 1 and a beam of 40.
//
// A pair of the joint sequence is (U i, P U i): U is a triangular matrix modulo 2, and P is Pascal's. Pixel and vertex 0 are given, and a
// searched U is made of steps i ^= (i >> shift) & mask. The first 2^m points depend on the first m columns of U only, so masks grow column
// by column, and the best of each length are kept.

#include "net_parameter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr int longest = 17;
constexpr uint points = 1u << longest;
constexpr int shifts[] = {1, 3, 2, 5, 8, 1};
constexpr size_t steps = std::size(shifts);

constexpr const char* names[] = {"pixel", "vertex 0", "vertex 1", "lens", "vertex 2"};

struct Masks { uint step[steps] = {}; };

uint reorder(const Masks& masks, uint i) {
    for (size_t s = 0; s < steps; ++s) i ^= (i >> shifts[s]) & masks.step[s];
    return i;
}
uint pascal(uint i) {
    i ^= (i & 0xaaaaaaaa) >> 1; i ^= (i & 0xcccccccc) >> 2; i ^= (i & 0xf0f0f0f0) >> 4; i ^= (i & 0xff00ff00) >> 8;
    return i ^ ((i & 0xffff0000) >> 16);
}
/// As reorder_for_vertex_0 of the kernels.
uint timesW(uint x) { return ((x ^ (x >> 1)) & 0x55555555) | ((x & 0x55555555) << 1); }
uint reorderForVertex0(uint i) {
    i ^= timesW((i & 0xcccccccc) >> 2); i ^= timesW(timesW((i & 0xf0f0f0f0) >> 4)); i ^= timesW((i & 0xff00ff00) >> 8);
    return i ^ timesW(timesW((i & 0xffff0000) >> 16));
}

/// How the variance of an integrand is spread over the digits of a coordinate: the share of functions of the first l digits that vary with
/// digit l falls as weight * decay^l.
struct Integrand { const char* name; double weight, decay, importance; };
constexpr Integrand integrands[] = {{"smooth", 2, 0.25, 0.5}, {"discontinuous", 0.5, 0.5, 1}};
constexpr size_t kinds = std::size(integrands);

/// The variance left by a scrambled net is the sum over its dual net of products of these shares; as a sum over points, the factor of a
/// coordinate depends on its leading zeros only (Walsh functions are constant in between).
std::array<float, 33> factorsOf(const Integrand& f) {
    std::array<float, 33> factors;
    double sum = 0, power = 1;
    for (float& factor : factors) {
        power *= f.decay;
        factor = static_cast<float>(1 + f.weight * (sum - power));
        sum += power;
    }
    return factors;
}
const std::array<float, 33> factors[kinds] = {factorsOf(integrands[0]), factorsOf(integrands[1])};

/// The product of the factors of both coordinates of a pair; digits are reversed, so trailing zeros lead.
float factorOf(size_t kind, uint first) {
    const auto& factor = factors[kind];
    return factor[static_cast<size_t>(std::countr_zero(first))] * factor[static_cast<size_t>(std::countr_zero(pascal(first)))];
}

struct Pair {
    Coordinate order;
    std::vector<float> factors[kinds];
};
Pair pairOf(const Coordinate& order) {
    Pair pair{order, {}};
    for (size_t kind = 0; kind < kinds; ++kind)
        for (uint i = 0; i < points; ++i) pair.factors[kind].push_back(factorOf(kind, order(i)));
    return pair;
}

/// Other pairs that a pair must be well spread with, and how much that counts.
struct Projection { std::vector<size_t> with; double weight; };
struct Candidate {
    Masks masks;
    double cost = 0, tie = 0;
    std::vector<double> sums[kinds];   ///< over points, for each projection
};

/// Powers of four are what people render with.
double importance(int m) { return m == 4 || m == 6 || m == 8 || m == 10 ? 3 : m % 2 == 0 ? 2 : 1; }

class Search {
public:
    Search(const std::vector<Pair>& pairs, const std::vector<Projection>& projections) : projections_(projections) {
        for (size_t kind = 0; kind < kinds; ++kind)
            for (const Projection& p : projections) {
                others_[kind].emplace_back(points, 1.0f);
                for (size_t other : p.with)
                    for (uint i = 0; i < points; ++i) others_[kind].back()[i] *= pairs[other].factors[kind][i];
            }
    }

    Candidate best(size_t beam, std::mt19937& random) {
        std::vector<Candidate> front(1);
        for (size_t kind = 0; kind < kinds; ++kind)
            for (const auto& others : others_[kind]) front[0].sums[kind].push_back(others[0] * factorOf(kind, 0));
        addColumn(front[0], 0);
        for (int column = 1; column < longest; ++column) {
            std::vector<Candidate> next;
            for (const Candidate& c : front) extend(c, column, next, random);
            std::sort(next.begin(), next.end(),
                      [](const Candidate& a, const Candidate& b) { return a.cost + a.tie < b.cost + b.tie; });
            next.resize(std::min(next.size(), beam));
            front = std::move(next);
        }
        /* Beyond, anything will do */
        for (size_t s = 0; s < steps; ++s)
            for (int column = longest; column < 32; ++column)
                if (random() & 1) front[0].masks.step[s] |= 1u << (column - shifts[s]);
        return front[0];
    }

private:
    /// All that the masks can make of a column.
    void extend(const Candidate& c, int column, std::vector<Candidate>& next, std::mt19937& random) {
        std::vector<uint> columns;
        for (uint choice = 0; choice < 1u << steps; ++choice) {
            Candidate n = c;
            bool fits = true;
            for (size_t s = 0; s < steps; ++s) {
                if (!(choice >> s & 1)) continue;
                fits = fits && column >= shifts[s];
                if (fits) n.masks.step[s] |= 1u << (column - shifts[s]);
            }
            const uint made = reorder(n.masks, 1u << column);
            if (!fits || std::find(columns.begin(), columns.end(), made) != columns.end()) continue;
            columns.push_back(made);
            addColumn(n, column);
            n.tie = (random() & 0xffff) * 1e-7;
            next.push_back(std::move(n));
        }
    }

    void addColumn(Candidate& c, int column) {
        for (uint i = 1u << column; i < 2u << column; ++i) {
            const uint first = reorder(c.masks, i);
            for (size_t kind = 0; kind < kinds; ++kind) own_[kind][i] = factorOf(kind, first);
        }
        for (size_t kind = 0; kind < kinds; ++kind)
            for (size_t p = 0; p < projections_.size(); ++p) {
                for (uint i = 1u << column; i < 2u << column; ++i) c.sums[kind][p] += double{others_[kind][p][i]} * own_[kind][i];
                const double left = std::max(c.sums[kind][p] / (2u << column) - 1, 1e-14);
                c.cost += projections_[p].weight * importance(column + 1) * integrands[kind].importance * std::log(left);
            }
    }

    std::vector<Projection> projections_;
    std::vector<std::vector<float>> others_[kinds];
    std::vector<float> own_[kinds] = {std::vector<float>(points), std::vector<float>(points)};
};

/// A row of a table for each group of pairs; a column for each m.
template <class Cell> void printTable(const char* title, const std::vector<Pair>& pairs, int last, int step, const Cell& cell) {
    std::printf("\n| %s |", title);
    for (int m = 2; m <= last; m += step) std::printf(" %d |", m);
    std::printf("\n|---|");
    for (int m = 2; m <= last; m += step) std::printf("--:|");
    for (const std::vector<size_t>& group : {std::vector<size_t>{0, 1}, {1, 2}, {2, 4}, {0, 3}, {0, 1, 2}}) {
        std::string name;
        std::vector<const Pair*> members;
        for (size_t p : group) {
            name += (name.empty() ? "" : ", ") + std::string(names[p]);
            members.push_back(&pairs[p]);
        }
        std::printf("\n| %s |", name.c_str());
        for (int m = 2; m <= last; m += step) std::printf(" %s |", cell(members, m).c_str());
    }
    std::printf("\n");
}

std::string parameter(const std::vector<const Pair*>& members, int m) {
    std::vector<Coordinate> coordinates;
    for (const Pair* p : members) {
        coordinates.push_back(p->order);
        coordinates.push_back([p](uint i) { return pascal(p->order(i)); });
    }
    return std::to_string(NetParameter(coordinates, m).t());
}

/// Independent points leave the integrand's variance, that of one point, divided by their number.
std::string varianceLeft(size_t kind, const std::vector<const Pair*>& members, int m) {
    double sum = 0, one = 1;
    for (const Pair* p : members) one *= p->factors[kind][0];
    for (uint i = 0; i < 1u << m; ++i) {
        double product = 1;
        for (const Pair* p : members) product *= p->factors[kind][i];
        sum += product;
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", (sum - (1u << m)) / (one - 1));
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    std::mt19937 random(argc > 1 ? static_cast<uint>(std::atoi(argv[1])) : 1);
    const size_t beam = argc > 2 ? static_cast<size_t>(std::atoi(argv[2])) : 40;
    const std::vector<std::vector<Projection>> wanted = {{}, {},
        {{{1}, 1}, {{0}, .7}, {{0, 1}, .5}},
        {{{0}, 1}, {{1}, 1}, {{0, 1}, .7}, {{2}, .4}},
        {{{2}, 1}, {{1}, .5}, {{0}, .2}, {{1, 2}, .4}}};
    std::vector<Pair> pairs = {pairOf([](uint i) { return i; }), pairOf(reorderForVertex0)};
    for (size_t p = pairs.size(); p < wanted.size(); ++p) {
        const Masks masks = Search(pairs, wanted[p]).best(beam, random).masks;
        pairs.push_back(pairOf([masks](uint i) { return reorder(masks, i); }));
        std::printf("%s:", names[p]);
        for (uint mask : masks.step) std::printf(" 0x%08x", mask);
        std::printf("\n");
    }
    printTable("t, m =", pairs, 12, 1, parameter);
    for (size_t kind = kinds; kind-- > 0;)
        printTable((std::string(integrands[kind].name) + ", m =").c_str(), pairs, 16, 2,
                   [kind](const std::vector<const Pair*>& members, int m) { return varianceLeft(kind, members, m); });
}
