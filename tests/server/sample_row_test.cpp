// Samples as they are sent.
#include "server/sample_row.hpp"

#include <gtest/gtest.h>

namespace strandline::serve {
namespace {

/// One sample at x.
std::shared_ptr<const Chunk> chunk_at(float x, std::uint64_t hash) {
    Chunk chunk;
    chunk.count = 1;
    chunk.columns = {0, x, 0, 0, x, 0};
    chunk.mask = {1};
    chunk.stroke = {0};
    chunk.motion = {0};
    chunk.hash = hash;
    return std::make_shared<const Chunk>(std::move(chunk));
}
SampleRow row_of(std::shared_ptr<const Chunk> chunk) { return {{{std::move(chunk), 0, 0, 0}}, 1, "tag"}; }
/// The number of samples that a splice holds itself.
std::uint32_t fresh_in(const std::string& splice) {
    return static_cast<unsigned char>(splice.at(12));  // little-endian, and few
}

TEST(SampleRow, WhatThePageHasIsNotSentAgain) {
    const SampleRow base = row_of(chunk_at(1, 7));
    EXPECT_EQ(fresh_in(splice_text(base, &base)), 0u);
    EXPECT_EQ(fresh_in(splice_text(row_of(chunk_at(1, 7)), &base)), 0u) << "another object, the same samples";
    EXPECT_EQ(fresh_in(splice_text(row_of(chunk_at(2, 8)), &base)), 1u);
    EXPECT_EQ(fresh_in(splice_text(base, nullptr)), 1u);
}

TEST(SampleRow, ChunksThatShareAHashByAccidentAreNotTakenForTheSame) {
    const SampleRow base = row_of(chunk_at(1, 7)), other = row_of(chunk_at(2, 7));
    EXPECT_EQ(fresh_in(splice_text(other, &base)), 1u);
    SampleRow both = base;
    both.chunks.push_back({other.chunks[0].chunk, 1, 0, 1});
    both.count = 2;
    EXPECT_EQ(fresh_in(splice_text(both, &base)), 1u);
}

}  // namespace
}  // namespace strandline::serve
