#include "render/film_blocks.h"

#include <utility>

namespace eikonal {

FilmBlocks::~FilmBlocks() {
    /* A buffer that stays mapped is never freed. An error here has been reported elsewhere */
    if (mapped_) clEnqueueUnmapMemObject(context_.queue(), buffer_.handle(), mapped_, 0, nullptr, nullptr);
}

const Buffer& FilmBlocks::upload(const Film& film, const Batch& batch) {
    words_ = static_cast<size_t>(batch.pixels()) * static_cast<size_t>(film.words());
    const size_t bytes = words_ * sizeof(uint);
    if (buffer_.size() < bytes) {
        if (mapped_) buffer_.unmap(context_, std::exchange(mapped_, nullptr));
        buffer_ = Buffer(context_, bytes, "blocks of the film");
        startDownload();
    }
    film.copyTo(wait(), batch);
    buffer_.unmap(context_, std::exchange(mapped_, nullptr));
    batch_ = batch;
    return buffer_;
}

void FilmBlocks::startDownload() { mapped_ = buffer_.map(context_, isMapped_); }

std::span<uint> FilmBlocks::wait() {
    context_.flush();
    const cl_event event = isMapped_;
    check(clWaitForEvents(1, &event), "waiting for blocks of the film");
    return {static_cast<uint*>(mapped_), words_};
}

}  // namespace eikonal
