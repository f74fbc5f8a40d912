#pragma once
// The header of a PLY file: its elements, and the properties of each.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace eikonal::ply {

enum class Format { ascii, littleEndian, bigEndian };
enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct TypeName { std::string_view name, sizedName; Type type; std::size_t size; };
inline constexpr std::array<TypeName, 8> typeNames{{{"char", "int8", Type::int8, 1}, {"uchar", "uint8", Type::uint8, 1},
    {"short", "int16", Type::int16, 2}, {"ushort", "uint16", Type::uint16, 2}, {"int", "int32", Type::int32, 4},
    {"uint", "uint32", Type::uint32, 4}, {"float", "float32", Type::float32, 4}, {"double", "float64", Type::float64, 8}}};

struct Property { std::string name; Type type{}; bool isList = false; Type countType{}; };
struct Element { std::string name; std::size_t count = 0; std::vector<Property> properties; };

struct Header {
    Format format = Format::ascii;
    std::vector<Element> elements;
    std::size_t size = 0;  ///< size of the header in bytes
    int skippedLine = 0;   ///< a line of unknown meaning before the first element; 0: none. Blender 2.4 left out the word "comment"

    std::string elementNames() const {
        std::string names;
        for (const Element& element : elements) names += (names.empty() ? "" : ", ") + element.name;
        return names.empty() ? "none" : names;
    }
};

/// Throws ReadProblem if the file does not begin with a valid header.
Header parseHeader(std::string_view text);

}  // namespace eikonal::ply
