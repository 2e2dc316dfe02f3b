// A stroke is driven from its end to its start, because only so the rake's state is known at each corner:
// edge by edge, each corner treated with the first of its treatments that the rake can follow.
#include "path/drive/drive.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "path/drive/moves.hpp"

namespace strandline::drive {
namespace {

// Heading jumps below this (radians) are rounding of the fit, not corners.
constexpr double smooth = 1e-7;
// Pieces, and edges, shorter than this (metres) are rounding of a cut.
constexpr double least_length = 2e-9, least_edge = 2e-8;

// The rake within this (metres) of a place is at it.
constexpr double same_place = 1e-7;

// An edge between two corners is shared by their roundings; one at the stroke's end belongs to its corner but
// for a rest that keeps the end's own direction and curvature.
constexpr double shared = 0.5, end_share = 0.9;

enum class Treatment { round, exact, pivot, loop };

/// Curves that meet without a corner made one; empty ones dropped.
std::vector<Curve> edges_of(std::vector<Curve> path) {
    std::vector<Curve> edges;
    for (Curve& curve : path) {
        std::erase_if(curve.pieces, [](const Clothoid& piece) { return piece.length < least_length; });
        if (length(curve) < least_edge) continue;
        const double turn =
            edges.empty() ? pi : wrap_angle(curve.start.heading - end_pose(edges.back()).heading);
        if (std::abs(turn) < smooth)
            edges.back() = joined(std::move(edges.back()), curve);
        else
            edges.push_back(std::move(curve));
    }
    return edges;
}

std::vector<Treatment> treatments(const Stroke& stroke, double turn, const Robot& robot,
                                  const Options& options) {
    using enum Treatment;
    const bool free = turns_on_spot(robot);
    if (robot.rake_offset == 0 && free) return {pivot};
    std::vector<Treatment> list;
    const auto last_resort = [&] {
        // no least radius: nothing to loop with, and nothing to loop for
        if ((options.above == Above::pivot && free) || robot.min_radius == 0) list.push_back(pivot);
        list.push_back(loop);
    };
    if (stroke.fill) {
        list = {round, exact};
        if (free) list.push_back(pivot);
        list.push_back(loop);
    } else if (std::abs(turn) < options.corner_threshold) {
        if (options.below == Below::round) list.push_back(round);
        list.push_back(exact);
        if (options.above == Above::round) list.push_back(round);
        last_resort();
    } else {
        if (options.above == Above::round) list.push_back(round);
        last_resort();
    }
    return list;
}

/// What brings the heading of `next` nearest to that of `before`: a multiple of 2 pi.
double whole_turns(Pose before, Pose next) {
    return 2 * pi * std::round((before.heading - next.heading) / (2 * pi));
}

/// A part of a path that is driven in one motion.
struct Chunk {
    Motion motion;
    RobotPath path;
};
/// The path cut where the rake leaves it (draw) and is back (lead), in order; neighbours share their state.
std::vector<Chunk> lifted_where_lost(Followed&& what) {
    std::vector<Chunk> chunks{{Motion::draw, {}}};
    auto span = what.undrivable.begin();
    for (std::size_t i = 0; i < what.path.size(); ++i) {
        const double s = what.rake_s[i];
        while (span != what.undrivable.end() && s > span->to) ++span;
        const bool lost = span != what.undrivable.end() && s >= span->from && s < span->to;
        chunks.back().path.push_back(what.path[i]);
        const Motion motion = lost ? Motion::lead : Motion::draw;
        if (motion == chunks.back().motion) continue;
        if (chunks.back().path.size() > 1)
            chunks.push_back({motion, {what.path[i]}});
        else
            chunks.back().motion = motion;
    }
    if (chunks.size() > 1 && chunks.back().path.size() < 2) chunks.pop_back();
    return chunks;
}

/// The drive while it is built, from its last leg to its first.
struct Builder {
    const Robot& robot;
    const Options& options;
    int stroke;
    bool fill;  ///< a fill is lifted where the rake is lost: it would rake outside; a line is drawn on
    Drive drive = {};
    std::vector<Chunk> chunks = {};  ///< of the leg being built, last chunk first

