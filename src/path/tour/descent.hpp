#pragma once
// Descent: from a work queue of nodes, until no move gains.
#include <cstdint>
#include <vector>

#include "path/tour/budget.hpp"
#include "path/tour/moves.hpp"

namespace strandline::tour {

class Descent {
  public:
    /// Counts its steps in `budget`; ends early when the caller stops it, or when too much was read to see
    /// whether rules are kept.
    Descent(Search& search, Budget& budget)
        : search_(search), budget_(budget), waiting_(static_cast<std::size_t>(search.tour.nodes()), false) {}

    /// From what was touched until nothing gains; the gain. The caller can take it back.
    double run();
    /// The same with wide exchanges, for good.
    double run_wide();
    void touch_all();
    bool ended() const { return budget_.stopped || search_.tour.visits_read > budget_.most_visits; }

  private:
    template <class Move>
    double run(Move& exchange, bool keep_log);
    /// Every polygon whose links changed is entered anew; all that was touched is queued. The gain.
    double settle();
    void push(int node);
    /// -1: nothing waits.
    int pop();

    Search& search_;
    Budget& budget_;
    std::vector<char> waiting_;  ///< in the queue already
    std::vector<int> queue_;
    std::size_t head_ = 0;
    Exchange<narrow> exchange_;
    Exchange<wide> wide_exchange_;
    Reinsert reinsert_;
    Revertex revertex_;
};

/// The nodes at the ends of the longest links: where a loose end is best put. Into search.longest.
void find_longest(Search& search);

}  // namespace strandline::tour
