#include "wait_notice.h"

#include "json_text.h"
#include "messages.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <system_error>

namespace eikonal {

constexpr double secondsBetweenLines = 10;

WaitNotice::WaitNotice(std::string what, bool silent) : WaitNotice(what, what, {nullptr, 0}, silent) {}

WaitNotice::WaitNotice(std::string what, std::string brief, Parts parts, bool silent)
    : what_(std::move(what)), brief_(std::move(brief)), parts_(parts) {
    try {
        if (!silent) watcher_ = std::thread([this] { watch(); });
    } catch (const std::system_error&) {
        /* No thread is left: then it is not told */
    }
}

WaitNotice::~WaitNotice() {
    {
        std::lock_guard lock(mutex_);
        over_ = true;
    }
    wake_.notify_all();
    if (watcher_.joinable()) watcher_.join();
}

void WaitNotice::watch() {
    using namespace std::chrono_literals;
    std::unique_lock lock(mutex_);
    const auto isOver = [this] { return over_; };
    if (wake_.wait_for(lock, 500ms, isOver)) return;
    show(true);
    while (!wake_.wait_for(lock, 250ms, isOver)) show(false);
    if (progressForm() == ProgressForm::bar) endStatus(false);
}

void WaitNotice::show(bool isFirst) {
    const int done = parts_.done ? std::min(parts_.done->load(), parts_.all) : 0;
    const std::string state = brief_ + (parts_.done ? fmt::format(": {} of {}", done, parts_.all) : "");
    const bool isNew = done > shownDone_ && time_.seconds() - shownAt_ >= secondsBetweenLines;
    const ProgressForm form = progressForm();
    if (isFirst) logProgress(what_);
    if (form == ProgressForm::bar) {
        drawStatus(fmt::format("{}, {:.0f} s", state, time_.seconds()));
        return;
    }
    if (!isFirst && !(form == ProgressForm::plain ? isNew : done > shownDone_)) return;
    shownAt_ = time_.seconds();
    shownDone_ = done;
    if (form == ProgressForm::openjd) {
        printProgress(fmt::format("openjd_status: {}", state));
    } else if (form == ProgressForm::json) {
        nlohmann::ordered_json json{{"event", "wait"}, {"text", what_}, {"seconds", time_.seconds()}};
        if (parts_.done) json.update({{"done", done}, {"inAll", parts_.all}});
        printProgress(jsonText(json));
    } else {
        printProgress(isFirst ? what_ : state);
    }
}

}  // namespace eikonal
