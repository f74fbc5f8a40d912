#pragma once
// Calling one device function: a tiny kernel around an expression runs it over arrays, so what is tested is the shipped
// text, on the shipped compiler, with the shipped options.
//
//     DeviceFunction<float> pdf({.include = "bsdf/diffuse.clh", .type = "float", .body = "result = pdf_diffuse(b, wo, wi);",
//                                .inputs = {"diffuse_item b", "vec3 wo", "vec3 wi"}});
//     std::vector<float> values = pdf(parameters, wos, wis);

#include "test_device.h"

#include "pack/tables.h"
#include "render/device_scene.h"

#include <stdexcept>
#include <vector>

namespace eikonal {

/// What the kernel is made of.
struct FunctionText {
    std::string include;                  ///< files of kernels/, separated by spaces
    std::string type;                     ///< of `result`: a type of the contract headers, or one that `declarations` makes
    std::string body;                     ///< statements that set `result` from the inputs
    std::vector<std::string> inputs;      ///< "vec3 wo": type and name of each array
    std::string declarations = {};        ///< structs and functions before the kernel
    std::string tables =
        {};  ///< "LIGHT_TABLES(TABLE)": scene tables, and other arguments, as a stage lists them (kernels/stages/stage.clh)
    /// All but the environment guide, whose tables scenes of tests have not.
    Features features = Features::all().without(Feature::ENVIRONMENT_GUIDE);
    SceneConstants constants = {.environments = 1};
    std::string mathFlags = shippedMathFlags;
};

/// Arrays of 32-bit words to and from the kernel; elements are structs of such words.
class DeviceFunctionBase {
public:
    explicit DeviceFunctionBase(FunctionText text);

protected:
    struct Array { const void* data; size_t elements, words; };
    /// Runs over `count` elements. An input whose words are 0 in number is refused.
    void run(const DeviceScene* scene, const std::vector<Array>& inputs, size_t count, void* result, size_t resultWords) const;

private:
    FunctionText text_;
    Kernel kernel_;
};

/// Elements whose number of words is only known at run time: parameters of a BSDF.
struct WordArray {
    size_t words = 0;          ///< of an element
    std::vector<uint> data;    ///< one element after the other
};

template <class Result> class DeviceFunction : DeviceFunctionBase {
public:
    using DeviceFunctionBase::DeviceFunctionBase;

    /// result[i] for every i. Inputs are vectors of structs of words, or WordArrays, all of the same length.
    template <class... T> std::vector<Result> operator()(const T&... inputs) const { return call(nullptr, inputs...); }
    /// The same with the tables of a scene.
    template <class... T> std::vector<Result> with(const DeviceScene& scene, const T&... inputs) const { return call(&scene, inputs...); }

private:
    template <class... T> std::vector<Result> call(const DeviceScene* scene, const T&... inputs) const {
        const std::vector<Array> arrays{arrayOf(inputs)...};
        std::vector<Result> results(arrays.at(0).elements);
        run(scene, arrays, results.size(), results.data(), sizeof(Result) / sizeof(uint));
        return results;
    }
    template <class T> static Array arrayOf(const std::vector<T>& v) {
        static_assert(sizeof(T) % sizeof(uint) == 0);
        return {v.data(), v.size(), sizeof(T) / sizeof(uint)};
    }
    static Array arrayOf(const WordArray& a) { return {a.data.data(), a.data.size() / a.words, a.words}; }
};

}  // namespace eikonal
