#pragma once
// Spectra in EXR files: the layout of Fichet, Pacanowski and Wilkie 2021 ("An OpenEXR Layout for Spectral Images", JCGT 10(3)), as pbrt-v4
// writes it.

#include <optional>
#include <string>

namespace eikonal {

/// The name of the emissive channel around a wavelength (nm): "S0.374,688nm". The layout uses a comma, since a point would start a layer.
std::string bucketChannel(double wavelength);
/// The wavelength (nm) of such a channel; nothing for other names.
std::optional<double> wavelengthOfChannel(const std::string& name);

/// The attributes that the layout requires: {name, text}.
inline constexpr const char* spectralAttributes[][2] = {{"spectralLayoutVersion", "1.0"}, {"emissiveUnits", "W.m^-2.sr^-1"}};

}  // namespace eikonal
