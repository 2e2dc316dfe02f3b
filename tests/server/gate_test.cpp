// Who may come in.
#include "server/gate.hpp"

#include <gtest/gtest.h>

#include "server/folder.hpp"

namespace strandline::serve {
namespace {

const Gate local{"127.0.0.1", 8014, ""};
bool in(const Gate& gate, const std::string& host, const std::string& origin = "",
        const std::string& site = "") {
    return from_here(gate, {host, origin, site, "", ""}).has_value();
}

TEST(Gate, OnlyTheServersOwnNameIsAnswered) {
    EXPECT_TRUE(in(local, "127.0.0.1:8014"));
    EXPECT_TRUE(in(local, "localhost:8014"));
    EXPECT_TRUE(in(local, "LOCALHOST:8014"));
    EXPECT_TRUE(in(local, "[::1]:8014"));
    for (const char* other :
         {"", "evil.example", "evil.example:8014", "localhost", "localhost:80", "127.0.0.1.evil.example:8014",
          "localhost.evil.example:8014", "192.168.1.5:8014", "127.evil:8014"})
        EXPECT_FALSE(in(local, other)) << other;
}

TEST(Gate, APageOfAnotherOriginIsRefused) {
    EXPECT_TRUE(in(local, "localhost:8014", "http://localhost:8014"));
    EXPECT_TRUE(in(local, "localhost:8014", "http://localhost:8014", "same-origin"));
    EXPECT_TRUE(in(local, "localhost:8014", "", "none"));
    for (const char* origin :
         {"null", "http://evil.example", "https://localhost:8014", "http://localhost:3000", "file://"})
        EXPECT_FALSE(in(local, "localhost:8014", origin)) << origin;
    EXPECT_FALSE(in(local, "localhost:8014", "", "cross-site"));
    EXPECT_FALSE(in(local, "localhost:8014", "", "same-site"));
}

TEST(Gate, OnEveryAddressNumbersAreItsOwnAndNamesAreNot) {
    const Gate open{"0.0.0.0", 8014, "sand"};
    EXPECT_TRUE(in(open, "192.168.1.5:8014"));
    EXPECT_TRUE(in(open, "192.168.1.5:8014", "http://192.168.1.5:8014"));
    EXPECT_TRUE(in(open, "[fe80::1]:8014"));
    EXPECT_FALSE(in(open, "rebound.example:8014"));
}

TEST(Gate, TheTokenIsAskedForAsHeaderOrCookie) {
    const Gate gate{"0.0.0.0", 8014, "sand"};
    const auto knows = [&](const std::string& authorization, const std::string& cookie) {
        return knows_token(gate, {"", "", "", authorization, cookie});
    };
    EXPECT_TRUE(knows("Bearer sand", ""));
    EXPECT_TRUE(knows("", "a=b; strandline_token=sand; c=d"));
    EXPECT_TRUE(knows("", "strandline_token=sand"));
    for (const char* wrong : {"", "Bearer", "Bearer ", "Bearer san", "Bearer sandy", "sand"})
        EXPECT_FALSE(knows(wrong, "")) << wrong;
    EXPECT_FALSE(knows("", "strandline_token=sandy"));
    EXPECT_FALSE(knows("", "x_strandline_token=sand"));
    EXPECT_TRUE(knows_token(local, {}));
}

TEST(Folder, IdsAreNamesWithoutAnyPath) {
    for (const char* id : {"lion", "Lion-2", "a_b"}) EXPECT_TRUE(is_project_id(id)) << id;
    for (const char* id : {"", ".", "..", "../x", "a/b", "a\\b", "a.b", "%2e%2e", "a b", "\xc3\xa4"})
        EXPECT_FALSE(is_project_id(id)) << id;
    EXPECT_FALSE(is_project_id(std::string(65, 'a')));
    EXPECT_EQ(project_id_for("My drawing.svg"), "My-drawing");
    EXPECT_EQ(project_id_for("../../etc/passwd"), "passwd");
    EXPECT_EQ(project_id_for(".svg"), "svg");
    EXPECT_EQ(project_id_for(""), "drawing");
    EXPECT_TRUE(is_project_id(project_id_for(std::string(500, 'x'))));
}

}  // namespace
}  // namespace strandline::serve
