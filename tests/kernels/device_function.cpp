#include "device_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <sstream>

namespace eikonal {

static std::string nameOf(const std::string& input) { return input.substr(input.rfind(' ') + 1); }
static std::string typeOf(const std::string& input) { return input.substr(0, input.rfind(' ')); }

/// The kernel. Arrays are padded to whole groups, so there is no guard in it, and straight-line code is vectorised as shipped.
static std::string kernelText(const FunctionText& text) {
    std::string source = "#include \"stages/queue.clh\"\n#include \"stages/stage.clh\"\n";
    std::istringstream files(text.include);
    for (std::string file; files >> file;) source += fmt::format("#include \"{}\"\n", file);
    source += text.declarations + "\n#define DEVICE_FUNCTION(TABLE, ARGUMENT) " + text.tables;
    for (const std::string& input : text.inputs)
        source += fmt::format(" ARGUMENT(__global const {} *, {}_array)", typeOf(input), nameOf(input));
    source += fmt::format(
        " ARGUMENT(__global {} *, results)\nSTAGE(device_function, DEVICE_FUNCTION) {{\n"
        "    FOR_EACH_SLOT_OF_GROUP(index, count) {{\n",
        text.type);
    for (const std::string& input : text.inputs) source += fmt::format("        {} = {}_array[index];\n", input, nameOf(input));
    return source + fmt::format("        {} result;\n        {}\n        results[index] = result;\n    }}\n}}\n", text.type, text.body);
}

DeviceFunctionBase::DeviceFunctionBase(FunctionText text) : text_(std::move(text)) {
    BuildSettings settings = shippedSettings(text_.features, text_.constants);
    settings.mathFlags = text_.mathFlags;
    kernel_ = Kernel(testCompiler().build(kernelText(text_), "device_function", settings));
}

void DeviceFunctionBase::run(const DeviceScene* scene, const std::vector<Array>& inputs, size_t count, void* result,
                             size_t resultWords) const {
    if (inputs.size() != text_.inputs.size())
        throw std::invalid_argument(fmt::format("{} arrays for {} inputs", inputs.size(), text_.inputs.size()));
    const size_t padded = (std::max<size_t>(count, 1) + testGroup - 1) / testGroup * testGroup;
    std::list<Buffer> buffers;
    Bindings own;
    for (size_t k = 0; k < inputs.size(); ++k) {
        if (inputs[k].elements != count) throw std::invalid_argument("array " + text_.inputs[k] + " has another length");
        const size_t words = inputs[k].words;
        /* Beyond the end: the first element again, which is safe to compute with */
        std::vector<uint> data(padded * words);
        const uint* given = static_cast<const uint*>(inputs[k].data);
        for (size_t i = 0; i < padded; ++i) std::copy_n(given + (i < count ? i : 0) * words, words, data.data() + i * words);
        buffers.push_back(Buffer::of<uint>(testContext(), data, text_.inputs[k]));
        own.set(nameOf(text_.inputs[k]) + "_array", buffers.back());
    }
    buffers.emplace_back(testContext(), padded * resultWords * sizeof(uint), "results");
    own.set("results", buffers.back());
    own.set("count", static_cast<cl_uint>(padded));
    for (const char* name : {"capacity", "path_capacity"}) own.set(name, 0u);
    const Bindings nothing;
    kernel_.launch(testContext(), {scene ? &scene->bindings() : &nothing, &own}, padded, testGroup);
    testCompiler().keep(kernel_.program());
    if (count > 0) buffers.back().read(testContext(), result, count * resultWords * sizeof(uint));
}

}  // namespace eikonal
