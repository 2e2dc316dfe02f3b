// Edits of single elements, and a Planner that keeps what they do not touch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plan/pipeline/pipeline.hpp"

namespace strandline {
namespace {

const char* const boxes = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
  <rect id="outer" x="5" y="5" width="90" height="90" fill="none" stroke="black"/>
  <rect id="middle" x="20" y="20" width="60" height="60" fill="none" stroke="black"/>
  <rect id="inner" x="35" y="35" width="30" height="30" fill="black"/>
  <path id="line" d="M10 10 L10 90" stroke="black" fill="none"/>
</svg>)";
const Source source{boxes, "boxes.svg"};

Plan planned(const std::vector<Edit>& edits) {
    auto plan = make_plan(source, *builtin_robot("beachbot"), {}, edits);
    EXPECT_TRUE(plan) << sentence(plan.error());
    return plan ? *plan : Plan{};
}
std::vector<std::string> ids(const Plan& plan) {
    std::vector<std::string> names;
    for (const Element& element : plan.drawing.elements) names.push_back(element.id);
    return names;
}
std::vector<std::string> driven(const Plan& plan) {
    std::vector<std::string> names;
    for (const Stroke& stroke : plan.strokes)
        if (const std::string& id = plan.drawing.elements[static_cast<std::size_t>(stroke.element)].id;
            names.empty() || names.back() != id)
            names.push_back(id);
    return names;
}
const Element& element(const Plan& plan, const std::string& id) {
    return *std::ranges::find(plan.drawing.elements, id, &Element::id);
}

TEST(Edits, AnErasedElementIsGoneAndWhatItEnclosedLiesInWhatEnclosedIt) {
    const Plan plan = planned({HintEdit{"middle", "ink", "off"}});
    EXPECT_EQ(ids(plan), (std::vector<std::string>{"outer", "inner", "line"}));
    EXPECT_EQ(plan.drawing.elements[static_cast<std::size_t>(element(plan, "inner").inside)].id, "outer");
}

TEST(Edits, AHintIsForOneElementAndTheLastOneWins) {
    const Plan plan = planned({HintEdit{"line", "pins", "7"}, HintEdit{"line", "pins", "3"},
                               HintEdit{"inner", "fill-style", "zigzag"}});
    EXPECT_EQ(std::get<LineElement>(element(plan, "line").what).pins, 3);
    EXPECT_EQ(std::get<LineElement>(element(plan, "outer").what).pins, 1);
    EXPECT_EQ(*value_of(element(plan, "inner").hints, "fill-style"), "zigzag");
    EXPECT_EQ(value_of(element(plan, "outer").hints, "fill-style"), nullptr);
}

TEST(Edits, AnOrderIsKeptEvenWhereItPutsTheOuterFirst) {
    const std::vector<std::string> wished{"outer", "line", "inner", "middle"};
    EXPECT_EQ(driven(planned({OrderEdit{wished}})), wished);
    EXPECT_EQ(driven(planned({OrderEdit{{"line", "line", "inner", "middle", "outer"}}})),
              (std::vector<std::string>{"line", "inner", "middle", "outer"}));
}

TEST(Edits, LinesDrawnByHandAreElementsInMetres) {
    const Path one = path_through({{2, 2}, {4, 2}}, false), two = path_through({{2, 3}, {4, 3}}, false);
    const Plan plan = planned({DrawEdit{"pen", {one, two}, 3, 0}});
    EXPECT_EQ(std::get<LineElement>(element(plan, "pen").what), (LineElement{one, 3}));
    EXPECT_EQ(std::get<LineElement>(element(plan, "pen/2").what).path, two);
    const auto bare = Planner().plan({"", "sketch"}, *builtin_robot("beachbot"), {}, plan.edits);
    ASSERT_TRUE(bare) << sentence(bare.error());
    EXPECT_EQ(ids(*bare), (std::vector<std::string>{"pen", "pen/2"}));
}

TEST(Edits, OneWhosePlaceIsGoneIsListedAndChangesNothing) {
    const std::vector<Edit> edits{HintEdit{"gone", "ink", "off"}, HintEdit{"line", "pause", "x"},
                                  OrderEdit{{"gone"}}};
    Plan plan = planned(edits);
    EXPECT_EQ(plan.idle_edits.size(), 3u);
    const Plan without = planned({});
    EXPECT_EQ(plan.samples, without.samples);
}

/// The first connection from one element to another, its index, and the two names.
struct Trip {
    int index = -1;
    std::string from, to;
    Curve curve;
};
Trip first_trip(const Plan& plan) {
    const auto name = [&](int stroke) {
        const int of = plan.strokes[static_cast<std::size_t>(stroke)].element;
        return plan.drawing.elements[static_cast<std::size_t>(of)].id;
    };
    for (std::size_t i = 0; i < plan.connections.size(); ++i)
        if (const PlannedConnection& c = plan.connections[i]; name(c.from) != name(c.to))
            return {static_cast<int>(i), name(c.from), name(c.to), c.curve};
    return {};
}
/// Half way along, moved to the left.
Pose beside(const Curve& curve, double left) {
    const Pose half = point_at(curve, length(curve) / 2).pose;
    return {half.at + left * Point{-std::sin(half.heading), std::cos(half.heading)}, half.heading};
}
double nearest(const Curve& curve, Point p) {
    double best = distance(curve.start.at, p);
    for (const CurvePoint& here : sampled(curve, 1e-3)) best = std::min(best, distance(here.pose.at, p));
    return best;
}

TEST(Edits, AConnectionIsLedThroughPosesWithinTheLimits) {
    // The area in one stroke: of several, another may come last where the way on is another.
    const HintEdit whole{"inner", "fill-tips", "off"};
    const Plan plain = planned({whole});
    const Trip trip = first_trip(plain);
    ASSERT_GE(trip.index, 0);
    const Pose pose = beside(trip.curve, 1);
    ASSERT_GT(nearest(trip.curve, pose.at), 0.5);
    const Plan led = planned({whole, ThroughEdit{trip.from, trip.to, {pose}}});
    EXPECT_TRUE(led.idle_edits.empty());
    EXPECT_EQ(driven(led), driven(plain));
    const Curve& curve = led.connections[static_cast<std::size_t>(trip.index)].curve;
    EXPECT_LT(nearest(curve, pose.at), 1e-3);
    EXPECT_LE(max_curvature(curve), 1 / led.robot.min_radius + 1e-6);
    const auto asked = led_connection(plain, trip.index, {pose});
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->curve, curve);
    // Named the other way round it is the same way, driven back.
    const Plan back = planned({whole, ThroughEdit{trip.to, trip.from, {{pose.at, pose.heading - pi}}}});
    EXPECT_EQ(back.connections[static_cast<std::size_t>(trip.index)].curve, curve);
}

