// The painter's model. What a shape does to the sheet below it is a pair: it hides H and adds ink I,
// C -> (C - H) + I. Two of them one after the other are such a pair again, (H1 + H2, (I1 - H2) + I2), so the
// shapes are laid together in a balanced tree instead of one by one on an ever larger sheet.
#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "input/drawing/parts.hpp"

namespace strandline::drawing_parts {
namespace {

/// Lines along an outline are not under it: they are cut this many tolerances inside.
constexpr double off_the_edge = 2;

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// An area, and the shape that its element is named after.
struct Piece {
    Region region;
    std::size_t shape;
    Box box;
};
struct Line {
    Path path;
    std::size_t shape, subpath;
    Box box;
};
struct Sheet {
    std::vector<Piece> ink, hides;
    std::vector<Line> lines;
};

std::vector<Piece> pieces_of(Regions regions, std::size_t shape) {
    std::vector<Piece> pieces;
    pieces.reserve(regions.size());
    for (Region& region : regions) {
        const Box box = bounds(region);
        pieces.push_back({std::move(region), shape, box});
    }
    return pieces;
}

/// visit(i, j) for every a[i] and b[j] whose boxes overlap: a sweep over their left sides.
template <class A, class B, class Visit>
void for_overlapping(const std::vector<A>& a, const std::vector<B>& b, Visit visit) {
    const auto by_left = [](const auto& items) {
        std::vector<std::size_t> order(items.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(items[i].box.low.x, i); });
        return order;
    };
    const std::vector<std::size_t> order_a = by_left(a), order_b = by_left(b);
    std::vector<std::size_t> open_a, open_b;
    const auto close = [](std::vector<std::size_t>& open, const auto& items, double x) {
        std::erase_if(open, [&](std::size_t i) { return items[i].box.high.x < x; });
    };
    std::size_t i = 0, j = 0;
    while (i < a.size() || j < b.size()) {
        const bool from_a =
            j == b.size() || (i < a.size() && a[order_a[i]].box.low.x <= b[order_b[j]].box.low.x);
        if (from_a) {
            const std::size_t here = order_a[i++];
            close(open_b, b, a[here].box.low.x);
            for (const std::size_t other : open_b)
                if (overlaps(a[here].box, b[other].box)) visit(here, other);
            open_a.push_back(here);
        } else {
            const std::size_t here = order_b[j++];
            close(open_a, a, b[here].box.low.x);
            for (const std::size_t other : open_a)
                if (overlaps(a[other].box, b[here].box)) visit(other, here);
            open_b.push_back(here);
        }
    }
}

/// Whether areas whose boxes overlap may meet: not where the box of one lies wholly outside the other, as
/// with rings in rings. Their indices are built when first asked for.
class Meeting {
  public:
    Meeting(const std::vector<Piece>& a, const std::vector<Piece>& b)
        : a_(a), b_(b), index_a_(a.size()), index_b_(b.size()) {}
    bool possible(std::size_t i, std::size_t j) {
        return index(index_a_[i], a_[i]).cover_of(b_[j].box) != AreaIndex::Cover::outside &&
               index(index_b_[j], b_[j]).cover_of(a_[i].box) != AreaIndex::Cover::outside;
    }

