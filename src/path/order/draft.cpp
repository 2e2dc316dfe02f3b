#include "path/order/draft.hpp"

#include <algorithm>
#include <utility>

#include "path/order/chain.hpp"
#include "path/order/shape.hpp"
#include "path/order/worth.hpp"

namespace strandline::order {
namespace {

/// Of names: this one is a corner's loop.
constexpr std::uint64_t loop_bit = std::uint64_t{1} << 63;

/// A stroke as planned, and what it is of.
struct Link {
    Planned planned;
    std::size_t place;  ///< of its group in the row
    int number;         ///< within its group
    bool last;          ///< of its group
};

class Drafter {
  public:
    Drafter(const Job& job, const std::vector<Going>& goings, const Robot& robot, const Options& options,
            const Search* search, Memory::Kept& kept)
        : job_(job),
          goings_(goings),
          robot_(robot),
          options_(options),
          search_(search),
          kept_(kept),
          finished_{route::Ground({.clearance = options.avoid.clearance, .radius = options.avoid.radius}),
                    route::Ground({.clearance = options.avoid.clearance, .radius = options.avoid.radius}),
                    std::vector<char>(job.groups.size(), 0), false, Raked(job, robot, options.avoid)} {}

    Draft make(const Progress& progress) {
        for (const Shape& wished : job_.shapes)
            answer_.unshaped.emplace_back(wished.hop ? "nothing is driven from there to there"
                                                     : "the two are not driven one after the other");
        if (search_) search_->pairs.hard().add_to(finished_.ground);
        const std::vector<std::vector<Link>> chains = chained(links());
        std::optional<CurvatureState> from;
        if (job_.parked) from = CurvatureState{*job_.parked, 0};
        const Link* last = nullptr;
        for (std::size_t k = 0; k < chains.size(); ++k) {
            progress.report("driving", static_cast<double>(k) / static_cast<double>(chains.size()));
            std::vector<Planned> chain;
            for (const Link& link : chains[k]) chain.push_back(link.planned);
            const Drives::Answer driven = kept_.drives.driven(chain, answer_.strokes, robot_, options_.drive);
            if (from) connect(*from, last, driven.drive->start, &chains[k].front());
            take(driven, chains[k]);
            from = driven.drive->end;
            last = &chains[k].back();
            for (const Link& link : chains[k])
                if (link.last) finish(goings_[link.place].step.element);
        }
        if (last && !job_.exits.empty())
            leave(*from, *last);
        else if (job_.end && from)
            cost_ += distance(from->pose.at, *job_.end);
        for (const Going& going : goings_)
            if (going.variant >= 0)
                cost_ += job_.groups[static_cast<std::size_t>(going.step.element)]
                             .variants[static_cast<std::size_t>(going.variant)]
                             .longer;
        return {std::move(answer_), false, cost_, goings_};
    }

  private:
    /// Groups -> strokes in driving order, each with its rake path as driven.
    std::vector<Link> links() {
        std::vector<Link> links;
        links.reserve(goings_.size());
        answer_.strokes.reserve(goings_.size());
        answer_.variants.assign(job_.groups.size(), -1);
        for (std::size_t k = 0; k < goings_.size(); ++k) {
            const auto& [step, variant] = goings_[k];
            const Group& group = job_.groups[static_cast<std::size_t>(step.element)];
            answer_.variants[static_cast<std::size_t>(step.element)] = variant;
            int number = 0;
            for (const Stroke& stroke : strokes_of(group, variant)) {
                const bool closed = is_single(group) && stroke.closed;
                const int index = static_cast<int>(answer_.strokes.size());
                const int end = static_cast<int>(stroke.nodes.size()) - 1;
                const int node = closed ? step.entry : step.reversed ? end : 0;
                answer_.strokes.push_back(stroke);
                answer_.entries.push_back({index, node, step.reversed});
                links.push_back({{index, rake_path_from(stroke, node, step.reversed)}, k, number++, false});
            }
            links.back().last = true;
        }
        return links;
    }

    std::vector<std::vector<Link>> chained(std::vector<Link> links) {
        std::vector<std::vector<Link>> chains;
        const auto stroke_of = [&](const Link& link) -> const Stroke& {
            return answer_.strokes[static_cast<std::size_t>(link.planned.stroke)];
        };
        const auto is_fill = [&](const Link& link) { return stroke_of(link).fill; };
        for (Link& next : links) {
            if (!chains.empty()) {
                const Link& before = chains.back().back();
                const Pose end = end_pose(before.planned.rake_path.back()),
                           start = next.planned.rake_path.front().start;
                answer_.straight += distance(end.at, start.at);
                if (!is_fill(before) && !is_fill(next) &&
                    nearly_touch(end, stroke_of(before), start, stroke_of(next), robot_, options_)) {
                    ++answer_.direct;
                    cost_ += distance(end.at, start.at);
                    chains.back().push_back(std::move(next));
                    continue;
                }
            }
            chains.push_back({});
            chains.back().push_back(std::move(next));
        }
        return chains;
    }

