#include "plan/parts/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "path/trajectory/trajectory.hpp"

namespace strandline::parts {
namespace {

/// The samples of each stroke: from the first that draws it to the first after it.
struct Extent {
    std::size_t first = std::numeric_limits<std::size_t>::max(), end = 0;
};
std::vector<Extent> extents(const Plan& plan) {
    std::vector<Extent> list(plan.strokes.size());
    for (std::size_t i = 0; i + 1 < plan.samples.size(); ++i) {
        const int stroke = plan.samples[i].stroke;
        if (plan.samples[i].motion != Motion::draw || stroke < 0 || stroke >= static_cast<int>(list.size()))
            continue;
        Extent& extent = list[static_cast<std::size_t>(stroke)];
        extent.first = std::min(extent.first, i);
        extent.end = i + 1;
    }
    return list;
}

/// Where the way that belongs to a stroke begins: with the lead before it.
std::size_t lead_of(const Plan& plan, std::size_t sample) {
    while (sample > 0 && plan.samples[sample - 1].motion == Motion::lead) --sample;
    return sample;
}

/// The samples that a part holds, the last one included: the first part has the way from where the robot was
/// parked too, the last one the way to the exit.
struct Span {
    std::size_t from, to;
};
Span span_of(const Plan& plan, const std::vector<Extent>& all, int first, int end) {
    return {first == 0 ? 0 : lead_of(plan, all[static_cast<std::size_t>(first)].first),
            end == static_cast<int>(plan.strokes.size()) ? plan.samples.size() - 1
                                                         : all[static_cast<std::size_t>(end - 1)].end};
}

/// As they are in the whole, but that the last one draws no more.
std::vector<Sample> samples_of(const Plan& plan, const Span& span) {
    std::vector<Sample> samples(plan.samples.begin() + static_cast<std::ptrdiff_t>(span.from),
                                plan.samples.begin() + static_cast<std::ptrdiff_t>(span.to + 1));
    samples.back().mask = 0;
    samples.back().stroke = -1;
    samples.back().motion = Motion::connect;
    return samples;
}

/// Only the first part begins where the robot was parked, only the last one ends at the exit.
void keep_ends(Options::Park& park, bool is_first, bool is_last, double last_heading) {
    const Options::Park whole = park;
    if (!is_first)
        park = {.exit = whole.exit,
                .exit_x = whole.exit_x,
                .exit_y = whole.exit_y,
                .exit_heading = whole.exit_heading};
    if (!is_last) {
        park.exit = "none";
        park.exit_x = park.exit_y = park.exit_heading = 0;
    } else if (!is_first && whole.exit == "parked") {
        // Where the robot was parked is of no other use to this part: it is a place like another.
        const bool turned = std::abs(wrap_angle(last_heading - whole.heading)) > pi / 2;
        park.exit = "pose";
        park.exit_x = whole.x;
        park.exit_y = whole.y;
        park.exit_heading = turned ? wrap_angle(whole.heading + pi) : whole.heading;
    }
}

/// The elements that the part's strokes draw, numbered anew; strokes follow.
void keep_elements(Plan& part, const Plan& whole, int first, int end) {
    std::set<int> used;
    for (const Stroke& stroke : part.strokes) used.insert(stroke.element);
    std::vector<int> number(whole.drawing.elements.size(), -1);
    part.drawing.elements.clear();
    for (const int e : used) {
        if (e < 0) continue;
        number[static_cast<std::size_t>(e)] = static_cast<int>(part.drawing.elements.size());
        part.drawing.elements.push_back(whole.drawing.elements[static_cast<std::size_t>(e)]);
    }
    const auto renumbered = [&](int e) { return e < 0 ? -1 : number[static_cast<std::size_t>(e)]; };
    for (Element& element : part.drawing.elements) element.inside = renumbered(element.inside);
    std::set<int> elsewhere;
    for (int k = 0; k < static_cast<int>(whole.strokes.size()); ++k)
        if (k < first || k >= end) elsewhere.insert(whole.strokes[static_cast<std::size_t>(k)].element);
    for (const int e : used)
        if (e >= 0 && elsewhere.contains(e))
            part.warnings.push_back({whole.drawing.elements[static_cast<std::size_t>(e)].id,
                                     "is drawn in more than one part: here only some of its strokes"});
    for (Stroke& stroke : part.strokes) stroke.element = renumbered(stroke.element);
}

/// Places that the part's drive comes nearer to than the rest of the whole does.
std::vector<Spot> near_to(const std::vector<Spot>& spots, const std::vector<Sample>& whole, std::size_t from,
                          std::size_t to) {
    std::vector<Spot> kept;
    for (const Spot& spot : spots) {
        double here = std::numeric_limits<double>::infinity(), elsewhere = here;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            double& least = i >= from && i <= to ? here : elsewhere;
            least = std::min({least, distance(whole[i].pose.at, spot.at), distance(whole[i].rake, spot.at)});
        }
        if (here <= elsewhere) kept.push_back(spot);
    }
    return kept;
}

}  // namespace

