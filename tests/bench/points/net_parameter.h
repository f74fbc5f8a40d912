#pragma once
// How evenly the first 2^m points of a digital sequence in base 2 lie in boxes.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

using uint = std::uint32_t;

/// Digits of a coordinate for an index, linear over bits: bit j is the digit of 2^-(j + 1).
using Coordinate = std::function<uint(uint)>;

/// The least t for which the first 2^m points are a (t, m, s)-net: any m - t leading digits of the s coordinates are linearly independent.
class NetParameter {
public:
    NetParameter(const std::vector<Coordinate>& coordinates, int m) : m_(m) {
        for (const Coordinate& digits : coordinates) {
            rows_.emplace_back(static_cast<size_t>(m), 0u);
            for (int column = 0; column < m; ++column)
                for (int row = 0; row < m; ++row) rows_.back()[static_cast<size_t>(row)] |= (digits(1u << column) >> row & 1u) << column;
        }
    }
    int t() const {
        int t = 0;
        while (!areIndependent({}, 0, m_ - t)) ++t;
        return t;
    }

private:
    /// Whether `basis` and, however they are shared out, `digits` leading digits of the coordinates from `coordinate` on are independent.
    bool areIndependent(std::vector<uint> basis, size_t coordinate, int digits) const {
        const bool isLast = coordinate + 1 == rows_.size();
        for (int used = 0; used <= digits; ++used) {
            if (used > 0 && !add(basis, rows_[coordinate][static_cast<size_t>(used) - 1])) return false;
            if (!isLast && !areIndependent(basis, coordinate + 1, digits - used)) return false;
        }
        return true;
    }
    /// The basis stays sorted, each vector with a leading bit of its own.
    static bool add(std::vector<uint>& basis, uint vector) {
        for (uint b : basis) vector = std::min(vector, vector ^ b);
        if (vector == 0) return false;
        basis.push_back(vector);
        std::sort(basis.rbegin(), basis.rend());
        return true;
    }

    int m_;
    std::vector<std::vector<uint>> rows_;
};