    /// Of a stroke as it is gone, and one of its loops.
    std::uint64_t name_of(const Link& link, int loop) const {
        return static_cast<std::uint64_t>(search_->row[link.place]) << 42 |
               static_cast<std::uint64_t>(link.number) << 21 | static_cast<std::uint64_t>(loop);
    }

    /// `number`: which of several that lead between the same two.
    Driven chosen(const CurvatureState& from, const Link* last, const CurvatureState& to, const Link* next,
                  int number) {
        if (!search_) return {connect::connection(from, to, options_.connect)};
        if (search_->mends)
            if (const Driven* before = kept_.joints.find(from, to)) return *before;
        const auto name = [&](const Link* link) {
            return static_cast<std::uint64_t>(link ? search_->row[link->place] + 1 : 0);
        };
        const std::uint64_t which = name(last) << 42 | name(next) << 21 | static_cast<std::uint64_t>(number);
        catch_up();
        Driven driven = search_->made.connected(which, from, to, finished_, search_->pairs, options_);
        if (last && next && last->place != next->place)
            search_->pairs.learn(search_->row[last->place], search_->row[next->place],
                                 search_->made.tried(which));
        kept_.joints.keep(from, to, driven);
        return driven;
    }

    void connect(const CurvatureState& from, const Link* last, const CurvatureState& to, const Link* next) {
        append(chosen(from, last, to, next, next ? next->number : 0), from, last, to, next);
    }

    /// To the exit that costs least; only the nearest are looked at.
    void leave(const CurvatureState& from, const Link& last) {
        const std::vector<Pose> exits = nearest_exits(job_, from.pose.at);
        std::optional<Driven> best;
        CurvatureState to;
        for (std::size_t k = 0; k < exits.size(); ++k) {
            Driven other = chosen(from, &last, {exits[k], 0}, nullptr, static_cast<int>(k));
            if (!search_) other.cost = worth(other.joint.curve, options_);
            if (best && other.cost >= best->cost) continue;
            best = std::move(other);
            to = {exits[k], 0};
        }
        append(std::move(*best), from, &last, to, nullptr);
    }

    void append(Driven driven, const CurvatureState& from, const Link* last, const CurvatureState& to,
                const Link* next) {
        const int before = last ? last->planned.stroke : -1, after = next ? next->planned.stroke : -1;
        if (last && next)
            shape(driven,
                  {goings_[last->place].step.element, goings_[next->place].step.element,
                   end_pose(last->planned.rake_path.back()).at, next->planned.rake_path.front().start.at});
        const connect::Connection& joint = driven.joint;
        if (!last || !next || last->place != next->place) cost_ += driven.cost;
        note(driven, before, after);
        if (!joint.broken.empty()) {
            ++answer_.fallbacks;
            answer_.warnings.push_back(
                {"connection after stroke " + std::to_string(before),
                 "its style breaks a limit there (" + joint.broken + "): a bounded curve is driven"});
        }
        const bool turns = options_.connect.style == connect::Style::straight || robot_.min_radius <= 0;
        answer_.dubins += !turns ? dubins_length(from.pose, to.pose, robot_.min_radius)
                                 : distance(from.pose.at, to.pose.at);
        answer_.stretches.push_back({kept_.joints.legs(from, to, joint, options_.drive.step), 0});
        answer_.connections.push_back(
            {before, after, joint.turn_before, joint.turn_after, joint.curve, std::move(driven.through)});
    }

    void note(const Driven& driven, int before, int after) {
        const Spoilt& spoilt = driven.spoilt;
        if (spoilt.metres > 0 || spoilt.crossings > 0)
            answer_.blemishes.push_back({before, after, point_at(driven.joint.curve, spoilt.first).pose.at,
                                         spoilt.metres, spoilt.crossings});
        if (const Rolled& rolled = spoilt.rolled; rolled.first)
            answer_.blemishes.push_back(
                {before, after, *rolled.first, rolled.metres, rolled.crossings, true});
    }

    /// A person's wish goes before what is shorter or spoils less; what it spoils is told.
    void shape(Driven& driven, const Between& ends) {
        auto led = shaped(driven.joint, ends, job_, options_.connect, answer_.unshaped);
        if (!led) return;
        driven.cost += worth(led->curve, options_) - worth(driven.joint.curve, options_);
        driven.joint = std::move(*led);
        driven.through.clear();
        driven.spoilt = search_ ? spoilt(driven.joint.curve, finished_, search_->pairs, options_) : Spoilt{};
    }

