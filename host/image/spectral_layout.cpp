#include "image/spectral_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace eikonal {

static constexpr std::string_view prefix = "S0.", unit = "nm";

std::string bucketChannel(double wavelength) {
    std::string number = fmt::format("{:.3f}", wavelength);
    std::ranges::replace(number, '.', ',');
    return fmt::format("{}{}{}", prefix, number, unit);
}

std::optional<double> wavelengthOfChannel(const std::string& name) {
    if (!name.starts_with(prefix) || !name.ends_with(unit)) return {};
    std::string number = name.substr(prefix.size(), name.size() - prefix.size() - unit.size());
    std::ranges::replace(number, ',', '.');
    double wavelength = 0;
    const char* const end = number.data() + number.size();
    const auto [read, error] = std::from_chars(number.data(), end, wavelength);
    if (error != std::errc() || read != end) return {};
    return wavelength;
}

}  // namespace eikonal
