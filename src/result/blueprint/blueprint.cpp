#include "result/blueprint/blueprint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text/text.hpp"

namespace strandline::blueprint {
namespace {

constexpr double page = 640;          // user units: width of the picture, and height of the drawing in it
constexpr double margin = 40;         // around the drawing
constexpr double line = 22;           // from one line of words to the next
constexpr double widest_turn = 4;     // of the machine's size: wider turns are drawn in part
constexpr double groove_share = 0.5;  // of the machine's size: how far grooves are drawn behind the rake
constexpr double wheel_length = 2.5;  // of its width: a profile does not say
constexpr const char *sand = "#efe3c8", *body = "#1b4f9c", *groove = "#8a7350", *turns = "#d3261a";

/// "0.45 m", "16 cm", "0.5 mm": as people say it.
std::string metric(double metres) {
    const double size = std::abs(metres);
    if (size >= 1 || size == 0) return fmt::format("{:.3g} m", metres);
    return size >= 0.01 ? fmt::format("{:.3g} cm", 100 * metres) : fmt::format("{:.3g} mm", 1000 * metres);
}

class Drawing {
  public:
    explicit Drawing(const Robot& robot) : robot_(robot) {
        const Point rake{-robot.rake_offset, robot.rake_side};
        const double bar = robot.rake_width() / 2;
        Box box = bounds({{robot.front, robot.half_width},
                          {-robot.back, -robot.half_width},
                          rake + Point{0, bar},
                          rake - Point{0, bar},
                          {0, 0}});
        for (const Wheel& wheel : robot.wheels) {
            const Point half{wheel_length * wheel.width / 2, wheel.width / 2};
            box = bounds({box.low, box.high, wheel.at - half, wheel.at + half});
        }
        size_ = std::max(box.width(), box.height());
        box = bounds({box.low, box.high, {rake.x - groove_share * size_, rake.y}});
        for (const auto& [side, radius] : sides()) {
            const double drawn = std::min(radius, widest_turn * size_);
            box = bounds({box.low, box.high, {drawn, side * drawn}});
        }
        view_ = box;
        scale_ = (page - 2 * margin) / std::max(view_.width(), view_.height());
    }

    std::string svg() {
        const std::vector<std::string> words = in_words();
        const double height =
            margin + scale_ * view_.width() + margin + line * (static_cast<double>(words.size()) + 1);
        text_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1:.0f}\" width=\"{0}\" "
            "height=\"{1:.0f}\" "
            "font-family=\"sans-serif\" font-size=\"15\">\n<rect width=\"100%\" height=\"100%\" "
            "fill=\"{2}\"/>\n",
            page, height, sand);
        grooves();
        turns_of_both_sides();
        machine();
        double y = margin + scale_ * view_.width() + margin;
        for (const std::string& sentence : words) {
            text_ += fmt::format("<text x=\"{}\" y=\"{:.1f}\">", margin, y);
            add_xml(text_, sentence);
            text_ += "</text>\n";
            y += line;
        }
        return text_ + "</svg>\n";
    }

  private:
    /// Which way (1: left), and the least radius there; none where turning is free.
    std::vector<std::pair<double, double>> sides() const {
        if (robot_.min_radius <= 0) return {};
        return {{1, least_radius(robot_, 1)}, {-1, least_radius(robot_, -1)}};
    }
    std::string at(Point p) const {
        const double across = (page - scale_ * view_.height()) / 2;
        return fmt::format("{:.1f} {:.1f}", across + scale_ * (view_.high.y - p.y),
                           margin + scale_ * (view_.high.x - p.x));
    }
    void path(const std::vector<Point>& points, bool closed, const std::string& style) {
        text_ += "<path d=\"";
        const char* command = "M";
        for (Point p : points) {
            text_ += command;
            text_ += at(p);
            command = "L";
        }
        text_ += fmt::format("{}\" {}/>\n", closed ? "Z" : "", style);
    }
    void rectangle(Point low, Point high, const std::string& style) {
        path({low, {high.x, low.y}, high, {low.x, high.y}}, true, style);
    }

