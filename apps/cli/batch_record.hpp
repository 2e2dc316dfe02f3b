#pragma once
// What a folder of plans was made from, so that a batch plans again only what would come out otherwise.
#include <map>
#include <string>
#include <string_view>

#include "planning.hpp"

namespace strandline::cli {

/// What the table says of a plan.
struct BatchFigures {
    int elements = 0;
    double drawn = 0;  ///< m of rake path
    double time = 0;   ///< s of drive
    int warnings = 0, faults = 0;
    std::string short_of;  ///< as shortcomings()
};
/// A plan of the folder: digests of all that it was made from and of its bytes, and its figures.
struct BatchEntry {
    std::string made_from, plan;
    BatchFigures figures;
};
/// By the plan's file name.
using BatchRecord = std::map<std::string, BatchEntry>;

/// 16 hexadecimal digits (FNV-1a of 64 bits): tells apart what differs by accident, not by design.
std::string digest_of(std::string_view bytes);
/// Of all that every plan of this call is made from but the drawing: program (its own bytes), robot,
/// settings, edits. Fonts of the machine are not in it.
std::string digest_of(const Asked& asked);

/// FOLDER/.strandline-batch; none there, or none that this program reads: empty, and everything is planned.
BatchRecord read_batch_record(const std::string& folder);
Outcome<void> write_batch_record(const std::string& folder, const BatchRecord& record);

}  // namespace strandline::cli
