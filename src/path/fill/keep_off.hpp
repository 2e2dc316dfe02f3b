#pragma once
// Private to the room: passes, and ways between them, that keep off sand that earlier ones have raked.
#include <cstdint>
#include <unordered_map>

#include "path/fill/lattice.hpp"

namespace strandline::fill {

/// All lines raked so far, by the travel at which each place was raked.
class Trail {
  public:
    /// `room`: where the centre of the rake may be. `lattice`: nothing in it is raked yet.
    Trail(Lattice lattice, const Regions& room, const Options& options);
    const Lattice& lattice() const { return lattice_; }

    /// The line, pushed away where it runs on the sand of earlier lines or of its own: to just beside their
    /// edge, on the side where it lies. What it no longer rakes there is raked already, and what it rakes
    /// beyond is left for it by the next pass, so as much is raked as before. Stretches that cross raked
    /// sand, are squeezed between two raked passes or would leave the room stay, and so do all where pins are
    /// lifted over raked sand, and in areas whose box is more than `largest_fine`. O(length / width x passes
    /// near by).
    Polyline kept_off(const Polyline& line) const;
    /// The way from the end of the last line to a point: that of the lattice, over which the end of the line
    /// is no obstacle: what was raked just now is not finished yet.
    Polyline way_to(Point p) const { return way(lattice_, *end_, p); }
    bool raked(Point p) const;
    void add(const Polyline& line);

  private:
    /// The flat end of a line near by: nothing is raked beyond it.
    struct End {
        Point at, beyond;  // beyond: a unit vector; zero: none is near
    };
    struct Edge {
        Point from, to;
        double travelled;  // at its start
        End start, end;    // of its line
    };
    struct Near {
        Point at;
        double distance;
        double keep;  // the distance to be kept
    };
    struct Edges {
        std::vector<Edge> all;
        std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> near;  // by cells of a width
    };

    void enter(const Polyline& line, double travelled, Edges& edges) const;
    /// What is nearest in its own measure: distance less what is to be kept.
    std::optional<Near> near(const Edges& own, Point p, double travelled) const;
    std::uint64_t cell(Point p) const;

    Lattice lattice_;  // without the latest
    AreaIndex room_;
    Options options_;
    double width_;
    bool watched_;  // whether lines are kept off and known for it
    Edges raked_;
    Polyline latest_;
    double travelled_ = 0;
    std::optional<Point> end_;
};

}  // namespace strandline::fill
