// Bad input: one clear message with its place, exit 1, nothing half-written.
#include <gtest/gtest.h>

#include <algorithm>

#include "program.hpp"

namespace strandline::test {
namespace {

std::string svg(const std::string& inside, const std::string& attributes = "viewBox='0 0 100 100'") {
    return "<svg xmlns='http://www.w3.org/2000/svg' " + attributes + ">" + inside + "</svg>";
}
const std::string line = "<path id='a' d='M10 10L90 90' stroke='black' fill='none'/>";

/// One line on stderr that holds each word; no output file, no temporary file.
void expect_refused(const Folder& folder, const Result& result, const std::vector<std::string>& words,
                    int code = 1) {
    EXPECT_EQ(result.exit, code) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    for (const std::string& word : words)
        EXPECT_NE(result.err.find(word), std::string::npos) << word << " in: " << result.err;
    for (const auto& entry : fs::directory_iterator(folder.path()))
        EXPECT_EQ(entry.path().filename().string().find("plan.json"), std::string::npos) << entry.path();
}

void refuses(const std::string& text, const std::vector<std::string>& words,
             const std::string& arguments = "") {
    const Folder folder;
    write(folder / "in.svg", text);
    expect_refused(folder, run(folder, "plan in.svg -o plan.json " + arguments), words);
}

TEST(BadInput, AnEmptyFile) { refuses("", {"in.svg", "empty"}); }
TEST(BadInput, NotXml) { refuses("hello", {"in.svg"}); }
TEST(BadInput, TruncatedXml) {
    refuses("<svg xmlns='http://www.w3.org/2000/svg'>\n<path d='M0 0", {"in.svg", "line"});
}
TEST(BadInput, AnotherRoot) { refuses("<html><body/></html>", {"in.svg", "svg"}); }
TEST(BadInput, AnEntityBomb) {
    std::string bomb = "<?xml version='1.0'?><!DOCTYPE svg [<!ENTITY a0 'aaaaaaaaaa'>";
    for (int i = 1; i < 12; ++i) {
        const std::string previous = "&a" + std::to_string(i - 1) + ";";
        bomb += "<!ENTITY a" + std::to_string(i) + " '";
        for (int k = 0; k < 10; ++k) bomb += previous;
        bomb += "'>";
    }
    refuses(bomb + "]>" + svg("<path id='&a11;' d='M0 0L9 9' stroke='black'/>"), {"in.svg", "entit"});
}
TEST(BadInput, NotANumber) { refuses(svg("<circle id='c' cx='nan' cy='5' r='3'/>"), {"in.svg", "c"}); }
TEST(BadInput, Infinity) { refuses(svg("<rect id='r' x='0' y='0' width='1e999' height='3'/>"), {"in.svg"}); }
TEST(BadInput, AbsurdCoordinates) {
    refuses(svg("<path id='p' d='M0 0L1e308 1e308' stroke='black'/>"), {"in.svg", "line 1"});
}
TEST(BadInput, ACanvasWithoutExtent) { refuses(svg(line), {"canvas"}, "--set canvas.width=0"); }
TEST(BadInput, AMarginLargerThanTheCanvas) { refuses(svg(line), {"margin"}, "--margin 8m"); }
TEST(BadInput, NothingToDraw) {
    refuses(svg("<rect width='5' height='5' fill='white'/>"), {"in.svg", "nothing"});
}
TEST(BadInput, AFillNarrowerThanTheRakeAlone) {
    // Either it is raked by a single pass, with a warning, or refused: never silently left out.
    const Folder folder;
    write(folder / "in.svg", svg("<rect id='thin' x='10' y='10' width='80' height='0.5'/>"));
    const Result result = run(folder, "plan in.svg -o plan.json");
    EXPECT_TRUE(result.exit == 0 || result.exit == 1) << result.err;
    EXPECT_NE(result.err.find("thin"), std::string::npos) << result.err;
}
TEST(BadInput, AMissingFile) {
    const Folder folder;
    expect_refused(folder, run(folder, "plan nowhere.svg -o plan.json"), {"nowhere.svg", "cannot be read"});
}
TEST(BadInput, AnUnwritableOutput) {
    const Folder folder;
    write(folder / "in.svg", svg(line));
    const Result result = run(folder, "-q plan in.svg -o no/such/folder/plan.json");
    EXPECT_EQ(result.exit, 1);
    EXPECT_NE(result.err.find("no/such/folder"), std::string::npos) << result.err;
}
TEST(BadInput, AWrongSettingIsTheCallsFault) {
    const Folder folder;
    write(folder / "in.svg", svg(line));
    expect_refused(folder, run(folder, "plan in.svg -o plan.json --set fill.spacing=wide"), {"fill.spacing"},
                   2);
    expect_refused(folder, run(folder, "plan in.svg -o plan.json --robot hovercraft"),
                   {"hovercraft", "beachbot"}, 2);
}
TEST(BadInput, APlanThatIsNone) {
    const Folder folder;
    write(folder / "x.json", "{\"format\": 3}");
    const Result result = run(folder, "check x.json");
    EXPECT_EQ(result.exit, 1);
    EXPECT_NE(result.err.find("x.json"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace strandline::test
