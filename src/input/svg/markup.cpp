#include "input/svg/markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "input/svg/scan.hpp"

namespace strandline::svg {

namespace {

using Byte = unsigned char;
Byte byte_at(std::string_view s, std::size_t i) { return i < s.size() ? static_cast<Byte>(s[i]) : Byte{0}; }

void append_utf8(std::string& out, std::uint32_t c) {
    const auto put = [&](std::uint32_t b) { out.push_back(static_cast<char>(static_cast<Byte>(b))); };
    if (c < 0x80) {
        put(c);
    } else if (c < 0x800) {
        put(0xC0 | c >> 6);
        put(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        put(0xE0 | c >> 12);
        put(0x80 | (c >> 6 & 0x3F));
        put(0x80 | (c & 0x3F));
    } else {
        put(0xF0 | c >> 18);
        put(0x80 | (c >> 12 & 0x3F));
        put(0x80 | (c >> 6 & 0x3F));
        put(0x80 | (c & 0x3F));
    }
}

constexpr std::uint32_t replacement = 0xFFFD;  // for what is no character

std::string from_utf16(std::string_view bytes, bool big_endian) {
    std::string out;
    out.reserve(bytes.size());
    const auto unit_at = [&](std::size_t i) {
        const std::uint32_t a = byte_at(bytes, i), b = byte_at(bytes, i + 1);
        return big_endian ? a << 8 | b : b << 8 | a;
    };
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        std::uint32_t c = unit_at(i);
        if (c >= 0xD800 && c < 0xE000) {
            const std::uint32_t low = i + 3 < bytes.size() ? unit_at(i + 2) : 0;
            if (c < 0xDC00 && low >= 0xDC00 && low < 0xE000) {
                c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00);
                i += 2;
            } else {
                c = replacement;
            }
        }
        append_utf8(out, c);
    }
    return out;
}

std::string from_utf32(std::string_view bytes, bool big_endian) {
    std::string out;
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
        std::uint32_t c = 0;
        for (std::size_t k = 0; k < 4; ++k) c = c << 8 | byte_at(bytes, big_endian ? i + k : i + 3 - k);
        append_utf8(out, c > 0x10FFFF || (c >= 0xD800 && c < 0xE000) ? replacement : c);
    }
    return out;
}

std::string from_latin1(std::string_view bytes) {
    std::string out;
    out.reserve(bytes.size() + bytes.size() / 8);
    for (const char c : bytes) append_utf8(out, static_cast<Byte>(c));
    return out;
}

bool valid_utf8(std::string_view s) {
    for (std::size_t i = 0; i < s.size();) {
        const Byte c = byte_at(s, i);
        if (c < 0x80) {
            ++i;
            continue;
        }
        const std::size_t length = c >= 0xF0 ? 4 : c >= 0xE0 ? 3 : 2;
        if (c < 0xC2 || c > 0xF4 || i + length > s.size()) return false;
        for (std::size_t k = 1; k < length; ++k)
            if ((byte_at(s, i + k) & 0xC0) != 0x80) return false;
        const Byte next = byte_at(s, i + 1);
        if ((c == 0xE0 && next < 0xA0) || (c == 0xED && next > 0x9F) || (c == 0xF0 && next < 0x90) ||
            (c == 0xF4 && next > 0x8F))
            return false;
        i += length;
    }
    return true;
}

/// encoding="..." of the XML declaration, lower case.
std::string declared_encoding(std::string_view text) {
    if (!text.starts_with("<?xml")) return {};
    const auto declaration = text.substr(0, text.find("?>"));
    const auto at = declaration.find("encoding");
    if (at == std::string_view::npos) return {};
    const auto open = declaration.find_first_of("\"'", at);
    if (open == std::string_view::npos) return {};
    const auto close = declaration.find(declaration[open], open + 1);
    if (close == std::string_view::npos) return {};
    return lower_case(declaration.substr(open + 1, close - open - 1));
}

/// Any of the encodings to UTF-8 without mark.
std::string utf8_text(std::string_view bytes, Warnings& warnings) {
    using namespace std::string_view_literals;
    if (bytes.starts_with("\xFF\xFE\0\0"sv)) return from_utf32(bytes.substr(4), false);
    if (bytes.starts_with("\0\0\xFE\xFF"sv)) return from_utf32(bytes.substr(4), true);
    if (bytes.starts_with("\xFF\xFE"sv)) return from_utf16(bytes.substr(2), false);
    if (bytes.starts_with("\xFE\xFF"sv)) return from_utf16(bytes.substr(2), true);
    if (bytes.starts_with("<\0\0\0"sv)) return from_utf32(bytes, false);
    if (bytes.starts_with("\0\0\0<"sv)) return from_utf32(bytes, true);
    if (bytes.starts_with("<\0"sv)) return from_utf16(bytes, false);
    if (bytes.starts_with("\0<"sv)) return from_utf16(bytes, true);
    if (bytes.starts_with("\xEF\xBB\xBF"sv)) bytes.remove_prefix(3);
    if (valid_utf8(bytes)) return std::string(bytes);
    const auto encoding = declared_encoding(bytes);
    if (encoding != "iso-8859-1" && encoding != "latin1" && encoding != "windows-1252")
        warnings.push_back({"", "the text is not valid UTF-8: read as Latin-1, names may look wrong"});
    return from_latin1(bytes);
}

std::vector<std::size_t> starts_of_lines(std::string_view text) {
    std::vector<std::size_t> starts{0};
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
        starts.push_back(at + 1);
    return starts;
}