void measure(Figures& figures, const std::vector<Sample>& samples) {
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const Sample &a = samples[i - 1], &b = samples[i];
        const double driven = distance(a.pose.at, b.pose.at);
        const double bend = std::max(std::abs(a.curvature), std::abs(b.curvature));
        switch (a.motion) {
            case Motion::draw:
                figures.drawn += distance(a.rake, b.rake);
                figures.tightest_drawn = std::max(figures.tightest_drawn, std::abs(a.curvature));
                break;
            case Motion::loop:
                figures.loops_driven += driven;
                figures.tightest_up = std::max(figures.tightest_up, bend);
                break;
            case Motion::connect:
                figures.up_driven += driven;
                figures.tightest_up = std::max(figures.tightest_up, bend);
                break;
            case Motion::lead:
                figures.up_driven += driven;
                break;
            case Motion::pivot:
                break;
        }
    }
    figures.time = samples.empty() ? 0 : samples.back().t;
}

Outcome<void> can_be_cut(const Plan& plan) {
    if (plan.strokes.empty()) return fail(plan.title, "has no strokes", "there is nothing to cut");
    const std::vector<Extent> driven = extents(plan);
    for (std::size_t k = 0; k < driven.size(); ++k)
        if (driven[k].end == 0)
            return fail(plan.title, fmt::format("stroke {} is never driven", k),
                        "the plan's check says what is wrong");
    return {};
}

Plan part(const Plan& plan, int first, int end) {
    Plan part = plan;
    const std::vector<Extent> all = extents(plan);
    const auto slice = [&](auto& list) {
        list.erase(list.begin() + end, list.end());
        list.erase(list.begin(), list.begin() + first);
    };
    slice(part.strokes);
    slice(part.order);
    for (Entry& entry : part.order) entry.stroke -= first;
    const int count = static_cast<int>(plan.strokes.size());
    std::erase_if(part.connections, [&](const PlannedConnection& c) {
        const bool begins = c.from < 0 ? first == 0 : c.from >= first;
        const bool ends = c.to < 0 ? end == count : c.to < end;
        return !begins || !ends;
    });
    for (PlannedConnection& c : part.connections) {
        if (c.from >= 0) c.from -= first;
        if (c.to >= 0) c.to -= first;
    }
    std::erase_if(part.stops, [&](const Stop& stop) { return stop.stroke <= first || stop.stroke >= end; });

    const Span span = span_of(plan, all, first, end);
    part.samples = samples_of(plan, span);
    for (Sample& sample : part.samples)
        if (sample.stroke >= 0) sample.stroke -= first;
    keep_ends(part.options.park, first == 0, end == count, part.samples.back().pose.heading);
    const std::vector<Sample> before = part.samples;
    part.samples = trajectory::retimed(std::move(part.samples), plan.robot);
    for (Stop& stop : part.stops) {
        // The instant at which the whole plan stopped, in the part's own time.
        std::size_t i = 0;
        while (i + 1 < before.size() && before[i].t < stop.time) ++i;
        stop.time = part.samples[i].t;
        stop.stroke -= first;
    }
    keep_elements(part, plan, first, end);
    part.undrivable = near_to(plan.undrivable, plan.samples, span.from, span.to);
    part.blemishes = near_to(plan.blemishes, plan.samples, span.from, span.to);
    part.bare = near_to(plan.bare, plan.samples, span.from, span.to);
    Figures figures;
    figures.elements = static_cast<int>(part.drawing.elements.size());
    figures.regions = static_cast<int>(std::ranges::count_if(part.drawing.elements, is_region));
    figures.lines = figures.elements - figures.regions;
    figures.strokes = end - first;
    figures.reproducible = plan.figures.reproducible;
    if (first == 0) figures.in_driven = plan.figures.in_driven;
    if (end == count) figures.out_driven = plan.figures.out_driven;
    measure(figures, part.samples);
    part.figures = figures;
    return part;
}

