#pragma once
// A small file in the format of the RGL material database, of a surface that is known: GGX facets of width alpha that reflect a given part
// of the light, whatever its direction.

#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace eikonal {

struct MeasuredFile {
    double alpha = 0.5;
    bool isotropic = true;  ///< otherwise for azimuths all around, though the surface has no grain
    std::function<double(double)> reflectance = [](double) { return 0.5; };  ///< of the wavelength in nm
    std::function<double(double, double)> brightness = [](double x, double y) {
        return 1 + x * (1 - y);
    };  ///< how light is sampled: matters to noise only

    struct Array { int type; std::vector<std::uint64_t> shape; std::string bytes; };
    static constexpr int byteType = 1, floatType = 10;

    /// The arrays of the file, to be written or spoilt.
    std::map<std::string, Array> arrays() const {
        constexpr int facets = 32, thetas = 7, color = 5;
        const int phis = isotropic ? 1 : 9;
        std::vector<float> phi, theta, wavelengths, ndf, sigma, vndf, luminance, spectra;
        for (int i = 0; i < phis; ++i) phi.push_back(static_cast<float>(isotropic ? 0 : -M_PI + 2 * M_PI * i / (phis - 1)));
        for (int i = 0; i < thetas; ++i) theta.push_back(static_cast<float>(M_PI / 2 * i / (thetas - 1)));
        for (int nm = 360; nm <= 830; nm += 47) wavelengths.push_back(static_cast<float>(nm));
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < facets; ++x) {
                ndf.push_back(static_cast<float>(density(angle(x, facets))));
                sigma.push_back(static_cast<float>(area(angle(x, facets))));
            }
        for (const float p : phi)
            for (const float t : theta) {
                for (int y = 0; y < facets; ++y)
                    for (int x = 0; x < facets; ++x) {
                        const double m = angle(x, facets), turn = 2 * M_PI * y / (facets - 1) - M_PI - p;
                        const double cosine = std::sin(m) * std::cos(turn) * std::sin(t) + std::cos(m) * std::cos(t);
                        vndf.push_back(static_cast<float>(density(m) * std::max(cosine, 0.) / area(t) * 2 * M_PI * M_PI * x / (facets - 1) *
                                                          std::sin(m)));
                    }
                for (int y = 0; y < color; ++y)
                    for (int x = 0; x < color; ++x) luminance.push_back(static_cast<float>(brightness(x / (color - 1.), y / (color - 1.))));
                for (const float nm : wavelengths) spectra.insert(spectra.end(), color * color, static_cast<float>(reflectance(nm)));
            }
        const std::string description = "GGX facets";
        const std::uint64_t p = phi.size(), t = theta.size(), w = wavelengths.size();
        return {{"phi_i", floats({p}, phi)}, {"theta_i", floats({t}, theta)}, {"wavelengths", floats({w}, wavelengths)},
                {"ndf", floats({2, facets}, ndf)}, {"sigma", floats({2, facets}, sigma)}, {"vndf", floats({p, t, facets, facets}, vndf)},
                {"luminance", floats({p, t, color, color}, luminance)}, {"spectra", floats({p, t, w, color, color}, spectra)},
                {"description", {byteType, {description.size()}, description}}, {"jacobian", {byteType, {1}, std::string(1, '\1')}}};
    }

    static Array floats(std::vector<std::uint64_t> shape, const std::vector<float>& values) {
        return {floatType, std::move(shape), {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)}};
    }

    /// The bytes of a file with these arrays.
    static std::string bytes(const std::map<std::string, Array>& arrays) {
        std::uint64_t offset = 18;
        for (const auto& [name, array] : arrays) offset += 2 + name.size() + 2 + 1 + 8 + 8 * array.shape.size();
        std::string head("tensor_file\0\1\0", 14), data;
        append(head, arrays.size(), 4);
        for (const auto& [name, array] : arrays) {
            append(head, name.size(), 2);
            head += name;
            append(head, array.shape.size(), 2);
            append(head, static_cast<std::uint64_t>(array.type), 1);
            append(head, offset + data.size(), 8);
            for (const std::uint64_t side : array.shape) append(head, side, 8);
            data += array.bytes;
        }
        return head + data;
    }

    void write(const std::string& path) const { std::ofstream(path, std::ios::binary) << bytes(arrays()); }

private:
    /// Of the facets in column x.
    static double angle(int x, int columns) { const double u = x / (columns - 1.); return u * u * M_PI / 2; }
    double density(double m) const {
        const double c = std::cos(m), s = std::sin(m), e = c * c + s * s / (alpha * alpha);
        return 1 / (M_PI * alpha * alpha * e * e);
    }
    double area(double t) const {
        const double c = std::cos(t), s = std::sin(t);
        return (c + std::sqrt(c * c + alpha * alpha * s * s)) / 2;
    }
    static void append(std::string& to, std::uint64_t value, int size) {
        for (int i = 0; i < size; ++i) to += static_cast<char>(value >> (8 * i));
    }
};

}  // namespace eikonal
