#include "gate.hpp"

#include <algorithm>
#include <cctype>

namespace strandline::serve {
namespace {

struct Authority {
    std::string host;
    std::string port;
};

/// "localhost:8014", "[::1]:8014".
Authority authority_of(std::string_view text) {
    std::string low(text);
    std::ranges::transform(low, low.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::size_t colon = low.rfind(':'), bracket = low.rfind(']');
    const bool has_port = colon != std::string::npos && (bracket == std::string::npos || colon > bracket);
    Authority authority{low.substr(0, has_port ? colon : low.size()),
                        has_port ? low.substr(colon + 1) : "80"};
    if (authority.host.starts_with('[') && authority.host.ends_with(']'))
        authority.host = authority.host.substr(1, authority.host.size() - 2);
    return authority;
}

bool is_address(std::string_view host) {
    const bool four = !host.empty() && std::ranges::all_of(host, [](char c) {
        return std::isdigit(static_cast<unsigned char>(c)) || c == '.';
    });
    const bool six = host.find(':') != std::string_view::npos && std::ranges::all_of(host, [](char c) {
                         return std::isxdigit(static_cast<unsigned char>(c)) || c == ':' || c == '.';
                     });
    return four || six;
}

bool is_ours(const Gate& gate, std::string_view text) {
    const Authority authority = authority_of(text);
    if (authority.port != std::to_string(gate.port)) return false;
    if (authority.host == gate.host || is_loopback(authority.host)) return true;
    const bool everywhere = gate.host == "0.0.0.0" || gate.host == "::";
    return everywhere && is_address(authority.host);
}

}  // namespace

bool is_loopback(std::string_view host) {
    return host == "localhost" || host == "::1" || (host.starts_with("127.") && is_address(host));
}

Outcome<void> from_here(const Gate& gate, const Visitor& visitor) {
    if (!is_ours(gate, visitor.host))
        return fail("Host", "\"" + visitor.host + "\" is not this server",
                    "open the address that strandline serve printed");
    constexpr std::string_view scheme = "http://";
    if (!visitor.origin.empty() &&
        (!visitor.origin.starts_with(scheme) || !is_ours(gate, visitor.origin.substr(scheme.size()))))
        return fail("Origin", "\"" + visitor.origin + "\" is another page", "use the editor's own page");
    // A loopback page of another port is the same site, but not the same origin.
    if (visitor.fetch_site == "cross-site" || visitor.fetch_site == "same-site")
        return fail("Sec-Fetch-Site", "another page asked", "open the editor's own page");
    return {};
}

bool is_token(const Gate& gate, std::string_view text) {
    unsigned char differs = text.size() == gate.token.size() ? 0 : 1;
    for (std::size_t i = 0; i < gate.token.size(); ++i)
        differs |= static_cast<unsigned char>(gate.token[i] ^ (i < text.size() ? text[i] : '\0'));
    return differs == 0;
}

bool knows_token(const Gate& gate, const Visitor& visitor) {
    if (gate.token.empty()) return true;
    constexpr std::string_view bearer = "Bearer ";
    if (visitor.authorization.starts_with(bearer))
        return is_token(gate, std::string_view(visitor.authorization).substr(bearer.size()));
    const std::string wanted = std::string(token_cookie) + "=";
    for (std::size_t at = 0; at < visitor.cookie.size();) {
        const std::size_t end = std::min(visitor.cookie.find(';', at), visitor.cookie.size());
        std::string_view pair(visitor.cookie.data() + at, end - at);
        while (pair.starts_with(' ')) pair.remove_prefix(1);
        if (pair.starts_with(wanted)) return is_token(gate, pair.substr(wanted.size()));
        at = end + 1;
    }
    return false;
}

}  // namespace strandline::serve
