#pragma once
// The threads that serve connections. An event stream holds its connection's thread for as long as a page is
// open, so there is no fixed number of them: a thread is there for every connection up to a limit, and goes
// when it has been idle for a while. Nobody waits behind a stream.
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>

namespace strandline::serve {

class Crew {
  public:
    explicit Crew(std::size_t most) : most_(most) {}
    ~Crew() { shutdown(); }
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;
    /// Done at once by an idle thread or a new one; behind others only where `most` are busy.
    void enqueue(std::function<void()> job);
    /// Waits until all that was begun is done.
    void shutdown();

  private:
    void work();
    const std::size_t most_;
    std::mutex mutex_;
    std::condition_variable news_, gone_;
    std::deque<std::function<void()>> jobs_;
    std::size_t threads_ = 0, idle_ = 0;
    bool ending_ = false;
};

}  // namespace strandline::serve
