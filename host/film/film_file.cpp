#include "film/film_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <iterator>

namespace eikonal {
namespace {

constexpr const char* kind = "Eikonal film 1";
constexpr RecordTag identityTag = recordTag("WHAT"), plannedTag = recordTag("PLAN"), secondsTag = recordTag("TIME"),
                    sceneTag = recordTag("SCEN"), metadataTag = recordTag("META"), pixelsTag = recordTag("PIXL"),
                    splatsTag = recordTag("SPLT");

/// The beginning of a run's record. Its nodes follow, then their words.
struct Head { int y, x0, x1, nodes; };

/// The pixels of row y from x0 on that have the same samples.
FilmRun runOf(const Film& film, int y, int x0) {
    const PixelRect& rect = film.pixels();
    const size_t width = static_cast<size_t>(rect.width()), begin = static_cast<size_t>(x0 - rect.x0);
    const std::span<const unsigned> taken = film.taken().subspan(static_cast<size_t>(y - rect.y0) * width, width);
    size_t end = begin;
    while (end < width && taken[end] == taken[begin]) ++end;
    FilmRun run{y, x0, rect.x0 + static_cast<int>(end), nodesOf({film.firstSample(), taken[begin]}), {}};
    for (size_t node = 0; node < run.nodes.size(); ++node)
        for (int word = 0; word < film.words(); ++word) {
            const std::span<const uint> row = film.row(node, word, y).subspan(begin, end - begin);
            run.words.insert(run.words.end(), row.begin(), row.end());
        }
    return run;
}

/// The record of a run, or of a row of splats: its head, its ranges of samples, its words.
template <class Run> std::vector<unsigned char> contentOf(const Run& run, const std::vector<SampleRange>& ranges) {
    const Head head{run.y, run.x0, run.x1, static_cast<int>(ranges.size())};
    const size_t rangeBytes = ranges.size() * sizeof ranges[0], wordBytes = run.words.size() * sizeof run.words[0];
    std::vector<unsigned char> content(sizeof head + rangeBytes + wordBytes);
    std::memcpy(content.data(), &head, sizeof head);
    std::memcpy(content.data() + sizeof head, ranges.data(), rangeBytes);
    std::memcpy(content.data() + sizeof head + rangeBytes, run.words.data(), wordBytes);
    return content;
}

/// Copies bytes of a record. There may be none, and then no place for them.
void copyBytes(void* to, const unsigned char* from, size_t bytes) {
    if (bytes > 0) std::memcpy(to, from, bytes);
}

std::string asText(const std::vector<unsigned char>& content) { return {content.begin(), content.end()}; }

}  // namespace

FilmFileWriter::FilmFileWriter(const std::string& path, const FilmFileHead& head) : file_(path, kind) {
    file_.write(identityTag, std::span<const char>(head.identity));
    file_.write(plannedTag, std::span<const unsigned>(head.planned));
    file_.write(secondsTag, std::span<const double>(&head.seconds, 1));
    file_.write(sceneTag, std::span<const char>(head.scene));
    file_.write(metadataTag, std::span<const char>(head.metadata));
}

void FilmFileWriter::write(const FilmRun& run) {
    file_.write(pixelsTag, contentOf(run, run.nodes));
}

void FilmFileWriter::write(const SplatSums& splats) {
    for (const SplatRow& row : splats.rows())
        if (!row.samples.empty()) file_.write(splatsTag, contentOf(row, row.samples));
}

void writeFilmFile(const std::string& path, const Film& film, const FilmFileHead& head) {
    FilmFileWriter file(path, head);
    if (film.splats()) file.write(*film.splats());
    const PixelRect& rect = film.pixels();
    for (int y = rect.y0; y < rect.y1; ++y)
        for (int x = rect.x0; x < rect.x1;) {
            const FilmRun run = runOf(film, y, x);
            if (!run.nodes.empty()) file.write(run);
            x = run.x1;
        }
    file.commit();
}

FilmFileReader::FilmFileReader(const std::string& path) : records_(path, kind, "a film file of Eikonal (a checkpoint or a part)") {
    const std::vector<unsigned char> planned = records_.read(plannedTag), seconds = records_.read(secondsTag);
    head_.identity = asText(records_.read(identityTag));
    head_.scene = asText(records_.read(sceneTag));
    head_.metadata = asText(records_.read(metadataTag));
    head_.planned.resize(planned.size() / sizeof(unsigned));
    copyBytes(head_.planned.data(), planned.data(), head_.planned.size() * sizeof(unsigned));
    if (seconds.size() == sizeof head_.seconds) std::memcpy(&head_.seconds, seconds.data(), seconds.size());
}

std::vector<RecordReader::Record> FilmFileReader::pixelRecords() const {
    std::vector<RecordReader::Record> found;
    std::ranges::copy_if(records_.records(), std::back_inserter(found), [](auto& record) { return record.tag == pixelsTag; });
    return found;
}

FilmRun FilmFileReader::readHead(const RecordReader::Record& record) const {
    Head head{};
    if (record.bytes >= sizeof head) records_.readPart(record, 0, &head, sizeof head);
    const std::uint64_t most = (record.bytes - std::min<std::uint64_t>(record.bytes, sizeof head)) / sizeof(SampleRange);
    if (head.nodes <= 0 || static_cast<std::uint64_t>(head.nodes) > most || head.x0 >= head.x1)
        records_.fail("is damaged: pixels without samples");
    FilmRun run{head.y, head.x0, head.x1, std::vector<SampleRange>(static_cast<size_t>(head.nodes)), {}};
    records_.readPart(record, sizeof head, run.nodes.data(), run.nodes.size() * sizeof(SampleRange));
    if (std::ranges::any_of(run.nodes, [](SampleRange node) { return node.first >= node.end; }))
        records_.fail("is damaged: pixels without samples");
    return run;
}

FilmRun FilmFileReader::readRun(const RecordReader::Record& record, size_t wordsPerPixel) const {
    const std::vector<unsigned char> content = records_.read(record);
    Head head{};
    if (content.size() >= sizeof head) std::memcpy(&head, content.data(), sizeof head);
    FilmRun run{head.y, head.x0, head.x1, {}, {}};
    if (head.nodes <= 0 || head.x0 >= head.x1) records_.fail("is damaged: pixels without samples");
    const size_t nodes = static_cast<size_t>(head.nodes), rangeBytes = nodes * sizeof(SampleRange),
                 wordBytes = nodes * wordsPerPixel * (static_cast<size_t>(head.x1) - static_cast<size_t>(head.x0)) * sizeof(uint);
    if (content.size() != sizeof head + rangeBytes + wordBytes) records_.fail("is damaged: its pixels do not fit its image");
    run.nodes.resize(nodes);
    run.words.resize(wordBytes / sizeof(uint));
    std::memcpy(run.nodes.data(), content.data() + sizeof head, rangeBytes);
    copyBytes(run.words.data(), content.data() + sizeof head + rangeBytes, wordBytes);
    return run;
}

void FilmFileReader::forSplats(const std::function<void(const SplatRow&)>& take) const {
    for (const RecordReader::Record& record : records_.records()) {
        if (record.tag != splatsTag) continue;
        const std::vector<unsigned char> content = records_.read(record);
        Head head{};
        if (content.size() >= sizeof head) std::memcpy(&head, content.data(), sizeof head);
        const std::uint64_t width = head.x1 > head.x0 ? static_cast<std::uint64_t>(head.x1 - head.x0) : 0,
                            ranges = head.nodes > 0 ? static_cast<std::uint64_t>(head.nodes) * sizeof(SampleRange) : 0,
                            before = sizeof head + ranges,
                            words = content.size() > before ? (content.size() - before) / sizeof(std::uint64_t) : 0;
        if (!width || !ranges || words == 0 || words % width || content.size() != before + words * sizeof(std::uint64_t))
            records_.fail("is damaged: its light paths do not fit its image");
        SplatRow row{head.y, head.x0, head.x1, {}, std::vector<std::uint64_t>(words)};
        row.samples.resize(static_cast<size_t>(head.nodes));
        std::memcpy(row.samples.data(), content.data() + sizeof head, ranges);
        copyBytes(row.words.data(), content.data() + sizeof head + ranges, words * sizeof(std::uint64_t));
        take(row);
    }
}

void FilmFileReader::readInto(Film& film) const {
    const PixelRect& rect = film.pixels();
    forSplats([&](const SplatRow& row) {
        if (!film.splats() || !film.splats()->fits(row) || !film.splats()->add(row))
            records_.fail("is damaged: its light paths do not fit its image");
    });
    for (const RecordReader::Record& record : pixelRecords()) {
        const FilmRun run = readRun(record, static_cast<size_t>(film.words()));
        if (run.y < rect.y0 || run.y >= rect.y1 || run.x0 < rect.x0 || run.x1 > rect.x1)
            records_.fail("is damaged: its pixels do not fit its image");
        if (run.nodes != nodesOf({film.firstSample(), run.nodes.back().end})) records_.fail("has other samples than this render takes");
        film.restore(run.y, run.x0, run.x1, run.nodes.back().end, run.words);
    }
}

}  // namespace eikonal
