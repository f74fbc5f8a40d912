// Measured BSDFs as the device reads them: densities with their integrals, and spectra as colours.

#include "pack/measured.h"

#include "read/formats/measured_bsdf.h"
#include "read/formats/read_bytes.h"

#include <algorithm>
#include <bit>

namespace eikonal {
namespace {

/// The number of bisection steps that search so many sorted numbers.
int searchSteps(size_t count) { return static_cast<int>(std::bit_width(std::max<size_t>(count, 2) - 2)); }

class Writer {
public:
    explicit Writer(Table<float>& values) : values_(values) {}

    uint list(const std::vector<float>& numbers) {
        const uint first = static_cast<uint>(values_.size());
        values_.insert(values_.end(), numbers.begin(), numbers.end());
        return first;
    }

    measured_grid grid(const MeasuredBsdf::Grid& g) { return {list(g.values), static_cast<uint>(g.width), static_cast<uint>(g.height)}; }

    /// Grids scaled to an integral of 1 over cells of side 1, with their marginal and conditional cumulative distributions.
    measured_warp warp(const MeasuredBsdf::Grid& g) {
        MeasuredBsdf::Grid density = g;
        std::vector<float> marginal, conditional;
        const size_t size = g.width * g.height;
        for (size_t first = 0; first < g.values.size(); first += size) {
            const float* const v = g.values.data() + first;
            std::vector<double> rows(size), upTo(g.height);
            for (size_t y = 0; y < g.height; ++y)
                for (size_t x = 1; x < g.width; ++x)
                    rows[y * g.width + x] = rows[y * g.width + x - 1] + 0.5 * (double(v[y * g.width + x - 1]) + double(v[y * g.width + x]));
            for (size_t y = 1; y < g.height; ++y) upTo[y] = upTo[y - 1] + 0.5 * (rows[y * g.width - 1] + rows[(y + 1) * g.width - 1]);
            const double total = upTo.back();
            for (const double sum : rows) conditional.push_back(static_cast<float>(sum / total));
            for (const double sum : upTo) marginal.push_back(static_cast<float>(sum / total));
            for (size_t i = 0; i < size; ++i) density.values[first + i] = static_cast<float>(v[i] / total);
        }
        const measured_grid packed = grid(density);
        return {packed, list(marginal), list(conditional)};
    }

    measured_grid color(const MeasuredBsdf& b) {
        const std::vector<glm::dvec3> weights = colorWeights(b.wavelengths);
        const size_t size = b.spectra.width * b.spectra.height, n = b.wavelengths.size();
        MeasuredBsdf::Grid colors{b.spectra.width, b.spectra.height, {}};
        for (size_t first = 0; first < b.spectra.values.size(); first += n * size)
            for (int channel = 0; channel < 3; ++channel)
                for (size_t i = 0; i < size; ++i) {
                    double sum = 0;
                    for (size_t w = 0; w < n; ++w)
                        sum += weights[w][channel] * std::max(double(b.spectra.values[first + w * size + i]), 0.);
                    colors.values.push_back(static_cast<float>(sum));
                }
        return grid(colors);
    }

private:
    /// The weight of the reflectance at each wavelength in linear sRGB under daylight;
    /// linear between wavelengths, constant beyond the ends.
    static std::vector<glm::dvec3> colorWeights(const std::vector<float>& wavelengths) {
        const DenseCurve& daylight = whiteSpectrum(ColorSpace::srgb);
        const double brightness = integrateXyz(daylight).y;
        std::vector<glm::dvec3> weights;
        for (size_t w = 0; w < wavelengths.size(); ++w) {
            DenseCurve hat{};
            for (int i = 0; i < wavelengthCount; ++i) {
                const double x = std::clamp(double(shortestWavelength + i), double(wavelengths.front()), double(wavelengths.back())),
                             here = wavelengths[w];
                double value = x == here;
                if (w > 0 && x > wavelengths[w - 1] && x < here) value = (x - wavelengths[w - 1]) / (here - wavelengths[w - 1]);
                if (w + 1 < wavelengths.size() && x > here && x < wavelengths[w + 1])
                    value = (wavelengths[w + 1] - x) / (wavelengths[w + 1] - here);
                hat[static_cast<size_t>(i)] = value * daylight[static_cast<size_t>(i)];
            }
            weights.push_back(rgbFromXyz(ColorSpace::srgb) * integrateXyz(hat) / brightness);
        }
        return weights;
    }

    Table<float>& values_;
};

void raise(int& most, size_t count) { most = std::max(most, searchSteps(count)); }

/// Raises the constants of the kernels that search this file.
void noteSizes(SceneConstants& constants, const MeasuredBsdf& bsdf) {
    raise(constants.measuredAngleSteps, std::max(bsdf.phi.size(), bsdf.theta.size()));
    raise(constants.measuredFacetSteps, std::max(bsdf.visible.width, bsdf.visible.height));
    raise(constants.measuredBrightnessSteps, std::max(bsdf.brightness.width, bsdf.brightness.height));
}

}  // namespace

uint MeasuredPacker::file(const std::string& path, const SourceLocation& where) {
    if (context_.spectral) colors_.addUplift();
    const auto [found, isNew] = files_.try_emplace(path, NONE);
    if (!isNew) return found->second;
    std::shared_ptr<const MeasuredBsdf> bsdf;
    try {
        bsdf = readMeasuredBsdf(path);
    } catch (const ReadProblem& problem) {
        throw SceneError(where, "\"" + path + "\" " + problem.what());
    }
    Writer writer(tables_.measured_values);
    measured m{};
    m.phi_count = static_cast<uint>(bsdf->phi.size());
    m.theta_count = static_cast<uint>(bsdf->theta.size());
    m.phis = writer.list(bsdf->phi);
    m.thetas = writer.list(bsdf->theta);
    m.isotropic = bsdf->isIsotropic();
    m.facets = writer.grid(bsdf->facets);
    m.area = writer.grid(bsdf->area);
    m.visible = writer.warp(bsdf->visible);
    m.brightness = writer.warp(bsdf->brightness);
    m.color = writer.color(*bsdf);
    tables_.measured_files.push_back(m);
    if (bsdf->phi.size() > 1) context_.require(Feature::GRAIN, "measured BSDF \"" + path + "\"");
    constants_.measuredFiles = static_cast<int>(tables_.measured_files.size());
    noteSizes(constants_, *bsdf);
    return found->second = static_cast<uint>(tables_.measured_files.size() - 1);
}

}  // namespace eikonal