TEST(Edits, AConnectionThatIsNotThereOrCannotBeLedIsSaidSo) {
    const Plan plain = planned({});
    const std::vector<std::string> order = driven(plain);
    ASSERT_GE(order.size(), 3u);
    const Plan idle = planned({ThroughEdit{order[0], order[2], {{{5, 5}, 0}}}});
    ASSERT_EQ(idle.idle_edits.size(), 1u);
    EXPECT_NE(idle.idle_edits[0].find("not driven one after the other"), std::string::npos);
    EXPECT_EQ(idle.samples, plain.samples);
    const auto plotter = make_plan(source, *builtin_robot("plotter"), {}, {});
    ASSERT_TRUE(plotter) << sentence(plotter.error());
    EXPECT_FALSE(led_connection(*plotter, 0, {{{5, 5}, 0}}));
    EXPECT_FALSE(led_connection(plain, 1000, {}));
}

TEST(Edits, PosesTooNearToEachOtherMakeALoopThatIsTold) {
    const Plan plain = planned({});
    const Trip trip = first_trip(plain);
    const Pose pose = beside(trip.curve, 0);
    EXPECT_FALSE(led_connection(plain, trip.index, {pose})->loops);
    const Pose turned{pose.at + Point{0.01, 0}, pose.heading + pi};
    const auto looped = led_connection(plain, trip.index, {pose, turned});
    ASSERT_TRUE(looped);
    EXPECT_TRUE(looped->loops);
    EXPECT_LE(max_curvature(looped->curve), 1 / plain.robot.min_radius + 1e-6);
}

