#pragma once
// Descent: from a work queue of nodes, until no move gains.
#include <cstdint>
#include <vector>

#include "path/tour/moves.hpp"

namespace strandline::tour {

class Descent {
  public:
    /// Ends early when progress is stopped or `most_visits` were read to see whether rules are kept.
    Descent(Search& search, const Progress& progress, std::uint64_t most_visits)
        : search_(search),
          progress_(progress),
          most_visits_(most_visits),
          waiting_(static_cast<std::size_t>(search.tour.nodes()), false) {}

    /// From what was touched until nothing gains; the gain. keep_log: so that the caller can take it back.
    double run(bool keep_log);
    void touch_all();
    bool stopped() const { return stopped_; }
    bool ended() const { return stopped_ || search_.tour.visits_read > most_visits_; }

  private:
    /// Every polygon whose links changed is entered anew; all that was touched is queued. The gain.
    double settle();
    void push(int node);
    /// -1: nothing waits.
    int pop();

    Search& search_;
    const Progress& progress_;
    const std::uint64_t most_visits_;
    std::vector<char> waiting_;  ///< in the queue already
    std::vector<int> queue_;
    std::size_t head_ = 0;
    Exchange exchange_;
    Reinsert reinsert_;
    Revertex revertex_;
    std::uint64_t steps_ = 0;
    bool stopped_ = false;
};

/// The nodes at the ends of the longest links: where a loose end is best put. Into search.longest.
void find_longest(Search& search);

}  // namespace strandline::tour
