#pragma once
// A small plan on a beach, and what of it exports are held against.
#include "exports/readers.hpp"
#include "formats/sample_plan.hpp"

namespace strandline::testing {

inline Plan beach_plan() {
    Plan plan = sample_plan();
    plan.options.site = {true, {{47.37, 8.55}, 30, 3, -2, 0.6}};
    for (const Sample& sample : plan.samples)
        if (sample.stroke == 1) {
            plan.stops = {{"tool 2", 1, sample.t}};
            break;
        }
    return plan;
}
/// Cut where pins go down or up: of the turning point, or of the rake.
inline std::vector<Track> tracks_of(const Plan& plan, bool rake) {
    std::vector<Track> tracks;
    for (std::size_t i = 0; i + 1 < plan.samples.size(); ++i) {
        const Sample &a = plan.samples[i], &b = plan.samples[i + 1];
        const bool down = a.mask != 0;
        if (tracks.empty() || tracks.back().down != down || (i > 0 && a.stroke != plan.samples[i - 1].stroke))
            tracks.push_back({down, {rake ? a.rake : a.pose.at}});
        tracks.back().points.push_back(rake ? b.rake : b.pose.at);
    }
    return tracks;
}
inline std::vector<Track> only_down(std::vector<Track> tracks) {
    std::erase_if(tracks, [](const Track& track) { return !track.down; });
    return tracks;
}
/// Within `tolerance` of each other, one by one.
inline void expect_same(const std::vector<Track>& read, const std::vector<Track>& planned, double tolerance) {
    ASSERT_EQ(read.size(), planned.size());
    for (std::size_t k = 0; k < read.size(); ++k) {
        EXPECT_EQ(read[k].down, planned[k].down) << k;
        EXPECT_LT(apart(read[k].points, planned[k].points), tolerance) << "track " << k;
        EXPECT_LT(distance(read[k].points.front(), planned[k].points.front()), tolerance) << "start " << k;
        EXPECT_LT(distance(read[k].points.back(), planned[k].points.back()), tolerance) << "end " << k;
    }
}
constexpr double millimetre = 1e-3;
constexpr double by_degrees = 0.012;  ///< what 1e-7 degrees leave, and a millimetre of thinning

}  // namespace strandline::testing
