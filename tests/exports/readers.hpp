#pragma once
// Second readers of what the program exports, written from the formats' own pages (docs/exports), and what
// tests compare with.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "site/earth.hpp"

namespace strandline::testing {

using Json = nlohmann::json;

/// A line that is drawn (tool down) or driven.
struct Track {
    bool down = false;
    Polyline points;
};

/// How far the farthest point of either line is from the other.
inline double apart(const Polyline& a, const Polyline& b) {
    double most = a.empty() != b.empty() ? 1e9 : 0;
    for (const Point p : a) most = std::max(most, distance_to(b, p));
    for (const Point p : b) most = std::max(most, distance_to(a, p));
    return most;
}

inline std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// What the command prints; it must end well.
inline std::string printed_by(const std::string& command) {
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    char buffer[4096];
    while (pipe && std::fgets(buffer, sizeof buffer, pipe)) output += buffer;
    EXPECT_EQ(pipe ? pclose(pipe) : -1, 0) << command << "\n" << output.substr(0, 2000);
    return output;
}
inline bool there_is(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}
/// The text in a file that other programs can be given; gone with it.
class Scratch {
  public:
    Scratch(const std::string& text, const std::string& suffix) {
        std::string shape = "/tmp/strandline-XXXXXX" + suffix;
        const int file = mkstemps(shape.data(), static_cast<int>(suffix.size()));
        if (file >= 0) close(file);
        path_ = shape;
        std::ofstream(path_, std::ios::binary) << text;
    }
    ~Scratch() { std::remove(path_.c_str()); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

/// YAML documents by another program's parser.
inline std::vector<Json> read_yaml(const std::string& text) {
    const Scratch file(text, ".yaml");
    const std::string printed = printed_by(
        "/usr/bin/python3 -c 'import sys, json, yaml\n"
        "loader = getattr(yaml, \"CSafeLoader\", yaml.SafeLoader)\n"
        "print(json.dumps(list(yaml.load_all(open(sys.argv[1]), Loader=loader))))' " +
        file.path());
    return Json::parse(printed).get<std::vector<Json>>();
}
inline bool there_is_yaml() { return std::system("/usr/bin/python3 -c 'import yaml' >/dev/null 2>&1") == 0; }

/// One line of a QGC WPL 110, or an item of a .plan.
struct MissionItem {
    int index = 0, current = 0, frame = 0, command = 0;
    double parameters[4] = {};
    Geographic at;
    double altitude = 0;
};
/// mavlink.io, "Mission Plain-Text File Format": a first line, then twelve fields between tabs.
inline std::vector<MissionItem> read_wpl(const std::string& text) {
    const auto lines = lines_of(text);
    EXPECT_EQ(lines.at(0), "QGC WPL 110");
    std::vector<MissionItem> items;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        EXPECT_EQ(std::count(lines[k].begin(), lines[k].end(), '\t'), 11) << lines[k];
        MissionItem i;
        int next = 0;
        EXPECT_EQ(
            std::sscanf(lines[k].c_str(), "%d %d %d %d %lf %lf %lf %lf %lf %lf %lf %d", &i.index, &i.current,
                        &i.frame, &i.command, &i.parameters[0], &i.parameters[1], &i.parameters[2],
                        &i.parameters[3], &i.at.latitude, &i.at.longitude, &i.altitude, &next),
            12)
            << lines[k];
        EXPECT_EQ(i.index, static_cast<int>(k) - 1);
        EXPECT_EQ(i.current, k == 1 ? 1 : 0);
        EXPECT_EQ(next, 1);
        items.push_back(i);
    }
    return items;
}
/// QGroundControl's developer guide, "Plan File Format": home as the first item, then mission.items.
inline std::vector<MissionItem> read_qgc_plan(const std::string& text) {
    const Json plan = Json::parse(text);
    EXPECT_EQ(plan.at("fileType"), "Plan");
    EXPECT_EQ(plan.at("version"), 1);
    EXPECT_EQ(plan.at("geoFence").at("version"), 2);
    EXPECT_EQ(plan.at("rallyPoints").at("version"), 2);
    const Json& mission = plan.at("mission");
    EXPECT_EQ(mission.at("version"), 2);
    const Json& home = mission.at("plannedHomePosition");
    std::vector<MissionItem> items{{0, 1, 0, 16, {}, {home.at(0), home.at(1)}, home.at(2)}};
    for (const Json& json : mission.at("items")) {
        EXPECT_EQ(json.at("type"), "SimpleItem");
        EXPECT_EQ(json.at("autoContinue"), true);
        EXPECT_EQ(json.at("doJumpId"), items.size());
        MissionItem i;
        i.index = json.at("doJumpId");
        i.frame = json.at("frame");
        i.command = json.at("command");
        const Json& p = json.at("params");
        EXPECT_EQ(p.size(), 7u);
        for (std::size_t k = 0; k < 4; ++k) i.parameters[k] = p[k].is_null() ? 0 : p[k].get<double>();
        i.at = {p[4], p[5]};
        i.altitude = p[6];
        items.push_back(i);
    }
    return items;
}
/// What an autopilot drives: straight from waypoint to waypoint, the servo as last told.
inline std::vector<Track> driven(const std::vector<MissionItem>& items, const Site& site, double down_pulse) {
    std::vector<Track> tracks(1);
    for (std::size_t k = 1; k < items.size(); ++k) {
        const MissionItem& item = items[k];
        if (item.command == 16 || item.command == 17) {
            EXPECT_EQ(item.frame, 3);
            tracks.back().points.push_back(read_back(site, item.at));
        } else if (item.command == 183) {
            const bool down = item.parameters[1] == down_pulse;
            if (down == tracks.back().down) continue;
            const Polyline& before = tracks.back().points;
            tracks.push_back({down, before.empty() ? Polyline{} : Polyline{before.back()}});
        } else {
            EXPECT_EQ(item.command, 178);
        }
    }
    std::erase_if(tracks, [](const Track& track) { return track.points.size() < 2; });
    return tracks;
}

/// RS274/NGC as far as a plotter goes: G0 and G1 with X and Y, G21, comments, lines of other words kept.
struct Program {
    std::vector<Track> tracks;  ///< metres; down: what G1 draws between two lifts
    std::vector<std::string> others;
};
inline Program read_gcode(const std::string& text) {
    Program program;
    Point at;
    bool millimetres = false, drawing = false;
    for (const std::string& line : lines_of(text)) {
        char word[8];
        double x = 0, y = 0;
        if (std::sscanf(line.c_str(), "%3s X%lf Y%lf", word, &x, &y) == 3) {
            EXPECT_TRUE(millimetres) << "units first";
            const bool down = std::string(word) == "G1";
            const Point to{x / 1000, y / 1000};
            if (!drawing || !down) program.tracks.push_back({down, {at}});
            program.tracks.back().points.push_back(to);
            drawing = down;
            at = to;
        } else {
            millimetres = millimetres || line == "G21";
            drawing = false;
            program.others.push_back(line);
        }
    }
    return program;
}

/// Theta and rho as Sisyphus tables take them: along an Archimedean spiral between two lines; metres by what
/// the comment says of the circle.
inline Polyline read_thr(const std::string& text) {
    Polyline track;
    double radius = 0, theta = 0, rho = 0;
    Point middle;
    bool begun = false;
    for (const std::string& line : lines_of(text)) {
        if (line.starts_with("#")) {
            std::sscanf(line.c_str(), "# rho 1 is %lf m from %lf %lf", &radius, &middle.x, &middle.y);
            continue;
        }
        double t = 0, r = 0;
        EXPECT_EQ(std::sscanf(line.c_str(), "%lf %lf", &t, &r), 2) << line;
        EXPECT_TRUE(r >= 0 && r <= 1) << line;
        const int steps = begun ? 1 + static_cast<int>(std::abs(t - theta) / 0.02) : 1;
        for (int k = 1; k <= steps; ++k) {
            const double share = static_cast<double>(k) / steps;
            const double angle = begun ? std::lerp(theta, t, share) : t,
                         reach = radius * (begun ? std::lerp(rho, r, share) : r);
            track.push_back(middle + reach * Point{std::sin(angle), std::cos(angle)});
        }
        theta = t;
        rho = r;
        begun = true;
    }
    return track;
}

}  // namespace strandline::testing
