#pragma once
// Values of a single stage <-> the texts its stage command reads and writes (docs/stage-formats.md): a tour
// instance, a polygon to fill, pairs of poses, a rake path. The plan's own texts are in result/formats.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome/outcome.hpp"
#include "machine/follow/follow.hpp"
#include "path/connect/connect.hpp"
#include "path/fill/fill.hpp"
#include "path/tour/tour.hpp"

namespace strandline::stages {

// ---- tour: one JSON object in, a bare JSON array out
struct Instance {
    tour::Problem problem;
    Warnings warnings;  ///< unknown keys
};
Outcome<Instance> read_instance(std::string_view text, const std::string& place);
/// entries: written as "at" beside each step of a closed element.
std::string write_solution(const tour::Tour& tour, const tour::Problem& problem,
                           const std::optional<tour::Entries>& entries = {});
/// The problem for solvers of others (TSPLIB, Reinelt, ORSA Journal on Computing 3, 1991). Lines that may be
/// run either way, to anywhere: coordinates, a node for each end, fixed edges, an open tour (TYPE HPP); a far
/// point tied to the start keeps it in front; a closed tour as it is (TYPE TSP). All else: AGTSP, a set for
/// each element, a node for each way to pass it, full matrix of at most 10,000 nodes. Lengths are whole
/// numbers there: COMMENT says by how much they are scaled. Error: links, before or groups, which the format
/// does not know; too many nodes.
Outcome<std::string> write_tsplib(const tour::Problem& problem);
/// A TOUR_SECTION over the nodes that write_tsplib numbers. Error: not such a tour, by line and node.
Outcome<std::vector<tour::Step>> read_tsplib_tour(std::string_view text, const std::string& place,
                                                  const tour::Problem& problem);

// ---- fill: one JSON object in, the same object with `strokes` out
struct FillTask {
    Regions regions;  ///< the polygon, repaired even-odd
    std::optional<double> width;
    std::string source;  ///< the input's object without width and strokes: written back with both
    Warnings warnings;
};
Outcome<FillTask> read_polygon(std::string_view text, const std::string& place);
/// The input with the moves as its strokes; rake-up moves have "down": false. With `pins`, what is down has a
/// "mask" of that many characters.
std::string write_moves(const FillTask& task, double width, const std::vector<rake::Move>& moves,
                        std::optional<int> pins);
/// One JSON object, its keys as the fields of rake::Account.
std::string write_account(const rake::Account& account);

// ---- connect: one JSON object a line in, the same object with R, sigma and samples out
struct PairDefaults {
    double radius = 0.5;
    std::optional<double> sharpness;  ///< absent: 2.5 / R^2
};
struct Pair {
    CurvatureState from, to;
    std::vector<Pose> through;
    CurveLimits limits;
    std::vector<Polygon> obstacles;
    double clearance = 0;
    std::string source;
    std::vector<std::string> unknown = {};  ///< keys that mean nothing here
};
/// Error.place holds the line number.
Outcome<Pair> read_pair(std::string_view line, int number, const PairDefaults& defaults);
/// Equal steps of at most 0.01 R, at least 9 samples, 9 decimals. "fallback": the limit that the style
/// breaks, where the curve is bounded instead. `failure`: reason, when the obstacles could not be kept clear
/// of.
std::string write_curve(const Pair& pair, const connect::Connection& connection,
                        const std::optional<std::string>& failure);
/// Whether the curve comes nearer than the clearance to any obstacle.
bool hits_obstacles(const Pair& pair, const Curve& curve);

// ---- convert: CSV in, CSV out, one row a row
struct RakeRows {
    struct Row {
        Point at;
        unsigned pins = 0;
    };
    std::vector<std::vector<Row>> strokes;
};
/// Error: a place over 1,000 km away; pins that are no whole number from 0 to the mask of all the robot's.
Outcome<RakeRows::Row> rake_row(Point at, double pins, const std::string& place, const Robot& robot);
/// A count of pins or their mask: more than all pins of the robot's mask is refused, as every wrong line.
Outcome<RakeRows> read_rake_csv(std::string_view text, const std::string& place, const Robot& robot);
/// One row of the output.
struct RobotRow {
    Pose pose;
    double curvature;
    unsigned pins;
    Point rake;
};
struct Conversion {
    std::vector<std::vector<RobotRow>> strokes;
    Warnings undrivable;  ///< spans the robot cannot follow, by row
};
/// A smooth curve is laid through each stroke's points, the backward pass run on it, the states read off at
/// the points.
Conversion converted(const RakeRows& rows, const Robot& robot);
std::string write_robot_csv(const Conversion& conversion);

}  // namespace strandline::stages
