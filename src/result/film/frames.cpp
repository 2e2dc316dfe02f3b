// A drive as pictures: the sand is painted on where something happened, the robot on top.
#include <algorithm>
#include <cmath>

#include "result/film/film.hpp"

namespace strandline::film {
namespace {

constexpr shade::Rgb body{58, 74, 92}, nose{214, 84, 52}, tyre{24, 24, 26}, bar{88, 92, 98}, pin{20, 20, 20};

std::vector<Point> box_of(Pose pose, double back, double front, double right, double left) {
    const Point ahead = unit(pose.heading), aside = left_normal(ahead);
    const auto at = [&](double x, double y) { return pose.at + x * ahead + y * aside; };
    return {at(back, right), at(front, right), at(front, left), at(back, left)};
}

/// The robot to scale: body, wheels, nose, the rake with its lowered pins.
void paint_robot(shade::Image& image, const shade::View& view, const Robot& robot, const Sample& sample) {
    const Pose pose = sample.pose;
    shade::paint(image, view, box_of(pose, -robot.back, robot.front, -robot.half_width, robot.half_width),
                 body);
    shade::paint(image, view,
                 box_of(pose, 0.8 * robot.front, robot.front, -robot.half_width / 2, robot.half_width / 2),
                 nose);
    for (const Wheel& wheel : robot.wheels)
        shade::paint(image, view,
                     box_of({pose.at, pose.heading}, wheel.at.x - wheel.width, wheel.at.x + wheel.width,
                            wheel.at.y - wheel.width / 2, wheel.at.y + wheel.width / 2),
                     tyre);
    const Pose rake{sample.rake, pose.heading};
    const double pitch = robot.pin_pitch, edge = robot.rake_width() / 2;
    shade::paint(image, view, box_of(rake, -pitch / 4, pitch / 4, -edge, edge), bar);
    for (int k = 0; k < robot.pins; ++k) {
        if ((sample.mask >> k & 1U) == 0) continue;
        const double right = k * pitch - edge;
        shade::paint(image, view,
                     box_of(rake, -pitch / 3, pitch / 3, right + pitch / 5, right + 4 * pitch / 5), pin);
    }
}

Box reach_of(const Robot& robot, const Sample& sample) {
    double reach = std::hypot(std::max(robot.front, robot.back), robot.half_width) + robot.rake_width();
    for (const Wheel& wheel : robot.wheels) reach = std::max(reach, length(wheel.at) + wheel.width);
    return grown(including(Box{sample.pose.at, sample.pose.at}, sample.rake), reach);
}

}  // namespace

void for_frames(const surface::Drive& drive, const shade::View& view, const Options& options,
                const std::function<bool(const Frame&)>& what) {
    const std::vector<Sample>& samples = drive.samples;
    surface::Options laying;
    laying.cell = options.cell;
    laying.within = grown(view.box, 10 * drive.robot.rake_width());
    surface::Layer layer(drive, laying);
    shade::Image sand = shade::sand(layer.surface(), view);
    const int count = std::max(2, static_cast<int>(std::lround(options.seconds * options.rate)));
    const double time = samples.empty() ? 0 : samples.back().t;
    Box robot_was;
    std::size_t at = 0;
    for (int k = 0; k <= count; ++k) {
        Box changed = robot_was;
        const std::size_t from = at;
        while (at + 1 < samples.size() && samples[at + 1].t <= time * k / count) ++at;
        layer.lay_to(k < count ? at : samples.size());
        Box laid;
        for (std::size_t i = from; i <= at && i < samples.size(); ++i)
            laid = united(laid, reach_of(drive.robot, samples[i]));
        Frame frame;
        frame.last = k == count;
        if (!laid.empty()) {
            shade::repaint(sand, layer.surface(), view, laid);
            changed = united(changed, laid);
        }
        frame.image = sand;
        if (!frame.last && at < samples.size()) {
            paint_robot(frame.image, view, drive.robot, samples[at]);
            robot_was = reach_of(drive.robot, samples[at]);
        }
        if (k == 0) changed = view.box;
        const Point upper = view.in_pixels({changed.low.x, changed.high.y});
        const Point lower = view.in_pixels({changed.high.x, changed.low.y});
        const auto pixel = [](double x, int most) {
            return static_cast<int>(std::clamp(std::floor(x), 0.0, static_cast<double>(most)));
        };
        frame.left = changed.empty() ? 0 : pixel(upper.x - 2, frame.image.columns - 1);
        frame.top = changed.empty() ? 0 : pixel(upper.y - 2, frame.image.rows - 1);
        frame.right = changed.empty() ? 1 : std::max(frame.left + 1, pixel(lower.x + 3, frame.image.columns));
        frame.bottom = changed.empty() ? 1 : std::max(frame.top + 1, pixel(lower.y + 3, frame.image.rows));
        if (!what(frame)) return;
    }
}

}  // namespace strandline::film
