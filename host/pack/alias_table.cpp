#include "pack/alias_table.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace eikonal {

/// Memory that several tables use one after the other.
struct Scratch {
    std::vector<double> scaled;
    std::vector<size_t> small, large;
};

/// Of weights whose sum is known.
static void fillTable(std::span<alias_entry> table, std::span<const double> weights, double sum, Scratch& scratch) {
    auto& [scaled, small, large] = scratch;
    const size_t n = weights.size();
    scaled.resize(n);
    small.clear();
    large.clear();
    for (size_t i = 0; i < n; ++i) {
        const double p = sum > 0 ? weights[i] / sum : 1.0 / static_cast<double>(n);
        table[i].pmf = static_cast<float>(p);
        scaled[i] = p * static_cast<double>(n);
        (scaled[i] < 1 ? small : large).push_back(i);
    }
    while (!small.empty() && !large.empty()) {
        const size_t s = small.back(), l = large.back();
        small.pop_back();
        table[s].keep = static_cast<float>(scaled[s]);
        table[s].other = static_cast<uint>(l);
        scaled[l] -= 1 - scaled[s];
        if (scaled[l] < 1) { large.pop_back(); small.push_back(l); }
    }
    for (const std::vector<size_t>* rest : {&small, &large})
        for (const size_t i : *rest) { table[i].keep = 1; table[i].other = static_cast<uint>(i); }
}

static double sumOf(std::span<const double> weights) {
    if (std::ranges::any_of(weights, [](double w) { return !(w >= 0); })) throw std::logic_error("a weight of an alias table is negative");
    return std::accumulate(weights.begin(), weights.end(), 0.0);
}

Table<alias_entry> makeAliasTable(std::span<const double> weights) {
    Table<alias_entry> table(weights.size());
    Scratch scratch;
    fillTable(table, weights, sumOf(weights), scratch);
    return table;
}

void fillAliasSquare(std::span<alias_entry> square, std::span<const double> weights, size_t side) {
    std::vector<double> rows;
    Scratch scratch;
    for (size_t y = 0; y < side; ++y) {
        const std::span<const double> row = weights.subspan(y * side, side);
        rows.push_back(sumOf(row));
        fillTable(square.subspan((1 + y) * side, side), row, rows.back(), scratch);
    }
    fillTable(square.first(side), rows, sumOf(rows), scratch);
}

Table<alias_entry> makeAliasSquare(std::span<const double> weights, size_t side) {
    Table<alias_entry> square(side + side * side);
    fillAliasSquare(square, weights, side);
    return square;
}

}  // namespace eikonal