    void take(const Drives::Answer& driven, const std::vector<Link>& chain) {
        const drive::Drive& drive = *driven.drive;
        const int first = chain.front().planned.stroke;
        const auto link_of = [&](const Leg& leg) -> const Link& {
            return *std::ranges::find(chain, first + leg.stroke,
                                      [](const Link& link) { return link.planned.stroke; });
        };
        std::vector<Leg> led;  // all legs, where one is a loop
        int number = 0;
        for (std::size_t i = 0; i < drive.legs.size(); ++i) {
            const Leg& leg = drive.legs[i];
            if (leg.motion == Motion::draw) rake(driven.drive, i, link_of(leg));
            if (leg.motion != Motion::loop) continue;
            if (led.empty()) led = drive.legs;
            // Those of fills are the same whichever way they are taken, but for variants, which say so.
            if (answer_.strokes[static_cast<std::size_t>(first + leg.stroke)].fill)
                cost_ -= worth(leg.curve, options_);
            cost_ += led_round(led[i], link_of(leg), number++);
        }
        if (!led.empty() && (!driven.led || *driven.led != led))
            driven.led = std::make_shared<const std::vector<Leg>>(std::move(led));
        answer_.stretches.push_back(
            {number > 0 ? driven.led : std::shared_ptr<const std::vector<Leg>>(driven.drive, &drive.legs),
             first});
        for (const drive::Span& span : drive.undrivable) answer_.undrivable.push_back(span);
        answer_.exact += drive.exact;
        answer_.rounded += drive.rounded;
        answer_.loops += drive.loops;
        answer_.pivots += drive.pivots;
    }

    void rake(const std::shared_ptr<const drive::Drive>& drive, std::size_t leg, const Link& link) {
        if (!search_) return;
        unraked_.push_back({drive, leg, link.planned.stroke, name_of(link, 0)});
        if (!search_->mends) catch_up();
    }
    /// Draws what was left for later: much of it is finished before anything is connected anew.
    void catch_up() {
        for (const Unraked& one : unraked_)
            finished_.raked.draw(one.drive->legs[one.leg],
                                 answer_.strokes[static_cast<std::size_t>(one.stroke)], one.name);
        unraked_.clear();
    }

    /// A corner's loop, round what is finished and what is hard; its cost.
    double led_round(Leg& leg, const Link& link, int number) {
        if (!search_) return worth(leg.curve, options_);
        const auto state = [](const CurvePoint& point) {
            return CurvatureState{point.pose, point.curvature};
        };
        const CurvatureState from = state(point_at(leg.curve, 0)),
                             to = state(point_at(leg.curve, length(leg.curve)));
        const Driven driven = led_loop(leg, loop_bit | name_of(link, number), from, to);
        note(driven, link.planned.stroke, link.planned.stroke);
        leg.curve = driven.joint.curve;
        leg.path = states_along(leg.curve, options_.drive.step);
        return driven.cost;
    }

    Driven led_loop(const Leg& leg, std::uint64_t which, const CurvatureState& from,
                    const CurvatureState& to) {
        if (search_->mends)
            if (const Driven* before = kept_.joints.find(from, to)) return *before;
        catch_up();
        const Driven& driven = search_->made.connected(which, from, to, finished_, search_->pairs, options_,
                                                       connect::Connection{.curve = leg.curve});
        kept_.joints.keep(from, to, driven);
        return driven;
    }

    void finish(int group) {
        finished_.groups[static_cast<std::size_t>(group)] = 1;
        const Group& done = job_.groups[static_cast<std::size_t>(group)];
        const Regions& area = done.area;
        // the last part of an area has it; lines have none
        if (!area.empty() || !done.work.strokes.front().fill) {
            const int element = done.work.element;
            std::erase_if(unraked_, [&](const Unraked& one) {
                return answer_.strokes[static_cast<std::size_t>(one.stroke)].element == element;
            });
            finished_.raked.finish(element);
        }
        if (!search_ || !options_.avoid.on || area.empty()) return;
        finished_.ground.add(area);
        finished_.areas.add(area);
        finished_.any_area = true;
    }

    const Job& job_;
    const std::vector<Going>& goings_;
    const Robot& robot_;
    const Options& options_;
    const Search* search_;
    Memory::Kept& kept_;
    Finished finished_;
    /// What is raked by now and not looked at yet.
    struct Unraked {
        std::shared_ptr<const drive::Drive> drive;
        std::size_t leg;
        int stroke;
        std::uint64_t name;
    };
    std::vector<Unraked> unraked_;
    Ordered answer_;
    double cost_ = 0;
};

}  // namespace

Draft drafted(const Job& job, const std::vector<Going>& goings, const Robot& robot, const Options& options,
              const Search* search, Memory::Kept& kept, const Progress& progress) {
    return Drafter(job, goings, robot, options, search, kept).make(progress);
}

}  // namespace strandline::order