Spot spot_at(const std::vector<std::size_t>& line_starts, std::size_t offset) {
    const auto after = std::ranges::upper_bound(line_starts, offset);
    const auto line = after - line_starts.begin();
    return {static_cast<int>(line),
            static_cast<int>(offset - line_starts[static_cast<std::size_t>(line) - 1]) + 1};
}

/// `original`: the text before the parser changed it; `last`: its last byte that is no space.
Error parse_error(const Markup& markup, const pugi::xml_parse_result& result, std::string_view original,
                  std::size_t last) {
    const auto offset = std::min(last, static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, result.offset)));
    const auto [line, column] = spot_at(markup.line_starts, offset);
    const auto reason = [&]() -> std::string {
        using namespace pugi;
        // For an attribute that never ends the parser names the place where it begins.
        const bool open_quote = result.status == status_bad_attribute && offset > 0 &&
                                (original[offset - 1] == '"' || original[offset - 1] == '\'') &&
                                original.find(original[offset - 1], offset) == std::string_view::npos;
        const bool at_end = offset >= last || open_quote;
        switch (result.status) {
            case status_no_document_element:
                return "no element in it: not an SVG";
            case status_bad_pi:
                return at_end ? "the file ends inside <?...?>" : "a broken <?...?>";
            case status_bad_comment:
                return at_end ? "the file ends inside a comment" : "a broken comment";
            case status_bad_cdata:
                return "the file ends inside CDATA";
            case status_bad_doctype:
                return "a broken DOCTYPE";
            case status_bad_start_element:
                return at_end ? "the file ends inside a tag" : "a broken start tag";
            case status_bad_attribute:
                return at_end ? "the file ends inside an attribute" : "a broken attribute";
            case status_bad_end_element:
                return at_end ? "the file ends inside an end tag" : "a broken end tag";
            case status_end_element_mismatch:
                return at_end ? "the file ends before its elements are closed"
                              : "an end tag that closes no open element";
            case status_out_of_memory:
                return "not enough memory";
            default:
                return at_end ? "the file ends too early" : "not XML";
        }
    }();
    return {fmt::format("line {}:{}", line, column), "not well-formed XML: " + reason,
            result.status == pugi::status_no_document_element
                ? "give an SVG file"
                : "is the file complete? save it again as plain SVG"};
}

}  // namespace

Outcome<std::unique_ptr<Markup>> parse_markup(std::string_view bytes, const Limits& limits) {
    if (bytes.size() > limits.bytes)
        return fail(
            "", fmt::format("the file has {} bytes, more than the limit of {}", bytes.size(), limits.bytes),
            "simplify the drawing");
    if (byte_at(bytes, 0) == 0x1F && byte_at(bytes, 1) == 0x8B)
        return fail("", "a compressed SVG (.svgz)", "unpack it first: gunzip -c FILE.svgz > FILE.svg");
    auto markup = std::make_unique<Markup>();
    markup->text = utf8_text(bytes, markup->warnings);
    constexpr std::size_t opening = 4096;
    markup->by_illustrator =
        std::string_view(markup->text).substr(0, opening).find("Adobe Illustrator") != std::string_view::npos;
    if (trimmed(markup->text).empty()) return fail("", "the file is empty", "give an SVG file");
    if (const auto expanded = expand_entities(markup->text); !expanded)
        return tl::unexpected(expanded.error());
    const auto content = trimmed(markup->text);
    markup->line_starts = starts_of_lines(markup->text);
    const auto spot_text = [&](std::size_t offset) {
        const auto [line, column] = spot_at(markup->line_starts, offset);
        return fmt::format("line {}:{}", line, column);
    };
    if (const auto zero = markup->text.find('\0'); zero != std::string::npos)
        return fail(spot_text(zero), "a zero byte: this is not text", "give an SVG file");
    const auto first = static_cast<std::size_t>(content.data() - markup->text.data());
    if (content.front() != '<')
        return fail(spot_text(first), "not XML: the first character is not '<'", "give an SVG file");
    const std::size_t last = first + content.size() - 1;
    constexpr unsigned options = pugi::parse_escapes | pugi::parse_wconv_attribute | pugi::parse_eol |
                                 pugi::parse_doctype | pugi::parse_cdata | pugi::parse_ws_pcdata |
                                 pugi::parse_pi;
    const auto result = markup->tree.load_buffer_inplace(markup->text.data(), markup->text.size(), options,
                                                         pugi::encoding_utf8);
    if (!result) {
        Warnings told_already;
        auto original = utf8_text(bytes, told_already);
        if (const auto expanded = expand_entities(original); !expanded)
            return tl::unexpected(expanded.error());
        return tl::unexpected(parse_error(*markup, result, original, last));
    }
    return markup;
}

Spot spot_of(const Markup& markup, pugi::xml_node node) {
    const auto offset = node.offset_debug();
    // pugixml names where the element's name begins: its bracket stands one before
    return offset < 1 ? Spot{} : spot_at(markup.line_starts, static_cast<std::size_t>(offset) - 1);
}

std::string well_formed(std::string_view text) {
    return valid_utf8(text) ? std::string(text) : from_latin1(text);
}

std::string clipped(std::string_view text, std::size_t longest) {
    if (text.size() <= longest) return well_formed(text);
    while (longest > 0 && (byte_at(text, longest) & 0xC0) == 0x80) --longest;
    return well_formed(text.substr(0, longest)) + "...";
}

std::string_view local_name(std::string_view name) {
    const auto colon = name.rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string place_of(const Markup& markup, pugi::xml_node node) {
    const std::string_view id = node.attribute("id").value();
    return fmt::format("line {}, <{}>{}{}", spot_of(markup, node).line, clipped(node.name()),
                       id.empty() ? "" : " #", clipped(id));
}

}  // namespace strandline::svg
