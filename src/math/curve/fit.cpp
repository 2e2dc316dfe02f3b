// A path as clothoid curves: joints are made smooth or left as corners, then every span is fitted by G1
// Hermite clothoids between points of the path, halved until the tolerance holds.
#include "math/curve/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace strandline {
namespace {

using fit::Span;

/// Headings this near are the same; what a metre gathers from it is a micrometre.
constexpr double same_heading = 1e-6;
/// Samples of a span that are measured against its clothoid. The error is zero with its slope at both ends,
/// so a few see its crests; the margin is for what lies between them.
constexpr int samples = 8;
constexpr double margin = 0.7;
/// A loop would pass for a near miss if the headings were not compared as well (radians).
constexpr double heading_slack = 0.6;
constexpr int deepest = 24;
/// A span shorter than this share of the tolerance may run anyhow: no feature of it can be seen.
constexpr double speck_share = 0.1;
/// Share of the tolerance by which a curve's integrated points may leave their places on the path.
constexpr double drift_share = 0.1;

/// What a joint between two spans becomes.
struct Joint {
    bool corner;
    double heading;
};

/// How far a line of that length bulges when its ends leave it by `turn` on both sides: a circular arc's
/// rise.
double bulge(double length, double turn) { return length / 2 * std::tan(std::abs(turn) / 2); }

Joint joint(const Span& before, const Span& after, const FitOptions& options) {
    const double jump = wrap_angle(after.heading0 - before.heading1);
    if (std::abs(jump) <= options.corner_angle) {
        if (before.exact != after.exact) return {false, before.exact ? before.heading1 : after.heading0};
        return {false, before.heading1 + jump / 2};
    }
    if (before.line && after.line && std::abs(jump) <= options.smooth_angle) {
        // The tangent of the circle through the three points.
        const double a = distance(before.p0, before.p1), b = distance(after.p0, after.p1);
        const double share = a / (a + b);
        if (bulge(a, share * jump) <= margin * options.tolerance &&
            bulge(b, (1 - share) * jump) <= margin * options.tolerance)
            return {false, before.heading1 + share * jump};
    }
    return {true, 0};
}

/// Whether the clothoid keeps to the span: each sample of the span has its foot on it, in order, near, and
/// looking the same way.
bool keeps_to(const Span& span, const Curve& curve, double tolerance) {
    const Clothoid& piece = curve.pieces.front();
    if (!std::isfinite(piece.length) || !std::isfinite(piece.curvature) || !std::isfinite(piece.sharpness) ||
        piece.length <= 0)
        return false;
    std::array<segments::Jet, samples> jets;
    std::array<double, samples> arcs;
    Point last = span.p0;
    double sum = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        const double share = static_cast<double>(i + 1) / samples;
        jets[i] = segments::jet(span.from, span.segment, span.t0 + share * (span.t1 - span.t0));
        arcs[i] = sum += distance(last, jets[i].at);
        last = jets[i].at;
    }
    if (sum <= 0 || piece.length > 2 * sum + tolerance) return false;
    if (sum <= speck_share * tolerance) return piece.length <= 4 * sum;
    double foot_before = 0;
    for (std::size_t i = 0; i + 1 < samples; ++i) {
        double s = arcs[i] / sum * piece.length;
        Pose foot = advanced(curve.start, piece, s);
        // Most guesses are near enough for one step along the tangent; two more for bad ones.
        double along = dot(jets[i].at - foot.at, unit(foot.heading));
        for (int k = 0; k < 3 && std::abs(along) > 0.02 * piece.length; ++k) {
            s = std::clamp(s + along, 0.0, piece.length);
            foot = advanced(curve.start, piece, s);
            along = dot(jets[i].at - foot.at, unit(foot.heading));
        }
        const double k = piece.curvature + piece.sharpness * s;
        const double across = cross(unit(foot.heading), jets[i].at - foot.at) - k * along * along / 2;
        if (std::abs(across) > margin * tolerance ||
            std::abs(along) > std::max(0.1 * piece.length, tolerance) || s + along < foot_before)
            return false;
        const double turned = foot.heading + k * along - heading(jets[i].velocity);
        if (length(jets[i].velocity) > 0 && std::abs(wrap_angle(turned)) > heading_slack) return false;
        foot_before = s + along;
    }
    return true;
}