TEST(Edits, TheDriveEndsNearThePlaceThatIsAskedFor) {
    for (const Point corner : {Point{1, 1}, Point{13, 13}, Point{1, 13}}) {
        Options options;
        options.tour.inner_first = false;
        ASSERT_TRUE(set(options, "tour.end_x", std::to_string(corner.x)));
        ASSERT_TRUE(set(options, "tour.end_y", std::to_string(corner.y)));
        // without the area, whose strokes end in the middle
        const auto plan =
            make_plan(source, *builtin_robot("beachbot"), options, {HintEdit{"inner", "ink", "off"}});
        ASSERT_TRUE(plan);
        EXPECT_LT(distance(plan->samples.back().rake, corner), 1) << corner.x << ' ' << corner.y;
    }
}

TEST(Edits, ADriveWithinAnAreaIsLedThroughPosesAndOthersAreNot) {
    const Plan plain = planned({});  // rings, one after the other
    const auto hop = std::ranges::find_if(plain.connections, [&](const PlannedConnection& c) {
        return c.from >= 0 && c.to >= 0 && plain.strokes[static_cast<std::size_t>(c.from)].fill &&
               plain.strokes[static_cast<std::size_t>(c.from)].element ==
                   plain.strokes[static_cast<std::size_t>(c.to)].element;
    });
    ASSERT_NE(hop, plain.connections.end());
    const Stroke &a = plain.strokes[static_cast<std::size_t>(hop->from)],
                 &b = plain.strokes[static_cast<std::size_t>(hop->to)];
    const Point from = end_pose(a.rake_path.back()).at, to = b.rake_path.front().start.at;
    const Pose pose = beside(hop->curve, 1);
    const auto led_from = [&](Point place) {
        return planned({ThroughEdit{"inner", "inner", {pose}, std::pair{place, to}}});
    };
    const Plan led = led_from(from);
    EXPECT_TRUE(led.idle_edits.empty());
    ASSERT_EQ(led.connections.size(), plain.connections.size());
    for (std::size_t i = 0; i < led.connections.size(); ++i) {
        const bool it = &plain.connections[i] == &*hop;
        EXPECT_EQ(nearest(led.connections[i].curve, pose.at) < 1e-3, it) << i;
        if (!it) {
            EXPECT_EQ(led.connections[i].curve, plain.connections[i].curve) << i;
        }
    }
    const Plan idle = led_from(from + Point{0.01, 0});
    ASSERT_EQ(idle.idle_edits.size(), 1u);
    EXPECT_NE(idle.idle_edits[0].find("within \"inner\": nothing is driven"), std::string::npos);
    EXPECT_EQ(idle.samples, plain.samples);
}

TEST(Drafts, KeepTheLastRowWhereTheEditLeavesIt) {
    Planner planner;
    const Robot robot = *builtin_robot("beachbot");
    const auto before = planner.plan(source, robot, {}, {});
    const auto same = planner.draft(source, robot, {}, {});
    ASSERT_TRUE(before && same);
    EXPECT_FALSE(same->plan.figures.reproducible);
    const Plan redrawn = whole(*same);
    ASSERT_EQ(redrawn.samples.size(), before->samples.size());
    for (std::size_t i = 0; i < redrawn.samples.size(); ++i) {
        Sample sample = redrawn.samples[i];
        const Sample& other = before->samples[i];
        EXPECT_NEAR(sample.t, other.t, 1e-6);
        EXPECT_NEAR(sample.speed, other.speed, 1e-6);
        sample.t = other.t;
        sample.speed = other.speed;
        sample.turn_rate = other.turn_rate;
        EXPECT_EQ(sample, other);
    }
    // Turned about: the others stay as they are.
    for (const char* direction : {"forward", "backward"}) {
        const auto draft = planner.draft(source, robot, {}, {DirectionEdit{"line", direction}});
        ASSERT_TRUE(draft);
        const Plan* turned = &draft->plan;
        EXPECT_TRUE(turned->idle_edits.empty());
        EXPECT_EQ(driven(*turned), driven(*before));
        for (std::size_t k = 0; k < turned->strokes.size(); ++k) {
            const bool line =
                turned->drawing.elements[static_cast<std::size_t>(turned->strokes[k].element)].id == "line";
            if (line)
                EXPECT_EQ(turned->order[k].reversed, std::string(direction) == "backward");
            else
                EXPECT_EQ(turned->order[k], before->order[k]);
        }
    }
}

