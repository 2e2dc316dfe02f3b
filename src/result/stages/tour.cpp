// A tour instance and its solution (docs/stage-formats.md).
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>

#include "result/stages/stages.hpp"

namespace strandline::stages {
namespace {

using Json = nlohmann::json;

/// "FILE, line 3, column 7" of a byte.
std::string text_place(const std::string& file, std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t last = before.rfind('\n');
    return fmt::format("{}, line {}, column {}", file, line,
                       before.size() - (last == std::string_view::npos ? 0 : last + 1) + 1);
}

/// Reads the fields one after another; the first error stays and the rest is skipped.
class Reader {
  public:
    Reader(const Json& root, const std::string& file) : root_(root), file_(file) {}

    Outcome<Instance> run() {
        if (!root_.is_object())
            wrong("", "is not a JSON object", "write {\"start\": null, \"elements\": [...]}");
        else
            read_all();
        if (error_) return tl::unexpected(*error_);
        for (const auto& [key, place] : unknown_)
            instance_.warnings.push_back({place, fmt::format("unknown key \"{}\" is ignored", key)});
        return std::move(instance_);
    }

  private:
    void wrong(const std::string& where, std::string reason, std::string remedy) {
        if (error_) return;
        error_ = Error{where.empty() ? file_ : file_ + ", " + where, std::move(reason), std::move(remedy)};
    }

    void known(const Json& object, const std::string& where, std::initializer_list<const char*> keys) {
        for (const auto& item : object.items())
            if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
                unknown_.try_emplace(item.key(), where.empty() ? file_ : file_ + ", " + where);
    }

    Point point(const Json& json, const std::string& where) {
        if (!json.is_array() || json.size() != 2 || !json[0].is_number() || !json[1].is_number()) {
            wrong(where, "is not a point", "write [x, y]");
            return {};
        }
        return {json[0].get<double>(), json[1].get<double>()};
    }

    int number(const Json& json, const std::string& where) {
        if (!json.is_number_integer() || json.get<double>() < 0 || json.get<double>() > 1e9) {
            wrong(where, "is not a count of 0 or more", "write a whole number");
            return 0;
        }
        return json.get<int>();
    }

    /// Its items, or none and an error.
    const Json::array_t& list(const Json& json, const std::string& where, const char* remedy,
                              std::size_t size = 0) {
        static const Json::array_t none;
        if (json.is_array() && (size == 0 || json.size() == size))
            return json.get_ref<const Json::array_t&>();
        wrong(where, "is not such a list", remedy);
        return none;
    }

    const Json* field(const Json& object, const char* key) const {
        const auto it = object.find(key);
        return it == object.end() || it->is_null() ? nullptr : &*it;
    }

    /// Which of the words the text is.
    int word(const Json& json, const std::string& where, std::initializer_list<const char*> words) {
        int k = 0;
        for (const char* w : words) {
            if (json.is_string() && json.get_ref<const std::string&>() == w) return k;
            ++k;
        }
        wrong(where, "is not a word known here", fmt::format("write one of: {}", fmt::join(words, ", ")));
        return 0;
    }

    void read_element(const Json& json, const std::string& where) {
        if (!json.is_object())
            return wrong(where, "is not an object", R"(write {"closed": false, "points": [...]})");
        known(json, where, {"closed", "points", "entry", "direction", "sense"});
        tour::Element element;
        const Json* closed = field(json, "closed");
        if (!closed || !closed->is_boolean())
            return wrong(where, "has no \"closed\": true or false", "write it");
        element.closed = closed->get<bool>();
        const Json* points = field(json, "points");
        if (!points) return wrong(where, "has no \"points\"", "write \"points\": [[x, y], ...]");
        int k = 0;
        for (const Json& p : list(*points, where + ".points", "write [[x, y], ...]"))
            element.points.push_back(point(p, fmt::format("{}.points[{}]", where, k++)));
        const int fewest = element.closed ? 1 : 2;
        if (static_cast<int>(element.points.size()) < fewest)
            return wrong(where,
                         fmt::format("has {} points; {} needs {} or more", element.points.size(),
                                     element.closed ? "a closed line" : "an open line", fewest),
                         "add points or remove the element");
        if (const Json* entry = field(json, "entry")) element.entry = number(*entry, where + ".entry");
        if (const Json* direction = field(json, "direction")) {
            if (element.closed) return wrong(where, "is closed and has a \"direction\"", "use \"sense\"");
            element.direction = word(*direction, where + ".direction", {"forward", "backward"}) == 0
                                    ? tour::Direction::forward
                                    : tour::Direction::backward;
        }
        if (const Json* sense = field(json, "sense")) {
            if (!element.closed) return wrong(where, "is open and has a \"sense\"", "use \"direction\"");
            element.sense =
                word(*sense, where + ".sense", {"ccw", "cw"}) == 0 ? tour::Sense::ccw : tour::Sense::cw;
        }
        instance_.problem.elements.push_back(std::move(element));
    }

