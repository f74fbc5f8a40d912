#include "color/diffuse_albedo.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace eikonal {
namespace {

constexpr int halfNodes = 12, nodes = 2 * halfNodes;   ///< directions in a hemisphere: half inside the critical angle, half beyond
constexpr int straight = nodes, size = nodes + 1;      ///< plus the perpendicular direction with weight 0, used only to evaluate
constexpr int moments = halfNodes;                     ///< of the phase function's Legendre series
constexpr int tableSteps = 64;

/// A linear map of radiances; entry [i][j] is the contribution of direction j to direction i.
struct Matrix {
    std::vector<double> a = std::vector<double>(size * size);
    double& at(int i, int j) { return a[static_cast<size_t>(i * size + j)]; }
    double at(int i, int j) const { return a[static_cast<size_t>(i * size + j)]; }
};
Matrix operator*(const Matrix& x, const Matrix& y) {
    Matrix z;
    for (int i = 0; i < size; ++i)
        for (int k = 0; k < size; ++k)
            for (int j = 0; j < size; ++j) z.at(i, j) += x.at(i, k) * y.at(k, j);
    return z;
}
/// Solves (1 - m) x = b by elimination; 1 - m is diagonally dominant here.
Matrix solveSeries(const Matrix& m, Matrix b) {
    Matrix left;
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) left.at(i, j) = (i == j ? 1 : 0) - m.at(i, j);
    for (int k = 0; k < size; ++k)
        for (int i = 0; i < size; ++i) {
            if (i == k) continue;
            const double factor = left.at(i, k) / left.at(k, k);
            for (int j = 0; j < size; ++j) {
                left.at(i, j) -= factor * left.at(k, j);
                b.at(i, j) -= factor * b.at(k, j);
            }
        }
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) b.at(i, j) /= left.at(i, i);
    return b;
}

double legendre(int degree, double x) {
    double before = 1, value = x;
    if (degree == 0) return 1;
    for (int k = 2; k <= degree; ++k) before = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * before) / k);
    return value;
}

/// Cosines of the directions, with Gauss-Legendre weights for each half.
struct Directions {
    double mu[size], weight[size];

    explicit Directions(double eta) {
        const double critical = eta > 1 ? std::sqrt(1 - 1 / (eta * eta)) : 0.5;
        for (int i = 0; i < halfNodes; ++i) {
            /* Newton's method, from Tricomi's initial guess */
            double x = std::cos(std::numbers::pi * (i + 0.75) / (halfNodes + 0.5)), slope = 1;
            for (int step = 0; step < 20; ++step) {
                slope = halfNodes * (x * legendre(halfNodes, x) - legendre(halfNodes - 1, x)) / (x * x - 1);
                x -= legendre(halfNodes, x) / slope;
            }
            const double share = 1 / ((1 - x * x) * slope * slope);   // weight on an interval of length 1
            mu[i] = critical * (1 + x) / 2;
            weight[i] = critical * share;
            mu[halfNodes + i] = critical + (1 - critical) * (1 + x) / 2;
            weight[halfNodes + i] = (1 - critical) * share;
        }
        mu[straight] = 1;
        weight[straight] = 0;
    }
};

/// Unpolarised Fresnel reflectance from inside.
double fresnelFromInside(double mu, double eta) {
    const double sine2 = eta * eta * (1 - mu * mu);
    if (sine2 >= 1) return 1;
    const double outside = std::sqrt(1 - sine2);
    const double across = (eta * mu - outside) / (eta * mu + outside), along = (mu - eta * outside) / (mu + eta * outside);
    return (across * across + along * along) / 2;
}