  private:
    static const AreaIndex& index(std::optional<AreaIndex>& held, const Piece& piece) {
        if (!held) held.emplace(Regions{piece.region});
        return *held;
    }
    const std::vector<Piece>&a_, &b_;
    std::vector<std::optional<AreaIndex>> index_a_, index_b_;
};

/// Numbers that belong together (union-find, by halving the way up).
class Groups {
  public:
    explicit Groups(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t of(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t i, std::size_t j) {
        const std::size_t a = of(i), b = of(j);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> parent_;
};

/// Each part of the union belongs to the earliest shape that a part of went into it.
std::vector<Piece> united_pieces(const std::vector<const Piece*>& below,
                                 const std::vector<const Piece*>& above) {
    const auto regions_of = [](const std::vector<const Piece*>& pieces) {
        Regions regions;
        for (const Piece* piece : pieces) regions.push_back(piece->region);
        return regions;
    };
    std::vector<Piece> whole = pieces_of(united(regions_of(below), regions_of(above)), none);
    std::size_t earliest = none;
    for (const auto* side : {&below, &above})
        for (const Piece* piece : *side) {
            earliest = std::min(earliest, piece->shape);
            const Point inside = point_inside(piece->region);
            for (Piece& part : whole)
                if (contains(part.box, inside) && contains(part.region, inside))
                    part.shape = std::min(part.shape, piece->shape);
        }
    // a part so thin that no piece's point lies in it by the grid's rounding
    for (Piece& part : whole)
        if (part.shape == none) part.shape = earliest;
    return whole;
}

/// Both, and what overlaps and may become one made one. `merged` counts the pieces that went into others.
template <class May>
std::vector<Piece> merged_pieces(std::vector<Piece> below, std::vector<Piece> above, int* merged, May may) {
    Groups groups(below.size() + above.size());
    std::vector<char> meets(below.size() + above.size(), 0);
    Meeting meeting(below, above);
    for_overlapping(below, above, [&](std::size_t i, std::size_t j) {
        if (!may(below[i], above[j]) || !meeting.possible(i, j)) return;
        groups.join(i, below.size() + j);
        meets[i] = meets[below.size() + j] = 1;
    });
    std::vector<Piece> all;
    struct Group {
        std::vector<const Piece*> below, above;
    };
    std::vector<Group> met(meets.size());
    for (std::size_t k = 0; k < meets.size(); ++k) {
        Piece& piece = k < below.size() ? below[k] : above[k - below.size()];
        if (meets[k] == 0) {
            all.push_back(std::move(piece));
            continue;
        }
        Group& group = met[groups.of(k)];
        (k < below.size() ? group.below : group.above).push_back(&piece);
    }
    for (const Group& group : met) {
        if (group.below.empty()) continue;
        std::vector<Piece> whole = united_pieces(group.below, group.above);
        if (merged != nullptr)
            *merged += std::max(0, static_cast<int>(group.below.size() + group.above.size()) -
                                       static_cast<int>(whole.size()));
        std::ranges::move(whole, std::back_inserter(all));
    }
    std::ranges::stable_sort(all, {}, &Piece::shape);
    return all;
}

class Painter {
  public:
    Painter(std::vector<Painted>& shapes, double tolerance, DrawingCounts& counts, const Progress& progress)
        : shapes_(shapes), tolerance_(tolerance), counts_(counts), progress_(progress) {}

    Sheet sheet(std::size_t first, std::size_t end) {
        if (end - first == 1) return sheet_of(first);
        const std::size_t middle = first + (end - first) / 2;
        Sheet below = sheet(first, middle);
        return laid_together(std::move(below), sheet(middle, end), first == 0);
    }

  private:
    Sheet sheet_of(std::size_t shape) {
        progress_.report("occlusion", static_cast<double>(shape) / static_cast<double>(shapes_.size()));
        Painted& painted = shapes_[shape];
        Sheet sheet{
            pieces_of(std::move(painted.area), shape), pieces_of(std::move(painted.hides), shape), {}};
        for (InkLine& line : painted.lines) {
            const Box box = bounds(line.path);
            sheet.lines.push_back({std::move(line.path), shape, line.subpath, box});
        }
        painted.area.clear();
        painted.lines.clear();
        return sheet;
    }

    Sheet laid_together(Sheet below, Sheet above, bool lowest) {
        Sheet whole;
        whole.lines = uncovered(std::move(below.lines), above);
        std::ranges::move(above.lines, std::back_inserter(whole.lines));
        std::vector<Piece> left = erased(std::move(below.ink), above);
        const auto may = [&](const Piece& a, const Piece& b) { return alike(a, b); };
        whole.ink = merged_pieces(std::move(left), std::move(above.ink), &counts_.merged, may);
        // nothing lies under the lowest sheet
        const auto always = [](const Piece&, const Piece&) { return true; };
        if (!lowest)
            whole.hides = merged_pieces(std::move(below.hides), std::move(above.hides), nullptr, always);
        return whole;
    }

    /// May they become one?
    bool alike(const Piece& a, const Piece& b) const {
        const Painted &p = shapes_[a.shape], &q = shapes_[b.shape];
        return p.section == q.section && p.hints == q.hints;
    }

    /// What the sheet above leaves of the ink: its bare paint hides, and so does ink of other hints.
    std::vector<Piece> erased(std::vector<Piece> ink, const Sheet& above) {
        std::vector<Regions> over(ink.size());
        Meeting with_hides(ink, above.hides);
        for_overlapping(ink, above.hides, [&](std::size_t i, std::size_t j) {
            if (with_hides.possible(i, j)) over[i].push_back(above.hides[j].region);
        });
        for_overlapping(ink, above.ink, [&](std::size_t i, std::size_t j) {
            if (!alike(ink[i], above.ink[j])) over[i].push_back(above.ink[j].region);
        });
        std::vector<Piece> left;
        for (std::size_t i = 0; i < ink.size(); ++i) {
            if (over[i].empty()) {
                left.push_back(std::move(ink[i]));
                continue;
            }
            Regions rest = subtracted({ink[i].region}, over[i]);
            constexpr double untouched = 1 - 1e-9;
            if (area(rest) >= untouched * area(ink[i].region)) {
                left.push_back(std::move(ink[i]));
                continue;
            }
            // Two outlines that nearly agree leave slivers that nothing can rake; what was thin before stays.
            const auto thin = [&](const Region& region) { return inset({region}, tolerance_).empty(); };
            if (!thin(ink[i].region)) std::erase_if(rest, thin);
            if (rest.empty()) ++counts_.hidden;
            std::ranges::move(pieces_of(std::move(rest), ink[i].shape), std::back_inserter(left));
        }
        return left;
    }

    /// The parts of the lines that no area of the sheet above lies on.
    std::vector<Line> uncovered(std::vector<Line> lines, const Sheet& above) {
        std::vector<char> met(lines.size(), 0), covers(above.ink.size() + above.hides.size(), 0);
        for_overlapping(lines, above.ink, [&](std::size_t i, std::size_t j) { met[i] = covers[j] = 1; });
        for_overlapping(lines, above.hides,
                        [&](std::size_t i, std::size_t j) { met[i] = covers[above.ink.size() + j] = 1; });
        Regions ink, hides;
        for (std::size_t k = 0; k < covers.size(); ++k) {
            if (covers[k] == 0) continue;
            if (k < above.ink.size())
                ink.push_back(above.ink[k].region);
            else
                hides.push_back(above.hides[k - above.ink.size()].region);
        }
        if (ink.empty() && hides.empty()) return lines;
        const AreaIndex cover(inset(united(ink, hides), off_the_edge * tolerance_));
        std::vector<Line> left;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (met[i] == 0 || cover.cover_of(lines[i].box) == AreaIndex::Cover::outside) {
                left.push_back(std::move(lines[i]));
                continue;
            }
            PathParts parts = cover.parted(lines[i].path, tolerance_);
            if (parts.outside.empty())
                ++counts_.hidden;
            else if (!parts.inside.empty())
                ++counts_.cut;
            for (Path& part : parts.outside) {
                const Box box = bounds(part);
                left.push_back({std::move(part), lines[i].shape, lines[i].subpath, box});
            }
        }
        return left;
    }

    std::vector<Painted>& shapes_;
    double tolerance_;
    DrawingCounts& counts_;
    const Progress& progress_;
};

}  // namespace

void occlude(std::vector<Painted>& shapes, double tolerance, DrawingCounts& counts,
             const Progress& progress) {
    if (shapes.empty()) return;
    Sheet sheet = Painter(shapes, tolerance, counts, progress).sheet(0, shapes.size());
    for (Piece& piece : sheet.ink) shapes[piece.shape].area.push_back(std::move(piece.region));
    for (Line& line : sheet.lines) shapes[line.shape].lines.push_back({line.subpath, std::move(line.path)});
}

}  // namespace strandline::drawing_parts
