// What the fuzzer found worth keeping (tests/svg/corpus, minimised by libFuzzer): still a document or an
// error.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "contract.hpp"

namespace strandline::svg {
namespace {

TEST(Corpus, EveryFileGivesADocumentOrOneError) {
    int documents = 0, errors = 0;
    for (const auto& entry : std::filesystem::directory_iterator(STRANDLINE_SOURCE "/tests/svg/corpus")) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string bytes((std::istreambuf_iterator<char>(file)), {});
        const auto document = read(bytes, {.limits = {.expanded = 10'000, .segments = 100'000}});
        ++(document ? documents : errors);
        if (document)
            EXPECT_TRUE(keeps_contract(*document)) << entry.path();
        else
            EXPECT_FALSE(document.error().reason.empty()) << entry.path();
    }
    EXPECT_GT(documents, 100);
    EXPECT_GT(errors, 10);
}

}  // namespace
}  // namespace strandline::svg
