#pragma once
// Private to the room: passes that keep their centre line off sand that earlier ones have raked.
#include <cstdint>
#include <unordered_map>

#include "path/fill/passes.hpp"

namespace strandline::fill {

/// All lines raked so far, by the travel at which each place was raked.
class Trail {
  public:
    /// `room`: where the centre of the rake may be.
    Trail(const Regions& room, const Options& options) : room_(room), width_(options.width) {}

    /// The line, pushed away where it runs on the sand of earlier lines or of its own: to just beside their
    /// edge, on the side where it lies. What it no longer rakes there is raked already, and what it rakes
    /// beyond is left for it by the next pass, so as much is raked as before. Stretches that cross raked
    /// sand, are squeezed between two raked passes or would leave the room stay. O(length / width x passes
    /// near by).
    Polyline kept_off(const Polyline& line) const;
    /// Raked after a lifted way from where the last one ended.
    void add(const Polyline& line);

  private:
    struct Edge {
        Point from, to;
        double travelled;  // at its start
        bool first, last;  // of its line: nothing is raked beyond its flat end
    };
    struct Near {
        Point at;
        double distance;
        double keep;  // the distance to be kept
    };
    using Cells = std::unordered_map<std::uint64_t, std::vector<Edge>>;

    void enter(const Polyline& line, double travelled, Cells& cells) const;
    /// What is nearest in its own measure: distance less what is to be kept.
    std::optional<Near> near(const Cells& own, Point p, double travelled) const;
    std::uint64_t cell(Point p) const;

    AreaIndex room_;
    double width_;
    Cells raked_;
    double travelled_ = 0;
    std::optional<Point> end_;
};

}  // namespace strandline::fill
