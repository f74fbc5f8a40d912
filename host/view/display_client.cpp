#include "view/display_client.h"

#include "image/channels.h"
#include "view/display_connection.h"
#include "view/display_packets.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

namespace eikonal {
namespace {

constexpr int tileSize = 128;
/// How long the render waits in the end for the last image to be sent.
constexpr std::chrono::seconds lastPatience(3);

/// The image as the other program has it.
class Display {
public:
    Display(DisplayAddress address, std::string title) : address_(std::move(address)), title_(std::move(title)) {}

    /// Sends what has changed. Throws a std::runtime_error; the next call then begins anew.
    void update(const FilmImage& image) {
        const auto channels = channelsOf<const float>(image);
        if (!connection_.isOpen()) create(image, channels);
        for (int y = 0; y < image.rows(); y += tileSize)
            for (int x = 0; x < image.columns(); x += tileSize)
                for (const auto& channel : channels)
                    sendTile(image, channel, {x, std::min(x + tileSize, image.columns()), y, std::min(y + tileSize, image.rows())});
    }

private:
    void create(const FilmImage& image, const std::vector<ChannelView<const float>>& channels) {
        connection_.open(address_);
        sent_.clear();
        std::vector<std::string> names;
        for (const auto& channel : channels) names.push_back(channel.name);
        connection_.send(createImagePacket(title_, image.columns(), image.rows(), names));
    }

    void sendTile(const FilmImage& image, const ChannelView<const float>& channel, const PixelBounds& tile) {
        std::vector<float> values;
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) values.push_back(channel[image.index(image.bounds.x0 + x, image.bounds.y0 + y)]);
        std::vector<float>& before = sent_[{channel.name, tile.x0, tile.y0}];
        if (before == values) return;
        connection_.send(updateImagePacket(title_, channel.name, tile, values));
        before = std::move(values);
    }

    const DisplayAddress address_;
    const std::string title_;
    DisplayConnection connection_;
    std::map<std::tuple<std::string, int, int>, std::vector<float>> sent_;  ///< values by channel and corner
};

}  // namespace

struct DisplayClient::State {
    std::mutex mutex;
    std::condition_variable change;
    std::shared_ptr<const FilmImage> next;  ///< to be sent
    bool ends = false, hasEnded = false;
    std::function<void(const std::string&)> warn;  ///< empty: has been told, or is not to be told any more

    void run(Display& display) {
        std::unique_lock lock(mutex);
        for (;;) {
            change.wait(lock, [&] { return next || ends; });
            if (!next) break;
            const std::shared_ptr<const FilmImage> image = std::exchange(next, nullptr);
            lock.unlock();
            std::string problem;
            try {
                display.update(*image);
            } catch (const std::exception& error) { problem = error.what(); }
            lock.lock();
            if (!problem.empty() && warn) std::exchange(warn, {})(problem);
        }
        hasEnded = true;
        change.notify_all();
    }
};

DisplayClient::DisplayClient(DisplayAddress address, std::string title, std::function<void(const std::string&)> warn)
    : state_(std::make_shared<State>()) {
    state_->warn = [address, warn = std::move(warn)](const std::string& problem) {
        warn(fmt::format("--display-server: {}:{} cannot be reached: {}; the render goes on", address.host, address.port, problem));
    };
    thread_ =
        std::thread([state = state_, display = std::make_shared<Display>(std::move(address), std::move(title))] { state->run(*display); });
}

DisplayClient::~DisplayClient() {
    std::unique_lock lock(state_->mutex);
    state_->ends = true;
    state_->change.notify_all();
    const bool hasEnded = state_->change.wait_for(lock, lastPatience, [this] { return state_->hasEnded; });
    state_->warn = {};
    lock.unlock();
    if (hasEnded) thread_.join();
    else thread_.detach();
}

void DisplayClient::show(std::shared_ptr<const FilmImage> image) {
    const std::lock_guard lock(state_->mutex);
    state_->next = std::move(image);
    state_->change.notify_all();
}

}  // namespace eikonal
