#pragma once
// Private to the room: what is kept of one order for the next.
#include <array>
#include <map>

#include "path/order/chain.hpp"
#include "path/order/detours.hpp"

namespace strandline::order {

/// Chains as they were driven: the same rake paths are driven the same way.
class Drives {
  public:
    struct Answer {
        std::shared_ptr<const drive::Drive> drive;  ///< strokes count from the chain's first
        /// What its legs became once their loops were led: whoever leads them keeps it here.
        std::shared_ptr<const std::vector<Leg>>& led;
    };
    /// The answer is good until the next call.
    Answer driven(const std::vector<Planned>& chain, const std::vector<Stroke>& strokes, const Robot& robot,
                  const drive::Options& options);
    /// Another order begins, or has come to its end: what it had no use for is forgotten.
    void begin();
    void end();

  private:
    struct One {
        std::vector<std::vector<Curve>> rake_paths;
        bool fill = false;
        int pins = 0;
        std::shared_ptr<const drive::Drive> drive;
        std::shared_ptr<const std::vector<Leg>> led;
        bool used = true;
    };
    /// Where a chain begins and ends, and of how many strokes it is.
    std::map<std::array<double, 7>, One> by_ends_;
};

/// What was driven between two states, by them.
class Joints {
  public:
    const Driven* find(const CurvatureState& from, const CurvatureState& to);
    void keep(const CurvatureState& from, const CurvatureState& to, const Driven& driven);
    /// What `joint` is as legs, from one state to the other.
    std::shared_ptr<const std::vector<Leg>> legs(const CurvatureState& from, const CurvatureState& to,
                                                 const connect::Connection& joint, double step);
    void clear() { by_states_.clear(); }
    void begin();
    void end();

  private:
    struct One {
        Driven driven;
        bool used = true;
    };
    struct Driving {
        double turn_before, turn_after, step;
        Curve curve;
        std::shared_ptr<const std::vector<Leg>> legs;
        bool used = true;
    };
    std::map<std::array<double, 8>, One> by_states_;
    std::map<std::array<double, 8>, Driving> driving_;
};

struct Memory::Kept {
    /// A group of the job as it is taken apart: of those with its name the one with that number.
    struct Place {
        std::string name;
        int number;
        Going going;
    };
    std::vector<Place> row;
    Drives drives;
    Joints joints;
    std::optional<Region> field;
    Regions keep_out;
    /// An order begins; one that is left halfway forgets nothing.
    void begin();
    void remember(const Job& job, const std::vector<Going>& goings);
};

/// By group: how many before it have its name.
std::vector<int> numbers_of(const Job& job);

}  // namespace strandline::order