TEST(Drafts, ObeyWishesAndHoldWhatIsDrawnNow) {
    Planner planner;
    const Robot robot = *builtin_robot("beachbot");
    ASSERT_TRUE(planner.plan(source, robot, {}, {}));
    const auto drafted = [&](const std::vector<Edit>& edits) {
        const auto draft = planner.draft(source, robot, {}, edits);
        EXPECT_TRUE(draft) << sentence(draft.error());
        return draft ? whole(*draft) : Plan{};
    };
    const std::vector<Edit> erased{HintEdit{"middle", "ink", "off"}};
    EXPECT_EQ(std::ranges::count(driven(drafted(erased)), "middle"), 0);
    // Back again, and something new.
    const Plan more = drafted({DrawEdit{"pen", {path_through({{2, 2}, {4, 5}}, false)}, 1, 0}});
    for (const char* id : {"outer", "middle", "inner", "line", "pen"})
        EXPECT_EQ(std::ranges::count(driven(more), id), 1) << id;
    // Another order, and two that are tied.
    EXPECT_EQ(driven(drafted({OrderEdit{{"outer", "inner", "line", "middle"}}})),
              (std::vector<std::string>{"outer", "inner", "line", "middle"}));
    const std::vector<std::string> tied = driven(drafted({LinkEdit{{"line", -1}, {"outer", 2}}}));
    const auto line = std::ranges::find(tied, "line"), outer = std::ranges::find(tied, "outer");
    EXPECT_EQ(std::abs(line - outer), 1);
    const Plan entered = drafted({EntryEdit{{"outer", 2}}});
    for (std::size_t k = 0; k < entered.strokes.size(); ++k)
        if (entered.drawing.elements[static_cast<std::size_t>(entered.strokes[k].element)].id == "outer") {
            EXPECT_EQ(entered.strokes[k].nodes[static_cast<std::size_t>(entered.order[k].node)].drawn, 2);
        }
}

TEST(Planner, AFileWithoutShapesIsRefusedAgainOnceNothingIsDrawnByHand) {
    const Robot robot = *builtin_robot("beachbot");
    const std::vector<Edit> drawn{DrawEdit{"pen", {path_through({{2, 2}, {4, 5}}, false)}, 1, 0}};
    for (const Source& empty :
         {Source{"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'/>", "empty.svg"},
          Source{"", ""}}) {
        Planner planner;
        const auto fresh = make_plan(empty, robot, {});
        ASSERT_FALSE(fresh);
        EXPECT_TRUE(planner.plan(empty, robot, {}, drawn));
        const auto after = planner.plan(empty, robot, {});
        ASSERT_FALSE(after);
        EXPECT_EQ(after.error(), fresh.error());
        EXPECT_TRUE(planner.plan(empty, robot, {}, drawn));
    }
}

TEST(Planner, PlansAsIfItHadKeptNothing) {
    Planner planner;
    const Robot beachbot = *builtin_robot("beachbot"), turf = *builtin_robot("turf");
    Options wide, zigzag;
    wide.canvas.width = 20;
    zigzag.fill.style = "zigzag";
    const std::vector<Edit> none, erased{HintEdit{"middle", "ink", "off"}},
        turned{HintEdit{"inner", "fill-style", "spiral"}},
        drawn{DrawEdit{"pen", {path_through({{2, 2}, {4, 5}}, false)}, 1, 0}};
    struct Round {
        const Robot& robot;
        Options options;
        const std::vector<Edit>& edits;
    };
    for (const Round& round :
         {Round{beachbot, {}, none}, Round{beachbot, {}, erased}, Round{beachbot, {}, turned},
          Round{beachbot, zigzag, turned}, Round{turf, zigzag, drawn}, Round{beachbot, wide, drawn},
          Round{beachbot, {}, none}}) {
        // a draft before it changes nothing of it
        ASSERT_TRUE(planner.draft(source, round.robot, round.options, round.edits));
        const auto kept = planner.plan(source, round.robot, round.options, round.edits);
        const auto fresh = make_plan(source, round.robot, round.options, round.edits);
        ASSERT_TRUE(kept && fresh);
        EXPECT_EQ(*kept, *fresh);
    }
}

}  // namespace
}  // namespace strandline
