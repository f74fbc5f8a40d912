#include "read/formats/measured_bsdf.h"

#include "read/formats/read_bytes.h"
#include "read/formats/tensor_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

/// The arrays of a file, with checks.
class Arrays {
public:
    explicit Arrays(const std::string& path) : tensors_(readTensorFile(path)) {}

    /// An expected side of 0 matches any length.
    const Tensor& get(const std::string& name, Tensor::Type type, const std::vector<std::uint64_t>& shape) const {
        const auto found = tensors_.find(name);
        if (found == tensors_.end()) throw ReadProblem("has no array \"" + name + "\", which measured BSDFs need");
        const Tensor& tensor = found->second;
        bool fits = tensor.type == type && tensor.shape.size() == shape.size();
        for (size_t d = 0; fits && d < shape.size(); ++d) fits = shape[d] ? tensor.shape[d] == shape[d] : tensor.shape[d] > 0;
        if (!fits)
            throw ReadProblem(fmt::format("has the array \"{}\" of shape {}{}; {} is expected (0: any)", name, tensor.shape,
                                          tensor.type == type ? "" : " and another type", shape));
        return tensor;
    }

    std::vector<float> list(const std::string& name) const {
        const std::vector<float> values = get(name, Tensor::Type::float32, {0}).floats();
        requireFinite(name, values);
        if (std::ranges::adjacent_find(values, std::greater_equal<>()) != values.end()) throw ReadProblem("has the list \"" + name + "\", which is not ascending");
        return values;
    }

    /// The last two dimensions are those of the grid; values may be negative only with `mayBeNegative`.
    MeasuredBsdf::Grid grid(const std::string& name, const std::vector<std::uint64_t>& shape, bool mayBeNegative = false) const {
        const Tensor& tensor = get(name, Tensor::Type::float32, shape);
        MeasuredBsdf::Grid grid{tensor.shape[shape.size() - 1], tensor.shape[shape.size() - 2], tensor.floats()};
        if (grid.width < 2 || grid.height < 2) throw ReadProblem(fmt::format("has the grid \"{}\" of {} x {} values; at least 2 x 2 are needed", name, grid.width, grid.height));
        requireFinite(name, grid.values);
        if (!mayBeNegative && std::ranges::any_of(grid.values, [](float v) { return v < 0; })) throw ReadProblem("has values below zero in \"" + name + "\"");
        return grid;
    }

private:
    static void requireFinite(const std::string& name, const std::vector<float>& values) {
        if (!std::ranges::all_of(values, [](float v) { return std::isfinite(v); })) throw ReadProblem("has values in \"" + name + "\" that are not finite");
    }
    std::map<std::string, Tensor> tensors_;
};

/// Checks that each of the grids can be sampled.
void requirePositive(const std::string& name, const MeasuredBsdf::Grid& grids) {
    const auto size = static_cast<std::ptrdiff_t>(grids.width * grids.height);
    for (auto grid = grids.values.begin(); grid != grids.values.end(); grid += size)
        if (std::all_of(grid, grid + size, [](float v) { return v == 0; })) throw ReadProblem("has a grid of zeros in \"" + name + "\", from which nothing can be sampled");
}

}  // namespace

std::shared_ptr<const MeasuredBsdf> readMeasuredBsdf(const std::string& path) {
    const Arrays arrays(path);
    auto bsdf = std::make_shared<MeasuredBsdf>();
    bsdf->phi = arrays.list("phi_i");
    bsdf->theta = arrays.list("theta_i");
    bsdf->wavelengths = arrays.list("wavelengths");
    const std::uint64_t phis = bsdf->phi.size(), thetas = bsdf->theta.size(), wavelengths = bsdf->wavelengths.size();
    bsdf->facets = arrays.grid("ndf", {0, 0});
    bsdf->area = arrays.grid("sigma", {0, 0});
    bsdf->visible = arrays.grid("vndf", {phis, thetas, 0, 0});
    bsdf->brightness = arrays.grid("luminance", {phis, thetas, 0, 0});
    bsdf->spectra = arrays.grid("spectra", {phis, thetas, wavelengths, bsdf->brightness.height, bsdf->brightness.width}, true);
    requirePositive("vndf", bsdf->visible);
    requirePositive("luminance", bsdf->brightness);
    if (!bsdf->isIsotropic()) {
        const double turns = 2 * M_PI / (bsdf->phi.back() - bsdf->phi.front());
        if (std::lround(turns) != 1)
            throw ReadProblem(fmt::format("was measured over 1/{} of a turn only; such symmetric files cannot be read, only isotropic ones and those of a whole turn", std::lround(turns)));
    }
    return bsdf;
}

}  // namespace eikonal
