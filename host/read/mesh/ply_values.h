#pragma once
// The data of a PLY file, text or binary.

#include "read/mesh/ply_header.h"
#include "read/formats/read_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

namespace eikonal::ply {

/// Reads the values in sequence. All PLY types fit a double exactly.
class Values {
public:
    Values(std::span<const char> bytes, Format format) : at_(bytes.data()), end_(bytes.data() + bytes.size()), format_(format) {}

    double next(Type type) {
        if (format_ == Format::ascii) return nextWord();
        switch (type) {
            case Type::int8: return load<std::int8_t>();
            case Type::uint8: return load<std::uint8_t>();
            case Type::int16: return load<std::int16_t>();
            case Type::uint16: return load<std::uint16_t>();
            case Type::int32: return load<std::int32_t>();
            case Type::uint32: return load<std::uint32_t>();
            case Type::float32: return load<float>();
            default: return load<double>();
        }
    }

    /// The length of a list; refused if the rest of the file cannot hold it.
    std::size_t nextCount(const Property& list) {
        const double count = next(list.countType);
        if (!(count >= 0) || count != std::floor(count)) throw ReadProblem{fmt::format("has a list \"{}\" of length {}", list.name, count)};
        require(count, size(list.type));
        return static_cast<std::size_t>(count);
    }

    /// Throws if the rest of the file cannot hold `count` values of `bytes` bytes each.
    void require(double count, std::size_t bytes) const {
        if (count * static_cast<double>(bytes) > static_cast<double>(end_ - at_) + 1) throwTruncated();
    }

    /// The smallest size of a value of this type; in text, a digit and a space.
    std::size_t size(Type type) const { return format_ == Format::ascii ? 2 : typeNames[static_cast<std::size_t>(type)].size; }

    /// The rest of a text, without the spaces and line ends before it; empty if the data is binary.
    std::string_view unreadText() {
        if (format_ != Format::ascii) return {};
        skipSpaces();
        return {at_, end_};
    }

    /// How many bytes follow binary data; 0 if they are blank, such as a line's end, or the data is text.
    std::size_t unreadBytes() const {
        const bool isBlank = std::all_of(at_, end_, [](char c) { return isSpace(c) || c == 0; });
        return format_ == Format::ascii || isBlank ? 0 : static_cast<std::size_t>(end_ - at_);
    }

private:
    [[noreturn]] static void throwTruncated() { throw ReadProblem{"is truncated: it ends before its last element"}; }

    template <class T> double load() {
        if (static_cast<std::size_t>(end_ - at_) < sizeof(T)) throwTruncated();
        std::array<char, sizeof(T)> bytes;
        std::memcpy(bytes.data(), at_, sizeof(T));
        at_ += sizeof(T);
        if ((format_ == Format::bigEndian) != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
        return static_cast<double>(std::bit_cast<T>(bytes));
    }

    static bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    std::string word() const { return std::string(at_, std::find_if(at_, end_, isSpace)).substr(0, 20); }

    void skipSpaces() {
        while (at_ != end_ && isSpace(*at_)) ++at_;
    }

    double nextWord() {
        skipSpaces();
        if (at_ == end_) throwTruncated();
        double value = 0;
        const auto [stop, error] = std::from_chars(*at_ == '+' ? at_ + 1 : at_, end_, value);
        if (error != std::errc{} || (stop != end_ && !isSpace(*stop)))
            throw ReadProblem{fmt::format("has \"{}\" where a number is expected", word())};
        at_ = stop;
        return value;
    }

    const char *at_, *end_;
    Format format_;
};

}  // namespace eikonal::ply
