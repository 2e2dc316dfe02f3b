#include "events.hpp"

#include <algorithm>

namespace strandline::serve {
namespace {

// A listener that is further behind than this is told what holds now by the next event of each name: every
// event says all there is to say, none builds on the one before.
constexpr std::size_t most_waiting = 64;

}  // namespace

std::string wire_text(const Event& event) {
    return "event: " + event.name + "\ndata: " + event.data + "\n\n";
}

std::optional<Event> Listener::next(std::chrono::milliseconds wait) {
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, wait, [&] { return closed_ || !waiting_.empty(); });
    if (waiting_.empty()) return std::nullopt;
    Event event = std::move(waiting_.front());
    waiting_.pop_front();
    return event;
}

bool Listener::closed() const {
    const std::lock_guard lock(mutex_);
    return closed_;
}

void Listener::push(const Event& event) {
    {
        const std::lock_guard lock(mutex_);
        if (event.name == "progress" || waiting_.size() >= most_waiting)
            std::erase_if(waiting_, [&](const Event& old) { return old.name == event.name; });
        waiting_.push_back(event);
    }
    news_.notify_one();
}

void Listener::close() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    news_.notify_one();
}

std::shared_ptr<Listener> Hub::listen() {
    auto listener = std::make_shared<Listener>();
    const std::lock_guard lock(mutex_);
    if (closed_) listener->close();
    listeners_.push_back(listener);
    return listener;
}

void Hub::tell(const Event& event) {
    const std::lock_guard lock(mutex_);
    std::erase_if(listeners_, [](const auto& listener) { return listener.expired(); });
    for (const auto& weak : listeners_)
        if (const auto listener = weak.lock()) listener->push(event);
}

void Hub::close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    for (const auto& weak : listeners_)
        if (const auto listener = weak.lock()) listener->close();
}

std::size_t Hub::listeners() const {
    const std::lock_guard lock(mutex_);
    return static_cast<std::size_t>(
        std::ranges::count_if(listeners_, [](const auto& listener) { return !listener.expired(); }));
}

}  // namespace strandline::serve
