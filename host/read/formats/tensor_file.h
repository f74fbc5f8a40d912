#pragma once
// Files of named arrays ("tensor_file", version 1.0): the container of the RGL material database.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace eikonal {

struct Tensor {
    enum class Type : std::uint8_t { uint8 = 1, int8, uint16, int16, uint32, int32, uint64, int64, float16, float32, float64 };
    Type type = Type::uint8;
    std::vector<std::uint64_t> shape;   ///< outermost first
    std::vector<char> bytes;
    size_t count() const;
    /// The values, which must be of type float32.
    std::vector<float> floats() const;
};

/// The arrays of a file by name. Throws ReadProblem with the problem and its place.
std::map<std::string, Tensor> readTensorFile(const std::string& path);

}  // namespace eikonal
