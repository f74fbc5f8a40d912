#include "film/film_parts.h"

#include "error.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace eikonal {

FilmParts::FilmParts(std::vector<std::unique_ptr<FilmFileReader>> files, const QueueLayout& layout, const PixelRect& pixels,
                     bool isPartial)
    : files_(std::move(files)), words_(static_cast<size_t>(layout.words)), sums_(layout), pixels_(pixels), isPartial_(isPartial),
      rows_(static_cast<size_t>(pixels.height())) {
    for (const auto& file : files_)
        for (const RecordReader::Record& record : file->pixelRecords()) {
            FilmRun head = file->readHead(record);
            if (head.y < pixels.y0 || head.y >= pixels.y1 || head.x0 < pixels.x0 || head.x1 > pixels.x1)
                throw Error(ExitCode::scene, fmt::format("{}: is damaged: its pixels do not fit its image", file->path()));
            rows_[static_cast<size_t>(head.y - pixels.y0)].push_back({file.get(), record, std::move(head)});
        }
}

void FilmParts::checkGap(const FilmRun& run, unsigned end) const {
    if (isPartial_) return;
    unsigned next = 0;
    const auto missing = [&](unsigned until) {
        throw Error(ExitCode::scene,
                    fmt::format("no part has samples {} to {} of pixel ({}, {}); with --partial, the image is made of what "
                                "is there",
                                next, until - 1, run.x0, run.y));
    };
    for (const SampleRange& node : run.nodes) {
        if (node.first > next) missing(node.first);
        next = node.end;
    }
    if (next < end) missing(end);
}

/// The pixels x0 <= x < x1, whose nodes are in order.
FilmRun FilmParts::joined(int y, int x0, int x1, const std::vector<Node>& nodes) const {
    const size_t count = static_cast<size_t>(x1 - x0);
    FilmRun all{y, x0, x1, {}, {}};
    std::vector<std::vector<uint>> sums;   // of each node
    struct Loaded { FilmRun run; size_t unused; };
    std::map<const Place*, Loaded> loaded;   // runs some of whose nodes are still to come
    for (const Node& node : nodes) {
        auto found = loaded.find(node.place);
        if (found == loaded.end())
            found = loaded.emplace(node.place, Loaded{node.place->file->readRun(node.place->record, words_), node.place->head.nodes.size()})
                        .first;
        const FilmRun& run = found->second.run;
        const size_t width = static_cast<size_t>(run.x1 - run.x0), skipped = static_cast<size_t>(x0 - run.x0);
        std::vector<uint> own(words_ * count);
        for (size_t word = 0; word < words_; ++word)
            std::copy_n(&run.words[(node.index * words_ + word) * width + skipped], count, &own[word * count]);
        if (--found->second.unused == 0) loaded.erase(found);
        SampleRange range = node.range;
        while (!all.nodes.empty() && joins(all.nodes.back(), range)) {
            sums_.join({sums.back().data(), count}, all.nodes.back(), {own.data(), count}, range, count);
            range.first = all.nodes.back().first;
            all.nodes.pop_back();
            sums.pop_back();
        }
        all.nodes.push_back(range);
        sums.push_back(std::move(own));
    }
    for (const std::vector<uint>& words : sums) all.words.insert(all.words.end(), words.begin(), words.end());
    return all;
}

void FilmParts::forRuns(int y, unsigned end, const std::function<void(const FilmRun&)>& take) {
    const std::vector<Place>& places = rows_[static_cast<size_t>(y - pixels_.y0)];
    std::set<int> borders{pixels_.x0, pixels_.x1};
    for (const Place& p : places) borders.insert({p.head.x0, p.head.x1});
    for (auto x0 = borders.begin(), x1 = std::next(x0); x1 != borders.end(); x0 = x1++) {
        std::vector<Node> nodes;
        for (const Place& p : places)
            if (p.head.x0 <= *x0 && p.head.x1 >= *x1)
                for (size_t i = 0; i < p.head.nodes.size(); ++i) nodes.push_back({p.head.nodes[i], &p, i});
        std::ranges::stable_sort(nodes, {}, &Node::range);
        for (size_t i = 1; i < nodes.size(); ++i)
            if (nodes[i].range.first < nodes[i - 1].range.end)
                throw Error(ExitCode::scene,
                            fmt::format("{} and {} both have sample {} of pixel ({}, {})", nodes[i - 1].place->file->path(),
                                        nodes[i].place->file->path(), nodes[i].range.first, *x0, y));
        const FilmRun run = joined(y, *x0, *x1, nodes);
        checkGap(run, end);
        if (!run.nodes.empty()) take(run);
    }
}

}  // namespace eikonal