/// The reflection of a half-space without a boundary.
Matrix reflectionOfHalfSpace(const Directions& directions, double rho, double g) {
    /* Treat nearly forward scattering as no scattering (the delta-M method, Wiscombe 1977), nearly backward scattering as mirroring */
    const double peak = std::pow(std::abs(g), moments), forward = g < 0 ? 0 : peak, backward = g < 0 ? peak : 0;
    const double extinction = 1 - rho * forward, scattered = rho * (1 - peak) / extinction, mirrored = rho * backward / extinction;

    /* A layer so thin that multiple scattering is negligible */
    constexpr double thin = 1e-6;
    Matrix r, t;
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) {
            double onwards = 0, back = 0;
            for (int k = 0; k < moments; ++k) {
                const double moment = (std::pow(std::abs(g), k) - peak) / (1 - peak) * (g < 0 && k % 2 ? -1 : 1);
                const double term = (2 * k + 1) * moment * legendre(k, directions.mu[i]) * legendre(k, directions.mu[j]);
                onwards += term;
                back += k % 2 ? -term : term;
            }
            const double share = thin / directions.mu[i] * scattered / 2 * directions.weight[j];
            r.at(i, j) = share * back;
            t.at(i, j) = share * onwards;
        }
        t.at(i, i) += 1 - thin / directions.mu[i];
        r.at(i, i) += thin / directions.mu[i] * mirrored;
    }

    /* Double the layer until nothing returns from below */
    Matrix same;
    for (int i = 0; i < size; ++i) same.at(i, i) = 1;
    for (double thickness = thin, more = 1; thickness < 1e6 && more > 1e-9; thickness *= 2) {
        const Matrix leaving = t * solveSeries(r * r, same), below = leaving * (r * t);
        t = leaving * t;
        more = std::ranges::max(below.a);
        for (size_t i = 0; i < r.a.size(); ++i) r.a[i] += below.a[i];
    }
    return r;
}

}  // namespace

double diffuseAlbedo(double rho, double g, double eta) {
    if (rho <= 0) return 0;
    if (rho >= 1) return 1;
    const Directions directions(eta);
    const Matrix r = reflectionOfHalfSpace(directions, rho, g);

    /* By reciprocity, compute the radiance seen in the perpendicular direction when the body is in a white environment */
    Matrix again, first;
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) {
            const double F = fresnelFromInside(directions.mu[j], eta);
            again.at(i, j) = r.at(i, j) * F;
            first.at(i, 0) += r.at(i, j) * (1 - F);
        }
    return solveSeries(again, first).at(straight, 0);
}

double halfSpaceAlbedo(double rho, double g) {
    rho = std::clamp(rho, 0.0, 1.0);
    const double s = std::sqrt((1 - rho) / std::max(1 - g * rho, 1e-9));
    return std::max((1 - s) * (1 - 0.139 * s) / (1 + 1.17 * s), 0.0);
}

double boundaryTransmittance(double eta) {
    constexpr int steps = 4096;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double mu = (i + 0.5) / steps;
        sum += (1 - fresnelFromInside(mu, 1 / eta)) * 2 * mu / steps;
    }
    return sum;
}

/// rho from the similarity parameter s = sqrt((1 - rho) / (1 - g rho)); the diffuse albedo is nearly linear in s.
static double albedoOf(double s, double g) { return (1 - s * s) / (1 - g * s * s); }

DiffuseAlbedoTable::DiffuseAlbedoTable(double g, double eta) : g_(g) {
    for (int i = 0; i <= tableSteps; ++i) albedos_.push_back(diffuseAlbedo(albedoOf(1 - double(i) / tableSteps, g), g, eta));
}

double DiffuseAlbedoTable::singleScattering(double diffuse) const {
    if (diffuse <= 0) return 0;
    if (diffuse >= 1) return 1;
    const auto above = std::ranges::upper_bound(albedos_, diffuse);
    const double step = static_cast<double>(above - albedos_.begin()) - (*above - diffuse) / (*above - *(above - 1));
    return albedoOf(1 - step / tableSteps, g_);
}

double DiffuseAlbedoTable::diffuse(double rho) const {
    rho = std::clamp(rho, 0.0, 1.0);
    const double place = (1 - std::sqrt((1 - rho) / (1 - g_ * rho))) * tableSteps, step = std::min(std::floor(place), tableSteps - 1.0);
    const size_t below = static_cast<size_t>(step);
    return std::lerp(albedos_[below], albedos_[below + 1], place - step);
}

}  // namespace eikonal
