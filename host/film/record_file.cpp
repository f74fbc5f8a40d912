#include "film/record_file.h"

#include "error.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace eikonal {
namespace {

constexpr std::size_t kindBytes = 32;
constexpr RecordTag last = recordTag("LAST");

/// What precedes the content of a record. All numbers have the byte order of the machine; `check` also notices another one.
struct Head {
    RecordTag tag;
    std::uint32_t contentCheck;
    std::uint64_t bytes;
    std::uint32_t check;      ///< of the fields above
    std::uint32_t unused = 0;
};
constexpr std::size_t checkedBytes = offsetof(Head, check);

std::uint32_t checksum(const void* data, std::size_t bytes) {
    return static_cast<std::uint32_t>(::crc32_z(0, static_cast<const unsigned char*>(data), bytes));
}

std::string padded(const std::string& kind) {
    std::string line = kind;
    line.resize(kindBytes - 1);
    return line + "\n";
}

}  // namespace

RecordWriter::RecordWriter(const std::string& path, const std::string& kind) : file_(path) {
    const std::string line = padded(kind);
    file_.write({reinterpret_cast<const unsigned char*>(line.data()), line.size()});
}

void RecordWriter::write(RecordTag tag, std::span<const unsigned char> content) {
    Head head{tag, checksum(content.data(), content.size()), content.size(), 0, 0};
    head.check = checksum(&head, checkedBytes);
    file_.write({reinterpret_cast<const unsigned char*>(&head), sizeof head});
    file_.write(content);
    ++records_;
}

void RecordWriter::commit() {
    const std::uint64_t count[] = {records_};
    write(last, std::span<const std::uint64_t>(count));
    file_.commit();
}

RecordReader::RecordReader(const std::string& path, const std::string& kind, const std::string& what)
    : path_(path), file_(path) {
    if (!file_.isOpen()) fail(fmt::format("cannot be opened: {}", std::strerror(errno)));
    if (!S_ISREG(file_.status().st_mode)) fail(fmt::format("is not {}: it is not a regular file", what));
    size_ = static_cast<std::uint64_t>(file_.status().st_size);
    const std::string expected = padded(kind);
    std::string line(std::min<std::uint64_t>(size_, kindBytes), 0);
    readAt(0, line.data(), line.size());
    const std::size_t name = kind.find_last_of(' ');   // its version follows
    if (line != expected.substr(0, line.size()) && line.compare(0, name, kind, 0, name) == 0)
        fail(fmt::format("is \"{}\", and this program reads \"{}\"", line.substr(0, line.find('\0')), kind));
    if (line.empty() || line != expected.substr(0, line.size())) fail(fmt::format("is not {}", what));

    std::uint64_t place = kindBytes;
    for (;;) {
        Head head{};
        if (place + sizeof head > size_) fail(fmt::format("is truncated: its {} bytes end within a record", size_));
        readAt(place, &head, sizeof head);
        if (head.check != checksum(&head, checkedBytes)) fail(fmt::format("is damaged at byte {}", place));
        place += sizeof head;
        if (head.bytes > size_ - place) fail(fmt::format("is truncated: its {} bytes end within a record", size_));
        records_.push_back({head.tag, place, head.bytes});
        place += head.bytes;
        if (head.tag == last) break;
    }
    if (place != size_) fail(fmt::format("is damaged: {} bytes follow its end", size_ - place));
    std::uint64_t count = 0;
    const std::vector<unsigned char> content = read(last);
    if (content.size() == sizeof count) std::memcpy(&count, content.data(), sizeof count);
    records_.pop_back();
    if (count != records_.size()) fail(fmt::format("is damaged: it has {} records instead of {}", records_.size(), count));
}

void RecordReader::fail(const std::string& problem) const { throw Error(ExitCode::scene, fmt::format("{}: {}", path_, problem)); }

void RecordReader::readAt(std::uint64_t place, void* content, std::size_t bytes) const {
    for (std::size_t done = 0; done < bytes;) {
        const ssize_t got = file_.read(static_cast<char*>(content) + done, bytes - done, static_cast<off_t>(place + done));
        if (got < 0 && errno == ESTALE) fail("was replaced while it was read; try again");
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(fmt::format("cannot be read: {}", std::strerror(errno)));
        if (got == 0) fail("is truncated: it became shorter while it was read");
        done += static_cast<std::size_t>(got);
    }
}

std::vector<unsigned char> RecordReader::read(const Record& record) const {
    Head head{};
    readAt(record.place - sizeof head, &head, sizeof head);
    std::vector<unsigned char> content(record.bytes);
    readAt(record.place, content.data(), content.size());
    if (head.contentCheck != checksum(content.data(), content.size()))
        fail(fmt::format("is damaged: the {} bytes from byte {} on are not what was written", record.bytes, record.place));
    return content;
}

std::vector<unsigned char> RecordReader::read(RecordTag tag) const {
    const auto found = std::ranges::find(records_, tag, &Record::tag);
    if (found == records_.end()) fail("is damaged: a record is missing");
    return read(*found);
}

}  // namespace eikonal
