#pragma once
// Spectra in an EXR: the layout of Fichet, Pacanowski and Wilkie 2021 ("An OpenEXR Layout for Spectral Images", JCGT 10(3)), as pbrt-v4 writes it.

#include <optional>
#include <string>

namespace eikonal {

/// The channel of emissive light around a wavelength (nm), "S0.374,688nm": a point would make it a layer of its own.
std::string bucketChannel(double wavelength);
/// The wavelength (nm) of such a channel; none if the name is another.
std::optional<double> wavelengthOfChannel(const std::string& name);

/// What the layout wants to be said with them: {name of an attribute, its text}.
inline constexpr const char* spectralAttributes[][2] = {{"spectralLayoutVersion", "1.0"}, {"emissiveUnits", "W.m^-2.sr^-1"}};

}  // namespace eikonal
