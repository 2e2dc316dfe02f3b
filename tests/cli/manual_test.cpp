// The pages that are made from the command line's description, against --help and against their readers.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "program.hpp"

namespace strandline::test {
namespace {

std::set<std::string> matches(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
        found.insert((*it)[1]);
    return found;
}

std::set<std::string> commands(const Folder& folder) {
    const std::string help = run(folder, "--help").out;
    const std::size_t begin = help.find("Subcommands:");
    return matches(help.substr(begin, help.find("\n\n", begin) - begin), "\n  ([a-z]+) ");
}

/// The part of a page under "## name".
std::string section(const std::string& page, const std::string& name) {
    const std::size_t begin = page.find("\n## " + name + "\n");
    if (begin == std::string::npos) return "";
    return page.substr(begin, page.find("\n## ", begin + 1) - begin);
}

bool has(const std::string& tool) {
    return std::system(("command -v " + tool + " >/dev/null 2>&1").c_str()) == 0;
}

/// What bash offers for the last of `words`, as COMP_WORDS has them.
std::string offered(const Folder& folder, const std::string& words) {
    write(folder / "ask.sh", "source ./script\nCOMP_WORDS=(strandline " + words +
                                 ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_strandline\n"
                                 "echo \"${COMPREPLY[*]}\" >offered\n");
    const std::string call = "cd '" + folder.path().string() + "' && bash ask.sh";
    EXPECT_EQ(std::system(call.c_str()), 0) << words;
    std::string line = read(folder / "offered");
    if (!line.empty()) line.pop_back();
    return line;
}

TEST(Manual, ThePageInDocsIsTheOneThatIsPrinted) {
    const Folder folder;
    const Result page = run(folder, "manual markdown");
    ASSERT_EQ(page.exit, 0) << page.err;
    EXPECT_TRUE(page.out == read(STRANDLINE_SOURCE "/docs/commands.md"))
        << "renew it: strandline manual markdown > docs/commands.md";
}

TEST(Manual, EveryOptionOfEveryHelpStandsInDocsAndManPage) {
    const Folder folder;
    const std::string docs = read(STRANDLINE_SOURCE "/docs/commands.md"), man = run(folder, "manual man").out;
    const std::set<std::string> all = commands(folder);
    EXPECT_GT(all.size(), 15u);
    for (const std::string& command : all) {
        const std::string help = run(folder, command + " --help").out, text = section(docs, command);
        const std::size_t begin = man.find("\n.SS " + command + "\n");
        ASSERT_NE(begin, std::string::npos) << command;
        const std::string manual = man.substr(begin, man.find("\n.S", begin + 1) - begin);
        const auto options = matches(help, "\n  (?:-[a-z],)?(--[a-z-]+)");
        EXPECT_TRUE(options.contains("--help")) << help;
        for (const std::string& option : options) {
            EXPECT_NE(text.find(option), std::string::npos) << command << ' ' << option;
            const std::string escaped = std::regex_replace(option, std::regex("-"), "\\-");
            EXPECT_NE(manual.find(escaped), std::string::npos) << command << ' ' << option;
        }
    }
}

TEST(Manual, GroffReadsTheManPageWithoutAWarning) {
    if (!has("groff")) GTEST_SKIP() << "groff is not at hand";
    const Folder folder;
    write(folder / "strandline.1", run(folder, "manual man").out);
    const std::string call =
        "cd '" + folder.path().string() + "' && groff -man -ww -Tutf8 -P-cbou strandline.1 >page 2>said";
    EXPECT_EQ(std::system(call.c_str()), 0);
    EXPECT_EQ(read(folder / "said"), "");
    const std::string page = std::regex_replace(read(folder / "page"), std::regex(" +"), " ");
    for (const char* words :
         {"strandline - a drawing becomes", "--keep-out", "\"Hello\\nbeach\"", "Exit codes"})
        EXPECT_NE(page.find(words), std::string::npos) << words;
}

TEST(Manual, BashCompletesCommandsOptionsAndValues) {
    const Folder folder;
    write(folder / "script", run(folder, "manual bash").out);
    EXPECT_EQ(offered(folder, "pl"), "plan");
    EXPECT_EQ(offered(folder, "plan --out"), "--out-dir --output");
    EXPECT_EQ(offered(folder, "-q plan a.svg --keep"), "--keep-out");
    EXPECT_EQ(offered(folder, "plan --robot beach"), "beachbot");
    EXPECT_EQ(offered(folder, "robots pl"), "plotter");
    EXPECT_EQ(offered(folder, "export plan.json --format wp"), "wpl");
    EXPECT_EQ(offered(folder, "plan --set fill.sty"), "fill.style=");
    EXPECT_EQ(offered(folder, "plan --set fill.style ="), "rings spiral zigzag");
    EXPECT_EQ(offered(folder, "plan --set fill.style = zi"), "zigzag");
    EXPECT_EQ(offered(folder, "plan --method e"), "exact");
    EXPECT_EQ(offered(folder, "text hello --align c"), "centre");
    EXPECT_EQ(offered(folder, "manual m"), "man markdown");
    // Nothing of its own: bash offers files.
    EXPECT_EQ(offered(folder, "plan ''"), "");
    EXPECT_EQ(offered(folder, "plan -o ''"), "");
}

TEST(Manual, BashOffersEveryOptionOfEveryHelp) {
    const Folder folder;
    write(folder / "script", run(folder, "manual bash").out);
    for (const std::string& command : commands(folder)) {
        const auto options = matches(run(folder, command + " --help").out, "\n  (?:-[a-z],)?(--[a-z-]+)");
        std::istringstream words(offered(folder, command + " --"));
        std::set<std::string> all;
        for (std::string word; words >> word;) all.insert(word);
        for (const std::string& option : options)
            EXPECT_TRUE(all.contains(option)) << command << ' ' << option;
    }
}

TEST(Manual, BashFindsFilesWhereTheProgramHasNothingToOffer) {
    const Folder folder;
    write(folder / "script", run(folder, "manual bash").out);
    write(folder / "starfish.svg", "");
    // As a person presses the key; what would be run writes down how it was called.
    write(folder / "go.sh", "strandline() { echo \"$@\" >typed; }\nsource ./script\n");
    const std::string call = "cd '" + folder.path().string() +
                             "' && printf 'strandline plan starf\\t\\nexit\\n' | "
                             "INPUTRC=/dev/null bash --rcfile go.sh -i >/dev/null 2>&1";
    EXPECT_EQ(std::system(call.c_str()), 0);
    EXPECT_EQ(read(folder / "typed"), "plan starfish.svg\n");
}

}  // namespace
}  // namespace strandline::test
