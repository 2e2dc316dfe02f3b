// G-code: the words G0, G1, X, Y, F of RS274/NGC (Kramer, Proctor, Messina, NISTIR 6556, 2000), everything
// else by template. Millimetres from the canvas's lower left corner.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "base/text/text.hpp"
#include "base/units/units.hpp"
#include "result/exports/spans.hpp"

namespace strandline::exports {
namespace {

constexpr int millimetre_decimals = 3;
constexpr double thinned_by = 2e-5;  // m: finer than any such machine moves
constexpr double same_place = 1e-6;  // m

using Values = std::map<std::string, std::string>;

/// What stands in a comment: no brackets, which would end it, and no second line.
std::string plain(std::string text) {
    for (char& c : text)
        if (c == '(' || c == ')' || static_cast<unsigned char>(c) < ' ') c = ' ';
    return text;
}

/// {name} for its value, \n for a new line. Error: a name that is not known, a bracket without the other.
Outcome<std::string> filled(const std::string& setting, const std::string& pattern, const Values& values) {
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern.compare(i, 2, "\\n") == 0) {
            text += '\n';
            ++i;
        } else if (pattern[i] == '{') {
            const std::size_t end = pattern.find('}', i);
            const std::string name =
                end == std::string::npos ? pattern.substr(i) : pattern.substr(i + 1, end - i - 1);
            const auto value = values.find(name);
            if (end == std::string::npos || value == values.end()) {
                std::vector<std::string> known;
                for (const auto& [key, unused] : values) known.push_back("{" + key + "}");
                return fail(setting, fmt::format("\"{}\" stands for nothing here", name),
                            fmt::format("use {}", fmt::join(known, ", ")));
            }
            text += value->second;
            i = end;
        } else {
            text += pattern[i];
        }
    }
    return text;
}

/// The templates of a plan, those without a place of their own filled in already.
struct Templates {
    std::string begin, down, up, end;
    bool end_lifts = false;  ///< the first thing it does: no other lift is needed before it
};
Outcome<Templates> templates_of(const Plan& plan, const std::string& feed) {
    const Options::Gcode& o = plan.options.gcode;
    Templates t;
    const int first = plan.strokes.empty() ? -1 : 0;
    Values values{{"title", plain(plan.title)}, {"feed", feed}, {"tool", hint_of(plan, first, "tool", "1")}};
    const auto fill = [&](const char* name, const std::string& pattern, std::string& to) -> Outcome<void> {
        auto text = filled(std::string("gcode.") + name, pattern, values);
        if (!text) return tl::unexpected(text.error());
        to = std::move(*text);
        values[name] = to;
        return {};
    };
    auto done = fill("up", o.up, t.up);
    if (done) done = fill("down", o.down, t.down);
    if (done) done = fill("begin", o.begin, t.begin);
    if (done) done = fill("end", o.end, t.end);
    if (!done) return tl::unexpected(done.error());
    t.end_lifts = o.end.starts_with("{up}");
    return t;
}

class Program {
  public:
    explicit Program(Templates templates) : templates_(std::move(templates)) {}

    void block(const std::string& text) {
        add(text_, text);
        if (!text.empty() && text.back() != '\n') add(text_, "\n");
    }
    void move(const char* word, Point at) {
        constexpr double millimetres = 1000;
        add(text_, word);
        add(text_, " X");
        add_fixed(text_, millimetres * at.x, millimetre_decimals);
        add(text_, " Y");
        add_fixed(text_, millimetres * at.y, millimetre_decimals);
    }
    void line(const Polyline& track, const std::string& feed) {
        if (!down_ || distance(at_, track.front()) > same_place) {
            lift();
            move("G0", track.front());
            add(text_, "\n");
            block(templates_.down);
            down_ = true;
            feed_due_ = true;
        }
        for (std::size_t i = 1; i < track.size(); ++i) {
            move("G1", track[i]);
            if (feed_due_) add(text_, " F" + feed);
            feed_due_ = false;
            add(text_, "\n");
        }
        at_ = track.back();
    }
    void lift() {
        if (down_) block(templates_.up);
        down_ = false;
    }
    std::string done() {
        if (!templates_.end_lifts) lift();
        block(templates_.end);
        return std::move(text_);
    }

  private:
    Templates templates_;
    Text text_;
    Point at_;
    bool down_ = false, feed_due_ = true;
};

Polyline track_of(const Plan& plan, const Span& span) {
    const Polyline all = tool_track(plan, span);
    Polyline kept;
    for (const std::size_t i : thinned(all, thinned_by)) kept.push_back(all[i]);
    return kept;
}

}  // namespace

Outcome<Written> gcode(const Plan& plan) {
    constexpr double mm_per_min = 60'000;  // a metre a second
    const Options::Gcode& o = plan.options.gcode;
    const std::string feed = number_text(o.feed > 0 ? o.feed : std::round(mm_per_min * plan.robot.speed));
    auto templates = templates_of(plan, feed);
    if (!templates) return tl::unexpected(templates.error());
    Program program(*templates);
    program.block(templates->begin);
    const auto stops = stop_samples(plan, plan.samples);
    std::size_t stopped = 0;
    for (const Span& span : spans_of(plan.samples)) {
        if (!span.down) continue;
        for (; stopped < stops.size() && stops[stopped] <= span.first; ++stopped) {
            program.lift();
            const Stop& stop = plan.stops[stopped];
            const Element* element = element_of(plan, stop.stroke);
            const auto text = filled("gcode.stop", o.stop,
                                     {{"why", plain(stop.why)},
                                      {"tool", hint_of(plan, stop.stroke, "tool", "1")},
                                      {"layer", element ? plain(element->layer) : ""},
                                      {"up", templates->up},
                                      {"down", templates->down}});
            if (!text) return tl::unexpected(text.error());
            program.block(*text);
        }
        program.line(track_of(plan, span), feed);
    }
    Written written{{{".gcode", program.done()}}, {}};
    if (plan.robot.pins > 1)
        written.warnings.push_back(
            {"gcode", fmt::format("one tool draws what {} pins do: widths are lost", plan.robot.pins)});
    return written;
}

}  // namespace strandline::exports