    void read_rules() {
        tour::Problem& problem = instance_.problem;
        const auto each = [&](const char* key, const char* remedy, auto&& read) {
            const Json* found = field(root_, key);
            if (!found) return;
            int k = 0;
            for (const Json& item : list(*found, key, remedy))
                read(item, fmt::format("{}[{}]", key, k++), remedy);
        };
        each("links", "write [[[i, v], [j, w]], ...]",
             [&](const Json& item, const std::string& where, const char* remedy) {
                 std::vector<int> numbers;
                 for (const Json& side : list(item, where, remedy, 2))
                     for (const Json& n : list(side, where, remedy, 2)) numbers.push_back(number(n, where));
                 if (numbers.size() == 4)
                     problem.links.push_back({numbers[0], numbers[1], numbers[2], numbers[3]});
             });
        each("before", "write [[i, j], ...]",
             [&](const Json& item, const std::string& where, const char* remedy) {
                 std::vector<int> numbers;
                 for (const Json& n : list(item, where, remedy, 2)) numbers.push_back(number(n, where));
                 if (numbers.size() == 2) problem.before.emplace_back(numbers[0], numbers[1]);
             });
        each("groups", "write [[i, ...], ...]",
             [&](const Json& item, const std::string& where, const char* remedy) {
                 std::vector<int> numbers;
                 for (const Json& n : list(item, where, remedy)) numbers.push_back(number(n, where));
                 problem.groups.push_back(std::move(numbers));
             });
        if (const Json* order = field(root_, "group_order"))
            problem.keep_group_order = word(*order, "group_order", {"any", "kept"}) == 1;
    }

    void read_all() {
        known(root_, "", {"start", "end", "elements", "links", "before", "groups", "group_order"});
        tour::Problem& problem = instance_.problem;
        if (const Json* start = field(root_, "start")) problem.start = point(*start, "start");
        if (const Json* end = field(root_, "end")) {
            if (end->is_string()) {
                word(*end, "end", {"start"});
                problem.end = tour::End::at_start;
            } else {
                problem.end = tour::End::at_point;
                problem.end_point = point(*end, "end");
            }
        }
        const Json* elements = field(root_, "elements");
        if (!elements)
            return wrong("", "has no \"elements\"",
                         R"(write "elements": [{"closed": false, "points": [...]}, ...])");
        int k = 0;
        for (const Json& element : list(*elements, "elements", "write a list of elements")) {
            read_element(element, fmt::format("element {}", k++));
            if (error_) return;
        }
        read_rules();
    }

    const Json& root_;
    const std::string& file_;
    Instance instance_;
    std::optional<Error> error_;
    std::map<std::string, std::string> unknown_;  ///< key -> where it was met first
};

}  // namespace

Outcome<Instance> read_instance(std::string_view text, const std::string& place) {
    Json root;
    try {
        root = Json::parse(text);
    } catch (const Json::parse_error& error) {
        const bool ended = error.byte > text.size();
        return fail(text_place(place, text, error.byte),
                    ended ? "the file ends inside a JSON value" : "is not JSON from here on",
                    "check commas, brackets and quotes");
    } catch (const Json::exception&) {
        // What a number cannot hold, such as 1e999.
        return fail(place, "holds a number that is too large", "write numbers of ordinary size");
    }
    return Reader(root, place).run();
}

std::string write_solution(const tour::Tour& tour, const tour::Problem& problem,
                           const std::optional<tour::Entries>& entries) {
    std::string text = "[";
    for (std::size_t k = 0; k < tour.steps.size(); ++k) {
        const tour::Step& step = tour.steps[k];
        text += text.size() > 1 ? ",\n " : "";
        fmt::format_to(std::back_inserter(text), R"({{"element":{},"entry_index":{},"reversed":{})",
                       step.element, step.entry, step.reversed);
        if (entries && problem.elements[static_cast<std::size_t>(step.element)].closed)
            fmt::format_to(std::back_inserter(text), R"(,"at":[{},{}])", entries->at[k].x, entries->at[k].y);
        text += '}';
    }
    return text + "]\n";
}

}  // namespace strandline::stages
