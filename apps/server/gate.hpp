#pragma once
// Who may come in: decided from a request's Host, Origin, cookie and token alone.
#include <string>
#include <string_view>

#include "base/outcome/outcome.hpp"

namespace strandline::serve {

struct Gate {
    std::string host = "127.0.0.1";  ///< that the server listens on
    int port = 0;
    std::string token = {};  ///< "": none is asked for
};
/// What a request says of where it comes from; "" for a header that is absent.
struct Visitor {
    std::string host, origin, fetch_site, authorization, cookie;
};

bool is_loopback(std::string_view host);
/// The name of the cookie that carries the token.
inline constexpr std::string_view token_cookie = "strandline_token";

/// Error: a Host that is not this server's (a name rebound to this address, say), another page's Origin.
/// Where the server listens on every address any address in numbers is its own: only names can be rebound.
Outcome<void> from_here(const Gate& gate, const Visitor& visitor);
/// Whether the token is there, as "Authorization: Bearer TOKEN" or in the cookie. Takes as long for a wrong
/// one as for the right one.
bool knows_token(const Gate& gate, const Visitor& visitor);
bool is_token(const Gate& gate, std::string_view text);

}  // namespace strandline::serve
