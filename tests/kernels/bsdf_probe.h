#pragma once
// Every BSDF of the list BSDFS behind one call: parameters, a sample, and evaluations at it and elsewhere.

#include "device_function.h"
#include "eikonal/bsdfs.h"
#include "random_inputs.h"

#include <functional>
#include <ostream>
#include <string>

namespace eikonal {

/// One parameter of a BSDF, from its list: as many words as it has in RGB, or at wavelengths.
struct BsdfParameter { std::string type, name; size_t words; };
struct BsdfKind { std::string name; bool spectral; std::vector<BsdfParameter> parameters; };
inline void PrintTo(const BsdfKind& kind, std::ostream* out) { *out << kind.name << (kind.spectral ? "_spectral" : ""); }
/// All of BSDFS whose file exists, in RGB and at wavelengths.
std::vector<BsdfKind> bsdfKinds();

/// How parameters are drawn: within the range in which densities can be integrated on a grid, or at and beyond the ends of what
/// scenes may hold.
enum class Range { smooth, extreme };
/// One set of parameters. A parameter of an unknown name is a number in [0, 1].
std::vector<uint> drawParameters(const BsdfKind& kind, Range range, Random& random);

/// One set of parameters, all words of each with the same value.
std::vector<uint> parametersOf(const BsdfKind& kind, const std::function<float(const BsdfParameter&)>& valueOf);
/// Widths of microfacets and indices of refraction of the table of BSDFs (bsdf_table_test.cpp).
inline const std::vector<float> tableWidths = {.01f, .1f, .2f, .3f, .6f, 1}, tableIndices = {1.1f, 1.5f, 2.5f, 1 / 1.5f};

/// What the device computes for one set of parameters, wo, (lobe, u) and another direction. Of four wavelengths, the first, second and
/// last.
struct BsdfResult {
    vec3 wi; spectrum weight; float pdf; int isDelta; float eta;   ///< sample_x
    spectrum f, fBack; float pdfHere;                              ///< eval_x(wo, wi), eval_x(wi, wo), pdf_x(wo, wi) at that wi
    spectrum fGiven; float pdfGiven;                               ///< eval_x and pdf_x at (wo, given)
    int kindIsDelta, isRandom, isOneWay;                           ///< x_is_delta, x_is_random, x_is_one_way
    float split;                                                   ///< split_x of a delta distribution
};

struct BsdfInputs {
    WordArray parameters;
    std::vector<vec3> wo;
    std::vector<float> lobe;
    std::vector<vec2> u;
    std::vector<vec3> given;
    size_t size() const { return wo.size(); }
    void add(const std::vector<uint>& b, vec3 w, vec3 elsewhere, Random& random);
};

class BsdfProbe {
public:
    explicit BsdfProbe(const BsdfKind& kind);
    std::vector<BsdfResult> operator()(const BsdfInputs& in) const;

private:
    DeviceFunction<BsdfResult> function_;
    BsdfKind kind_;
};

/// Words as text, for messages.
std::string describeParameters(const BsdfKind& kind, const std::vector<uint>& words);

}  // namespace eikonal
