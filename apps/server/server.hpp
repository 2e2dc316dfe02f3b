#pragma once
// The API and the editor's pages over HTTP.
#include <functional>
#include <string>

#include "api.hpp"

namespace strandline::serve {

struct ServeOptions {
    std::string host = "127.0.0.1";
    int port = 0;  ///< 0: any that is free
    std::string token = {};
    std::string web = {};  ///< folder of the editor's built pages
};
/// Serves until `ended` returns, which is called on a thread of its own. `listening` is called with the port
/// once calls are taken. Error: the address is taken or not ours; --host without a token.
Outcome<void> serve(Api& api, const ServeOptions& options, const std::function<void(int port)>& listening,
                    const std::function<void()>& ended);

}  // namespace strandline::serve
