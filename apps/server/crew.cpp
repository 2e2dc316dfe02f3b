#include "crew.hpp"

#include <chrono>
#include <thread>
#include <utility>

namespace strandline::serve {

void Crew::enqueue(std::function<void()> job) {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
    if (idle_ < jobs_.size() && threads_ < most_) {
        ++threads_;
        std::thread([this] { work(); }).detach();  // shutdown() waits for it by count
    } else {
        news_.notify_one();
    }
}

void Crew::work() {
    constexpr std::chrono::seconds patience(20);
    std::unique_lock lock(mutex_);
    for (;;) {
        ++idle_;
        news_.wait_for(lock, patience, [&] { return ending_ || !jobs_.empty(); });
        --idle_;
        if (jobs_.empty()) break;
        const auto job = std::move(jobs_.front());
        jobs_.pop_front();
        lock.unlock();
        job();
        lock.lock();
    }
    --threads_;
    gone_.notify_all();
}

void Crew::shutdown() {
    std::unique_lock lock(mutex_);
    ending_ = true;
    news_.notify_all();
    gone_.wait(lock, [&] { return threads_ == 0; });
}

}  // namespace strandline::serve
