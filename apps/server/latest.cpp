#include "workspace.hpp"

namespace strandline::serve {

Latest::Latest() : thread_([this] { work(); }) {}

Latest::~Latest() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        next_.reset();
        if (stop_current_) *stop_current_ = true;
    }
    news_.notify_one();
    thread_.join();
}

void Latest::want(Job job) {
    {
        const std::lock_guard lock(mutex_);
        next_ = std::move(job);
        if (stop_current_) *stop_current_ = true;
    }
    news_.notify_one();
}

void Latest::work() {
    for (;;) {
        std::unique_lock lock(mutex_);
        news_.wait(lock, [&] { return ending_ || next_; });
        if (ending_) return;
        const Job job = std::move(*next_);
        next_.reset();
        stop_current_ = std::make_shared<std::atomic<bool>>(false);
        const auto stop = stop_current_;
        lock.unlock();
        job(*stop);
        lock.lock();
        stop_current_.reset();
    }
}

}  // namespace strandline::serve
