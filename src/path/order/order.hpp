#pragma once
// Which stroke comes when, where it is entered and in which sense, and what is driven
// between. The only room that sees tour, drive and connect together. See docs/order.md.
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "math/region/region.hpp"
#include "path/connect/connect.hpp"
#include "path/drive/drive.hpp"
#include "path/stroke/stroke.hpp"
#include "path/tour/tour.hpp"

namespace strandline::order {

/// Another way to do a group's work, begun or ended elsewhere.
struct Variant {
    std::vector<Stroke> strokes;  ///< one way, in this order
    double longer = 0;            ///< metres driven within it beyond those of the group's own strokes
};
/// One element's strokes and what a person asked of them. Closed single strokes are entered at any node; open
/// ones at either end; the strokes of a fill keep their direction, and their order where `before` says so.
struct Group {
    StrokeGroup work;
    /// Of its strokes: the first is drawn before the second; the last one comes last in any case. Where pairs
    /// stand here, strokes that they leave open change places, with other groups between, and variants are
    /// passed over; unless the group is tied. None: the strokes are driven in one go, as they stand.
    std::vector<std::pair<int, int>> before = {};
    std::vector<Variant> variants = {};
    std::string name = {};          ///< for messages
    std::optional<int> entry = {};  ///< fixed node of a closed stroke, or 0 / last of an open one
    tour::Direction direction = tour::Direction::any;
    tour::Sense sense = tour::Sense::any;
    Regions area = {};  ///< not to be driven over once its strokes are drawn; of lines: none
};
/// The strokes of a group, or of one of its variants; -1: its own.
const std::vector<Stroke>& strokes_of(const Group& group, int variant);

/// Ties node `node_a` of group a to node `node_b` of group b: they are driven one after the other there.
struct Tie {
    int a = 0, node_a = 0, b = 0, node_b = 0;
};
/// What is driven from group a to group b is led through these poses of the robot; from b to a through the
/// same backwards. A hop: of what is driven within group a (b is it too), the drive between these places of
/// the rake.
struct Shape {
    int a = 0, b = 0;
    std::vector<Pose> through;
    std::optional<std::pair<Point, Point>> hop = {};
};
struct Job {
    std::vector<Group> groups;
    std::vector<std::pair<int, int>> before;  ///< first group is finished before the second begins
    std::vector<Tie> ties;
    std::optional<Point> start;  ///< the drive begins near here
    /// Groups drawn without others between, in this order; all of them, or none.
    std::vector<std::vector<int>> batches = {};
    std::optional<Point> end = {};  ///< the drive ends near here
    std::vector<Shape> shapes = {};
    /// Connections do not lead the robot's footprint out of the field, nor into keep-outs, whatever is
    /// avoided.
    std::optional<Region> field = {};
    Regions keep_out = {};
    std::optional<Pose> parked = {};  ///< the drive begins here
    std::vector<Pose> exits = {};     ///< and ends at one of these, the cheapest; none: at the last stroke
};
/// What is done about driving over what is finished: areas are hard, lines cost something.
struct Avoid {
    bool on = false;
    double clearance = 0.21;   ///< metres that the turning point keeps from finished areas
    double radius = 0.5;       ///< metres: the robot's least one, above 0
    double crossing_cost = 2;  ///< metres that a crossing of a drawn line is worth
    double area_cost = 20;     ///< metres that a metre over a finished area is worth
    double near_share = 0.25;  ///< of that: a metre beside it, nearer than the clearance
};
/// Where nothing better was found than to drive over what is finished.
struct Blemish {
    int from = -1, to = -1;  ///< strokes; -1: parked, or an exit
    Point at;                ///< where it begins
    double metres = 0;       ///< nearer to finished areas than the clearance
    int crossings = 0;       ///< of finished lines
    /// Instead, of what is still being raked: metres with a wheel on its area, crossings of its own line.
    bool unfinished = false;
};
struct Options {
    tour::Options tour;
    drive::Options drive;
    connect::Options connect;
    Avoid avoid;
    bool straight = false;  ///< the order of least straight gaps stays; nothing is avoided
    /// Metres: travel speed / turn rate, where time is to be least: bends with more curvature than 1 / this
    /// are driven slower, and count for more. 0: metres are.
    double slow_bends = 0;
    double min_gap = 0.02;  ///< metres: nearer strokes are joined directly
};

/// What is driven between two strokes of the answer; from -1: from where it was parked, to -1: to an exit.
struct Connection {
    int from = -1, to = -1;
    double turn_before = 0, turn_after = 0;
    Curve curve;
    std::vector<Pose> through = {};  ///< what it was led through, round finished ground
};
struct Ordered {
    std::vector<Stroke> strokes;     ///< in driving order
    std::vector<Entry> entries;      ///< one per stroke
    std::vector<int> variants;       ///< by group: which was taken; -1: its own strokes
    std::vector<Stretch> stretches;  ///< end to end
    std::vector<Connection> connections;
    std::vector<Blemish> blemishes;
    double straight = 0;  ///< m, rake centre, from stroke end to stroke start
    double dubins = 0;    ///< m, robot pose to robot pose where strokes are not joined directly
    int direct = 0;       ///< gaps joined directly
    int exact = 0, rounded = 0, loops = 0, pivots = 0;
    std::vector<std::string> unshaped;  ///< by shape of the job: why it does not hold; "" where it does
    int fallbacks = 0;  ///< connections whose style breaks a limit: they are bounded, each with a warning
    std::vector<drive::Span> undrivable;
    tour::Tour tour;
    bool reordered = false;  ///< the groups' order is not the tour's
    Warnings warnings;
};

/// What is kept of one order for the next, an edit later: the row, how strokes are driven and what is driven
/// between them. For one robot and one set of options. Holds the answer's legs, which it shares.
class Memory {
  public:
    struct Kept;
    Memory();
    ~Memory();
    Memory(Memory&&) noexcept;
    Memory& operator=(Memory&&) noexcept;

  private:
    std::unique_ptr<Kept> kept_;
    friend Outcome<Ordered> ordered(const Job&, const Robot&, const Options&, const Progress&, Memory*);
    friend std::optional<Ordered> mended(const Job&, const Robot&, const Options&, Memory&, const Progress&);
};

/// Order by straight rake-up length (tour); entries, senses and variants along that order by Dubins length
/// between robot poses (exact, dynamic programming); then all of it again by driven metres and blemishes
/// together (annealing), and every stroke driven and connected, round what is finished, until nothing gains.
/// A robot that turns on the spot for free keeps the tour. Error: contradictory wishes, by name.
/// `memory`: what was driven before is not driven again; the answer is the same, and is remembered.
Outcome<Ordered> ordered(const Job& job, const Robot& robot, const Options& options,
                         const Progress& progress = {}, Memory* memory = nullptr);

/// The row remembered, put right for a job that differs little from the last one: what is gone is left out,
/// what is new comes where it costs the least straight gap, what may no longer be gone through as it was goes
/// otherwise; ties and `before` move what they must. No other row is looked for, and what was connected
/// between the same states is connected so again, even where something else is finished by now: a draft,
/// marked as stopped. None: there is no such row, or the wishes need a search. O(strokes), and what is driven
/// anew.
std::optional<Ordered> mended(const Job& job, const Robot& robot, const Options& options, Memory& memory,
                              const Progress& progress = {});

}  // namespace strandline::order
