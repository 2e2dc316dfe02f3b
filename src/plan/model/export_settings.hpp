#pragma once
// Private to the room: the rows of the table of settings that exports and georeference read.
#include <vector>

#include "plan/model/model.hpp"

namespace strandline {

std::vector<Setting> export_settings();

}  // namespace strandline