    void grooves() {
        const double end = -robot_.rake_offset - groove_share * size_;
        for (int pin = 0; pin < robot_.pins; ++pin) {
            const double y = pin_y(pin), half = 0.42 * robot_.pin_pitch;
            rectangle({end, y - half}, {-robot_.rake_offset, y + half},
                      fmt::format("fill=\"{}\" fill-opacity=\"0.45\"", groove));
        }
    }
    double pin_y(int pin) const {
        return robot_.rake_side + ((robot_.pins - 1) / 2.0 - pin) * robot_.pin_pitch;
    }
    void turns_of_both_sides() {
        constexpr int chords = 32;
        for (const auto& [side, radius] : sides()) {
            const double reach = std::min(pi / 2, widest_turn * size_ / radius);
            std::vector<Point> arc;
            for (int i = 0; i <= chords; ++i) {
                const double turn = reach * i / chords;
                arc.push_back({radius * std::sin(turn), side * radius * (1 - std::cos(turn))});
            }
            path(arc, false,
                 fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\" stroke-dasharray=\"7 5\"",
                             turns));
        }
    }
    void machine() {
        const std::string outline = fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\"", body);
        rectangle({-robot_.back, -robot_.half_width}, {robot_.front, robot_.half_width}, outline);
        for (const Wheel& wheel : robot_.wheels) {
            const Point half{wheel_length * wheel.width / 2, wheel.width / 2};
            rectangle(wheel.at - half, wheel.at + half, "fill=\"#444\"");
        }
        const Point rake{-robot_.rake_offset, robot_.rake_side};
        if (robot_.rake_offset > 0) path({{0, 0}, {0, rake.y}, rake}, false, outline);
        if (robot_.pins > 1) path({{rake.x, pin_y(0)}, {rake.x, pin_y(robot_.pins - 1)}}, false, outline);
        for (int pin = 0; pin < robot_.pins; ++pin) dot({rake.x, pin_y(pin)}, 4, "#000");
        dot({0, 0}, 6, body);
    }
    void dot(Point p, double radius, const char* colour) {
        const std::string place = at(p);
        const std::size_t gap = place.find(' ');
        text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", place.substr(0, gap),
                             place.substr(gap + 1), radius, colour);
    }

    std::vector<std::string> in_words() const {
        const Robot& r = robot_;
        std::vector<std::string> words;
        words.push_back(
            fmt::format("{}: {} long, {} wide", r.name, metric(r.front + r.back), metric(2 * r.half_width)));
        words.push_back(r.pins == 1 ? fmt::format("one tool, {} wide", metric(r.pin_pitch))
                                    : fmt::format("{} pins, {} apart: rakes {}", r.pins, metric(r.pin_pitch),
                                                  metric(r.rake_width())));
        words.back() += r.rake_offset > 0
                            ? fmt::format("; {} behind the turning point", metric(r.rake_offset))
                            : "; at the turning point";
        if (r.rake_side != 0)
            words.back() += fmt::format(", {} to the {}", metric(std::abs(r.rake_side)),
                                        r.rake_side > 0 ? "left" : "right");
        if (r.min_radius <= 0) {
            words.emplace_back("turns on the spot freely");
        } else {
            const double left = least_radius(r, 1), right = least_radius(r, -1);
            words.push_back(left == right ? fmt::format("least radius {}", metric(left))
                                          : fmt::format("least radius {} to the left, {} to the right",
                                                        metric(left), metric(right)));
            words.back() += r.can_pivot ? "; can turn on the spot" : "; cannot turn on the spot";
        }
        words.push_back(fmt::format("{}/s drawing, {}/s between strokes, {:.4g} rad/s at most",
                                    metric(r.speed), metric(r.travel_speed), r.turn_rate));
        words.push_back(!r.lifts           ? "the tool is always down"
                        : r.lift_delay > 0 ? fmt::format("the tool takes {:.3g} s up or down", r.lift_delay)
                                           : "the tool goes up and down at once");
        return words;
    }

    const Robot& robot_;
    Box view_;  // of the body frame: x ahead, y left
    double size_ = 0, scale_ = 1;
    Text text_;
};

}  // namespace

std::string write_svg(const Robot& robot) { return Drawing(robot).svg(); }

}  // namespace strandline::blueprint
