#include "path/order/pairs.hpp"

#include <algorithm>
#include <cmath>

#include "path/order/worth.hpp"

namespace strandline::order {
namespace {

/// A metre over a finished area is guessed to cost so many metres of way round it.
constexpr double guessed_detour = 1.5;
/// The same of a keep-out, or outside the field.
constexpr double guessed_hard_detour = 3;
/// Exits that are looked at for one candidate: the nearest.
constexpr std::size_t most_exits = 6;

/// Turns with their clothoids take more room than arcs: the three parts of a way that backs up are guessed
/// by arcs so much wider.
constexpr double wider = 1.06;
/// Pairs of more candidates than this are not kept in a table.
constexpr std::size_t most_tabled = 1500;

bool is_fill(const Group& group) { return group.work.strokes.front().fill; }

}  // namespace

bool nearly_touch(Pose from, const Stroke& drawn, Pose to, const Stroke& next, const Robot& robot,
                  const Options& options) {
    // The rake would have to be moved sideways where they meet.
    if (middle_of(robot, pin_mask(robot, drawn.pins)) != middle_of(robot, pin_mask(robot, next.pins)))
        return false;
    // Rounding moves the ends that meet, and the legs could not be dealt back to their strokes.
    if (options.drive.below == drive::Below::round || options.drive.above == drive::Above::round)
        return false;
    // A robot that turns on the spot for free gains nothing.
    if (robot.min_radius <= 0 || options.connect.style == connect::Style::straight) return false;
    const double gap = distance(from.at, to.at);
    if (gap > options.min_gap) return false;
    constexpr double touching = 1e-9;
    if (gap <= touching)
        return std::abs(wrap_angle(to.heading - from.heading)) < options.drive.corner_threshold;
    const double across = heading(to.at - from.at);
    return std::abs(wrap_angle(across - from.heading)) < options.drive.corner_threshold &&
           std::abs(wrap_angle(to.heading - across)) < options.drive.corner_threshold;
}

std::vector<Pose> nearest_exits(const Job& job, Point from) {
    std::vector<Pose> exits = job.exits;
    std::ranges::stable_sort(exits, {}, [&](const Pose& exit) { return distance(exit.at, from); });
    if (exits.size() > most_exits) exits.resize(most_exits);
    return exits;
}

Pairs::Pairs(const Job& job, const Choices& choices, const Robot& robot, const Options& options)
    : job_(job),
      robot_(robot),
      options_(options),
      hard_(job, robot, options.avoid.clearance, options.avoid.radius),
      marks_(job, options.avoid, robot) {
    first_.push_back(0);
    for (const std::vector<Candidate>& own : choices) {
        candidates_.insert(candidates_.end(), own.begin(), own.end());
        first_.push_back(static_cast<int>(candidates_.size()));
    }
    if (candidates_.size() <= most_tabled) table_.assign(candidates_.size() * candidates_.size(), -1);
}

int& Pairs::number(int from, int to) {
    const std::size_t n = candidates_.size(), a = static_cast<std::size_t>(from),
                      b = static_cast<std::size_t>(to);
    if (!table_.empty()) return table_[a * n + b];
    return numbers_.try_emplace(static_cast<std::uint64_t>(a) << 32 | b, -1).first->second;
}

Pairs::Entry& Pairs::entry(int from, int to) {
    int& number = this->number(from, to);
    if (number < 0) {
        number = static_cast<int>(entries_.size());
        entries_.push_back(first_look(from, to));
    }
    return entries_[static_cast<std::size_t>(number)];
}

Pairs::Entry Pairs::first_look(int from, int to) const {
    Entry entry;
    const Candidate &a = candidates_[static_cast<std::size_t>(from)],
                    &b = candidates_[static_cast<std::size_t>(to)];
    const bool lines = !is_fill(job_.groups[static_cast<std::size_t>(group_of(from))]) &&
                       !is_fill(job_.groups[static_cast<std::size_t>(group_of(to))]);
    const auto stroke_at = [&](const Candidate& candidate, bool end) -> const Stroke& {
        const auto& [step, variant] = candidate.going;
        const auto& strokes = strokes_of(job_.groups[static_cast<std::size_t>(step.element)], variant);
        return step.reversed == end ? strokes.front() : strokes.back();
    };
    if (lines &&
        nearly_touch(a.rake_end, stroke_at(a, true), b.rake_start, stroke_at(b, false), robot_, options_)) {
        entry = {distance(a.rake_end.at, b.rake_start.at), true, true, {{}}};
        entry.passages.front().length = entry.shortest;
        return entry;
    }
    entry.shortest = dubins_length(a.end, b.start, robot_.min_radius);
    if (const auto backed = backed_guess(a.end, b.start, entry.shortest))
        entry.shortest = worth(*backed, options_);
    if (options_.connect.pivot) entry.shortest = std::min(entry.shortest, turned_straight(a.end, b.start));
    if (options_.slow_bends <= 0 && !options_.avoid.on && !hard_.near(a.end.at, b.start.at)) {
        entry.weighed = true;
        entry.passages = {{entry.shortest}};
    }
    return entry;
}

double Pairs::turned_straight(Pose from, Pose to) const {
    const double d = distance(from.at, to.at);
    const double ahead = d > 0 ? heading(to.at - from.at) : to.heading;
    const auto turned = [&](double angle) {
        return angle == 0 ? 0 : options_.connect.turn_start + options_.connect.turn_cost * std::abs(angle);
    };
    return d + turned(wrap_angle(ahead - from.heading)) + turned(wrap_angle(to.heading - ahead));
}

std::optional<Curve> Pairs::backed_guess(Pose from, Pose to, double below) const {
    if (!options_.connect.back_up) return std::nullopt;
    const double radius = std::max(least_radius(robot_, 1), least_radius(robot_, -1));
    return backing_guess(from, to, wider * radius, options_.connect.stand_cost, below);
}

Passage Pairs::passage(double length, const Curve& curve, const Rates& rates, int left) const {
    const Touched touched = marks_.touched(curve);
    Passage result{length + touched.hard * rates.hard};
    for (const Touch& touch : touched.groups) {
        const double metre =
            touch.group == left ? options_.avoid.area_cost * options_.avoid.near_share : rates.area;
        result.spoils.push_back(
            {touch.group, touch.crossings * options_.avoid.crossing_cost + touch.metres * metre});
    }
    return result;
}

const std::vector<Passage>& Pairs::passages(int from, int to) {
    Entry& found = entry(from, to);
    if (found.weighed) return found.passages;
    found.weighed = true;
    const Pose a = candidates_[static_cast<std::size_t>(from)].end,
               b = candidates_[static_cast<std::size_t>(to)].start;
    std::vector<Curve> curves;
    const double d = distance(a.at, b.at);
    if (options_.connect.pivot && d > 0 && turned_straight(a, b) <= found.shortest)
        curves.push_back(straight({a.at, heading(b.at - a.at)}, d));
    std::vector<Curve> words = dubins_words(a, b, robot_.min_radius);
    if (auto backed = backed_guess(a, b, length(words.front()))) curves.push_back(std::move(*backed));
    for (Curve& word : words) curves.push_back(std::move(word));
    const auto whole = [](const Passage& p) {
        double sum = p.length;
        for (const Passage::Spoils& s : p.spoils) sum += s.cost;
        return sum;
    };
    double least = std::numeric_limits<double>::infinity();
    for (const Curve& curve : curves) {
        const double l =
            found.passages.empty() && options_.slow_bends <= 0 ? found.shortest : worth(curve, options_);
        if (l >= least) continue;  // a shorter one is cheaper, whatever is drawn
        found.passages.push_back(
            passage(l, curve, {.area = guessed_detour, .hard = guessed_hard_detour}, group_of(from)));
        least = std::min(least, whole(found.passages.back()));
    }
    std::ranges::stable_sort(found.passages, {}, &Passage::length);  // what is hard made some longer
    return found.passages;
}

double Pairs::cheapest_word(Pose from, Pose to, bool all_finished) const {
    double best = std::numeric_limits<double>::infinity();
    for (const Curve& word : dubins_words(from, to, robot_.min_radius)) {
        const double metres = worth(word, options_);
        if (metres >= best) continue;
        const Passage way = passage(metres, word, {.area = guessed_detour, .hard = guessed_hard_detour});
        double sum = way.length;
        if (all_finished)
            for (const Passage::Spoils& spoils : way.spoils) sum += spoils.cost;
        best = std::min(best, sum);
    }
    return best;
}

double Pairs::from_parked(int candidate) {
    const auto [at, fresh] = from_parked_.try_emplace(candidate, 0);
    if (fresh)
        at->second =
            cheapest_word(*job_.parked, candidates_[static_cast<std::size_t>(candidate)].start, false);
    return at->second;
}

double Pairs::to_exit(int candidate) {
    const auto [at, fresh] = to_exit_.try_emplace(candidate, std::numeric_limits<double>::infinity());
    if (!fresh) return at->second;
    const Pose from = candidates_[static_cast<std::size_t>(candidate)].end;
    for (const Pose& exit : nearest_exits(job_, from.at))
        at->second = std::min(at->second, cheapest_word(from, exit, true));
    return at->second;
}

void Pairs::learn(int from, int to, std::vector<Passage> driven) {
    Entry& known = entry(from, to);
    known.weighed = known.learnt = true;
    std::ranges::sort(driven, {}, &Passage::length);
    known.shortest = driven.front().length;
    known.passages = std::move(driven);
}

}  // namespace strandline::order