    Followed followed(const Curve& piece, double end_delta) const {
        return robot_path_for({piece}, robot,
                              {.step = options.step,
                               .max_delta = options.max_delta,
                               .end_delta = end_delta,
                               .steady_end = false});
    }
    /// Whether the rake gets to the piece's start, and with which delta; it does not where it strayed up to
    /// there.
    std::optional<double> delta_at_start(const Curve& piece, const Followed& what) const {
        const Pose first = what.path.front().pose;
        if (distance(rake_at(robot, first), piece.start.at) > same_place) return std::nullopt;
        return wrap_angle(first.heading - piece.start.heading);
    }
    void push(Leg leg) {
        leg.stroke = stroke;
        drive.legs.push_back(std::move(leg));
    }
    /// The piece becomes the next chunk towards the start.
    void draw(const Curve& piece, Followed&& what) {
        for (const Followed::Span& span : what.undrivable)
            drive.undrivable.push_back(
                {point_at(piece, (span.from + span.to) / 2).pose.at, span.to - span.from});
        if (!fill || what.undrivable.empty()) {
            chunks.push_back({Motion::draw, std::move(what.path)});
            return;
        }
        std::vector<Chunk> parts = lifted_where_lost(std::move(what));
        std::move(parts.rbegin(), parts.rend(), std::back_inserter(chunks));
    }
    /// The chunks become one leg, or one for each row of chunks of the same motion.
    void finish_leg() {
        for (auto chunk = chunks.begin(); chunk != chunks.end();) {
            const auto end = std::find_if(chunk, chunks.end(),
                                          [&](const Chunk& other) { return other.motion != chunk->motion; });
            Leg leg{.motion = chunk->motion};
            for (auto part = end; part != chunk;) add_to(leg.path, (--part)->path);
            push(std::move(leg));
            chunk = end;
        }
        chunks.clear();
    }
    static void add_to(RobotPath& path, const RobotPath& chunk) {
        const double before = (path.empty() ? 0 : path.back().s) - chunk.front().s;
        const double turns = path.empty() ? 0 : whole_turns(path.back().pose, chunk.front().pose);
        // chunks share their joint; with the rake at the turning point curvature may jump there
        const bool one = !path.empty() && std::abs(path.back().curvature - chunk.front().curvature) < smooth;
        for (std::size_t i = one ? 1 : 0; i < chunk.size(); ++i) {
            path.push_back(chunk[i]);
            path.back().s += before;
            path.back().pose.heading += turns;
        }
    }
    const RobotState& first_state() const { return drive.legs.back().path.front(); }
};

Curve cut(const Curve& edge, double from, double to) {
    if (to - from < least_length) return {point_at(edge, from).pose, {}};
    return slice(edge, from, to);
}

/// Headings of neighbouring legs differ by whole turns at most; here they are made to differ by nothing.
void unwind(std::vector<Leg>& legs) {
    for (std::size_t i = 1; i < legs.size(); ++i) {
        const double turns = whole_turns(legs[i - 1].path.back().pose, legs[i].path.front().pose);
        for (RobotState& state : legs[i].path) state.pose.heading += turns;
        legs[i].curve.start.heading += turns;
    }
}

}  // namespace

Drive drive(const Stroke& stroke, int stroke_index, int node, bool reversed, const Robot& machine,
            const Options& options) {
    const Robot robot = steered(stroke, machine);
    const std::vector<Curve> edges = edges_of(rake_path_from(stroke, node, reversed));
    Builder build{robot, options, stroke_index, stroke.fill};
    if (edges.empty()) return {};

    double end_delta = leaving_delta(robot, edges.back());
    if (auto out = leaving(robot, edges.back(), end_delta, options.step).run_out) build.push(std::move(*out));
    double end = length(edges.back());  // of the present edge: what a rounding left of it
    for (std::size_t i = edges.size() - 1; i > 0; --i) {
        const Curve &edge = edges[i], &before = edges[i - 1];
        const double length_before = length(before),
                     turn = wrap_angle(edge.start.heading - end_pose(before).heading);
        const Curve whole = cut(edge, 0, end);
        std::optional<Followed> plain;

        for (const Treatment treatment : treatments(stroke, turn, robot, options)) {
            if (treatment == Treatment::round) {
                const double share = i == 1 ? end_share : shared,
                             share_after = i + 1 == edges.size() ? end_share : shared;
                const auto arc =
                    rounded(before, edge, turn, stroke.fill ? options.fill_radius : options.corner_radius,
                            share * length_before, std::min(share_after * length(edge), end));
                if (!arc) continue;
                const Curve piece = joined(arc->arc, cut(edge, arc->cut, end));
                Followed bent = build.followed(piece, end_delta);
                const auto delta = build.delta_at_start(piece, bent);
                if (!delta || (!bent.undrivable.empty() && bent.undrivable.front().from < length(arc->arc)))
                    continue;
                end_delta = *delta;
                build.draw(piece, std::move(bent));
                end = length_before - arc->cut;
                ++build.drive.rounded;
                break;
            }
            if (!plain) plain = build.followed(whole, end_delta);
            const auto delta = build.delta_at_start(whole, *plain);
            if (treatment == Treatment::exact &&
                (robot.rake_offset == 0 || !delta ||
                 !drivable_deltas(robot, options.max_delta).hold(*delta + turn)))
                continue;
            build.draw(whole, std::move(*plain));
            end = length_before;
            if (treatment == Treatment::exact) {
                build.finish_leg();
                end_delta = *delta + turn;
                ++build.drive.exact;
                break;
            }
            build.finish_leg();
            if (treatment == Treatment::pivot) {
                end_delta = leaving_delta(robot, before);
                const Pose to = build.first_state().pose, corner = end_pose(before);
                const auto legs = pivot(robot_at(robot, corner.at, corner.heading + end_delta), to);
                std::for_each(legs.rbegin(), legs.rend(), [&](const Leg& leg) { build.push(leg); });
                ++build.drive.pivots;
            } else {
                Loop loop = loop_round(robot, before, build.first_state(), options);
                end_delta = loop.from.delta;
                if (loop.lead) build.push(std::move(*loop.lead));
                build.push(std::move(loop.curve));
                if (loop.from.run_out) build.push(std::move(*loop.from.run_out));
                ++build.drive.loops;
            }
            break;
        }
    }
    const Curve first = cut(edges.front(), 0, end);
    build.draw(first, build.followed(first, end_delta));
    build.finish_leg();
    if (auto lead = lead_in(robot, build.first_state(), options.step)) build.push(std::move(*lead));

    Drive result = std::move(build.drive);
    std::reverse(result.legs.begin(), result.legs.end());
    std::reverse(result.undrivable.begin(), result.undrivable.end());
    unwind(result.legs);
    const RobotState &start = result.legs.front().path.front(), &last = result.legs.back().path.back();
    result.start = {start.pose, start.curvature};
    result.end = {last.pose, last.curvature};
    return result;
}

}  // namespace strandline::drive
