#include "pack/implicit_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace eikonal {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(), mostFinite = 1e35, tiny = 1e-36;
/* Relative errors of an operation and of a function, at least twice those of the device; the error of its sine */
constexpr double rounding = 0x1p-21, functionRounding = 0x1p-18, sineError = 2e-6;

ValueRange widened(double low, double high, double by = rounding) {
    low -= std::abs(low) * by + tiny;
    high += std::abs(high) * by + tiny;
    return {low < -mostFinite ? -infinite : std::min(low, mostFinite), high > mostFinite ? infinite : std::max(high, -mostFinite)};
}
ValueRange whole() { return {-infinite, infinite}; }

/// The bound of a product: 0 times infinity is 0.
double times(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }
ValueRange multiply(ValueRange a, ValueRange b, double by = rounding) {
    const auto [low, high] = std::minmax({times(a.low, b.low), times(a.low, b.high), times(a.high, b.low), times(a.high, b.high)});
    return widened(low, high, by);
}
ValueRange magnitude(ValueRange a) { return {std::max({0.0, a.low, -a.high}), std::max(-a.low, a.high)}; }
ValueRange square(ValueRange a) {
    const ValueRange m = magnitude(a), s = multiply(m, m);
    return {std::max(s.low, 0.0), s.high};
}
ValueRange integerPower(ValueRange a, uint n) {
    const bool isEven = n % 2 == 0;
    if (isEven) a = magnitude(a);
    const ValueRange r = widened(std::pow(a.low, n), std::pow(a.high, n), (n + 2) * rounding);
    return {isEven ? std::max(r.low, 0.0) : r.low, r.high};
}
ValueRange power(ValueRange a, double p) {
    const ValueRange r = widened(std::pow(std::max(a.low, 0.0), p), std::pow(a.high, p), functionRounding);
    return {std::max(r.low, 0.0), r.high};
}
ValueRange reciprocal(ValueRange a) { return a.hasZero() ? whole() : widened(1 / a.high, 1 / a.low, 4 * rounding); }

ValueRange sine(ValueRange a) {
    using std::numbers::pi;
    const double margin = 1e-5 + 1e-6 * std::max(std::abs(a.low), std::abs(a.high));
    /* Whether a point first + k period, k an integer, is near the interval */
    const auto meets = [&](double first) {
        return std::floor((a.high + margin - first) / (2 * pi)) > std::floor((a.low - margin - first) / (2 * pi));
    };
    if (!(a.high - a.low < 2 * pi) || magnitude(a).high > 1e4) return {-1, 1};
    const auto [low, high] = std::minmax({std::sin(a.low), std::sin(a.high)});
    return {meets(-pi / 2) ? -1 - sineError : low - sineError, meets(pi / 2) ? 1 + sineError : high + sineError};
}

ValueRange angle(ValueRange y, ValueRange x) {
    if (y.hasZero() && x.low <= 0) return {-3.1416, 3.1416};
    const auto [low, high] =
        std::minmax({std::atan2(y.low, x.low), std::atan2(y.low, x.high), std::atan2(y.high, x.low), std::atan2(y.high, x.high)});
    return widened(low, high, functionRounding);
}

/// One instruction. None: undefined for all operands.
std::optional<ValueRange> evaluate(const implicit_instruction& step, ValueRange a, ValueRange b) {
    const double number = step.number;
    switch (static_cast<implicit_operation>(step.operation)) {
        case implicit_number: return ValueRange{number, number};
        case implicit_add: return widened(a.low + b.low, a.high + b.high);
        case implicit_subtract: return widened(a.low - b.high, a.high - b.low);
        case implicit_shift: return widened(a.low + number, a.high + number);
        case implicit_scale: return multiply(a, {number, number});
        case implicit_multiply: return multiply(a, b);
        case implicit_square: return square(a);
        case implicit_integer_power: return integerPower(a, step.b);
        case implicit_power: return a.high < 0 ? std::nullopt : std::optional(power(a, number));
        case implicit_reciprocal: return reciprocal(a);
        case implicit_sqrt: return a.high < 0 ? std::nullopt : std::optional(power(a, 0.5));
        case implicit_exp: return widened(std::exp(a.low), std::exp(a.high), functionRounding);
        case implicit_log:
            if (a.high <= 0) return std::nullopt;
            return widened(a.low <= tiny ? -infinite : std::log(a.low), std::log(a.high), functionRounding);
        case implicit_sine: return sine(a);
        case implicit_asin:
            if (a.low > 1 || a.high < -1) return std::nullopt;
            return widened(std::asin(std::max(a.low, -1.0)), std::asin(std::min(a.high, 1.0)), functionRounding);
        case implicit_atan: return widened(std::atan(a.low), std::atan(a.high), functionRounding);
        case implicit_abs: return magnitude(a);
        case implicit_min: return ValueRange{std::min(a.low, b.low), std::min(a.high, b.high)};
        case implicit_max: return ValueRange{std::max(a.low, b.low), std::max(a.high, b.high)};
        case implicit_atan2: return angle(a, b);
    }
    return std::nullopt;
}

}  // namespace

std::optional<ValueRange> boundsOver(std::span<const implicit_instruction> program, const Box& box) {
    std::array<ValueRange, IMPLICIT_REGISTERS> registers{};
    for (int c = 0; c < 3; ++c) registers[static_cast<size_t>(c)] = widened(box.low[c], box.high[c]);
    ValueRange last{};
    for (const implicit_instruction& step : program) {
        /* The second operand of an integer power is its exponent */
        const ValueRange b = step.operation == implicit_integer_power ? ValueRange{} : registers[step.b];
        const std::optional<ValueRange> value = evaluate(step, registers[step.a], b);
        if (!value) return std::nullopt;
        last = registers[step.target] = *value;
    }
    return last;
}

}  // namespace eikonal