std::vector<int> cuts(const Plan& plan, const Limit& limit) {
    const std::vector<Extent> all = extents(plan);
    std::vector<double> driven{0};
    for (std::size_t i = 1; i < plan.samples.size(); ++i)
        driven.push_back(driven.back() + distance(plan.samples[i - 1].pose.at, plan.samples[i].pose.at));
    const int count = static_cast<int>(plan.strokes.size());
    // In the whole drive: no part takes less time by itself, it only begins and ends at rest besides.
    const auto may_fit = [&](int first, int end) {
        const auto [from, to] = span_of(plan, all, first, end);
        return (limit.seconds <= 0 || plan.samples[to].t - plan.samples[from].t <= limit.seconds) &&
               (limit.metres <= 0 || driven[to] - driven[from] <= limit.metres);
    };
    const auto fits = [&](int first, int end) {
        return limit.seconds <= 0 ||
               trajectory::retimed(samples_of(plan, span_of(plan, all, first, end)), plan.robot).back().t <=
                   limit.seconds;
    };
    const auto whole_until = [&](int end) {
        return end == count || plan.strokes[static_cast<std::size_t>(end - 1)].element !=
                                   plan.strokes[static_cast<std::size_t>(end)].element;
    };
    std::vector<int> begins;
    for (int first = 0; first < count;) {
        begins.push_back(first);
        int last = first;
        while (last < count && may_fit(first, last + 1)) ++last;
        const auto longest = [&](bool whole) {
            for (int end = last; end > first; --end)
                if (whole_until(end) == whole && fits(first, end)) return end;
            return first;
        };
        int end = longest(true);
        if (end == first) end = longest(false);
        first = std::max(end, first + 1);
    }
    return begins;
}

Outcome<int> stroke_at(const Plan& plan, const From& from) {
    const std::vector<Extent> all = extents(plan);
    const int count = static_cast<int>(plan.strokes.size());
    if (const double* time = std::get_if<double>(&from)) {
        for (int k = 0; k < count; ++k)
            if (plan.samples[all[static_cast<std::size_t>(k)].end].t > *time) return k;
        return fail(
            "--from", fmt::format("{:g} s is after the last stroke", *time),
            fmt::format("the drive takes {:.0f} s", plan.samples.empty() ? 0 : plan.samples.back().t));
    }
    if (const std::string* id = std::get_if<std::string>(&from)) {
        for (int k = 0; k < count; ++k) {
            const int e = plan.strokes[static_cast<std::size_t>(k)].element;
            if (e >= 0 && plan.drawing.elements[static_cast<std::size_t>(e)].id == *id) return k;
        }
        return fail("--from " + *id, "no element of that name is drawn",
                    "name an element of the plan, a time (12min) or a place (3.5,2)");
    }
    const Point place = std::get<Point>(from);
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const Sample& sample : plan.samples)
        if (sample.motion == Motion::draw && distance(sample.rake, place) < least) {
            least = distance(sample.rake, place);
            best = sample.stroke;
        }
    return best;
}

}  // namespace strandline::parts