/// The curves laid so far; the last one is open.
class Layer {
  public:
    explicit Layer(double tolerance) : tolerance_(tolerance) {}

    /// A corner: what follows starts a curve of its own.
    void cut() { open_ = false; }

    void add(Point from, double heading, Clothoid piece, Point to) {
        if (!(piece.length > 0)) return;
        if (!open_ || distance(end_.at, from) > drift_share * tolerance_) {
            end_ = {from, heading};
            curves.push_back({end_, {}});
            open_ = true;
        }
        curves.back().pieces.push_back(piece);
        end_ = advanced(end_, piece, piece.length);
        // The next piece starts from its own point; a piece that missed its end is not built upon.
        if (distance(end_.at, to) > drift_share * tolerance_) open_ = false;
    }

    std::vector<Curve> curves;

  private:
    double tolerance_;
    bool open_ = false;
    Pose end_;
};

void lay(const Span& span, bool own0, bool own1, double tolerance, int depth, Layer& layer) {
    const Pose a{span.p0, span.heading0}, b{span.p1, span.heading1};
    const double chord = distance(a.at, b.at);
    if (span.exact && own0 && own1) {
        const double share = span.t1 - span.t0;
        const double whole =
            span.line ? chord : std::abs(std::get<ArcSegment>(span.segment).sweep * share / span.curvature);
        layer.add(a.at, a.heading, {whole, span.curvature, 0}, b.at);
        return;
    }
    // A whole Bezier may loop; a half of one is tame enough for the test to see.
    if ((depth > 0 || span.exact) && chord > 0) {
        const Curve curve = hermite_clothoid(a, b);
        if (keeps_to(span, curve, tolerance)) {
            layer.add(a.at, a.heading, curve.pieces.front(), b.at);
            return;
        }
    }
    if (depth == deepest) {  // nothing smooth fits here: a straight with corners
        layer.cut();
        layer.add(a.at, heading(b.at - a.at), {chord, 0, 0}, b.at);
        layer.cut();
        return;
    }
    const double t = (span.t0 + span.t1) / 2;
    const segments::Jet middle = segments::jet(span.from, span.segment, t);
    const double own = length(middle.velocity) > 0 ? heading(middle.velocity) : heading(b.at - a.at);
    Span first = span, second = span;
    first.t1 = second.t0 = t;
    first.p1 = second.p0 = middle.at;
    first.heading1 = second.heading0 = own;
    lay(first, own0, true, tolerance, depth + 1, layer);
    lay(second, true, own1, tolerance, depth + 1, layer);
}

}  // namespace

std::vector<Curve> fitted(const Path& path, const FitOptions& options) {
    std::vector<Span> spans = fit::spans(path, options.tolerance);
    if (spans.empty()) return {};
    std::vector<Span> shared = spans;
    std::vector<bool> corner_after(spans.size(), true);
    const bool meets =
        path.closed && distance(spans.back().p1, spans.front().p0) <= drift_share * options.tolerance;
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const std::size_t next = (i + 1) % spans.size();
        if (next == 0 && !meets) continue;
        const Joint made = joint(spans[i], spans[next], options);
        corner_after[i] = made.corner;
        if (!made.corner) shared[i].heading1 = shared[next].heading0 = made.heading;
    }
    const auto same = [](double a, double b) { return std::abs(wrap_angle(a - b)) <= same_heading; };
    Layer layer(options.tolerance);
    for (std::size_t i = 0; i < spans.size(); ++i) {
        lay(shared[i], same(shared[i].heading0, spans[i].heading0),
            same(shared[i].heading1, spans[i].heading1), options.tolerance, 0, layer);
        if (corner_after[i]) layer.cut();
    }
    return layer.curves;
}

}  // namespace strandline
