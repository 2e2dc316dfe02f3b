#include "base/outcome/outcome.hpp"

namespace strandline {

std::string sentence(const Error& error) {
    std::string text = error.place.empty() ? error.reason : error.place + ": " + error.reason;
    return error.remedy.empty() ? text : text + "; " + error.remedy;
}

std::string sentence(const Warning& warning) {
    return warning.place.empty() ? warning.reason : warning.place + ": " + warning.reason;
}

}  // namespace strandline
