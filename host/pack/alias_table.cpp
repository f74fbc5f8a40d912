#include "pack/alias_table.h"

#include <numeric>
#include <stdexcept>

namespace eikonal {

Table<alias_entry> makeAliasTable(const std::vector<double>& weights) {
    const size_t n = weights.size();
    double sum = 0;
    for (double w : weights) {
        if (!(w >= 0)) throw std::logic_error("a weight of an alias table is negative");
        sum += w;
    }
    Table<alias_entry> table(n);
    std::vector<double> scaled(n);
    std::vector<size_t> small, large;
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
    for (const std::vector<size_t>& rest : {small, large})
        for (size_t i : rest) { table[i].keep = 1; table[i].other = static_cast<uint>(i); }
    return table;
}

Table<alias_entry> makeAliasSquare(std::span<const double> weights, size_t side) {
    std::vector<double> rows;
    Table<alias_entry> columns;
    for (size_t y = 0; y < side; ++y) {
        const std::span<const double> row = weights.subspan(y * side, side);
        rows.push_back(std::accumulate(row.begin(), row.end(), 0.0));
        const Table<alias_entry> aliases = makeAliasTable({row.begin(), row.end()});
        columns.insert(columns.end(), aliases.begin(), aliases.end());
    }
    Table<alias_entry> square = makeAliasTable(rows);
    square.insert(square.end(), columns.begin(), columns.end());
    return square;
}

}  // namespace eikonal
