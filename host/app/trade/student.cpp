#include "app/trade/student.h"

#include <cmath>

namespace eikonal {

/* Finite sums in the angle whose tangent is t / sqrt(freedom) (Abramowitz and Stegun 1964, 26.7.3 and 26.7.4) */
double studentTail(double t, int freedom) {
    const double angle = std::atan(std::abs(t) / std::sqrt(freedom)), sine = std::sin(angle), cosine2 = std::cos(angle) * std::cos(angle);
    const bool isOdd = freedom % 2 == 1;
    double term = isOdd ? std::cos(angle) : 1, sum = freedom > 1 ? term : 0;
    for (int k = isOdd ? 3 : 2; k <= freedom - 2; k += 2) {
        term *= cosine2 * (k - 1) / k;
        sum += term;
    }
    const double within = isOdd ? 2 / M_PI * (angle + sine * sum) : sine * sum;
    return std::fmax(0., 1 - within);
}

double studentQuantile(int freedom, double tail) {
    if (freedom < 1) return 0;
    double low = 0, high = 1;
    while (studentTail(high, freedom) > tail) high *= 2;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (studentTail(middle, freedom) > tail ? low : high) = middle;
    }
    return high;
}

}  // namespace eikonal
