#pragma once
// Several drawings planned into one folder: what became of each, and how that is said.
#include <string>
#include <vector>

#include "batch_record.hpp"

namespace strandline::cli {

struct BatchItem {
    enum class State { waiting, planned, up_to_date, failed, stopped };
    std::string input, output;  ///< files; the output lies in the batch's folder
    State state = State::waiting;
    BatchFigures figures;  ///< of planned and up_to_date
    Error error;           ///< of failed
};

/// NAME.json in `folder` for each input. Error: two inputs would have one plan, a plan would replace its
/// drawing, or an input is stdin.
Outcome<std::vector<BatchItem>> batch_items(const std::vector<std::string>& inputs,
                                            const std::string& folder);

/// "planned; 12 elements, 80.50 m, 6 min 02 s": the line of an item when it is done.
std::string outcome_text(const BatchItem& item);
/// A line an item in the order of the call, and one of sums.
std::string batch_table(const std::vector<BatchItem>& items);
std::string batch_json(const std::vector<BatchItem>& items);

}  // namespace strandline::cli
