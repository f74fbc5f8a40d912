#include "color/curve.h"

#include "color/observer.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>

namespace eikonal {
namespace {

// host/color/tables/*.csv: a line of names, then lines of a wavelength in nm and a value for each name.
constexpr const char* tables[] = {
#include "spectrum_tables.inc"
};

/// Removes and returns the front of `text` up to `separator`, which is removed, too; all of `text` if there is none.
std::string_view takeUntil(std::string_view& text, char separator) {
    const size_t end = std::min(text.find(separator), text.size());
    const std::string_view taken = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return taken;
}

double toNumber(std::string_view text) {
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// Extends a measurement to the whole visible range.
void extend(SampledCurve& curve) {
    if (curve.wavelengths.front() > shortestWavelength) {
        curve.wavelengths.insert(curve.wavelengths.begin(), shortestWavelength - 1);
        curve.values.insert(curve.values.begin(), curve.values.front());
    }
    if (curve.wavelengths.back() < longestWavelength) {
        curve.wavelengths.push_back(longestWavelength + 1);
        curve.values.push_back(curve.values.back());
    }
}

void normalizePhotopically(SampledCurve& curve, const SampledCurve& luminosity) {
    double integral = 0, ofOne = 0;
    for (int nm = shortestWavelength; nm <= longestWavelength; ++nm) {
        integral += luminosity(nm) * curve(nm);
        ofOne += luminosity(nm);
    }
    for (double& value : curve.values) value *= ofOne / integral;
}

using Curves = std::map<std::string, std::shared_ptr<const SampledCurve>>;

Curves readTables() {
    std::map<std::string, SampledCurve> curves;
    for (std::string_view text : tables) {
        std::string_view header = takeUntil(text, '\n');
        takeUntil(header, ',');
        std::vector<SampledCurve*> columns;
        while (!header.empty()) columns.push_back(&curves[std::string(takeUntil(header, ','))]);
        while (!text.empty()) {
            std::string_view line = takeUntil(text, '\n');
            const double wavelength = toNumber(takeUntil(line, ','));
            for (SampledCurve* column : columns) {
                column->wavelengths.push_back(wavelength);
                column->values.push_back(toNumber(takeUntil(line, ',')));
            }
        }
    }
    for (auto& [name, curve] : curves) extend(curve);
    for (auto& [name, curve] : curves)
        if (name.starts_with("stdillum-") || name.starts_with("illum-")) normalizePhotopically(curve, curves.at("cie1931-Y"));

    Curves shared;
    for (auto& [name, curve] : curves) shared[name] = std::make_shared<const SampledCurve>(std::move(curve));
    return shared;
}

const Curves& allCurves() {
    static const Curves curves = readTables();
    return curves;
}

}  // namespace

double SampledCurve::operator()(double wavelength) const {
    if (wavelengths.size() < 2 || !(wavelength >= wavelengths.front() && wavelength <= wavelengths.back())) return 0;
    const auto above = std::upper_bound(wavelengths.begin(), wavelengths.end(), wavelength);
    if (above == wavelengths.end()) return values.back();
    const size_t i = above - wavelengths.begin();
    const double t = (wavelength - wavelengths[i - 1]) / (wavelengths[i] - wavelengths[i - 1]);
    return (1 - t) * values[i - 1] + t * values[i];
}

std::shared_ptr<const SampledCurve> namedSpectrum(const std::string& name) {
    const auto found = allCurves().find(name);
    return found == allCurves().end() ? nullptr : found->second;
}

std::vector<std::string> spectrumNames() {
    std::vector<std::string> names;
    for (const auto& [name, curve] : allCurves()) names.push_back(name);
    return names;
}

}  // namespace eikonal
