#include "read/formats/tensor_file.h"

#include "read/formats/read_bytes.h"

#include <fmt/format.h>

#include <cstring>
#include <limits>

namespace eikonal {
namespace {

constexpr size_t bytesOfType[] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};

/// Reads little-endian numbers in sequence.
class Reader {
public:
    explicit Reader(const std::vector<char>& bytes) : bytes_(bytes) {}

    template <class T> T number(const char* what) {
        const char* const start = take(sizeof(T), what);
        std::uint64_t value = 0;
        for (size_t i = 0; i < sizeof(T); ++i) value |= static_cast<std::uint64_t>(static_cast<unsigned char>(start[i])) << (8 * i);
        return static_cast<T>(value);
    }
    std::string text(size_t length, const char* what) {
        const char* start = take(length, what);
        return {start, length};
    }

private:
    const char* take(size_t length, const char* what) {
        if (length > bytes_.size() - at_) throw ReadProblem(fmt::format("ends at byte {}, within {}", bytes_.size(), what));
        at_ += length;
        return bytes_.data() + at_ - length;
    }
    const std::vector<char>& bytes_;
    size_t at_ = 0;
};

}  // namespace

size_t Tensor::count() const {
    size_t n = 1;
    for (const std::uint64_t side : shape) n *= side;
    return n;
}

std::vector<float> Tensor::floats() const {
    std::vector<float> values(bytes.size() / sizeof(float));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
    return values;
}

std::map<std::string, Tensor> readTensorFile(const std::string& path) {
    const std::vector<char> bytes = readBytes(path);
    Reader reader(bytes);
    if (bytes.size() < 12 || std::memcmp(bytes.data(), "tensor_file", 12) != 0) throw ReadProblem("is not a tensor file (it does not begin with \"tensor_file\")");
    reader.text(12, "its first word");
    const int major = reader.number<std::uint8_t>("its version"), minor = reader.number<std::uint8_t>("its version");
    if (major != 1 || minor != 0) throw ReadProblem(fmt::format("has version {}.{} of the tensor format; only 1.0 can be read", major, minor));

    std::map<std::string, Tensor> tensors;
    const std::uint32_t count = reader.number<std::uint32_t>("the number of its arrays");
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::string name = reader.text(reader.number<std::uint16_t>("a name's length"), "a name");
        const size_t dimensions = reader.number<std::uint16_t>("a number of dimensions");
        const int type = reader.number<std::uint8_t>("a type");
        const std::uint64_t offset = reader.number<std::uint64_t>("an offset");
        if (type < 1 || type > 11) throw ReadProblem(fmt::format("has the array \"{}\" of the unknown type {}", name, type));

        Tensor tensor;
        tensor.type = static_cast<Tensor::Type>(type);
        std::uint64_t size = bytesOfType[type];
        for (size_t d = 0; d < dimensions; ++d) {
            tensor.shape.push_back(reader.number<std::uint64_t>("a shape"));
            const std::uint64_t side = tensor.shape.back();
            size = side && size > std::numeric_limits<std::uint64_t>::max() / side ? std::numeric_limits<std::uint64_t>::max() : size * side;
        }
        if (offset > bytes.size() || size > bytes.size() - offset)
            throw ReadProblem(fmt::format("is cut short: the array \"{}\" has {} bytes from byte {}, the file has {}", name, size, offset, bytes.size()));
        tensor.bytes.assign(bytes.begin() + static_cast<std::ptrdiff_t>(offset), bytes.begin() + static_cast<std::ptrdiff_t>(offset + size));
        if (!tensors.emplace(name, std::move(tensor)).second) throw ReadProblem(fmt::format("has two arrays called \"{}\"", name));
    }
    return tensors;
}

}  // namespace eikonal
