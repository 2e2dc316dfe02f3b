#pragma once
// What happens to a project, handed to everyone who listens. Each listener has a queue of its own, so that a
// slow one holds up nobody.
#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace strandline::serve {

/// A server-sent event: its name and one line of JSON.
struct Event {
    std::string name, data;
};
/// As it goes over the wire (WHATWG HTML, 9.2).
std::string wire_text(const Event& event);

class Listener {
  public:
    /// The next event, waiting for at most that long. Nothing: none came, or the hub is closed (closed()).
    std::optional<Event> next(std::chrono::milliseconds wait);
    bool closed() const;

  private:
    friend class Hub;
    void push(const Event& event);
    void close();
    mutable std::mutex mutex_;
    std::condition_variable news_;
    std::deque<Event> waiting_;
    bool closed_ = false;
};

class Hub {
  public:
    std::shared_ptr<Listener> listen();
    void tell(const Event& event);
    void close();
    std::size_t listeners() const;

  private:
    mutable std::mutex mutex_;
    std::vector<std::weak_ptr<Listener>> listeners_;
    bool closed_ = false;
};

}  // namespace strandline::serve
