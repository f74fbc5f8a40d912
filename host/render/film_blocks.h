#pragma once
// A batch's pixels of the film, on their way to the device and back.

#include "device/buffer.h"
#include "film/film.h"

#include <optional>
#include <span>

namespace eikonal {

/// At most one batch at a time. The device works on while pixels are on their way.
class FilmBlocks {
public:
    explicit FilmBlocks(const Context& context) : context_(context) {}
    ~FilmBlocks();
    FilmBlocks(const FilmBlocks&) = delete;
    FilmBlocks& operator=(const FilmBlocks&) = delete;

    /// The batch that is on its way, if any.
    const std::optional<Batch>& batch() const { return batch_; }
    /// Copies a batch's pixels as they are now into the buffer, block after block, and enqueues handing it to the device. None must be on
    /// its way.
    const Buffer& upload(const Film& film, const Batch& batch);
    /// Enqueues the way back.
    void startDownload();
    /// Waits for the pixels. They may be changed until end().
    std::span<uint> wait();
    /// No batch is on its way any more.
    void end() { batch_.reset(); }

private:
    const Context& context_;
    std::optional<Batch> batch_;
    Buffer buffer_;
    size_t words_ = 0;           ///< of the batch
    void* mapped_ = nullptr;     ///< the buffer as host memory, from the event on
    Owned<cl_event, clReleaseEvent> isMapped_;
};

}  // namespace eikonal
