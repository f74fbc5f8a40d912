#pragma once
// Files of checked records. A file that is not whole, or not as it was written, is noticed and never trusted.

#include "film/reopened_file.h"
#include "image/atomic_file.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace eikonal {

/// Four characters that say what a record holds.
using RecordTag = std::uint32_t;
constexpr RecordTag recordTag(const char (&name)[5]) {
    RecordTag tag = 0;
    for (int i = 3; i >= 0; --i) tag = tag << 8 | static_cast<unsigned char>(name[i]);
    return tag;
}

/// Writes a record file, completely or not at all. The functions throw what AtomicFile's throw.
class RecordWriter {
public:
    /// kind: the first line of the file, at most 31 characters.
    RecordWriter(const std::string& path, const std::string& kind);
    void write(RecordTag tag, std::span<const unsigned char> content);
    template <class T> void write(RecordTag tag, std::span<const T> content) {
        write(tag, {reinterpret_cast<const unsigned char*>(content.data()), content.size_bytes()});
    }
    /// Ends the file and puts it in its place.
    void commit();

private:
    AtomicFile file_;
    std::uint64_t records_ = 0;
};

/// Reads one. The functions throw Error (ExitCode::scene), "path: what is wrong".
class RecordReader {
public:
    struct Record { RecordTag tag; std::uint64_t place, bytes; };

    /// Finds all records, and checks that the file is whole and of this kind. what: for messages, "a checkpoint of Eikonal".
    RecordReader(const std::string& path, const std::string& kind, const std::string& what);
    const std::string& path() const { return path_; }
    const std::vector<Record>& records() const { return records_; }
    /// The content of a record, whose checksum is right.
    std::vector<unsigned char> read(const Record& record) const;
    /// The content of the only record with this tag.
    std::vector<unsigned char> read(RecordTag tag) const;
    /// Bytes of a record's content, unchecked.
    void readPart(const Record& record, std::uint64_t offset, void* bytes, std::size_t count) const {
        readAt(record.place + offset, bytes, count);
    }
    /// Throws an Error about this file.
    [[noreturn]] void fail(const std::string& problem) const;

private:
    void readAt(std::uint64_t place, void* content, std::size_t bytes) const;
    std::string path_;
    ReopenedFile file_;
    std::uint64_t size_ = 0;
    std::vector<Record> records_;
};

}  // namespace eikonal
