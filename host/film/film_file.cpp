#include "film/film_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace eikonal {
namespace {

constexpr const char* kind = "Eikonal film 1";
constexpr RecordTag identityTag = recordTag("WHAT"), plannedTag = recordTag("PLAN"), secondsTag = recordTag("TIME"),
                    pixelsTag = recordTag("PIXL");

/// Some pixels of a row that have the same number of samples. Their words follow, as in Film::restore.
struct Run { int y, x0, x1; unsigned samples; };

void writeRow(RecordWriter& file, const Film& film, int y) {
    const PixelRect& rect = film.pixels();
    const size_t width = static_cast<size_t>(rect.width());
    const std::span<const unsigned> taken = film.taken().subspan(static_cast<size_t>(y - rect.y0) * width, width);
    for (size_t begin = 0, end = 0; begin < width; begin = end) {
        while (end < width && taken[end] == taken[begin]) ++end;
        const Run run{y, rect.x0 + static_cast<int>(begin), rect.x0 + static_cast<int>(end), taken[begin]};
        if (run.samples == 0) continue;
        std::vector<uint> words(sizeof run / sizeof(uint));
        std::memcpy(words.data(), &run, sizeof run);
        for (int word = 0; word < film.words(); ++word) {
            const std::span<const uint> row = film.row(word, y).subspan(begin, end - begin);
            words.insert(words.end(), row.begin(), row.end());
        }
        file.write(pixelsTag, std::span<const uint>(words));
    }
}

}  // namespace

void writeFilmFile(const std::string& path, const Film& film, const FilmFileHead& head) {
    RecordWriter file(path, kind);
    file.write(identityTag, std::span<const char>(head.identity));
    file.write(plannedTag, std::span<const unsigned>(head.planned));
    file.write(secondsTag, std::span<const double>(&head.seconds, 1));
    for (int y = film.pixels().y0; y < film.pixels().y1; ++y) writeRow(file, film, y);
    file.commit();
}

FilmFileReader::FilmFileReader(const std::string& path) : records_(path, kind, "a checkpoint of Eikonal") {
    const std::vector<unsigned char> identity = records_.read(identityTag), planned = records_.read(plannedTag),
                                     seconds = records_.read(secondsTag);
    if (seconds.size() == sizeof head_.seconds) std::memcpy(&head_.seconds, seconds.data(), seconds.size());
    head_.identity.assign(identity.begin(), identity.end());
    head_.planned.resize(planned.size() / sizeof(unsigned));
    std::memcpy(head_.planned.data(), planned.data(), head_.planned.size() * sizeof(unsigned));
}

void FilmFileReader::readInto(Film& film) const {
    const PixelRect& rect = film.pixels();
    for (const RecordReader::Record& record : records_.records()) {
        if (record.tag != pixelsTag) continue;
        const std::vector<unsigned char> content = records_.read(record);
        Run run{};
        if (content.size() >= sizeof run) std::memcpy(&run, content.data(), sizeof run);
        const bool isInside = run.y >= rect.y0 && run.y < rect.y1 && run.x0 >= rect.x0 && run.x0 < run.x1 && run.x1 <= rect.x1;
        const size_t pixels = static_cast<size_t>(run.x1 - run.x0), words = pixels * static_cast<size_t>(film.words());
        if (!isInside || content.size() != sizeof run + words * sizeof(uint))
            records_.fail("is damaged: its pixels do not fit its image");
        std::vector<uint> values(words);
        std::memcpy(values.data(), content.data() + sizeof run, words * sizeof(uint));
        film.restore(run.y, run.x0, run.x1, run.samples, values);
    }
}

}  // namespace eikonal
