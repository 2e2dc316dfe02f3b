// The allow-list of src/rooms.txt, proved on the sources: who includes whom, and what the library keeps away
// from.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
const fs::path source = fs::path(STRANDLINE_SOURCE) / "src";

struct Room {
    std::string floor;
    std::set<std::string> may_include;
};

std::map<std::string, Room> read_rooms() {
    std::map<std::string, Room> rooms;
    std::ifstream file(source / "rooms.txt");
    const std::regex line_shape("^([a-z]+)/([a-z]+):([^|]*)(\\|.*)?$"), word("[a-z]+");
    for (std::string line; std::getline(file, line);) {
        std::smatch m;
        if (!std::regex_match(line, m, line_shape)) continue;
        Room room{m[1], {}};
        const std::string own = m[3];
        for (std::sregex_iterator i(own.begin(), own.end(), word), end; i != end; ++i)
            room.may_include.insert(i->str());
        rooms[m[2]] = room;
    }
    return rooms;
}

std::string read(const fs::path& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

template <class What>
void for_each_source(What&& what) {
    for (const auto& entry : fs::recursive_directory_iterator(source)) {
        const std::string kind = entry.path().extension().string();
        if (kind == ".cpp" || kind == ".hpp")
            what(entry.path(), entry.path().parent_path().filename().string(), read(entry.path()));
    }
}

/// Every "floor/room/file" include of a text.
std::vector<std::array<std::string, 3>> includes(const std::string& text) {
    std::vector<std::array<std::string, 3>> found;
    const std::regex shape("#include \"([a-z]+)/([a-z]+)/([a-z_.]+)\"");
    for (std::sregex_iterator i(text.begin(), text.end(), shape), end; i != end; ++i)
        found.push_back({(*i)[1], (*i)[2], (*i)[3]});
    return found;
}

TEST(House, ARoomIncludesOnlyWhatItsLineSays) {
    const auto rooms = read_rooms();
    ASSERT_GT(rooms.size(), 15u);
    int seen = 0;
    for_each_source([&](const fs::path& path, const std::string& room, const std::string& text) {
        ASSERT_TRUE(rooms.contains(room)) << path << " is in no room of rooms.txt";
        for (const auto& [floor, other, file] : includes(text)) {
            ++seen;
            if (other == room) continue;
            EXPECT_TRUE(rooms.at(room).may_include.contains(other)) << path << " includes " << other;
            EXPECT_EQ(file, other + ".hpp") << path << " includes a private header of " << other;
        }
    });
    EXPECT_GT(seen, 40);
}

TEST(House, TheAllowListHasNoCircle) {
    const auto rooms = read_rooms();
    std::set<std::string> done;
    for (std::size_t pass = 0; pass < rooms.size(); ++pass)
        for (const auto& [name, room] : rooms) {
            bool ready = true;
            for (const std::string& other : room.may_include) ready = ready && done.contains(other);
            if (ready) done.insert(name);
        }
    for (const auto& [name, room] : rooms) EXPECT_TRUE(done.contains(name)) << name << " reaches itself";
}

TEST(House, CheckNeverReachesTheRoomsThatPlanned) {
    auto rooms = read_rooms();
    std::set<std::string> reached{"check"};
    for (std::size_t pass = 0; pass < rooms.size(); ++pass)
        for (const std::string& name : std::set(reached))
            for (const std::string& other : rooms[name].may_include) reached.insert(other);
    for (const char* planner :
         {"fill", "drive", "connect", "route", "tour", "order", "trajectory", "pipeline"})
        EXPECT_FALSE(reached.contains(planner)) << planner;
}

TEST(House, TheLibraryOpensNoFilesPrintsNothingAndReadsNoClock) {
    const std::regex forbidden(
        "#include "
        "<(iostream|fstream|cstdio|chrono|ctime|filesystem)>|std::(cout|cerr|clock)|\\bprintf\\(|fmt::print");
    for_each_source([&](const fs::path& path, const std::string&, const std::string& text) {
        std::smatch m;
        EXPECT_FALSE(std::regex_search(text, m, forbidden)) << path << ": " << m.str();
    });
}

TEST(House, OnlyThePictureRoomIncludesCairo) {
    for_each_source([&](const fs::path& path, const std::string& room, const std::string& text) {
        if (room == "picture") return;
        EXPECT_EQ(text.find("cairo"), std::string::npos) << path;
    });
}

}  // namespace
