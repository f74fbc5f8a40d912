#include "device/program.h"

#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace eikonal {

constexpr const char* languageOptions = "-cl-std=CL1.2 -cl-kernel-arg-info";

static double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

static std::string buildLog(cl_program program, cl_device_id device) {
    size_t size = 0;
    if (clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, 0, nullptr, &size) != CL_SUCCESS) return {};
    std::string log(size, '\0');
    clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, size, log.data(), nullptr);
    while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) log.pop_back();
    return log;
}

static std::vector<std::string> argumentNames(cl_program program, const std::string& kernelName) {
    cl_int status = CL_SUCCESS;
    const Owned<cl_kernel, clReleaseKernel> kernel(clCreateKernel(program, kernelName.c_str(), &status));
    check(status, "creating kernel " + kernelName);
    cl_uint count = 0;
    check(clGetKernelInfo(kernel, CL_KERNEL_NUM_ARGS, sizeof count, &count, nullptr), "querying the arguments of kernel " + kernelName);
    std::vector<std::string> names;
    for (cl_uint i = 0; i < count; ++i) {
        const std::string asking = "querying the argument names of kernel " + kernelName;
        size_t size = 0;
        check(clGetKernelArgInfo(kernel, i, CL_KERNEL_ARG_NAME, 0, nullptr, &size), asking);
        std::string name(size, '\0');
        check(clGetKernelArgInfo(kernel, i, CL_KERNEL_ARG_NAME, size, name.data(), nullptr), asking);
        while (!name.empty() && name.back() == '\0') name.pop_back();
        names.push_back(std::move(name));
    }
    return names;
}

Compiler::Compiler(const Context& context, KernelFolders folders, std::string cacheFolder)
    : context_(context), files_(std::move(folders)), cache_(std::move(cacheFolder)) {}

const KernelSource& Compiler::sourceOf(const std::string& text) const {
    const auto known = sources_.find(text);
    return known != sources_.end() ? known->second : sources_.emplace(text, KernelSource(files_, text)).first->second;
}

std::string Compiler::keyOf(const KernelSource& source, const std::string& options, const std::string& kernel) const {
    const DeviceInfo& d = context_.device();
    return fmt::format("{}\n{:016x}\n{}\n{}\n{}\n{}\n{}", kernel, hashBytes(source.text()), options, d.platformName, d.name, d.version,
                       d.driver);
}

std::shared_ptr<Program> Compiler::loadCached(const std::string& key, const std::string& kernel) const {
    const auto cached = cache_.load(key);
    if (!cached) return nullptr;
    cl_int status = CL_SUCCESS, binaryStatus = CL_SUCCESS;
    const size_t size = cached->binary.size();
    const unsigned char* bytes = cached->binary.data();
    auto program = std::make_shared<Program>();
    const cl_device_id device = context_.device().id;
    program->handle =
        decltype(program->handle)(clCreateProgramWithBinary(context_.handle(), 1, &device, &size, &bytes, &binaryStatus, &status));
    if (status != CL_SUCCESS || binaryStatus != CL_SUCCESS) return nullptr;
    if (clBuildProgram(program->handle, 1, &device, "", nullptr, nullptr) != CL_SUCCESS) return nullptr;
    program->kernel = kernel;
    program->arguments = cached->arguments;
    program->fromCache = true;
    program->compileSeconds = cached->seconds;
    return program;
}

static void dumpProgram(const std::string& folder, const std::string& name, const std::string& text, const std::string& options) {
    const std::filesystem::path path = std::filesystem::path(folder) / (name + ".cl");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream file(path, std::ios::binary);
    file << "/* options: " << options << " */\n" << text;
    file.close();
    if (!file)
        throw Error(ExitCode::scene,
                    fmt::format("cannot write {} for --dump-kernels: {}", path.string(), error ? error.message() : std::strerror(errno)));
}

static std::string optionsFor(const KernelSource& source, const BuildSettings& settings) {
    std::string options = languageOptions;
    for (const std::string& more : {settings.mathFlags, settings.more})
        if (!more.empty()) options += " " + more;
    return fmt::format("{}{}{} -DPOISON_ITEMS={}", options, settings.warningsAreErrors ? " -Werror" : "",
                       settings.contraction ? "" : " -DNO_CONTRACTION=1", settings.poison ? 1 : 0) +
           source.options(settings.features, settings.constants);
}

bool Compiler::isKept(const std::string& text, const std::string& kernel, const BuildSettings& settings) const {
    const KernelSource& source = sourceOf(text);
    const std::string key = keyOf(source, optionsFor(source, settings), kernel);
    return built_.contains(key) || cache_.load(key).has_value();
}

std::shared_ptr<Program> Compiler::build(const std::string& text, const std::string& kernel, const BuildSettings& settings) {
    const auto start = std::chrono::steady_clock::now();
    const KernelSource& source = sourceOf(text);
    const std::string options = optionsFor(source, settings);
    const std::string key = keyOf(source, options, kernel);
    if (!settings.dumpFolder.empty())
        dumpProgram(settings.dumpFolder, fmt::format("{}-{:08x}", kernel, static_cast<std::uint32_t>(hashBytes(key))), source.text(),
                    options);

    if (const auto before = built_.find(key); before != built_.end()) {
        Program& known = *before->second;
        if (!known.fromCache) known.compileSeconds = known.seconds;
        known.fromCache = true;
        known.seconds = secondsSince(start);
        return before->second;
    }
    std::shared_ptr<Program> program = loadCached(key, kernel);
    if (!program) {
        cl_int status = CL_SUCCESS;
        const char* characters = source.text().c_str();
        program = std::make_shared<Program>();
        program->handle = decltype(program->handle)(clCreateProgramWithSource(context_.handle(), 1, &characters, nullptr, &status));
        check(status, "creating the program of " + kernel);
        const cl_device_id device = context_.device().id;
        status = clBuildProgram(program->handle, 1, &device, options.c_str(), nullptr, nullptr);
        if (status != CL_SUCCESS)
            throw DeviceError(fmt::format("the kernel {} of {} does not build for \"{}\": {}\n{}\noptions: {}", kernel, folders().kernels,
                                          context_.device().name, statusName(status), buildLog(program->handle, device), options));
        program->kernel = kernel;
        program->arguments = argumentNames(program->handle, kernel);
        program->cacheKey = key;
    }
    program->seconds = secondsSince(start);
    built_.emplace(key, program);
    return program;
}

static std::vector<unsigned char> binaryOf(cl_program program) {
    size_t size = 0;
    if (clGetProgramInfo(program, CL_PROGRAM_BINARY_SIZES, sizeof size, &size, nullptr) != CL_SUCCESS || size == 0) return {};
    std::vector<unsigned char> bytes(size);
    unsigned char* data = bytes.data();
    if (clGetProgramInfo(program, CL_PROGRAM_BINARIES, sizeof data, &data, nullptr) != CL_SUCCESS) return {};
    return bytes;
}

void Compiler::keep(const Program& program, double firstLaunchSeconds) const {
    if (program.fromCache || cache_.folder().empty()) return;
    const std::vector<unsigned char> binary = binaryOf(program.handle);
    if (!binary.empty()) cache_.store(program.cacheKey, {binary, program.arguments, program.seconds + firstLaunchSeconds});
}

}  // namespace eikonal
